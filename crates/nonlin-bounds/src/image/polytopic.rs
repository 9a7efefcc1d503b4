//! Images of V-polytopes by boxes around the images of their vertices.

use scalars::Interval;
use scalars::rounding::add_up;
use setrep::{MAX_FACES, Matrix, Part, SetError, VPolytope};

use crate::expanded::Expanded;
use crate::{BoundError, DynFunction, Expansion, Workspace};

/// A side below this share of the image's extent is rounding, or as good as: it goes to the remainder and doubles no corner.
const THIN: f64 = 1e-12;

/// A side below this share of its own magnitude is rounding.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Image `{ f(x, p) : x in X }` of a polytope `X = conv V + [-r, r]`.
///
/// `conv_i ( f(x_0) + [J] (v_i - x_0) ) + [-s, s]`, `[J]` the range of the Jacobian over the interval hull of `X`, `s = |[J]| r`.
/// Each product of the interval matrix and a vector is a box; its corners (one for a side without width) are the candidates, and the
/// result has the extreme ones among them: at most `2^m` a vertex, and exactly the image where `f` is affine.
///
/// Nonlinearity is paid for once a vertex and not once a set, so the enclosure follows a set that is far from a box or a
/// parallelotope. Additive noise is a Minkowski sum afterwards; other noise is stacked with the states.
///
/// **Guarantee:** superset of the image, rounding included.
/// **Source:** paper 004, Lemma 1 and Theorem 1 (there `r = 0`).
///
/// # Errors
/// [`BoundError::Dimension`], [`BoundError::NonFinite`]; [`BoundError::NotSmooth`] unless every output is proven `C1` on the hull;
/// [`BoundError::UnboundedResult`]; [`SetError::ZeroDimension`] for a function without outputs, [`SetError::OverBudget`] beyond
/// [`MAX_FACES`] corners or facets.
pub fn polytopic_image(
    f: &dyn DynFunction,
    set: &VPolytope,
    at: Expansion<'_>,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<VPolytope, BoundError> {
    let expanded = Expanded::over(f, set, at, p, &mut workspace.jet)?;
    let m = expanded.outputs();
    // A function without outputs has an image without coordinates, which no polytope is.
    if m == 0 {
        return Err(SetError::ZeroDimension { part: Part::Map }.into());
    }
    let mut boxes = Vec::with_capacity(m * set.num_vertices());
    for vertex in set.vertices().columns() {
        boxes.extend((0..m).map(|i| expanded.reach(i, vertex)));
    }
    if let Some(k) = boxes.iter().position(|side| !side.is_bounded()) {
        return Err(BoundError::UnboundedResult { output: k % m });
    }
    let lost = flatten(&mut boxes, m);
    let remainder: Vec<f64> = (0..m).map(|i| add_up(lost[i], expanded.spread(i, set.remainder()))).collect();
    if let Some(output) = remainder.iter().position(|r| !r.is_finite()) {
        return Err(BoundError::UnboundedResult { output });
    }
    Ok(VPolytope::with_remainder(corners(&boxes, m)?, &remainder)?.remove_redundant()?)
}

/// Replaces the sides that are thin by their midpoints, and returns the largest radii so lost, one an output.
fn flatten(boxes: &mut [Interval], m: usize) -> Vec<f64> {
    let mut lost = vec![0.0_f64; m];
    for i in 0..m {
        let extent = boxes.iter().skip(i).step_by(m).copied().reduce(Interval::hull).unwrap_or(Interval::ZERO);
        for side in boxes.iter_mut().skip(i).step_by(m) {
            if side.width() <= (THIN * extent.width()).max(ROUNDING * side.mag()) {
                lost[i] = lost[i].max(side.rad());
                *side = Interval::point(side.mid());
            }
        }
    }
    lost
}

/// The corners of all boxes, one a column.
fn corners(boxes: &[Interval], m: usize) -> Result<Matrix, SetError> {
    let mut columns = Matrix::zeros(m, 0);
    for sides in boxes.chunks_exact(m) {
        let corners = VPolytope::from_intervals(sides)?;
        let count = columns.cols() + corners.num_vertices();
        if count > MAX_FACES {
            return Err(SetError::OverBudget { count, limit: MAX_FACES });
        }
        for corner in corners.vertices().columns() {
            columns.push_col(corner)?;
        }
    }
    Ok(columns)
}

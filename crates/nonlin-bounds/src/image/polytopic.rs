//! Images of V-polytopes by boxes around the images of their vertices.

use scalars::Interval;
use scalars::rounding::add_up;
use setrep::{MAX_FACES, Matrix, Part, SetError, VPolytope};

use crate::expanded::Expanded;
use crate::{BoundError, DynFunction, Expansion, Workspace};

/// A side below this share of the image's extent is rounding, or as good as: it goes to the remainder and doubles no corner. Corners that
/// are no vertices up to this share are dropped.
const THIN: f64 = 1e-10;

/// A side below this share of its own magnitude is rounding.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Image `{ f(x, p) : x in X }` of a polytope `X = conv V + [-r, r]`.
///
/// `conv_i ( f(x_0) + [J] (v_i - x_0) ) + [-s, s]`, `[J]` the range of the Jacobian over the interval hull of `X`, `s = |[J]| r`.
/// Each product of the interval matrix and a vector is a box; its corners (one for a side without width) are the candidates, and the
/// result has the extreme ones among them: at most `2^m` a vertex, and exactly the image where `f` is affine.
///
/// Nonlinearity is paid for once a vertex and not once a set, so the enclosure follows a set that is far from a box or a
/// parallelotope. Noises in a box join by [`polytopic_image_with_noise`]; others are stacked with the states.
///
/// **Guarantee:** superset of the image, rounding included.
/// **Source:** paper 004, Lemma 1 and Theorem 1 (there `r = 0`).
///
/// # Errors
/// [`BoundError::Dimension`], [`BoundError::NonFinite`]; [`BoundError::NotSmooth`] unless every output is proven `C1` on the hull;
/// [`BoundError::UnboundedResult`]; [`SetError::ZeroDimension`] for a function without outputs, [`SetError::OverBudget`] beyond
/// [`MAX_FACES`] corners.
pub fn polytopic_image(
    f: &dyn DynFunction,
    set: &VPolytope,
    at: Expansion<'_>,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<VPolytope, BoundError> {
    polytopic_image_with_noise(f, set, &[], at, p, workspace)
}

/// Image `{ f((x, w), p) : x in X, w in [w] }` of a polytope, `[w]` a box of noises that are the last variables of `f`.
///
/// As [`polytopic_image`] of `X x [w]`, without listing all its vertices: a noise that moves one output only widens that side of every box,
/// which is the same set; only one that moves several doubles the vertices.
///
/// **Guarantee:** superset of the image, rounding included.
/// **Source:** paper 004, Theorem 1, for the set `Z = X x W` of its equation (3).
///
/// # Errors
/// As [`polytopic_image`].
pub fn polytopic_image_with_noise(
    f: &dyn DynFunction,
    set: &VPolytope,
    noise: &[Interval],
    at: Expansion<'_>,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<VPolytope, BoundError> {
    let expanded = Expanded::over_product(f, (set, noise), |_| true, at, p, &mut workspace.jet)?;
    let (n, m) = (set.dim(), expanded.outputs());
    // A function without outputs has an image without coordinates, which no polytope is.
    if m == 0 {
        return Err(SetError::ZeroDimension { part: Part::Map }.into());
    }
    let moves = |k: usize| (0..m).filter(|&i| expanded.share(i, n + k, noise[k]) != Interval::ZERO).count();
    let (mixing, single): (Vec<usize>, Vec<usize>) = (0..noise.len()).partition(|&k| moves(k) > 1);
    let choices = u32::try_from(mixing.len()).ok().and_then(|k| 1_usize.checked_shl(k)).unwrap_or(usize::MAX);
    if choices.saturating_mul(set.num_vertices()) > MAX_FACES {
        return Err(SetError::OverBudget { count: choices, limit: MAX_FACES }.into());
    }
    let mut boxes = Vec::with_capacity(m * choices * set.num_vertices());
    for choice in 0..choices {
        let end = |bit: usize, k: usize| if choice >> bit & 1 == 1 { noise[k].hi() } else { noise[k].lo() };
        let moved = |i: usize| {
            let own = single.iter().map(|&k| expanded.share(i, n + k, noise[k]));
            let ends = mixing.iter().enumerate();
            own.chain(ends.map(|(bit, &k)| expanded.share(i, n + k, Interval::point(end(bit, k)))))
                .fold(Interval::ZERO, |sum, term| sum + term)
        };
        let shifts: Vec<Interval> = (0..m).map(moved).collect();
        for vertex in set.vertices().columns() {
            boxes.extend((0..m).map(|i| expanded.reach(i, vertex) + shifts[i]));
        }
    }
    if let Some(k) = boxes.iter().position(|side| !side.is_bounded()) {
        return Err(BoundError::UnboundedResult { output: k % m });
    }
    let lost = flatten(&mut boxes, m);
    let remainder: Vec<f64> = (0..m).map(|i| add_up(lost[i], expanded.spread(i, set.remainder()))).collect();
    if let Some(output) = remainder.iter().position(|r| !r.is_finite()) {
        return Err(BoundError::UnboundedResult { output });
    }
    Ok(VPolytope::with_remainder(corners(&boxes, m)?, &remainder)?.thinned(THIN))
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

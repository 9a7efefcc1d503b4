//! Images by remainder-form decomposition: D-CZ, and its zonotope.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Zonotope};

use crate::decomposition::Decomposition;
use crate::{BoundError, DynFunction, RangeMethod, Workspace, range};

/// Image `{ f(x, p) : x in X }` of a constrained zonotope by remainder-form decomposition (D-CZ).
///
/// It needs first derivatives only, profits from second ones, and evaluates `f` at points: at most 64 of them an output.
///
/// Each output lies in `h_i xi + [g_i]` with a row `h_i` of shifts over the generators that makes `f_i - h_i xi` monotone, and the values of that
/// difference at two opposite corners; of all choices of signs and two frames the row with the narrowest residual is taken. The image is
/// `<mid g, H, rad g; A, [b]>` with the generators and constraints of `X`, cut by the tight range of `f` over the hull of `X` where that is narrower.
/// Noises that are not additive are stacked with the states.
///
/// Shifts are taken at the ends of the range of the derivative and not clamped at zero as in the paper: the linear part of an output then stays in
/// its row also where the derivative has one sign.
///
/// **Guarantee:** superset of the image, rounding included.
/// **Source:** Khajenejad, Shoaib, Yong, *Guaranteed State Estimation via Indirect Polytopic Set Computation for Nonlinear Discrete-Time Systems* (2021),
/// reference 16 of paper 004; the second frame, the shifts and the cuts are ours.
///
/// # Errors
/// [`BoundError::Dimension`]; [`BoundError::NotSmooth`] unless every output is proven `C1` on the hull; [`BoundError::UnboundedResult`];
/// [`BoundError::Set`], among them an empty set.
pub fn decomposition_image(
    f: &dyn DynFunction,
    set: &ConstrainedZonotope,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<ConstrainedZonotope, BoundError> {
    let (decomposition, sides) = decompose(f, set, p, 1, workspace)?;
    let body = assemble(&decomposition.rows, &decomposition.residuals)?;
    let cut: Vec<usize> = (0..sides.len()).filter(|&i| !body_side(&body, i).subset_of(&sides[i])).collect();
    let source = &decomposition.set;
    let mut image = ConstrainedZonotope::with_constraints(&body, source.constraints(), source.ranges())?;
    if !cut.is_empty() {
        let mut rows = Matrix::zeros(cut.len(), sides.len());
        cut.iter().enumerate().for_each(|(row, &i)| rows[(row, i)] = 1.0);
        let ranges: Vec<Interval> = cut.iter().map(|&i| sides[i]).collect();
        image.intersect_rows(&rows, &ranges, &mut workspace.sets)?;
    }
    Ok(image)
}

/// Image `{ f(x, p) : x in X }` of a zonotope by remainder-form decomposition: [`decomposition_image`] without the cuts, which a zonotope cannot
/// hold; an output whose tight range is narrower than its residual takes that range, and no row.
///
/// **Guarantee:** superset of the image, rounding included.
///
/// # Errors
/// As [`decomposition_image`].
pub fn decomposition_image_of_zonotope(
    f: &dyn DynFunction,
    set: &Zonotope,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<Zonotope, BoundError> {
    let (decomposition, _) = decompose(f, &ConstrainedZonotope::from(set.clone()), p, 1, workspace)?;
    assemble(&decomposition.rows, &decomposition.residuals)
}

/// Up to `count` images of a zonotope, each with other rows: [`decomposition_image_of_zonotope`], then the same with the next narrowest residuals.
/// The image lies in all of them.
///
/// **Guarantee:** each is a superset of the image, rounding included.
/// **Source:** D-ZB of reference 16 of paper 004, whose bundles have a member for every choice of signs.
///
/// # Errors
/// As [`decomposition_image`].
pub fn decomposition_images_of_zonotope(
    f: &dyn DynFunction,
    set: &Zonotope,
    p: &[Interval],
    count: usize,
    workspace: &mut Workspace,
) -> Result<Vec<Zonotope>, BoundError> {
    let (decomposition, _) = decompose(f, &ConstrainedZonotope::from(set.clone()), p, count, workspace)?;
    let first = assemble(&decomposition.rows, &decomposition.residuals)?;
    let others = decomposition.others.iter().map(|(rows, residuals)| assemble(rows, residuals));
    core::iter::once(Ok(first)).chain(others).collect()
}

/// The decomposition over a set in up to `count` ways, and the tight range over its hull, which replaces a row whose residual is not narrower.
fn decompose(
    f: &dyn DynFunction,
    set: &ConstrainedZonotope,
    p: &[Interval],
    count: usize,
    workspace: &mut Workspace,
) -> Result<(Decomposition, Vec<Interval>), BoundError> {
    let mut decomposition = Decomposition::of(f, set, p, (count, &|_| true), workspace)?;
    let mut sides = vec![Interval::ENTIRE; f.outputs()];
    match range(f, &decomposition.hull, p, RangeMethod::Tight, workspace, &mut sides) {
        // The rows stand without it.
        Err(error) if !error.is_of_the_box() => return Err(error),
        _ => {}
    }
    let Decomposition { rows, residuals, others, .. } = &mut decomposition;
    let ways = others.iter_mut().map(|(rows, residuals)| (rows, residuals));
    for (rows, residuals) in core::iter::once((rows, residuals)).chain(ways) {
        for (i, side) in sides.iter().enumerate() {
            if side.width() <= residuals[i].width() {
                residuals[i] = *side;
                (0..rows.cols()).for_each(|j| rows[(i, j)] = 0.0);
            }
        }
    }
    Ok((decomposition, sides))
}

/// `<mid g, H, rad g>`.
fn assemble(rows: &Matrix, residuals: &[Interval]) -> Result<Zonotope, BoundError> {
    let center: Vec<f64> = residuals.iter().map(Interval::mid).collect();
    let radii: Vec<f64> = residuals.iter().map(Interval::rad).collect();
    Ok(Zonotope::with_remainder(&center, rows, &radii)?)
}

/// Side `i` of the hull of a zonotope.
fn body_side(body: &Zonotope, i: usize) -> Interval {
    let start = Interval::point(body.center()[i]).inflate(body.remainder()[i]);
    body.generators().columns().fold(start, |side, column| side.inflate(column[i].abs()))
}

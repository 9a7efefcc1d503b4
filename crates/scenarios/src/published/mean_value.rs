//! Mean value extensions of paper 003, Proposition 1 and Corollary 1, with eliminated constraints.

use nalgebra::{DMatrix, DVector};
use nonlin_bounds::{BoundError, DynFunction, Jet, Order};
use scalars::Interval;

use super::inclusion::{half_widths, inclusion, mid};
use super::{CgRep, elimination};

/// Value at `gamma` and Jacobian over a box.
fn linearise(
    f: &dyn DynFunction,
    hull: &[Interval],
    gamma: &DVector<f64>,
) -> Result<(DVector<f64>, DMatrix<Interval>), BoundError> {
    let mut value = DVector::zeros(f.outputs());
    f.value(gamma.as_slice(), &[], value.as_mut_slice())?;
    let mut jet = Jet::new();
    f.enclose(Order::Jacobian, hull, &[], &mut jet)?;
    Ok((value, DMatrix::from_row_slice(f.outputs(), f.variables(), jet.jacobian())))
}

/// Proposition 1 without noise: `f(gamma) + J (X - gamma)`, `J` over `hull`. `None` if the elimination finds the set empty.
///
/// # Errors
/// As [`DynFunction::enclose`].
pub fn image(
    f: &dyn DynFunction,
    set: &CgRep,
    hull: &[Interval],
    gamma: &DVector<f64>,
) -> Result<Option<CgRep>, BoundError> {
    let (value, jacobian) = linearise(f, hull, gamma)?;
    let identity = DMatrix::identity(set.dim(), set.dim());
    let moved = inclusion(&jacobian, &set.affine(&identity, &-gamma));
    Ok(moved.map(|moved| moved.affine(&DMatrix::identity(value.len(), value.len()), &value)))
}

/// Corollary 1 with `Jtilde = mid J`: the members of the set with `h(x) = 0`.
///
/// # Errors
/// As [`DynFunction::enclose`].
pub fn consistent(
    h: &dyn DynFunction,
    set: &CgRep,
    hull: &[Interval],
    gamma: &DVector<f64>,
) -> Result<Option<CgRep>, BoundError> {
    let (value, jacobian) = linearise(h, hull, gamma)?;
    let identity = DMatrix::identity(set.dim(), set.dim());
    let slope = mid(&jacobian);
    Ok(half_widths(&jacobian, &set.affine(&identity, &-gamma))
        .map(|radii| set.intersect(&slope, &CgRep::from_box(&(&slope * gamma - value), &radii))))
}

/// Heuristic C2: the point of the hull nearest to the centre of the set without its constraints.
#[must_use]
pub fn c2(set: &CgRep, hull: &[Interval]) -> Option<DVector<f64>> {
    elimination::eliminate(set, 0).map(|zonotope| clamped(&zonotope.center, hull))
}

/// Heuristic C3: the point of the hull nearest to the centre of the set.
#[must_use]
pub fn c3(set: &CgRep, hull: &[Interval]) -> DVector<f64> {
    clamped(&set.center, hull)
}

fn clamped(point: &DVector<f64>, hull: &[Interval]) -> DVector<f64> {
    DVector::from_fn(point.len(), |k, _| point[k].max(hull[k].lo()).min(hull[k].hi()))
}

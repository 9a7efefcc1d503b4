//! The CZ-inclusion of paper 003 with the half-widths that constraint elimination gives.

use nalgebra::{DMatrix, DVector};
use scalars::Interval;

use super::CgRep;
use super::elimination::eliminate;

/// Midpoints of an interval matrix.
#[must_use]
pub fn mid(matrix: &DMatrix<Interval>) -> DMatrix<f64> {
    matrix.map(|x| x.mid())
}

/// Radii of an interval matrix.
#[must_use]
pub fn rad(matrix: &DMatrix<Interval>) -> DMatrix<f64> {
    matrix.map(|x| x.rad())
}

/// The diagonal of `P`: `P_ii = sum_k rad J_ik (|c_k| + sum_j |G_kj|)` for the zonotope `{G, c}` that is left of the set after all its
/// constraints were eliminated (Theorem 1 and Remark 2). `None` if the elimination finds the set empty.
#[must_use]
pub fn half_widths(jacobian: &DMatrix<Interval>, set: &CgRep) -> Option<DVector<f64>> {
    let zonotope = eliminate(set, 0)?;
    let reach = DVector::from_fn(zonotope.dim(), |k, _| {
        zonotope.center[k].abs() + zonotope.generators.row(k).iter().map(|g| g.abs()).sum::<f64>()
    });
    Some(rad(jacobian) * reach)
}

/// `mid(J) X + P [-1, 1]^m`, which contains `J x` for all members `J` and `x` (Theorem 1).
#[must_use]
pub fn inclusion(jacobian: &DMatrix<Interval>, set: &CgRep) -> Option<CgRep> {
    let radii = half_widths(jacobian, set)?;
    let none = DVector::zeros(radii.len());
    Some(set.affine(&mid(jacobian), &none).plus(&CgRep::from_box(&none, &radii)))
}

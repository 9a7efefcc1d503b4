//! First-order Taylor extensions of paper 003, Lemma 2, Proposition 2 and Corollary 2, as printed and corrected.

use nalgebra::{DMatrix, DVector};
use nonlin_bounds::{BoundError, DynFunction, Jet, Order};
use scalars::Interval;

use super::CgRep;
use super::inclusion::inclusion;

/// Which matrix stands for the cross term `2 (c - gamma)' H G xi` of the quadratic part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cross {
    /// `L = (c - gamma)' Q` with the upper triangular `Q` of the print: no enclosure where `gamma != c` and `Q` has entries off its diagonal.
    AsPrinted,
    /// `L = (c - gamma)' (Q + Q') / 2`.
    Symmetrised,
}

/// The linear part at `gamma` and the remainder `R` of Lemma 2.
struct Expansion {
    value: DVector<f64>,
    gradient: DMatrix<f64>,
    remainder: CgRep,
}

/// Proposition 2 without noise: `f(gamma) + grad f(gamma) (X - gamma) + R`. `None` if the elimination finds the set empty.
///
/// # Errors
/// As [`DynFunction::enclose`].
pub fn image(
    f: &dyn DynFunction,
    set: &CgRep,
    hull: &[Interval],
    gamma: &DVector<f64>,
    cross: Cross,
) -> Result<Option<CgRep>, BoundError> {
    let translate = |e: &Expansion| &e.value - &e.gradient * gamma;
    Ok(expand(f, set, hull, gamma, cross)?
        .map(|expansion| set.affine(&expansion.gradient, &translate(&expansion)).plus(&expansion.remainder)))
}

/// Corollary 2: the members of the set with `h(x) = 0`.
///
/// # Errors
/// As [`DynFunction::enclose`].
pub fn consistent(
    h: &dyn DynFunction,
    set: &CgRep,
    hull: &[Interval],
    gamma: &DVector<f64>,
    cross: Cross,
) -> Result<Option<CgRep>, BoundError> {
    Ok(expand(h, set, hull, gamma, cross)?.map(|Expansion { value, gradient, remainder }| {
        let mirror = -DMatrix::identity(value.len(), value.len());
        set.intersect(&gradient, &remainder.affine(&mirror, &(&gradient * gamma - &value)))
    }))
}

fn expand(
    f: &dyn DynFunction,
    set: &CgRep,
    hull: &[Interval],
    gamma: &DVector<f64>,
    cross: Cross,
) -> Result<Option<Expansion>, BoundError> {
    let (n, m) = (f.variables(), f.outputs());
    let at: Vec<Interval> = gamma.iter().map(|&x| Interval::point(x)).collect();
    let mut jet = Jet::new();
    f.enclose(Order::Jacobian, &at, &[], &mut jet)?;
    let value = DVector::from_fn(m, |i, _| jet.values()[i].mid());
    let gradient = DMatrix::from_fn(m, n, |i, k| jet.jacobian()[i * n + k].mid());
    f.enclose(Order::Hessian, hull, &[], &mut jet)?;
    let halves: Vec<DMatrix<Interval>> =
        jet.hessians().chunks_exact(n * (n + 1) / 2).map(|packed| half_hessian(n, packed)).collect();
    let offset = &set.center - gamma;
    let rows = halves.iter().map(|half| cross_row(half, &offset, cross));
    let slopes = DMatrix::from_rows(&rows.map(|row| row.transpose()).collect::<Vec<_>>());
    let quadratic = quadratic_part(set, &halves);
    if slopes.iter().all(|l| l.mag() == 0.0) {
        return Ok(Some(Expansion { value, gradient, remainder: quadratic }));
    }
    let doubled = CgRep { center: offset, generators: &set.generators * 2.0, ..set.clone() };
    Ok(inclusion(&slopes, &doubled).map(|linear| Expansion { value, gradient, remainder: quadratic.plus(&linear) }))
}

/// Half of the Hessian as the upper triangular `Q` of the paper: halves of the second derivatives on the diagonal, whole ones above it.
fn half_hessian(n: usize, packed: &[Interval]) -> DMatrix<Interval> {
    let mut half = DMatrix::from_element(n, n, Interval::ZERO);
    let mut entries = packed.iter();
    for i in 0..n {
        for (j, &entry) in (i..n).zip(&mut entries) {
            half[(i, j)] = if i == j { entry.scale(0.5) } else { entry };
        }
    }
    half
}

/// One row of `L`.
fn cross_row(half: &DMatrix<Interval>, offset: &DVector<f64>, cross: Cross) -> DVector<Interval> {
    let n = offset.len();
    DVector::from_fn(n, |k, _| {
        (0..n).fold(Interval::ZERO, |sum, i| {
            let entry = match cross {
                Cross::AsPrinted => half[(i, k)],
                Cross::Symmetrised => (half[(i, k)] + half[(k, i)]).scale(0.5),
            };
            sum + entry.scale(offset[i])
        })
    })
}

/// `ctilde + [Gtilde Gtilde_d] B(Atilde, btilde)` of Lemma 2: the quadratic form in `xi`, with `xi_i^2 = 1/2 + zeta_i / 2` and the products
/// of all pairs of constraints.
fn quadratic_part(set: &CgRep, halves: &[DMatrix<Interval>]) -> CgRep {
    let (columns, rows, m) = (set.generators.ncols(), set.constraints.nrows(), halves.len());
    let pairs: Vec<(usize, usize)> = (0..columns).flat_map(|i| (i + 1..columns).map(move |j| (i, j))).collect();
    let width = columns + pairs.len() + m;
    let (mut center, mut generators) = (DVector::zeros(m), DMatrix::zeros(m, width));
    for (q, half) in halves.iter().enumerate() {
        let form = congruent(half, &set.generators);
        center[q] = 0.5 * (0..columns).map(|i| form[(i, i)].mid()).sum::<f64>();
        for i in 0..columns {
            generators[(q, i)] = 0.5 * form[(i, i)].mid();
        }
        for (k, &(i, j)) in pairs.iter().enumerate() {
            generators[(q, columns + k)] = form[(i, j)].mid() + form[(j, i)].mid();
        }
        generators[(q, columns + pairs.len() + q)] = form.iter().map(Interval::rad).sum();
    }
    let products: Vec<(usize, usize)> = (0..rows).flat_map(|r| (r..rows).map(move |s| (r, s))).collect();
    let mut constraints = DMatrix::zeros(products.len(), width);
    let mut offsets = DVector::zeros(products.len());
    let a = &set.constraints;
    for (p, &(r, s)) in products.iter().enumerate() {
        for i in 0..columns {
            constraints[(p, i)] = 0.5 * a[(r, i)] * a[(s, i)];
        }
        for (k, &(i, j)) in pairs.iter().enumerate() {
            constraints[(p, columns + k)] = a[(r, i)] * a[(s, j)] + a[(r, j)] * a[(s, i)];
        }
        let squares: f64 = (0..columns).map(|i| a[(r, i)] * a[(s, i)]).sum();
        offsets[p] = set.offsets[r] * set.offsets[s] - 0.5 * squares;
    }
    CgRep { center, generators, constraints, offsets }
}

/// `G' Q G` in interval arithmetic.
fn congruent(half: &DMatrix<Interval>, generators: &DMatrix<f64>) -> DMatrix<Interval> {
    let (n, columns) = generators.shape();
    DMatrix::from_fn(columns, columns, |i, j| {
        (0..n).flat_map(|k| (0..n).map(move |l| (k, l))).fold(Interval::ZERO, |sum, (k, l)| {
            let product = generators[(k, i)] * generators[(l, j)];
            if product == 0.0 { sum } else { sum + half[(k, l)].scale(product) }
        })
    })
}

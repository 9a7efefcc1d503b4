//! The updated set of paper 004, Theorem 2, by a lift over the vertices.

use nonlin_bounds::{BoundError, DynFunction, Jet, Order};
use scalars::Interval;
use setrep::{ConstrainedZonotope, HPolytope, Matrix, VPolytope};

/// `{ x in X : exists l >= 0, sum l = 1, A Jm (x - q_0) - D l <= b - A mu(q_0) }` for `X = conv V`, `Y = { y : A y <= b }`; column `i` of
/// `D` is `rad(A J) |v_i - q_0|`.
///
/// `z <= r` has a solution in the hull of the boxes `[-d_i, d_i]` iff some `l` in the simplex has `-sum l_i d_i <= r`, so this is the
/// projection of the paper, without the `2^m` corners of each box and without a conversion in `R^(2m)`. Here it is a constrained
/// zonotope over the weights of `x` and `l`; its supports are linear programs.
///
/// # Errors
/// As [`DynFunction::enclose`]; set operations that overflow.
pub fn updated_set(
    mu: &dyn DynFunction,
    set: &VPolytope,
    y: &HPolytope,
    q0: &[f64],
) -> Result<ConstrainedZonotope, BoundError> {
    let (n, m, count) = (mu.variables(), mu.outputs(), set.num_vertices());
    let mut value = vec![0.0; m];
    mu.value(q0, &[], &mut value)?;
    let mut jet = Jet::new();
    mu.enclose(Order::Jacobian, &set.interval_hull(), &[], &mut jet)?;
    let a = |j: usize, i: usize| y.normals()[(j, i)];
    let slope =
        |j: usize, k: usize| (0..m).fold(Interval::ZERO, |sum, i| sum + jet.jacobian()[i * n + k].scale(a(j, i)));
    let half = |k: usize, i: usize| 0.5 * set.vertices()[(k, i)];
    let center: Vec<f64> = (0..n).map(|k| (0..count).map(|i| half(k, i)).sum()).collect();
    let mut generators = Matrix::zeros(n, 2 * count);
    let rows = y.num_half_spaces();
    let mut constraints = Matrix::zeros(2 + rows, 2 * count);
    let mut ranges = vec![Interval::point(2.0 - count as f64); 2];
    for i in 0..count {
        for k in 0..n {
            generators[(k, i)] = half(k, i);
        }
        constraints[(0, i)] = 1.0;
        constraints[(1, count + i)] = 1.0;
    }
    for (j, &offset) in y.offsets().iter().enumerate() {
        let slopes: Vec<Interval> = (0..n).map(|k| slope(j, k)).collect();
        let mut level = offset - (0..m).map(|i| a(j, i) * value[i]).sum::<f64>();
        for i in 0..count {
            let from = |k: usize| set.vertices()[(k, i)] - q0[k];
            let linear = 0.5 * (0..n).map(|k| slopes[k].mid() * from(k)).sum::<f64>();
            let spread = 0.5 * (0..n).map(|k| slopes[k].rad() * from(k).abs()).sum::<f64>();
            constraints[(2 + j, i)] = linear;
            constraints[(2 + j, count + i)] = -spread;
            level -= linear - spread;
        }
        ranges.push(Interval::new(f64::NEG_INFINITY, level).unwrap_or(Interval::ENTIRE));
    }
    Ok(ConstrainedZonotope::new(&center, &generators, &constraints, &ranges)?)
}

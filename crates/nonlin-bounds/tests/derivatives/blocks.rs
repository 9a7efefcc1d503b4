//! Many variables: blocks of seeds give what one pass would, and steady state allocates nothing.

use nonlin_bounds::{BoundError, DynFunction, Function, Jet, Order};
use scalars::{Interval, Scalar};

use crate::common::functions::{Domain, Visitor, each};

/// `sum_{i <= j} a_ij x_i x_j`, with `a_ij` that tell the entry.
struct Quadratic {
    dim: usize,
}

fn coefficient(i: usize, j: usize) -> f64 {
    (1 + i + 100 * j) as f64
}

impl Function for Quadratic {
    fn variables(&self) -> usize {
        self.dim
    }
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
        y[0] = S::zero();
        for j in 0..self.dim {
            for i in 0..=j {
                y[0] += (x[i] * x[j]).scale(coefficient(i, j));
            }
        }
        y[1] = x[self.dim - 1];
    }
}

/// Every entry of gradient and Hessian is at its place, for dimensions within one block, at its end, and of many blocks.
#[test]
fn every_entry_is_at_its_place() {
    let mut jet = Jet::new();
    for n in [1, 2, 3, 4, 5, 8, 9, 12, 13, 17, 64, 70] {
        let f = Quadratic { dim: n };
        let x: Vec<Interval> = (0..n).map(|i| Interval::new(-1.0, i as f64).unwrap()).collect();
        for order in [Order::Jacobian, Order::Hessian] {
            f.enclose(order, &x, &[], &mut jet).unwrap();
            for i in 0..n {
                // The gradient over the box, entry by entry in exact numbers.
                let bound = |end: fn(&Interval) -> f64| -> f64 {
                    (0..n).map(|j| coefficient(i.min(j), i.max(j)) * end(&x[j]) * if i == j { 2.0 } else { 1.0 }).sum()
                };
                let slope = jet.jacobian()[i];
                assert!(slope.lo() <= bound(Interval::lo) && bound(Interval::hi) <= slope.hi(), "{n} {i}");
                assert!(slope.width() <= (1.0 + 1e-12) * (bound(Interval::hi) - bound(Interval::lo)), "{n} {i}");
                assert_eq!(jet.jacobian()[n + i], if i + 1 == n { Interval::ONE } else { Interval::ZERO });
            }
        }
        let mut entry = 0;
        for i in 0..n {
            for j in i..n {
                let value = coefficient(i, j) * if i == j { 2.0 } else { 1.0 };
                let range = jet.hessians()[entry];
                assert!(range.contains(value) && range.width() <= 1e-14 * value, "{n}: ({i}, {j}) {range:?}");
                assert_eq!(jet.hessians()[n * (n + 1) / 2 + entry], Interval::ZERO);
                entry += 1;
            }
        }
    }
}

/// The same function with the number of variables as a constant, which need not be true.
struct Fixed<const N: usize>(Quadratic);

impl<const N: usize> Function for Fixed<N> {
    const VARIABLES: Option<usize> = Some(N);
    fn variables(&self) -> usize {
        self.0.dim
    }
    fn outputs(&self) -> usize {
        2
    }
    fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
        self.0.eval(x, p, y);
    }
}

/// The derivatives of each order, first and second ones in a row.
fn jets<F: Function>(f: &F) -> [Result<Vec<Interval>, BoundError>; 2] {
    let x: Vec<Interval> = (0..f.variables()).map(|i| Interval::new(-1.0, i as f64).unwrap()).collect();
    [Order::Jacobian, Order::Hessian].map(|order| {
        let mut jet = Jet::new();
        f.enclose(order, &x, &[], &mut jet)?;
        Ok([jet.jacobian(), jet.hessians()].concat())
    })
}

/// The constant changes no result; one that is too small is refused.
#[test]
fn a_fixed_number_of_variables_has_the_same_jets() {
    fn same<const N: usize>() {
        assert_eq!(jets(&Fixed::<N>(Quadratic { dim: N })), jets(&Quadratic { dim: N }), "{N}");
    }
    same::<1>();
    same::<2>();
    same::<3>();
    same::<4>();
    same::<5>();
    same::<9>();
    assert!(jets(&Fixed::<2>(Quadratic { dim: 3 })).iter().all(|jet| matches!(jet, Err(BoundError::Dimension { .. }))));
}

struct Steady(Jet);

impl Visitor for Steady {
    fn visit<F: Function + 'static>(&mut self, function: F, domain: Domain) {
        let x: Vec<Interval> = domain.center.iter().map(|&c| Interval::point(c).inflate(1e-3)).collect();
        let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p)).collect();
        let mut all = || {
            for order in [Order::Value, Order::Jacobian, Order::Hessian] {
                function.enclose(order, &x, &p, &mut self.0).unwrap();
            }
        };
        all();
        let allocations = allocation_counter::measure(all).count_total;
        // Decimal literals of a model are read anew at every evaluation.
        assert!(allocations == 0 || domain.name == "reactor", "{}: {allocations}", domain.name);
    }
}

/// After the first call of each order nothing is allocated.
#[test]
fn steady_state_allocates_nothing() {
    each(&mut Steady(Jet::new()));
}

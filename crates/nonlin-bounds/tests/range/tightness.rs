//! What each method is exact for, and how they compare.

use nonlin_bounds::{DynFunction, Function, RangeMethod, Workspace, range};
use scalars::{Interval, Scalar};

use super::{METHODS, interval, range_of};
use crate::common::functions::{Domain, PlanarMap, Visitor, each};
use crate::common::polynomial::Polynomials;
use crate::common::random::{Random, cases};

const SEED: u64 = 0x0003_2101;

/// Whether an interval is `[lo, hi]` but for rounding at the given scale.
fn is_about(found: Interval, lo: f64, hi: f64, scale: f64) -> bool {
    (found.lo() - lo).abs() <= 1e-13 * scale && (found.hi() - hi).abs() <= 1e-13 * scale
}

/// A quadratic function `c + sum_k a_k x_k + sum_{j <= k} q_jk x_j x_k`.
fn quadratic(n: usize, random: &mut Random, coupled: bool) -> (Polynomials, Vec<f64>, Vec<Vec<f64>>) {
    let a: Vec<f64> = (0..n).map(|_| 4.0 * random.unit()).collect();
    let mut q = vec![vec![0.0; n]; n];
    let mut monomials = vec![(1.5, vec![0; n])];
    for j in 0..n {
        let mut exponents = vec![0; n];
        exponents[j] = 1;
        monomials.push((a[j], exponents.clone()));
        for k in j..n {
            if k == j || coupled {
                q[j][k] = 2.0 * random.unit();
                let mut exponents = exponents.clone();
                exponents[k] += 1;
                monomials.push((q[j][k], exponents));
            }
        }
    }
    (Polynomials { variables: n, outputs: vec![monomials] }, a, q)
}

/// The slope form of a quadratic is the exact interval of its slopes: `f(c) +- sum_j (|g_j| + sum_k |h_jk| r_k / 2) r_j` with the gradient `g` at the
/// midpoint and the Hessian `h`; the mean value form has twice the second part.
#[test]
fn slopes_of_quadratics_are_exact() {
    for case in 0..cases(300) {
        let mut random = Random::new(SEED, case);
        let n = 1 + random.below(4);
        let (f, a, q) = quadratic(n, &mut random, true);
        let center: Vec<f64> = (0..n).map(|_| 2.0 * random.unit()).collect();
        let radius: Vec<f64> = (0..n).map(|_| random.fraction()).collect();
        let x: Vec<Interval> = (0..n).map(|k| interval(center[k] - radius[k], center[k] + radius[k])).collect();
        let hessian = |j: usize, k: usize| if j == k { 2.0 * q[j][j] } else { q[j][k] + q[k][j] };
        let (mut linear, mut curved, mut value) = (0.0, 0.0, 1.5);
        for j in 0..n {
            let gradient = a[j] + (0..n).map(|k| hessian(j, k) * center[k]).sum::<f64>();
            linear += gradient.abs() * radius[j];
            curved += (0..n).map(|k| hessian(j, k).abs() * radius[k]).sum::<f64>() * radius[j];
            value += a[j] * center[j] + (j..n).map(|k| q[j][k] * center[j] * center[k]).sum::<f64>();
        }
        for (method, share) in [(RangeMethod::Slope, 0.5), (RangeMethod::MeanValue, 1.0)] {
            let half = linear + share * curved;
            let y = range_of(&f, &x, method).unwrap()[0];
            assert!(
                is_about(y, value - half, value + half, 100.0),
                "case {case} {method:?}: {y:?}, not {value} +- {half}"
            );
        }
    }
}

/// Sums of parabolas: the second-order form is the exact range.
#[test]
fn second_order_is_exact_for_sums_of_parabolas() {
    for case in 0..cases(300) {
        let mut random = Random::new(SEED + 1, case);
        let n = 1 + random.below(4);
        let (f, a, q) = quadratic(n, &mut random, false);
        let x = random.subbox(&vec![0.0; n], &vec![4.0; n]);
        let (mut lo, mut hi) = (1.5, 1.5);
        for j in 0..n {
            let value = |x: f64| a[j] * x + q[j][j] * x * x;
            let vertex = (-a[j] / (2.0 * q[j][j])).clamp(x[j].lo(), x[j].hi());
            let values = [value(x[j].lo()), value(x[j].hi()), value(vertex)];
            lo += values.iter().copied().fold(f64::INFINITY, f64::min);
            hi += values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        }
        for method in [RangeMethod::SecondOrder, RangeMethod::Tight] {
            let y = range_of(&f, &x, method).unwrap()[0];
            assert!(is_about(y, lo, hi, 200.0), "case {case} {method:?} on {x:?}: {y:?}, not [{lo}, {hi}]");
        }
    }
}

/// A function that is monotone in each variable: its range is spanned by two corners.
#[test]
fn mixed_monotone_is_exact_for_monotone_functions() {
    struct Monotone;
    impl Function for Monotone {
        const VARIABLES: Option<usize> = Some(3);
        fn outputs(&self) -> usize {
            2
        }
        fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
            y[0] = x[0] * x[1].exp() - x[2].atan() * x[0].add_f64(3.0);
            y[1] = (x[1] - x[0]) / (x[2].sqr().add_f64(1.0));
        }
    }
    let x = [interval(0.0, 2.0), interval(3.0, 4.0), interval(0.25, 1.0)];
    let corner = |x: [f64; 3]| {
        let mut y = [0.0; 2];
        DynFunction::value(&Monotone, &x, &[], &mut y).unwrap();
        y
    };
    for method in [RangeMethod::MixedMonotone, RangeMethod::Tight] {
        let y = range_of(&Monotone, &x, method).unwrap();
        let (lo, hi) = (corner([0.0, 3.0, 1.0])[0], corner([2.0, 4.0, 0.25])[0]);
        assert!(is_about(y[0], lo, hi, 100.0), "{method:?} {:?} [{lo}, {hi}]", y[0]);
        let (lo, hi) = (corner([2.0, 3.0, 1.0])[1], corner([0.0, 4.0, 0.25])[1]);
        assert!(is_about(y[1], lo, hi, 10.0), "{method:?} {:?} [{lo}, {hi}]", y[1]);
    }
    let natural = range_of(&Monotone, &x, RangeMethod::Natural).unwrap();
    assert!(natural[0].width() > 1.01 * range_of(&Monotone, &x, RangeMethod::Tight).unwrap()[0].width());
}

/// Remainder form by hand: `x^2 + x y` on `[-1, 1]^2`, derivatives `2x + y` in `[-3, 3]` and `x` in `[-1, 1]`. Rising in both with shifts
/// `(-3, -1)`: `[f(-1, -1) - 8, f(1, 1) + 8]`; the four choices of signs intersect to the `[-8, 8]` of opposite signs, in which both corners have value 0.
#[test]
fn mixed_monotone_intersects_all_signs() {
    let f = Polynomials { variables: 2, outputs: vec![vec![(1.0, vec![2, 0]), (1.0, vec![1, 1])]] };
    let y = range_of(&f, &[interval(-1.0, 1.0); 2], RangeMethod::MixedMonotone).unwrap()[0];
    // Lower bound 0 - 8 of the opposite signs or 2 - 8 of equal ones; upper 0 + 8 or 2 + 8.
    assert!(is_about(y, -6.0, 8.0, 10.0), "{y:?}");
}

/// `Tight` is contained in the range of every single method, and narrower than the natural one on average.
#[test]
fn tight_is_the_tightest() {
    struct Tightness {
        ratio: f64,
        count: f64,
    }
    impl Visitor for Tightness {
        fn visit<F: Function + 'static>(&mut self, function: F, domain: Domain) {
            let f: &dyn DynFunction = &function;
            let mut workspace = Workspace::new();
            let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p)).collect();
            for case in 0..cases(40) {
                let x = Random::new(SEED + 2, case).subbox(&domain.center, &domain.radius);
                let mut find = |method| {
                    let mut y = vec![Interval::EMPTY; f.outputs()];
                    range(f, &x, &p, method, &mut workspace, &mut y).unwrap();
                    y
                };
                let tight = find(RangeMethod::Tight);
                for method in METHODS {
                    for (i, (tight, other)) in tight.iter().zip(find(method)).enumerate() {
                        // Sharper gradients move corners by roundings.
                        let slack = 1e-14 * (1.0 + other.mag());
                        assert!(
                            tight.subset_of(&other.inflate(slack)),
                            "{} output {i}: {tight:?} beyond {method:?} {other:?} on {x:?}",
                            domain.name
                        );
                        if method == RangeMethod::Natural && other.width() > 1e-12 * (1.0 + other.mag()) {
                            self.ratio += tight.width() / other.width();
                            self.count += 1.0;
                        }
                    }
                }
            }
        }
    }
    let mut tightness = Tightness { ratio: 0.0, count: 0.0 };
    each(&mut tightness);
    let mean = tightness.ratio / tightness.count;
    println!("mean width of tight to natural ranges: {mean:.3}");
    assert!(mean < 0.85, "{mean}");
}

/// The map of paper 003, equation (15), against sampling; on a box of width `w` the excess of the centered forms falls with `w^2`.
#[test]
fn excess_of_the_planar_map() {
    let excess = |method: RangeMethod, w: f64| {
        let x = [interval(1.0 - w, 1.0 + w), interval(-0.5 - w, -0.5 + w)];
        let y = range_of(&PlanarMap, &x, method).unwrap();
        let (mut sampled, steps) = ([Interval::EMPTY; 2], 200);
        for i in 0..=steps {
            for j in 0..=steps {
                let at = |side: Interval, k: i32| side.lo() + (side.hi() - side.lo()) * f64::from(k) / f64::from(steps);
                let mut y = [0.0; 2];
                DynFunction::value(&PlanarMap, &[at(x[0], i), at(x[1], j)], &[], &mut y).unwrap();
                sampled.iter_mut().zip(y).for_each(|(s, y)| *s = s.hull(Interval::point(y)));
            }
        }
        y.iter().zip(sampled).map(|(y, s)| y.width() / s.width()).fold(0.0, f64::max) - 1.0
    };
    let table: Vec<(RangeMethod, f64, f64)> =
        METHODS.iter().map(|&method| (method, excess(method, 0.5), excess(method, 0.25))).collect();
    println!("{table:.4?}");
    assert!(table[5].1 < 0.02, "{}", table[5].1);
    for (method, wide, narrow) in table {
        let share = narrow / wide;
        match method {
            // Relative to the range, which falls with the width itself.
            RangeMethod::Natural => assert!(share > 0.7, "{method:?} {share}"),
            // On the narrow box both outputs are monotone.
            RangeMethod::MixedMonotone | RangeMethod::Tight => assert!(narrow < 1e-12, "{method:?} {narrow}"),
            _ => assert!(share < 0.6, "{method:?} {share}"),
        }
    }
}

/// Steady state: no method allocates.
#[test]
fn steady_state_allocates_nothing() {
    let (mut workspace, mut y) = (Workspace::new(), [Interval::EMPTY; 2]);
    let x = [interval(-0.5, 2.0), interval(-1.0, 1.5)];
    for method in METHODS {
        let mut again = || range(&PlanarMap, &x, &[], method, &mut workspace, &mut y).unwrap();
        again();
        again();
        assert_eq!(allocation_counter::measure(again).count_total, 0, "{method:?}");
    }
}

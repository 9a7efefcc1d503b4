//! The zonotopic filter of paper 001: containment, the linear case, the identity with the Kalman filter, refutations, refusals.

use estimators::kalman::{ByFunction, Ekf, Flat, Gaussian};
use estimators::{Culprit, Estimator, EstimatorError, Guarantee, LinearizedZf, Relation, System, Zf, ZfOptions};
use nalgebra::{Matrix1, Matrix2, SMatrix, Vector1, Vector2};
use nonlin_bounds::{Form, Function, function};
use scalars::Interval;
use setrep::{Matrix, Membership, Reduction, SetError, StripRule, Zonotope};

use crate::support::{Random, cases};

fn boxed(radii: &[f64]) -> Zonotope {
    Zonotope::from_box(&vec![0.0; radii.len()], radii).unwrap()
}

/// A pendulum by Euler steps with a noise on its rate; angle and height are measured.
fn swing() -> impl Function + Copy + Send + Sync + std::fmt::Debug {
    function!(|[angle, rate, w]: 3| -> 2 {
        [angle + rate.scale(0.0625), rate - angle.sin().scale(0.5) + w]
    })
}

fn seen() -> impl Function + Copy + Send + Sync + std::fmt::Debug {
    function!(|[angle, _rate, v1, v2]: 4| -> 2 { [angle + v1, angle.cos() + v2] })
}

fn pendulum(noise: &[f64; 2]) -> System {
    System::new(Relation::new(swing()), boxed(&[0.01]), Relation::new(seen()), boxed(noise)).unwrap()
}

/// A float near `x` from a grid on which the angles of a pendulum move without rounding.
fn on_grid(x: f64) -> f64 {
    let step = 2f64.powi(-36);
    (x / step).round() * step
}

/// The truth a step later: the angle moves exactly, and the noise that leads exactly to the rate is proven to keep its bound.
fn swung(x: [f64; 2], w: f64) -> [f64; 2] {
    let rate = on_grid(x[1] - 0.5 * x[0].sin() + w);
    let noise = Interval::point(rate) - (Interval::point(x[1]) - Interval::point(x[0]).sin().scale(0.5));
    assert!(noise.mag() <= 0.01, "{noise:?}");
    // Multiples of 2^-40 below 8.
    [x[0] + 0.0625 * x[1], rate]
}

/// What is measured of a state, with noises proven to keep their bounds.
fn measured(x: [f64; 2], v: [f64; 2], bounds: [f64; 2]) -> [f64; 2] {
    let y = [x[0] + v[0], x[0].cos() + v[1]];
    let angle = Interval::point(x[0]);
    for ((seen, y), bound) in [angle, angle.cos()].into_iter().zip(y).zip(bounds) {
        assert!((Interval::point(y) - seen).mag() <= bound);
    }
    y
}

/// Rules, forms of the strips, tightening on and off: all hold the truth, with noises at their bounds as often as not.
#[test]
fn the_state_stays_inside() {
    let rules = [StripRule::Volume, StripRule::Segments, StripRule::Determinant];
    for run in 0..cases(40) {
        let mut random = Random::new(run as u64);
        let options = ZfOptions {
            rule: rules[run % 3],
            tighten: run % 2 == 0,
            strips: [Form::MeanValue, Form::Taylor, Form::Natural][run / 6 % 3],
            generators: 8 + run % 5,
            reduction: Reduction::Combastel,
        };
        let noise = [0.05, 0.02];
        let mut x = [on_grid(0.5 + 0.2 * random.unit()), on_grid(0.2 * random.unit())];
        let mut filter =
            Zf::new(pendulum(&noise), Zonotope::from_box(&[0.5, 0.0], &[0.2, 0.2]).unwrap(), options).unwrap();
        assert_eq!(filter.guarantee(), Guarantee::Rigorous);
        for step in 0..40 {
            let mut bounded = |bound: f64| {
                let share = if step % 2 == 0 { random.sign() } else { random.unit() };
                share * (bound - 1e-10)
            };
            filter.update(&measured(x, noise.map(&mut bounded), noise)).unwrap();
            let holds = |filter: &Zf, x: &[f64; 2]| {
                let point = x.map(Interval::point);
                filter.hull().iter().zip(x).all(|(side, &x)| side.contains(x))
                    && filter.enclosure().membership(&point).unwrap() != Membership::ProvenOutside
            };
            assert!(holds(&filter, &x), "{options:?}, step {step}, {x:?}, {:?}", filter.hull());
            x = swung(x, bounded(0.01));
            filter.predict(&[]).unwrap();
            assert!(holds(&filter, &x), "{options:?}, step {step}, {x:?}, {:?}", filter.hull());
            assert!(filter.enclosure().num_generators() <= options.generators + 6);
        }
        if options.strips != Form::Natural {
            assert!(filter.hull()[0].rad() < 0.2, "{options:?}: {:?}", filter.hull());
        }
    }
}

/// Outputs that were not measured need not be smooth or defined; one that was goes by its range.
#[test]
fn outputs_that_were_not_measured_may_be_anything() {
    let all =
        function!(|[angle, rate, v]: 3| -> 3 { [angle.abs() + v, angle + v, (angle - rate - rate.sqr()).sqrt()] });
    let one = function!(|[angle, _rate, v]: 3| -> 1 { [angle + v] });
    let updated = |seen: Relation, y: &[Option<f64>]| {
        let system = System::new(Relation::new(swing()), boxed(&[0.01]), seen, boxed(&[0.05])).unwrap();
        let mut filter = Zf::new(system, boxed(&[0.5, 0.5]), ZfOptions::new(8)).unwrap();
        filter.update_some(y, &[]).unwrap();
        filter.state().clone()
    };
    let expected = updated(Relation::new(one), &[Some(0.25)]);
    assert_eq!(updated(Relation::new(all), &[None, Some(0.25), None]), expected);
    assert!(expected.hull[0].width() < 0.11);
    updated(Relation::new(all), &[Some(0.25), Some(0.25), None]);
}

/// A linear system: the prediction is exact but for rounding, and strips cut a box along an axis exactly.
#[test]
fn linear_systems_are_moved_exactly() {
    let rows = |rows: &[&[f64]]| Matrix::from_rows(rows).unwrap();
    let (a, b) = (rows(&[&[1.0, 0.5], &[0.0, 1.0]]), rows(&[&[0.0], &[1.0]]));
    let (c, d) = (rows(&[&[1.0, 0.0]]), Matrix::identity(1));
    assert!(System::linear(&a, &c, boxed(&[0.25]), &c, &d, boxed(&[0.5])).is_err());
    assert!(System::linear(&a, &b, boxed(&[0.25; 2]), &c, &d, boxed(&[0.5])).is_err());
    let system = System::linear(&a, &b, boxed(&[0.25]), &c, &d, boxed(&[0.5])).unwrap();
    let mut filter = Zf::new(system, boxed(&[1.0, 2.0]), ZfOptions::new(20)).unwrap();
    // The strip [-1/4, 3/4] around y = 1/4.
    filter.update(&[0.25]).unwrap();
    let near = |filter: &Zf, expected: [[f64; 2]; 2]| {
        filter
            .hull()
            .iter()
            .zip(expected)
            .all(|(side, [lo, hi])| (side.lo() - lo).abs() + (side.hi() - hi).abs() < 1e-12)
    };
    assert!(near(&filter, [[-0.25, 0.75], [-2.0, 2.0]]), "{:?}", filter.hull());
    filter.predict(&[]).unwrap();
    assert!(near(&filter, [[-1.25, 1.75], [-2.25, 2.25]]), "{:?}", filter.hull());
    // The generator along y has moved on sheared: area 4 * (1 * 2 / 2 + (1 / 2 + 1) / 4).
    let area = filter.enclosure().volume().unwrap();
    assert!((area.mid() - 4.0 * (0.5 * 2.0 + 0.25 * 1.5)).abs() < 1e-9, "{area}");
}

/// `H H'` for the sets of both filters.
fn scatter(radii: &[f64]) -> SMatrix<f64, 2, 2> {
    Matrix2::from_diagonal(&Vector2::new(radii[0] * radii[0], radii[1] * radii[1]))
}

/// Least segments, whole strips, no reduction: center and `G G'` are mean and covariance of the extended Kalman filter that takes one output
/// after the other.
#[test]
fn the_linearised_filter_is_an_extended_kalman_filter() {
    let angle = ByFunction::new(function!(|[angle, _rate, v]: 3| -> 1 { [angle + v] }));
    let height = ByFunction::new(function!(|[angle, _rate, v]: 3| -> 1 { [angle.cos() + v] }));
    let (start, noise) = ([0.4, 0.3], [0.05, 0.02]);
    let options = ZfOptions::new(100_000).with_rule(StripRule::Segments).with_whole_strips();
    let initial = Zonotope::from_box(&[0.7, -0.1], &start).unwrap();
    let mut zf = LinearizedZf::new(pendulum(&noise), initial, options).unwrap();
    assert_eq!(zf.guarantee(), Guarantee::FirstOrder);
    let belief = Gaussian::new(Vector2::new(0.7, -0.1), &scatter(&start)).unwrap();
    let q = Matrix1::new(0.01 * 0.01);
    let mut ekf: Ekf<_, Flat, 2, 1, 1, 1> =
        Ekf::new((ByFunction::new(swing()), angle.clone()), belief, &q, &Matrix1::new(1.0)).unwrap();
    let mut random = Random::new(4);
    for step in 0..60 {
        zf.predict(&[]).unwrap();
        ekf.predict(&[]).unwrap();
        let mean = *ekf.belief().mean();
        let y = [mean[0] + 0.04 * random.unit(), mean[0].cos() + 0.02 * random.unit()];
        zf.update(&y).unwrap();
        let r = noise.map(|radius| Matrix1::new(radius * radius));
        ekf.update_by(&angle, &r[0], &Vector1::new(y[0])).unwrap();
        ekf.update_by(&height, &r[1], &Vector1::new(y[1])).unwrap();
        let (mean, p) = (ekf.belief().mean(), ekf.belief().covariance());
        let center = Vector2::from_column_slice(zf.enclosure().center());
        assert!((center - mean).norm() <= 1e-12 * mean.norm().max(1.0), "step {step}: {center} {mean}");
        let covariation = zf.enclosure().covariation();
        let covariation = Matrix2::from_column_slice(covariation.as_slice());
        assert!((covariation - p).norm() <= 1e-11 * p.norm(), "step {step}");
        assert_eq!(zf.enclosure().num_generators(), 2 + 3 * (step + 1));
    }
}

/// A strip that misses the set is refuted with proof and the output named, tightened or not; the set is kept.
#[test]
fn an_empty_strip_is_a_contradiction() {
    for options in [ZfOptions::new(10), ZfOptions::new(10).with_whole_strips()] {
        let mut filter =
            Zf::new(pendulum(&[0.05, 0.02]), Zonotope::from_box(&[0.5, 0.0], &[0.2, 0.2]).unwrap(), options).unwrap();
        let before = filter.state().clone();
        let wrong = filter.update(&[0.5, 0.2]).unwrap_err();
        let EstimatorError::Inconsistent(found) = wrong else { panic!("{wrong}") };
        assert_eq!(found.culprits, [Culprit::Measurement(1), Culprit::Prediction]);
        assert!(found.verify() && found.margin() > 0.3);
        assert_eq!(filter.state(), &before);
        filter.update_some(&[Some(0.5), None], &[]).unwrap();
        filter.update_some(&[None, None], &[]).unwrap();
    }
}

#[test]
fn orders_below_the_dimension_and_dynamics_without_derivative_are_refused() {
    let wrong = Zf::new(pendulum(&[0.1, 0.1]), boxed(&[1.0, 1.0]), ZfOptions::new(1)).unwrap_err();
    assert_eq!(wrong, EstimatorError::Set(SetError::TooFewGenerators { max_generators: 1, dim: 2 }));
    // The square root has no derivative at 0, which lies in the set: its range says nothing, and dynamics like it are refused.
    let root = function!(|[x, _y, v]: 3| -> 1 { [x.sqrt() + v] });
    let system = System::new(Relation::new(swing()), boxed(&[0.01]), Relation::new(root), boxed(&[0.1])).unwrap();
    let mut filter = Zf::new(system, Zonotope::from_box(&[1.0, 0.0], &[1.0, 0.1]).unwrap(), ZfOptions::new(9)).unwrap();
    let before = filter.hull().to_vec();
    filter.update(&[1.0]).unwrap();
    assert!(filter.hull().iter().zip(&before).all(|(new, old)| (new.width() - old.width()).abs() < 1e-12));
    let rooted = function!(|[x, y, w]: 3| -> 2 { [x.sqrt() + w, y] });
    filter.system_mut().set_dynamics(Relation::new(rooted), boxed(&[0.01])).unwrap();
    let before = filter.state().clone();
    assert!(matches!(filter.predict(&[]).unwrap_err(), EstimatorError::Bound(_)));
    assert_eq!(filter.state(), &before);
    let generators = Matrix::identity(3);
    assert!(Zf::new(pendulum(&[0.1, 0.1]), Zonotope::new(&[0.0; 3], &generators).unwrap(), ZfOptions::new(9)).is_err());
}

#[test]
fn a_step_allocates_nothing() {
    for rule in [StripRule::Volume, StripRule::Segments] {
        let initial = Zonotope::from_box(&[0.5, 0.0], &[0.2, 0.2]).unwrap();
        let mut filter = Zf::new(pendulum(&[0.1, 0.5]), initial, ZfOptions::new(14).with_rule(rule)).unwrap();
        let saved = filter.state().clone();
        let mut step = || {
            filter.restore(&saved).unwrap();
            for _ in 0..4 {
                filter.step(&[], &[0.5, 0.9]).unwrap();
            }
        };
        step();
        step();
        let counted = allocation_counter::measure(|| (0..20).for_each(|_| step()));
        assert_eq!(counted.count_total, 0, "{rule:?}: {counted:?}");
    }
}

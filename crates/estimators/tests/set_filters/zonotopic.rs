//! ZMV and ZFO: the radii of paper 003's examples, containment with uniform and vertex noise, contradictions, bad input, allocations.

use estimators::{
    Culprit, Estimator, EstimatorError, Evidence, Guarantee, Phase, Relation, System, ZonotopeFilter, ZonotopeOptions,
};
use nonlin_bounds::{BoundError, DynFunction, Function, Jet, Order, function};
use scalars::{Interval, Scalar};
use setrep::{Matrix, Membership, SetError, Strip, StripRule, Zonotope};

use crate::plants::{
    Draw, PlanarStep, attitude, attitude_run, attitude_start, cube, planar, planar_run, planar_start, radius,
};
use crate::support::{Random, cases};

fn start_of_planar() -> Zonotope {
    planar_start().unconstrained().clone()
}

fn start_of_attitude() -> Zonotope {
    attitude_start().unconstrained().clone()
}

/// `|x_i| <= 1`.
fn unit_box(n: usize) -> Vec<Strip> {
    let axis = |i: usize| (0..n).map(|k| f64::from(u8::from(i == k))).collect::<Vec<_>>();
    (0..n).map(|i| Strip::new(&axis(i), Interval::ZERO.inflate(1.0)).unwrap()).collect()
}

/// The state lies in the hull, and is not proven to lie outside the set.
fn check(filter: &ZonotopeFilter, x: &[f64], what: &str) {
    let point: Vec<_> = x.iter().map(|&x| Interval::point(x).inflate(1e-12)).collect();
    assert!(filter.hull().iter().zip(&point).all(|(side, x)| !side.disjoint(x)), "{what}: {:?} {x:?}", filter.hull());
    assert_ne!(filter.enclosure().membership(&point).unwrap(), Membership::ProvenOutside, "{what}");
}

/// Radii of the sets of example 5.1 until there are none.
fn planar_radii(options: &ZonotopeOptions, draw: Draw, random: &mut Random) -> Vec<f64> {
    // As generators noises count in a reduction, as a box remainder they come free of charge.
    let mut system = planar();
    let noise = Zonotope::new(&[0.0; 2], &Matrix::from_diagonal(&[0.4; 2])).unwrap();
    system.set_dynamics(Relation::new(PlanarStep), noise).unwrap();
    let mut filter = ZonotopeFilter::new(system, start_of_planar(), options.clone()).unwrap();
    assert_eq!(filter.guarantee(), Guarantee::Rigorous);
    let mut radii = Vec::new();
    for (k, (x, y)) in planar_run(draw, 10, random).iter().enumerate() {
        if k > 0 {
            let before = filter.state().clone();
            if let Err(error) = filter.predict(&[]) {
                assert!(
                    matches!(error, EstimatorError::Bound(_) | EstimatorError::Set(SetError::Overflow { .. })),
                    "{error}"
                );
                assert_eq!(filter.state(), &before);
                return radii;
            }
        }
        filter.update(y).unwrap();
        check(&filter, x, "planar");
        radii.push(radius(filter.hull()));
    }
    radii
}

/// The paper's zonotopes blow up, and do not depend on what is measured: no strip ever bites.
#[test]
fn planar_example_has_the_published_radii() {
    let mut random = Random::new(61);
    for draw in [Draw::Uniform, Draw::Vertex] {
        for (options, published) in [
            (ZonotopeOptions::zmv(8), &[2.0, 4.02, 10.69, 58.3][..]),
            (ZonotopeOptions::zfo(8), &[2.0, 3.015, 5.515, 13.95]),
        ] {
            let radii = planar_radii(&options, draw, &mut random);
            println!("{:?} {radii:.4?}", options.extension);
            assert!(radii.len() < 8, "the pole is in reach: {radii:?}");
            for (found, expected) in radii.iter().zip(published) {
                assert!((found / expected - 1.0).abs() < 0.01, "{found} {expected}");
            }
        }
    }
}

/// Example 5.2 as the paper evaluates it: `sin(p) / p` with `p` a root, whose interval quotient costs most of what the zonotopes lose.
/// A quarter-circle kinematics in `(x, w)` with parameters the measured rates.
struct TextbookAttitude;

impl Function for TextbookAttitude {
    const VARIABLES: Option<usize> = Some(7);
    fn parameters(&self) -> usize {
        3
    }
    fn outputs(&self) -> usize {
        4
    }
    fn eval<S: Scalar>(&self, x: &[S], u: &[S], y: &mut [S]) {
        let [a, b, c] = [0, 1, 2].map(|i| u[i] - x[4 + i]);
        let half = S::ratio(1, 10);
        let p = half * (a.sqr() + b.sqr() + c.sqr()).sqrt();
        let (cos, sinc) = (p.cos(), half * (p.sin() / p));
        y[0] = cos * x[0] - sinc * (c * x[1] - b * x[2] + a * x[3]);
        y[1] = cos * x[1] - sinc * (a * x[2] - c * x[0] + b * x[3]);
        y[2] = cos * x[2] - sinc * (b * x[0] - a * x[1] + c * x[3]);
        y[3] = cos * x[3] + sinc * (a * x[0] + b * x[1] + c * x[2]);
    }
}

/// Radii of the sets of example 5.2, `k = 0..=steps`.
fn attitude_radii(
    mut system: System,
    textbook: bool,
    options: ZonotopeOptions,
    (draw, steps): (Draw, usize),
    random: &mut Random,
) -> Vec<f64> {
    if textbook {
        system.set_dynamics(Relation::new(TextbookAttitude), cube(3, 3e-3)).unwrap();
    }
    let mut filter = ZonotopeFilter::new(system, start_of_attitude(), options).unwrap();
    let run = attitude_run(0.15, draw, steps, random);
    let mut radii = Vec::new();
    for (k, (x, y, _)) in run.iter().enumerate() {
        if k > 0 {
            filter.predict(&run[k - 1].2).unwrap();
        }
        filter.update(y).unwrap();
        if k < 30 {
            check(&filter, x, "attitude");
        }
        radii.push(radius(filter.hull()));
    }
    radii
}

/// The zonotope columns of Table 3, for the textbook model.
#[test]
fn attitude_example_has_the_published_ratios() {
    let mut random = Random::new(62);
    let mut run =
        |options: ZonotopeOptions| attitude_radii(attitude(0.15), true, options, (Draw::Uniform, 190), &mut random);
    let [zmv, zmv_f, zfo, zfo_f] = [
        run(ZonotopeOptions::zmv(12)),
        run(ZonotopeOptions::zmv(12).with_feasible(unit_box(4))),
        run(ZonotopeOptions::zfo(12)),
        run(ZonotopeOptions::zfo(12).with_feasible(unit_box(4))),
    ];
    for (name, radii) in [("zmv", &zmv), ("zmv+f", &zmv_f), ("zfo", &zfo), ("zfo+f", &zfo_f)] {
        println!("{name}: {:.4?}", [1, 10, 50, 100, 150, 190].map(|k: usize| radii[k]));
    }
    for (name, a, b, published) in [
        ("ZMV+F / ZMV", &zmv_f, &zmv, 0.9187),
        ("ZFO / ZMV", &zfo, &zmv, 0.6447),
        ("ZFO+F / ZMV", &zfo_f, &zmv, 0.6057),
        ("ZMV / ZFO", &zmv, &zfo, 1.6829),
        ("ZFO+F / ZFO", &zfo_f, &zfo, 0.9367),
        ("ZMV+F / ZFO", &zmv_f, &zfo, 1.5384),
    ] {
        let ratio = a.iter().zip(b).map(|(a, b)| a / b).sum::<f64>() / a.len() as f64;
        println!("{name}: {ratio:.4}, published {published}");
        assert!((ratio / published - 1.0).abs() < 0.015, "{name}: {ratio} {published}");
    }
}

/// With functions that do not lose their dependencies the same filters stay small for longer, and the invariant helps.
#[test]
fn attitude_example_contains_every_state() {
    let mut random = Random::new(63);
    for round in 0..10 * cases(1) {
        let draw = if round % 2 == 0 { Draw::Uniform } else { Draw::Vertex };
        for options in [ZonotopeOptions::zmv(12), ZonotopeOptions::zfo(12)] {
            let plain = attitude_radii(attitude(0.15), false, options.clone(), (draw, 30), &mut random);
            let options = ZonotopeOptions { keep_hull: true, ..options.with_feasible(unit_box(4)).with_consistency() };
            let full = attitude_radii(attitude(0.15), false, options, (draw, 30), &mut random);
            assert!(full[30] <= plain[30] && plain[30] < 0.45, "{} {}", full[30], plain[30]);
        }
    }
}

/// A point that turns on a circle, and is seen through a mirror that bends: variables `(x, y, w)` and `(x, y, v)`.
fn turning() -> System {
    let turn = function!(|[x, y, w]: 3| -> 2 {
        let (cos, sin) = ((w + S::decimal("0.3")).cos(), (w + S::decimal("0.3")).sin());
        [cos * x - sin * y, sin * x + cos * y]
    });
    let mirror = function!(|[x, y, v]: 3| -> 2 { [x + x.sqr().scale(0.125) + v, y - x * y * S::decimal("0.1") - v] });
    let circle = function!(|[x, y]: 2| -> 1 { [x.sqr() + y.sqr()] });
    System::new(Relation::new(turn), cube(1, 0.01), Relation::new(mirror), cube(1, 0.05))
        .unwrap()
        .with_invariant(Relation::new(circle), vec![Interval::new(0.9, 1.1).unwrap()])
        .unwrap()
}

/// Strips that bite: the filters converge, whatever the noise, and never refute a truth.
#[test]
fn strips_that_bite_keep_the_state() {
    let mut random = Random::new(64);
    let mut sum = [0.0; 4];
    for round in 0..40 * cases(1) {
        let constant = [random.sign(), random.sign()];
        let filters = [
            ZonotopeOptions::zmv(10),
            ZonotopeOptions::zfo(10).with_consistency(),
            ZonotopeOptions { rule: StripRule::Segments, ..ZonotopeOptions::zmv(10) },
            ZonotopeOptions {
                keep_hull: true,
                ..ZonotopeOptions::zfo(10).with_consistency().with_feasible(unit_box(2))
            },
        ];
        let new = |options: ZonotopeOptions| ZonotopeFilter::new(turning(), cube(2, 1.0), options.with_rows()).unwrap();
        let mut filters = filters.map(new);
        let (mut angle, mut noise) = (0.3 * random.unit(), [0.0; 2]);
        for k in 0..40 {
            for (i, noise) in noise.iter_mut().enumerate() {
                let bound = [0.01, 0.05][i] * (1.0 - 1e-12);
                *noise = match round % 3 {
                    0 => bound * random.unit(),
                    1 => bound * random.sign(),
                    _ => bound * constant[i],
                };
            }
            let (y, x) = angle.sin_cos();
            let measured = [x + 0.125 * x * x + noise[1], y - 0.1 * x * y - noise[1]];
            for (i, filter) in filters.iter_mut().enumerate() {
                filter.update(&measured).unwrap();
                check(filter, &[x, y], "turning");
                if k == 39 {
                    sum[i] += radius(filter.hull()) / 40.0 / cases(1) as f64;
                }
                filter.predict(&[]).unwrap();
            }
            angle += 0.3 + noise[0];
        }
    }
    println!("mean radii {sum:.4?}");
    assert!(sum.iter().all(|&radius| radius < 0.2), "{sum:?}");
    assert!(sum[3] <= sum[0], "invariant and hull help: {sum:?}");
}

/// Values out of reach are refuted, by the range of the output or by the strip; the filter is as it was.
#[test]
fn contradictions_are_proven_and_leave_the_filter_as_it_was() {
    let mut filter = ZonotopeFilter::new(turning(), cube(2, 1.0), ZonotopeOptions::zmv(10)).unwrap();
    filter.update(&[1.1, 0.0]).unwrap();
    let before = filter.state().clone();
    let Err(EstimatorError::Inconsistent(proof)) = filter.update(&[1.1, 9.0]) else { panic!("no contradiction") };
    assert_eq!(proof.culprits, [Culprit::Measurement(1), Culprit::Prediction]);
    assert!(proof.verify() && proof.margin() > 0.0);
    assert_eq!(filter.state(), &before);

    let far = vec![Strip::new(&[1.0, 1.0], Interval::new(5.0, f64::INFINITY).unwrap()).unwrap()];
    filter.options_mut().feasible = far;
    let Err(EstimatorError::Inconsistent(proof)) = filter.update(&[1.1, 0.0]) else { panic!("no contradiction") };
    assert_eq!(proof.culprits, [Culprit::Feasible(0), Culprit::Prediction]);
    assert!(matches!(proof.evidence, Evidence::Disjoint { .. }) && proof.verify());
    assert_eq!(filter.state(), &before);

    // An initial set off the circle.
    let mut off = ZonotopeFilter::new(turning(), cube(2, 0.25), ZonotopeOptions::zfo(10)).unwrap();
    let Err(EstimatorError::Inconsistent(proof)) = off.consistency() else { panic!("no contradiction") };
    assert_eq!(proof.culprits, [Culprit::Invariant(0), Culprit::Prediction]);

    // The square root of what is negative has no value.
    let root = function!(|[x, y, v]: 3| -> 2 { [y + v, (x - y.sqr()).sqrt() + v] });
    let mut system = turning();
    system.set_measurement(Relation::new(root), cube(1, 0.1)).unwrap();
    let negative = Zonotope::from_box(&[-2.0, 0.0], &[1.0, 1.0]).unwrap();
    for options in [ZonotopeOptions::zmv(10), ZonotopeOptions::zmv(10).with_rows()] {
        let mut filter = ZonotopeFilter::new(system.clone(), negative.clone(), options).unwrap();
        let Err(EstimatorError::Inconsistent(proof)) = filter.update(&[0.5, 0.5]) else { panic!("no contradiction") };
        assert_eq!(proof.culprits, [Culprit::Measurement(1), Culprit::Prediction]);
        // Where nothing was seen of it, nothing is refuted.
        filter.update_some(&[Some(0.5), None], &[]).unwrap();
    }
}

#[test]
fn bad_input_is_refused_and_missing_outputs_say_nothing() {
    let new = |set, options| ZonotopeFilter::new(turning(), set, options);
    assert!(matches!(
        new(cube(2, 1.0), ZonotopeOptions::zmv(1)),
        Err(EstimatorError::Set(SetError::TooFewGenerators { max_generators: 1, dim: 2 }))
    ));
    assert!(matches!(
        new(cube(2, 1.0), ZonotopeOptions::zmv(5).with_feasible(unit_box(3))),
        Err(EstimatorError::Size { what: "strip of feasible states", .. })
    ));
    assert!(matches!(
        new(cube(3, 1.0), ZonotopeOptions::zmv(5)),
        Err(EstimatorError::Size { what: "initial set", .. })
    ));

    let mut filter = new(cube(2, 1.0), ZonotopeOptions::zmv(10)).unwrap();
    filter.predict(&[]).unwrap();
    let before = filter.state().clone();
    assert!(matches!(filter.update(&[0.0]), Err(EstimatorError::Size { what: "measurement", expected: 2, found: 1 })));
    assert!(matches!(filter.update(&[0.0, f64::NAN]), Err(EstimatorError::NotFinite { index: 1, .. })));
    assert!(filter.predict(&[1.0]).is_err());
    assert!(filter.step(&[f64::NAN], &[1.0, 0.0]).is_err());
    assert_eq!(filter.state(), &before);
    filter.update_some(&[None, None], &[]).unwrap();
    let same = |(new, old): (&Interval, &Interval)| old.subset_of(new) && new.subset_of(&old.inflate(1e-14));
    assert!(filter.hull().iter().zip(&before.hull).all(same));

    // Updates without predictions and predictions without updates keep the set small; phases come in order.
    for k in 0..30 {
        if k % 10 < 5 {
            filter.update(&[1.1, 0.0]).unwrap();
        } else {
            filter.predict(&[]).unwrap();
        }
        assert!(filter.enclosure().num_generators() <= 14, "{}", filter.enclosure().num_generators());
    }
    let mut phases = Vec::new();
    filter.options_mut().consistency = true;
    filter.restore(&before).unwrap();
    filter.update_traced(&[Some(1.1), None], &[], &mut |phase| phases.push(phase)).unwrap();
    filter.predict_traced(&[], &mut |phase| phases.push(phase)).unwrap();
    assert_eq!(phases, [Phase::Update, Phase::Consistency, Phase::Reduction, Phase::Prediction]);
}

/// A function whose Hessians are not known.
struct WithoutHessians<F>(F);

impl<F: Function> DynFunction for WithoutHessians<F> {
    fn variables(&self) -> usize {
        Function::variables(&self.0)
    }
    fn parameters(&self) -> usize {
        Function::parameters(&self.0)
    }
    fn outputs(&self) -> usize {
        Function::outputs(&self.0)
    }
    fn value(&self, x: &[f64], p: &[f64], y: &mut [f64]) -> Result<(), BoundError> {
        DynFunction::value(&self.0, x, p, y)
    }
    fn enclose(&self, order: Order, x: &[Interval], p: &[Interval], jet: &mut Jet) -> Result<(), BoundError> {
        if order == Order::Hessian {
            return Err(BoundError::OrderNotAvailable { order: 2 });
        }
        self.0.enclose(order, x, p, jet)
    }
}

/// Without Hessians the first order goes by the mean value theorem; `|x|` goes by neither.
#[test]
fn dynamics_that_are_not_smooth_fall_back_or_are_refused() {
    let bent = function!(|[x, y, w]: 3| -> 2 { [x.sqr().scale(0.25) + w, y.scale(0.5) + x.scale(0.125)] });
    let kinked = function!(|[x, y, w]: 3| -> 2 { [x.abs().scale(0.25) + w, y] });
    let predict = |dynamics: Relation, options| {
        let mut system = turning();
        system.set_dynamics(dynamics, cube(1, 0.01)).unwrap();
        let mut filter = ZonotopeFilter::new(system, cube(2, 1.0), options).unwrap();
        let before = filter.state().clone();
        let result = filter.predict(&[]);
        assert_eq!(result.is_err(), filter.state() == &before);
        result.map(|()| filter.state().set.clone())
    };
    let by_mean_value = predict(Relation::new(bent), ZonotopeOptions::zmv(8)).unwrap();
    assert_ne!(predict(Relation::new(bent), ZonotopeOptions::zfo(8)).as_ref(), Ok(&by_mean_value));
    let bent = Relation::from_bounds(WithoutHessians(bent));
    assert_eq!(predict(bent, ZonotopeOptions::zfo(8)), Ok(by_mean_value));
    for options in [ZonotopeOptions::zmv(8), ZonotopeOptions::zfo(8)] {
        let refused = predict(Relation::new(kinked), options).unwrap_err();
        assert!(matches!(refused, EstimatorError::Bound(BoundError::NotSmooth { output: 0, .. })), "{refused}");
    }
}

#[test]
fn a_step_in_steady_state_allocates_nothing() {
    let mut random = Random::new(65);
    let run = attitude_run(0.15, Draw::Uniform, 20, &mut random);
    let strips = unit_box(4);
    for options in [ZonotopeOptions::zmv(12).with_rows(), ZonotopeOptions::zfo(12)] {
        let options = ZonotopeOptions { keep_hull: true, ..options.with_consistency().with_feasible(strips.clone()) };
        let mut filter = ZonotopeFilter::new(attitude(0.15), start_of_attitude(), options).unwrap();
        let start = filter.state().clone();
        let mut go = || {
            filter.restore(&start).unwrap();
            for (_, y, u) in &run {
                filter.update(y).unwrap();
                filter.predict(u).unwrap();
            }
        };
        (0..4).for_each(|_| go());
        assert_eq!(allocation_counter::measure(go).count_total, 0);
    }
}

//! Linear models: nothing is dropped but the rounding of the estimate, so the state stays in the set.

use estimators::{Estimator, Gain, InZsmf, Outputs, Right, Zsmf};
use lie_groups::{LieGroup, Rn};
use nalgebra::{Matrix2, SVector, Vector2};
use scalars::Interval;
use setrep::{Membership, Reduction, Zonotope};

use crate::support::{Linear, REDUCTIONS, Random, boxed, cases};

/// Whether a point widened by the rounding of the estimate is proven outside.
fn outside(set: &Zonotope, x: &SVector<f64, 2>) -> bool {
    let point: Vec<Interval> = x.iter().map(|v| Interval::point(*v).inflate(1e-12 * (1.0 + v.abs()))).collect();
    set.membership(&point).unwrap() == Membership::ProvenOutside
}

/// A mass pushed and braked at the bounds of the force and measured at the bounds of the noise.
fn run(seed: u64, reduction: Option<(Reduction, usize)>, gain: Gain<2, 1>, steps: usize) {
    let mut random = Random::new(seed);
    let model = Linear {
        a: Matrix2::new(1.0, 0.1, -0.05, 0.98),
        c: SVector::<f64, 2>::new(1.0, 0.0).transpose(),
        d: SVector::<f64, 2>::new(0.005, 0.1),
    };
    let start = Zonotope::from_box(&[1.0, -2.0], &[0.5, 3.0]).unwrap();
    let mut filter = Zsmf::new(model.clone(), &start, &boxed(&[0.4]), &boxed(&[0.3])).unwrap().with_gain(gain);
    if let Some((method, order)) = reduction {
        filter = filter.with_reduction(method, order).unwrap();
    }
    let mut x = Vector2::new(1.0 + 0.5 * random.sign(), -2.0 + 3.0 * random.sign());
    let constant = (random.sign(), random.sign());
    for k in 0..steps {
        let (w, v) = if seed.is_multiple_of(2) { constant } else { (random.sign(), random.sign()) };
        let y = model.c * x + SVector::<f64, 1>::new(0.3 * v);
        let u = Vector2::new(0.0, 0.2 * random.unit());
        match k % 5 {
            3 => filter.predict(&u).unwrap(),
            4 => {
                filter.update(y.as_slice()).unwrap();
                assert!(!outside(filter.enclosure(), &x), "update {k}: {x}");
                filter.predict(&u).unwrap();
            }
            _ => filter.step(&u, y.as_slice()).unwrap(),
        }
        x = model.a * x + u + model.d * (0.4 * w);
        assert!(!outside(filter.enclosure(), &x), "step {k}: {x} {:?}", filter.enclosure().interval_hull());
    }
    let width = filter.enclosure().interval_hull()[0].width();
    assert!(width < 3.0, "the set is useful: {width}");
}

#[test]
fn the_state_stays_in_the_set() {
    for seed in 0..cases(10) as u64 {
        run(seed, None, Gain::FRadius, 100);
        for method in REDUCTIONS {
            run(seed, Some((method, 12)), Gain::FRadius, 100);
        }
    }
}

#[test]
fn any_gain_keeps_the_state_in_the_set() {
    for seed in 0..cases(10) as u64 {
        run(seed, Some((Reduction::Girard, 15)), Gain::Fixed(Vector2::new(0.4, 0.5)), 100);
    }
}

/// The invariant filter on the plane: a drifting point with both coordinates measured, either reduction.
#[test]
fn on_the_plane_the_invariant_set_holds_the_point() {
    for seed in 0..cases(10) as u64 {
        let mut random = Random::new(seed);
        let mut filter: InZsmf<Rn<f64, 2>, 2, 2, Right> = InZsmf::new(
            Rn::identity(),
            &boxed(&[2.0, 3.0]),
            Outputs::position(),
            &boxed(&[0.05, 0.02]),
            &boxed(&[0.5, 0.7]),
        )
        .unwrap()
        .with_reduction(Reduction::Girard, 10)
        .unwrap();
        let mut x = Vector2::new(2.0 * random.sign(), 3.0 * random.sign());
        for k in 0..200 {
            let y = x + Vector2::new(0.5 * random.sign(), 0.7 * random.sign());
            let xi = random.matrix::<2, 1>();
            filter.step(&xi, y.as_slice()).unwrap();
            x += xi + Vector2::new(0.05 * random.sign(), 0.02 * random.sign());
            assert!(!outside(filter.tangent_set(), &(x - filter.estimate().vector())), "step {k}");
        }
    }
}

//! Filters go on from a state that was stored as text as if nothing had happened, bit for bit.

use estimators::{
    CzFilter, CzOptions, Estimator, FilterState, LinearCz, LinearOptions, LinearSystem, Rcz, RczOptions, Zf, ZfOptions,
    ZonotopeFilter, ZonotopeOptions,
};
use scalars::Interval;
use setrep::{Complexity, ConstrainedZonotope, Matrix, Strip, Zonotope};

use crate::plants::{Draw, attitude, attitude_run, attitude_start, cube, planar, planar_run, planar_start};
use crate::saved_states::goes_on_to_the_bit;
use crate::support::Random;

/// Outputs and inputs of a run.
type Run = Vec<(Vec<f64>, Vec<f64>)>;

fn quaternions(draw: Draw, steps: usize) -> Run {
    let run = attitude_run(0.15, draw, steps, &mut Random::new(91));
    run.into_iter().map(|(_, y, u)| (y, u.to_vec())).collect()
}

fn points(draw: Draw) -> Run {
    planar_run(draw, 12, &mut Random::new(92)).into_iter().map(|(_, y)| (y, Vec::new())).collect()
}

fn unit_strips() -> Vec<Strip> {
    let side = Interval::new(-1.0, 1.0).unwrap();
    (0..4).map(|i| Strip::new(Matrix::identity(4).col(i), side).unwrap()).collect()
}

/// The first set without its constraints, of which it has none.
fn zonotope(set: &ConstrainedZonotope) -> Zonotope {
    set.unconstrained().clone()
}

#[test]
fn constrained_zonotope_filters() {
    let (small, large) = (Complexity { generators: 8, constraints: 3 }, Complexity { generators: 12, constraints: 5 });
    for draw in [Draw::Uniform, Draw::Vertex] {
        for options in [CzOptions::czmv(Some(small)), CzOptions::czfo(Some(small))] {
            goes_on_to_the_bit(|o| CzFilter::new(planar(), planar_start(), o).unwrap(), options, &points(draw));
        }
        for options in [CzOptions::czmv(Some(large)), CzOptions::czfo(Some(large))] {
            let options = options.with_consistency().with_feasible(unit_strips());
            let make = |o| CzFilter::new(attitude(0.15), attitude_start(), o).unwrap();
            goes_on_to_the_bit(make, options, &quaternions(draw, 10));
        }
    }
}

#[test]
fn ranged_filter() {
    let tiers = [RczOptions::fast(4), RczOptions::slow(4), RczOptions::cheap(4)];
    for options in tiers {
        // More than one period of the slow tier, saved within one.
        let make = |o| Rcz::new(attitude(0.15), attitude_start(), o).unwrap();
        goes_on_to_the_bit(make, options, &quaternions(Draw::Uniform, 26));
    }
}

#[test]
fn zonotope_filters() {
    for options in [ZonotopeOptions::zmv(12), ZonotopeOptions::zfo(12)] {
        let options = options.with_rows().with_consistency().with_feasible(unit_strips());
        let make = |o| ZonotopeFilter::new(attitude(0.15), zonotope(&attitude_start()), o).unwrap();
        goes_on_to_the_bit(make, options, &quaternions(Draw::Uniform, 10));
    }
    let make = |o| Zf::new(attitude(0.15), zonotope(&attitude_start()), o).unwrap();
    goes_on_to_the_bit(make, ZfOptions::new(12), &quaternions(Draw::Uniform, 10));
}

/// The linear filter has a shell of its own.
#[test]
fn linear_filter() {
    let system = || {
        let a = Matrix::from_rows(&[&[1.0, 0.1], &[-0.1, 0.9]]).unwrap();
        let seen = Matrix::from_rows(&[&[1.0, 0.3]]).unwrap();
        LinearSystem::new(a, cube(2, 0.01).into(), seen, cube(1, 0.05).into()).unwrap()
    };
    let options =
        LinearOptions { limit: Some(Complexity { generators: 8, constraints: 3 }), ..LinearOptions::default() };
    let make = || LinearCz::new(system(), cube(2, 0.5).into(), options).unwrap();
    let text = |filter: &LinearCz| serde_json::to_string(filter.state()).unwrap();
    let (mut filter, mut restored) = (make(), make());
    for k in 0..20_u32 {
        if k == 10 {
            let state: FilterState<ConstrainedZonotope> = serde_json::from_str(&text(&filter)).unwrap();
            restored.restore(&state).unwrap();
        }
        // The truth rests at the origin.
        let y = [0.049 * (f64::from(k) * 0.7).sin()];
        for filter in [Some(&mut filter), (k >= 10).then_some(&mut restored)].into_iter().flatten() {
            filter.update(&y).unwrap();
            filter.predict(&[]).unwrap();
        }
        assert_eq!(text(&filter) == text(&restored), k >= 10, "step {k}");
    }
}

/// A system that is written anew after a restart: what is saved is the state, not the model.
#[test]
fn a_state_of_another_size_is_refused() {
    let filter = CzFilter::new(planar(), planar_start(), CzOptions::czmv(None)).unwrap();
    let text = serde_json::to_string(filter.state()).unwrap();
    let state: FilterState<ConstrainedZonotope> = serde_json::from_str(&text).unwrap();
    let mut other = CzFilter::new(attitude(0.15), attitude_start(), CzOptions::czmv(None)).unwrap();
    let before = other.state().clone();
    assert!(other.restore(&state).is_err());
    assert_eq!(*other.state(), before);
    for broken in ["\"step\":-1", "\"step\":null", "\"step\":1.5"] {
        assert!(serde_json::from_str::<FilterState<ConstrainedZonotope>>(&text.replace("\"step\":0", broken)).is_err());
    }
    // A side with its ends exchanged is none.
    let crossed = text.replacen("\"hull\":[", "\"hull\":[[2.0,1.0],", 1);
    assert!(serde_json::from_str::<FilterState<ConstrainedZonotope>>(&crossed).is_err());
}

//! First sets that are hard: points, segments, sets pinned by equations, sets of rounding size, wide and huge ones, rows twice. Every filter on
//! constrained zonotopes keeps the state or says what is in its way; it never claims a contradiction.

use estimators::{Curvature, CzFilter, CzOptions, Estimator, EstimatorError, Method, Rcz, RczOptions, SetFilter};
use scalars::Interval;
use setrep::{Complexity, ConstrainedZonotope, Matrix, Membership, Workspace, Zonotope};

use crate::plants::{Draw, attitude, attitude_run, exactly, holds, planar, planar_run};
use crate::support::Random;

/// States, measurements and inputs.
type Run = Vec<(Vec<Interval>, Vec<f64>, Vec<f64>)>;

/// Sets that hold `x`.
fn starts(x: &[f64]) -> Vec<(&'static str, ConstrainedZonotope)> {
    let n = x.len();
    let cube = |radius: f64| ConstrainedZonotope::from_box(x, &vec![radius; n]).unwrap();
    let mut segment = Matrix::zeros(n, 0);
    segment.push_col(&vec![0.05; n]).unwrap();
    let identity = Matrix::identity(n);
    let pinned = ConstrainedZonotope::from_cg_rep(x, &identity, &identity, &vec![0.0; n]).unwrap();
    let mut workspace = Workspace::new();
    let mut doubled = cube(0.1);
    for _ in 0..4 {
        doubled.intersect_half_space(&vec![1.0; n], x.iter().sum(), &mut workspace).unwrap();
        doubled.intersect_half_space(&vec![-1.0; n], -x.iter().sum::<f64>(), &mut workspace).unwrap();
    }
    // One generator of each power of ten.
    let mut steep = Matrix::zeros(n, 0);
    for k in 0..12 {
        let mut column = vec![0.0; n];
        (column[k % n], column[(k + 1) % n]) = (10f64.powi(-(k as i32) - 1), 10f64.powi(-12));
        steep.push_col(&column).unwrap();
    }
    vec![
        ("point", cube(0.0)),
        ("segment", Zonotope::new(x, &segment).unwrap().into()),
        ("pinned", pinned),
        ("of rounding size", cube(1e-16)),
        ("tiny", cube(1e-150)),
        ("a plane by rows that stand there twice", doubled),
        ("many decades", Zonotope::new(x, &steep).unwrap().into()),
        ("wide", cube(3.0)),
        ("huge", cube(1e8)),
        ("near overflow", cube(1e300)),
    ]
}

/// Runs a filter as far as it gets: to the end, or to an error that is no contradiction.
fn survive<M: Method<Set = ConstrainedZonotope>>(
    filter: Result<SetFilter<M>, EstimatorError>,
    run: &Run,
    what: &str,
) -> bool {
    let Ok(mut filter) = filter else { return false };
    for (k, (x, y, _)) in run.iter().enumerate() {
        let before = filter.state().set.clone();
        let moved = if k == 0 { Ok(()) } else { filter.predict(&run[k - 1].2) };
        if let Err(error) = moved.and_then(|()| filter.update(y)) {
            let honest = !matches!(error, EstimatorError::Inconsistent(_));
            assert!(honest, "{what}, step {k}: {error} {before:?}");
            return false;
        }
        assert!(holds(filter.hull(), x), "{what}, step {k}: {:?} {x:?}", filter.hull());
        let member = filter.enclosure().membership(x, &mut Workspace::new()).unwrap();
        assert_ne!(member, Membership::ProvenOutside, "{what}, step {k}");
    }
    true
}

#[test]
fn hard_first_sets_are_followed_or_refused() {
    let (small, large) = (Complexity { generators: 8, constraints: 3 }, Complexity { generators: 12, constraints: 5 });
    let mut finished = [0; 2];
    for draw in [Draw::Uniform, Draw::Vertex, Draw::Constant] {
        let points: Run =
            planar_run(draw, 5, &mut Random::new(94)).into_iter().map(|(x, y)| (exactly(&x), y, Vec::new())).collect();
        let quaternions: Run =
            attitude_run(0.15, draw, 5, &mut Random::new(95)).into_iter().map(|(x, y, u)| (x, y, u.to_vec())).collect();
        for (limit, is_planar) in [(small, true), (large, false)] {
            let (system, run) = if is_planar { (planar(), &points) } else { (attitude(0.15), &quaternions) };
            let truth: Vec<f64> = run[0].0.iter().map(Interval::mid).collect();
            for (name, start) in starts(&truth) {
                let whole = CzOptions { curvature: Curvature::Generators, ..CzOptions::czfo(Some(limit)) };
                for options in [CzOptions::czmv(Some(limit)), CzOptions::czfo(Some(limit)), whole] {
                    let what = format!("{name}, {draw:?}, {:?}", options.extension);
                    let filter = CzFilter::new(system.clone(), start.clone(), options.with_consistency());
                    finished[usize::from(survive(filter, run, &what))] += 1;
                }
                let n = truth.len();
                for options in [RczOptions::fast(n), RczOptions::cheap(n)] {
                    let what = format!("{name}, {draw:?}, {:?}", options.tier);
                    let filter = Rcz::new(system.clone(), start.clone(), options);
                    finished[usize::from(survive(filter, run, &what))] += 1;
                }
            }
        }
    }
    println!("{} gave up, {} went on to the end", finished[0], finished[1]);
    assert!(finished[1] > 3 * finished[0], "{finished:?}");
}

//! No rigorous filter loses the truth or proves a false contradiction, wherever the noises are; results do not depend on threads.

use scenarios::cz_attitude::contenders::{PRINTED_NOISE, all, rigorous};
use scenarios::cz_attitude::simulation::simulate;
use scenarios::cz_attitude::studies::{Scale, Studies};
use scenarios::cz_attitude::tables;
use scenarios::cz_planar::{PlanarExperiment, contenders, plant};
use scenarios::noise::NoiseKind;
use scenarios::set_study::{Contender, Course, End, Trajectory};
use scenarios::{Context, Experiment};

use crate::{cases, random};

const KINDS: [NoiseKind; 3] = [NoiseKind::Uniform, NoiseKind::Vertices, NoiseKind::ConstantVertex];

fn check(trajectory: &Trajectory, contenders: &[Contender], kind: NoiseKind) {
    for contender in contenders {
        let course = Course::of(trajectory, &mut *contender.start(()).unwrap(), &[]).unwrap();
        let watched = course.containment;
        assert!(watched.points > 0);
        assert_eq!(watched.points, watched.not_outside, "{} loses the truth, {kind:?}", contender.method);
        assert!(!matches!(course.end, End::Contradiction(_)), "{}: {:?}, {kind:?}", contender.method, course.end);
    }
}

#[test]
fn planar_truth_is_never_lost() {
    let contenders = contenders().unwrap();
    for kind in KINDS {
        for run in 0..cases(10) {
            check(&plant::simulate(kind, 20, &mut random(kind.name(), run)).unwrap(), &contenders, kind);
        }
    }
}

#[test]
fn attitude_truth_is_never_lost() {
    let contenders = rigorous(PRINTED_NOISE, &all()).unwrap();
    for kind in KINDS {
        for run in 0..cases(1) {
            check(&simulate(PRINTED_NOISE, kind, 12, &mut random(kind.name(), run)).unwrap(), &contenders, kind);
        }
    }
}

/// The results are the same bytes for one thread and for two.
#[test]
fn results_do_not_depend_on_threads() {
    let results = |threads: usize| -> String {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let context = Context { quick: true, runs: Some(2), ..Context::new(5) };
        let scale = Scale { runs: 2, table_runs: 2, steps: 3, search_steps: 2, watched_steps: 2 };
        let (planar, attitude) =
            pool.install(|| (PlanarExperiment.run(&context).unwrap(), Studies::run(&context, &scale).unwrap()));
        let mut results = planar.results;
        assert!(results.rows.iter().any(|row| row.metric_name() == "contained_proven"));
        results.rows.extend(tables::rows(&attitude));
        results.to_json().unwrap()
    };
    assert!(results(1) == results(2));
}

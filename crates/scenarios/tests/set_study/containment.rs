//! No rigorous filter loses the truth or proves a false contradiction, wherever the noises are; results do not depend on threads.

use scenarios::cz_attitude::AttitudeExperiment;
use scenarios::cz_attitude::contenders::{PRINTED_NOISE, all, rigorous};
use scenarios::cz_attitude::simulation::simulate;
use scenarios::cz_planar::{PlanarExperiment, contenders, plant};
use scenarios::noise::NoiseKind;
use scenarios::set_study::{Contender, Course, End, Trajectory};
use scenarios::{Context, Experiment};

use crate::random;

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
        for run in 0..10 {
            check(&plant::simulate(kind, 20, &mut random(kind.name(), run)).unwrap(), &contenders, kind);
        }
    }
}

#[test]
fn attitude_truth_is_never_lost() {
    let contenders = rigorous(PRINTED_NOISE, &all()).unwrap();
    for kind in KINDS {
        for run in 0..2 {
            check(&simulate(PRINTED_NOISE, kind, 25, &mut random(kind.name(), run)).unwrap(), &contenders, kind);
        }
    }
}

/// The results are the same bytes for one thread and for two.
#[test]
fn results_do_not_depend_on_threads() {
    let files = |threads: usize| -> Vec<(String, String)> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let context = Context { quick: true, runs: Some(1), ..Context::new(5) };
        let outputs =
            pool.install(|| [PlanarExperiment.run(&context).unwrap(), AttitudeExperiment.run(&context).unwrap()]);
        let files = outputs.iter().flat_map(|output| output.files().unwrap());
        files
            .map(|file| (file.name, file.text))
            .filter(|(name, _)| name != "timings.json" && name != "report.md")
            .collect()
    };
    let (one, two) = (files(1), files(2));
    assert!(one.iter().any(|(name, text)| name == "results.json" && text.contains("contained_proven")));
    assert!(one == two);
}

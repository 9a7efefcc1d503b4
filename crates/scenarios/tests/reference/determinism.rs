//! The same seed gives the same bytes, whatever the number of threads.

use scenarios::inzsmf::InZsmfExperiment;
use scenarios::inzsmf::study::truth_of;
use scenarios::noise::NoiseKind;
use scenarios::{Context, Experiment};

/// All files but the timings and the report, which shows them.
fn files(threads: usize) -> Vec<(String, String)> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let context = Context { quick: true, runs: Some(2), ..Context::new(5) };
    let output = pool.install(|| InZsmfExperiment.run(&context)).unwrap();
    let files = output.files().unwrap().into_iter().map(|file| (file.name, file.text));
    files.filter(|(name, _)| name != "timings.json" && name != "report.md").collect()
}

#[test]
fn the_experiment_does_not_depend_on_threads() {
    let one = files(1);
    let two = files(2);
    assert!(one.iter().any(|(name, text)| name == "results.json" && text.contains("runs_violated")));
    for (a, b) in one.iter().zip(&two) {
        assert!(a == b, "{} differs between one and two threads", a.0);
    }
    assert_eq!(one.len(), two.len());
}

/// The noises depend on seed and run, and on nothing else.
#[test]
fn seeds_and_runs_have_their_own_noises() {
    let truth = |seed, run| truth_of(&Context::new(seed), NoiseKind::Uniform, 3, run).unwrap();
    assert_eq!(truth(5, 0), truth(5, 0));
    assert_ne!(truth(5, 0).outputs, truth(6, 0).outputs);
    assert_ne!(truth(5, 0).outputs, truth(5, 1).outputs);
}

//! The same seed gives the same bytes, whatever the number of threads.

use scenarios::inzsmf::InZsmfExperiment;
use scenarios::{Context, Experiment};

/// All files but the timings and the report, which shows them.
fn files(threads: usize, seed: u64) -> Vec<(String, String)> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let context = Context { quick: true, runs: Some(2), ..Context::new(seed) };
    let output = pool.install(|| InZsmfExperiment.run(&context)).unwrap();
    let files = output.files().unwrap().into_iter().map(|file| (file.name, file.text));
    files.filter(|(name, _)| name != "timings.json" && name != "report.md").collect()
}

#[test]
fn the_experiment_does_not_depend_on_threads() {
    let one = files(1, 5);
    let two = files(2, 5);
    assert!(one.iter().any(|(name, text)| name == "results.json" && text.contains("runs_violated")));
    for (a, b) in one.iter().zip(&two) {
        assert!(a == b, "{} differs between one and two threads", a.0);
    }
    assert_eq!(one.len(), two.len());
    assert_ne!(one[0], files(2, 6)[0]);
}

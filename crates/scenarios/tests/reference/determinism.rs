//! The same seed gives the same bytes, whatever the number of threads.

use scenarios::images::ImagesExperiment;
use scenarios::inzsmf::InZsmfExperiment;
use scenarios::inzsmf::study::truth_of;
use scenarios::noise::NoiseKind;
use scenarios::{Context, Experiment, Mode};

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

/// The tables of `images` are the same bytes for one thread and for two; the methods hold every watched point.
#[test]
fn the_tightness_tables_do_not_depend_on_threads() {
    let results = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let context = Context { runs: Some(2), ..Context::new(5) };
        pool.install(|| ImagesExperiment.run(&context)).unwrap().results
    };
    let (one, two) = (results(1), results(2));
    assert!(one.to_json().unwrap() == two.to_json().unwrap());
    let contained = one.rows.iter().filter(|row| row.metric_name() == "containment");
    let lost: Vec<_> = contained.filter(|row| row.get_value() != Some(1.0)).collect();
    assert!(
        lost.iter().all(|row| row.table_name() == "Lemma 2" && row.get_mode() == Some(Mode::Published)),
        "{lost:?}"
    );
    assert_eq!(lost.len(), 1);
    let ratios = one.rows.iter().filter(|row| row.metric_name() == "width ratio");
    assert!(ratios.clone().count() > 100);
    for row in ratios {
        let ratio = row.get_value().unwrap();
        assert!((0.999..50.0).contains(&ratio), "{row:?}");
    }
}

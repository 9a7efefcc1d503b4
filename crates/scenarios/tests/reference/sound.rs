//! `sound` mode against an independent computation in Python (numpy, 100 runs, other random numbers).

use scenarios::inzsmf::cases::TABLE_I;
use scenarios::inzsmf::sound::Variant;
use scenarios::inzsmf::study;
use scenarios::metrics::RunMetrics;
use scenarios::results::mean_and_sd;
use scenarios::{Context, Mode};

/// Runs of the independent computation.
const THEIR_RUNS: f64 = 100.0;
/// Runs here.
const RUNS: usize = 24;

/// Mean RMSE(theta), RMSE(x), AAR(theta), AAR(x) of ZSMF and InZSMF with Combastel's reduction to 30 generators, rows of Table I.
const INDEPENDENT: [[[f64; 4]; 2]; 8] = [
    [[0.305, 0.351, 14.04, 17.07], [0.246, 0.349, 12.50, 17.93]],
    [[0.312, 0.352, 14.16, 17.18], [0.254, 0.350, 12.56, 17.97]],
    [[0.334, 0.356, 14.13, 17.16], [0.278, 0.352, 12.51, 17.94]],
    [[0.335, 0.377, 14.28, 17.32], [0.285, 0.374, 12.59, 18.12]],
    [[0.312, 0.380, 14.17, 17.20], [0.257, 0.377, 12.60, 18.06]],
    [[0.513, 0.406, 14.22, 17.28], [0.467, 0.396, 12.58, 18.11]],
    [[0.321, 0.382, 14.23, 17.25], [0.258, 0.379, 12.54, 17.99]],
    [[0.394, 0.378, 14.17, 17.21], [0.333, 0.372, 12.54, 18.01]],
];

/// Half a unit of the last digit of those means.
const ROUNDING: [f64; 4] = [0.0005, 0.0005, 0.005, 0.005];

/// All 64 means agree within three standard errors of the difference, the spread taken from our runs for both sides.
#[test]
fn agrees_with_an_independent_computation() {
    let contenders = Variant::of_the_paper().contenders();
    let pairs: Vec<_> =
        (0..TABLE_I.len()).flat_map(|case| contenders.iter().map(move |contender| (case, contender))).collect();
    let cells = study::study(&Context::new(1), "sound", RUNS, &pairs).unwrap();
    let mut disagreements = Vec::new();
    for (case, row) in TABLE_I.iter().enumerate() {
        for (method, theirs) in ["zsmf", "inzsmf"].iter().zip(INDEPENDENT[case]) {
            let cell = study::find(&cells, case, method, Mode::Sound).unwrap();
            for metric in 0..4 {
                let (mean, sd) = mean_and_sd(&cell.samples(metric)).unwrap();
                let error = sd.unwrap() * (1.0 / RUNS as f64 + 1.0 / THEIR_RUNS).sqrt();
                let name = RunMetrics::NAMES[metric].0;
                println!(
                    "{} {method} {name}: {mean:.4} against {}, standard error {error:.4}",
                    row.label, theirs[metric]
                );
                if (mean - theirs[metric]).abs() > 3.0 * error + ROUNDING[metric] {
                    disagreements.push(format!("{} {method} {name}: {mean} against {}", row.label, theirs[metric]));
                }
            }
        }
    }
    assert!(disagreements.is_empty(), "{disagreements:#?}");
}

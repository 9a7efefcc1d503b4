//! `published` mode against the tables of paper 000.

use scenarios::inzsmf::cases::{TABLE_I, TABLE_II, TABLE_II_CASE};
use scenarios::inzsmf::{published, study};
use scenarios::{Context, Mode};

/// Indices of the metrics in a cell.
const AAR_HEADING: usize = 2;
const AAR_POSITION: usize = 3;

/// `AAR(x)` within 2 % and `AAR(theta)` within 6 % of the paper in all 16 cells of Table I and the pole rows of Table II, from six runs.
#[test]
fn areas_are_the_papers() {
    let contenders = published::contenders().unwrap();
    let pairs: Vec<_> =
        (0..TABLE_I.len()).flat_map(|case| contenders.iter().map(move |contender| (case, contender))).collect();
    let cells = study::study(&Context::new(1), "published", 6, &pairs).unwrap();
    let check = |case: usize, method: &str, paper: &[f64; 4]| {
        let cell = study::find(&cells, case, method, Mode::Published).unwrap();
        for (metric, tolerance) in [(AAR_POSITION, 0.02), (AAR_HEADING, 0.06)] {
            let off = cell.mean(metric) / paper[metric] - 1.0;
            println!(
                "{} {method} metric {metric}: {:.4} paper {:.4} ({:+.2} %)",
                TABLE_I[case].label,
                cell.mean(metric),
                paper[metric],
                100.0 * off
            );
            assert!(
                off.abs() <= tolerance,
                "{} {method}: {} against {}",
                TABLE_I[case].label,
                cell.mean(metric),
                paper[metric]
            );
        }
    };
    for (case, row) in TABLE_I.iter().enumerate() {
        check(case, "zsmf", &row.paper_zsmf);
        check(case, "inzsmf", &row.paper_inzsmf);
    }
    for (method, _, paper) in TABLE_II.iter().filter(|row| row.0.ends_with("/pole")) {
        check(TABLE_II_CASE, method, paper);
    }
}

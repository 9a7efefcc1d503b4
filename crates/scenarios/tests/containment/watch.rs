//! The containment study on few runs.

use scenarios::Context;
use scenarios::inzsmf::containment::{Tally, Watched, study};
use scenarios::noise::NoiseKind;

/// What is known of the filters: ZSMF is safe from the true pose and loses the truth after heading errors; InZSMF is safe after heading
/// errors and loses it after position errors with heading errors; both hold the truth at the start of the safe rows.
#[test]
fn filters_lose_the_truth_where_their_linearisation_fails() {
    let tallies = study(&Context::new(2), 2, 10).unwrap();
    let of = |watched: Watched, case: usize| -> &Tally {
        tallies.iter().find(|t| t.watched == watched && t.case == case && t.kind == NoiseKind::Uniform).unwrap()
    };
    for case in [1, 2] {
        assert_eq!(of(Watched::Zsmf, case).runs_violated(), 2, "row {case}");
        assert!(of(Watched::Zsmf, case).largest_gauge() > 1.0);
    }
    for case in [5, 6, 7] {
        assert_eq!(of(Watched::InZsmf, case).runs_violated(), 2, "row {case}");
        assert!(of(Watched::InZsmf, case).largest_gauge() > 10.0);
    }
    for (watched, cases) in [(Watched::Zsmf, [0, 3]), (Watched::InZsmf, [0, 1])] {
        for case in cases {
            let tally = of(watched, case);
            assert_eq!(tally.runs_violated(), 0);
            assert!(tally.runs.iter().all(|run| run.steps == 40 && run.proven == 40 && run.gauge < 1.0));
        }
    }
    // A violation and a proof of containment exclude each other.
    assert!(tallies.iter().flat_map(|tally| &tally.runs).all(|run| run.violated + run.proven <= run.steps));
}

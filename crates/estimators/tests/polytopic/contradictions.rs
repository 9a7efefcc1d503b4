//! Measurements that no state explains: a proof, and the filter is as it was.

use estimators::{Culprit, Estimator, EstimatorError, VhOptions};
use setrep::Workspace;

use crate::plants::{is_proof, planar, unicycle};

#[test]
fn contradictory_measurements_are_refuted_by_every_filter() {
    let mut workspace = Workspace::new();
    for example in [planar(3.0), unicycle(1.0, 1.0)] {
        for (name, mut filter) in example.filters() {
            let before = filter.half_spaces(200, &mut workspace).unwrap();
            let y = vec![Some(40.0); example.output.len()];
            let error = filter.correct(Some(&y)).unwrap_err();
            assert!(is_proof(&error), "{name}: {error:?}");
            assert_eq!(filter.half_spaces(200, &mut workspace).unwrap(), before, "{name}");
            assert!(filter.advance(&[]).is_ok(), "{name}");
        }
    }
}

/// The outputs together contradict what each of them allows: `x_1` near its right end, `x_2 - x_1` as if `x_2` were above its own.
#[test]
fn the_culprits_are_named() {
    let mut filter = planar(1.0).vh(VhOptions::paper());
    let error = filter.update(&[0.5, 40.0]).unwrap_err();
    let EstimatorError::Inconsistent(found) = &error else { panic!("{error:?}") };
    assert!(found.culprits.contains(&Culprit::Measurement(1)) && found.culprits.contains(&Culprit::Prediction));
    assert!(found.verify() && (38.0..40.0).contains(&found.margin()), "{}", found.margin());
    assert!(filter.update(&[0.5, f64::NAN]).is_err() && filter.update(&[0.5]).is_err());
}

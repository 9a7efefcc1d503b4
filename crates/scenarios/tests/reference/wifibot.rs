//! The real robot logs, where the data is there.

use std::path::PathBuf;

use lie_groups::LieGroup;
use nalgebra::{Matrix2, Matrix2x3, Matrix3, Vector3};
use scenarios::data::wifibot::{HOW_TO_GET, load};
use scenarios::wifibot::odometry::{Course, element};
use scenarios::wifibot::{LOGS, WifibotExperiment};
use scenarios::{Context, Experiment, ScenarioError};

/// The folder with the data; one line that says how to get it where there is none.
pub(crate) fn data() -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("ORBITOPE_DATA").map(PathBuf::from) else {
        println!("skipped, ORBITOPE_DATA is not set: {HOW_TO_GET}");
        return None;
    };
    for number in LOGS {
        if let Err(error @ ScenarioError::DataMissing { .. }) = load(Some(&folder), "wifibot", number) {
            println!("skipped {error}");
            return None;
        }
    }
    Some(folder)
}

/// The displacement of a window is `s d + (R - I) l`: odometry `d` times a scale, and a lever arm `l` swung by the turn `R`.
/// An independent computation over windows of 50 samples gave the fits below; with the speeds read as those of the interval that begins, `s` would be 0.951 and 0.949.
#[test]
fn scale_and_lever_arm_of_the_logs() {
    let Some(folder) = data() else { return };
    for (number, expected) in LOGS.into_iter().zip([[0.9943, 0.0172, 0.0042], [0.9949, 0.0217, 0.0046]]) {
        let course = Course::new(number, &load(Some(&folder), "wifibot", number).unwrap()).unwrap();
        let (mut normal, mut right) = (Matrix3::<f64>::zeros(), Vector3::zeros());
        let mut from = course.start;
        for window in &course.windows {
            let moved = element(&from).inverse().compose(&element(&window.end));
            let swing = moved.act_linear() - Matrix2::identity();
            let [_, d1, d2] = window.motion;
            let rows = Matrix2x3::new(d1, swing[(0, 0)], swing[(0, 1)], d2, swing[(1, 0)], swing[(1, 1)]);
            normal += rows.transpose() * rows;
            right += rows.transpose() * moved.translation();
            from = window.end;
        }
        let fit = normal.lu().solve(&right).unwrap();
        let miss = fit - Vector3::from(expected);
        assert!(miss[0].abs() < 1e-3 && miss[1].abs() < 2e-3 && miss[2].abs() < 2e-3, "log {number}: {fit}");
    }
}

/// Without the data the experiment says how to get it; nothing else is an error.
#[test]
fn without_data_the_experiment_says_how_to_get_it() {
    let error = WifibotExperiment.run(&Context::new(1)).unwrap_err();
    assert!(matches!(&error, ScenarioError::DataMissing { experiment: "wifibot", .. }), "{error}");
}

#[test]
fn the_robot_experiment_does_not_depend_on_threads() {
    let Some(folder) = data() else { return };
    let results = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let context = Context { runs: Some(2), data: Some(&folder), ..Context::new(5) };
        pool.install(|| WifibotExperiment.run(&context)).unwrap().results.to_json().unwrap()
    };
    let one = results(1);
    assert!(one.contains("\"contained_proven\""));
    assert!(one == results(2));
}

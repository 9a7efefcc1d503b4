//! The real robot logs, where the data is there.

use std::path::PathBuf;

use scenarios::data::wifibot::{HOW_TO_GET, load};
use scenarios::wifibot::odometry::Course;
use scenarios::wifibot::{LOGS, WifibotExperiment};
use scenarios::{Context, Experiment, ScenarioError};

/// The folder with the data; one line that says how to get it where there is none.
fn data() -> Option<PathBuf> {
    let folder = std::env::var_os("ORBITOPE_DATA").map(PathBuf::from);
    if folder.is_none() {
        println!("skipped, ORBITOPE_DATA is not set: {HOW_TO_GET}");
    }
    folder
}

/// An independent least-squares fit gives a wheel scale of 0.95 for both logs: the reference moves 5 % less than the wheels say.
#[test]
fn the_wheels_are_five_per_cent_off() {
    let Some(folder) = data() else { return };
    for number in LOGS {
        let course = Course::new(number, &load(Some(&folder), "wifibot", number).unwrap()).unwrap();
        let mut from = course.start;
        let (mut wheels, mut reference) = (0.0, 0.0);
        for window in &course.windows {
            wheels += window.motion[1].hypot(window.motion[2]);
            reference += (window.end.position[0] - from.position[0]).hypot(window.end.position[1] - from.position[1]);
            from = window.end;
        }
        let scale = reference / wheels;
        assert!((0.93..0.97).contains(&scale), "log {number}: {scale}");
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

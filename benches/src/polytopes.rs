//! Steps of paper 004's polytopic filter, counted in interval hulls of the predicted set as a constrained zonotope.

use std::hint::black_box;

use estimators::{Estimator, Vh, VhOptions};
use scenarios::noise::NoiseKind;
use scenarios::polytopes::PolytopeCase;
use scenarios::set_study::Trajectory;
use scenarios::{monte_carlo, polytope_planar, unicycle};
use setrep::{ConstrainedZonotope, Workspace};

use crate::timing::Bench;

/// The rows `polytope/*`: a prediction and an update at `k = 3`.
pub fn benches() -> Vec<Bench> {
    let mut rng = monte_carlo::stream(1, "bench", 0);
    let planar = polytope_planar::plant::case(polytope_planar::plant::Form::Cas, 3.0).expect("the sizes fit");
    let planar_run = polytope_planar::plant::simulate(NoiseKind::Uniform, 3, &mut rng).expect("a proven run");
    let robot = unicycle::plant::case(true, 1.0).expect("the sizes fit");
    let robot_run = unicycle::plant::simulate(true, NoiseKind::Uniform, 3, &mut rng).expect("a proven run");
    vec![
        step("polytope/example-1", &planar, &planar_run, VhOptions::paper()),
        step("polytope/example-2", &robot, &robot_run, VhOptions::paper()),
        step("polytope/example-2-tight", &robot, &robot_run, VhOptions::tight()),
    ]
}

/// The last step of a run.
fn step(name: &'static str, case: &PolytopeCase, run: &Trajectory, options: VhOptions) -> Bench {
    let mut filter: Vh = case.vh(options).expect("a valid start");
    let last = run.steps();
    for k in 0..last {
        filter.update(&run.outputs[k]).expect("a consistent run");
        if k + 1 < last {
            filter.predict(&run.inputs[k]).expect("bounded sets");
        }
    }
    let mut predicted = filter.clone();
    predicted.predict(&run.inputs[last - 1]).expect("bounded sets");
    let mut workspace = Workspace::new();
    let half_spaces = predicted.enclosure().to_h_polytope().expect("a bounded set");
    let set = ConstrainedZonotope::from_h_polytope(&half_spaces, &mut workspace).expect("a bounded set");
    let (input, output) = (run.inputs[last - 1].clone(), run.outputs[last].clone());
    let state = filter.state().clone();
    let ours = move || {
        filter.restore(&state).expect("a state of its own");
        filter.predict(black_box(&input)).expect("bounded sets");
        filter.update(black_box(&output)).expect("a consistent run");
    };
    Bench::new(name, "cz-hull", ours, move || {
        black_box(set.interval_hull(&mut workspace).expect("a bounded set"));
    })
}

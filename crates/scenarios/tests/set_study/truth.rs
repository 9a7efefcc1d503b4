//! The simulators under the truth contract.

use nonlin_bounds::{DynFunction, Jet, Order};
use scalars::Interval;
use scenarios::cz_attitude::plant::{AttitudeOutput, RATE_NOISE, SquaredNorm};
use scenarios::cz_attitude::simulation::{noise_between, simulate};
use scenarios::cz_planar::plant::{self, NOISE, PlanarOutput, PlanarStep};
use scenarios::noise::NoiseKind;
use scenarios::set_study::Trajectory;
use scenarios::truth::proven_within;

use crate::random;

/// Largest distance from its bound that counts as "at the bound".
const AT_BOUND: f64 = 1e-12;
const KINDS: [NoiseKind; 3] = [NoiseKind::Uniform, NoiseKind::Vertices, NoiseKind::ConstantVertex];

/// Value of a function of states and noises, without the noises.
fn value(f: &dyn DynFunction, state: &[Interval], noises: usize) -> Vec<Interval> {
    let variables: Vec<_> = state.iter().copied().chain(std::iter::repeat_n(Interval::ZERO, noises)).collect();
    let mut jet = Jet::new();
    f.enclose(Order::Value, &variables, &[], &mut jet).unwrap();
    jet.values().to_vec()
}

/// A noise is proven in its bound, and at it if its kind is that of vertices.
fn check(noise: Interval, bound: f64, kind: NoiseKind) {
    assert!(proven_within(&noise, bound), "{kind:?}: {noise:?} beyond {bound}");
    assert!(kind == NoiseKind::Uniform || bound - noise.mig() <= AT_BOUND, "{kind:?}: {noise:?} is not at {bound}");
}

fn check_outputs(run: &Trajectory, g: &dyn DynFunction, bound: f64, kind: NoiseKind) {
    for (state, output) in run.states.iter().zip(&run.outputs) {
        for (value, &y) in value(g, state, output.len()).iter().zip(output) {
            check(Interval::point(y) - *value, bound, kind);
        }
    }
}

#[test]
fn planar_runs_are_exact_trajectories() {
    for kind in KINDS {
        for run in 0..20 {
            let run = plant::simulate(kind, 50, &mut random("truth", run)).unwrap();
            assert_eq!((run.steps(), run.inputs.len(), run.states.len()), (50, 50, 51));
            assert!(run.widest() == 0.0);
            check_outputs(&run, &PlanarOutput, NOISE, kind);
            for pair in run.states.windows(2) {
                for (value, next) in value(&PlanarStep, &pair[0], 2).iter().zip(&pair[1]) {
                    check(*next - *value, NOISE, kind);
                }
            }
        }
    }
}

#[test]
fn attitude_runs_are_exact_trajectories_on_the_sphere() {
    let mut widest = 0.0_f64;
    for kind in KINDS {
        for run in 0..5 {
            let run = simulate(0.15, kind, 300, &mut random("truth", run)).unwrap();
            check_outputs(&run, &AttitudeOutput, 0.15, kind);
            for (k, u) in run.inputs.iter().enumerate() {
                let u = [u[0], u[1], u[2]];
                for noise in noise_between(&run.states[k], &run.states[k + 1], &u) {
                    check(noise, RATE_NOISE, kind);
                    widest = widest.max(noise.width());
                }
                assert!(value(&SquaredNorm, &run.states[k], 0)[0].contains(1.0));
            }
            // Enclosures of states do not widen with time.
            assert!(run.widest() < 4e-15, "{:e}", run.widest());
        }
    }
    println!("widest noise {widest:e}");
    assert!(widest < 2e-13, "{widest:e}");
}

/// The noise that is solved for is the noise of the step: another one is found out.
#[test]
fn the_noise_of_an_attitude_step_is_solved_for() {
    let run = simulate(0.15, NoiseKind::ConstantVertex, 2, &mut random("truth", 0)).unwrap();
    let u = [run.inputs[0][0], run.inputs[0][1], run.inputs[0][2]];
    let right = noise_between(&run.states[0], &run.states[1], &u);
    let moved = noise_between(&run.states[0], &run.states[1], &[u[0], u[1] + 1e-12, u[2]]);
    assert!(right[1].disjoint(&moved[1]) && right[0].mid() == moved[0].mid());
    // Back and forth: the sign of the turn counts.
    let back = noise_between(&run.states[1], &run.states[0], &u);
    assert!(back.iter().any(|noise| noise.mag() > 10.0 * RATE_NOISE));
}

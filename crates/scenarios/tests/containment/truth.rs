//! The truth contract of the simulator and the bounds of the noises.

use scalars::Interval;
use scenarios::monte_carlo::stream;
use scenarios::noise::{BoundedNoise, NoiseKind};
use scenarios::truth::{Exact, output_within, proven_within};
use scenarios::vehicle::{OUTPUT_BOUNDS, PROCESS_BOUNDS, Vehicle};

/// Largest distance from its bound that counts as "at the bound".
const AT_BOUND: f64 = 1e-12;

/// Every noise of every run is proven in its bounds; noises at their bounds are within 1e-12 of them; enclosures stay tight.
#[test]
fn a_simulated_run_is_an_exact_trajectory() {
    let vehicle = Vehicle::new();
    let (mut widest_state, mut widest_noise, mut farthest) = (0.0_f64, 0.0_f64, 0.0_f64);
    for kind in NoiseKind::ALL {
        for run in 0..8 {
            let truth = vehicle.simulate(kind, 1571, &mut stream(3, kind.name(), run)).unwrap();
            for (k, output) in truth.outputs.iter().enumerate() {
                let process = vehicle.noise_between(&truth.states[k], &truth.states[k + 1]).unwrap();
                let state = truth.states[k].coordinates();
                let measurement = [0, 1].map(|i| Interval::point(output[i]) - state[i + 1]);
                let noises = process.iter().zip(PROCESS_BOUNDS).chain(measurement.iter().zip(OUTPUT_BOUNDS));
                for (noise, bound) in noises {
                    assert!(proven_within(noise, bound), "{kind:?} step {k}: {noise:?}");
                    widest_noise = widest_noise.max(noise.width());
                    if matches!(kind, NoiseKind::Vertices | NoiseKind::ConstantVertex) {
                        farthest = farthest.max(bound - noise.mig());
                    }
                }
                widest_state = state.iter().fold(widest_state, |widest, x| widest.max(x.width()));
            }
        }
    }
    println!("widest state {widest_state:e}, widest noise {widest_noise:e}, farthest from a bound {farthest:e}");
    assert!(widest_state <= 4e-14, "{widest_state:e}");
    assert!(widest_noise <= 2e-13, "{widest_noise:e}");
    assert!(farthest <= AT_BOUND, "{farthest:e}");
}

/// A step that needs more noise than allowed is found out: the proof can fail.
#[test]
fn a_step_beyond_the_bounds_is_not_proven() {
    let vehicle = Vehicle::new();
    let truth = vehicle.simulate(NoiseKind::ConstantVertex, 2, &mut stream(3, "beyond", 0)).unwrap();
    let honest = vehicle.noise_between(&truth.states[0], &truth.states[1]).unwrap();
    let mut moved = truth.states[1];
    // 1e-14 m in one period of 0.01 s is 1e-12 m/s: across a bound that the honest noise meets within 1e-12.
    moved.position = moved.position.map(|x| x.moved_by(1e-14));
    let plus = vehicle.noise_between(&truth.states[0], &moved).unwrap();
    moved.position = moved.position.map(|x| x.moved_by(-2e-14));
    let minus = vehicle.noise_between(&truth.states[0], &moved).unwrap();
    let inside = |noise: &[Interval; 3]| noise.iter().zip(PROCESS_BOUNDS).all(|(w, bound)| proven_within(w, bound));
    assert!(inside(&honest));
    assert!(!inside(&plus) || !inside(&minus));
}

/// All kinds stay in the box; vertices are at it and all occur; a constant vertex is constant; the Gaussian is centred and concentrated.
#[test]
fn noises_stay_in_their_bounds() {
    let bounds = [0.1, 1.0, 3.0];
    for kind in NoiseKind::ALL {
        let (mut rng, mut noise) = (stream(7, kind.name(), 0), BoundedNoise::new(kind, bounds));
        let draws: Vec<[f64; 3]> = (0..20_000).map(|_| noise.draw(&mut rng)).collect();
        let scaled: Vec<f64> = draws.iter().flat_map(|draw| [0, 1, 2].map(|i| draw[i] / bounds[i])).collect();
        assert!(draws.iter().all(|draw| (0..3).all(|i| draw[i].abs() < bounds[i])));
        let mean = scaled.iter().sum::<f64>() / scaled.len() as f64;
        let sd = (scaled.iter().map(|v| v * v).sum::<f64>() / scaled.len() as f64).sqrt();
        let (expected, largest) = match kind {
            NoiseKind::Uniform => (1.0 / 3.0_f64.sqrt(), 0.999),
            NoiseKind::Vertices | NoiseKind::ConstantVertex => (1.0, 1.0 - 1e-11),
            // A standard Gaussian cut at 3 has standard deviation 0.98658.
            NoiseKind::TruncatedGaussian => (0.98658 / 3.0, 0.98),
        };
        assert!((sd - expected).abs() < 0.01, "{kind:?}: sd {sd}");
        assert!(scaled.iter().any(|v| v.abs() > largest), "{kind:?}");
        if kind == NoiseKind::ConstantVertex {
            assert!(draws.windows(2).all(|pair| pair[0] == pair[1]));
        } else {
            assert!(mean.abs() < 0.015, "{kind:?}: mean {mean}");
        }
    }
}

#[test]
fn outputs_are_moved_inwards_until_proven() {
    let h = Interval::new(20.0, 20.0_f64.next_up()).unwrap();
    let y = output_within(&h, 1.0, 1.0).unwrap();
    assert!(y < 21.0 && (Interval::point(y) - h).mag() < 1.0);
    assert_eq!(output_within(&h, 0.25, 1.0), Some(20.25));
    // A state that is not known well enough has no proven output.
    assert_eq!(output_within(&Interval::new(0.0, 3.0).unwrap(), 0.0, 1.0), None);
    assert_eq!(output_within(&Interval::EMPTY, 0.0, 1.0), None);
    assert!(!proven_within(&Interval::EMPTY, 1.0) && !proven_within(&Interval::ENTIRE, 1.0));
}

/// Ten thousand moves of a tenth: the number stays known to an ulp and differences to 1e-17.
#[test]
fn exact_numbers_do_not_widen() {
    let (mut x, mut total) = (Exact::new(1.0), Interval::ZERO);
    for _ in 0..10_000 {
        let next = x.moved_by(0.1);
        let step = next.difference(x);
        assert!(step.width() <= 1e-15 && step.contains(0.1));
        total += step;
        x = next;
    }
    assert!(x.enclosure().width() <= 4e-13 && total.contains(x.value() - 1.0));
}

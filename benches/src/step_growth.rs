//! How the cost of a step of the ranged filter grows with the number of states, on the chain of tanks.

use estimators::{Estimator, Rcz, RczOptions};
use scenarios::figure::{Figure, Look, Panel, Series};
use scenarios::monte_carlo;
use scenarios::noise::NoiseKind;
use scenarios::tank_chain::plant::{simulate, start, system};

use crate::growth::fit;
use crate::timing::processor_time;

/// A name, and the options for so many states.
type Variant = (&'static str, fn(usize) -> RczOptions);

/// Numbers of tanks.
const SIZES: [usize; 4] = [6, 12, 30, 60];
/// Steps of a run: two re-encodings of the slow variant.
const STEPS: usize = 20;
/// Runs of which the fastest counts; one of the largest chain takes long enough.
const REPETITIONS: usize = 3;

/// A variant of the filter: its name, its options by the number of states, and microseconds a step by the number of tanks.
pub struct Sweep {
    label: &'static str,
    points: Vec<(f64, f64)>,
}

/// Times all variants and prints the figures.
pub fn sweeps() -> Vec<Sweep> {
    let variants: [Variant; 3] = [
        ("re-encoding every 10th step, 2 n constraints", RczOptions::slow),
        ("re-encoding every step, n + 1 constraints", RczOptions::fast),
        ("no linear programs", RczOptions::cheap),
    ];
    let sweep = |(label, options): (&'static str, fn(usize) -> RczOptions)| {
        println!("Rcz on n tanks, {label}");
        let time = |&n: &usize| {
            let us = step_us(n, options(n));
            println!("{n:>6} {us:>14.0} us a step");
            (n as f64, us)
        };
        let sweep = Sweep { label, points: SIZES.iter().map(time).collect() };
        println!("exponent: {:.2}", fit(&sweep.points).1);
        sweep
    };
    variants.into_iter().map(sweep).collect()
}

/// Microseconds a step: an update, a prediction, and the reductions that fall due.
fn step_us(n: usize, options: RczOptions) -> f64 {
    let run = simulate(n, NoiseKind::Uniform, STEPS, &mut monte_carlo::stream(1, "growth", n));
    let run = run.expect("the steps are proven");
    let start = start(n).expect("the start is a box");
    let mut filter = Rcz::new(system(n).expect("the sizes fit"), start, options).expect("the sizes fit");
    let first = filter.state().clone();
    let mut fastest = f64::INFINITY;
    for _ in 0..REPETITIONS {
        filter.restore(&first).expect("a state of this filter");
        let begin = processor_time();
        for output in &run.outputs {
            filter.step(&[], output).expect("the noises keep their bounds");
        }
        let elapsed = processor_time() - begin;
        fastest = fastest.min(1e6 * elapsed.as_secs_f64() / run.outputs.len() as f64);
    }
    fastest
}

/// Times, and the power laws fitted to them.
pub fn figure(sweeps: &[Sweep]) -> Figure {
    let panel = Panel::new("Rcz on the chain of tanks", "number of states", "time of a step [us]").log_x().log_y();
    let panel = sweeps.iter().enumerate().fold(panel, |panel, (look, sweep)| {
        let (scale, exponent) = fit(&sweep.points);
        let law: Vec<_> = sweep.points.iter().map(|(x, _)| (*x, scale * x.powf(exponent))).collect();
        let label = format!("{}: n^{exponent:.1}", sweep.label);
        panel.with(Series::points("", Look::nth(look), sweep.points.clone())).with(Series::line(
            label,
            Look::nth(look),
            law,
        ))
    });
    Figure::new("step-growth", "Time of a filter step with the number of states", 1).with(panel)
}

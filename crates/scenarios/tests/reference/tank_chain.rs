//! The chain of tanks: radii beside those of an independent computation, containment with every noise.

use scenarios::noise::NoiseKind;
use scenarios::set_study::{Cell, RADIUS, study};
use scenarios::tank_chain::contenders::contenders;
use scenarios::tank_chain::{ideal, plant};
use scenarios::{Context, monte_carlo};

/// Runs of the filters that `wanted` names.
fn cells(n: usize, kind: NoiseKind, steps: usize, runs: usize, wanted: &[&str]) -> Vec<Cell> {
    let mut filters = contenders(n);
    filters.retain(|filter| wanted.contains(&&*filter.method));
    let context = Context::new(1);
    study(&context, "tank-chain test", runs, |rng: &mut _| plant::simulate(n, kind, steps, rng), &filters, &[RADIUS])
        .unwrap()
}

/// No step is lost, no run ends early.
fn check(cell: &Cell) {
    assert_eq!((cell.contradictions(), cell.diverged()), (0, 0), "{}", cell.method);
    for run in &cell.runs {
        assert_eq!(run.containment.shares().map(|shares| shares.0), Some(1.0), "{}", cell.method);
    }
}

/// An independent computation has .436 and .223 at k = 100 and 200 for re-encoding every tenth step, .503 and .444 at every step, .863 and
/// .517 for boxes.
#[test]
fn six_tanks_are_remembered() {
    let cells = cells(6, NoiseKind::Uniform, 200, 3, &["rcz", "rcz/every-step", "rcz/box"]);
    let at = |cell: &Cell, k: usize| cell.curve(0)[k];
    for cell in &cells {
        println!("{}: {:.3?}", cell.method, [10, 20, 50, 100, 200].map(|k| at(cell, k)));
        check(cell);
    }
    let [slow, every, boxes] = &cells[..] else { panic!("three filters") };
    assert!(at(slow, 100) <= 0.46 && at(slow, 200) <= 0.24);
    assert!(at(slow, 200) < at(every, 200) && at(every, 100) < at(boxes, 100));
}

/// The yardstick of thirty tanks is .692 at k = 50 in that computation; here it is computed for six.
#[test]
fn thirty_tanks_stay_near_the_yardstick() {
    let cells = cells(30, NoiseKind::Uniform, 50, 1, &["rcz"]);
    println!("n = 30: {:.3?}", [10, 20, 50].map(|k| cells[0].curve(0)[k]));
    check(&cells[0]);
    assert!(cells[0].curve(0)[50] <= 1.06 * 0.692);
}

#[test]
fn the_yardstick_is_below_the_filter_and_not_far() {
    let context = Context::new(1);
    let run = plant::simulate(6, NoiseKind::Uniform, 50, &mut monte_carlo::stream(context.seed, "tank-chain test", 0));
    let ideal = ideal::radii(6, &run.unwrap(), &[10, 20, 50]).unwrap();
    let cells = cells(6, NoiseKind::Uniform, 50, 1, &["rcz"]);
    for (&k, ideal) in [10, 20, 50].iter().zip(ideal) {
        let ours = cells[0].curve(0)[k];
        println!("k = {k}: {ours:.4}, yardstick {ideal:.4}");
        assert!(ours >= 0.99 * ideal && ours <= 1.15 * ideal);
    }
}

#[test]
fn tanks_with_noise_at_its_bounds_are_never_lost() {
    for kind in [NoiseKind::Vertices, NoiseKind::ConstantVertex] {
        for cell in &cells(6, kind, 40, 2, &["rcz", "rcz/every-step", "rcz/box"]) {
            check(cell);
        }
    }
}

//! Paper 004: its tables, orders between its filters, containment.

use scenarios::noise::NoiseKind;
use scenarios::polytope_planar::{self, PAPER_RUNS, TABLE_II, plant::Form};
use scenarios::polytopes::sizes::study_sizes;
use scenarios::polytopes::tables::{is_nowhere_larger, standard_errors};
use scenarios::set_study::{Cell, End};
use scenarios::unicycle::{self, Setting};
use scenarios::{Context, ScenarioError};

/// Every step of every run of a cell is complete, without a lost state.
fn check(cell: &Cell) {
    for run in &cell.runs {
        assert_eq!(run.end, End::Complete, "{}", cell.method);
        assert_eq!(run.containment.points, run.containment.not_outside, "{}", cell.method);
    }
}

fn planar(form: Form, kind: NoiseKind, runs: usize, methods: &[&str]) -> Result<Vec<Cell>, ScenarioError> {
    let mut contenders = polytope_planar::contenders(form, 3.0)?;
    contenders.retain(|contender| methods.contains(&&*contender.method));
    let simulate = |rng: &mut _| polytope_planar::plant::simulate(kind, polytope_planar::STEPS, rng);
    study_sizes(&Context::new(1), "polytopes test", runs, simulate, contenders)
}

/// Table II with tripled generators and the Jacobian as printed: V-H and COMB within three standard errors, RRSR up to `k = 2`; the order of the filters.
#[test]
fn table_2_is_reproduced() -> Result<(), ScenarioError> {
    let cells = planar(Form::Cas, NoiseKind::Uniform, 50, &["vh", "rrsr", "comb"])?;
    cells.iter().for_each(check);
    let find = |method: &str| cells.iter().find(|cell| cell.method == method).unwrap();
    for (method, printed) in TABLE_II.iter().filter(|(method, _)| ["vh", "rrsr", "comb"].contains(method)) {
        let errors = standard_errors(find(method), printed, PAPER_RUNS);
        println!("{method}: {:.4?}, standard errors {errors:.2?}", find(method).curve(0));
        let steps = if *method == "rrsr" { 3 } else { 5 };
        assert!(errors[..steps].iter().all(|error| error.abs() <= 3.0), "{method}: {errors:?}");
    }
    assert!(is_nowhere_larger(find("vh"), find("rrsr")) && is_nowhere_larger(find("comb"), find("vh")));
    Ok(())
}

/// The tight forms nearly halve the paper's volumes at `k = 3, 4`.
#[test]
fn the_defaults_are_much_smaller() -> Result<(), ScenarioError> {
    let cells = planar(Form::Tight, NoiseKind::Uniform, 50, &["vh/tight", "rcz"])?;
    assert_eq!(cells.len(), 2);
    for cell in &cells {
        check(cell);
        println!("{}: {:.4?}", cell.method, cell.curve(0));
    }
    let best = |k: usize| cells.iter().map(|cell| cell.curve(0)[k]).fold(f64::INFINITY, f64::min);
    assert!(best(3) <= 0.55 * 0.4077 && best(4) <= 0.55 * 0.2306, "{} {}", best(3), best(4));
    Ok(())
}

/// All filters keep the state with noises at the vertices of their bounds.
#[test]
fn noise_at_its_vertices_is_contained() -> Result<(), ScenarioError> {
    for form in [Form::Cas, Form::Tight] {
        let contenders = polytope_planar::contenders(form, 3.0)?;
        let simulate = |rng: &mut _| polytope_planar::plant::simulate(NoiseKind::Vertices, polytope_planar::STEPS, rng);
        study_sizes(&Context::new(2), "vertices", 4, simulate, contenders)?.iter().for_each(check);
    }
    Ok(())
}

/// Example II: sizes of the magnitude of Table III, a dozen vertices with process noise, and nothing lost. Noises at their vertices leave less.
#[test]
fn example_2_has_the_magnitude_of_table_3() -> Result<(), ScenarioError> {
    for setting in [Setting::NOISY, Setting::WIDE, Setting::VERTICES] {
        let mut contenders = unicycle::contenders(setting)?;
        contenders.retain(|contender| contender.method != "comb");
        let least = if setting == Setting::VERTICES { 0.0 } else { 1e-6 };
        let simulate = |rng: &mut _| unicycle::plant::simulate(setting.is_noisy, setting.kind, unicycle::STEPS, rng);
        for cell in study_sizes(&Context::new(1), "unicycle test", 4, simulate, contenders)? {
            check(&cell);
            println!("{} {}: {:?}", setting.label(), cell.method, cell.curve(0));
            assert!(cell.curve(0).iter().all(|volume| (least..1e-4).contains(volume)), "{}", cell.method);
            if cell.method == "vh" {
                assert!(cell.curve(1).iter().all(|vertices| (4.0..40.0).contains(vertices)));
            }
        }
    }
    Ok(())
}

/// Without process noise vertices multiply; the budget holds.
#[test]
fn example_2_without_noise_is_bounded() -> Result<(), ScenarioError> {
    let setting = Setting::QUIET;
    let mut contenders = unicycle::contenders(setting)?;
    contenders.retain(|contender| contender.method.starts_with("vh"));
    let simulate = |rng: &mut _| unicycle::plant::simulate(false, setting.kind, unicycle::STEPS, rng);
    for cell in study_sizes(&Context::new(1), "unicycle test, quiet", 2, simulate, contenders)? {
        check(&cell);
        println!("{}: {:?}, vertices {:.1?}", cell.method, cell.curve(0), cell.curve(1));
        assert!(cell.curve(1).iter().all(|vertices| *vertices <= 64.0));
        assert!(cell.curve(0)[4] <= 0.2 * cell.curve(0)[0]);
    }
    Ok(())
}

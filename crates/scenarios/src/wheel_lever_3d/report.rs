//! Rows and text.

use estimators::Left;
use estimators::kalman::{Chart, OnGroup};
use lie_groups::{LieGroup, SO3, TfgScaleLever3};
use nalgebra::{SVector, Vector3};

use super::model::{Imperfect3, N, Parts, Plain3, Spatial, Step};
use super::study::{ATTITUDE_DEG, Cell, End, HILLS, SPREADS};
use crate::report::significant;
use crate::wheel_lever::autonomy::{ESTIMATES, spread, vector};
use crate::wheel_lever::filters::Method;
use crate::{Report, Results, Row, ScenarioError, Table, monte_carlo};

/// Name of the table of residuals.
pub const RESIDUALS: &str = "autonomy";
/// Name of the table of runs.
pub const RUNS: &str = "convergence";
/// Turns of the steps whose residuals are shown, rad.
const TURNS_RAD: [f64; 4] = [0.0, 0.01, 0.1, 1.0];

/// Spread of an error after a step over random estimates with the same error; `lever` is what becomes of the lever arm.
fn residual<G: Spatial>(turn_rad: f64, lever: impl Fn(&Parts, &Step) -> Vector3<f64>) -> Result<f64, ScenarioError> {
    type Error<G> = OnGroup<G, Left, 3>;
    let rng = &mut monte_carlo::stream(9, "autonomy-3d", 0);
    let step = Step { turn: Vector3::new(0.36, 0.48, 0.8) * turn_rad, shift: vector(rng) };
    let error: SVector<f64, N> = 0.5 * vector(rng);
    let mut after = Vec::new();
    for _ in 0..ESTIMATES {
        let scale: SVector<f64, 1> = vector(rng);
        let parts = Parts {
            rotation: SO3::exp(&vector(rng)),
            scale: 1.1 + 0.8 * scale[0],
            position: 3.0 * vector(rng),
            lever: 2.0 * vector(rng),
        };
        let estimate = G::of(&parts)?;
        let moved = |x: &G| {
            let parts = x.parts();
            x.with(&Parts { lever: lever(&parts, &step), ..parts.moved(&step) })
        };
        let truth = Error::<G>::shift(&estimate, &error);
        after.push(Error::<G>::difference(&moved(&truth), &moved(&estimate))?);
    }
    Ok(spread(&after))
}

/// How far each error is from moving by itself.
///
/// # Errors
/// Those of the logarithms.
pub fn residuals() -> Result<Vec<Row>, ScenarioError> {
    let mut rows = Vec::new();
    let constant = |parts: &Parts, _: &Step| parts.lever;
    let turned = |parts: &Parts, step: &Step| SO3::exp(&step.turn).inverse().act(&parts.lever);
    for turn_rad in TURNS_RAD {
        let found = [
            ("lever arm constant in the body", "tfg-iekf", residual::<TfgScaleLever3<f64>>(turn_rad, constant)?),
            ("lever arm constant in the body", "iekf-imperfect", residual::<Imperfect3>(turn_rad, constant)?),
            ("lever arm constant in the body", "ekf", residual::<Plain3>(turn_rad, constant)?),
            ("lever arm turned back, X <- Omega' X", "tfg-iekf", residual::<TfgScaleLever3<f64>>(turn_rad, turned)?),
        ];
        rows.extend(found.map(|(row, method, spread)| {
            Row::new(RESIDUALS, row, method).metric(format!("spread, turn of {turn_rad} rad"), "").value(spread)
        }));
    }
    Ok(rows)
}

/// The rows of a cell.
#[must_use]
pub fn rows(cell: &Cell) -> Vec<Row> {
    let mut rows = Vec::new();
    let label = format!("X = ({}, {}, {})", cell.lever[0], cell.lever[1], cell.lever[2]);
    for method in Method::ALL {
        let ends = || cell.runs.iter().map(move |ends| &ends[method as usize]);
        let row = |metric: &str, unit: &str| Row::new(RUNS, label.clone(), method.name()).metric(metric, unit);
        let count = |is: fn(&End) -> bool| ends().filter(|end| is(end)).count() as f64;
        let percent = |is: fn(&End) -> bool| 100.0 * count(is) / cell.runs.len() as f64;
        let median = |value: fn(&End) -> f64| {
            let mut values: Vec<f64> = ends().map(value).collect();
            values.sort_by(f64::total_cmp);
            values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
        };
        rows.push(row("convergence", "%").value(percent(|end| end.convergent)));
        rows.push(row("rotation within 10 deg at the end", "%").value(percent(|end| end.close)));
        rows.push(row("scale negative at the end", "runs").value(count(|end| end.scale < 0.0)));
        rows.push(row("median(x)", "m").value(median(|end| end.errors[0])));
        rows.push(row("median(X)", "m").value(median(|end| end.errors[1])));
        rows.push(row("median NEES/10@20..", "").value(median(|end| end.nees)));
    }
    rows
}

/// The text.
#[must_use]
pub fn report(results: &Results) -> Report {
    let value = |table: &str, method: &str, metric: &str| {
        let mut rows = results.table(table).filter(|row| row.method_name() == method);
        let value = rows.find(|row| row.metric_name() == metric).and_then(Row::get_value);
        value.map_or("-".to_owned(), |x| significant(x, 3))
    };
    let of = |metric: &str| Method::ALL.map(|method| value(RUNS, method.name(), metric)).join(", ");
    let [heading, tilt] = ATTITUDE_DEG;
    let [(roll, roll_rate), (pitch, pitch_rate)] = HILLS;
    let [s, x, l] = SPREADS;
    let mut report = Report::new("wheel-lever-3d: unknown wheel scale and antenna in space");
    report
        .paragraph(
            "The paper's filter is exact in the plane because rotations of the plane commute. In space a lever arm that is constant in the body \
             does not move as the two-frame group asks: after a turn the error of the lever arm depends on its estimate, by the product of \
             lever arm, turn and attitude error. With the scale in the group the rest of the error still moves by itself.",
        )
        .heading("What holds")
        .list([
            format!(
                "A step with a turn of 0.01 rad (0.1 s of this drive turns by up to 0.03) spreads the two-frame error by {}, the imperfect one by {}, \
                 the plain one by {}; without a turn, or with a lever arm that is turned back, the two-frame error by rounding.",
                value(RESIDUALS, "tfg-iekf", "spread, turn of 0.01 rad"),
                value(RESIDUALS, "iekf-imperfect", "spread, turn of 0.01 rad"),
                value(RESIDUALS, "ekf", "spread, turn of 0.01 rad")
            ),
            format!(
                "With the short lever arm, in the order tfg-iekf, iekf-imperfect, ekf: convergent {} %, rotation right at the end {} %, negative scales in \
                 {} runs.",
                of("convergence"),
                of("rotation within 10 deg at the end"),
                of("scale negative at the end")
            ),
        ])
        .heading("Settings")
        .list([
            format!(
                "The drive of `wheel-lever` over hills: roll and pitch rates of {roll} and {pitch} rad/s with {roll_rate} and {pitch_rate} rad/s; gyro, \
                 wheel and fix noises as there, on three axes."
            ),
            format!(
                "First heading off by {heading} degrees, roll and pitch by {tilt} (standard deviations); spreads of scale {s}, position {x} m, lever arm \
                 {l} m, as `BEST` there. Convergence: the error about the body's vertical axis within three standard deviations at every fix from 20 s on."
            ),
            "Jacobians by central differences, for all errors alike.".to_owned(),
        ])
        .heading("Autonomy")
        .paragraph(format!("Largest difference of the errors after a step, over {ESTIMATES} random estimates with the same error."))
        .table(Table::pivot(results.table(RESIDUALS)))
        .heading("Runs")
        .table(Table::pivot(results.table(RUNS)));
    report
}

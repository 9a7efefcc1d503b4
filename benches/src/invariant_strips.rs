//! Steps of the filter of strips on paper 000's vehicle: counted in certified programs of its size, beside other filters, and by the number
//! of rows.

use std::hint::black_box;

use estimators::kalman::wheels::{InvariantWheels, WheelStep};
use estimators::kalman::{Gaussian, OnGroup, Ukf};
use estimators::{
    Estimator, InZsmf, InvariantStrips, Left, Outputs, PlanarBox, PlanarIncrement, PlanarMeasurement, StripsOptions,
};
use lie_groups::SE2;
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use scalars::Interval;
use scenarios::figure::{Figure, Look, Panel, Series};
use setrep::{BoxedRows, Reduction, Zonotope};

use crate::draw::Draw;
use crate::timing::{Bench, processor_time};

/// Turn and way of a step.
const TURN_RAD: f64 = 0.004;
const WAY_M: f64 = 0.08;

/// The rows `strips-step/*`: a prediction and an update in steady state.
pub fn benches() -> Vec<Bench> {
    let names = [("strips-step/se2", StripsOptions::pose()), ("strips-step/se2-fast", StripsOptions::fast_pose())];
    let mut benches: Vec<Bench> =
        names.map(|(name, options)| Bench::new(name, "40-programs-4x150", stepping(options), forty_programs())).into();
    benches.push(Bench::new("strips-step/se2", "inzsmf-step", stepping(StripsOptions::pose()), inzsmf_step()));
    benches.push(Bench::new("strips-step/se2", "ukf-step", stepping(StripsOptions::pose()), ukf_step()));
    benches
}

/// A step of the filter, after as many as its memory holds.
fn stepping(options: StripsOptions) -> impl FnMut() + 'static {
    let mut filter = InvariantStrips::new(&PlanarBox::se2(Interval::ENTIRE, [symmetric(25.0); 2]), options)
        .expect("the prior is bounded");
    let step = PlanarIncrement::exponential([TURN_RAD, WAY_M, 0.0].map(Interval::point), [symmetric(1e-3); 3]);
    let mut measured = positions();
    let mut advance = move || {
        let Some(y) = measured.next() else { return };
        filter.predict(black_box(&step)).expect("the step is finite");
        filter.update(&[PlanarMeasurement::position(y, [symmetric(1.0); 2])]).expect("the noises keep their bounds");
    };
    (0..400).for_each(|_| advance());
    advance
}

/// Forty supports of a polytope with 150 rows in a box of 4 dimensions, one after another from the basis of the last.
fn forty_programs() -> impl FnMut() + 'static {
    let mut draw = Draw::new(9);
    let mut rows = BoxedRows::new(&[symmetric(4.0); 4]).expect("the box is bounded");
    for _ in 0..150 {
        rows.push(&draw.normals(4), 1.0 + draw.unit().abs()).expect("the row is finite");
    }
    let directions: Vec<Vec<f64>> = (0..40).map(|_| draw.normals(4)).collect();
    move || {
        for direction in &directions {
            black_box(rows.support(black_box(direction)).expect("the direction is finite"));
        }
    }
}

/// A step of the first-order filter, order 30.
fn inzsmf_step() -> impl FnMut() + 'static {
    let ball =
        |dim: usize, radius: f64| Zonotope::from_box(&vec![0.0; dim], &vec![radius; dim]).expect("a positive radius");
    let mut filter: InZsmf<SE2<f64>, 3, 2, Left> = InZsmf::new(
        SE2::from_pose(std::f64::consts::FRAC_PI_2, 20.0, 0.0),
        &ball(3, 1.0),
        Outputs::position(),
        &ball(3, 1e-3),
        &ball(2, 1.0),
    )
    .and_then(|filter| filter.with_reduction(Reduction::Combastel, 30))
    .expect("the sets have the sizes of the group");
    let (increment, mut measured) = (Vector3::new(TURN_RAD, WAY_M, 0.0), positions());
    move || {
        if let Some(y) = measured.next() {
            filter.step(black_box(&increment), &y).expect("the filter converges");
        }
    }
}

/// A step of the unscented filter on the group.
fn ukf_step() -> impl FnMut() + 'static {
    let start = Gaussian::new(SE2::from_pose(std::f64::consts::FRAC_PI_2, 20.0, 0.0), &Matrix3::identity());
    let (process, noise) = (Matrix3::identity() * 1e-6, Matrix2::identity());
    let mut filter: Ukf<InvariantWheels, OnGroup<SE2<f64>, Left, 2>, 3, 2, 3, 2> =
        start.and_then(|start| Ukf::new(InvariantWheels, start, &process, &noise)).expect("covariances are positive");
    let (step, mut measured) = (WheelStep::new(TURN_RAD, Vector2::new(WAY_M, 0.0)), positions());
    move || {
        if let Some(y) = measured.next() {
            filter.predict(black_box(&step)).expect("the step is finite");
            filter.update(&y).expect("the filter converges");
        }
    }
}

/// Microseconds a step by the mean number of rows kept, for memories of several lengths.
pub fn growth_figure() -> Figure {
    let point = |&bucket: &usize| {
        let options = StripsOptions { bucket, memory: 300, ..StripsOptions::pose() };
        let mut filter = InvariantStrips::new(&PlanarBox::se2(Interval::ENTIRE, [symmetric(25.0); 2]), options)
            .expect("the prior is bounded");
        let step = PlanarIncrement::exponential([TURN_RAD, WAY_M, 0.0].map(Interval::point), [symmetric(1e-3); 3]);
        let (mut begin, mut rows) = (processor_time(), 0.0);
        for (k, y) in positions().take(1000).enumerate() {
            if k == 500 {
                begin = processor_time();
            }
            filter.predict(&step).expect("the step is finite");
            filter
                .update(&[PlanarMeasurement::position(y, [symmetric(1.0); 2])])
                .expect("the noises keep their bounds");
            rows += if k < 500 { 0.0 } else { filter.num_rows() as f64 / 500.0 };
        }
        let us = 1e6 * (processor_time() - begin).as_secs_f64() / 500.0;
        println!("{rows:>6.0} rows {us:>10.1} us a step");
        (rows, us)
    };
    // Buckets of these many instants; 0 keeps every row.
    let points: Vec<(f64, f64)> = [75, 40, 20, 10, 5, 0].iter().map(point).collect();
    let panel = Panel::new("Filter of strips, SE(2)", "rows", "time of a step [us]").log_x().log_y();
    Figure::new("strips-growth", "Time of a step with the number of rows", 1).with(panel.with(Series::points(
        "predict and update",
        Look::nth(0),
        points,
    )))
}

fn symmetric(radius: f64) -> Interval {
    Interval::new(-radius, radius).expect("a positive radius")
}

/// Measured positions on the circle of 20 m radius, one turn again and again, noises below 0.9 m.
fn positions() -> impl Iterator<Item = [f64; 2]> + 'static {
    let mut draw = Draw::new(10);
    let turn: Vec<[f64; 2]> = (1..=1571)
        .map(|k| {
            let (sin, cos) = (TURN_RAD * f64::from(k)).sin_cos();
            [20.0 * cos + draw.symmetric(0.9), 20.0 * sin + draw.symmetric(0.9)]
        })
        .collect();
    (0..).map(move |k| turn[k % turn.len()])
}

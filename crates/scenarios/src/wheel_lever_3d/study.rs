//! Runs of the filters over hills.

use std::f64::consts::PI;

use estimators::kalman::{Chart, Ekf, Gaussian, OnGroup};
use estimators::{Estimator, Left};
use lie_groups::{LieGroup, SO3, TfgScaleLever3};
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};
use rand::Rng;

use super::model::{Imperfect3, N, Parts, Plain3, Space, Spatial, Step};
use crate::noise::standard_normal;
use crate::wheel_lever::setting::{CIRCLE_S, PERIOD_S, RATE_RAD_S, SECONDS, SIGMAS, SPEED_M_S, STEPS_PER_FIX};
use crate::wheel_lever::study::{CLOSE_DEG, ENVELOPE, SETTLED_S};
use crate::{Context, ScenarioError, monte_carlo};

/// Lever arms, m: a short one, and one that shows what the estimate of it does to the error.
pub const LEVERS_M: [[f64; 3]; 2] = [[0.5, 0.0, 0.3], [5.0, 0.0, 1.0]];
/// Standard deviations of the first heading, and of roll and pitch, degrees.
pub const ATTITUDE_DEG: [f64; 2] = [200.0, 5.0];
/// Amplitudes (rad/s) and frequencies (rad/s) of the roll and pitch rates.
pub const HILLS: [(f64, f64); 2] = [(0.15, 0.5), (0.2, 0.7)];
/// First standard deviations of scale, position (m) and lever arm (m).
pub const SPREADS: [f64; 3] = [0.5, 10.0, 20.0];

/// How a run of a filter ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Whether the heading error stayed within its bound from [`SETTLED_S`] on, at every fix.
    pub convergent: bool,
    /// Whether the rotation is right at the end.
    pub close: bool,
    /// Last scale.
    pub scale: f64,
    /// Last errors of position and lever arm, m.
    pub errors: [f64; 2],
    /// Mean normalised estimation error squared from [`SETTLED_S`] on, over its dimension.
    pub nees: f64,
}

/// Runs of all filters with one lever arm.
#[derive(Clone, Debug)]
pub struct Cell {
    /// True lever arm, m.
    pub lever: [f64; 3],
    /// Ends by run, then in the order of [`Method::ALL`](crate::wheel_lever::filters::Method::ALL).
    pub runs: Vec<[End; 3]>,
}

/// A fix, and the true state there.
struct Second {
    steps: [Step; STEPS_PER_FIX],
    truth: Parts,
    fix: Vector3<f64>,
}

fn normal<R: Rng>(rng: &mut R, sd: f64) -> Vector3<f64> {
    Vector3::from_fn(|_, _| sd * standard_normal(rng))
}

/// Runs all filters `runs` times, on the same noises.
///
/// # Errors
/// Those of the filters.
pub fn cell(context: &Context<'_>, lever: [f64; 3], runs: usize) -> Result<Cell, ScenarioError> {
    let runs = monte_carlo::run(context, &format!("wheel-lever-3d/{}", lever[0]), runs, |_, rng| {
        let [yaw, tilt] = ATTITUDE_DEG.map(|degrees: f64| degrees.to_radians() * standard_normal(rng));
        let tilt = SO3::exp(&Vector3::new(tilt, ATTITUDE_DEG[1].to_radians() * standard_normal(rng), 0.0));
        let rotation = SO3::exp(&Vector3::new(0.0, 0.0, yaw)).compose(&tilt);
        let start = Parts { rotation: SO3::identity(), scale: 1.0, position: Vector3::zeros(), lever: lever.into() };
        let guess = Parts { rotation, lever: Vector3::zeros(), ..start };
        let seconds = drive(start, rng);
        let ends = [
            follow::<TfgScaleLever3<f64>>(&guess, &seconds)?,
            follow::<Imperfect3>(&guess, &seconds)?,
            follow::<Plain3>(&guess, &seconds)?,
        ];
        Ok::<_, ScenarioError>(ends)
    })?;
    Ok(Cell { lever, runs })
}

fn drive<R: Rng>(mut truth: Parts, rng: &mut R) -> Vec<Second> {
    let [gyro, wheels, fix_m] = SIGMAS;
    let seconds = (0..SECONDS).map(|second| {
        let steps = std::array::from_fn(|k| {
            let time_s = second as f64 + PERIOD_S * k as f64;
            let [roll, pitch] = HILLS.map(|(amplitude, frequency)| amplitude * (frequency * time_s).cos());
            let yaw = if second < CIRCLE_S { RATE_RAD_S } else { 0.0 };
            let step =
                Step { turn: Vector3::new(roll, pitch, yaw) * PERIOD_S, shift: Vector3::x() * (SPEED_M_S * PERIOD_S) };
            truth = truth.moved(&Step {
                turn: step.turn + normal(rng, gyro * PERIOD_S),
                shift: step.shift + normal(rng, wheels * PERIOD_S),
            });
            step
        });
        Second { steps, truth, fix: truth.antenna() + normal(rng, fix_m) }
    });
    seconds.collect()
}

fn follow<G: Spatial>(guess: &Parts, seconds: &[Second]) -> Result<End, ScenarioError> {
    type Error<G> = OnGroup<G, Left, 3>;
    let [gyro, wheels, fix_m] = SIGMAS;
    let [yaw, tilt] = ATTITUDE_DEG.map(f64::to_radians);
    let mut deviations = SVector::<f64, N>::zeros();
    deviations.fixed_rows_mut::<3>(0).copy_from(&Vector3::new(tilt, tilt, yaw));
    let [scale, position, lever] = G::STARTS;
    deviations[scale] = SPREADS[0];
    deviations.fixed_rows_mut::<3>(position).fill(SPREADS[1]);
    deviations.fixed_rows_mut::<3>(lever).fill(SPREADS[2]);
    let start = Gaussian::<Error<G>, N>::from_root(G::of(guess)?, &SMatrix::from_diagonal(&deviations))?;
    let variances = [gyro, gyro, gyro, wheels, wheels, wheels].map(|sd| (sd * PERIOD_S).powi(2));
    let q = SMatrix::<f64, 6, 6>::from_diagonal(&SVector::from(variances));
    let mut filter: Ekf<_, Error<G>, N, 3, 6, 3> =
        Ekf::new(Space, start, &q, &(Matrix3::identity() * (fix_m * fix_m)))?;
    let (mut convergent, mut nees, mut count) = (true, 0.0, 0.0);
    let mut error = SVector::<f64, N>::zeros();
    for (index, second) in seconds.iter().enumerate() {
        for step in &second.steps {
            filter.predict(step)?;
        }
        filter.update(second.fix.as_slice())?;
        if index + 1 >= SETTLED_S {
            let truth = G::of(&second.truth)?;
            error = Error::<G>::difference(&truth, filter.belief().mean())?;
            convergent &= error[2].abs() <= ENVELOPE * filter.belief().standard_deviations()[2];
            nees += filter.belief().nees(&truth)? / N as f64;
            count += 1.0;
        }
    }
    let estimate = filter.belief().mean().parts();
    let truth = seconds.last().map_or(*guess, |last| last.truth);
    let angle = error.fixed_rows::<3>(0).norm().min(PI);
    Ok(End {
        convergent,
        close: angle <= CLOSE_DEG.to_radians(),
        scale: estimate.scale,
        errors: [(truth.position - estimate.position).norm(), (truth.lever - estimate.lever).norm()],
        nees: nees / count,
    })
}

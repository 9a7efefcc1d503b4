//! The two filters as the numbers of paper 000 imply them: flaws included, for comparison only.
//!
//! The tables of the paper are reproduced by four settings that its text does not state or that contradict it:
//! 1. the box of the order reduction sums the columns **with their signs** (Remark 1 of the paper sums absolute values), so
//!    the reduced set need not contain the set;
//! 2. the initial generators are the identity, also where the initial error lies outside that set;
//! 3. the position box of the invariant filter is taken in the **body** frame, that of the other in the world frame;
//! 4. the invariant filter corrects its centre with the gain of the **previous** step, its set with the current one.
//!
//! Nothing here bounds anything. The filters to use are `estimators::Zsmf` and `estimators::InZsmf`.

use estimators::place;
use nalgebra::{Complex, DMatrix, Matrix2, Matrix2x3, Matrix3, Matrix3x2, Vector2, Vector3};

use crate::inzsmf::cases::POLES;
use crate::inzsmf::study::Contender;
use crate::inzsmf::tracking::Tracker;
use crate::vehicle::{OUTPUT_BOUNDS, PERIOD_S, PROCESS_BOUNDS, Pose, SPEED, TURN_RATE};
use crate::{Mode, ScenarioError};

/// Columns above which the generators are reduced, and to which (the paper's order).
const MAX_COLUMNS: usize = 30;

/// Which error the filter propagates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coordinates {
    /// `x - xhat` in the world frame (ZSMF).
    Euclidean,
    /// `log(Xhat^-1 X)` in the body frame (left InZSMF).
    LeftInvariant,
}

/// The observer gain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PublishedGain {
    /// Algorithm 2: minimises the F-radius of the next set.
    FRadius,
    /// Algorithm 1: a gain of the body-frame error dynamics; the Euclidean filter uses `blkdiag(1, R) L R^T`, which places the
    /// same poles because its error dynamics is that of heading 0 turned by `R`.
    Poles(Matrix3x2<f64>),
}

/// The axes of the position box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoxFrame {
    /// Those of the filter's coordinates (flaw 3).
    Own,
    /// Those of the world.
    World,
}

/// What the text of the paper leaves open or contradicts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// ZSMF or InZSMF.
    pub coordinates: Coordinates,
    /// Algorithm 1 or 2.
    pub gain: PublishedGain,
    /// Whether the centre is corrected with the gain of the previous step (flaw 4).
    pub lagging_gain: bool,
    /// The axes of the position box.
    pub frame: BoxFrame,
}

impl Settings {
    /// The filter as the paper's numbers imply it: the invariant one lags, boxes in the filter's own axes.
    #[must_use]
    pub fn of_the_tables(coordinates: Coordinates, gain: PublishedGain) -> Self {
        Self { coordinates, gain, lagging_gain: coordinates == Coordinates::LeftInvariant, frame: BoxFrame::Own }
    }
}

/// One of the two filters, as published.
#[derive(Clone, Debug)]
pub struct PublishedFilter {
    settings: Settings,
    heading_rad: f64,
    position: Vector2<f64>,
    columns: Vec<Vector3<f64>>,
    previous_gain: Option<Matrix3x2<f64>>,
}

impl PublishedFilter {
    /// The filter at an initial estimate, with `H_0 = diag(radii)`.
    #[must_use]
    pub fn new(settings: Settings, initial: Pose, radii: [f64; 3]) -> Self {
        Self {
            settings,
            heading_rad: initial.heading_rad,
            position: Vector2::from(initial.position),
            columns: (0..3).map(|axis| Vector3::ith(axis, radii[axis])).collect(),
            previous_gain: None,
        }
    }

    /// The filter's coordinates.
    #[must_use]
    pub fn coordinates(&self) -> Coordinates {
        self.settings.coordinates
    }

    /// The generators, one a column, in the filter's coordinates.
    #[must_use]
    pub fn columns(&self) -> &[Vector3<f64>] {
        &self.columns
    }

    /// `A_k` of (16), at the heading estimate.
    fn euclidean_dynamics(&self) -> Matrix3<f64> {
        let (sin, cos) = self.heading_rad.sin_cos();
        let advance = SPEED * PERIOD_S;
        Matrix3::new(1.0, 0.0, 0.0, -sin * advance, 1.0, 0.0, cos * advance, 0.0, 1.0)
    }

    /// `L = A P C^T (C P C^T + Q_v)^-1` of (12), with the reduced generators.
    fn f_radius_gain(&self, a: &Matrix3<f64>, c: &Matrix2x3<f64>, output_generators: &Matrix2<f64>) -> Matrix3x2<f64> {
        let p: Matrix3<f64> = self.columns.iter().map(|column| column * column.transpose()).sum();
        let s = c * p * c.transpose() + output_generators * output_generators.transpose();
        // s is at least H_v H_v^T = I: invertible.
        s.try_inverse().map_or_else(Matrix3x2::zeros, |inverse| a * p * c.transpose() * inverse)
    }

    /// The prediction of the centre and its correction: (14) plus the correction, or (18) times its exponential.
    fn move_center(&mut self, rotation: &Matrix2<f64>, correction: &Vector3<f64>) {
        match self.settings.coordinates {
            Coordinates::Euclidean => {
                self.position += rotation * Vector2::new(SPEED * PERIOD_S, 0.0) + correction.fixed_rows::<2>(1);
                self.heading_rad += TURN_RATE * PERIOD_S + correction[0];
            }
            Coordinates::LeftInvariant => {
                self.move_by(&Vector3::new(TURN_RATE * PERIOD_S, SPEED * PERIOD_S, 0.0));
                self.move_by(correction);
            }
        }
    }

    /// `X exp(xi)`.
    fn move_by(&mut self, xi: &Vector3<f64>) {
        let (sin, cos) = xi[0].sin_cos();
        let (s, t) = if xi[0].abs() < 1e-5 { (1.0, 0.5 * xi[0]) } else { (sin / xi[0], (1.0 - cos) / xi[0]) };
        self.position += rotation(self.heading_rad) * Matrix2::new(s, -t, t, s) * xi.fixed_rows::<2>(1);
        self.heading_rad += xi[0];
    }
}

impl Tracker for PublishedFilter {
    /// One step of Algorithm 1 or 2.
    fn step(&mut self, output: [f64; 2]) -> Result<(), ScenarioError> {
        reduce_with_signs(&mut self.columns, MAX_COLUMNS);
        let rotation = rotation(self.heading_rad);
        let c = output_matrix();
        // The error dynamics: A, the frame of the process noise, and that of the measurement noise.
        let (a, process_frame, output_frame) = match self.settings.coordinates {
            Coordinates::Euclidean => (self.euclidean_dynamics(), turned(&rotation), Matrix2::identity()),
            Coordinates::LeftInvariant => (body_dynamics(), Matrix3::identity(), rotation.transpose()),
        };
        let output_generators = output_frame * Matrix2::from_diagonal(&Vector2::from(OUTPUT_BOUNDS));
        let gain = match self.settings.gain {
            PublishedGain::FRadius => self.f_radius_gain(&a, &c, &output_generators),
            PublishedGain::Poles(gain) if self.settings.coordinates == Coordinates::LeftInvariant => gain,
            PublishedGain::Poles(gain) => turned(&rotation) * gain * rotation.transpose(),
        };
        let applied = if self.settings.lagging_gain { self.previous_gain.unwrap_or(gain) } else { gain };
        let correction = applied * (output_frame * (Vector2::from(output) - self.position));
        self.move_center(&rotation, &correction);
        self.previous_gain = Some(gain);

        let closed_loop = a - gain * c;
        self.columns.iter_mut().for_each(|column| *column = closed_loop * *column);
        let process = PERIOD_S * process_frame * Matrix3::from_diagonal(&Vector3::from(PROCESS_BOUNDS));
        self.columns.extend(process.column_iter().map(Vector3::from));
        self.columns.extend((-gain * output_generators).column_iter().map(Vector3::from));
        Ok(())
    }

    fn center(&self) -> Pose {
        Pose { heading_rad: self.heading_rad, position: self.position.into() }
    }

    fn widths(&self) -> [f64; 3] {
        let frame = match self.settings.frame {
            BoxFrame::World if self.settings.coordinates == Coordinates::LeftInvariant => {
                turned(&rotation(self.heading_rad))
            }
            _ => Matrix3::identity(),
        };
        (2.0 * self.columns.iter().fold(Vector3::zeros(), |sum, column| sum + (frame * column).abs())).into()
    }
}

/// The filters of Tables I and II, and InZSMF with the gain of the current step and with the box in the world frame.
///
/// # Errors
/// [`ScenarioError::Estimator`] if the poles cannot be placed.
pub fn contenders() -> Result<Vec<Contender>, ScenarioError> {
    let f_radius = |coordinates| Settings::of_the_tables(coordinates, PublishedGain::FRadius);
    let zsmf_pole = Settings::of_the_tables(Coordinates::Euclidean, poles(Coordinates::Euclidean)?);
    let inzsmf_pole = Settings::of_the_tables(Coordinates::LeftInvariant, poles(Coordinates::LeftInvariant)?);
    let (zsmf, inzsmf) = (f_radius(Coordinates::Euclidean), f_radius(Coordinates::LeftInvariant));
    let all = [
        ("zsmf", zsmf),
        ("inzsmf", inzsmf),
        ("inzsmf/current-gain", Settings { lagging_gain: false, ..inzsmf }),
        ("inzsmf/world-box", Settings { frame: BoxFrame::World, ..inzsmf }),
        ("zsmf/pole", zsmf_pole),
        ("inzsmf/pole", inzsmf_pole),
        ("inzsmf/pole-world-box", Settings { frame: BoxFrame::World, ..inzsmf_pole }),
    ];
    let contender = |(method, settings): (&str, Settings)| {
        Contender::new(method, Mode::Published, move |initial| {
            Ok(Box::new(PublishedFilter::new(settings, initial, [1.0; 3])))
        })
    };
    Ok(all.map(contender).into())
}

/// The gain that places the poles of Table II.
fn poles(coordinates: Coordinates) -> Result<PublishedGain, ScenarioError> {
    let mut a = body_dynamics();
    if coordinates == Coordinates::Euclidean {
        // (16) at heading 0: the frame does not turn.
        a.fixed_view_mut::<2, 2>(1, 1).fill_with_identity();
    }
    Ok(PublishedGain::Poles(placed(&a)?))
}

/// The gain that gives `A - L C` the poles of Table II.
fn placed(a: &Matrix3<f64>) -> Result<Matrix3x2<f64>, ScenarioError> {
    let c = output_matrix();
    let a = DMatrix::from_column_slice(3, 3, a.as_slice());
    let c = DMatrix::from_column_slice(2, 3, c.as_slice());
    let gain = place(&a, &c, &POLES.map(|re| Complex::new(re, 0.0)))?;
    Ok(Matrix3x2::from_fn(|i, j| gain[(i, j)]))
}

/// `C` of (16) and `C^L` of (20).
fn output_matrix() -> Matrix2x3<f64> {
    Matrix2x3::new(0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
}

/// `A^L = I - delta ad_u` of (20): first order in the period.
fn body_dynamics() -> Matrix3<f64> {
    let (turn, advance) = (TURN_RATE * PERIOD_S, SPEED * PERIOD_S);
    Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, turn, advance, -turn, 1.0)
}

/// `R(heading)`.
fn rotation(heading_rad: f64) -> Matrix2<f64> {
    let (sin, cos) = heading_rad.sin_cos();
    Matrix2::new(cos, -sin, sin, cos)
}

/// `blkdiag(1, R)`.
fn turned(rotation: &Matrix2<f64>) -> Matrix3<f64> {
    let mut turned = Matrix3::identity();
    turned.fixed_view_mut::<2, 2>(1, 1).copy_from(rotation);
    turned
}

/// Flaw 1: keeps the `max - 3` longest columns and replaces the others by the diagonal of their **signed** sum.
fn reduce_with_signs(columns: &mut Vec<Vector3<f64>>, max: usize) {
    if columns.len() <= max {
        return;
    }
    columns.sort_by(|left, right| right.norm_squared().total_cmp(&left.norm_squared()));
    let sum: Vector3<f64> = columns.drain(max - 3..).sum();
    columns.extend((0..3).map(|axis| Vector3::ith(axis, sum[axis])));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The flaw, shown: opposite columns cancel, and the reduced set has lost the length of both.
    #[test]
    fn signed_sums_lose_what_cancels() {
        let mut columns = vec![Vector3::new(1.0, 0.0, 0.0); 27];
        columns.extend((0..10).map(|j| Vector3::new(0.0, 0.0, if j % 2 == 0 { 0.5 } else { -0.5 })));
        let width = |columns: &[Vector3<f64>]| columns.iter().map(|column| column[2].abs()).sum::<f64>();
        assert_eq!(width(&columns), 5.0);
        reduce_with_signs(&mut columns, MAX_COLUMNS);
        assert_eq!((columns.len(), width(&columns)), (MAX_COLUMNS, 0.0));
        // Up to the limit nothing is touched.
        let before = columns.clone();
        reduce_with_signs(&mut columns, MAX_COLUMNS);
        assert_eq!(columns, before);
    }

    /// Both placed gains of the tables give the poles, at any heading.
    #[test]
    fn placed_gains_place_the_poles_at_any_heading() {
        let PublishedGain::Poles(gain) = poles(Coordinates::Euclidean).unwrap() else { panic!("no gain") };
        for heading in [0.0, 0.7, 2.0, -3.0] {
            let frame = rotation(heading);
            let (sin, cos) = f64::sin_cos(heading);
            let advance = SPEED * PERIOD_S;
            let a = Matrix3::new(1.0, 0.0, 0.0, -sin * advance, 1.0, 0.0, cos * advance, 0.0, 1.0);
            let closed = a - turned(&frame) * gain * frame.transpose() * output_matrix();
            let sum: f64 = POLES.iter().sum();
            let product: f64 = POLES.iter().product();
            assert!((closed.trace() - sum).abs() < 1e-12 && (closed.determinant() - product).abs() < 1e-12);
        }
    }
}

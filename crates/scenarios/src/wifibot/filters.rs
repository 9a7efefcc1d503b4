//! The library's filters on the robot: ZSMF in the world, InZSMF on SE(2).

use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

use estimators::{Estimator, InZsmf, Left, Model, Outputs, Zsmf};
use lie_groups::{Enclose, SE2};
use nalgebra::{Matrix2x3, Matrix3, Vector2, Vector3};
use scalars::Interval;
use setrep::{Reduction, Zonotope};

use crate::ScenarioError;
use crate::inzsmf::errors::{Error, euclidean_errors, invariant_errors};
use crate::vehicle::{Pose, TruePose};
use crate::wifibot::odometry::{Window, element};

/// Bound on each coordinate of a position fix, m.
pub const FIX_BOUND_M: f64 = 0.1;
/// Order reduction of both filters: a valid one, with few generators more than the paper's.
pub const REDUCTION: (Reduction, usize) = (Reduction::Girard, 60);

/// A filter of the robot.
pub trait Follower {
    /// Moves the set over a window of odometry.
    ///
    /// # Errors
    /// Those of the filter.
    fn predict(&mut self, window: &Window) -> Result<(), ScenarioError>;

    /// Corrects the set by a position fix.
    ///
    /// # Errors
    /// Those of the filter.
    fn correct(&mut self, fix: [f64; 2]) -> Result<(), ScenarioError>;

    /// The estimate.
    fn center(&self) -> Pose;

    /// Widths of the box of the set, (heading, x1, x2): rad, m, m. Superset of all states of the set.
    ///
    /// # Errors
    /// Those of the set.
    fn widths(&self) -> Result<[f64; 3], ScenarioError>;

    /// The set of errors around zero, in the filter's coordinates.
    ///
    /// # Errors
    /// Those of the set.
    fn error_set(&self) -> Result<Zonotope, ScenarioError>;

    /// All errors that stand for the truth: one a full turn within reach.
    ///
    /// # Errors
    /// Those of the logarithm.
    fn errors(&self, truth: &TruePose, reach_rad: f64) -> Result<Vec<Error>, ScenarioError>;
}

/// The filters of the experiment. Each starts at the first fix with a guessed heading and a set that holds every heading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// ZSMF on `(theta, x1, x2)`.
    Zsmf,
    /// Left InZSMF as published.
    InZsmf,
    /// Left InZSMF whose set moves to the coordinates of the corrected estimate.
    InZsmfTransport,
}

impl Method {
    /// All, in the order of the tables.
    pub const ALL: [Self; 3] = [Self::Zsmf, Self::InZsmf, Self::InZsmfTransport];

    /// The name in the rows.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Zsmf => "zsmf",
            Self::InZsmf => "inzsmf",
            Self::InZsmfTransport => "inzsmf/transport",
        }
    }

    /// The filter at `guess`, whose position is a fix; `bounds` are those of the errors of the increments.
    ///
    /// # Errors
    /// Those of the sets and filters.
    pub fn start(self, guess: &Pose, bounds: [f64; 3]) -> Result<Box<dyn Follower>, ScenarioError> {
        let odometry = Zonotope::from_box(&[0.0; 3], &bounds)?;
        let fix = Zonotope::from_box(&[0.0; 2], &[FIX_BOUND_M; 2])?;
        let (reduction, order) = REDUCTION;
        Ok(match self {
            Self::Zsmf => {
                let center = [guess.heading_rad, guess.position[0], guess.position[1]];
                // A radius of pi, rounded up, holds every heading.
                let first = Zonotope::from_box(&center, &[PI.next_up(), FIX_BOUND_M, FIX_BOUND_M])?;
                Box::new(Euclidean(Zsmf::new(Robot, &first, &odometry, &fix)?.with_reduction(reduction, order)?))
            }
            Self::InZsmf | Self::InZsmfTransport => {
                // eps_x = V(theta)^-1 R' e with |V(theta)^-1| <= pi / 2 for |theta| <= pi and |e| <= sqrt 2 times the bound.
                let reach = 1.001 * FRAC_PI_2 * SQRT_2 * FIX_BOUND_M;
                let first = Zonotope::from_box(&[0.0; 3], &[PI.next_up(), reach, reach])?;
                let filter = InZsmf::new(element(guess), &first, Outputs::position(), &odometry, &fix)?;
                let transport = self == Self::InZsmfTransport;
                Box::new(Invariant(filter.with_reduction(reduction, order)?.with_transport(transport)))
            }
        })
    }
}

/// The robot in the world: `theta+ = theta + turn + w_1`, `x+ = x + R(theta) shift + R(theta + turn) (w_2, w_3)`.
#[derive(Clone, Copy, Debug)]
struct Robot;

impl Model<3, 2, 3> for Robot {
    type Input = [f64; 3];

    fn transition(&self, x: &Vector3<f64>, [turn, forward, left]: &[f64; 3]) -> Vector3<f64> {
        let (sin, cos) = x[0].sin_cos();
        x + Vector3::new(*turn, cos * forward - sin * left, sin * forward + cos * left)
    }

    fn transition_jacobian(&self, x: &Vector3<f64>, [_, forward, left]: &[f64; 3]) -> Matrix3<f64> {
        let (sin, cos) = x[0].sin_cos();
        let (d1, d2) = (-sin * forward - cos * left, cos * forward - sin * left);
        Matrix3::new(1.0, 0.0, 0.0, d1, 1.0, 0.0, d2, 0.0, 1.0)
    }

    fn noise_jacobian(&self, x: &Vector3<f64>, [turn, ..]: &[f64; 3]) -> Matrix3<f64> {
        let (sin, cos) = (x[0] + turn).sin_cos();
        Matrix3::new(1.0, 0.0, 0.0, 0.0, cos, -sin, 0.0, sin, cos)
    }

    fn output(&self, x: &Vector3<f64>) -> Vector2<f64> {
        Vector2::new(x[1], x[2])
    }

    fn output_jacobian(&self, _: &Vector3<f64>) -> Matrix2x3<f64> {
        Matrix2x3::new(0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
    }
}

struct Euclidean(Zsmf<Robot, 3, 2, 3>);

impl Follower for Euclidean {
    fn predict(&mut self, window: &Window) -> Result<(), ScenarioError> {
        Ok(self.0.predict(&window.motion)?)
    }

    fn correct(&mut self, fix: [f64; 2]) -> Result<(), ScenarioError> {
        Ok(self.0.update(&fix)?)
    }

    fn center(&self) -> Pose {
        let x = self.0.estimate();
        Pose { heading_rad: x[0], position: [x[1], x[2]] }
    }

    fn widths(&self) -> Result<[f64; 3], ScenarioError> {
        let mut hull = [Interval::ZERO; 3];
        self.0.enclosure().interval_hull_into(&mut hull)?;
        Ok(hull.map(|side| side.width()))
    }

    fn error_set(&self) -> Result<Zonotope, ScenarioError> {
        let mut set = self.0.enclosure().clone();
        set.translate((-self.0.estimate()).as_slice())?;
        Ok(set)
    }

    fn errors(&self, truth: &TruePose, reach_rad: f64) -> Result<Vec<Error>, ScenarioError> {
        Ok(euclidean_errors(truth, &self.center(), reach_rad))
    }
}

struct Invariant(InZsmf<SE2<f64>, 3, 2, Left, 2>);

impl Follower for Invariant {
    fn predict(&mut self, window: &Window) -> Result<(), ScenarioError> {
        Ok(self.0.predict(&window.increment)?)
    }

    fn correct(&mut self, fix: [f64; 2]) -> Result<(), ScenarioError> {
        Ok(self.0.update(&fix)?)
    }

    fn center(&self) -> Pose {
        let unit = self.0.estimate().rotation().unit();
        Pose { heading_rad: unit.im.atan2(unit.re), position: self.0.estimate().translation().into() }
    }

    fn widths(&self) -> Result<[f64; 3], ScenarioError> {
        let mut hull = [Interval::ZERO; 3];
        self.0.tangent_set().interval_hull_into(&mut hull)?;
        let [x1, x2] = self.0.world_hull(&Vector2::zeros())?;
        Ok([hull[0].width(), x1.width(), x2.width()])
    }

    fn error_set(&self) -> Result<Zonotope, ScenarioError> {
        Ok(self.0.tangent_set().clone())
    }

    fn errors(&self, truth: &TruePose, reach_rad: f64) -> Result<Vec<Error>, ScenarioError> {
        invariant_errors(truth, &self.0.estimate().enclose(), reach_rad)
    }
}

#[cfg(test)]
mod tests {
    use lie_groups::LieGroup;

    use super::*;

    fn window() -> Window {
        let motion = SE2::from_pose(0.4, 0.5, -0.1);
        Window {
            motion: [0.4, 0.5, -0.1],
            increment: motion.log().unwrap(),
            error: Vector3::zeros(),
            end: Pose { heading_rad: 0.0, position: [0.0; 2] },
        }
    }

    /// Both filters predict the same pose.
    #[test]
    fn predictions_agree() {
        let guess = Pose { heading_rad: 1.0, position: [3.0, -2.0] };
        let centers = Method::ALL.map(|method| {
            let mut filter = method.start(&guess, [0.01; 3]).unwrap();
            filter.predict(&window()).unwrap();
            filter.center()
        });
        for center in centers {
            assert!((center.heading_rad - 1.4).abs() < 1e-14);
            assert!((center.position[0] - centers[0].position[0]).abs() < 1e-14);
            assert!((center.position[1] - centers[0].position[1]).abs() < 1e-14);
        }
    }

    /// The derivatives against central differences.
    #[test]
    fn jacobians_are_derivatives() {
        let (x, u, h) = (Vector3::new(0.7, 1.0, 2.0), [0.3, 0.8, -0.2], 1e-6);
        for column in 0..3 {
            let mut step = Vector3::zeros();
            step[column] = h;
            let slope = (Robot.transition(&(x + step), &u) - Robot.transition(&(x - step), &u)) / (2.0 * h);
            assert!((slope - Robot.transition_jacobian(&x, &u).column(column)).norm() < 1e-9);
            let exact = |sign: f64| {
                let end = SE2::from_pose(x[0], x[1], x[2]).compose(&SE2::from_pose(u[0], u[1], u[2]));
                end.compose(&SE2::exp(&(sign * step))).translation()
            };
            let slope = (exact(1.0) - exact(-1.0)) / (2.0 * h);
            let jacobian = Robot.noise_jacobian(&x, &u);
            assert!((slope - jacobian.fixed_view::<2, 1>(1, column)).norm() < 1e-9);
        }
    }

    /// The first sets hold every heading, and every position that the first fix allows.
    #[test]
    fn first_sets_hold_the_truth() {
        for (heading, corner) in [(3.1, [1.0, 1.0]), (-3.1, [-1.0, 1.0]), (2.0, [1.0, -1.0]), (0.0, [-1.0, -1.0])] {
            let guess = Pose { heading_rad: 0.3, position: [1.0, 1.0] };
            let truth = Pose { heading_rad: 0.3 + heading, position: corner.map(|sign| 1.0 + sign * FIX_BOUND_M) };
            for method in Method::ALL {
                let filter = method.start(&guess, [0.01; 3]).unwrap();
                let set = filter.error_set().unwrap();
                let errors = filter.errors(&TruePose::new(truth), 0.0).unwrap();
                let hull = set.interval_hull();
                let inside = (0..3).all(|k| hull[k].inflate(1e-12).contains(errors[0][k].mid()));
                assert!(inside, "{} {heading} {errors:?}", method.name());
            }
        }
    }
}

//! What the test binaries share: random numbers, the models, the paper's vehicle.
#![allow(dead_code, unreachable_pub, reason = "each test binary uses a part")]

use estimators::{InZsmf, Left, Model, Outputs, Zsmf};
use lie_groups::{LieGroup, SE2};
use nalgebra::{Matrix3, SMatrix, SVector, Vector2, Vector3};
use setrep::{Reduction, Zonotope};

/// All order reductions.
pub const REDUCTIONS: [Reduction; 4] = [Reduction::Combastel, Reduction::Girard, Reduction::Pca, Reduction::Method4];

/// The number of cases, times `ORBITOPE_CASES` if it is set.
pub fn cases(default: usize) -> usize {
    let factor = std::env::var("ORBITOPE_CASES").ok().and_then(|text| text.parse().ok()).unwrap_or(1);
    default * factor
}

/// A small generator of random numbers with a printed seed.
#[derive(Clone)]
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        println!("seed {seed}");
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        // splitmix64
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in `[-1, 1)`.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / 2f64.powi(52) - 1.0
    }

    /// Uniform below `n`.
    pub fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// `+1` or `-1`.
    pub fn sign(&mut self) -> f64 {
        if self.bits() & 1 == 0 { 1.0 } else { -1.0 }
    }

    pub fn matrix<const R: usize, const C: usize>(&mut self) -> SMatrix<f64, R, C> {
        SMatrix::from_fn(|_, _| self.unit())
    }
}

/// A time-invariant linear model: `x+ = A x + u + D w`, `y = C x + v`.
#[derive(Debug, Clone)]
pub struct Linear<const N: usize, const M: usize, const W: usize> {
    pub a: SMatrix<f64, N, N>,
    pub c: SMatrix<f64, M, N>,
    pub d: SMatrix<f64, N, W>,
}

impl<const N: usize, const M: usize, const W: usize> Model<N, M, W> for Linear<N, M, W> {
    type Input = SVector<f64, N>;
    fn transition(&self, x: &SVector<f64, N>, u: &SVector<f64, N>) -> SVector<f64, N> {
        self.a * x + u
    }
    fn transition_jacobian(&self, _: &SVector<f64, N>, _: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        self.a
    }
    fn noise_jacobian(&self, _: &SVector<f64, N>, _: &SVector<f64, N>) -> SMatrix<f64, N, W> {
        self.d
    }
    fn output(&self, x: &SVector<f64, N>) -> SVector<f64, M> {
        self.c * x
    }
    fn output_jacobian(&self, _: &SVector<f64, N>) -> SMatrix<f64, M, N> {
        self.c
    }
}

/// The vehicle of paper 000 (14)-(16) in Euclidean coordinates.
#[derive(Debug, Clone)]
pub struct Vehicle;

/// Sampling period, turn rate and speed of the paper.
pub const DT_S: f64 = 0.01;
pub const TURN_RATE: f64 = 0.4;
pub const SPEED: f64 = 8.0;

impl Model<3, 2, 3> for Vehicle {
    type Input = ();
    fn transition(&self, x: &Vector3<f64>, (): &()) -> Vector3<f64> {
        let (sin, cos) = x[0].sin_cos();
        x + Vector3::new(TURN_RATE, SPEED * cos, SPEED * sin) * DT_S
    }
    fn transition_jacobian(&self, x: &Vector3<f64>, (): &()) -> Matrix3<f64> {
        let (sin, cos) = x[0].sin_cos();
        let reach = SPEED * DT_S;
        Matrix3::new(1.0, 0.0, 0.0, -reach * sin, 1.0, 0.0, reach * cos, 0.0, 1.0)
    }
    fn noise_jacobian(&self, x: &Vector3<f64>, (): &()) -> Matrix3<f64> {
        let (sin, cos) = x[0].sin_cos();
        Matrix3::new(1.0, 0.0, 0.0, 0.0, cos, -sin, 0.0, sin, cos) * DT_S
    }
    fn output(&self, x: &Vector3<f64>) -> Vector2<f64> {
        Vector2::new(x[1], x[2])
    }
    fn output_jacobian(&self, _: &Vector3<f64>) -> SMatrix<f64, 2, 3> {
        SMatrix::<f64, 2, 3>::new(0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
    }
}

/// The tangent increment of the vehicle over a step.
pub fn increment() -> Vector3<f64> {
    Vector3::new(TURN_RATE, SPEED, 0.0) * DT_S
}

/// A box around 0.
pub fn boxed(radii: &[f64]) -> Zonotope {
    Zonotope::from_box(&vec![0.0; radii.len()], radii).unwrap()
}

/// The paper's InZSMF, order 30, started at a pose with the given box of errors.
pub fn vehicle_inzsmf(pose: [f64; 3], radii: [f64; 3]) -> InZsmf<SE2<f64>, 3, 2, Left> {
    let start = SE2::from_pose(pose[0], pose[1], pose[2]);
    InZsmf::new(start, &boxed(&radii), Outputs::position(), &boxed(&[1e-3; 3]), &boxed(&[1.0; 2]))
        .unwrap()
        .with_reduction(Reduction::Combastel, 30)
        .unwrap()
}

/// The paper's ZSMF, order 30, started at a pose with the given box of errors.
pub fn vehicle_zsmf(pose: [f64; 3], radii: [f64; 3]) -> Zsmf<Vehicle, 3, 2, 3> {
    let start = Zonotope::from_box(&pose, &radii).unwrap();
    Zsmf::new(Vehicle, &start, &boxed(&[0.1; 3]), &boxed(&[1.0; 2]))
        .unwrap()
        .with_reduction(Reduction::Combastel, 30)
        .unwrap()
}

/// A true vehicle, one step of (18) at a time.
pub struct Truth {
    pub pose: SE2<f64>,
    random: Random,
}

impl Truth {
    /// At the paper's initial state.
    pub fn new(seed: u64) -> Self {
        Self { pose: SE2::from_pose(std::f64::consts::FRAC_PI_2, 0.0, 0.0), random: Random::new(seed) }
    }

    /// A position measured with uniform noise in `[-1, 1]^2`.
    pub fn measure(&mut self) -> Vector2<f64> {
        self.pose.translation() + self.random.matrix::<2, 1>()
    }

    /// Moves by a step with uniform noise.
    pub fn advance(&mut self) {
        let noise = self.random.matrix::<3, 1>() * (0.1 * DT_S);
        self.pose = self.pose.compose(&SE2::exp(&increment())).compose(&SE2::exp(&noise));
    }
}

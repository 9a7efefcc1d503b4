//! [`ByFunction`]: a model of `R^N` written once over every number type, the same that the set-valued filters take.

use nalgebra::{SMatrix, SVector};
use nonlin_bounds::{Dual, Function};
use scalars::Scalar;

use super::chart::Flat;
use super::model::{Motion, Sensor, SmoothMotion, SmoothSensor};
use crate::EstimatorError;
use crate::error::{check_finite, check_size};

/// Most variables, parameters or outputs of a function that a filter evaluates without allocating.
const MOST: usize = 64;
/// Variables of one pass of derivatives.
const PASS: usize = 8;

/// A [`Function`] as a motion `x+ = f((x, w), (u, p))` or as a sensor `y = h((x, v), p)`; derivatives by dual numbers.
///
/// Variables are the states, then the noises; parameters the input of the step (a sensor has none), then those that are `fixed`.
///
/// ```
/// use estimators::kalman::{ByFunction, Ekf, Flat, Gaussian};
/// use estimators::Estimator;
/// use nalgebra::{Matrix1, Matrix2, Vector2};
/// use nonlin_bounds::{Rk4, function};
///
/// // A pendulum with a noise on its rate, by Runge-Kutta steps of 10 ms; its angle is measured.
/// let pendulum = function!(|[angle, rate, w]: 3| -> 2 { [rate, -angle.sin() * S::decimal("9.81") + w] });
/// let motion = ByFunction::new(Rk4::new(pendulum)?).with_fixed(&[0.01]);
/// let sensor = ByFunction::new(function!(|[angle, _rate, v]: 3| -> 1 { [angle + v] }));
/// let start = Gaussian::new(Vector2::new(0.0, 0.0), &Matrix2::identity())?;
/// let mut filter: Ekf<_, Flat, 2, 1, 1, 1> = Ekf::new((motion, sensor), start, &Matrix1::new(1e-4), &Matrix1::new(1e-2))?;
/// filter.update(&[0.3])?;
/// filter.predict(&[])?;
/// assert!((filter.belief().mean()[0] - 0.3).abs() < 0.01);
/// # Ok::<(), estimators::EstimatorError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ByFunction<F> {
    function: F,
    fixed: Vec<f64>,
}

impl<F: Function> ByFunction<F> {
    /// The model without fixed parameters.
    pub fn new(function: F) -> Self {
        Self { function, fixed: Vec::new() }
    }

    /// The same with fixed parameters, the last ones of the function.
    #[must_use]
    pub fn with_fixed(mut self, fixed: &[f64]) -> Self {
        self.fixed = fixed.to_vec();
        self
    }

    /// The function.
    pub fn function(&self) -> &F {
        &self.function
    }

    /// `f((x, w), (u, p))` over any scalar; sizes were checked.
    fn eval<S: Scalar>(&self, variables: usize, fill: impl FnOnce(&mut [S]), u: &[f64], y: &mut [S]) {
        let (mut x, mut p) = ([S::zero(); MOST], [S::zero(); MOST]);
        fill(&mut x[..variables]);
        for (slot, &value) in p.iter_mut().zip(u.iter().chain(&self.fixed)) {
            *slot = S::from_f64(value);
        }
        self.function.eval(&x[..variables], &p[..u.len() + self.fixed.len()], y);
    }

    /// The value at a point and noises.
    fn value<const N: usize, const W: usize, const M: usize>(
        &self,
        x: &SVector<f64, N>,
        w: &SVector<f64, W>,
        u: &[f64],
    ) -> SVector<f64, M> {
        let mut y = SVector::<f64, M>::zeros();
        let stack = |slots: &mut [f64]| {
            slots[..N].copy_from_slice(x.as_slice());
            slots[N..].copy_from_slice(w.as_slice());
        };
        self.eval(N + W, stack, u, y.as_mut_slice());
        y
    }

    /// The derivatives by states and noises at a point and noises 0, eight variables a pass.
    fn jacobians<const N: usize, const W: usize, const M: usize>(
        &self,
        x: &SVector<f64, N>,
        u: &[f64],
    ) -> (SMatrix<f64, M, N>, SMatrix<f64, M, W>) {
        let (mut by_states, mut by_noises) = (SMatrix::zeros(), SMatrix::zeros());
        for start in (0..N + W).step_by(PASS) {
            let mut y = [Dual::<f64, PASS>::constant(0.0); M];
            let seed = |slots: &mut [Dual<f64, PASS>]| {
                for (k, slot) in slots.iter_mut().enumerate() {
                    let value = if k < N { x[k] } else { 0.0 };
                    // One that is not of this pass is a constant.
                    *slot = Dual::variable(value, k.wrapping_sub(start));
                }
            };
            self.eval(N + W, seed, u, &mut y);
            for (i, y) in y.iter().enumerate() {
                for (k, &derivative) in (start..N + W).zip(y.gradient()) {
                    if k < N {
                        by_states[(i, k)] = derivative;
                    } else {
                        by_noises[(i, k - N)] = derivative;
                    }
                }
            }
        }
        (by_states, by_noises)
    }

    /// `Ok` if the function has these sizes and they fit on the stack.
    fn check_sizes(&self, names: [&'static str; 2], variables: usize, outputs: usize) -> Result<(), EstimatorError> {
        check_size(names[0], self.function.variables(), variables)?;
        check_size(names[1], self.function.outputs(), outputs)?;
        let largest = variables.max(outputs).max(self.function.parameters());
        if largest > MOST {
            return Err(EstimatorError::Size { what: "function of the model", expected: MOST, found: largest });
        }
        check_finite("fixed parameters", &self.fixed)
    }
}

impl<F: Function, const N: usize, const W: usize> Motion<Flat, N, W> for ByFunction<F> {
    /// The parameters of the function that are not fixed.
    type Input = [f64];

    fn transition(&self, x: &SVector<f64, N>, u: &[f64], w: &SVector<f64, W>) -> SVector<f64, N> {
        self.value(x, w, u)
    }

    fn check(&self) -> Result<(), EstimatorError> {
        self.check_sizes(["variables of the motion", "outputs of the motion"], N + W, N)
    }

    fn check_input(&self, u: &[f64]) -> Result<(), EstimatorError> {
        check_size("input", self.function.parameters().saturating_sub(self.fixed.len()), u.len())?;
        check_size("parameters of the motion", self.function.parameters(), u.len() + self.fixed.len())?;
        check_finite("input", u)
    }
}

impl<F: Function, const N: usize, const W: usize> SmoothMotion<Flat, N, W> for ByFunction<F> {
    fn motion_jacobians(&self, x: &SVector<f64, N>, u: &[f64]) -> (SMatrix<f64, N, N>, SMatrix<f64, N, W>) {
        self.jacobians(x, u)
    }
}

impl<F: Function, const N: usize, const M: usize, const V: usize> Sensor<Flat, N, M, V> for ByFunction<F> {
    fn output(&self, x: &SVector<f64, N>, v: &SVector<f64, V>) -> SVector<f64, M> {
        self.value(x, v, &[])
    }

    fn check(&self) -> Result<(), EstimatorError> {
        check_size("parameters of the sensor", self.function.parameters(), self.fixed.len())?;
        self.check_sizes(["variables of the sensor", "outputs of the sensor"], N + V, M)
    }
}

impl<F: Function, const N: usize, const M: usize, const V: usize> SmoothSensor<Flat, N, M, V> for ByFunction<F> {
    fn output_jacobians(&self, x: &SVector<f64, N>) -> (SMatrix<f64, M, N>, SMatrix<f64, M, V>) {
        self.jacobians(x, &[])
    }
}

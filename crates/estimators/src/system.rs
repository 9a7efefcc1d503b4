//! [`System`]: the model of a set-valued filter: dynamics, measurement, invariants and noise sets.

use nonlin_bounds::Linear;
use scalars::Interval;
use setrep::{Matrix, Zonotope};

use crate::EstimatorError;
use crate::error::check_size;

mod relation;

pub use relation::Relation;

/// Equations and inequalities `h(x) in [range]` that hold at every step: conserved quantities, limits.
///
/// A range with a width states an inexact invariant (paper 003, Remark 13).
#[derive(Debug, Clone)]
pub struct Invariant {
    relation: Relation,
    range: Vec<Interval>,
}

impl Invariant {
    /// The function `h`.
    #[must_use]
    pub fn relation(&self) -> &Relation {
        &self.relation
    }

    /// The range of every entry of `h`.
    #[must_use]
    pub fn range(&self) -> &[Interval] {
        &self.range
    }
}

/// A discrete-time system with unknown but bounded noises,
///
/// ```text
/// x_k = f((x_{k-1}, w_{k-1}), u_k)    w in W
/// y_k = g((x_k, v_k), p_k)            v in V
/// h(x_k) in [range]                   (optional)
/// ```
///
/// The variables of `f` are the `n` states, then the process noises; those of `g` the states, then the measurement noises. Inputs `u`
/// and `p` are parameters: known numbers, times, anything that varies from call to call. Parts that change over time are
/// replaced between steps by the setters.
#[derive(Debug, Clone)]
pub struct System {
    dynamics: Relation,
    process_noise: Zonotope,
    measurement: Relation,
    measurement_noise: Zonotope,
    invariant: Option<Invariant>,
}

impl System {
    /// A system without invariants.
    ///
    /// # Errors
    /// [`EstimatorError::Size`] if the sizes do not fit: `f` has `n` outputs and `n + dim W` variables, `g` has `n + dim V`
    /// variables.
    pub fn new(
        dynamics: Relation,
        process_noise: Zonotope,
        measurement: Relation,
        measurement_noise: Zonotope,
    ) -> Result<Self, EstimatorError> {
        let states = dynamics.function().outputs();
        check_size("variables of the dynamics", states + process_noise.dim(), dynamics.function().variables())?;
        let variables = states + measurement_noise.dim();
        check_size("variables of the measurement", variables, measurement.function().variables())?;
        Ok(Self { dynamics, process_noise, measurement, measurement_noise, invariant: None })
    }

    /// A linear system without inputs,
    ///
    /// ```text
    /// x_k = A x_{k-1} + B w_{k-1}    w in W        A: n x n,  B: n x q
    /// y_k = C x_k + D v_k            v in V        C: m x n,  D: m x r
    /// ```
    ///
    /// for filters of a [`System`], which are exact for it but for rounding and what their sets cannot hold. Inputs enter as parameters
    /// ([`Linear::with_parameters`](nonlin_bounds::Linear::with_parameters)).
    ///
    /// # Errors
    /// [`EstimatorError::Size`] if the sizes do not fit, [`EstimatorError::Bound`] for entries that are not finite.
    ///
    /// ```
    /// use estimators::{Estimator, System, Zf, ZfOptions};
    /// use setrep::{Matrix, Zonotope};
    ///
    /// // A mass with an unknown push every 0.1 s; its position is measured.
    /// let a = Matrix::from_rows(&[&[1.0, 0.1], &[0.0, 1.0]])?;
    /// let (b, c) = (Matrix::from_rows(&[&[0.005], &[0.1]])?, Matrix::from_rows(&[&[1.0, 0.0]])?);
    /// let (push, error) = (Zonotope::from_box(&[0.0], &[0.1])?, Zonotope::from_box(&[0.0], &[0.2])?);
    /// let system = System::linear(&a, &b, push, &c, &Matrix::identity(1), error)?;
    /// let mut filter = Zf::new(system, Zonotope::from_box(&[0.0, 0.0], &[10.0, 10.0])?, ZfOptions::new(20))?;
    /// for k in 0..100 {
    ///     filter.step(&[], &[0.1 * f64::from(k)])?; // moving at speed 1
    /// }
    /// assert!(filter.hull()[1].contains(1.0) && filter.hull()[1].rad() < 0.6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn linear(
        a: &Matrix,
        b: &Matrix,
        process_noise: Zonotope,
        c: &Matrix,
        d: &Matrix,
        measurement_noise: Zonotope,
    ) -> Result<Self, EstimatorError> {
        let side_by_side = |what, left: &Matrix, right: &Matrix| {
            check_size(what, left.rows(), right.rows())?;
            let columns = [left.as_slice(), right.as_slice()].concat();
            let both = Matrix::from_column_slice(left.rows(), left.cols() + right.cols(), &columns)?;
            Ok::<_, EstimatorError>(Relation::new(Linear::new(both)?))
        };
        check_size("columns of A", a.rows(), a.cols())?;
        check_size("columns of C", a.rows(), c.cols())?;
        let dynamics = side_by_side("rows of B", a, b)?;
        Self::new(dynamics, process_noise, side_by_side("rows of D", c, d)?, measurement_noise)
    }

    /// The same system with the invariant `h(x) in [range]`; `h` has the states as variables and no parameters.
    ///
    /// # Errors
    /// [`EstimatorError::Size`] if the sizes do not fit, [`EstimatorError::EmptyRange`] if a range is empty.
    pub fn with_invariant(mut self, relation: Relation, range: Vec<Interval>) -> Result<Self, EstimatorError> {
        check_size("variables of the invariant", self.states(), relation.function().variables())?;
        check_size("parameters of the invariant", 0, relation.function().parameters())?;
        check_size("range of the invariant", relation.function().outputs(), range.len())?;
        if let Some(index) = range.iter().position(Interval::is_empty) {
            return Err(EstimatorError::EmptyRange { what: "range of the invariant", index });
        }
        self.invariant = Some(Invariant { relation, range });
        Ok(self)
    }

    /// Number `n` of states.
    #[must_use]
    pub fn states(&self) -> usize {
        self.dynamics.function().outputs()
    }

    /// Number of measured quantities.
    #[must_use]
    pub fn outputs(&self) -> usize {
        self.measurement.function().outputs()
    }

    /// The dynamics `f`.
    #[must_use]
    pub fn dynamics(&self) -> &Relation {
        &self.dynamics
    }

    /// The measurement `g`.
    #[must_use]
    pub fn measurement(&self) -> &Relation {
        &self.measurement
    }

    /// The invariant, if there is one.
    #[must_use]
    pub fn invariant(&self) -> Option<&Invariant> {
        self.invariant.as_ref()
    }

    /// The set `W` of process noises.
    #[must_use]
    pub fn process_noise(&self) -> &Zonotope {
        &self.process_noise
    }

    /// The set `V` of measurement noises.
    #[must_use]
    pub fn measurement_noise(&self) -> &Zonotope {
        &self.measurement_noise
    }

    /// Replaces the dynamics and the process noise, from the next step on.
    ///
    /// # Errors
    /// [`EstimatorError::Size`] if the sizes do not fit the states; nothing is then replaced.
    pub fn set_dynamics(&mut self, dynamics: Relation, process_noise: Zonotope) -> Result<(), EstimatorError> {
        check_size("outputs of the dynamics", self.states(), dynamics.function().outputs())?;
        check_size("variables of the dynamics", self.states() + process_noise.dim(), dynamics.function().variables())?;
        (self.dynamics, self.process_noise) = (dynamics, process_noise);
        Ok(())
    }

    /// Replaces the measurement and its noise; the number of outputs may change.
    ///
    /// # Errors
    /// [`EstimatorError::Size`] if the sizes do not fit the states; nothing is then replaced.
    pub fn set_measurement(&mut self, measurement: Relation, noise: Zonotope) -> Result<(), EstimatorError> {
        let variables = self.states() + noise.dim();
        check_size("variables of the measurement", variables, measurement.function().variables())?;
        (self.measurement, self.measurement_noise) = (measurement, noise);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use nonlin_bounds::Function;
    use scalars::{Interval, Scalar};
    use setrep::Zonotope;

    use super::{Relation, System};
    use crate::EstimatorError;

    /// As many sums of all variables as outputs.
    struct Sums(usize, usize);
    impl Function for Sums {
        fn variables(&self) -> usize {
            self.0
        }
        fn outputs(&self) -> usize {
            self.1
        }
        fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
            let sum = x.iter().fold(S::zero(), |sum, &x| sum + x);
            y.fill(sum);
        }
    }

    #[test]
    fn sizes_that_do_not_fit_are_named() {
        let unit = |n: usize| Zonotope::from_box(&vec![0.0; n], &vec![1.0; n]).unwrap();
        let relation = |n, m| Relation::new(Sums(n, m));
        let wrong = System::new(relation(2, 2), unit(1), relation(3, 1), unit(1)).unwrap_err();
        assert_eq!(wrong, EstimatorError::Size { what: "variables of the dynamics", expected: 3, found: 2 });
        let wrong = System::new(relation(3, 2), unit(1), relation(2, 1), unit(1)).unwrap_err();
        assert_eq!(wrong, EstimatorError::Size { what: "variables of the measurement", expected: 3, found: 2 });

        let mut system = System::new(relation(3, 2), unit(1), relation(3, 4), unit(1)).unwrap();
        assert_eq!((system.states(), system.outputs()), (2, 4));
        assert!(system.set_measurement(relation(4, 1), unit(1)).is_err());
        assert_eq!(system.outputs(), 4);
        system.set_measurement(relation(4, 1), unit(2)).unwrap();
        assert_eq!(system.outputs(), 1);
        assert!(system.set_dynamics(relation(4, 3), unit(1)).is_err());

        let wrong = system.clone().with_invariant(relation(2, 1), vec![Interval::EMPTY]).unwrap_err();
        assert_eq!(wrong, EstimatorError::EmptyRange { what: "range of the invariant", index: 0 });
        assert!(system.clone().with_invariant(relation(2, 1), vec![]).is_err());
        assert!(system.with_invariant(relation(2, 1), vec![Interval::ZERO]).unwrap().invariant().is_some());
    }
}

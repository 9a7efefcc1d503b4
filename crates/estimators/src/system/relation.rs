//! [`Relation`]: a function of a model.

use std::fmt;
use std::sync::Arc;

use nonlin_bounds::{DynFunction, ForwardBackward, Function, Jet, Order, Structured, Tape, Workspace};
use scalars::Interval;

/// A function of a model, shared between filters: what encloses it and, if it was recorded, its tape.
#[derive(Clone)]
pub struct Relation {
    function: Arc<dyn DynFunction + Send + Sync>,
    tape: Option<Arc<Tape>>,
}

impl Relation {
    /// A function written over [`scalars::Scalar`]. Its tape is recorded too, so that measurements can contract boxes.
    pub fn new<F: Function + Send + Sync + 'static>(function: F) -> Self {
        let function = Structured::new(function);
        let tape = Some(function.tape().clone());
        Self { function: Arc::new(function), tape }
    }

    /// A function known by hand-written bounds only: code that runs over `f64`, a bound of its error, bounds of its Jacobian. Filters do
    /// without contraction for it, and without Hessians if it has none.
    ///
    /// ```
    /// use estimators::{Estimator, Rcz, RczOptions, Relation, System};
    /// use nonlin_bounds::{BoundError, DynFunction, Jet, Order, Smoothness, function};
    /// use scalars::Interval;
    /// use setrep::{ConstrainedZonotope, Zonotope};
    ///
    /// /// A characteristic whose code is good to 1e-12 and whose slope is known to lie in `[0.75, 1.25]`.
    /// fn characteristic(x: f64) -> f64 { x - 0.25 * x.sin() }
    ///
    /// /// The gauge that has it, and an error: variables `(x, v)`.
    /// struct Gauge;
    /// impl DynFunction for Gauge {
    ///     fn variables(&self) -> usize { 2 }
    ///     fn parameters(&self) -> usize { 0 }
    ///     fn outputs(&self) -> usize { 1 }
    ///     fn value(&self, x: &[f64], _: &[f64], y: &mut [f64]) -> Result<(), BoundError> {
    ///         y[0] = characteristic(x[0]) + x[1];
    ///         Ok(())
    ///     }
    ///     fn enclose(&self, order: Order, x: &[Interval], _: &[Interval], jet: &mut Jet) -> Result<(), BoundError> {
    ///         if order == Order::Hessian {
    ///             return Err(BoundError::OrderNotAvailable { order: 2 });
    ///         }
    ///         jet.reset(order, 2, 1);
    ///         let (values, jacobian, _, smoothness) = jet.parts_mut();
    ///         // The mean value theorem.
    ///         let (slope, middle) = (Interval::ONE.inflate(0.25), x[0].mid());
    ///         values[0] = Interval::point(characteristic(middle)).inflate(1e-12) + slope * x[0].add_f64(-middle) + x[1];
    ///         if order == Order::Jacobian {
    ///             jacobian.copy_from_slice(&[slope, Interval::ONE]);
    ///         }
    ///         smoothness[0] = Smoothness::C1;
    ///         Ok(())
    ///     }
    /// }
    ///
    /// let drift = Relation::new(function!(|[x, w]: 2| -> 1 { [x + w] }));
    /// let (w, v) = (Zonotope::from_box(&[0.0], &[0.01])?, Zonotope::from_box(&[0.0], &[0.05])?);
    /// let system = System::new(drift, w, Relation::from_bounds(Gauge), v)?;
    /// let mut filter = Rcz::new(system, ConstrainedZonotope::from_box(&[2.0], &[1.0])?, RczOptions::fast(1))?;
    /// filter.update(&[characteristic(2.5)])?;
    /// assert!(filter.hull()[0].contains(2.5) && filter.hull()[0].rad() < 0.3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_bounds<F: DynFunction + Send + Sync + 'static>(function: F) -> Self {
        Self { function: Arc::new(function), tape: None }
    }

    /// What the enclosures take.
    #[must_use]
    pub fn function(&self) -> &(dyn DynFunction + Send + Sync) {
        &*self.function
    }

    /// Whether no point of the box of variables gives values in `required`, by propagation or since the function is defined nowhere in
    /// it; propagation narrows the box.
    ///
    /// **Guarantee:** true only if there is none.
    pub(crate) fn excludes(&self, sides: &mut [Interval], required: &[Interval], parameters: &[Interval]) -> bool {
        let mut jet = Jet::new();
        if self.function.enclose(Order::Value, sides, parameters, &mut jet).is_err() || jet.outputs() != required.len()
        {
            return false;
        }
        // An output of which nothing is required may be defined nowhere.
        let mut stated = jet.values().iter().zip(required).filter(|(_, required)| **required != Interval::ENTIRE);
        if stated.any(|(value, required)| value.disjoint(required)) {
            return true;
        }
        let thorough = ForwardBackward { sweeps: 100, least_gain: 0.0 };
        let mut contract = |tape| thorough.contract_stated(tape, sides, parameters, required, &mut Workspace::new());
        self.tape().is_some_and(|tape| contract(tape).is_ok_and(|outcome| outcome.is_empty()))
    }

    /// The tape, if the function was recorded.
    #[must_use]
    pub fn tape(&self) -> Option<&Tape> {
        self.tape.as_deref()
    }
}

impl fmt::Debug for Relation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut view = f.debug_struct("Relation");
        view.field("variables", &self.function.variables()).field("parameters", &self.function.parameters());
        view.field("outputs", &self.function.outputs()).field("tape", &self.tape.is_some()).finish_non_exhaustive()
    }
}

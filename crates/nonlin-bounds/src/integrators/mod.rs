//! One step in time of a vector field: three discrete models, and one step that encloses the flow itself.
//!
//! A vector field is a [`Function`](crate::Function) `x' = f(x, w, p)` whose first variables are the states, as many as it has outputs;
//! further variables `w` (noises) and the parameters are constant over the step. [`Euler`], [`Heun`] and [`Rk4`] are the discrete
//! models: functions again, that claim nothing about the differential equation. [`Flow`] does claim it.

mod euler;
mod flow;
mod heun;
mod rk4;
mod series;

pub use euler::Euler;
pub use flow::Flow;
pub use heun::Heun;
pub use rk4::Rk4;

use crate::{BoundError, Function, Operand};

/// Number of states of a vector field.
fn check_field(field: &impl Function) -> Result<(), BoundError> {
    if field.outputs() > field.variables() {
        let (expected, found) = (field.outputs(), field.variables());
        return Err(BoundError::Dimension { operand: Operand::Variables, expected, found });
    }
    Ok(())
}

/// What every integrator has in common: the field, and the shapes of the discrete model.
macro_rules! discrete_model {
    ($type:ident) => {
        impl<F: Function> $type<F> {
            /// The discrete model of a vector field.
            ///
            /// # Errors
            /// [`BoundError::Dimension`] if the field has more outputs than variables.
            pub fn new(field: F) -> Result<Self, BoundError> {
                super::check_field(&field)?;
                Ok(Self { field })
            }
        }

        impl<F: Function> Function for $type<F> {
            const VARIABLES: Option<usize> = F::VARIABLES;
            fn variables(&self) -> usize {
                self.field.variables()
            }
            fn parameters(&self) -> usize {
                self.field.parameters() + 1
            }
            fn outputs(&self) -> usize {
                self.field.outputs()
            }
            fn eval<S: Scalar>(&self, x: &[S], p: &[S], y: &mut [S]) {
                let (p, step) = p.split_at(self.field.parameters());
                self.step(x, p, step[0], y);
            }
        }
    };
}
use discrete_model;

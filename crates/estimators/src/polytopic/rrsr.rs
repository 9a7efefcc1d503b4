//! [`Rrsr`]: the mean value filter that paper 004 compares with.

use crate::{CzFilter, CzOptions};

/// Guaranteed state estimation with constrained zonotopes by the mean value theorem, as paper 004 runs it (RRSR, after Rego, Raffo, Scott and
/// Raimondo 2020): [`CzFilter`] with the options [`CzOptions::rrsr`].
pub type Rrsr = CzFilter;

impl CzOptions {
    /// CZMV with the expansion points of heuristic C2 and without a limit on the complexity of the sets, for linear and nonlinear outputs: they
    /// grow by generators and constraints from step to step.
    ///
    /// **Source:** paper 004, Section VII, whose RRSR is CZMV of paper 003 where outputs are not linear.
    #[must_use]
    pub fn rrsr() -> Self {
        Self::czmv(None)
    }
}

//! [`Contender`]: a filter with its settings under a name, ready to be started.

use crate::{Mode, ScenarioError};

/// Builds a filter at a start.
type Build<S, F> = Box<dyn Fn(S) -> Result<Box<F>, ScenarioError> + Send + Sync>;

/// A filter with its settings, ready to be started anywhere in `S`; `F` is what the filters of a study have in common.
pub struct Contender<S, F: ?Sized> {
    /// Name in the rows: the filter, `/`, the variant.
    pub method: String,
    /// How the paper's algorithm is run.
    pub mode: Mode,
    build: Build<S, F>,
}

impl<S, F: ?Sized> std::fmt::Debug for Contender<S, F> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Contender").field("method", &self.method).field("mode", &self.mode).finish_non_exhaustive()
    }
}

impl<S, F: ?Sized> Contender<S, F> {
    /// A filter under a name.
    pub fn new<B>(method: impl Into<String>, mode: Mode, build: B) -> Self
    where
        B: Fn(S) -> Result<Box<F>, ScenarioError> + Send + Sync + 'static,
    {
        Self { method: method.into(), mode, build: Box::new(build) }
    }

    /// The filter at a start.
    ///
    /// # Errors
    /// Those of the filter's constructor.
    pub fn start(&self, at: S) -> Result<Box<F>, ScenarioError> {
        (self.build)(at)
    }
}

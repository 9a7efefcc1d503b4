//! Scratch memory that the caller owns, so that operations in steady state allocate nothing.

/// Buffers for the operations that take one. Grows to the largest use and is then reused; holds no result.
#[derive(Debug, Default, Clone)]
pub struct Workspace {
    /// Per-row sums of absolute values of the generators (and the center).
    pub(crate) row_sums: Vec<f64>,
    /// The remainder being built.
    pub(crate) remainder: Vec<f64>,
    /// The center being built.
    pub(crate) center: Vec<f64>,
    /// A matrix being built.
    pub(crate) matrix: Vec<f64>,
    /// Packed (key, column) pairs of a selection.
    pub(crate) keys: Vec<u64>,
    /// Selected columns.
    pub(crate) selected: Vec<usize>,
    /// A frame, its coordinates and their sums.
    pub(crate) frame: Vec<f64>,
    pub(crate) coordinates: Vec<f64>,
    pub(crate) scales: Vec<f64>,
    pub(crate) eigen: Vec<f64>,
    /// The covariation of a set.
    pub(crate) gram: crate::Matrix,
    /// Ranges of the rows being built.
    pub(crate) ranges: Vec<scalars::Interval>,
    /// Ranges of the rows to be cut by.
    pub(crate) offsets: Vec<scalars::Interval>,
    /// Linear programs over the generators' box.
    pub(crate) solver: Option<boxlp::Solver>,
    /// An objective of these.
    pub(crate) objective: Vec<f64>,
    /// Tables of minors.
    pub(crate) wedge: Option<crate::wedge::Wedge<f64>>,
    /// Eliminations with their estimated losses, and a constrained zonotope to try them on.
    pub(crate) choices: Vec<(f64, crate::constrained_zonotope::Choice)>,
    /// A constrained zonotope being changed, one to return to, and one lifted to a zonotope.
    pub(crate) trial: Option<crate::ConstrainedZonotope>,
    pub(crate) draft: Option<crate::ConstrainedZonotope>,
    pub(crate) backup: Option<crate::ConstrainedZonotope>,
    pub(crate) lift: Option<crate::Zonotope>,
    /// Members of a bundle being changed, and its constrained zonotope.
    pub(crate) members: Vec<crate::Zonotope>,
    pub(crate) program: Option<crate::ConstrainedZonotope>,
    /// A re-encoding under way.
    pub(crate) reencoding: crate::constrained_zonotope::ReencodingScratch,
}

impl Workspace {
    /// An empty workspace.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }
}

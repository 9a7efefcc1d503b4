//! [`Extension`]: how functions are enclosed on a set.

/// How functions are enclosed on a zonotope or a constrained zonotope.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Extension {
    /// The mean value theorem: Propositions 1 and 3, Corollary 1 of paper 003. Needs `C1` and Jacobians; adds as many generators as
    /// outputs.
    MeanValue,
    /// Taylor's theorem of first order, whose quadratic term is a set of its own: Propositions 2 and 4, Corollary 2. Needs `C2` and
    /// Hessians; adds generators and constraints for all pairs of those of the set.
    FirstOrder,
}

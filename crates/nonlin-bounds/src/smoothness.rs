//! [`Smoothness`]: what an evaluation over a box has proven about a function there.

/// What an evaluation has proven about a function on a whole box, from nothing to twice continuously differentiable.
///
/// The order is the strength of the claim; the smoothness of a composition is the least of its parts. `C2` is the most that is
/// kept track of: the elementary functions are smooth wherever they are `C2`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Smoothness {
    /// Not proven to be defined on the whole box (a pole, a root of a negative number).
    Undefined,
    /// Defined, but not proven continuous (the cut of `atan2`).
    Defined,
    /// Continuous (`|x|` across zero, `sqrt` at zero).
    C0,
    /// Continuously differentiable.
    C1,
    /// Twice continuously differentiable.
    C2,
}

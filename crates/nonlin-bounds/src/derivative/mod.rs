//! Forward-mode derivatives over any scalar, and what is proven about the function while they are computed.
//!
//! [`Decorated`] pairs a range with its [`Smoothness`](crate::Smoothness); [`Dual`] carries a gradient, [`Second`] also a packed
//! Hessian. The chain rule is written once (`elementary`), the blocks of seeds for many variables are in `blocks`,
//! those for a known structure in `plan`.

mod blocks;
mod decorated;
mod dual;
mod elementary;
mod plan;
mod second;

pub(crate) use blocks::{Enclosure, Evaluate, Scratch, enclose, jacobian, values};
pub use decorated::Decorated;
pub use dual::Dual;
pub(crate) use plan::{Plan, enclose_by_plan};
pub use second::Second;

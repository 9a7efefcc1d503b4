//! Forward-mode derivatives over any scalar, and what is proven about the function while they are computed.
//!
//! [`Decorated`] pairs a range with its [`Smoothness`](crate::Smoothness); [`Dual`] carries a gradient, [`Second`] also a packed
//! Hessian. The chain rule is written once (`elementary`), the blocks of seeds for many variables are in `blocks`.

mod blocks;
mod decorated;
mod dual;
mod elementary;
mod second;

pub(crate) use blocks::{Scratch, enclose};
pub use decorated::Decorated;
pub use dual::Dual;
pub use second::Second;

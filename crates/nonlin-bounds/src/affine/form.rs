//! [`Form`]: how a function is enclosed by an affine one.

use crate::{Order, Smoothness};

/// How a function is enclosed by an affine one. With `gamma` the expansion point, `H` the box, `d = H - gamma`:
///
/// | form | `J` | `[e]` | needs |
/// |---|---|---|---|
/// | `Natural` | `mid f'(H)` | `f(H) - J d` | defined |
/// | `MeanValue` | `mid f'(H)` | `f(gamma) + (f'(H) - J) d` | C1 |
/// | `Slope` | `mid S` | `f(gamma) + (S - J) d`, `S = f'(gamma) + d' f''(H) / 2` | C2 |
/// | `Taylor` | `mid f'(gamma)` | `f(gamma) + (f'(gamma) - J) d + sum_k h_kk d_k^2 / 2 + sum_{j<k} h_jk d_j d_k` | C2 |
///
/// Take `Taylor` where Hessians are at hand: its remainder is of second order in the box and one-sided (`d_k^2 >= 0`), about the middle
/// of the hull a quarter as wide as the mean value form's for `x^2` and never wider than the slope form's. `Slope` gains where the
/// expansion point is far from the middle. `MeanValue` needs no Hessian. `Natural` needs nothing and keeps what it has of dependencies.
///
/// **Source:** Taylor: Lagrange's remainder; mean value: paper 003, Lemma 1; natural: paper 001, (30)-(33).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Form {
    /// The range on the box against the mean gradient.
    Natural,
    /// The mean value theorem.
    MeanValue,
    /// A slope matrix from the Hessians, exact for quadratics.
    Slope,
    /// Taylor's theorem of first order with its remainder.
    Taylor,
}

impl Form {
    /// The derivatives over the box and at the expansion point.
    pub(super) fn orders(self) -> (Order, Order) {
        match self {
            Self::Natural | Self::MeanValue => (Order::Jacobian, Order::Value),
            Self::Slope | Self::Taylor => (Order::Hessian, Order::Jacobian),
        }
    }

    /// The smoothness that the form needs of an output.
    pub(super) fn needs(self) -> Smoothness {
        match self {
            Self::Natural => Smoothness::Defined,
            Self::MeanValue => Smoothness::C1,
            Self::Slope | Self::Taylor => Smoothness::C2,
        }
    }
}

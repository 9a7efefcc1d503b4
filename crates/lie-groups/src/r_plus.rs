//! R+: scalings.

use nalgebra::{DMatrix, SMatrix, SVector};
use scalars::Scalar;

use crate::lie_group::checked_vee;
use crate::{Coeff, GroupError, LieGroup};

/// A scaling by a positive factor `e^s`.
///
/// - **Tangent:** `xi = (s)`, the natural logarithm of the factor: no estimate can make a scale negative.
/// - **Storage:** `s` and `e^s`. Products add the logarithms, so small ones keep their digits and, over intervals, nothing but rounding is lost.
/// - **Acts on** the line: `e^s p`.
/// - **Matrix:** `[e^s]`, `hat(xi) = [s]`. The group is commutative: `Ad = I`, `ad = 0`, `Jl = Jr = I`.
///
/// ```
/// use lie_groups::{LieGroup, RPlus};
///
/// let wheel = RPlus::from_scale(0.95)?;
/// assert!((wheel.compose(&wheel).scale() - 0.9025).abs() < 1e-15);
/// # Ok::<(), lie_groups::GroupError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RPlus<S> {
    log: S,
    scale: S,
}

impl<S: Scalar> RPlus<S> {
    /// The scaling by `e^s`.
    #[inline]
    pub fn from_log(s: S) -> Self {
        Self { log: s, scale: s.exp() }
    }

    /// The logarithm `s` of the factor.
    #[inline]
    pub fn log_scale(&self) -> S {
        self.log
    }

    /// The factor `e^s`.
    #[inline]
    pub fn scale(&self) -> S {
        self.scale
    }
}

impl<S: Coeff> RPlus<S> {
    /// The scaling by a positive factor.
    ///
    /// # Errors
    /// [`GroupError::NotFinite`] or [`GroupError::NotAScale`] unless the factor is finite and positive (over intervals: every member).
    pub fn from_scale(scale: S) -> Result<Self, GroupError> {
        scale.check_finite(0)?;
        let (scale_lo, scale_hi) = scale.ends();
        if scale_lo > 0.0 {
            Ok(Self { log: scale.ln(), scale })
        } else {
            Err(GroupError::NotAScale { scale_lo, scale_hi })
        }
    }
}

impl<S: Coeff> LieGroup<S, 1, 1> for RPlus<S> {
    #[inline]
    fn identity() -> Self {
        Self { log: S::zero(), scale: S::one() }
    }

    #[inline]
    fn exp(xi: &SVector<S, 1>) -> Self {
        Self::from_log(xi[0])
    }

    #[inline]
    fn log(&self) -> Result<SVector<S, 1>, GroupError> {
        self.log.check_finite(0)?;
        Ok(SVector::<S, 1>::new(self.log))
    }

    #[inline]
    fn compose(&self, other: &Self) -> Self {
        Self::from_log(self.log + other.log)
    }

    #[inline]
    fn inverse(&self) -> Self {
        Self::from_log(-self.log)
    }

    #[inline]
    fn act(&self, p: &SVector<S, 1>) -> SVector<S, 1> {
        SVector::<S, 1>::new(self.scale * p[0])
    }

    #[inline]
    fn act_linear(&self) -> SMatrix<S, 1, 1> {
        SMatrix::<S, 1, 1>::new(self.scale)
    }

    #[inline]
    fn act_jacobian(p: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        *p
    }

    #[inline]
    fn adjoint(&self) -> SMatrix<S, 1, 1> {
        SMatrix::<S, 1, 1>::new(S::one())
    }

    #[inline]
    fn ad(_xi: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::<S, 1, 1>::new(S::zero())
    }

    #[inline]
    fn jl(_xi: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::<S, 1, 1>::new(S::one())
    }

    #[inline]
    fn jl_inv(xi: &SVector<S, 1>) -> Result<SMatrix<S, 1, 1>, GroupError> {
        xi[0].check_finite(0)?;
        Ok(SMatrix::<S, 1, 1>::new(S::one()))
    }

    fn hat(xi: &SVector<S, 1>) -> DMatrix<S> {
        DMatrix::from_element(1, 1, xi[0])
    }

    fn vee(matrix: &DMatrix<S>) -> Result<SVector<S, 1>, GroupError> {
        checked_vee(matrix, 1, |m| SVector::<S, 1>::new(m[(0, 0)]), Self::hat)
    }

    fn matrix(&self) -> DMatrix<S> {
        DMatrix::from_element(1, 1, self.scale)
    }
}

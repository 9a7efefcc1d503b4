//! Order reduction: fewer generators, a larger set. One method a file.
//!
//! All methods enclose some generators `B` (columns of `G`) in a parallelotope or box `T` of `n` generators,
//! `{ B xi } in { T zeta }`, and keep the others as they are: `<c, [K B], r>` lies in `<c, [K T], r'>`, where `r' - r` is
//! rounding only.

mod combastel;
mod frame;
mod girard;
mod jacobi;
mod method4;
mod pca;
mod selection;

pub(crate) use jacobi::eigenvectors;

use crate::{SetError, Workspace, Zonotope};

/// Methods of order reduction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Reduction {
    /// Boxes the generators of least 2-norm (the `R_s` of the papers).
    #[default]
    Combastel,
    /// Boxes the generators of least `|g|_1 - |g|_inf`, those closest to an axis or to zero.
    Girard,
    /// Encloses the generators of least 2-norm in a box along their principal axes.
    Pca,
    /// Grows a parallelotope of `n` generators by those that cost the least volume (Chisci; Yang and Scott's method 4).
    Method4,
}

impl Zonotope {
    /// Encloses the set in one with at most `max_generators` generators; does nothing if it has no more already.
    ///
    /// Generators that are zero are dropped. Allocates nothing within the capacity of the workspace.
    ///
    /// **Guarantee:** superset of the set; at most `max_generators` columns; the box remainder grows by rounding only. PCA and
    /// method 4 fall back to Combastel where their frame is not well-conditioned enough for that.
    /// **Source:** see [`Reduction`] and `reduce/*.rs`.
    ///
    /// # Errors
    /// [`SetError::TooFewGenerators`] if `max_generators < n` (also for a set that needs no reduction), [`SetError::Overflow`]; the set is then unchanged.
    ///
    /// ```
    /// # use setrep::{Matrix, Reduction, Workspace, Zonotope};
    /// let mut set = Zonotope::new(&[0.0, 0.0], &Matrix::from_rows(&[&[4.0, 1.0, -0.5], &[0.0, 1.0, 0.5]])?)?;
    /// set.reduce(Reduction::Combastel, 2, &mut Workspace::new())?;
    /// assert_eq!(set.num_generators(), 2);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn reduce(
        &mut self,
        method: Reduction,
        max_generators: usize,
        workspace: &mut Workspace,
    ) -> Result<(), SetError> {
        if max_generators < self.dim() {
            return Err(SetError::TooFewGenerators { max_generators, dim: self.dim() });
        }
        if self.num_generators() <= max_generators {
            return Ok(());
        }
        match method {
            Reduction::Combastel => combastel::reduce(self, max_generators, workspace),
            Reduction::Girard => girard::reduce(self, max_generators, workspace),
            Reduction::Pca => pca::reduce(self, max_generators, workspace),
            Reduction::Method4 => method4::reduce(self, max_generators, workspace),
        }
    }
}

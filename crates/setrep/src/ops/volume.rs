//! Volume of a zonotope.

use core::ops::ControlFlow;

use scalars::Interval;

use super::planar::sorted_by_angle;
use crate::wedge::{Wedge, check_subsets};
use crate::{SetError, Zonotope};

/// Most `n`-subsets of generators that [`Zonotope::volume`] enumerates.
pub const MINOR_LIMIT: u64 = 2_000_000;

impl Zonotope {
    /// Volume `2^n sum_J |det G_J|` over the `n`-subsets `J` of the generators, the box remainder counted as generators.
    ///
    /// In the plane `4 sum_{i<j} |g_i x g_j|` by sorting the generators by angle, in `O(ng log ng)`; otherwise by all minors,
    /// `C(ng, n)` of them (the problem is #P-hard in `n`).
    ///
    /// **Guarantee:** the interval contains the exact volume; its upper bound is infinite where the sum overflows.
    /// **Source:** Shephard 1974; Gover and Krikorian 2010.
    ///
    /// # Errors
    /// [`SetError::TooManySubsets`] beyond [`MINOR_LIMIT`] minors (not in the plane), [`SetError::TooManyDimensions`] beyond 14.
    ///
    /// ```
    /// # use setrep::{Matrix, Zonotope};
    /// let hexagon = Zonotope::new(&[0.0, 0.0], &Matrix::from_rows(&[&[1.0, 0.0, 1.0], &[0.0, 1.0, 1.0]])?)?;
    /// assert!(hexagon.volume()?.contains(12.0));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn volume(&self) -> Result<Interval, SetError> {
        let (n, generators) = (self.dim(), self.all_generators());
        let minors =
            if n == 2 { planar_minor_sum(&sorted_by_angle(&generators)) } else { minor_sum(n, generators.as_slice())? };
        let doubled = (0..n).fold(minors, |volume, _| volume.scale(2.0));
        Ok(doubled.intersection(Interval::new(0.0, f64::INFINITY).unwrap_or(doubled)))
    }
}

/// `sum_J |det G_J|` over the `n`-subsets of the columns.
fn minor_sum(n: usize, columns: &[f64]) -> Result<Interval, SetError> {
    let subsets = check_subsets(n, columns.len() / n, n, MINOR_LIMIT)?;
    let mut sum = Interval::ZERO;
    if subsets > 0 {
        Wedge::<Interval>::new(n, n).for_each(columns, &mut |_, minors| {
            sum += minors[0].abs();
            ControlFlow::Continue(())
        });
    }
    Ok(sum)
}

/// `sum_{i<j} |g_i x g_j|` for generators of the half-plane sorted by angle, as `sum_j (g_1 + .. + g_{j-1}) x g_j`.
///
/// The generators are sorted by a position on the unit circle of the 1-norm that is off by at most `4u`. Two in the wrong order are
/// then at most `8u` apart there, so `|a x b| <= 16 u |a|_1 |b|_1`; this enters with the wrong sign, an error of twice as much.
/// All pairs together, the sum as ordered is at most `16 u (sum_j |g_j|_1)^2` below the true one, and never above it.
fn planar_minor_sum(sorted: &[[f64; 2]]) -> Interval {
    let (mut sum, mut norms) = (Interval::ZERO, Interval::ZERO);
    let mut prefix = [Interval::ZERO; 2];
    for g in sorted {
        sum += prefix[0].scale(g[1]) - prefix[1].scale(g[0]);
        norms += Interval::point(g[0].abs()) + Interval::point(g[1]);
        prefix[0] += Interval::point(g[0]);
        prefix[1] += Interval::point(g[1]);
    }
    if sorted.len() < 2 {
        return Interval::ZERO;
    }
    let misordered = norms.sqr().scale(8.0 * f64::EPSILON);
    sum + Interval::ZERO.hull(misordered)
}

//! Convex hulls with fewer points: what the others nearly hold is dropped, and paid for in the remainder.

use super::VPolytope;
use super::walk::{Place, Walk, extreme, residual};
use crate::Matrix;
use crate::bounds::add_lengths;

/// Roundings of coordinates that a dropped point may always cost.
const ULPS: f64 = 32.0 * f64::EPSILON;

impl VPolytope {
    /// The same set but for little, with fewer columns: those are dropped that lie in the hull of the others up to `share` of the set's
    /// extent in each coordinate (and a few ulp), and by how much they may be outside joins the remainder.
    ///
    /// Where [`remove_redundant`](Self::remove_redundant) keeps every exact vertex, however close to a facet, this is what computed sets
    /// ask for, whose facets are planes up to rounding only: it keeps a corner once, and it is fast. Every dropped column has a
    /// convex combination of columns that are kept, whose rounding is bounded. A `share` that is not positive counts as zero.
    ///
    /// **Guarantee:** superset; larger by at most the growth of the remainder. Which columns are kept is a matter of floating point.
    ///
    /// ```
    /// # use setrep::{Matrix, VPolytope};
    /// let nearly = VPolytope::new(Matrix::from_columns(&[&[0.0, 0.0], &[1.0, 0.0], &[0.0, 1.0], &[0.5, 0.5 + 1e-14]])?)?;
    /// let triangle = nearly.thinned(1e-12);
    /// assert_eq!((nearly.remove_redundant()?.num_vertices(), triangle.num_vertices()), (4, 3));
    /// assert!(triangle.remainder().iter().all(|&r| r < 2e-14));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    #[must_use]
    pub fn thinned(&self, share: f64) -> Self {
        let share = if share > 0.0 { share } else { 0.0 };
        let (n, m) = (self.dim(), self.num_vertices());
        let Some(mut walk) = Walk::new(&self.vertices) else { return self.clone() };
        let hull = self.interval_hull();
        let limits: Vec<f64> = hull.iter().map(|side| share * side.width() + ULPS * side.mag()).collect();
        let mut undecided: Vec<usize> = (0..m).filter(|j| !walk.kept.contains(j)).collect();
        let (mut lost, mut trial) = (vec![0.0_f64; n], vec![0.0_f64; n]);
        while let Some(&next) = undecided.last() {
            let q = walk.relative(next).to_vec();
            let vertex = match walk.place(&q, share) {
                Place::Inside(mut weights) => {
                    let x = self.vertices.col(next);
                    if residual(&self.vertices, x, &mut weights, &mut trial)
                        && trial.iter().zip(&limits).all(|(e, limit)| e <= limit)
                    {
                        lost.iter_mut().zip(&trial).for_each(|(lost, e)| *lost = lost.max(*e));
                        undecided.pop();
                        continue;
                    }
                    next
                }
                Place::Outside(normal) => {
                    let reach = |j: usize| normal.iter().zip(walk.relative(j)).map(|(a, x)| a * x).sum();
                    extreme(undecided.iter().copied(), reach, |j| walk.relative(j)).unwrap_or(next)
                }
                Place::Lost => next,
            };
            undecided.retain(|&j| j != vertex);
            walk.kept.push(vertex);
        }
        walk.kept.sort_unstable();
        let mut vertices = Matrix::zeros(n, 0);
        vertices.reserve_cols(walk.kept.len());
        walk.kept.iter().for_each(|&j| vertices.append_columns(self.vertices.col(j)));
        let remainder = self.remainder.iter().zip(&lost).map(|(&r, &lost)| add_lengths(r, lost)).collect();
        Self { vertices, remainder }
    }
}

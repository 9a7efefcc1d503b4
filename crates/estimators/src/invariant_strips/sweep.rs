//! Support functions of points turned through a range of angles: the bounds of all noise terms.
//!
//! Every term that a step adds to a row has the form `<d, e^{i psi} c>` with `psi` in a range and `c` one of a few points. Its supremum is
//! exact: the larger value at the two ends, or `|d| |c|` if the direction of `d` is passed on the way. No trigonometric function is
//! needed for a row: the turned points are computed once a step.

use scalars::Interval;
use scalars::rounding::UNIT_ROUNDOFF;

use super::plane::{Vector, cross, dot, modulus_up, norm1, point, product, radius, unit};

/// Ranges wider than this count as whole turns, so that the cone between two ends is pointed.
const WIDEST: f64 = 3.0;

/// The set `{ e^{i psi} c_k : psi in a range, k }` of up to four points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sweep {
    paths: [Path; 4],
    len: usize,
    whole: bool,
    /// Error of a value for a direction of 1-norm 1.
    pad: f64,
}

/// `|d|` but for rounding; an upper bound where its square underflows.
#[inline]
fn length(d: Vector) -> f64 {
    let square = dot(d, d);
    if square > 1e-280 { square.sqrt() } else { norm1(d) }
}

/// The way of one point.
#[derive(Debug, Clone, Copy, Default)]
struct Path {
    first: Vector,
    last: Vector,
    /// Upper bound of `|c|`.
    length: f64,
}

impl Path {
    /// Whether the direction of `d` may be passed on the way; never false if it is.
    ///
    /// The range is narrower than a half turn by 0.14, so a direction that is passed has a positive product with the bisector, rounding
    /// or not; the two cross products are allowed their rounding.
    #[inline]
    fn passes(&self, d: Vector, error: f64) -> bool {
        let bisector = [self.first[0] + self.last[0], self.first[1] + self.last[1]];
        cross(self.first, d) >= -error && cross(d, self.last) >= -error && dot(bisector, d) > 0.0
    }
}

impl Sweep {
    /// The points `corners`, at most four, turned through `angles`.
    pub(super) fn new(angles: Interval, corners: &[Vector]) -> Self {
        let whole = angles.is_empty() || angles.width() > WIDEST;
        let (first, last) = if whole {
            let any = [Interval::ONE, Interval::ZERO];
            (any, any)
        } else {
            (unit(Interval::point(angles.lo())), unit(Interval::point(angles.hi())))
        };
        let (mut paths, mut off, mut longest) = ([Path::default(); 4], 0.0_f64, 0.0_f64);
        for (path, &corner) in paths.iter_mut().zip(corners) {
            let (start, end) = (product(&first, &point(corner)), product(&last, &point(corner)));
            let length = modulus_up(corner);
            *path = Path { first: start.map(|s| s.mid()), last: end.map(|e| e.mid()), length };
            off = off.max(radius(&start)).max(radius(&end));
            longest = longest.max(length);
        }
        // Ends, products and sums: at most eight roundings of `|d|_1 |c|` for a value, or of subnormal numbers.
        let pad = off * 1.001 + 8.0 * UNIT_ROUNDOFF * longest + f64::MIN_POSITIVE;
        Self { paths, len: corners.len().min(4), whole, pad }
    }

    /// Upper bound of `max <d, p>` over the set.
    #[inline]
    pub(super) fn sup(&self, d: Vector) -> f64 {
        let error = self.pad * norm1(d);
        let mut most = f64::NEG_INFINITY;
        for path in &self.paths[..self.len] {
            let value = if self.whole || path.passes(d, error) {
                length(d) * path.length
            } else {
                dot(path.first, d).max(dot(path.last, d))
            };
            most = most.max(value);
        }
        most + error
    }

    /// Upper bound of `max |<d, p>|` over the set.
    #[inline]
    pub(super) fn sup_abs(&self, d: Vector) -> f64 {
        let error = self.pad * norm1(d);
        let opposite = [-d[0], -d[1]];
        let mut most = 0.0_f64;
        for path in &self.paths[..self.len] {
            let value = if self.whole || path.passes(d, error) || path.passes(opposite, error) {
                length(d) * path.length
            } else {
                dot(path.first, d).abs().max(dot(path.last, d).abs())
            };
            most = most.max(value);
        }
        most + error
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values are upper bounds of a fine sample, and no more than rounding and the grid above it.
    #[test]
    fn suprema_are_attained() {
        let corners = [[0.3, 0.1], [0.3, -0.1], [-0.2, 0.4]];
        for (lo, width) in [(0.2, 0.0), (-1.0, 0.3), (2.0, 1.7), (-3.0, 2.9), (5.0, 3.1), (0.0, 7.0)] {
            let sweep = Sweep::new(Interval::new(lo, lo + width).unwrap(), &corners);
            for k in 0..60 {
                let angle = f64::from(k) * 0.1047;
                let d = [2.0 * angle.cos(), 2.0 * angle.sin()];
                let steps = 4000;
                let (mut most, mut most_abs) = (f64::NEG_INFINITY, 0.0_f64);
                // Beyond the widest range the set counts as the whole turn.
                let reach = if width > WIDEST { core::f64::consts::TAU } else { width };
                for corner in corners {
                    for j in 0..=steps {
                        let (s, c) = (lo + reach * f64::from(j) / f64::from(steps)).sin_cos();
                        let value = dot(d, [c * corner[0] - s * corner[1], s * corner[0] + c * corner[1]]);
                        most = most.max(value);
                        most_abs = most_abs.max(value.abs());
                    }
                }
                assert!(sweep.sup(d) >= most - 1e-15 && sweep.sup(d) < most + 2e-6, "{lo} {width} {k}");
                assert!(sweep.sup_abs(d) >= most_abs - 1e-15 && sweep.sup_abs(d) < most_abs + 2e-6, "{lo} {width} {k}");
            }
        }
    }
}

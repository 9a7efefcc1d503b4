//! Range of a parabola with uncertain coefficients, `{ a z + q z^2 : a in [a], q in [q], z in [z] }`.

use scalars::Interval;

/// Encloses the range; exact but for rounding.
pub(super) fn parabola(a: Interval, q: Interval, z: Interval) -> Interval {
    Interval::new(-maximum(-a, -q, z), maximum(a, q, z)).unwrap_or(Interval::ENTIRE)
}

/// Upper bound. The curvature that counts is `q.hi`, the slope `a.hi` for positive `z`, and `a.lo` for negative ones.
fn maximum(a: Interval, q: Interval, z: Interval) -> f64 {
    let mut bound = f64::NEG_INFINITY;
    if z.hi() >= 0.0 {
        bound = peak(a.hi(), q.hi(), z.lo().max(0.0), z.hi());
    }
    if z.lo() <= 0.0 {
        bound = bound.max(peak(-a.lo(), q.hi(), (-z.hi()).max(0.0), -z.lo()));
    }
    bound
}

/// Upper bound of `a t + q t^2` for `0 <= lo <= t <= hi`.
fn peak(a: f64, q: f64, lo: f64, hi: f64) -> f64 {
    let (a, q) = (Interval::point(a), Interval::point(q));
    let value = |t: f64| (a * Interval::point(t) + q * Interval::point(t).sqr()).hi();
    if q.hi() < 0.0 {
        let vertex = a / q.scale(-2.0);
        if vertex.hi() >= lo && vertex.lo() <= hi {
            // The maximum over the whole line.
            return (a.sqr() / q.scale(-4.0)).hi();
        }
    }
    value(lo).max(value(hi))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against a fine grid: never inside it, and at most a rounding outside of what the grid can miss.
    #[test]
    fn against_a_grid() {
        let interval = |lo: f64, hi: f64| Interval::new(lo, hi).unwrap_or(Interval::ENTIRE);
        let values = [-2.0, -0.75, -0.125, 0.0, 0.25, 1.0, 3.0];
        for (k, &a) in values.iter().enumerate() {
            for &q in &values {
                for &lo in &values {
                    for width in [0.0, 0.25, 2.0] {
                        let wide = if k % 2 == 0 { 0.0 } else { 0.5 };
                        let range = parabola(interval(a, a + wide), interval(q, q + wide), interval(lo, lo + width));
                        let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
                        for step in 0..=1000 {
                            let z = lo + width * f64::from(step) / 1000.0;
                            for (a, q) in [(a, q), (a + wide, q), (a, q + wide), (a + wide, q + wide)] {
                                let y = a * z + q * z * z;
                                (least, largest) = (least.min(y), largest.max(y));
                            }
                        }
                        let message = format!("{a} {q} {lo} {width}: {range:?} {least} {largest}");
                        assert!(range.lo() <= least + 1e-12 && largest - 1e-12 <= range.hi(), "{message}");
                        assert!(least - range.lo() < 2e-5 && range.hi() - largest < 2e-5, "{message}");
                    }
                }
            }
        }
    }
}

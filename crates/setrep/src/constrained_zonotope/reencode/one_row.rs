//! Linear programs over a box with a single row, in closed form.

/// `max { f'xi : |xi| <= 1, a'xi in [lo, hi] }` in plain floating point: the minimum over `y` of
/// `B(y) = max(y lo, y hi) + |f - y a|_1`.
///
/// `B` is convex and piecewise linear. Its slope starts at `lo - |a|_1` and rises by `2 |a_k|` at `y = f_k / a_k` and by `hi - lo` at
/// `y = 0`; the minimum is where it passes zero.
pub(super) fn one_row(f: &[f64], a: &[f64], lo: f64, hi: f64, breakpoints: &mut Vec<(f64, f64)>) -> f64 {
    breakpoints.clear();
    breakpoints.push((0.0, hi - lo));
    let mut slope = lo;
    for (&f, &a) in f.iter().zip(a) {
        if a != 0.0 {
            slope -= a.abs();
            breakpoints.push((f / a, 2.0 * a.abs()));
        }
    }
    breakpoints.sort_unstable_by(|x, y| x.0.total_cmp(&y.0));
    let mut y = 0.0;
    for &(at, rise) in breakpoints.iter() {
        y = at;
        slope += rise;
        if slope >= 0.0 {
            break;
        }
    }
    let rest: f64 = f.iter().zip(a).map(|(f, a)| (f - y * a).abs()).sum();
    (y * lo).max(y * hi) + rest
}

#[cfg(test)]
mod tests {
    use boxlp::{Problem, Solver};

    use super::one_row;

    /// Deterministic numbers in `[-1, 1]`.
    fn numbers(count: usize, seed: &mut u64) -> Vec<f64> {
        let mut next = || {
            *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        (0..count).map(|_| next()).collect()
    }

    #[test]
    fn the_closed_form_is_the_maximum() {
        let (mut seed, mut scratch) = (11, Vec::new());
        for case in 0..2_000 {
            let n = 1 + case % 9;
            let (f, mut a) = (numbers(n, &mut seed), numbers(n, &mut seed));
            if case % 5 == 0 {
                a[0] = 0.0;
            }
            // A range that some xi satisfies, without width now and then, one-sided now and then.
            let xi = numbers(n, &mut seed);
            let value: f64 = a.iter().zip(&xi).map(|(a, x)| a * x).sum();
            let norm: f64 = a.iter().map(|a| a.abs()).sum();
            let width = if case % 3 == 0 { 0.0 } else { 0.25 * norm };
            let (lo, hi) = (value - width, if case % 7 == 0 { norm } else { value + width });
            let mut problem = Problem::new(n).unwrap();
            problem.push_row(&a, lo, hi).unwrap();
            let exact = Solver::new(problem).maximize(&f).unwrap().bound;
            let closed = one_row(&f, &a, lo, hi, &mut scratch);
            assert!(
                (closed - exact).abs() < 1e-12 * (1.0 + norm),
                "case {case}: {closed} {exact} {f:?} {a:?} {lo} {hi}"
            );
        }
    }

    #[test]
    fn a_row_of_zeros_says_nothing() {
        assert_eq!(one_row(&[1.0, -2.0], &[0.0, 0.0], -1.0, 1.0, &mut Vec::new()), 3.0);
        assert_eq!(one_row(&[], &[], 0.0, 0.0, &mut Vec::new()), 0.0);
    }
}

//! What the gains promise, on random pairs.

use estimators::{Estimator, EstimatorError, Gain, f_radius_gain, observability_rank, place};
use nalgebra::{Complex, DMatrix, Matrix3, SMatrix};

use crate::support::{Random, cases, increment, vehicle_inzsmf};

/// `|| [(A - L C) H, -L V] ||_F^2`.
fn size(
    a: &Matrix3<f64>,
    h: &SMatrix<f64, 3, 6>,
    c: &SMatrix<f64, 2, 3>,
    v: &SMatrix<f64, 2, 3>,
    l: &SMatrix<f64, 3, 2>,
) -> f64 {
    ((a - l * c) * h).norm_squared() + (l * v).norm_squared()
}

/// The F-radius is a strictly convex quadratic in the gain: any change of the optimal gain by `E` adds exactly
/// `|E [C H, V]|_F^2`.
#[test]
fn the_f_radius_gain_minimises_the_f_radius() {
    let mut random = Random::new(1);
    for _ in 0..cases(1000) {
        let (a, h) = (random.matrix::<3, 3>(), random.matrix::<3, 6>());
        let (c, v) = (random.matrix::<2, 3>(), random.matrix::<2, 3>());
        let l = f_radius_gain(&a, &(h * h.transpose()), &c, &(v * v.transpose())).unwrap();
        let best = size(&a, &h, &c, &v, &l);
        let scale = a.norm_squared() * h.norm_squared();
        for exponent in [-6, -3, 0, 3] {
            let change: SMatrix<f64, 3, 2> = random.matrix() * 10f64.powi(exponent);
            let growth = size(&a, &h, &c, &v, &(l + change)) - best;
            let expected = (change * c * h).norm_squared() + (change * v).norm_squared();
            assert!((growth - expected).abs() <= 1e-8 * expected + 1e-11 * scale, "{growth:e} {expected:e}");
        }
    }
}

/// A random pair with the poles drawn for it.
fn random_placement(random: &mut Random) -> (DMatrix<f64>, DMatrix<f64>, Vec<Complex<f64>>) {
    let n = 1 + random.below(8);
    let p = 1 + random.below(n);
    let a = DMatrix::from_fn(n, n, |_, _| random.unit());
    let c = DMatrix::from_fn(p, n, |_, _| random.unit());
    let mut poles: Vec<Complex<f64>> = Vec::new();
    while poles.len() < n {
        let again = poles.last().copied().filter(|z| {
            let count = poles.iter().filter(|q| *q == z).count();
            count < p && random.below(3) == 0
        });
        let pole = again.unwrap_or_else(|| {
            let im = if random.below(2) == 0 { 0.0 } else { random.unit() };
            Complex::new(random.unit(), im)
        });
        if pole.im == 0.0 {
            poles.push(pole);
        } else if poles.len() + 2 <= n {
            poles.extend([pole.conj(), pole]);
        }
    }
    (a, c, poles)
}

/// Largest difference between `tr M^k` and the sum of the `k`-th powers of the poles, `k = 1..n`, relative to `max(1, |M|)^k`.
/// These sums fix the characteristic polynomial, so they agree if and only if the eigenvalues do.
fn power_sum_gap(matrix: &DMatrix<f64>, poles: &[Complex<f64>]) -> f64 {
    let (mut power, mut worst) = (DMatrix::identity(matrix.nrows(), matrix.nrows()), 0.0f64);
    for k in 1..=poles.len() as i32 {
        power = &power * matrix;
        let sum: Complex<f64> = poles.iter().map(|z| z.powi(k)).sum();
        worst = worst.max((power.trace() - sum).norm() / matrix.norm().max(1.0).powi(k));
    }
    worst
}

/// The eigenvalues of `A - L C` are the poles; the same input gives the same bits.
#[test]
fn placed_poles_are_eigenvalues() {
    let mut random = Random::new(2);
    let (mut placed, mut refused) = (0, 0);
    for _ in 0..cases(1000) {
        let (a, c, poles) = random_placement(&mut random);
        match place(&a, &c, &poles) {
            Ok(gain) => {
                placed += 1;
                assert!(power_sum_gap(&(&a - &gain * &c), &poles) < 1e-8, "{a}{c}{poles:?}");
                assert_eq!(gain, place(&a, &c, &poles).unwrap());
            }
            // One output leaves no choice; eight close poles can then be beyond f64.
            Err(EstimatorError::PlacementInaccurate { .. }) if a.nrows() > 4 => refused += 1,
            Err(error) => panic!("{error}: {a}{c}{poles:?}"),
        }
    }
    println!("{placed} placed, {refused} refused");
    assert!(refused * 100 <= placed);
}

/// With one output the gain is unique: Ackermann's formula `L = p(A) O^-1 e_n`.
#[test]
fn one_output_gives_ackermanns_gain() {
    let mut random = Random::new(3);
    for _ in 0..cases(200) {
        let a = DMatrix::from_fn(3, 3, |_, _| random.unit());
        let c = DMatrix::from_fn(1, 3, |_, _| random.unit());
        let (real, pair) = (random.unit(), Complex::new(random.unit(), 0.1 + random.unit().abs()));
        let gain = place(&a, &c, &[pair, Complex::new(real, 0.0), pair.conj()]).unwrap();
        let identity = DMatrix::identity(3, 3);
        let p_of_a = (&a - &identity * real) * (&a * &a - &a * (2.0 * pair.re) + &identity * pair.norm_sqr());
        let mut observability = DMatrix::zeros(3, 3);
        let mut row = c.clone();
        for i in 0..3 {
            observability.set_row(i, &row.row(0));
            row = &row * &a;
        }
        let unit = DMatrix::from_column_slice(3, 1, &[0.0, 0.0, 1.0]);
        let Some(solved) = observability.lu().solve(&unit) else { continue };
        let expected = p_of_a * &solved;
        assert!((&gain - &expected).norm() < 1e-9 * (1.0 + solved.norm()).powi(2), "{gain}{expected}");
    }
}

/// Rank of an observability matrix in block form: what is cut off from the outputs is not seen.
#[test]
fn the_observable_part_has_the_rank_it_was_built_with() {
    let mut random = Random::new(4);
    for _ in 0..cases(500) {
        let (seen, hidden) = (1 + random.below(4), random.below(4));
        let n = seen + hidden;
        let mut a = DMatrix::from_fn(n, n, |_, _| random.unit());
        a.view_mut((0, seen), (seen, hidden)).fill(0.0);
        let mut c = DMatrix::from_fn(1, n, |_, _| random.unit());
        c.columns_mut(seen, hidden).fill(0.0);
        // An orthogonal change of coordinates hides the zeros.
        let q = DMatrix::from_fn(n, n, |_, _| random.unit()).qr().q();
        let rank = observability_rank(&(&q * a * q.transpose()), &(c * q.transpose())).unwrap();
        assert_eq!(rank, seen);
    }
}

/// A placed gain is the fixed gain that `place` returns, step after step.
#[test]
fn placed_and_fixed_gains_agree() {
    let poles = [0.95, 0.98, 0.98];
    let fixed = SMatrix::<f64, 3, 2>::new(0.0, 0.0125, 0.02, 0.004, -0.004, 0.07);
    let mut by_poles = vehicle_inzsmf([0.0; 3], [1.0; 3]).with_gain(Gain::real_poles(poles));
    let mut by_gain = vehicle_inzsmf([0.0; 3], [1.0; 3]).with_gain(Gain::Fixed(fixed));
    for k in 0..100 {
        let y = [0.08 * f64::from(k), 0.5];
        by_poles.step(&increment(), &y).unwrap();
        by_gain.step(&increment(), &y).unwrap();
    }
    // The paper's gain belongs to A = I - dt ad_u; the exact A differs from it by 1.6e-4.
    let difference = by_poles.estimate().translation() - by_gain.estimate().translation();
    assert!(difference.norm() < 1e-2, "{difference}");
}

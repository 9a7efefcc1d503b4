//! Pole placement: the paper's gain, and gains of an independent implementation of the same method.

use estimators::{Gain, place};
use nalgebra::{Complex, DMatrix};

fn real(poles: &[f64]) -> Vec<Complex<f64>> {
    poles.iter().map(|re| Complex::new(*re, 0.0)).collect()
}

fn assert_close(gain: &DMatrix<f64>, expected: &[f64], tolerance: f64) {
    let expected = DMatrix::from_row_slice(gain.nrows(), gain.ncols(), expected);
    assert!((gain - &expected).amax() < tolerance, "{gain}{expected}");
}

fn position_outputs() -> DMatrix<f64> {
    DMatrix::from_row_slice(2, 3, &[0.0, 1.0, 0.0, 0.0, 0.0, 1.0])
}

/// The gain behind the InZSMF pole rows of paper 000, Table II: `A = I - dt ad_u`, poles .95 .98 .98.
#[test]
fn the_papers_invariant_gain() {
    let a = DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.004, 0.08, -0.004, 1.0]);
    let gain = place(&a, &position_outputs(), &real(&[0.95, 0.98, 0.98])).unwrap();
    assert_close(&gain, &[0.0, 0.0125, 0.02, 0.004, -0.004, 0.07], 1e-14);
}

/// The same poles for the ZSMF pair at a heading of 0.7 rad (SciPy 1.17 `place_poles`, YT, converged).
#[test]
fn the_papers_euclidean_gain() {
    let (sin, cos) = 0.7f64.sin_cos();
    let a = DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 0.0, -0.08 * sin, 1.0, 0.0, 0.08 * cos, 0.0, 1.0]);
    let gain = place(&a, &position_outputs(), &real(&[0.95, 0.98, 0.98])).unwrap();
    let expected = [
        -0.00805272109047113,
        0.0095605273410562,
        0.04075082142749398,
        -0.02463624324971154,
        -0.02463624324971148,
        0.0492491785725061,
    ];
    assert_close(&gain, &expected, 1e-12);
}

fn four_states() -> (DMatrix<f64>, DMatrix<f64>) {
    let a = [1.0, 0.1, 0.0, 0.0, 0.0, 1.0, 0.2, 0.0, 0.0, 0.0, 1.0, 0.1, 0.3, 0.0, 0.0, 0.9];
    let c = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    (DMatrix::from_row_slice(4, 4, &a), DMatrix::from_row_slice(2, 4, &c))
}

/// Four states and two outputs where the best eigenvectors are unique: real poles, a repeated pair (SciPy 1.17, converged to 1e-7).
#[test]
fn four_states_two_outputs() {
    let (a, c) = four_states();
    let gain = place(&a, &c, &real(&[0.5, 0.6, 0.7, 0.8])).unwrap();
    assert_close(&gain, &[0.8, 0.0, 1.5, 0.2, 0.0, 0.5, 0.3, 0.3], 1e-4);
    let z = Complex::new(0.5, 0.2);
    let gain = place(&a, &c, &[z, z.conj(), z, z.conj()]).unwrap();
    assert_close(&gain, &[1.0, 0.0, 2.9, 0.2, 0.0, 0.9, 0.3, 2.0], 1e-12);
}

/// `|det X|` of the unit left eigenvectors, for distinct poles.
fn eigenvector_determinant(matrix: &DMatrix<f64>, poles: &[Complex<f64>]) -> f64 {
    let columns: Vec<_> = poles
        .iter()
        .map(|pole| {
            let shifted = matrix.transpose().map(Complex::from) - DMatrix::identity(4, 4) * *pole;
            shifted.svd(false, true).v_t.unwrap().row(3).adjoint()
        })
        .collect();
    DMatrix::from_columns(&columns).determinant().norm()
}

/// Where several gains are equally good, ours is as good as the reference's: a pair with reals, two pairs (SciPy 1.17, converged).
#[test]
fn as_well_conditioned_as_the_reference() {
    let (a, c) = four_states();
    let (z, w) = (Complex::new(0.5, 0.2), Complex::new(0.3, 0.1));
    let (p, q) = (Complex::new(0.7, 0.0), Complex::new(0.8, 0.0));
    for (poles, reference) in
        [([z, z.conj(), p, q], 0.09409508973341997), ([z, z.conj(), w, w.conj()], 0.011769703820233856)]
    {
        let gain = place(&a, &c, &poles).unwrap();
        let det = eigenvector_determinant(&(&a - gain * &c), &poles);
        assert!(det > reference * (1.0 - 1e-6), "{det} {reference}");
    }
}

/// With every state measured the poles are those given, state by state.
#[test]
fn as_many_outputs_as_states() {
    let a = DMatrix::from_row_slice(2, 2, &[1.0, 0.5, -0.25, 2.0]);
    let gain = place(&a, &DMatrix::identity(2, 2), &real(&[0.5, 0.25])).unwrap();
    assert_close(&gain, &[0.5, 0.5, -0.25, 1.75], 1e-14);
}

#[test]
fn real_poles_are_complex_ones_on_the_axis() {
    assert_eq!(Gain::<2, 1>::real_poles([0.5, 0.25]), Gain::Poles([Complex::new(0.5, 0.0), Complex::new(0.25, 0.0)]));
}

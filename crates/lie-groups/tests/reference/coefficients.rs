//! The coefficient functions of `f64` against their series in double-double.

use lie_groups::{Coeff, Complex};
use nalgebra::Matrix2;

use crate::support::dense::Dense;
use crate::support::random::{Random, SEED, cases};

/// `z = i theta` as a matrix in double-double.
fn matrix_of(theta: f64) -> Dense {
    Dense::exact(&Matrix2::new(0.0, -theta, theta, 0.0))
}

/// Angles from the smallest number up to 20, a part of them next to the multiples of pi/2.
fn angle(random: &mut Random) -> f64 {
    match random.below(4) {
        0 => random.log_uniform(1e-320, 1e-9),
        1 => random.log_uniform(1e-9, 20.0),
        2 => random.uniform(-6.2, 6.2),
        _ => {
            let multiple = random.below(5) as f64 * std::f64::consts::FRAC_PI_2;
            // Closer to 2 pi, where phi_1 vanishes, the reference itself loses digits.
            multiple + random.log_uniform(1e-12, 1e-1)
        }
    }
}

#[test]
fn errors_relative_to_the_modulus() {
    let mut random = Random::new("coefficients");
    let mut worst = [0.0_f64; 5];
    let count = cases(20_000);
    for _ in 0..count {
        let theta = angle(&mut random);
        let z = matrix_of(theta);
        let mut check = |k: usize, exact: &Dense, computed: Complex<f64>| {
            let error = exact.error_of(&computed.to_matrix());
            assert!(error <= 2e-15, "function {k} at {theta:e}: {error:e}");
            worst[k] = worst[k].max(error);
        };
        let (turn, phi1) = f64::exp_phi1(theta);
        check(0, &z.phi(0), turn.unit());
        let exact_phi1 = z.phi(1);
        check(1, &exact_phi1, phi1);
        let (phi1, phi2) = f64::phi1_phi2(theta);
        check(1, &exact_phi1, phi1);
        check(2, &z.phi(2), phi2);
        if theta.abs() < 6.2 {
            let (psi1, psi2) = f64::psi1_psi2(theta).unwrap();
            let exact_psi1 = exact_phi1.inverse();
            check(3, &exact_psi1, psi1);
            check(4, &exact_psi1.multiply(&z.phi(2)), psi2);
        }
    }
    println!("{count} angles, seed {SEED:#x}, worst relative errors:");
    for (what, error) in ["e^z", "phi_1", "phi_2", "psi_1", "psi_2"].into_iter().zip(worst) {
        println!("    {what:8} {error:.1e}");
    }
}

/// At the smallest numbers nothing underflows to 0/0.
#[test]
fn exact_limits_at_zero() {
    for theta in [0.0, -0.0, 5e-324, -5e-324, f64::MIN_POSITIVE, 1e-200] {
        // Halving the angle may lose the last bit of a subnormal one.
        let (turn, phi1) = f64::exp_phi1(theta);
        assert!(turn.unit().re == 1.0 && (turn.unit().im - theta).abs() <= 5e-324);
        assert!(phi1.re == 1.0 && (phi1.im - 0.5 * theta).abs() <= 5e-324);
        let (phi1, phi2) = f64::phi1_phi2(theta);
        assert_eq!((phi1.re, phi2.re), (1.0, 0.5));
        let (psi1, psi2) = f64::psi1_psi2(theta).unwrap();
        assert_eq!((psi1.re, psi2.re), (1.0, 0.5));
        let direction = f64::direction(Complex::new(1.0, theta)).unwrap();
        assert_eq!(f64::log_psi1(&direction).unwrap(), (theta, Complex::new(1.0, -0.5 * theta)));
    }
}

//! exp, log, Jacobians and adjoint against dense `expm` and `phi_1` in double-double, at every scale of the rotation.

use lie_groups::{LieGroup, Rn, SE2, SO2};
use nalgebra::SVector;

use crate::support::dense::Dense;
use crate::support::random::{Random, SEED, cases};

/// Norm-wise relative errors may reach this; the worst ones are printed.
const BAR: f64 = 1e-14;

/// What is measured, in the order of the figures.
const WHAT: [&str; 8] = ["exp", "log exp", "Jl", "Jr", "Jl^-1", "Jr^-1", "Ad exp", "one-parameter subgroup"];

/// Error of a tangent vector, the rotation and the rest each relative to their own size.
fn tangent_error<const N: usize>(computed: &SVector<f64, N>, exact: &SVector<f64, N>) -> f64 {
    let difference = computed - exact;
    let head = difference[0].abs() / exact[0].abs();
    let rest = exact.rows(1, N - 1).norm();
    if rest == 0.0 { head } else { head.max(difference.rows(1, N - 1).norm() / rest) }
}

fn sweep<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(name: &str) {
    let mut random = Random::new(name);
    let mut worst = [0.0_f64; 8];
    let count = cases(10_000);
    for _ in 0..count {
        let xi: SVector<f64, N> = random.tangent(3.0);
        let element = G::exp(&xi);
        let ad = Dense::exact(&G::ad(&xi));
        let (jl, jr) = ad.phi_both_signs(1);
        let share = random.uniform(0.0, 1.0);
        let product = G::exp(&(xi * share)).compose(&G::exp(&(xi * (1.0 - share))));
        let errors = [
            Dense::exact(&G::hat(&xi)).phi(0).error_of(&element.matrix()),
            tangent_error(&element.log().unwrap(), &xi),
            jl.error_of(&G::jl(&xi)),
            jr.error_of(&G::jr(&xi)),
            jl.inverse().error_of(&G::jl_inv(&xi).unwrap()),
            jr.inverse().error_of(&G::jr_inv(&xi).unwrap()),
            ad.phi(0).error_of(&element.adjoint()),
            tangent_error(&product.log().unwrap(), &xi),
        ];
        for (k, error) in errors.into_iter().enumerate() {
            assert!(error <= BAR, "{name}: {} is off by {error:e} at {xi:?}", WHAT[k]);
            worst[k] = worst[k].max(error);
        }
    }
    println!("{name}: {count} samples, seed {SEED:#x}, worst relative errors:");
    for (what, error) in WHAT.into_iter().zip(worst) {
        println!("    {what:24} {error:.1e}");
    }
}

#[test]
fn so2_at_every_scale() {
    sweep::<SO2<f64>, 1, 2>("SO2");
}

#[test]
fn se2_at_every_scale() {
    sweep::<SE2<f64>, 3, 2>("SE2");
}

#[test]
fn rn_at_every_scale() {
    sweep::<Rn<f64, 4>, 4, 4>("R4");
}

/// The window in which widely used libraries lose digits: `(theta, u) = (1e-5, 0.3, 0.2)`, where one of them returns
/// a last column of `Jl^-1` that is 11 % off.
#[test]
fn small_but_not_tiny_angle() {
    let xi = nalgebra::Vector3::new(1e-5, 0.3, 0.2);
    let exact = Dense::exact(&<SE2<f64> as LieGroup<f64, 3, 2>>::ad(&xi)).phi(1).inverse();
    let error = exact.error_of(&SE2::jl_inv(&xi).unwrap());
    assert!(error < 4e-16, "{error:e}");
}

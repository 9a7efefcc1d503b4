//! exp, log, Jacobians and adjoint against dense `expm` and `phi_1` in double-double, at every scale of the rotation.

use lie_groups::{
    LieGroup, Rn, SE2, SE3, SE23, SO2, SO3, Sim2, Sim3, TfgLever2, TfgLever3, TfgScaleLever2, TfgScaleLever3,
};
use nalgebra::DVector;

use crate::support::dense::Dense;
use crate::support::erased::{Erased, Group};
use crate::support::random::{Random, SEED, cases};

/// Norm-wise relative errors may reach this; the worst ones are printed.
const BAR: f64 = 1e-14;

/// What is measured, in the order of the figures.
const WHAT: [&str; 8] = ["exp", "log exp", "Jl", "Jr", "Jl^-1", "Jr^-1", "Ad exp", "one-parameter subgroup"];

/// Error of a tangent vector: rotation, log-scale and the rest each relative to their own size.
fn tangent_error(kinds: &str, computed: &DVector<f64>, exact: &DVector<f64>) -> f64 {
    let parts: [&[char]; 3] = [&['r', 'w'], &['s'], &['x']];
    parts.iter().fold(0.0, |worst: f64, part| {
        let norm = |v: &DVector<f64>| {
            v.iter()
                .zip(kinds.chars())
                .filter(|(_, kind)| part.contains(kind))
                .fold(0.0, |sum, (x, _)| sum + x * x)
                .sqrt()
        };
        if norm(exact) == 0.0 { worst } else { worst.max(norm(&(computed - exact)) / norm(exact)) }
    })
}

fn sweep(name: &str, kinds: &str, group: &dyn Group<f64>, base: usize) {
    let mut random = Random::new(name);
    let mut worst = [0.0_f64; 8];
    let count = cases(base);
    for _ in 0..count {
        let xi = DVector::from_vec(random.tangent_of(kinds));
        let element = group.exp(&xi);
        let ad = Dense::exact(&group.ad(&xi));
        let (jl, jr) = ad.phi_both_signs(1);
        let share = random.uniform(0.0, 1.0);
        let product = group.compose(&group.exp(&(&xi * share)), &group.exp(&(&xi * (1.0 - share))));
        let errors = [
            Dense::exact(&group.hat(&xi)).phi(0).error_of(&group.matrix(&element)),
            tangent_error(kinds, &group.log(&element).unwrap(), &xi),
            jl.error_of(&group.jl(&xi)),
            jr.error_of(&group.jr(&xi)),
            jl.inverse().error_of(&group.jl_inv(&xi).unwrap()),
            jr.inverse().error_of(&group.jr_inv(&xi).unwrap()),
            ad.exp_from_phi1(&jl).error_of(&group.adjoint(&element)),
            tangent_error(kinds, &group.log(&product).unwrap(), &xi),
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

/// One test a group: `sweeps!(test name: Type, "kinds of coordinates", action dimension, samples)`.
macro_rules! sweeps {
    ($($test:ident: $group:ty, $kinds:literal, $d:literal, $count:literal;)*) => {$(
        #[test]
        fn $test() {
            sweep(stringify!($group), $kinds, &Erased::<$group, { $kinds.len() }, $d>::new(), $count);
        }
    )*};
}

sweeps! {
    so2_at_every_scale: SO2<f64>, "r", 2, 10_000;
    se2_at_every_scale: SE2<f64>, "rxx", 2, 10_000;
    rn_at_every_scale: Rn<f64, 4>, "xxxx", 4, 10_000;
    sim2_at_every_scale: Sim2<f64>, "rsxx", 2, 3_000;
    tfg_scale_lever2_at_every_scale: TfgScaleLever2<f64>, "rsxxxx", 2, 1_000;
    tfg_lever2_at_every_scale: TfgLever2<f64>, "rxxxx", 2, 1_000;
    so3_at_every_scale: SO3<f64>, "www", 3, 3_000;
    se3_at_every_scale: SE3<f64>, "wwwxxx", 3, 1_000;
    se23_at_every_scale: SE23<f64>, "wwwxxxxxx", 3, 300;
    sim3_at_every_scale: Sim3<f64>, "wwwsxxx", 3, 1_000;
    tfg_lever3_at_every_scale: TfgLever3<f64>, "wwwxxxxxx", 3, 300;
    tfg_scale_lever3_at_every_scale: TfgScaleLever3<f64>, "wwwsxxxxxx", 3, 300;
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

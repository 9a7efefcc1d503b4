//! Values of the groups for comparison with other libraries: one line `group;case;what;numbers`, matrices by rows.
//!
//! `benches/peers/groups_gtsam.py` reads them. Run: `cargo run --release -p lie-groups --example values`

use std::fmt::Write;

use lie_groups::{GroupError, LieGroup, SE2, SE3, SE23, SEK3, Sim2, Sim3};
use nalgebra::{DMatrix, SVector};

/// Sizes of the tangent vectors, from far below to around 1.
const SCALES: [f64; 7] = [1e-9, 1e-7, 1e-5, 1e-3, 1e-2, 0.3, 1.5];

fn line(out: &mut String, head: &str, what: &str, matrix: &DMatrix<f64>) {
    let numbers: Vec<String> = matrix.transpose().iter().map(|x| format!("{x:e}")).collect();
    let _ = writeln!(out, "{head};{what};{}", numbers.join(" "));
}

fn values<G: LieGroup<f64, N, D>, const N: usize, const D: usize>(name: &str) -> Result<String, GroupError> {
    let mut out = String::new();
    let column = |v: &SVector<f64, N>| DMatrix::from_column_slice(N, 1, v.as_slice());
    let square = |m: nalgebra::SMatrix<f64, N, N>| DMatrix::from_fn(N, N, |row, col| m[(row, col)]);
    for (case, scale) in SCALES.into_iter().enumerate() {
        // The golden ratio fills an interval evenly; every coordinate has the size of the case.
        let xi = SVector::<f64, N>::from_fn(|k, _| scale * (2.0 * ((k + 1) as f64 * 0.618_033_988_75).fract() - 1.0));
        let other = G::exp(&SVector::from_fn(|k, _| ((7 * k + 3) as f64 * 0.618_033_988_75).fract() - 0.5));
        let element = G::exp(&xi);
        let head = format!("{name};{case}");
        line(&mut out, &head, "xi", &column(&xi));
        line(&mut out, &head, "exp", &element.matrix());
        line(&mut out, &head, "log", &column(&element.log()?));
        line(&mut out, &head, "compose", &element.compose(&other).matrix());
        line(&mut out, &head, "inverse", &element.inverse().matrix());
        line(&mut out, &head, "adjoint", &square(element.adjoint()));
        line(&mut out, &head, "jr", &square(G::jr(&xi)));
        line(&mut out, &head, "jr_inv", &square(G::jr_inv(&xi)?));
        line(&mut out, &head, "other", &column(&other.log()?));
    }
    Ok(out)
}

fn main() -> Result<(), GroupError> {
    print!("{}", values::<SE2<f64>, 3, 2>("SE2")?);
    print!("{}", values::<SE3<f64>, 6, 3>("SE3")?);
    print!("{}", values::<SE23<f64>, 9, 3>("SE23")?);
    print!("{}", values::<SEK3<f64, 3, 12>, 12, 3>("SE33")?);
    print!("{}", values::<Sim2<f64>, 4, 2>("Sim2")?);
    print!("{}", values::<Sim3<f64>, 7, 3>("Sim3")?);
    Ok(())
}

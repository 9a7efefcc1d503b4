//! The laws, each a function over any group and scalar.

use lie_groups::LieGroup;
use nalgebra::{DMatrix, Dim, Matrix, RawStorage, SMatrix, SVector};

use crate::probe::{Probe, distance, size};
use crate::support::random::{Random, SEED, cases};

/// One test a law for a group: `laws!(module name: Type, tangent dimension, action dimension)`.
macro_rules! laws {
    ($name:ident: $group:ty, $n:literal, $d:literal) => {
        mod $name {
            use super::*;
            $crate::battery::laws!(@each $group, $n, $d: group_axioms, exp_and_log, one_parameter_subgroup,
                inverse_jacobians, left_from_right, jacobian_definition, adjoint_of_products, conjugation, bracket, hat_and_vee,
                matrix_form, action, action_derivative, interpolation);
        }
    };
    (@each $group:ty, $n:literal, $d:literal: $($law:ident),*) => {$(
        #[test]
        fn $law() {
            $crate::battery::run(concat!(stringify!($group), " ", stringify!($law)), $crate::battery::$law::<$group, _, $n, $d>);
        }
    )*};
}
pub(crate) use laws;

/// Runs a law on random elements and prints its worst relative error.
pub(crate) fn run(name: &str, law: impl Fn(&mut Random) -> f64) {
    let mut random = Random::new(name);
    let count = cases(2_000);
    let worst = (0..count).fold(0.0, |worst: f64, _| worst.max(law(&mut random)));
    println!("{name}: {count} cases, seed {SEED:#x}, worst relative error {worst:.1e}");
    assert!(worst <= 1e-13, "{name}: {worst:e}");
}

/// A tangent vector with log-uniform coordinates, rotation below 3.
fn tangent<S: Probe, const N: usize>(random: &mut Random) -> SVector<S, N> {
    random.tangent::<N>(3.0).map(S::from_f64)
}

fn element<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(random: &mut Random) -> G {
    G::exp(&tangent(random))
}

/// Distance of two elements, relative to the largest translation that went into them.
fn apart<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(a: &G, b: &G, scale: f64) -> f64 {
    distance(&a.matrix(), &b.matrix(), scale.max(size(&a.matrix())))
}

/// Product, for scalars that are no nalgebra field.
fn product<S, R, K, C, T, U>(a: &Matrix<S, R, K, T>, b: &Matrix<S, K, C, U>) -> DMatrix<S>
where
    S: Probe,
    R: Dim,
    K: Dim,
    C: Dim,
    T: RawStorage<S, R, K>,
    U: RawStorage<S, K, C>,
{
    DMatrix::from_fn(a.nrows(), b.ncols(), |row, col| {
        (0..a.ncols()).fold(S::zero(), |sum, k| sum + a[(row, k)] * b[(k, col)])
    })
}

fn identity<S: Probe>(n: usize) -> DMatrix<S> {
    DMatrix::from_fn(n, n, |row, col| if row == col { S::one() } else { S::zero() })
}

/// `(X Y) Z = X (Y Z)`, `X I = I X = X`, `X X^-1 = X^-1 X = I`.
pub(crate) fn group_axioms<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(random: &mut Random) -> f64 {
    let (x, y, z): (G, G, G) = (element(random), element(random), element(random));
    let scale = size(&x.matrix()) + size(&y.matrix()) + size(&z.matrix());
    let one = G::identity();
    [
        apart(&x.compose(&y).compose(&z), &x.compose(&y.compose(&z)), scale),
        apart(&x.compose(&one), &x, scale),
        apart(&one.compose(&x), &x, scale),
        apart(&x.compose(&x.inverse()), &one, scale),
        apart(&x.inverse().compose(&x), &one, scale),
    ]
    .into_iter()
    .fold(0.0, f64::max)
}

/// `log(exp(xi)) = xi` and `exp(log(X)) = X`.
pub(crate) fn exp_and_log<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(random: &mut Random) -> f64 {
    let xi: SVector<S, N> = tangent(random);
    let x = G::exp(&xi);
    let log = x.log().unwrap();
    distance(&log, &xi, size(&xi)).max(apart(&G::exp(&log), &x, 1.0))
}

/// `exp((s + t) xi) = exp(s xi) exp(t xi)` and `exp(-xi) = exp(xi)^-1`.
pub(crate) fn one_parameter_subgroup<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(
    random: &mut Random,
) -> f64 {
    let xi: SVector<S, N> = tangent(random);
    // Dyadic numbers, so that s + t is exact over f64 as well.
    let (s, t) = (random.below(64) as f64 / 32.0, -(random.below(64) as f64) / 32.0);
    let at = |time: f64| G::exp(&xi.map(|v| v.scale(time)));
    let scale = 2.0 * size(&xi);
    apart(&at(s).compose(&at(t)), &at(s + t), scale).max(apart(&at(-1.0), &at(1.0).inverse(), scale))
}

/// `Jl Jl^-1 = I` and `Jr Jr^-1 = I`.
pub(crate) fn inverse_jacobians<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(
    random: &mut Random,
) -> f64 {
    let xi: SVector<S, N> = tangent(random);
    let error = |j: SMatrix<S, N, N>, inverse: SMatrix<S, N, N>| {
        distance(&product(&j, &inverse), &identity(N), size(&j) * size(&inverse))
    };
    error(G::jl(&xi), G::jl_inv(&xi).unwrap()).max(error(G::jr(&xi), G::jr_inv(&xi).unwrap()))
}

/// `Jr(xi) = Jl(-xi)` and `Jl(xi) = Ad_exp(xi) Jr(xi)`.
pub(crate) fn left_from_right<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(
    random: &mut Random,
) -> f64 {
    let xi: SVector<S, N> = tangent(random);
    let (left, right) = (G::jl(&xi), G::jr(&xi));
    let mirrored = distance(&right, &G::jl(&xi.map(|v| -v)), size(&right));
    let adjoint = G::exp(&xi).adjoint();
    let turned = product(&adjoint, &right);
    let left = DMatrix::from_fn(N, N, |row, col| left[(row, col)]);
    mirrored.max(distance(&turned, &left, size(&adjoint) * size(&right)))
}

/// `log(exp(xi + d) exp(xi)^-1) = Jl d` and `log(exp(xi)^-1 exp(xi + d)) = Jr d`, by central differences; the error is
/// relative to `1 / step`, as rounding is in a difference quotient.
pub(crate) fn jacobian_definition<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(
    random: &mut Random,
) -> f64 {
    let step = 1e-5;
    let xi = SVector::<S, N>::from_fn(|_, _| S::from_f64(random.uniform(-3.0, 3.0)));
    let x = G::exp(&xi);
    let (left, right) = (G::jl(&xi), G::jr(&xi));
    let mut worst = 0.0_f64;
    for col in 0..N {
        let moved = |by: f64| {
            let mut moved = xi;
            moved[col] = moved[col].add_f64(by);
            G::exp(&moved)
        };
        let (ahead, behind) = (moved(step), moved(-step));
        for (jacobian, plus, minus) in [
            (&left, ahead.compose(&x.inverse()), behind.compose(&x.inverse())),
            (&right, x.inverse().compose(&ahead), x.inverse().compose(&behind)),
        ] {
            let (plus, minus) = (plus.log().unwrap(), minus.log().unwrap());
            for row in 0..N {
                let difference = (plus[row] - minus[row]).scale(0.5 / step);
                // Compared as numbers: the difference quotient is no enclosure of the derivative.
                worst = worst.max(step * (difference - jacobian[(row, col)]).size());
            }
        }
    }
    worst
}

/// `Ad_(X Y) = Ad_X Ad_Y` and `Ad_(X^-1) Ad_X = I`.
pub(crate) fn adjoint_of_products<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(
    random: &mut Random,
) -> f64 {
    let (x, y): (G, G) = (element(random), element(random));
    let (ad_x, ad_y, ad_xy) = (x.adjoint(), y.adjoint(), x.compose(&y).adjoint());
    let ad_xy = DMatrix::from_fn(N, N, |row, col| ad_xy[(row, col)]);
    let inverse = x.inverse().adjoint();
    distance(&ad_xy, &product(&ad_x, &ad_y), size(&ad_x) + size(&ad_y)).max(distance(
        &product(&inverse, &ad_x),
        &identity(N),
        size(&inverse) * size(&ad_x),
    ))
}

/// `X exp(xi) X^-1 = exp(Ad_X xi)`.
pub(crate) fn conjugation<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(random: &mut Random) -> f64 {
    let x: G = element(random);
    let xi: SVector<S, N> = tangent(random);
    let turned = product(&x.adjoint(), &xi);
    let direct = x.compose(&G::exp(&xi)).compose(&x.inverse());
    apart(&direct, &G::exp(&SVector::from_fn(|row, _| turned[row])), size(&x.matrix()) + size(&turned))
}

/// `hat(ad_xi eta) = hat(xi) hat(eta) - hat(eta) hat(xi)`.
pub(crate) fn bracket<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(random: &mut Random) -> f64 {
    let (xi, eta): (SVector<S, N>, SVector<S, N>) = (tangent(random), tangent(random));
    let (a, b) = (G::hat(&xi), G::hat(&eta));
    let (ab, ba) = (product(&a, &b), product(&b, &a));
    let commutator = ab.zip_map(&ba, |p, q| p - q);
    let image = product(&G::ad(&xi), &eta);
    distance(&G::hat(&SVector::from_fn(|row, _| image[row])), &commutator, size(&a) * size(&b))
}

/// `vee(hat(xi)) = xi`, exactly.
pub(crate) fn hat_and_vee<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(random: &mut Random) -> f64 {
    let xi: SVector<S, N> = tangent(random);
    if G::vee(&G::hat(&xi)) == Ok(xi) { 0.0 } else { f64::INFINITY }
}

/// `matrix(X Y) = matrix(X) matrix(Y)`, `matrix(I) = I`.
pub(crate) fn matrix_form<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(random: &mut Random) -> f64 {
    let (x, y): (G, G) = (element(random), element(random));
    let (mx, my) = (x.matrix(), y.matrix());
    let one = G::identity().matrix();
    let neutral = distance(&one, &identity(one.nrows()), 1.0);
    neutral.max(distance(&x.compose(&y).matrix(), &product(&mx, &my), size(&mx) + size(&my)))
}

/// The point in the coordinates of the matrix form: homogeneous unless the matrix acts directly.
fn lifted<S: Probe, const D: usize>(p: &SVector<S, D>, rows: usize, last: S) -> DMatrix<S> {
    DMatrix::from_fn(rows, 1, |row, _| if row < D { p[row] } else { last })
}

/// `X . p` is the matrix form applied to `p`, its linear part is `act_linear`, and `(X Y) . p = X . (Y . p)`.
pub(crate) fn action<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(random: &mut Random) -> f64 {
    let (x, y): (G, G) = (element(random), element(random));
    let p: SVector<S, D> = tangent(random);
    let matrix = x.matrix();
    let rows = matrix.nrows();
    let scale = size(&p) + size(&matrix) + size(&y.matrix());
    let by_matrix =
        distance(&lifted(&x.act(&p), rows, S::one()), &product(&matrix, &lifted(&p, rows, S::one())), scale);
    let moved = x.act(&p).zip_map(&x.act(&SVector::from_element(S::zero())), |a, b| a - b);
    let linear = product(&x.act_linear(), &p);
    let by_linear = distance(&DMatrix::from_fn(D, 1, |row, _| moved[row]), &linear, scale);
    by_matrix.max(by_linear).max(distance(&x.compose(&y).act(&p), &x.act(&y.act(&p)), scale))
}

/// Column `k` of `act_jacobian(p)` is `hat(e_k)` applied to `p`.
pub(crate) fn action_derivative<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(
    random: &mut Random,
) -> f64 {
    let p: SVector<S, D> = tangent(random);
    let jacobian = G::act_jacobian(&p);
    (0..N).fold(0.0, |worst: f64, col| {
        let generator = G::hat(&SVector::from_fn(|row, _| if row == col { S::one() } else { S::zero() }));
        let rows = generator.nrows();
        let column = SVector::<S, D>::from_fn(|row, _| jacobian[(row, col)]);
        worst.max(distance(
            &product(&generator, &lifted(&p, rows, S::one())),
            &lifted(&column, rows, S::zero()),
            size(&p),
        ))
    })
}

/// `interpolate` runs from `a` to `b`, at constant speed.
pub(crate) fn interpolation<G: LieGroup<S, N, D>, S: Probe, const N: usize, const D: usize>(
    random: &mut Random,
) -> f64 {
    let a: G = element(random);
    let xi: SVector<S, N> = tangent(random);
    let b = a.compose(&G::exp(&xi));
    let scale = size(&a.matrix()) + size(&xi);
    let at = |t: f64| G::interpolate(&a, &b, S::from_f64(t)).unwrap();
    let quarter = a.compose(&G::exp(&xi.map(|v| v.scale(0.25))));
    apart(&at(0.0), &a, scale).max(apart(&at(1.0), &b, scale)).max(apart(&at(0.25), &quarter, scale))
}

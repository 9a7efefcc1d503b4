//! The laws, each a function over any group and scalar.

use nalgebra::{DMatrix, DVector};

use crate::probe::{Probe, distance, size};
use crate::support::erased::{Element, Group};
use crate::support::random::{Random, SEED, cases};

/// A group to be tested: itself, its name and the kinds of its tangent coordinates (`Random::tangent_of`).
pub(crate) struct Subject<S> {
    pub(crate) name: &'static str,
    pub(crate) kinds: &'static str,
    pub(crate) group: Box<dyn Group<S>>,
}

/// One test a group: `laws!(test name: Type, "kinds of coordinates", action dimension)`.
macro_rules! laws {
    ($($test:ident: $group:ty, $kinds:literal, $d:literal;)*) => {$(
        #[test]
        fn $test() {
            let group = Box::new($crate::support::erased::Erased::<$group, { $kinds.len() }, $d>::new());
            $crate::battery::run_all(&$crate::battery::Subject { name: stringify!($group), kinds: $kinds, group });
        }
    )*};
}
pub(crate) use laws;

/// Runs every law on random elements and prints the worst relative error of each.
pub(crate) fn run_all<S: Probe>(subject: &Subject<S>) {
    type Law<S> = fn(&Subject<S>, &mut Random) -> f64;
    let laws: [(&str, Law<S>); 14] = [
        ("group axioms", group_axioms),
        ("exp and log", exp_and_log),
        ("one-parameter subgroup", one_parameter_subgroup),
        ("inverse Jacobians", inverse_jacobians),
        ("left from right", left_from_right),
        ("definition of the Jacobians", jacobian_definition),
        ("adjoint of products", adjoint_of_products),
        ("conjugation", conjugation),
        ("bracket", bracket),
        ("hat and vee", hat_and_vee),
        ("matrix form", matrix_form),
        ("action", action),
        ("derivative of the action", action_derivative),
        ("interpolation", interpolation),
    ];
    let (name, count) = (subject.name, cases(BASE));
    assert_eq!(subject.group.dims().0, subject.kinds.len());
    // A box of rotation vectors is widened by the condition of the maps (up to e^3 with a scale) in each of the two to five operations of a law.
    let bar = if subject.kinds.contains('w') { S::SPACE_BAR } else { 1e-13 };
    println!("{name}: {count} cases a law, seed {SEED:#x}, worst relative errors:");
    for (what, law) in laws {
        let mut random = Random::new(&format!("{name} {what}"));
        let worst = (0..count).fold(0.0, |worst: f64, _| worst.max(law(subject, &mut random)));
        println!("    {what:28} {worst:.1e}");
        assert!(worst <= bar, "{name}, {what}: {worst:e}");
    }
}

/// Random cases of a law.
const BASE: usize = 300;

/// A tangent vector with log-uniform coordinates, rotation and log-scale below 3.
fn tangent<S: Probe>(g: &Subject<S>, random: &mut Random) -> DVector<S> {
    DVector::from_iterator(g.kinds.len(), random.tangent_of(g.kinds).into_iter().map(S::from_f64))
}

fn element<S: Probe>(g: &Subject<S>, random: &mut Random) -> Element {
    g.group.exp(&tangent(g, random))
}

/// A point of the space acted on.
fn place<S: Probe>(g: &Subject<S>, random: &mut Random) -> DVector<S> {
    DVector::from_fn(g.group.dims().1, |_, _| S::from_f64(random.log_uniform(1e-3, 1e3)))
}

/// Distance of two elements, relative to the largest translation that went into them.
fn apart<S: Probe>(g: &Subject<S>, a: &Element, b: &Element, scale: f64) -> f64 {
    let (a, b) = (g.group.matrix(a), g.group.matrix(b));
    distance(&a, &b, scale.max(size(&a)))
}

/// Largest entry of the matrix form.
fn extent<S: Probe>(g: &Subject<S>, x: &Element) -> f64 {
    size(&g.group.matrix(x))
}

/// Product, for scalars that are no nalgebra field.
fn product<S: Probe>(a: &DMatrix<S>, b: &DMatrix<S>) -> DMatrix<S> {
    DMatrix::from_fn(a.nrows(), b.ncols(), |row, col| {
        (0..a.ncols()).fold(S::zero(), |sum, k| sum + a[(row, k)] * b[(k, col)])
    })
}

/// Product with a vector.
fn image<S: Probe>(a: &DMatrix<S>, v: &DVector<S>) -> DVector<S> {
    DVector::from_fn(a.nrows(), |row, _| (0..a.ncols()).fold(S::zero(), |sum, k| sum + a[(row, k)] * v[k]))
}

fn identity<S: Probe>(n: usize) -> DMatrix<S> {
    DMatrix::from_fn(n, n, |row, col| if row == col { S::one() } else { S::zero() })
}

/// `(X Y) Z = X (Y Z)`, `X I = I X = X`, `X X^-1 = X^-1 X = I`.
fn group_axioms<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let (x, y, z) = (element(g, random), element(g, random), element(g, random));
    let scale = extent(g, &x) + extent(g, &y) + extent(g, &z);
    let (xy, yz) = (g.group.compose(&x, &y), g.group.compose(&y, &z));
    let inner = extent(g, &xy) + extent(g, &yz);
    let (one, inverse) = (g.group.identity(), g.group.inverse(&x));
    let with_inverse = scale + extent(g, &inverse);
    [
        apart(g, &g.group.compose(&xy, &z), &g.group.compose(&x, &yz), scale + inner),
        apart(g, &g.group.compose(&x, &one), &x, scale),
        apart(g, &g.group.compose(&one, &x), &x, scale),
        apart(g, &g.group.compose(&x, &inverse), &one, with_inverse),
        apart(g, &g.group.compose(&inverse, &x), &one, with_inverse),
    ]
    .into_iter()
    .fold(0.0, f64::max)
}

/// `log(exp(xi)) = xi` and `exp(log(X)) = X`.
fn exp_and_log<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let xi = tangent(g, random);
    let x = g.group.exp(&xi);
    let log = g.group.log(&x).unwrap();
    distance(&log, &xi, size(&xi)).max(apart(g, &g.group.exp(&log), &x, size(&xi)))
}

/// `exp((s + t) xi) = exp(s xi) exp(t xi)` and `exp(-xi) = exp(xi)^-1`.
fn one_parameter_subgroup<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let xi = tangent(g, random);
    // Dyadic numbers, so that s + t is exact over f64 as well.
    let (s, t) = (random.below(64) as f64 / 32.0, -(random.below(64) as f64) / 32.0);
    let at = |time: f64| g.group.exp(&xi.map(|v| v.scale(time)));
    let scale = 2.0 * size(&xi) + extent(g, &at(s)) + extent(g, &at(t)) + extent(g, &at(-1.0)) + extent(g, &at(1.0));
    let subgroup = apart(g, &g.group.compose(&at(s), &at(t)), &at(s + t), scale);
    subgroup.max(apart(g, &at(-1.0), &g.group.inverse(&at(1.0)), scale))
}

/// `Jl Jl^-1 = I` and `Jr Jr^-1 = I`.
fn inverse_jacobians<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let xi = tangent(g, random);
    let error = |j: DMatrix<S>, inverse: DMatrix<S>| {
        distance(&product(&j, &inverse), &identity(j.nrows()), size(&j) * size(&inverse))
    };
    let left = error(g.group.jl(&xi), g.group.jl_inv(&xi).unwrap());
    left.max(error(g.group.jr(&xi), g.group.jr_inv(&xi).unwrap()))
}

/// `Jr(xi) = Jl(-xi)` and `Jl(xi) = Ad_exp(xi) Jr(xi)`.
fn left_from_right<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let xi = tangent(g, random);
    let (left, right) = (g.group.jl(&xi), g.group.jr(&xi));
    let mirrored = distance(&right, &g.group.jl(&xi.map(|v| -v)), size(&right));
    let adjoint = g.group.adjoint(&g.group.exp(&xi));
    mirrored.max(distance(&product(&adjoint, &right), &left, size(&adjoint) * size(&right)))
}

/// `log(exp(xi + d) exp(xi)^-1) = Jl d` and `log(exp(xi)^-1 exp(xi + d)) = Jr d`, by central differences; the error is
/// relative to `1 / step`, as rounding is in a difference quotient.
fn jacobian_definition<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let step = 1e-5;
    let group = &g.group;
    let xi = DVector::<S>::from_fn(g.kinds.len(), |_, _| S::from_f64(random.uniform(-1.5, 1.5)));
    let inverse = group.inverse(&group.exp(&xi));
    let (left, right) = (group.jl(&xi), group.jr(&xi));
    let mut worst = 0.0_f64;
    for col in 0..xi.len() {
        let moved = |by: f64| {
            let mut moved = xi.clone();
            moved[col] = moved[col].add_f64(by);
            group.exp(&moved)
        };
        let (ahead, behind) = (moved(step), moved(-step));
        for (jacobian, plus, minus) in [
            (&left, group.compose(&ahead, &inverse), group.compose(&behind, &inverse)),
            (&right, group.compose(&inverse, &ahead), group.compose(&inverse, &behind)),
        ] {
            let (plus, minus) = (group.log(&plus).unwrap(), group.log(&minus).unwrap());
            for row in 0..xi.len() {
                let difference = (plus[row] - minus[row]).scale(0.5 / step);
                // Compared as numbers: the difference quotient is no enclosure of the derivative.
                worst = worst.max(step * (difference - jacobian[(row, col)]).size());
            }
        }
    }
    worst
}

/// `Ad_(X Y) = Ad_X Ad_Y` and `Ad_(X^-1) Ad_X = I`.
fn adjoint_of_products<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let (x, y) = (element(g, random), element(g, random));
    let (ad_x, ad_y) = (g.group.adjoint(&x), g.group.adjoint(&y));
    let ad_xy = g.group.adjoint(&g.group.compose(&x, &y));
    let inverse = g.group.adjoint(&g.group.inverse(&x));
    let of_product = distance(&ad_xy, &product(&ad_x, &ad_y), size(&ad_x) * size(&ad_y));
    of_product.max(distance(&product(&inverse, &ad_x), &identity(ad_x.nrows()), size(&inverse) * size(&ad_x)))
}

/// `X exp(xi) X^-1 = exp(Ad_X xi)`.
fn conjugation<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let (x, xi) = (element(g, random), tangent(g, random));
    let turned = image(&g.group.adjoint(&x), &xi);
    let (step, inverse) = (g.group.exp(&xi), g.group.inverse(&x));
    let moved = g.group.compose(&x, &step);
    let direct = g.group.compose(&moved, &inverse);
    let inputs = extent(g, &x) * extent(g, &step) + extent(g, &moved) * extent(g, &inverse);
    apart(g, &direct, &g.group.exp(&turned), inputs + size(&turned) * extent(g, &step))
}

/// `hat(ad_xi eta) = hat(xi) hat(eta) - hat(eta) hat(xi)`.
fn bracket<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let (xi, eta) = (tangent(g, random), tangent(g, random));
    let (a, b) = (g.group.hat(&xi), g.group.hat(&eta));
    let (ab, ba) = (product(&a, &b), product(&b, &a));
    let commutator = ab.zip_map(&ba, |p, q| p - q);
    distance(&g.group.hat(&image(&g.group.ad(&xi), &eta)), &commutator, size(&a) * size(&b))
}

/// `vee(hat(xi)) = xi`, exactly.
fn hat_and_vee<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let xi = tangent(g, random);
    if g.group.vee(&g.group.hat(&xi)) == Ok(xi) { 0.0 } else { f64::INFINITY }
}

/// `matrix(X Y) = matrix(X) matrix(Y)`, `matrix(I) = I`.
fn matrix_form<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let (x, y) = (element(g, random), element(g, random));
    let (mx, my) = (g.group.matrix(&x), g.group.matrix(&y));
    let one = g.group.matrix(&g.group.identity());
    let neutral = distance(&one, &identity(one.nrows()), 1.0);
    // The body vectors of the product turn forth and back.
    let scale = size(&mx) * size(&my);
    neutral.max(distance(&g.group.matrix(&g.group.compose(&x, &y)), &product(&mx, &my), scale))
}

/// The point in the coordinates of the matrix form: homogeneous unless the matrix acts directly.
fn lifted<S: Probe>(p: &DVector<S>, rows: usize, last: S) -> DMatrix<S> {
    let d = p.len();
    DMatrix::from_fn(rows, 1, |row, _| match row {
        row if row < d => p[row],
        row if row == d => last,
        _ => S::zero(),
    })
}

/// `X . p` is the matrix form applied to `p`, its linear part is `act_linear`, and `(X Y) . p = X . (Y . p)`.
fn action<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let (x, y, p) = (element(g, random), element(g, random), place(g, random));
    let matrix = g.group.matrix(&x);
    let rows = matrix.nrows();
    let both = g.group.compose(&x, &y);
    let scale = size(&p) * size(&matrix) * extent(g, &y);
    let lift = |p: &DVector<S>| lifted(p, rows, S::one());
    let by_matrix = distance(&lift(&g.group.act(&x, &p)), &product(&matrix, &lift(&p)), scale);
    let origin = g.group.act(&x, &p.map(|_| S::zero()));
    let moved = g.group.act(&x, &p).zip_map(&origin, |a, b| a - b);
    let by_linear = distance(&moved, &image(&g.group.act_linear(&x), &p), scale);
    let in_turn = g.group.act(&x, &g.group.act(&y, &p));
    by_matrix.max(by_linear).max(distance(&g.group.act(&both, &p), &in_turn, scale))
}

/// Column `k` of `act_jacobian(p)` is `hat(e_k)` applied to `p`.
fn action_derivative<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let p = place(g, random);
    let jacobian = g.group.act_jacobian(&p);
    let n = g.kinds.len();
    (0..n).fold(0.0, |worst: f64, col| {
        let generator = g.group.hat(&DVector::from_fn(n, |row, _| if row == col { S::one() } else { S::zero() }));
        let rows = generator.nrows();
        let column = DVector::from_fn(p.len(), |row, _| jacobian[(row, col)]);
        let exact = product(&generator, &lifted(&p, rows, S::one()));
        worst.max(distance(&exact, &lifted(&column, rows, S::zero()), size(&p)))
    })
}

/// `interpolate` runs from `a` to `b`, at constant speed.
fn interpolation<S: Probe>(g: &Subject<S>, random: &mut Random) -> f64 {
    let (a, xi) = (element(g, random), tangent(g, random));
    let step = g.group.exp(&xi);
    let b = g.group.compose(&a, &step);
    let inverse = g.group.inverse(&a);
    let scale = extent(g, &a) * size(&xi) * extent(g, &step) + extent(g, &inverse) * extent(g, &b);
    let at = |t: f64| g.group.interpolate(&a, &b, S::from_f64(t)).unwrap();
    let quarter = g.group.compose(&a, &g.group.exp(&xi.map(|v| v.scale(0.25))));
    let ends = apart(g, &at(0.0), &a, scale).max(apart(g, &at(1.0), &b, scale));
    ends.max(apart(g, &at(0.25), &quarter, scale))
}

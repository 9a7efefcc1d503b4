//! The groups of space where enclosures are hardest: next to half and full turns, at angles whose squares underflow, with sets without or with great widths, empty or
//! unbounded, and after many products.

use lie_groups::{LieGroup, SE3, SO3, ScaledSO3, Sim3, TfgScaleLever3};
use nalgebra::{DVector, Vector3};
use scalars::Interval;

use crate::boxes::interval;
use crate::support::dense::Dense;
use crate::support::erased::{Erased, Group};
use crate::support::random::{Random, cases};

const PI: f64 = std::f64::consts::PI;

fn pick(random: &mut Random, values: &[f64]) -> f64 {
    values[random.below(values.len() as u64) as usize]
}

/// A rotation vector of a length next to where something changes, along or next to an axis or not.
fn rotation(random: &mut Random) -> [f64; 3] {
    let lengths =
        [0.0, 1e-300, 1e-160, 1e-8, 1e-3, 1.0, 3.1, PI - 1e-9, PI, PI + 1e-9, 5.0, 2.0 * PI - 1e-6, 2.0 * PI, 8.0];
    let length = pick(random, &lengths);
    let axis: [f64; 3] = match random.below(3) {
        0 => [0.0, 1.0, 0.0],
        1 => [1.0, 1e-9, -1e-170],
        _ => std::array::from_fn(|_| random.uniform(-1.0, 1.0)),
    };
    let norm = axis.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-3);
    axis.map(|x| x / norm * length)
}

fn tangents(random: &mut Random, kinds: &str) -> DVector<Interval> {
    let mut axis = rotation(random).into_iter();
    let width = pick(random, &[0.0, 1e-300, 1e-15, 1e-8, 1e-2, 0.5, 2.0]);
    let ranges = kinds.chars().map(|kind| {
        let center = match kind {
            'w' => axis.next().unwrap(),
            's' => pick(random, &[0.0, 1e-200, 1e-9, 0.99, 1.01, -3.0, 5.0]),
            _ => pick(random, &[0.0, 1e-200, 1.0, -1e5]),
        };
        let width = if random.below(3) == 0 { 0.0 } else { width };
        let share = pick(random, &[0.0, 0.5, 1.0]);
        interval(center - share * width, center + (1.0 - share) * width)
    });
    DVector::from_vec(ranges.collect())
}

fn point_of(random: &mut Random, bounds: &DVector<Interval>) -> DVector<f64> {
    bounds.map(|x| match random.below(4) {
        0 => x.lo(),
        1 => x.hi(),
        _ => random.uniform(x.lo(), x.hi()),
    })
}

struct Subject {
    name: &'static str,
    kinds: &'static str,
    point: Box<dyn Group<f64>>,
    boxed: Box<dyn Group<Interval>>,
}

fn subjects() -> Vec<Subject> {
    macro_rules! subject {
        ($group:ident, $kinds:literal) => {
            Subject {
                name: stringify!($group),
                kinds: $kinds,
                point: Box::new(Erased::<$group<f64>, { $kinds.len() }, 3>::new()),
                boxed: Box::new(Erased::<$group<Interval>, { $kinds.len() }, 3>::new()),
            }
        };
    }
    vec![
        subject!(SO3, "www"),
        subject!(ScaledSO3, "wwws"),
        subject!(SE3, "wwwxxx"),
        subject!(Sim3, "wwwsxxx"),
        subject!(TfgScaleLever3, "wwwsxxxxxx"),
    ]
}

#[test]
fn hard_boxes_of_space_are_contained() {
    for g in subjects() {
        let mut random = Random::new(&format!("{} hard", g.name));
        let (mut all, mut logs, mut inverses) = (0, 0, 0);
        for _ in 0..cases(60) {
            let (bx, by) = (tangents(&mut random, g.kinds), tangents(&mut random, g.kinds));
            let (x, y) = (g.boxed.exp(&bx), g.boxed.exp(&by));
            let product = g.boxed.compose(&g.boxed.inverse(&x), &y);
            let log = g.boxed.log(&product);
            let again = log.as_ref().ok().map(|log| g.boxed.matrix(&g.boxed.exp(log)));
            let (jl, jr) = (g.boxed.jl(&bx), g.boxed.jr(&bx));
            let inverse = g.boxed.jl_inv(&bx).ok().zip(g.boxed.jr_inv(&bx).ok());
            let (adjoint, matrix, matrix_product) = (g.boxed.adjoint(&x), g.boxed.matrix(&x), g.boxed.matrix(&product));
            for _ in 0..4 {
                let (xi, eta) = (point_of(&mut random, &bx), point_of(&mut random, &by));
                let judge = |what: &str, escape: Option<(usize, usize)>| {
                    assert!(
                        escape.is_none(),
                        "{}: {what} of {xi:?} in {bx:?}, {eta:?} in {by:?} escapes at {escape:?}",
                        g.name
                    );
                };
                let (mx, my) = (Dense::exact(&g.point.hat(&-&xi)).phi(0), Dense::exact(&g.point.hat(&eta)).phi(0));
                let both = mx.multiply(&my);
                judge("exp", Dense::exact(&g.point.hat(&xi)).phi(0).escapes_computed(&matrix));
                judge("product", both.escapes_computed(&matrix_product));
                if let Some(again) = &again {
                    judge("log", both.escapes_computed(again));
                    logs += 1;
                }
                let ad = Dense::exact(&g.point.ad(&xi));
                let (left, right) = ad.phi_both_signs(1);
                judge("Ad", ad.exp_from_phi1(&left).escapes_computed(&adjoint));
                judge("Jl", left.escapes_computed(&jl));
                judge("Jr", right.escapes_computed(&jr));
                if let Some((jl_inv, jr_inv)) = &inverse {
                    judge("Jl^-1", left.inverse().escapes_computed(jl_inv));
                    judge("Jr^-1", right.inverse().escapes_computed(jr_inv));
                    inverses += 1;
                }
                all += 1;
            }
        }
        println!("{}: {all} points, {logs} through log, {inverses} through inverses", g.name);
    }
}

/// Sets that are empty, unbounded, or too large for any sense: no panic, and nothing bounded where nothing is known.
#[test]
fn no_set_of_space_is_refused_by_a_panic() {
    let far = [
        Interval::EMPTY,
        Interval::ENTIRE,
        interval(0.0, 1.0),
        interval(-1e308, 1e308),
        Interval::point(1e99),
        Interval::point(-1e160),
        Interval::point(5e-324),
        Interval::new(2.0, f64::INFINITY).unwrap(),
        interval(-5e-324, f64::MIN_POSITIVE),
    ];
    let mut count = 0;
    for g in subjects() {
        let n = g.kinds.len();
        let mut random = Random::new(g.name);
        for k in 0..cases(150) {
            let a = far[k % far.len()];
            let b = far[(k / far.len()) % far.len()];
            let at = random.below(n as u64) as usize;
            let v = DVector::from_fn(n, |i, _| {
                if i == at {
                    a
                } else if random.below(3) == 0 {
                    b
                } else {
                    Interval::point(0.1)
                }
            });
            let x = g.boxed.exp(&v);
            let y = g.boxed.exp(&v.map(|x| -x));
            let p = g.boxed.compose(&x, &y);
            let _ = (
                g.boxed.log(&x).is_ok(),
                g.boxed.log(&p).is_ok(),
                g.boxed.jl_inv(&v).is_ok(),
                g.boxed.jr_inv(&v).is_ok(),
            );
            let _ = (g.boxed.jl(&v), g.boxed.jr(&v), g.boxed.ad(&v), g.boxed.adjoint(&p), g.boxed.act_linear(&p));
            let (m, q) = (g.boxed.matrix(&x), g.boxed.matrix(&p));
            let _ = g.boxed.interpolate(&x, &p, Interval::point(0.5)).is_ok();
            if v.iter().any(Interval::is_empty) {
                assert!(m.iter().any(Interval::is_empty) && g.boxed.log(&x).is_err(), "{}: {v:?} {m:?}", g.name);
            } else {
                for i in 0..m.nrows() {
                    assert!(q[(i, i)].contains(1.0), "{}: {v:?} {q:?}", g.name);
                    for j in 0..m.ncols() {
                        assert!(i == j || q[(i, j)].contains(0.0), "{}: {v:?} {q:?}", g.name);
                    }
                }
            }
            count += 1;
        }
    }
    println!("{count} sets");
}

/// Turns about an axis by angles of any size.
#[test]
fn huge_turns_about_an_axis() {
    let mut random = Random::new("huge turns");
    for power in 0..110 {
        let theta = 10_f64.powi(power) * random.uniform(-1.0, 1.0);
        let (sin, cos) = Interval::point(theta).sin_cos();
        let w = Vector3::new(Interval::ZERO, Interval::ZERO, Interval::point(theta));
        let m = SO3::exp(&w).rotation_matrix();
        assert!(!m[(0, 0)].disjoint(&cos) && !m[(1, 0)].disjoint(&sin), "{theta:e}");
        let jl = SO3::jl(&w);
        let point = Interval::point(theta);
        assert!(
            !jl[(0, 0)].disjoint(&(sin / point)) && !jl[(1, 0)].disjoint(&((Interval::ONE - cos) / point)),
            "{theta:e}"
        );
    }
}

/// Many factors, forth and back, of widths up to all rotations, through matrices and quaternions.
#[test]
fn long_products_of_space_are_contained() {
    let mut random = Random::new("long products");
    let group = Erased::<SO3<f64>, 3, 3>::new();
    let group: &dyn Group<f64> = &group;
    for width in [0.0, 1e-15, 1e-8, 1e-3, 3e-2] {
        let mut set = SO3::<Interval>::identity();
        let mut exact = Dense::identity(3);
        for k in 0..cases(60) {
            let w = rotation(&mut random);
            let bounds = Vector3::from_fn(|i, _| interval(w[i] - width, w[i] + width));
            let point = DVector::from_fn(3, |i, _| if random.below(2) == 0 { bounds[i].lo() } else { bounds[i].hi() });
            let factor = SO3::exp(&bounds);
            let m = Dense::exact(&group.hat(&point)).phi(0);
            if random.below(2) == 0 {
                set = set.compose(&factor);
                exact = exact.multiply(&m);
            } else {
                set = factor.inverse().compose(&set);
                exact = Dense::exact(&group.hat(&-&point)).phi(0).multiply(&exact);
            }
            let matrix = set.rotation_matrix();
            assert_eq!(exact.escapes_computed(&matrix), None, "width {width}, factor {k}");
            let again = SO3::from_matrix(&matrix).unwrap();
            assert_eq!(exact.escapes_computed(&again.rotation_matrix()), None, "width {width}, factor {k}, matrix");
            let [a, b, c, d] = set.quaternion();
            let by_quaternion = SO3::from_quaternion(a, b, c, d).unwrap();
            assert_eq!(exact.escapes_computed(&by_quaternion.rotation_matrix()), None, "width {width}, factor {k}");
            match random.below(8) {
                0 => set = again,
                1 => set = by_quaternion,
                _ => {}
            }
            if let Ok(log) = set.log() {
                assert_eq!(
                    exact.escapes_computed(&SO3::exp(&log).rotation_matrix()),
                    None,
                    "width {width}, factor {k}, log"
                );
            }
        }
        println!("width {width:e}: radius {:e}", set.spin().radius());
    }
}

/// Accuracy over `f64`, in units of `2^-53` of the largest entry.
#[test]
fn accuracy_at_hard_places() {
    for g in subjects() {
        let mut random = Random::new(&format!("{} accuracy", g.name));
        let mut worst = [(0.0_f64, 0.0_f64); 5];
        for _ in 0..cases(600) {
            let t = match random.below(4) {
                0 => PI - random.log_uniform(1e-12, 1e-2).abs(),
                1 => PI + random.log_uniform(1e-12, 1e-2).abs(),
                2 => random.log_uniform(1e-12, 3.0).abs(),
                _ => random.uniform(3.0, 6.0),
            };
            let axis: [f64; 3] = std::array::from_fn(|_| random.uniform(-1.0, 1.0));
            let norm = axis.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-3);
            let mut axis = axis.into_iter();
            let xi = DVector::from_iterator(
                g.kinds.len(),
                g.kinds.chars().map(|kind| match kind {
                    'w' => axis.next().unwrap() * t / norm,
                    's' => random.log_uniform(1e-12, 3.0),
                    _ => random.uniform(-1.0, 1.0),
                }),
            );
            let x = g.point.exp(&xi);
            let m = Dense::exact(&g.point.hat(&xi)).phi(0);
            let left = Dense::exact(&g.point.ad(&xi)).phi(1);
            let mut note = |k: usize, error: f64| {
                let units = error / 2.0_f64.powi(-53);
                if units > worst[k].0 || units.is_nan() {
                    worst[k] = (units, t);
                }
            };
            note(0, m.error_of(&g.point.matrix(&x)));
            note(1, left.error_of(&g.point.jl(&xi)));
            note(2, left.inverse().error_of(&g.point.jl_inv(&xi).unwrap()));
            let w = xi.rows(0, 3).norm();
            if w < PI {
                let log = g.point.log(&x).unwrap();
                // Relative to the length of each kind of part.
                note(3, (log.rows(0, 3) - xi.rows(0, 3)).norm() / w);
                note(4, (&log - &xi).norm() / xi.norm());
            }
        }
        println!("{}: exp, Jl, Jl^-1, rotation of log, log: {worst:.1?}", g.name);
        assert!(worst.iter().all(|(units, _)| *units < 1e4), "{}: {worst:?}", g.name);
    }
}

//! The two-frame groups over intervals: exact images of the points of a box lie in the enclosures, for functions of tangent vectors and for the
//! operations on elements.

use lie_groups::{
    GroupError, SE3, SE23, SO3, ScaledSO3, Sim2, Sim3, TfgLever2, TfgLever3, TfgScaleLever2, TfgScaleLever3,
};
use nalgebra::{DMatrix, DVector, SMatrix};
use scalars::Interval;

use crate::boxes::{angles, interval};
use crate::support::dense::Dense;
use crate::support::erased::{Erased, Group};
use crate::support::random::{Random, SEED, cases};

/// Points per box.
const POINTS: usize = 10;

/// A radius: zero, tiny or up to `widest`.
fn radius(random: &mut Random, widest: f64) -> f64 {
    match random.below(4) {
        0 => 0.0,
        1 => random.log_uniform(1e-18, 1e-3).abs(),
        _ => random.log_uniform(1e-3, widest).abs(),
    }
}

/// A box of tangent vectors by the kinds of its coordinates; boxes of rotation vectors of one width in all directions, or of different ones.
fn tangents(random: &mut Random, kinds: &str) -> DVector<Interval> {
    let length = if random.below(3) == 0 { random.uniform(0.0, 5.0) } else { random.log_uniform(1e-15, 3.0).abs() };
    let axis: [f64; 3] = std::array::from_fn(|_| random.uniform(-1.0, 1.0));
    let norm = axis.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-3);
    let mut axis = axis.into_iter();
    let widest = if random.below(8) == 0 { 2.0 } else { 0.3 };
    let ranges = kinds.chars().map(|kind| {
        let (center, widest) = match kind {
            'r' => return angles(random),
            'w' => (axis.next().unwrap() * length / norm, widest),
            's' => (random.log_uniform(1e-9, 3.0), widest),
            _ => (if random.below(4) == 0 { 0.0 } else { random.log_uniform(1e-6, 1e3) }, 100.0),
        };
        let radius = radius(random, widest);
        interval(center - radius, center + radius)
    });
    DVector::from_vec(ranges.collect())
}

fn point_of(random: &mut Random, bounds: &DVector<Interval>) -> DVector<f64> {
    bounds.map(|x| match random.below(8) {
        0 => x.lo(),
        1 => x.hi(),
        _ => random.uniform(x.lo(), x.hi()),
    })
}

/// Length of the longest rotation vector of a box.
fn longest_turn(kinds: &str, bounds: &DVector<Interval>) -> f64 {
    bounds
        .iter()
        .zip(kinds.chars())
        .filter(|(_, k)| "rw".contains(*k))
        .map(|(x, _)| x.mag() * x.mag())
        .sum::<f64>()
        .sqrt()
}

struct Subject {
    name: &'static str,
    kinds: &'static str,
    point: Box<dyn Group<f64>>,
    boxed: Box<dyn Group<Interval>>,
}

fn functions(g: &Subject, count: usize) {
    let mut random = Random::new(&format!("{} functions", g.name));
    let (mut all, mut inverses) = (0, 0);
    while all < count {
        let bounds = tangents(&mut random, g.kinds);
        let element = g.boxed.exp(&bounds);
        let (exp, adjoint) = (g.boxed.matrix(&element), g.boxed.adjoint(&element));
        let (jl, jr) = (g.boxed.jl(&bounds), g.boxed.jr(&bounds));
        let inverse = match (g.boxed.jl_inv(&bounds), g.boxed.jr_inv(&bounds)) {
            (Ok(left), Ok(right)) => Some((left, right)),
            (Err(GroupError::FullTurn { .. }), Err(GroupError::FullTurn { .. })) => {
                assert!(longest_turn(g.kinds, &bounds) > std::f64::consts::TAU - 1e-9, "{bounds:?}");
                None
            }
            other => panic!("{} at {bounds:?}: {other:?}", g.name),
        };
        for _ in 0..POINTS {
            let xi = point_of(&mut random, &bounds);
            let judge = |what: &str, escape: Option<(usize, usize)>| {
                assert!(escape.is_none(), "{}: {what} of {xi:?} in {bounds:?} escapes at {escape:?}", g.name);
            };
            judge("exp", Dense::exact(&g.point.hat(&xi)).phi(0).escapes(&exp));
            let ad = Dense::exact(&g.point.ad(&xi));
            let (left, right) = ad.phi_both_signs(1);
            judge("Ad exp", ad.exp_from_phi1(&left).escapes(&adjoint));
            judge("Jl", left.escapes(&jl));
            judge("Jr", right.escapes(&jr));
            all += 1;
            if let Some((jl_inv, jr_inv)) = &inverse {
                judge("Jl^-1", left.inverse().escapes_computed(jl_inv));
                judge("Jr^-1", right.inverse().escapes_computed(jr_inv));
                inverses += 1;
            }
        }
    }
    println!("{}: seed {SEED:#x}, {all} points through exp, Ad, Jl, Jr, {inverses} through the inverses", g.name);
}

fn operations(g: &Subject, count: usize) {
    let mut random = Random::new(&format!("{} operations", g.name));
    let (mut all, mut logs) = (0, 0);
    while all < count {
        let (bx, by) = (tangents(&mut random, g.kinds), tangents(&mut random, g.kinds));
        let (x, y) = (g.boxed.exp(&bx), g.boxed.exp(&by));
        let product = g.boxed.compose(&x, &y);
        let results = [
            ("product", g.boxed.matrix(&product)),
            ("inverse", g.boxed.matrix(&g.boxed.inverse(&x))),
            ("product of three", g.boxed.matrix(&g.boxed.compose(&g.boxed.inverse(&y), &product))),
        ];
        let log = g.boxed.log(&x).ok();
        let d = g.point.dims().1;
        let place = DVector::from_fn(d, |_, _| random.log_uniform(1e-3, 1e3));
        let moved = g.boxed.act(&x, &place.map(Interval::point));
        for _ in 0..POINTS {
            let (xi, eta) = (point_of(&mut random, &bx), point_of(&mut random, &by));
            let exp = |v: &DVector<f64>| Dense::exact(&g.point.hat(v)).phi(0);
            let (mx, my) = (exp(&xi), exp(&eta));
            let both = mx.multiply(&my);
            let exact = [both.clone(), exp(&-&xi), exp(&-&eta).multiply(&both)];
            for ((what, bounds), exact) in results.iter().zip(&exact) {
                let escape = exact.escapes_computed(bounds);
                assert!(
                    escape.is_none(),
                    "{}: {what} of {xi:?} in {bx:?} and {eta:?} in {by:?} escapes at {escape:?}",
                    g.name
                );
            }
            if let Some(log) = &log {
                // The log has the angle in (-pi, pi): that of a larger angle is another vector.
                if longest_turn(g.kinds, &xi.map(Interval::point)) < std::f64::consts::PI {
                    assert!(
                        xi.iter().zip(log.iter()).all(|(&v, range)| range.contains(v)),
                        "{}: {xi:?} is not in {log:?}",
                        g.name
                    );
                    logs += 1;
                }
            }
            let lifted = Dense::from_fn(mx.size, |row, _| match row {
                row if row < d => place[row].into(),
                row if row == d => 1.0.into(),
                _ => 0.0.into(),
            });
            let image = mx.multiply(&lifted);
            assert!(
                (0..d).all(|row| image.get(row, 0).in_interval(&moved[row])),
                "{}: {place:?} leaves {moved:?}",
                g.name
            );
            all += 1;
        }
    }
    println!("{}: seed {SEED:#x}, {all} points through the operations, {logs} through log", g.name);
}

macro_rules! contained {
    ($($test:ident: $group:ident, $kinds:literal, $d:literal, $count:literal;)*) => {$(
        #[test]
        fn $test() {
            let subject = Subject {
                name: stringify!($group),
                kinds: $kinds,
                point: Box::new(Erased::<$group<f64>, { $kinds.len() }, $d>::new()),
                boxed: Box::new(Erased::<$group<Interval>, { $kinds.len() }, $d>::new()),
            };
            functions(&subject, cases($count));
            operations(&subject, cases($count));
        }
    )*};
}

contained! {
    sim2_contains_exact_images: Sim2, "rsxx", 2, 5_000;
    tfg_lever2_contains_exact_images: TfgLever2, "rxxxx", 2, 5_000;
    tfg_scale_lever2_contains_exact_images: TfgScaleLever2, "rsxxxx", 2, 2_000;
    so3_contains_exact_images: SO3, "www", 3, 5_000;
    scaled_so3_contains_exact_images: ScaledSO3, "wwws", 3, 2_000;
    se3_contains_exact_images: SE3, "wwwxxx", 3, 2_000;
    se23_contains_exact_images: SE23, "wwwxxxxxx", 3, 1_000;
    sim3_contains_exact_images: Sim3, "wwwsxxx", 3, 1_000;
    tfg_lever3_contains_exact_images: TfgLever3, "wwwxxxxxx", 3, 1_000;
    tfg_scale_lever3_contains_exact_images: TfgScaleLever3, "wwwsxxxxxx", 3, 1_000;
}

/// All rotations whose matrix lies in the hull of some have the enclosure's matrices and rotation vectors.
#[test]
fn matrices_and_quaternions_of_rotations() {
    let mut random = Random::new("rotation matrices");
    let group = Erased::<SO3<f64>, 3, 3>::new();
    let group: &dyn Group<f64> = &group;
    let mut logs = 0;
    for _ in 0..cases(1_000) {
        let bounds = tangents(&mut random, "www");
        let points: Vec<_> = (0..POINTS).map(|_| point_of(&mut random, &bounds)).collect();
        let images: Vec<_> = points.iter().map(|w| Dense::exact(&group.hat(w)).phi(0)).collect();
        let hull = SMatrix::<Interval, 3, 3>::from_fn(|row, col| {
            images.iter().fold(Interval::EMPTY, |hull, m| hull.hull(m.get(row, col).enclose()))
        });
        let set = SO3::<Interval>::from_matrix(&hull).unwrap();
        let (matrix, again) = (set.rotation_matrix(), {
            let [w, x, y, z] = set.quaternion();
            SO3::<Interval>::from_quaternion(w, x, y, z).unwrap().rotation_matrix()
        });
        let log = lie_groups::LieGroup::log(&set);
        for (w, image) in points.iter().zip(&images) {
            assert_eq!(image.escapes(&matrix), None, "{w:?} in {bounds:?}");
            assert_eq!(image.escapes(&again), None, "{w:?} in {bounds:?} by quaternions");
            if let (Ok(log), true) = (&log, w.norm() < std::f64::consts::PI) {
                assert!(w.iter().zip(log.iter()).all(|(&v, range)| range.contains(v)), "{w:?} is not in {log:?}");
                logs += 1;
            }
        }
    }
    println!("seed {SEED:#x}: {logs} rotation vectors through log");
    assert!(logs > cases(1_000));
}

/// Products of small turns: the set grows as the sum of the radii of its factors, where a box alone would grow exponentially.
#[test]
fn rotations_of_space_do_not_wrap() {
    let mut random = Random::new("wrapping");
    let mut rotation = <SO3<Interval> as lie_groups::LieGroup<Interval, 3, 3>>::identity();
    let mut exact = <SO3<f64> as lie_groups::LieGroup<f64, 3, 3>>::identity();
    let (count, width) = (1_000_u32, 1e-6);
    for _ in 0..count {
        let w = nalgebra::Vector3::from_fn(|_, _| random.uniform(-0.5, 0.5));
        let step = w.map(|x| Interval::point(x).inflate(width));
        rotation = lie_groups::LieGroup::compose(&rotation, &lie_groups::LieGroup::exp(&step));
        exact = lie_groups::LieGroup::compose(&exact, &lie_groups::LieGroup::exp(&w));
    }
    let spin = rotation.spin();
    println!(
        "seed {SEED:#x}: radius after {count} products {:.3e}, sum of half-diagonals {:.3e}",
        spin.radius(),
        f64::from(count) * width * 3.0_f64.sqrt()
    );
    assert!(spin.radius() < 1.001 * f64::from(count) * width * 3.0_f64.sqrt() + 1e-11);
    let matrix = rotation.rotation_matrix();
    let inside = exact.rotation_matrix().iter().zip(matrix.iter()).all(|(&x, range)| range.inflate(1e-12).contains(x));
    assert!(inside, "{:?}", DMatrix::from_fn(3, 3, |r, c| matrix[(r, c)]));
}

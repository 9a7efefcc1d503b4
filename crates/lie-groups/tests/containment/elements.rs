//! log and the group operations over boxes of group elements.

use lie_groups::{Enclose, GroupError, LieGroup, Rn, SE2, SO2};
use nalgebra::{DMatrix, SVector};
use scalars::Interval;

use crate::boxes::{Boxed, interval, point_of, tangents};
use crate::support::dense::Dense;
use crate::support::random::{Random, SEED, cases};

/// Points per box.
const POINTS: usize = 10;

/// The hull of dense matrices, some of its entries widened.
fn hull(random: &mut Random, points: &[Dense]) -> DMatrix<Interval> {
    let size = points[0].size;
    let slack = if random.bits() & 1 == 0 { 0.0 } else { random.log_uniform(1e-16, 1e-2).abs() };
    DMatrix::from_fn(size, size, |row, col| {
        points.iter().fold(Interval::EMPTY, |hull, m| hull.hull(m.get(row, col).enclose())).inflate(slack)
    })
}

/// Points of a random box of tangent vectors with angles short of a half turn, and a box of elements around their exponentials.
fn cloud<B: Boxed<N, D>, const N: usize, const D: usize>(
    random: &mut Random,
) -> (Vec<SVector<f64, N>>, Vec<Dense>, DMatrix<Interval>) {
    let mut bounds: SVector<Interval, N> = tangents(random);
    let half_turn = interval(-std::f64::consts::PI, std::f64::consts::PI);
    while bounds[0].disjoint(&half_turn) {
        bounds = tangents(random);
    }
    bounds[0] = bounds[0].intersection(half_turn);
    let points: Vec<_> = (0..POINTS).map(|_| point_of(random, &bounds)).collect();
    let images: Vec<_> = points.iter().map(|xi| Dense::exact(&B::Point::hat(xi)).phi(0)).collect();
    let element = hull(random, &images);
    (points, images, element)
}

fn log_sweep<B: Boxed<N, D>, const N: usize, const D: usize>(name: &str) {
    let mut random = Random::new(name);
    let (mut checked, mut refused) = (0_usize, 0_usize);
    let wanted = cases(100_000);
    while checked < wanted {
        let (points, _, bounds) = cloud::<B, N, D>(&mut random);
        match B::from_matrix(&bounds).log() {
            Ok(log) => {
                for xi in points {
                    let inside = xi.iter().zip(log.iter()).all(|(&x, range)| range.contains(x));
                    assert!(inside, "{name}: {xi:?} is not in {log:?}, the log of {bounds:?}");
                    checked += 1;
                }
            }
            Err(error) => {
                // Up to rounding: the angle of a sine of 1e-16 may reach pi when rounded outward.
                let reaches = bounds[(0, 0)].lo() <= -1.0 && bounds[(1, 0)].inflate(1e-15).contains(0.0);
                assert!(reaches && matches!(error, GroupError::HalfTurn { .. }), "{name}: {error} for {bounds:?}");
                refused += 1;
            }
        }
    }
    println!("{name}: seed {SEED:#x}, {checked} points through log, {refused} boxes refused");
}

#[test]
fn so2_log_contains_the_points() {
    log_sweep::<SO2<Interval>, 1, 2>("SO2");
}

#[test]
fn se2_log_contains_the_points() {
    log_sweep::<SE2<Interval>, 3, 2>("SE2");
}

#[test]
fn rn_log_contains_the_points() {
    log_sweep::<Rn<Interval, 3>, 3, 3>("R3");
}

fn operation_sweep<B: Boxed<N, D>, const N: usize, const D: usize>(name: &str) {
    let mut random = Random::new(name);
    let count = cases(100_000 / POINTS);
    for _ in 0..count {
        let (xs, x_points, x_box) = cloud::<B, N, D>(&mut random);
        let (_, y_points, y_box) = cloud::<B, N, D>(&mut random);
        let (x, y) = (B::from_matrix(&x_box), B::from_matrix(&y_box));
        let (product, inverse, adjoint) = (x.compose(&y).matrix(), x.inverse().matrix(), x.adjoint());
        let place: SVector<f64, D> = random.tangent(1e3);
        let image = x.act(&place.map(Interval::point));
        for k in 0..POINTS {
            let judge = |what: &str, escape: Option<(usize, usize)>| {
                assert!(escape.is_none(), "{name}: {what} of {x_box:?}, {y_box:?} loses an element at {escape:?}");
            };
            judge("product", x_points[k].multiply(&y_points[k]).escapes(&product));
            judge("inverse", x_points[k].inverse().escapes(&inverse));
            judge("adjoint", Dense::exact(&B::Point::ad(&xs[k])).phi(0).escapes(&adjoint));
            let size = x_points[k].size;
            let lifted = Dense::from_fn(size, |row, _| if row < D { place[row].into() } else { 1.0.into() });
            let moved = x_points[k].multiply(&lifted);
            let inside = (0..D).all(|row| moved.get(row, 0).in_interval(&image[row]));
            assert!(inside, "{name}: the image of {place:?} leaves {image:?}");
        }
    }
    println!("{name}: seed {SEED:#x}, {} pairs through the operations", count * POINTS);
}

#[test]
fn operations_contain_exact_results() {
    operation_sweep::<SO2<Interval>, 1, 2>("SO2");
    operation_sweep::<SE2<Interval>, 3, 2>("SE2");
    operation_sweep::<Rn<Interval, 3>, 3, 3>("R3");
}

/// The box of a rounded element contains the exact one it stands for, whose entries have quotient `sin / cos`.
#[test]
fn enclosing_a_rounded_rotation() {
    let mut random = Random::new("enclose");
    for _ in 0..cases(10_000) {
        let rounded = SO2::from_angle(random.uniform(-3.0, 3.0));
        let stored = rounded.unit();
        let exact = Dense::from_fn(1, |_, _| {
            // 1 / sqrt(1 + d) to second order, with d the exact defect of the stored squares.
            let square = |x: f64| crate::support::dd::Dd::from(x) * x.into();
            let defect = square(stored.re) + square(stored.im) - 1.0.into();
            crate::support::dd::Dd::ONE - defect * 0.5.into() + defect * defect * 0.375.into()
        });
        let enclosed = rounded.enclose();
        let boxed = enclosed.unit();
        // The arc is the angle of the exact direction.
        let (sin, cos) = enclosed.angle().unwrap().sin_cos();
        assert!(!sin.disjoint(&boxed.im) && !cos.disjoint(&boxed.re) && enclosed.angle().unwrap().width() < 4e-15);
        for (part, range) in [(stored.re, boxed.re), (stored.im, boxed.im)] {
            assert!((exact.get(0, 0) * part.into()).in_interval(&range), "{part:e} scaled is not in {range:?}");
            assert!(range.width() <= 8.0 * f64::EPSILON * part.abs(), "{range:?}");
        }
    }
    let pose = SE2::from_pose(0.3, 1.0, 2.0).enclose();
    assert_eq!(pose.translation()[0], Interval::ONE);
    assert_eq!(Rn::new(SVector::<f64, 1>::new(0.1)).enclose().vector()[0], Interval::point(0.1));
}

/// Arcs add: after many products the width of the heading is the sum of the widths, where boxes of cosines and sines would have grown
/// by `|cos| + |sin|` in each.
#[test]
fn headings_do_not_wrap() {
    let step = SO2::from_angle(interval(0.3 - 1e-6, 0.3 + 1e-6));
    let mut rotation = SO2::<Interval>::identity();
    let count = 1000;
    for _ in 0..count {
        rotation = rotation.compose(&step);
    }
    let angle = rotation.angle().unwrap();
    assert!(angle.width() < 2e-6 * f64::from(count) + 1e-11, "{}", angle.width());
    // 300 radians, less 48 turns.
    assert!((angle.mid() - (300.0 - 48.0 * std::f64::consts::TAU)).abs() < 1e-10);
    assert!(!rotation.unit().re.disjoint(&Interval::point(300.0_f64.cos()).inflate(1e-15)));
}

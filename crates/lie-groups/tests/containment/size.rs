//! Enclosures are tight: against the range over the corners of the box for small ones, in units of rounding for points, against
//! the very arc for boxes of rotations.

use lie_groups::{LieGroup, SE2, SO2};
use nalgebra::{SMatrix, Vector3};
use scalars::Interval;

use crate::boxes::interval;
use crate::support::random::{Random, SEED, cases};

type Box3 = SMatrix<Interval, 3, 3>;
type Point3 = SMatrix<f64, 3, 3>;

/// What is measured.
const WHAT: [&str; 4] = ["exp", "log", "Jl", "Jl^-1"];

fn log_as_matrix<S: lie_groups::Coeff>(xi: &nalgebra::SVector<S, 3>) -> SMatrix<S, 3, 3> {
    SMatrix::from_fn(|row, col| if col == 0 { xi[row] } else { S::zero() })
}

fn fixed<S: lie_groups::Coeff>(m: &nalgebra::DMatrix<S>) -> SMatrix<S, 3, 3> {
    SMatrix::from_fn(|row, col| m[(row, col)])
}

/// Enclosures of the four functions over the box; the log is that of the pose box `(theta, x1, x2)`.
fn enclosures(bounds: &Vector3<Interval>) -> [Box3; 4] {
    let pose = SE2::from_pose(bounds[0], bounds[1], bounds[2]);
    [
        fixed(&SE2::exp(bounds).matrix()),
        log_as_matrix(&pose.log().unwrap()),
        SE2::jl(bounds),
        SE2::jl_inv(bounds).unwrap(),
    ]
}

fn values(xi: &Vector3<f64>) -> [Point3; 4] {
    let pose = SE2::from_pose(xi[0], xi[1], xi[2]);
    [fixed(&SE2::exp(xi).matrix()), log_as_matrix(&pose.log().unwrap()), SE2::jl(xi), SE2::jl_inv(xi).unwrap()]
}

/// Largest width over the entries.
fn width(m: &Box3) -> f64 {
    m.iter().fold(0.0, |w, x| x.width().max(w))
}

/// Largest width over the entries of the hull of the values on a grid of the box.
fn sampled_width(bounds: &Vector3<Interval>, steps: usize) -> [f64; 4] {
    let mut ranges = [[Interval::EMPTY; 9]; 4];
    let at = |x: &Interval, k: usize| x.lo() + (x.hi() - x.lo()) * k as f64 / steps as f64;
    for i in 0..=steps {
        for corner in 0..4 {
            let (j, k) = (steps * (corner & 1), steps * (corner >> 1));
            // The functions are affine in the translation: its corners suffice.
            let xi = Vector3::new(at(&bounds[0], i), at(&bounds[1], j), at(&bounds[2], k));
            for (range, value) in ranges.iter_mut().zip(values(&xi)) {
                for (entry, &x) in range.iter_mut().zip(value.iter()) {
                    *entry = entry.hull(Interval::point(x));
                }
            }
        }
    }
    ranges.map(|range| range.iter().fold(0.0, |w, x| x.width().max(w)))
}

/// Worst ratio of widths over boxes of the given radii; the translation is of the size of a step (0.1 to 10).
fn ratios(stream: &str, count: usize, angle_radius: f64, translation_radius: f64, steps: usize) -> [f64; 4] {
    let mut random = Random::new(stream);
    let mut worst = [0.0_f64; 4];
    for _ in 0..count {
        let limit = 3.1 - angle_radius;
        let center = [random.uniform(-limit, limit), random.log_uniform(0.1, 10.0), random.log_uniform(0.1, 10.0)];
        let radius = [angle_radius, translation_radius, translation_radius];
        let bounds = Vector3::from_fn(|row, _| interval(center[row] - radius[row], center[row] + radius[row]));
        let sampled = sampled_width(&bounds, steps);
        for (k, enclosure) in enclosures(&bounds).iter().enumerate() {
            worst[k] = worst[k].max(width(enclosure) / sampled[k]);
        }
    }
    worst
}

#[test]
fn small_boxes_are_first_order_tight() {
    let worst = ratios("small", cases(20_000), 1e-6, 1e-6, 1);
    println!("seed {SEED:#x}: radius 1e-6, width over sampled width");
    for (what, ratio) in WHAT.into_iter().zip(worst) {
        println!("    {what:6} {ratio:.3}");
        assert!(ratio < 1.5, "{what}: {ratio}");
    }
}

#[test]
fn wide_boxes_stay_within_a_factor() {
    let worst = ratios("wide", cases(2_000), 0.5, 0.1, 64);
    println!("seed {SEED:#x}: angle radius 0.5, translation radius 0.1, width over sampled width");
    for (what, ratio) in WHAT.into_iter().zip(worst) {
        println!("    {what:6} {ratio:.3}");
        assert!(ratio < 3.0, "{what}: {ratio}");
    }
}

#[test]
fn points_are_enclosed_within_rounding() {
    let mut random = Random::new("points");
    let mut worst = [0.0_f64; 4];
    for _ in 0..cases(20_000) {
        let xi: Vector3<f64> = random.tangent(3.0);
        for (k, (enclosure, value)) in enclosures(&xi.map(Interval::point)).iter().zip(values(&xi)).enumerate() {
            worst[k] = worst[k].max(width(enclosure) / (value.amax() * f64::EPSILON));
        }
    }
    println!("seed {SEED:#x}: points, width in units of 2.2e-16 of the largest entry");
    for (what, units) in WHAT.into_iter().zip(worst) {
        println!("    {what:6} {units:.1}");
        assert!(units < 30.0, "{what}: {units}");
    }
}

/// The log of a box of rotations is the hull of the arc of the unit circle in the box.
#[test]
fn boxes_of_rotations_have_the_log_of_their_arc() {
    let mut random = Random::new("arcs");
    let grid: Vec<f64> = (0..=4000).map(|k| (f64::from(k) / 2000.0 - 1.0) * std::f64::consts::PI).collect();
    let step = std::f64::consts::PI / 2000.0;
    let (mut checked, mut refused) = (0, 0);
    for _ in 0..cases(5_000) {
        let ends: Vec<f64> = (0..2 + random.below(2)).map(|_| random.uniform(-3.2, 3.2)).collect();
        let range = |f: fn(f64) -> f64| {
            ends.iter().fold(Interval::EMPTY, |hull, &t| hull.hull(Interval::point(f(t)))).inflate(1e-15)
        };
        let (cos, sin) = (range(f64::cos), range(f64::sin));
        let arc = grid
            .iter()
            .filter(|t| cos.contains(t.cos()) && sin.contains(t.sin()))
            .fold(Interval::EMPTY, |hull, &t| hull.hull(Interval::point(t)));
        let Ok(log) = SO2::from_cos_sin(cos, sin).unwrap().angle() else {
            assert!(cos.lo() <= -1.0 && sin.contains(0.0));
            refused += 1;
            continue;
        };
        assert!(arc.subset_of(&log), "{arc:?} is not in {log:?}");
        // The two ends lie in the box too; the arc ends within a step of the grid.
        let known = ends.iter().fold(arc, |hull, &t| hull.hull(Interval::point(f64::atan2(t.sin(), t.cos()))));
        assert!(log.subset_of(&known.inflate(step)), "{log:?} is wider than {known:?}");
        checked += 1;
    }
    println!("seed {SEED:#x}: {checked} arcs, {refused} boxes refused");
    assert!(checked > refused);
}

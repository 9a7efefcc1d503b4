//! SE(2) over `f64` against `sophus_lie`, and over intervals against our own `f64` version.

use std::hint::black_box;

use lie_groups::{LieGroup, SE2};
use nalgebra::Vector3;
use scalars::Interval;
use sophus_autodiff::linalg::VecF64;
use sophus_lie::Isometry2F64;

use crate::timing::Bench;

/// Elements per batch: small enough to stay in the first-level cache.
const BATCH: usize = 256;

/// Tangent vectors with rotation angles in (-3, 3) and translations in (-5, 5), from a fixed linear congruence.
fn tangents() -> Vec<[f64; 3]> {
    let mut state = 20_261_122_u64;
    let mut draw = |scale: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0) * scale
    };
    (0..BATCH).map(|_| [draw(3.0), draw(5.0), draw(5.0)]).collect()
}

/// One pass over all inputs, keeping every result alive.
fn each<T: Copy, R>(inputs: &[T], operation: impl Fn(T) -> R) {
    for &input in inputs {
        black_box(operation(black_box(input)));
    }
}

/// The rows `se2/*`.
pub fn benches() -> Vec<Bench> {
    let points: Vec<[f64; 3]> = tangents();
    let xis: Vec<Vector3<f64>> = points.iter().map(|p| Vector3::new(p[0], p[1], p[2])).collect();
    let boxes: Vec<Vector3<Interval>> =
        xis.iter().map(|xi| xi.map(|v| Interval::point(v).inflate(1e-3 * v.abs()))).collect();
    let poses: Vec<SE2<f64>> = xis.iter().map(SE2::exp).collect();
    let pairs: Vec<(SE2<f64>, SE2<f64>)> = poses.iter().copied().zip(poses.iter().rev().copied()).collect();

    let peer_xis: Vec<VecF64<3>> = points.iter().map(|p| VecF64::<3>::new(p[0], p[1], p[2])).collect();
    // The peer orders tangent vectors as we do or translation first; a draw from one range serves either way for timing.
    let peer_poses: Vec<Isometry2F64> = peer_xis.iter().map(|xi| Isometry2F64::exp(*xi)).collect();
    let peer_pairs: Vec<(Isometry2F64, Isometry2F64)> =
        peer_poses.iter().copied().zip(peer_poses.iter().rev().copied()).collect();

    macro_rules! row {
        ($name:literal, $peer:literal, $ours_in:expr, $ours:expr, $peer_in:expr, $theirs:expr) => {{
            let (ours_in, peer_in) = ($ours_in.clone(), $peer_in.clone());
            Bench::new($name, $peer, move || each(&ours_in, $ours), move || each(&peer_in, $theirs)).batched(BATCH)
        }};
    }
    vec![
        row!("se2/exp", "sophus_lie", xis, |xi| SE2::exp(&xi), peer_xis, Isometry2F64::exp),
        row!("se2/log", "sophus_lie", poses, |x: SE2<f64>| x.log(), peer_poses, |x: Isometry2F64| x.log()),
        row!(
            "se2/compose",
            "sophus_lie",
            pairs,
            |(a, b): (SE2<f64>, SE2<f64>)| a.compose(&b),
            peer_pairs,
            |(a, b): (Isometry2F64, Isometry2F64)| a.group_mul(b)
        ),
        row!("se2/inverse", "sophus_lie", poses, |x: SE2<f64>| x.inverse(), peer_poses, |x: Isometry2F64| x.inverse()),
        row!("se2/jl", "sophus_lie", xis, |xi| SE2::jl(&xi), peer_xis, Isometry2F64::left_jacobian),
        row!("se2/jl-inv", "sophus_lie", xis, |xi| SE2::jl_inv(&xi), peer_xis, Isometry2F64::inv_left_jacobian),
        row!("se2-interval/exp", "f64", boxes, |xi| SE2::exp(&xi), xis, |xi| SE2::exp(&xi)),
        row!("se2-interval/jl", "f64", boxes, |xi| SE2::jl(&xi), xis, |xi| SE2::jl(&xi)),
    ]
}

//! SE(2) over `f64` against `sophus_lie`, and over intervals against our own `f64` version.

use std::hint::black_box;

use lie_groups::{LieGroup, SE2};
use nalgebra::Vector3;
use scalars::Interval;
use sophus_autodiff::linalg::VecF64;
use sophus_lie::Isometry2F64;

use crate::draw::Draw;
use crate::timing::Bench;

/// Elements per batch: small enough to stay in the first-level cache.
const BATCH: usize = 256;

/// Tangent vectors with rotation angles in (-3, 3) and translations in (-5, 5).
fn tangents() -> Vec<[f64; 3]> {
    let mut draw = Draw::new(20_261_122);
    (0..BATCH).map(|_| [3.0, 5.0, 5.0].map(|scale| draw.symmetric(scale))).collect()
}

/// Work that applies an operation to all inputs and keeps every result. Inputs are read in place: copying them through the stack
/// would time the processor's store forwarding.
fn each<T: 'static, R: 'static>(inputs: Vec<T>, operation: impl Fn(&T) -> R + 'static) -> impl FnMut() + 'static {
    let mut results: Vec<R> = inputs.iter().map(&operation).collect();
    move || {
        for (result, input) in results.iter_mut().zip(black_box(&inputs)) {
            *result = operation(input);
        }
        black_box(&results);
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

    let versus = |name, ours: Box<dyn FnMut()>, peer: Box<dyn FnMut()>| {
        Bench::new(name, "sophus_lie", ours, peer).batched(BATCH)
    };
    vec![
        versus(
            "se2/exp",
            Box::new(each(xis.clone(), SE2::exp)),
            Box::new(each(peer_xis.clone(), |xi| Isometry2F64::exp(*xi))),
        ),
        versus(
            "se2/log",
            Box::new(each(poses.clone(), SE2::log)),
            Box::new(each(peer_poses.clone(), Isometry2F64::log)),
        ),
        versus(
            "se2/compose",
            Box::new(each(pairs, |(a, b)| a.compose(b))),
            Box::new(each(peer_pairs, |(a, b)| a.group_mul(*b))),
        ),
        versus("se2/inverse", Box::new(each(poses, SE2::inverse)), Box::new(each(peer_poses, Isometry2F64::inverse))),
        versus(
            "se2/jl",
            Box::new(each(xis.clone(), SE2::jl)),
            Box::new(each(peer_xis.clone(), |xi| Isometry2F64::left_jacobian(*xi))),
        ),
        versus(
            "se2/jl-inv",
            Box::new(each(xis.clone(), SE2::jl_inv)),
            Box::new(each(peer_xis, |xi| Isometry2F64::inv_left_jacobian(*xi))),
        ),
        Bench::new("se2-interval/exp", "f64", each(boxes.clone(), SE2::exp), each(xis.clone(), SE2::exp))
            .batched(BATCH),
        Bench::new("se2-interval/jl", "f64", each(boxes, SE2::jl), each(xis, SE2::jl)).batched(BATCH),
    ]
}

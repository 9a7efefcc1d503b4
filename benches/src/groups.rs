//! The groups over `f64` against `sophus_lie`, the two-frame group of the wheel model against our SE(2), and intervals against `f64`.
//!
//! Rows against `factrs` are in `benches/peers/factrs`, a program of its own that runs these too.

use std::hint::black_box;

use lie_groups::{LieGroup, SE2, SE3, TfgScaleLever2};
use nalgebra::SVector;
use scalars::Interval;
use sophus_autodiff::linalg::VecF64;
use sophus_lie::{Isometry2F64, Isometry3F64};

use crate::draw::Draw;
use crate::timing::Bench;

/// Elements per batch: small enough to stay in the first-level cache.
const BATCH: usize = 256;

/// Tangent vectors with rotations of up to 3 (each coordinate of a rotation vector up to 1.7), log-scales up to 1 and vectors in (-5, 5).
pub fn tangents<const N: usize>(kinds: &str) -> Vec<[f64; N]> {
    let mut draw = Draw::new(20_261_122);
    let scales: Vec<f64> = kinds
        .chars()
        .map(|kind| match kind {
            'r' => 3.0,
            'w' => 1.7,
            's' => 1.0,
            _ => 5.0,
        })
        .collect();
    (0..BATCH).map(|_| std::array::from_fn(|k| draw.symmetric(scales[k]))).collect()
}

/// Work that applies an operation to all inputs and keeps every result. Inputs are read in place: copying them through the stack
/// would time the processor's store forwarding.
pub fn each<T: 'static, R: 'static>(inputs: Vec<T>, operation: impl Fn(&T) -> R + 'static) -> Box<dyn FnMut()> {
    let mut results: Vec<R> = inputs.iter().map(&operation).collect();
    Box::new(move || {
        for (result, input) in results.iter_mut().zip(black_box(&inputs)) {
            *result = operation(input);
        }
        black_box(&results);
    })
}

/// Every element with one from the other end.
pub fn pairs<T: Clone>(elements: &[T]) -> Vec<(T, T)> {
    elements.iter().cloned().zip(elements.iter().rev().cloned()).collect()
}

/// A comparison of a batch.
pub fn versus(name: &str, peer: &'static str, ours: Box<dyn FnMut()>, theirs: Box<dyn FnMut()>) -> Bench {
    Bench::new(name, peer, ours, theirs).batched(BATCH)
}

/// Our side of the common operations.
pub struct Ours<G, const N: usize> {
    /// Tangent vectors.
    pub xis: Vec<SVector<f64, N>>,
    /// Their exponentials.
    pub elements: Vec<G>,
}

impl<G: 'static, const N: usize> Ours<G, N> {
    /// The inputs of a group by the kinds of its coordinates.
    pub fn new<const D: usize>(kinds: &str) -> Self
    where
        G: LieGroup<f64, N, D>,
    {
        let xis: Vec<SVector<f64, N>> = tangents::<N>(kinds).into_iter().map(SVector::from).collect();
        let elements = xis.iter().map(G::exp).collect();
        Self { xis, elements }
    }

    /// An operation on tangent vectors.
    pub fn on_xis<R: 'static>(&self, operation: impl Fn(&SVector<f64, N>) -> R + 'static) -> Box<dyn FnMut()> {
        each(self.xis.clone(), operation)
    }

    /// An operation on elements.
    pub fn on_elements<R: 'static>(&self, operation: impl Fn(&G) -> R + 'static) -> Box<dyn FnMut()>
    where
        G: Clone,
    {
        each(self.elements.clone(), operation)
    }

    /// An operation on pairs of elements.
    pub fn on_pairs<R: 'static>(&self, operation: impl Fn(&(G, G)) -> R + 'static) -> Box<dyn FnMut()>
    where
        G: Clone,
    {
        each(pairs(&self.elements), operation)
    }
}

/// The rows of one group against `sophus_lie`: our type, the peer's, the kinds of the coordinates.
macro_rules! against_sophus {
    ($name:literal, $ours:ty, $peer:ty, $kinds:literal) => {{
        let ours = Ours::<$ours, { $kinds.len() }>::new($kinds);
        // The peer orders tangent vectors as we do.
        let peer_xis: Vec<_> =
            ours.xis.iter().map(|xi| VecF64::<{ $kinds.len() }>::from_column_slice(xi.as_slice())).collect();
        let peers: Vec<$peer> = peer_xis.iter().map(|xi| <$peer>::exp(*xi)).collect();
        let row = |what: &str, ours, theirs| versus(&format!("{}/{what}", $name), "sophus_lie", ours, theirs);
        vec![
            row("exp", ours.on_xis(<$ours>::exp), each(peer_xis.clone(), |xi| <$peer>::exp(*xi))),
            row("log", ours.on_elements(<$ours>::log), each(peers.clone(), <$peer>::log)),
            row("compose", ours.on_pairs(|(a, b)| a.compose(b)), each(pairs(&peers), |(a, b)| a.group_mul(*b))),
            row("inverse", ours.on_elements(<$ours>::inverse), each(peers.clone(), <$peer>::inverse)),
            row("adjoint", ours.on_elements(<$ours>::adjoint), each(peers, <$peer>::adj)),
            row("jl", ours.on_xis(<$ours>::jl), each(peer_xis.clone(), |xi| <$peer>::left_jacobian(*xi))),
            row("jl-inv", ours.on_xis(<$ours>::jl_inv), each(peer_xis, |xi| <$peer>::inv_left_jacobian(*xi))),
        ]
    }};
}

/// The rows `se2/*`, `se3/*`, `tfg-scale/*` and `se2-interval/*`.
pub fn benches() -> Vec<Bench> {
    let mut rows = against_sophus!("se2", SE2<f64>, Isometry2F64, "rxx");
    rows.extend(against_sophus!("se3", SE3<f64>, Isometry3F64, "wwwxxx"));

    let plane = Ours::<SE2<f64>, 3>::new("rxx");
    let wheel = Ours::<TfgScaleLever2<f64>, 6>::new("rsxxxx");
    rows.push(versus("tfg-scale/exp", "our SE2", wheel.on_xis(TfgScaleLever2::exp), plane.on_xis(SE2::exp)));
    rows.push(versus("tfg-scale/log", "our SE2", wheel.on_elements(TfgScaleLever2::log), plane.on_elements(SE2::log)));
    rows.push(versus("tfg-scale/jl", "our SE2", wheel.on_xis(TfgScaleLever2::jl), plane.on_xis(SE2::jl)));

    rows.push(versus("se2-interval/exp", "f64", each(boxes(&plane.xis), SE2::exp), plane.on_xis(SE2::exp)));
    rows.push(versus("se2-interval/jl", "f64", each(boxes(&plane.xis), SE2::jl), plane.on_xis(SE2::jl)));
    let space = Ours::<SE3<f64>, 6>::new("wwwxxx");
    rows.push(versus("se3-interval/exp", "f64", each(boxes(&space.xis), SE3::exp), space.on_xis(SE3::exp)));
    rows.push(versus("se3-interval/jl", "f64", each(boxes(&space.xis), SE3::jl), space.on_xis(SE3::jl)));
    rows
}

/// Boxes of 0.1 % around tangent vectors.
fn boxes<const N: usize>(xis: &[SVector<f64, N>]) -> Vec<SVector<Interval, N>> {
    xis.iter().map(|xi| xi.map(|v| Interval::point(v).inflate(1e-3 * v.abs()))).collect()
}

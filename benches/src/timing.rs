//! Interleaved timing of two pieces of work in one run.
//!
//! A shared machine is noisy, so two programs timed one after the other can not be compared. Here both sides run in short
//! windows that alternate; of each side the least mean over a window counts, and only the ratio of the two is a claim.

use std::hint::black_box;
use std::time::{Duration, Instant};

use serde::Serialize;

/// One line of the table: our time, the peer's time, and `ratio = peer / ours` (above 1: we are faster).
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// What was timed, as `family/case`.
    pub name: String,
    /// Nanoseconds per operation, ours.
    pub ours_ns: f64,
    /// Who is compared with: a library, or a floor such as `faer-product`.
    pub peer: String,
    /// Nanoseconds per operation, the peer's.
    pub peer_ns: f64,
    /// `peer_ns / ours_ns`.
    pub ratio: f64,
}

/// How long a window lasts and how many windows each side gets.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// Length of one window.
    pub window: Duration,
    /// Number of windows a side.
    pub windows: usize,
}

impl Default for Budget {
    fn default() -> Self {
        Self { window: Duration::from_millis(4), windows: 60 }
    }
}

/// Times `ours` and `peer` in alternating windows. Each call of a closure does `batch` operations.
pub fn compare(
    name: &str,
    peer_name: &str,
    batch: usize,
    budget: Budget,
    mut ours: impl FnMut(),
    mut peer: impl FnMut(),
) -> Row {
    let our_calls = calls_per_window(&mut ours, budget.window);
    let peer_calls = calls_per_window(&mut peer, budget.window);
    let (mut our_best, mut peer_best) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..budget.windows {
        our_best = our_best.min(window_ns(&mut ours, our_calls));
        peer_best = peer_best.min(window_ns(&mut peer, peer_calls));
    }
    let (ours_ns, peer_ns) = (our_best / batch as f64, peer_best / batch as f64);
    Row { name: name.to_owned(), ours_ns, peer: peer_name.to_owned(), peer_ns, ratio: peer_ns / ours_ns }
}

fn calls_per_window(work: &mut impl FnMut(), window: Duration) -> u32 {
    let mut calls = 1_u32;
    loop {
        let start = Instant::now();
        for _ in 0..calls {
            work();
        }
        if start.elapsed() * 2 >= window || calls >= 1 << 24 {
            return calls;
        }
        calls *= 2;
    }
}

fn window_ns(work: &mut impl FnMut(), calls: u32) -> f64 {
    let start = Instant::now();
    for _ in 0..calls {
        work();
    }
    black_box(start.elapsed()).as_nanos() as f64 / f64::from(calls)
}

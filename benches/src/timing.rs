//! Interleaved timing of two pieces of work in one run.
//!
//! A shared machine is noisy, so two programs timed one after the other can not be compared. Here both sides run in short
//! windows that alternate, on the clock of the thread's own processor time; of each side the least mean over a window counts,
//! and only the ratio of the two is a claim.

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
    /// Time after which no more windows are begun: slow work gets fewer of them, but at least [`LEAST_WINDOWS`].
    pub patience: Duration,
}

/// Windows that each side gets however slow it is.
const LEAST_WINDOWS: usize = 5;

impl Default for Budget {
    fn default() -> Self {
        Self { window: Duration::from_millis(4), windows: 60, patience: Duration::from_secs(8) }
    }
}

/// A comparison: a name, the work of both sides, and how many operations one call of either does.
pub struct Bench {
    /// What is timed, as `family/case`; rows against several peers share it.
    pub name: String,
    peer: &'static str,
    batch: usize,
    ours: Work,
    theirs: Work,
}

/// Work that is timed from outside, or that says itself how long its interesting part took.
enum Work {
    Plain(Box<dyn FnMut()>),
    Clocked(Box<dyn FnMut() -> Duration>),
}

impl Bench {
    /// A comparison whose calls do one operation each.
    pub fn new(
        name: impl Into<String>,
        peer: &'static str,
        ours: impl FnMut() + 'static,
        theirs: impl FnMut() + 'static,
    ) -> Self {
        let (ours, theirs) = (Work::Plain(Box::new(ours)), Work::Plain(Box::new(theirs)));
        Self { name: name.into(), peer, batch: 1, ours, theirs }
    }

    /// A comparison of parts of what the calls do: each returns the [`processor_time`] of its part.
    pub fn clocked(
        name: impl Into<String>,
        peer: &'static str,
        ours: impl FnMut() -> Duration + 'static,
        theirs: impl FnMut() -> Duration + 'static,
    ) -> Self {
        let (ours, theirs) = (Work::Clocked(Box::new(ours)), Work::Clocked(Box::new(theirs)));
        Self { name: name.into(), peer, batch: 1, ours, theirs }
    }

    /// The same with `batch` operations in each call.
    #[must_use]
    pub fn batched(mut self, batch: usize) -> Self {
        self.batch = batch;
        self
    }

    /// Times both sides in alternating windows.
    pub fn run(&mut self, budget: Budget) -> Row {
        let our_calls = calls_per_window(&mut self.ours, budget.window);
        let peer_calls = calls_per_window(&mut self.theirs, budget.window);
        let (mut our_best, mut peer_best) = (f64::INFINITY, f64::INFINITY);
        let start = Instant::now();
        for window in 0..budget.windows {
            if window >= LEAST_WINDOWS && start.elapsed() > budget.patience {
                break;
            }
            our_best = our_best.min(window_ns(&mut self.ours, our_calls));
            peer_best = peer_best.min(window_ns(&mut self.theirs, peer_calls));
        }
        let (ours_ns, peer_ns) = (our_best / self.batch as f64, peer_best / self.batch as f64);
        Row { name: self.name.clone(), ours_ns, peer: self.peer.to_owned(), peer_ns, ratio: peer_ns / ours_ns }
    }

    /// Time of `calls` calls of our side, for a harness of its own.
    pub fn time_ours(&mut self, calls: u64) -> Duration {
        time(&mut self.ours, calls)
    }
}

fn calls_per_window(work: &mut Work, window: Duration) -> u64 {
    let mut calls = 1;
    while time(work, calls) * 2 < window && calls < 1 << 24 {
        calls *= 2;
    }
    calls
}

fn window_ns(work: &mut Work, calls: u64) -> f64 {
    time(work, calls).as_nanos() as f64 / calls as f64
}

/// Processor time of `calls` calls.
fn time(work: &mut Work, calls: u64) -> Duration {
    match work {
        Work::Plain(work) => {
            let start = processor_time();
            (0..calls).for_each(|_| work());
            processor_time() - start
        }
        Work::Clocked(work) => (0..calls).map(|_| work()).sum(),
    }
}

/// Time this thread has run for: what others run in between does not count.
#[cfg(unix)]
pub fn processor_time() -> Duration {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    Duration::new(time.tv_sec.unsigned_abs(), time.tv_nsec as u32)
}

/// Time since the first call, where there is no such clock.
#[cfg(not(unix))]
pub fn processor_time() -> Duration {
    static START: std::sync::LazyLock<Instant> = std::sync::LazyLock::new(Instant::now);
    START.elapsed()
}

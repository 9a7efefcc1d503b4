//! Monte Carlo runs in parallel, with results that do not depend on the number of threads.
//!
//! Every run owns a ChaCha stream fixed by (seed, name, run), and results are collected by run index. So a result is a function of the
//! seed alone, and a single run can be repeated by itself with [`stream`].

use std::sync::atomic::{AtomicUsize, Ordering};

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::experiment::{Context, Progress};

/// The random stream of one run.
///
/// ChaCha8 with the key (seed, FNV-1a hash of `name`) and the stream number `run`: streams of different runs do not overlap.
#[must_use]
pub fn stream(seed: u64, name: &str, run: usize) -> ChaCha8Rng {
    let mut key = [0_u8; 32];
    key[..8].copy_from_slice(&seed.to_le_bytes());
    key[8..16].copy_from_slice(&fnv1a(name.as_bytes()).to_le_bytes());
    let mut rng = ChaCha8Rng::from_seed(key);
    rng.set_stream(run as u64);
    rng
}

/// Calls `run(index, rng)` for `0..runs` in parallel and returns the results in the order of the index.
///
/// `name` fixes the random streams (cases that shall share their noise share the name) and labels the progress.
///
/// # Errors
/// The error of the lowest failing index, so that errors do not depend on threads either.
///
/// ```
/// use scenarios::{Context, monte_carlo};
/// use rand::RngExt;
/// let draws = monte_carlo::run(&Context::new(1), "coin", 4, |_, rng| Ok::<_, std::fmt::Error>(rng.random::<bool>()))?;
/// assert_eq!(draws.len(), 4);
/// # Ok::<(), std::fmt::Error>(())
/// ```
pub fn run<T, E, F>(context: &Context<'_>, name: &str, runs: usize, run: F) -> Result<Vec<T>, E>
where
    T: Send,
    E: Send,
    F: Fn(usize, &mut ChaCha8Rng) -> Result<T, E> + Sync,
{
    let done = AtomicUsize::new(0);
    context.report(Progress { label: name, done: 0, total: runs });
    let results: Vec<Result<T, E>> = (0..runs)
        .into_par_iter()
        .map(|index| {
            let result = run(index, &mut stream(context.seed, name, index));
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            context.report(Progress { label: name, done, total: runs });
            result
        })
        .collect();
    results.into_iter().collect()
}

/// 64-bit FNV-1a: small, fixed for ever, unlike the hasher of the standard library.
fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use rand::RngExt;

    use super::*;

    fn draws(threads: usize) -> Vec<(usize, f64)> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let body = |index: usize, rng: &mut ChaCha8Rng| {
            // Unequal work, so that runs finish out of order.
            let last = (0..1000 * (32 - index)).map(|_| rng.random::<f64>()).last();
            Ok::<_, ()>((index, last.unwrap_or(0.0)))
        };
        pool.install(|| run(&Context::new(5), "unequal", 32, body)).unwrap()
    }

    #[test]
    fn results_do_not_depend_on_the_number_of_threads() {
        let one = draws(1);
        assert_eq!(one, draws(2));
        assert_eq!(one, draws(7));
        assert!(one.iter().enumerate().all(|(k, (index, _))| k == *index));
    }

    /// The lowest failing index decides, not the thread that fails first.
    #[test]
    fn the_first_error_by_index_is_returned() {
        let result = run(&Context::new(1), "fails", 64, |index, _| if index % 10 == 3 { Err(index) } else { Ok(()) });
        assert_eq!(result, Err(3));
    }

    #[test]
    fn streams_differ_by_seed_name_and_run() {
        let first = |seed, name, run| stream(seed, name, run).random::<u64>();
        let base = first(1, "a", 0);
        assert_eq!(base, first(1, "a", 0));
        assert!([first(2, "a", 0), first(1, "b", 0), first(1, "a", 1)].iter().all(|&other| other != base));
    }

    #[test]
    fn progress_counts_every_run() {
        let (calls, last) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let callback = |progress: Progress<'_>| {
            calls.fetch_add(1, Ordering::Relaxed);
            last.fetch_max(progress.done, Ordering::Relaxed);
            assert_eq!((progress.label, progress.total), ("count", 9));
        };
        let context = Context { progress: &callback, ..Context::new(1) };
        run(&context, "count", 9, |_, _| Ok::<_, ()>(())).unwrap();
        assert_eq!((calls.into_inner(), last.into_inner()), (10, 9));
    }
}

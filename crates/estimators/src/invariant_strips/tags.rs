//! What is known of each row beside its numbers, and which rows are kept.

use super::options::StripsOptions;

/// Without buckets: instants for which a bound, and a measurement, stay without carrying anything. Rows that have not been needed for that
/// long hardly ever are again, and keeping them makes a step three times as long.
const IDLE: [u64; 2] = [8, 18];

/// Where a row comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Origin {
    /// Entry `entry` (two for a measurement) of the measurements of a step.
    Measured { step: u64, entry: usize },
    /// A bound of the set at some instant, which rests on all rows of that time; or the prior.
    Bound,
    /// The arc, the scale or the arms of this moment.
    Derived,
}

/// The companion of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Tag {
    pub(crate) origin: Origin,
    /// Rows of one class have the same direction in the coordinates of their time.
    pub(crate) class: usize,
    /// Instant at which the row was made.
    pub(crate) born: u64,
    /// Last instant at which it carried a bound.
    pub(crate) used: u64,
}

/// The row of a class and bucket with the least slack.
#[derive(Debug, Clone, Copy)]
struct Least {
    slack: f64,
    row: usize,
}

/// Scratch of the choice.
#[derive(Debug, Clone, Default)]
pub(crate) struct Pruning {
    least: Vec<Least>,
    /// The rows to keep.
    pub(crate) keep: Vec<bool>,
}

impl Pruning {
    /// Marks the rows to keep: `slack(i)` is the distance of row `i` from the middle of the set, in units of its class.
    ///
    /// A row stays while it is young enough and was used at this instant, belongs to the bucket of this instant, or has the least slack of
    /// its class and bucket (the oldest of equal ones); without buckets, while it is young enough and was used lately. Any choice is sound.
    pub(crate) fn choose(
        &mut self,
        tags: &[Tag],
        instant: u64,
        options: &StripsOptions,
        mut slack: impl FnMut(usize) -> f64,
    ) {
        let life = |tag: &Tag| if tag.origin == Origin::Bound { options.support_life } else { options.memory };
        let young = |tag: &Tag| tag.origin != Origin::Derived && instant - tag.born <= life(tag) as u64;
        self.keep.clear();
        if options.bucket == 0 {
            let idle = |tag: &Tag| instant - tag.born.max(tag.used) > IDLE[usize::from(tag.origin != Origin::Bound)];
            self.keep.extend(tags.iter().map(|tag| young(tag) && !idle(tag)));
            return;
        }
        let bucket = (instant / 8).clamp(2, (options.bucket as u64).max(2));
        let newest = instant / bucket;
        let classes = tags.iter().map(|tag| tag.class + 1).max().unwrap_or(0);
        // No row is older than the first instant, however long the memory.
        let buckets = (options.memory.max(options.support_life) as u64 / bucket + 2).min(newest + 1) as usize;
        self.least.clear();
        self.least.resize(classes * buckets, Least { slack: f64::INFINITY, row: usize::MAX });
        for (row, tag) in tags.iter().enumerate().filter(|(_, tag)| young(tag)) {
            let age = (newest - tag.born / bucket) as usize;
            let least = &mut self.least[tag.class * buckets + age.min(buckets - 1)];
            let slack = slack(row);
            if slack < least.slack {
                *least = Least { slack, row };
            }
        }
        self.keep.extend(tags.iter().map(|tag| young(tag) && (tag.used == instant || tag.born / bucket == newest)));
        for least in self.least.iter().filter(|least| least.row < tags.len()) {
            self.keep[least.row] = true;
        }
    }
}

//! [`Signs`]: the linear functions that make a function monotone on a box.

use scalars::Interval;
use scalars::rounding::{add_up, sub_down};

/// At most this many coordinates are tried with both signs, those where the sign matters most; the others keep the better one.
const ENUMERATED: usize = 4;

/// What the linear functions are for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Purpose {
    /// Bounds of the function: the shift is a loss, and as small as it can be. A coordinate of one-signed derivative needs none.
    #[default]
    Range,
    /// Rows of an enclosure: the shift is kept, and as close to the derivative as it can be.
    Rows,
}

/// A choice of signs, one a coordinate, with the shifts `m` that make `f - m'x` monotone: for derivatives in `[l, u]`
///
/// - rising: `m_j = l`, or `min(l, 0)` for a range,
/// - falling: `m_j = u`, or `max(u, 0)` for a range.
///
/// Every choice is valid. The first one takes the shift of least magnitude everywhere; the coordinates whose sign matters most are varied.
#[derive(Debug, Default, Clone)]
pub(crate) struct Signs {
    purpose: Purpose,
    slopes: Vec<Interval>,
    rising: Vec<bool>,
    /// The coordinates whose signs vary.
    varied: Vec<usize>,
}

impl Signs {
    /// Prepares the choices for a gradient on a box of the given widths.
    pub(crate) fn plan(
        &mut self,
        purpose: Purpose,
        gradient: impl Iterator<Item = Interval>,
        width: impl Fn(usize) -> f64,
    ) {
        let Self { slopes, rising, varied, .. } = self;
        slopes.clear();
        // A coordinate without width does not move: any derivative will do.
        slopes.extend(gradient.enumerate().map(|(j, slope)| if width(j) == 0.0 { Interval::ZERO } else { slope }));
        rising.clear();
        rising.resize(slopes.len(), true);
        // What the better sign costs, and what of that is worth an evaluation.
        let cost = |j: usize| match purpose {
            Purpose::Range => (-slopes[j].lo()).min(slopes[j].hi()) * width(j),
            Purpose::Rows => slopes[j].width() * width(j),
        };
        let least = match purpose {
            Purpose::Range => 0.0,
            Purpose::Rows => (0..slopes.len()).map(|j| 1e-9 * slopes[j].mag() * width(j)).fold(0.0, f64::max),
        };
        varied.clear();
        varied.extend((0..slopes.len()).filter(|&j| cost(j) > least));
        varied.sort_unstable_by(|&a, &b| cost(b).total_cmp(&cost(a)).then(a.cmp(&b)));
        varied.truncate(ENUMERATED);
        self.purpose = purpose;
        self.choose(0);
    }

    /// Number of choices.
    pub(crate) fn choices(&self) -> usize {
        1 << self.varied.len()
    }

    /// Makes choice number `choice`; number 0 is the greedy one.
    pub(crate) fn choose(&mut self, choice: usize) {
        for (rising, slope) in self.rising.iter_mut().zip(&self.slopes) {
            *rising = -slope.lo() <= slope.hi();
        }
        for (bit, &j) in self.varied.iter().enumerate() {
            self.rising[j] ^= choice >> bit & 1 == 1;
        }
    }

    /// Whether `f - m'x` rises, rather than falls, with coordinate `j`.
    pub(crate) fn rises(&self, j: usize) -> bool {
        self.rising[j]
    }

    /// The shift `m_j`.
    pub(crate) fn shift(&self, j: usize) -> f64 {
        let shift = if self.rising[j] { self.slopes[j].lo() } else { self.slopes[j].hi() };
        match (self.purpose, self.rising[j]) {
            (Purpose::Rows, _) => shift,
            (Purpose::Range, true) => shift.min(0.0),
            (Purpose::Range, false) => shift.max(0.0),
        }
    }

    /// The interval from `least - loss` to `largest + loss`, for enclosures of a least and a largest value.
    pub(crate) fn between(least: Interval, largest: Interval, loss: f64) -> Interval {
        Interval::new(sub_down(least.lo(), loss), add_up(largest.hi(), loss)).unwrap_or(Interval::ENTIRE)
    }
}

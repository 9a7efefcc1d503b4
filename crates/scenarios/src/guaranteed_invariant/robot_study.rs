//! Study (c): logs of a real robot with unknown scale, arm and heading; bounds that hold, bounds that are guessed, bounds that are too small.

use crate::data::wifibot::load;
use crate::guaranteed_invariant::lever::Bounds;
use crate::guaranteed_invariant::lever_run::LeverRun;
use crate::guaranteed_invariant::robot::Log;
use crate::guaranteed_invariant::robot_spans::Span;
use crate::noise::{BoundedNoise, NoiseKind};
use crate::wifibot::LOGS;
use crate::wifibot::odometry::{Rule, SAFETY};
use crate::wifibot::wheels::fit::ADDED_LEVER_M;
use crate::{Context, ScenarioError, monte_carlo};

/// Bounds of the position noises, m.
pub const FIX_BOUNDS_M: [f64; 2] = [1.0, 0.05];
/// Lengths of a window, s. Errors grow slower than the way driven, so longer windows have relatively sharper bounds, and fewer fixes.
pub const WINDOWS_S: [f64; 2] = [1.0, 5.0];

/// Windows of the longest span that is bounded.
pub const LONGEST_SPAN: usize = 40;

/// Where the bounds on the increments come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// 1.2 times the worst of the whole log: hold by construction.
    WholeLog,
    /// Those, and likewise of all spans of 2 to [`LONGEST_SPAN`] windows.
    Spans,
    /// 1.2 times the worst of the first third: what one would do without knowing the rest.
    FirstThird,
    /// Half the worst of the whole log: too small.
    Halved,
}

impl Source {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::WholeLog, Self::Spans, Self::FirstThird, Self::Halved];

    /// The name in the rows.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::WholeLog => "stated bounds",
            Self::Spans => "stated bounds of windows and spans",
            Self::FirstThird => "bounds of the first third",
            Self::Halved => "half the worst",
        }
    }

    /// Whether the bounds hold by construction.
    #[must_use]
    pub fn holds(self) -> bool {
        matches!(self, Self::WholeLog | Self::Spans)
    }

    /// The bounds.
    #[must_use]
    pub fn bounds(self, log: &Log, fix_m: f64) -> Bounds {
        match self {
            Self::WholeLog | Self::Spans => log.stated_bounds(fix_m),
            Self::FirstThird => log.bounds(SAFETY, log.increments.len() / 3, fix_m),
            Self::Halved => log.bounds(0.5, log.increments.len(), fix_m),
        }
    }
}

/// All runs on one log, read by one rule, with one source of bounds and one bound on the fixes.
#[derive(Clone, Debug)]
pub struct RobotCell {
    /// Where the bounds come from.
    pub source: Source,
    /// The bounds.
    pub bounds: Bounds,
    /// Those over several windows.
    pub spans: Vec<Span>,
    /// Scales for which the reference keeps the bounds.
    pub admissible: Option<[f64; 2]>,
    /// Run by run.
    pub runs: Vec<LeverRun>,
}

/// A log read by a rule, and what became of it.
#[derive(Clone, Debug)]
pub struct RobotLog {
    /// The log.
    pub log: Log,
    /// The rule of its speeds.
    pub rule: Rule,
    /// The cells.
    pub cells: Vec<RobotCell>,
}

/// Runs both logs by both rules with `runs` draws of the position noise.
///
/// # Errors
/// [`ScenarioError::DataMissing`] without the logs; those of the filter.
pub fn study(context: &Context<'_>, experiment: &'static str, runs: usize) -> Result<Vec<RobotLog>, ScenarioError> {
    let mut logs = Vec::new();
    for number in LOGS {
        let samples = load(context.data, experiment, number)?;
        for rule in Rule::ALL {
            for window_s in WINDOWS_S {
                let log = Log::new(number, &samples, rule, window_s)?;
                let cells = wanted(context.quick, &log, rule)
                    .map(|(source, fix_m)| cell(context, &log, source, fix_m, runs))
                    .collect::<Result<Vec<_>, _>>()?;
                logs.push(RobotLog { log, rule, cells });
            }
        }
    }
    Ok(logs)
}

/// What is run on a log. In full: on windows of a second all sources of bounds by the right rule, those that hold by the other; on longer
/// windows those of windows. In quick mode: windows with sharp fixes by the right rule, and the spans of log 3.
fn wanted(quick: bool, log: &Log, rule: Rule) -> impl Iterator<Item = (Source, f64)> + use<> {
    let (ends, short, third) = (rule == Rule::Ends, log.window_s == WINDOWS_S[0], log.number == LOGS[1]);
    let wanted = move |source: Source, fix_m: f64| {
        if quick {
            let of_windows = source == Source::WholeLog && !short;
            let of_spans = source == Source::Spans && short && third;
            return ends && fix_m == FIX_BOUNDS_M[1] && (of_windows || of_spans);
        }
        match source {
            Source::WholeLog => true,
            Source::Spans => short,
            Source::FirstThird | Source::Halved => short && ends,
        }
    };
    let all = Source::ALL.into_iter().flat_map(|source| FIX_BOUNDS_M.map(|fix_m| (source, fix_m)));
    all.filter(move |&(source, fix_m)| wanted(source, fix_m))
}

fn cell(context: &Context<'_>, log: &Log, source: Source, fix_m: f64, runs: usize) -> Result<RobotCell, ScenarioError> {
    let bounds = source.bounds(log, fix_m);
    let longest = if source == Source::Spans { LONGEST_SPAN.min(log.increments.len()) } else { 0 };
    let spans: Vec<Span> = (2..=longest).map(|windows| Span::new(log, windows, SAFETY)).collect();
    let name = format!("guaranteed-invariant, log {}, {} s", log.number, log.window_s);
    let runs = monte_carlo::run(context, &name, runs, |_, rng| {
        let mut noise = BoundedNoise::new(NoiseKind::Uniform, [fix_m; 2]);
        let truth = log.run(ADDED_LEVER_M, &bounds, source.holds(), || noise.draw(rng))?;
        LeverRun::with_spans(&truth, &bounds, &spans)
    })?;
    Ok(RobotCell { source, admissible: log.admissible_scales(&bounds, &spans), bounds, spans, runs })
}

//! What the numbers say, in words made from them.

use crate::Mode;
use crate::guaranteed_invariant::broken::Broken;
use crate::guaranteed_invariant::lever_run::LeverRun;
use crate::guaranteed_invariant::lever_study::Runs;
use crate::guaranteed_invariant::noise::Drive;
use crate::guaranteed_invariant::planar::{Cell, Loss, SETTLED};
use crate::guaranteed_invariant::robot_study::{RobotCell, RobotLog};
use crate::guaranteed_invariant::settings::{SETTINGS, SHARP};
use crate::inzsmf::containment::Watched;
use crate::region::Containment;
use crate::report::significant;
use crate::vehicle::PERIOD_S;
use crate::wifibot::odometry::Rule;

/// All studies.
#[derive(Clone, Copy, Debug)]
pub struct Evidence<'a> {
    /// Filter of strips on paper 000's vehicle.
    pub strips: &'a [Cell],
    /// The paper's filters there.
    pub first_order: &'a [Cell],
    /// How often they lose the truth.
    pub losses: &'a [Loss],
    /// Noises beyond the bounds.
    pub broken: &'a [Broken],
    /// Problem 3.
    pub levers: &'a [Runs],
    /// Robot logs; empty without data.
    pub logs: &'a [RobotLog],
}

/// One or two sentences a finding.
#[must_use]
pub fn findings(evidence: &Evidence<'_>) -> Vec<String> {
    let mut findings = vec![kept(evidence), lost(evidence.losses)];
    findings.extend(sizes(evidence));
    findings.push(proofs(evidence.broken));
    findings.extend(sharp(evidence.levers));
    findings.extend(evidence.logs.iter().filter(|log| log.rule == Rule::Ends).flat_map(robot));
    findings
}

/// Containment of all guaranteed runs.
fn kept(evidence: &Evidence<'_>) -> String {
    let mut all = Containment::default();
    let mut add = |run: Containment| {
        all.points += run.points;
        all.not_outside += run.not_outside;
        all.inside += run.inside;
    };
    evidence.strips.iter().flat_map(|cell| &cell.runs).for_each(|run| add(run.containment));
    evidence.levers.iter().flatten().for_each(|run| add(run.containment()));
    let runs = evidence.strips.iter().map(|cell| cell.runs.len()).sum::<usize>()
        + evidence.levers.iter().map(Vec::len).sum::<usize>();
    let inside = if all.inside == all.points {
        "all are proven to hold it".to_owned()
    } else {
        format!("{} are proven to hold it, at the others rounding leaves it open", all.inside)
    };
    // The bounds hold in these runs: a contradiction would be false.
    let contradicted =
        evidence.strips.iter().flat_map(|cell| &cell.runs).filter(|run| run.contradiction.is_some()).count()
            + evidence.levers.iter().flatten().filter(|run| run.contradiction.is_some()).count();
    let holds = if all.not_outside == all.points && contradicted == 0 {
        "The state was never lost"
    } else {
        "The state was lost, so the guarantee is broken"
    };
    format!(
        "**{holds}**: {} of {} sets of {runs} runs do not exclude the truth; {inside}. {contradicted} runs ended with a contradiction.",
        all.not_outside, all.points
    )
}

fn lost(losses: &[Loss]) -> String {
    let share = |watched: Watched| {
        let of = losses.iter().filter(|loss| loss.watched == watched);
        let runs: Vec<_> = of.flat_map(|loss| &loss.runs).collect();
        format!("{} of {}", runs.iter().filter(|run| run.violated > 0).count(), runs.len())
    };
    let [zsmf, inzsmf, zsmf_signed, inzsmf_signed] = Watched::ALL.map(share);
    format!(
        "**The paper's filters lose it** on the same noises, started with sets that hold it: ZSMF in {zsmf} runs and InZSMF in {inzsmf} \
         with valid reductions, {zsmf_signed} and {inzsmf_signed} as published."
    )
}

fn mean(cell: &Cell, of: impl Fn(&crate::guaranteed_invariant::planar::Sizes) -> f64) -> f64 {
    cell.runs.iter().map(of).sum::<f64>() / cell.runs.len().max(1) as f64
}

fn sizes(evidence: &Evidence<'_>) -> Vec<String> {
    let mut findings = Vec::new();
    for drive in Drive::ALL {
        let Some(cell) = evidence.strips.iter().find(|cell| cell.drive == drive && cell.case.is_none()) else {
            continue;
        };
        let [whole, settled] = [0, 1].map(|late| {
            [0, 1].map(|k| significant(mean(cell, |run| if late == 1 { run.settled[k] } else { run.whole[k] }), 3))
        });
        let mut text = format!(
            "**{}, heading unknown**: mean heading width {} rad, mean area {} m^2; from k = {SETTLED} on {} rad and {} m^2.",
            drive.name(),
            whole[0],
            whole[1],
            settled[0],
            settled[1]
        );
        for mode in [Mode::Published, Mode::Sound] {
            let cells: Vec<&Cell> = evidence
                .first_order
                .iter()
                .filter(|other| other.drive == drive && other.mode == mode && other.method == "inzsmf")
                .collect();
            let ratio = |k: usize| {
                let other = cells.iter().map(|other| mean(other, |run| run.whole[k])).fold(f64::INFINITY, f64::min);
                significant(other / mean(cell, |run| run.whole[k]), 3)
            };
            if !cells.is_empty() {
                text += &format!(
                    " InZSMF ({}) from its best initial estimate: {} times the heading, {} times the area.",
                    mode.name(),
                    ratio(0),
                    ratio(1)
                );
            }
        }
        findings.push(text);
    }
    findings
}

fn proofs(studies: &[Broken]) -> String {
    let part = |study: &Broken| {
        let found = study.found();
        let latest = found.iter().copied().fold(0.0, f64::max);
        let head = format!(
            "{} times the bounds, {}: {} of {} runs",
            study.excess,
            study.drive.name(),
            found.len(),
            study.steps.len()
        );
        if found.is_empty() {
            head
        } else {
            format!("{head}, at the latest at step {latest} ({} s)", significant(latest * PERIOD_S, 3))
        }
    };
    let parts: Vec<String> = studies.iter().map(part).collect();
    format!("**Noises beyond the bounds are proven**: {}.", parts.join("; "))
}

fn sharp(levers: &[Runs]) -> Option<String> {
    let last: Vec<_> = levers.get(SHARP)?.iter().filter_map(|run| run.steps.last()).collect();
    let mean = |of: fn(&crate::guaranteed_invariant::lever_run::LeverStep) -> f64| {
        significant(last.iter().map(|step| of(step)).sum::<f64>() / last.len().max(1) as f64, 3)
    };
    Some(format!(
        "**Problem 3, {}**: from an unknown heading, a scale in [0.8, 1.25] and an arm in a box of 6 m, after 100 s the heading is known within \
         {} rad, the scale within {}, the arm within {} by {} m (widths, means of {} runs).",
        SETTINGS[SHARP].label,
        mean(|step| step.heading_rad),
        mean(|step| step.scale.width()),
        mean(|step| step.arm_m[0].width()),
        mean(|step| step.arm_m[1].width()),
        last.len()
    ))
}

fn robot(log: &RobotLog) -> Vec<String> {
    log.cells.iter().map(|cell| robot_cell(log, cell)).collect()
}

fn robot_cell(log: &RobotLog, cell: &RobotCell) -> String {
    let (fix_m, source, window_s) = (cell.bounds.fix_m, cell.source.name(), log.log.window_s);
    let head = format!("**Log {}, windows of {window_s} s, fixes within {fix_m} m, {source}**", log.log.number);
    let runs = cell.runs.len();
    let seconds = |of: fn(&LeverRun) -> Option<usize>| cell.runs.iter().filter_map(of).collect::<Vec<_>>();
    let (proofs, lost) = (seconds(|run| run.contradiction), seconds(LeverRun::lost));
    if !cell.source.holds() {
        let at = |seconds: &[usize]| match (seconds.iter().min(), seconds.iter().max()) {
            (Some(first), Some(last)) => format!("in {} of {runs} runs, at window {first} to {last}", seconds.len()),
            _ => "in no run".to_owned(),
        };
        let first = cell.runs.iter().find_map(|run| run.contradiction.map(|second| (second, &run.culprits)));
        let named = first.map_or_else(String::new, |(second, culprits)| {
            let named: Vec<String> = culprits.iter().map(ToString::to_string).collect();
            format!(" The first proof, at window {second}, names: {}.", named.join(", "))
        });
        return format!("{head}: bounds proven wrong {}; reference proven outside {}.{named}", at(&proofs), at(&lost));
    }
    let ends: Vec<_> = cell.runs.iter().filter_map(|run| run.steps.last()).collect();
    let mean = |of: &dyn Fn(&crate::guaranteed_invariant::lever_run::LeverStep) -> f64| {
        ends.iter().map(|step| of(step)).sum::<f64>() / ends.len().max(1) as f64
    };
    let holds = ends.iter().filter(|step| step.scale.contains(log.log.scale)).count();
    let limit = cell.admissible.map_or("none".to_owned(), |[lo, hi]| significant(hi - lo, 3));
    format!(
        "{head}: reference {} at the end scale in [{}, {}] (means of {runs} runs), holding the least-squares one, {}, in {holds}; the bound \
         on the speed alone leaves a width of {limit}. Heading within {} rad.",
        if lost.is_empty() && proofs.is_empty() { "contained at every step;" } else { "LOST;" },
        significant(mean(&|step| step.scale.lo()), 4),
        significant(mean(&|step| step.scale.hi()), 4),
        significant(log.log.scale, 4),
        significant(mean(&|step| step.heading_rad), 3),
    )
}

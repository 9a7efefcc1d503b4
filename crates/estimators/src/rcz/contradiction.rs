//! Proofs that no state is left, with the names of those that contradict each other.

use nonlin_bounds::Conflict;
use scalars::Interval;
use setrep::{ConstrainedZonotope, Emptiness, Workspace};

use super::state::RczState;
use crate::{Culprit, EstimatorError, Evidence, Inconsistency};

/// A set whose own hull has no point in common with the box that the state is `held` in.
pub(super) fn of_hull(
    step: u64,
    set: &ConstrainedZonotope,
    (own, held): (&[Interval], &[Interval]),
    rows: &[Culprit],
    workspace: &mut Workspace,
) -> EstimatorError {
    by_rows(step, set, rows, workspace).unwrap_or_else(|| {
        let (predicted, required) = own
            .iter()
            .zip(held)
            .find(|(own, held)| own.disjoint(held))
            .map_or((Interval::EMPTY, Interval::EMPTY), |(own, held)| (*own, *held));
        let evidence = Evidence::Disjoint { predicted, required };
        inconsistent(step, everyone(rows), evidence)
    })
}

/// A box of states over which propagation found a conflict. The rows over that box often show it as well, with multipliers.
pub(super) fn of_propagation(
    state: &RczState,
    set: &ConstrainedZonotope,
    (culprit, conflict): (fn(usize) -> Culprit, Conflict),
    rows: &[Culprit],
    workspace: &mut Workspace,
) -> EstimatorError {
    by_rows(state.step, set, rows, workspace).unwrap_or_else(|| {
        let culprits = match conflict {
            Conflict::Output { output, .. } => vec![culprit(output), Culprit::Prediction],
            _ => everyone(rows),
        };
        inconsistent(state.step, culprits, Evidence::Propagation { hull: state.hull.clone() })
    })
}

/// The proof by multipliers, if there is one.
fn by_rows(
    step: u64,
    set: &ConstrainedZonotope,
    rows: &[Culprit],
    workspace: &mut Workspace,
) -> Option<EstimatorError> {
    let Ok(Emptiness::ProvenEmpty(certificate)) = set.emptiness(workspace) else { return None };
    let mut culprits: Vec<Culprit> = if rows.len() == set.num_constraints() {
        certificate.multipliers().iter().filter_map(|(row, _)| rows.get(*row).copied()).collect()
    } else {
        // Rescaling has dropped rows, so that their places are lost.
        everyone(rows)
    };
    culprits.sort_unstable();
    culprits.dedup();
    Some(inconsistent(step, culprits, Evidence::Rows { set: Box::new(set.clone()), certificate }))
}

/// All that had a part, each once.
fn everyone(rows: &[Culprit]) -> Vec<Culprit> {
    let mut culprits: Vec<Culprit> = rows.iter().copied().chain([Culprit::Prediction]).collect();
    culprits.sort_unstable();
    culprits.dedup();
    culprits
}

fn inconsistent(step: u64, culprits: Vec<Culprit>, evidence: Evidence) -> EstimatorError {
    EstimatorError::Inconsistent(Box::new(Inconsistency { step, culprits, evidence }))
}

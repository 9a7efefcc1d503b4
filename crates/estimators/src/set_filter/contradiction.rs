//! Proofs that no state is left, with the names of those that contradict each other.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Emptiness, Workspace};

use super::{Equation, FilterState};
use crate::{Culprit, EstimatorError, Evidence, Guarantee, Inconsistency};

/// A set whose own hull has no point in common with the box that the state is `held` in.
pub(crate) fn of_hull(
    step: u64,
    set: &ConstrainedZonotope,
    (own, held): (&[Interval], &[Interval]),
    rows: &[Culprit],
    workspace: &mut Workspace,
) -> EstimatorError {
    by_rows(step, set, rows, workspace).unwrap_or_else(|| {
        let apart = own.iter().zip(held).find(|(own, held)| !own.is_empty() && !held.is_empty() && own.disjoint(held));
        let evidence = match apart {
            Some((&predicted, &required)) => Evidence::Disjoint { predicted, required },
            // The bounds of the set itself cross.
            None => Evidence::Propagation { hull: held.to_vec() },
        };
        inconsistent(step, rows.to_vec(), evidence)
    })
}

/// A box of states over which an equation has no solution, as its outputs `culprits` show. The rows over that box often show it as
/// well, with multipliers.
pub(crate) fn of_values<M>(
    state: &FilterState<ConstrainedZonotope, M>,
    set: &ConstrainedZonotope,
    (equation, culprits): (&Equation<'_>, Vec<Culprit>),
    rows: &[Culprit],
    workspace: &mut Workspace,
) -> EstimatorError {
    by_rows(state.step, set, rows, workspace).unwrap_or_else(|| {
        let evidence = Evidence::Values {
            hull: state.hull.clone(),
            invariant: equation.noise.is_none(),
            required: equation.values.to_vec(),
            parameters: equation.parameters.to_vec(),
        };
        inconsistent(state.step, culprits, evidence)
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
    let culprits: Vec<Culprit> = if rows.len() == set.num_constraints() {
        certificate.multipliers().iter().filter_map(|(row, _)| rows.get(*row).copied()).collect()
    } else {
        // Rescaling has dropped rows, so that their places are lost.
        rows.to_vec()
    };
    Some(inconsistent(step, culprits, Evidence::Rows { set: Box::new(set.clone()), certificate }))
}

/// The error, with each culprit once; the prediction always is one: its coordinates are bounded in every proof.
pub(crate) fn inconsistent(step: u64, mut culprits: Vec<Culprit>, evidence: Evidence) -> EstimatorError {
    culprits.push(Culprit::Prediction);
    culprits.sort_unstable();
    culprits.dedup();
    EstimatorError::Inconsistent(Box::new(Inconsistency { step, culprits, evidence, guarantee: Guarantee::Rigorous }))
}

/// The error, with what the filter that reports it promises.
pub(crate) fn under(guarantee: Guarantee, error: EstimatorError) -> EstimatorError {
    match error {
        EstimatorError::Inconsistent(mut inconsistency) if guarantee != Guarantee::Rigorous => {
            inconsistency.guarantee = guarantee;
            EstimatorError::Inconsistent(inconsistency)
        }
        error => error,
    }
}

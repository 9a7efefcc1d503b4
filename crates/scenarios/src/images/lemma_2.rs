//! The counterexample to Lemma 2 of paper 003 as printed: a true state is cut off.

use nalgebra::DVector;
use scalars::Interval;
use setrep::{IntervalVector, Membership, Workspace};

use super::models::UnitProduct;
use super::plane::enclosure_of;
use crate::published::CgRep;
use crate::published::taylor::{Cross, consistent};
use crate::{Mode, Row, ScenarioError};

/// A member of the set with `x_1 x_2 = 1`.
const STATE: [f64; 2] = [1.0, 1.0];
/// The expansion point: not the centre.
const GAMMA: [f64; 2] = [0.0, -1.0];

/// Whether the states of `[-1, 1]^2` with `x_1 x_2 = 1` that Corollary 2 about `(0, -1)` leaves have `(1, 1)` among them.
///
/// # Errors
/// [`ScenarioError::Bound`] if the extension fails.
pub fn verdict(cross: Cross, workspace: &mut Workspace) -> Result<Membership, ScenarioError> {
    let set = CgRep::zonotope(&[0.0, 0.0], &[&[1.0, 0.0], &[0.0, 1.0]]);
    let hull = [Interval::ZERO.inflate(1.0); 2];
    let gamma = DVector::from_column_slice(&GAMMA);
    let left = enclosure_of(consistent(&UnitProduct, &set, &hull, &gamma, cross)?)?;
    Ok(left.region().membership(&IntervalVector::point(&STATE), workspace)?)
}

/// One row for each form of the cross term: 1 if the state is kept, 0 if it is proven to be lost.
///
/// # Errors
/// As [`verdict`].
pub fn rows(workspace: &mut Workspace) -> Result<Vec<Row>, ScenarioError> {
    let forms = [(Mode::Published, Cross::AsPrinted), (Mode::Sound, Cross::Symmetrised)];
    let row = |(mode, cross)| {
        let kept = verdict(cross, workspace)? != Membership::ProvenOutside;
        let row = Row::new("Lemma 2", "g=x1*x2, gamma=(0,-1), x=(1,1)", "czfo+c").mode(mode);
        Ok(row.metric("containment", "").value(f64::from(u8::from(kept))))
    };
    forms.into_iter().map(row).collect()
}

//! The sets of the first steps, for Figure 2.

use setrep::Workspace;

use crate::ScenarioError;
use crate::images::outline::outline;
use crate::set_study::course::follow;
use crate::set_study::{Contender, Trajectory};

/// Steps shown.
pub const STEPS: usize = 4;

/// The sets of the filters after the updates of the first steps, and the true states.
#[derive(Debug, Clone)]
pub struct Snapshots {
    /// A filter's name and the vertices of its sets, as far as it got.
    pub sets: Vec<(String, Vec<Vec<[f64; 2]>>)>,
    /// The true states.
    pub truth: Vec<[f64; 2]>,
}

/// Takes them.
///
/// # Errors
/// Those of the filters and of the set operations.
pub fn take(trajectory: &Trajectory, contenders: &[Contender]) -> Result<Snapshots, ScenarioError> {
    let start = Trajectory {
        states: trajectory.states.iter().take(STEPS).cloned().collect(),
        inputs: trajectory.inputs.clone(),
        outputs: trajectory.outputs.iter().take(STEPS).cloned().collect(),
    };
    let mut workspace = Workspace::new();
    let mut sets = Vec::new();
    for contender in contenders {
        let mut outlines = Vec::new();
        follow(&start, &mut *contender.start(())?, &mut |_| {}, &mut |_, filter| {
            outlines.push(outline(filter.region(), &mut workspace)?);
            Ok(())
        })?;
        sets.push((contender.method.clone(), outlines));
    }
    let truth = start.states.iter().map(|state| [state[0].mid(), state[1].mid()]).collect();
    Ok(Snapshots { sets, truth })
}

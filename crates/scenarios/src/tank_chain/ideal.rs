//! The yardstick: what the whole history says about a linearised chain.

use nonlin_bounds::{AffineEnclosure, Domain, Form, Workspace};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix};

use super::plant::{Levels, OUTPUT_NOISE, PROCESS_NOISE, Tanks, start};
use crate::ScenarioError;
use crate::set_study::Trajectory;
use crate::set_study::course::radius;

/// Radii, at the steps asked for, of the hull of all levels that agree with every measurement so far if the dynamics were those linearised at
/// the true levels: nothing is reduced, and there are no remainders.
///
/// A guaranteed filter can be at it, seldom below: it does not know where to linearise. The set grows by `n` generators and by a constraint
/// for each measurement a step.
///
/// # Errors
/// Those of the set operations.
pub fn radii(n: usize, run: &Trajectory, at: &[usize]) -> Result<Vec<f64>, ScenarioError> {
    let (plant, mut workspace) = (Tanks { n }, Workspace::new());
    let noise = ConstrainedZonotope::from_box(&vec![0.0; n], &vec![PROCESS_NOISE; n])?;
    let mut rows = Matrix::zeros(Levels { n }.measured().count(), n);
    for (row, tank) in (Levels { n }).measured().enumerate() {
        rows[(row, tank)] = 1.0;
    }
    let (mut set, mut enclosure, mut radii) = (start(n)?, AffineEnclosure::new(), Vec::new());
    for (k, (x, y)) in run.states.iter().zip(&run.outputs).enumerate() {
        let ranges: Vec<Interval> = y.iter().map(|&y| Interval::point(y).inflate(OUTPUT_NOISE)).collect();
        set.materialize();
        set.intersect_rows(&rows, &ranges, &mut workspace.sets)?;
        if at.contains(&k) {
            radii.push(radius(&set.interval_hull(&mut workspace.sets)?));
        }
        if at.iter().all(|&step| step <= k) {
            break;
        }
        let x: Vec<f64> = x.iter().map(Interval::mid).collect();
        let (point, hull) = at_truth(&x);
        enclosure.enclose(Form::Taylor, &plant, &Domain::new(&hull, &point), &mut workspace)?;
        set = moved(set, &x, &enclosure, &noise, &mut workspace.sets)?;
    }
    Ok(radii)
}

/// The true levels without noise, as a point and as a box.
fn at_truth(x: &[f64]) -> (Vec<f64>, Vec<Interval>) {
    let point: Vec<f64> = x.iter().copied().chain(std::iter::repeat_n(0.0, x.len())).collect();
    let hull = point.iter().map(|&x| Interval::point(x)).collect();
    (point, hull)
}

/// `f(x) + J (X - x) + W`.
fn moved(
    mut set: ConstrainedZonotope,
    x: &[f64],
    enclosure: &AffineEnclosure,
    noise: &ConstrainedZonotope,
    workspace: &mut setrep::Workspace,
) -> Result<ConstrainedZonotope, ScenarioError> {
    let n = x.len();
    let jacobian = Matrix::from_column_slice(n, n, &enclosure.jacobian().as_slice()[..n * n])?;
    set.translate(&x.iter().map(|x| -x).collect::<Vec<f64>>())?;
    set.linear_map_in_place(&jacobian, workspace)?;
    set.translate(&enclosure.offsets().iter().map(Interval::mid).collect::<Vec<f64>>())?;
    set.add_assign(noise)?;
    Ok(set)
}

//! The sets of one run, step by step, with images of points of the first set.

use nonlin_bounds::DynFunction;
use scalars::Interval;
use setrep::{Outline, Workspace};

use crate::ScenarioError;
use crate::figure::{Figure, Look, Panel, Series};
use crate::set_study::course::follow;
use crate::set_study::{Contender, Trajectory};

/// The outlines of one filter, step by step; fewer where it gave up.
#[derive(Debug, Clone)]
pub struct Outlines {
    /// The filter.
    pub method: String,
    /// Corners of the projection on two coordinates.
    pub steps: Vec<Vec<[f64; 2]>>,
}

/// Follows a run with every filter and keeps the outlines of the updated sets.
///
/// # Errors
/// Those of the filters and of the outlines.
pub fn outlines(
    trajectory: &Trajectory,
    contenders: &[Contender],
    axes: [usize; 2],
) -> Result<Vec<Outlines>, ScenarioError> {
    let of = |contender: &Contender| {
        let (mut steps, mut workspace) = (Vec::new(), Workspace::new());
        follow(trajectory, &mut *contender.start(())?, &mut |_| {}, &mut |_, filter| {
            steps.push(Outline::new(filter.region(), axes, &mut workspace)?.outer);
            Ok(())
        })?;
        Ok(Outlines { method: contender.method.clone(), steps })
    };
    contenders.iter().map(of).collect()
}

/// Images of points under the dynamics without noise, step by step, the points first.
///
/// # Errors
/// Those of the function.
pub fn images(
    dynamics: &dyn DynFunction,
    points: Vec<Vec<f64>>,
    steps: usize,
) -> Result<Vec<Vec<Vec<f64>>>, ScenarioError> {
    let mut images = vec![points];
    for k in 0..steps {
        let next = |x: &Vec<f64>| {
            let mut y = vec![0.0; x.len()];
            let noises = vec![0.0; dynamics.variables() - x.len()];
            dynamics.value(&[&x[..], &noises].concat(), &[], &mut y)?;
            Ok(y)
        };
        let moved = images[k].iter().map(next).collect::<Result<Vec<_>, ScenarioError>>()?;
        images.push(moved);
    }
    Ok(images)
}

/// A panel a step: the outlines, the images of points, the state.
#[must_use]
pub fn figure(
    (name, title): (&str, &str),
    (axes, labels): ([usize; 2], [&str; 2]),
    outlines: &[Outlines],
    images: &[Vec<Vec<f64>>],
    trajectory: &Trajectory,
) -> Figure {
    let on_axes = |x: &Vec<f64>| (x[axes[0]], x[axes[1]]);
    let mut figure = Figure::new(name, title, 3);
    for (k, state) in trajectory.states.iter().enumerate() {
        let mut panel = Panel::new(format!("k = {k}"), labels[0], labels[1]);
        for outlines in outlines {
            if let Some(corners) = outlines.steps.get(k) {
                let corners = corners.iter().map(|&[x, y]| (x, y));
                panel = panel.with(Series::outline(&*outlines.method, look(&outlines.method), corners));
            }
        }
        if let Some(points) = images.get(k) {
            let near = points.iter().map(on_axes).filter(|&(x, y)| is_near(outlines, k, [x, y]));
            panel = panel.with(Series::points("images of points of X0", Look::nth(7), near));
        }
        let state: Vec<f64> = state.iter().map(Interval::mid).collect();
        figure = figure.with(panel.with(Series::points("state", Look::nth(6), [on_axes(&state)])));
    }
    figure
}

/// Whether a point is no further from the sets of a step than half their widths: what has left cannot be seen beside them.
fn is_near(outlines: &[Outlines], k: usize, point: [f64; 2]) -> bool {
    (0..2).all(|axis| {
        let corners = outlines.iter().filter_map(|outlines| outlines.steps.get(k)).flatten().map(|corner| corner[axis]);
        let (lo, hi) = corners.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| (lo.min(x), hi.max(x)));
        let margin = 0.5 * (hi - lo);
        (lo - margin..=hi + margin).contains(&point[axis])
    })
}

/// Colour by filter, dash for variants.
#[must_use]
pub fn look(method: &str) -> Look {
    let color = match method.split('/').next() {
        Some("vh") => 1,
        Some("rrsr") => 2,
        Some("d-zb") => 3,
        Some("d-cz") => 4,
        Some("comb") => 5,
        _ => 0,
    };
    let look = Look::nth(color);
    if method.contains('/') { look.dashed(1) } else { look }
}

//! Figure 4 of paper 003: a parallelogram refined by the invariant `|x|^2 = 1`, with and without a box known beforehand.

use nalgebra::{DMatrix, DVector};
use scalars::Interval;
use setrep::{Matrix, VPolytope, Workspace};

use super::enclosure::Enclosure;
use super::methods::{Method, method_name};
use super::models::UnitCircle;
use super::plane::{Shape, enclosure_of};
use super::sets::{Form, Sets};
use crate::published::taylor::{Cross, consistent as taylor};
use crate::published::{CgRep, mean_value};
use crate::{Mode, ScenarioError};

/// Points of the circle that are looked at.
const SAMPLES: usize = 401;

/// `X_0`.
#[must_use]
pub fn parallelogram() -> CgRep {
    CgRep::zonotope(&[1.3, 0.0], &[&[0.2, 0.2], &[0.0, 0.2]])
}

/// `X_0` intersected with the box `[-1, 1]^2`, which holds every point of the circle.
#[must_use]
pub fn boxed() -> CgRep {
    let unit_box = CgRep::from_box(&DVector::zeros(2), &DVector::from_element(2, 1.0));
    parallelogram().intersect(&DMatrix::identity(2, 2), &unit_box)
}

/// Boxes around points of the circle that are proven to lie in `X_0`, hence in every set of the figure.
#[must_use]
pub fn arc() -> Vec<Vec<Interval>> {
    let generator = Interval::point(0.2);
    let point = |k: usize| {
        let x2 = Interval::point(-0.2 + 0.4 * k as f64 / (SAMPLES - 1) as f64);
        vec![(Interval::ONE - x2.sqr()).sqrt(), x2]
    };
    // x = (1.3 + 0.2 a + 0.2 b, 0.2 b) with the floats next to 1.3 and 0.2.
    let is_member = |x: &Vec<Interval>| {
        x[1].subset_of(&Interval::ZERO.hull(generator).hull(-generator))
            && (x[0] - x[1]).add_f64(-1.3).subset_of(&generator.hull(-generator))
    };
    (0..SAMPLES).map(point).filter(is_member).collect()
}

/// The sets of the figure, and those of Corollary 2 beside them.
///
/// # Errors
/// [`ScenarioError::Bound`] if an extension fails.
pub fn published(workspace: &mut Workspace) -> Result<Vec<Shape>, ScenarioError> {
    let mut shapes = Vec::new();
    let cases = [
        ("X0", parallelogram(), 0.16, 0.041605, 0.012_011_8),
        ("X0 and box", boxed(), 0.005, 0.000_993_695, 0.004_319_44),
    ];
    for (row, set, area, corollary_1, corollary_2) in cases {
        let enclosure = set.to_set()?;
        let hull = enclosure.interval_hull(workspace)?;
        let shape = |method: &str, mode, reference, set| Shape {
            row,
            method: method.to_owned(),
            mode,
            reference: Some(reference),
            set,
        };
        shapes.push(shape("set", None, area, Enclosure::Constrained(enclosure)));
        let gamma = mean_value::c2(&set, &hull).ok_or(setrep::SetError::EmptySet)?;
        let first = enclosure_of(mean_value::consistent(&UnitCircle, &set, &hull, &gamma)?)?;
        shapes.push(shape("czmv+c", Some(Mode::Sound), corollary_1, first));
        let gamma = mean_value::c3(&set, &hull);
        let second = enclosure_of(taylor(&UnitCircle, &set, &hull, &gamma, Cross::AsPrinted)?)?;
        shapes.push(shape("czfo+c", Some(Mode::Sound), corollary_2, second));
    }
    Ok(shapes)
}

/// What the methods of this library leave of both sets.
///
/// # Errors
/// [`ScenarioError::Bound`] if a method fails.
pub fn rigorous(workspace: &mut nonlin_bounds::Workspace) -> Result<Vec<Shape>, ScenarioError> {
    let corners: [&[&[f64]]; 2] =
        [&[&[1.7, 0.2], &[1.3, 0.2], &[0.9, -0.2], &[1.3, -0.2]], &[&[0.9, -0.2], &[1.0, -0.2], &[1.0, -0.1]]];
    let mut shapes = Vec::new();
    for ((row, set), corners) in [("X0", parallelogram()), ("X0 and box", boxed())].into_iter().zip(corners) {
        let constrained = set.to_set()?;
        // The rounding of the corners.
        let vertices = VPolytope::with_remainder(Matrix::from_columns(corners)?, &[1e-15; 2])?;
        let sets = Sets { zonotope: constrained.unconstrained().clone(), constrained, vertices };
        for form in [Form::Constrained, Form::Vertices] {
            for &method in Method::of_solutions(form) {
                let set = method.solution(&UnitCircle, &sets, form, &[Interval::ZERO], workspace)?;
                let method = method_name(method, form);
                shapes.push(Shape { row, method, mode: Some(Mode::Rigorous), reference: None, set });
            }
        }
    }
    Ok(shapes)
}

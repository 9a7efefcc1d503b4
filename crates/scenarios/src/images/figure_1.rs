//! Figure 1 of paper 003: images of a triangle by Taylor and mean value extensions about several points.

use nalgebra::DVector;
use nonlin_bounds::{DynFunction, Jet, Order, Workspace};
use scalars::Interval;
use setrep::{Matrix, VPolytope};

use super::enclosure::Enclosure;
use super::methods::{Method, method_name};
use super::models::Planar;
use super::plane::{Shape, enclosure_of};
use super::sets::{Form, Sets};
use crate::published::taylor::{Cross, image as taylor};
use crate::published::{CgRep, mean_value};
use crate::{Mode, ScenarioError};

/// The point of the triangle next to its centre in the 1-norm.
const CLOSEST: [f64; 2] = [5.5, 0.5];
/// The middle of the triangle's hull: C1, and for the mean value extension also C2.
const HULL_CENTER: [f64; 2] = [5.75, 0.5];
/// Barycentric coordinates of the samples are multiples of its reciprocal: all samples are floats.
const MESH: usize = 32;

/// The set of the figure, the triangle with the corners `(6.5, 1)`, `(5.5, 0.5)`, `(5, 0)`, with its centre outside.
#[must_use]
pub fn triangle() -> CgRep {
    CgRep::zonotope(&[5.0, 0.5], &[&[0.5, 1.0, -0.5], &[0.5, 0.5, 0.0]]).constrained(&[&[-1.0, 1.0, -1.0]], &[2.0])
}

/// The corners of the triangle.
///
/// # Errors
/// None: the corners are finite.
pub fn corners() -> Result<VPolytope, ScenarioError> {
    Ok(VPolytope::new(Matrix::from_columns(&[&[6.5, 1.0], &[5.5, 0.5], &[5.0, 0.0]])?)?)
}

/// The hull of the triangle.
#[must_use]
pub fn hull() -> [Interval; 2] {
    [Interval::point(5.75).inflate(0.75), Interval::point(0.5).inflate(0.5)]
}

/// Members of the triangle, exactly.
#[must_use]
pub fn samples() -> Vec<[f64; 2]> {
    let share = |k: usize| k as f64 / MESH as f64;
    let member = |i: usize, j: usize| {
        let (a, b, c) = (share(i), share(j), share(MESH - i - j));
        [6.5 * a + 5.5 * b + 5.0 * c, a + 0.5 * b]
    };
    (0..=MESH).flat_map(|i| (0..=MESH - i).map(move |j| member(i, j))).collect()
}

/// Their images, enclosed.
///
/// # Errors
/// None: the function is defined there.
pub fn images() -> Result<Vec<Vec<Interval>>, ScenarioError> {
    let mut jet = Jet::new();
    let image = |x: [f64; 2]| {
        Planar.enclose(Order::Value, &x.map(Interval::point), &[], &mut jet)?;
        Ok(jet.values().to_vec())
    };
    samples().into_iter().map(image).collect()
}

/// The enclosures of the figure and their relatives, by the algorithms of paper 003; `reference` is the area of an independent computation.
///
/// # Errors
/// [`ScenarioError::Bound`] if an extension fails.
pub fn published() -> Result<Vec<Shape>, ScenarioError> {
    let (set, hull) = (triangle(), hull());
    let shape = |row: &'static str, method: &'static str, mode: Mode, reference: f64, set: Option<CgRep>| {
        let set = enclosure_of(set)?;
        Ok::<_, ScenarioError>(Shape { row, method: method.into(), mode: Some(mode), reference: Some(reference), set })
    };
    let point = |x: &[f64]| DVector::from_column_slice(x);
    let second = |gamma: &[f64], cross: Cross| taylor(&Planar, &set, &hull, &point(gamma), cross);
    let first = |gamma: &[f64]| mean_value::image(&Planar, &set, &hull, &point(gamma));
    let (closest, middle) = ("gamma = closest point of X", "gamma = middle of the hull");
    Ok(vec![
        shape("gamma = c", "czfo", Mode::Sound, 0.720843, second(set.center.as_slice(), Cross::AsPrinted)?)?,
        shape(closest, "czfo", Mode::Published, 1.055091, second(&CLOSEST, Cross::AsPrinted)?)?,
        shape(closest, "czfo", Mode::Sound, 0.955999, second(&CLOSEST, Cross::Symmetrised)?)?,
        shape(middle, "czfo", Mode::Published, 1.250827, second(&HULL_CENTER, Cross::AsPrinted)?)?,
        shape(middle, "czfo", Mode::Sound, 1.084798, second(&HULL_CENTER, Cross::Symmetrised)?)?,
        shape(middle, "czmv", Mode::Sound, 0.327099, first(&HULL_CENTER)?)?,
        shape(closest, "czmv", Mode::Sound, 0.427367, first(&CLOSEST)?)?,
    ])
}

/// The enclosures of this library, about the middle of the hull.
///
/// # Errors
/// [`ScenarioError::Bound`] if a method fails.
pub fn rigorous() -> Result<Vec<Shape>, ScenarioError> {
    let constrained = triangle().to_set()?;
    let sets = Sets { zonotope: constrained.unconstrained().clone(), constrained, vertices: corners()? };
    let mut workspace = Workspace::new();
    let mut shapes = Vec::new();
    for form in [Form::Constrained, Form::Vertices] {
        for &method in Method::of_images(form) {
            let set = method.image(&Planar, &sets, form, &mut workspace)?;
            let row = "gamma = middle of the hull";
            shapes.push(Shape {
                row,
                method: method_name(method, form),
                mode: Some(Mode::Rigorous),
                reference: None,
                set,
            });
        }
    }
    Ok(shapes)
}

/// The same set as it came: for the panel of the figure.
///
/// # Errors
/// None: its numbers are finite.
pub fn source() -> Result<Enclosure, ScenarioError> {
    Ok(Enclosure::Constrained(triangle().to_set()?))
}

//! Figures 1 and 4 of paper 003, and ours beside them.

use scalars::Interval;
use setrep::Workspace;

use super::plane::Measured;
use super::{figure_1, outline};
use crate::figure::{Figure, Look, Panel, Series};
use crate::{Mode, ScenarioError};

/// The triangle with its hull and centre; the image with the enclosures of it.
///
/// # Errors
/// Those of the set operations.
pub fn figure_1(
    sets: &[Measured],
    images: &[Vec<Interval>],
    workspace: &mut Workspace,
) -> Result<Figure, ScenarioError> {
    let triangle = outline::outline(figure_1::source()?.region(), workspace)?;
    let hull = outline::outline(&setrep::IntervalVector::new(figure_1::hull().to_vec()), workspace)?;
    let left = Panel::new("(a) the set", "x1", "x2")
        .with(Series::outline("interval hull", Look::REFERENCE.dashed(1), pairs(&hull)))
        .with(Series::outline("X", Look::nth(0).solid(), pairs(&triangle)))
        .with(Series::points("centre of X", Look::nth(6), [(5.0, 0.5)]));
    let mut right = Panel::new("(b) its image and enclosures", "f1", "f2");
    right = right.with(Series::points(
        "sampled image",
        Look::REFERENCE,
        images.iter().map(|image| (image[0].mid(), image[1].mid())),
    ));
    for (k, set) in sets.iter().filter(|set| shown(set)).enumerate() {
        right = right.with(Series::outline(label(set), Look::nth(k + 1), pairs(&set.outline)));
    }
    let title = "Enclosures of the image of a triangle (paper 003: Figure 1)";
    Ok(Figure::new("figure-1", title, 2).with(left).with(right))
}

/// The parallelogram, what the invariant leaves of it, and the circle; on the right what it leaves of the part in the box.
#[must_use]
pub fn figure_4(sets: &[Measured]) -> Figure {
    let circle = |from: i32, to: i32| {
        let angles = (from..=to).map(|k| f64::from(k) / 100.0);
        Series::line("|x| = 1", Look::REFERENCE, angles.map(|angle| (angle.cos(), angle.sin())))
    };
    let whole = Panel::new("(a) from the set", "x1", "x2").equal_aspect().with(circle(-50, 50)).with(Series::line(
        "box",
        Look::REFERENCE.dashed(1),
        [(1.0, -0.45), (1.0, 0.45)],
    ));
    let part = Panel::new("(b) from its part in the box", "x1", "x2").equal_aspect().with(circle(-21, -8));
    let [whole, part] = [(whole, "X0"), (part, "X0 and box")].map(|(panel, row)| {
        let shown = |set: &&Measured| {
            set.shape.row == row && (set.shape.mode != Some(Mode::Rigorous) || set.shape.method == "taylor/cz")
        };
        sets.iter().filter(shown).enumerate().fold(panel, |panel, (k, set)| {
            let mode = if set.shape.mode == Some(Mode::Rigorous) { " (ours)" } else { "" };
            let label = format!("{}{mode}", set.shape.method);
            panel.with(Series::outline(label, Look::nth(k), pairs(&set.outline)))
        })
    });
    Figure::new("figure-4", "A parallelogram refined by an invariant (paper 003: Figure 4)", 2).with(whole).with(part)
}

/// The sets of the paper's Figure 1 and a few beside them: all would hide each other.
fn shown(set: &Measured) -> bool {
    match set.shape.mode {
        Some(Mode::Rigorous) => ["taylor/cz", "quadratic/cz", "polytopic/v"].contains(&&*set.shape.method),
        _ => set.shape.method == "czmv" || set.shape.row != "gamma = middle of the hull",
    }
}

fn pairs(outline: &[[f64; 2]]) -> impl Iterator<Item = (f64, f64)> + '_ {
    outline.iter().map(|&[x, y]| (x, y))
}

fn label(set: &Measured) -> String {
    let mode = match set.shape.mode {
        Some(Mode::Published) => " (as printed)",
        Some(Mode::Rigorous) => " (ours)",
        _ => "",
    };
    format!("{}, {}{mode}", set.shape.method, set.shape.row)
}

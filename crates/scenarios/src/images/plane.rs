//! Planar sets with a name, their areas and whether they hold the samples.

use scalars::Interval;
use setrep::{SetError, Workspace};

use super::enclosure::Enclosure;
use super::outline::{area, outline};
use crate::published::CgRep;
use crate::region::Containment;
use crate::{Mode, Row, ScenarioError};

/// A named enclosure in the plane.
#[derive(Debug, Clone)]
pub struct Shape {
    /// What varies.
    pub row: &'static str,
    /// The method.
    pub method: String,
    /// How it was run; none for sets that no method made.
    pub mode: Option<Mode>,
    /// The area that an independent computation of ours found.
    pub reference: Option<f64>,
    /// The set.
    pub set: Enclosure,
}

/// A [`Shape`] with what was measured.
#[derive(Debug, Clone)]
pub struct Measured {
    /// The set and its names.
    pub shape: Shape,
    /// Its vertices, counterclockwise.
    pub outline: Vec<[f64; 2]>,
    /// Its area.
    pub area: f64,
    /// Whether it holds the points it has to.
    pub containment: Containment,
}

impl Measured {
    /// Measures a set; `points` are boxes around points that it has to hold.
    ///
    /// # Errors
    /// Those of the set operations.
    pub fn of(shape: Shape, points: &[Vec<Interval>], workspace: &mut Workspace) -> Result<Self, ScenarioError> {
        let outline = outline(shape.set.region(), workspace)?;
        let containment = Containment::of(shape.set.region(), points, workspace)?;
        Ok(Self { area: area(&outline), outline, containment, shape })
    }

    /// Rows of a table: area, containment.
    #[must_use]
    pub fn rows(&self, table: &str, unit: &str) -> Vec<Row> {
        let Shape { row, method, mode, .. } = &self.shape;
        let start = |metric: &str, unit: &str| {
            let row = Row::new(table, *row, method.as_str()).metric(metric, unit);
            if let Some(mode) = mode { row.mode(*mode) } else { row }
        };
        let mut rows = vec![start("area", unit).value(self.area)];
        if let Some((contained, proven)) = self.containment.shares() {
            rows.push(start("containment", "").value(contained));
            rows.push(start("contained_proven", "").value(proven));
        }
        rows
    }
}

/// A set of the published algorithms as an enclosure.
///
/// # Errors
/// [`SetError::EmptySet`] if the algorithm found none.
pub fn enclosure_of(set: Option<CgRep>) -> Result<Enclosure, SetError> {
    set.ok_or(SetError::EmptySet)?.to_set().map(Enclosure::Constrained)
}

//! What a sampled set measures, and how much more an enclosure of it does.

use rand::Rng;
use setrep::{Matrix, SupportFunction, VPolytope};

use super::outline::{area, outline};
use super::sets::unit;
use crate::ScenarioError;

/// Directions in which widths are taken, besides the axes.
const DIRECTIONS: usize = 12;

/// Widths of a sampled set in some directions, and its area.
pub struct Yardstick {
    directions: Matrix,
    width: f64,
    area: Option<f64>,
}

impl Yardstick {
    /// Measures the hull of points; the directions are scaled to its sides.
    ///
    /// # Errors
    /// None: the points are finite.
    pub fn new(points: &Matrix, rng: &mut impl Rng) -> Result<Self, ScenarioError> {
        let n = points.rows();
        let extent = |d: &dyn Fn(&[f64]) -> f64| {
            let (low, high) = points
                .columns()
                .map(d)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
            high - low
        };
        let sides: Vec<f64> = (0..n).map(|k| extent(&|x: &[f64]| x[k])).collect();
        let mut directions = Matrix::zeros(n, 0);
        for j in 0..n + DIRECTIONS {
            let entry = |k: usize, rng: &mut _| if j < n { f64::from(u8::from(j == k)) } else { unit(rng) };
            let direction: Vec<f64> = (0..n).map(|k| entry(k, rng) / sides[k].max(1e-12)).collect();
            directions.push_col(&direction)?;
            directions.push_col(&direction.iter().map(|d| -d).collect::<Vec<f64>>())?;
        }
        let reach = |d: &[f64]| extent(&|x: &[f64]| x.iter().zip(d).map(|(x, d)| x * d).sum::<f64>());
        let width = directions.columns().step_by(2).map(reach).sum();
        let area = if n == 2 {
            let outline = VPolytope::new(points.clone())?.outline_2d()?;
            Some(area(&outline.columns().map(|x| [x[0], x[1]]).collect::<Vec<_>>()))
        } else {
            None
        };
        Ok(Self { directions, width, area })
    }

    /// Ratios of the widths and of the areas.
    ///
    /// # Errors
    /// Those of the support function.
    pub fn compare(
        &self,
        set: &dyn SupportFunction,
        workspace: &mut setrep::Workspace,
    ) -> Result<(f64, Option<f64>), ScenarioError> {
        let supports = set.support_vectors(&self.directions, &mut Matrix::zeros(set.dim(), 0), workspace)?;
        let width: f64 = supports.iter().sum();
        let area_ratio = match self.area {
            Some(sampled) => Some(area(&outline(set, workspace)?) / sampled),
            None => None,
        };
        Ok((width / self.width, area_ratio))
    }
}

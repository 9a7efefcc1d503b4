//! Random sets in three forms, and members of them.

use rand::{Rng, RngExt};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, SetError, SupportFunction, VPolytope, Workspace, Zonotope};

use super::families::Drawn;

/// Directions whose support vectors are the vertices of the polytope and the extreme members.
const DIRECTIONS: usize = 48;
/// Members are moved towards the middle by this share, so that rounding leaves them members.
const INWARD: f64 = 1e-9;

/// The three forms of one drawn set. The polytope is the hull of support vectors of the constrained zonotope.
#[derive(Debug, Clone)]
pub struct Sets {
    /// `n + 2` generators.
    pub zonotope: Zonotope,
    /// The zonotope with two strips in its coordinates.
    pub constrained: ConstrainedZonotope,
    /// Vertices of the constrained zonotope.
    pub vertices: VPolytope,
}

/// Which form.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// [`Sets::zonotope`].
    Zonotope,
    /// [`Sets::constrained`].
    Constrained,
    /// [`Sets::vertices`].
    Vertices,
}

impl Form {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Zonotope, Self::Constrained, Self::Vertices];

    /// The name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Zonotope => "zonotope",
            Self::Constrained => "cz",
            Self::Vertices => "v",
        }
    }
}

/// Uniform in `[-1, 1]`.
pub fn unit(rng: &mut impl Rng) -> f64 {
    2.0 * rng.random::<f64>() - 1.0
}

impl Sets {
    /// Sets whose hull has about the half-widths `size scale`, about the middle of the drawn box.
    ///
    /// # Errors
    /// None: the numbers are finite.
    pub fn draw(drawn: &Drawn, size: f64, rng: &mut impl Rng, workspace: &mut Workspace) -> Result<Self, SetError> {
        let n = drawn.center.len();
        let columns = n + 2;
        let mut generators = Matrix::zeros(n, columns);
        for k in 0..n {
            let row: Vec<f64> = (0..columns).map(|_| unit(rng)).collect();
            let sum: f64 = row.iter().map(|g| g.abs()).sum();
            for (j, g) in row.iter().enumerate() {
                generators[(k, j)] = g * size * drawn.scale[k] / sum;
            }
        }
        let zonotope = Zonotope::new(&drawn.center, &generators)?;
        let mut rows = Matrix::zeros(2, columns);
        rows.as_mut_slice().iter_mut().for_each(|a| *a = unit(rng));
        let range = |i: usize| {
            let reach: f64 = (0..columns).map(|j| rows[(i, j)].abs()).sum();
            Interval::point(0.1 * reach).inflate(0.25 * reach)
        };
        let constrained = ConstrainedZonotope::with_constraints(&zonotope, &rows, &[range(0), range(1)])?;
        let vertices = VPolytope::new(extremes(&constrained, rng, workspace)?)?.remove_redundant()?;
        Ok(Self { zonotope, constrained, vertices })
    }

    /// Members of one of the forms: support vectors, and mixtures of two or three of them; one a column.
    ///
    /// # Errors
    /// Those of the support function.
    pub fn members(
        &self,
        form: Form,
        count: usize,
        rng: &mut impl Rng,
        workspace: &mut Workspace,
    ) -> Result<Matrix, SetError> {
        let mut members = match form {
            Form::Zonotope => extremes(&self.zonotope, rng, workspace)?,
            Form::Constrained => extremes(&self.constrained, rng, workspace)?,
            Form::Vertices => self.vertices.vertices().clone(),
        };
        let first = members.cols();
        let n = members.rows();
        let middle: Vec<f64> = (0..n).map(|k| members.columns().map(|x| x[k]).sum::<f64>() / first as f64).collect();
        while members.cols() < count {
            let mut weights = [rng.random::<f64>(), rng.random::<f64>(), rng.random::<f64>()];
            weights[2] *= f64::from(u8::from(rng.random::<bool>()));
            let sum: f64 = weights.iter().sum();
            let mut mixture = vec![0.0; n];
            for weight in weights {
                let extreme = members.col(rng.random_range(0..first));
                mixture.iter_mut().zip(extreme).for_each(|(x, v)| *x += weight / sum * v);
            }
            members.push_col(&mixture)?;
        }
        for j in 0..members.cols() {
            for (x, m) in members.col_mut(j).iter_mut().zip(&middle) {
                *x += INWARD * (m - *x);
            }
        }
        Ok(members)
    }
}

/// Support vectors in random directions.
fn extremes(set: &dyn SupportFunction, rng: &mut impl Rng, workspace: &mut Workspace) -> Result<Matrix, SetError> {
    let n = set.dim();
    let hull = set.interval_hull(workspace)?;
    let mut directions = Matrix::zeros(n, DIRECTIONS);
    for j in 0..DIRECTIONS {
        for (d, side) in directions.col_mut(j).iter_mut().zip(hull.iter()) {
            *d = unit(rng) / side.width();
        }
    }
    let mut points = Matrix::zeros(n, 0);
    set.support_vectors(&directions, &mut points, workspace)?;
    Ok(points)
}

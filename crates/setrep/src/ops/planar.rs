//! Zonotopes in the plane: vertices and outlines.

use crate::{Matrix, SetError, Zonotope};

impl Zonotope {
    /// Vertices of a set in the plane (approximate), counterclockwise from the lowest, each once; a segment has two, a point one.
    ///
    /// With the generators turned into the upper half-plane and sorted by angle, the boundary runs from the sum of all `-g_j` through
    /// partial sums. The box remainder counts as generators.
    ///
    /// Approximate: in plain floating point, as for plots. [`membership`](Self::membership) and [`volume`](Self::volume) are rigorous.
    ///
    /// # Errors
    /// [`SetError::NotPlanar`].
    ///
    /// ```
    /// # use setrep::Zonotope;
    /// let square = Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// assert_eq!(square.vertices_2d()?, [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn vertices_2d(&self) -> Result<Vec<[f64; 2]>, SetError> {
        if self.dim() != 2 {
            return Err(SetError::NotPlanar { dim: self.dim() });
        }
        Ok(polygon([self.center[0], self.center[1]], &sorted_by_angle(&self.all_generators())))
    }

    /// Outline of the projection onto the coordinates `(i, j)` (approximate), closed (the first vertex comes again at the end).
    ///
    /// Approximate, as [`vertices_2d`](Self::vertices_2d).
    ///
    /// # Errors
    /// [`SetError::Dimension`] if the space has no such coordinates.
    pub fn outline_2d(&self, i: usize, j: usize) -> Result<Vec<[f64; 2]>, SetError> {
        if i.max(j) >= self.dim() {
            return Err(SetError::Dimension { part: crate::Part::Output, expected: self.dim(), found: i.max(j) + 1 });
        }
        let generators: Vec<f64> = self.all_generators().columns().flat_map(|g| [g[i], g[j]]).collect();
        let generators = Matrix::from_column_slice(2, generators.len() / 2, &generators)?;
        let mut outline = polygon([self.center[i], self.center[j]], &sorted_by_angle(&generators));
        outline.extend(outline.first().copied());
        Ok(outline)
    }

    /// The generators and, for nonzero components of the remainder, the columns of `diag(r)`.
    pub(crate) fn all_generators(&self) -> Matrix {
        let mut generators = self.generators.clone();
        for (i, &r) in self.remainder.iter().enumerate().filter(|(_, r)| **r > 0.0) {
            generators.push_axis(i, r);
        }
        generators
    }
}

/// The nonzero generators of the plane turned into the half-plane of angles `[0, pi)` (exactly) and sorted by angle (as computed).
pub(crate) fn sorted_by_angle(generators: &Matrix) -> Vec<[f64; 2]> {
    let mut sorted: Vec<(f64, [f64; 2])> = generators
        .columns()
        .filter(|g| g[0] != 0.0 || g[1] != 0.0)
        .map(|g| if g[1] < 0.0 || (g[1] == 0.0 && g[0] < 0.0) { [-g[0], -g[1]] } else { [g[0], g[1]] })
        .map(|g| (angle_key(g), g))
        .collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    sorted.into_iter().map(|(_, g)| g).collect()
}

/// A number in `[0, 2)` that grows with the angle in `[0, pi)`: the position on the unit circle of the 1-norm, off by at most `4u`.
fn angle_key([x, y]: [f64; 2]) -> f64 {
    let norm = x.abs() + y;
    let t = if norm.is_finite() { y / norm } else { 0.5 * y / (0.5 * x.abs() + 0.5 * y) };
    if x >= 0.0 { t } else { 2.0 - t }
}

/// The boundary polygon of a center and sorted generators.
fn polygon(center: [f64; 2], sorted: &[[f64; 2]]) -> Vec<[f64; 2]> {
    // Parallel neighbours make one edge.
    let mut edges: Vec<[f64; 2]> = Vec::with_capacity(sorted.len());
    for g in sorted {
        match edges.last_mut() {
            Some(e) if e[0] * g[1] == e[1] * g[0] => *e = [e[0] + g[0], e[1] + g[1]],
            _ => edges.push(*g),
        }
    }
    let mut vertex = edges.iter().fold(center, |v, e| [v[0] - e[0], v[1] - e[1]]);
    if edges.is_empty() {
        return vec![vertex];
    }
    let mut vertices = Vec::with_capacity(2 * edges.len());
    for sign in [2.0, -2.0] {
        for e in &edges {
            vertices.push(vertex);
            vertex = [vertex[0] + sign * e[0], vertex[1] + sign * e[1]];
        }
    }
    vertices
}

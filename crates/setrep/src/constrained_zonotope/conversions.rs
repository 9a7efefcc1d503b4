//! Constrained zonotopes and polytopes.

use scalars::Interval;
use scalars::rounding::add_up;

use super::ConstrainedZonotope;
use crate::bounds::add_lengths;
use crate::polytope::MAX_FACES;
use crate::{Directions, HPolytope, Matrix, Part, SetError, VPolytope, Workspace, Zonotope};

impl ConstrainedZonotope {
    /// The set as the convex hull of vertices, at most [`MAX_FACES`] of them at every stage.
    ///
    /// The coordinates `{ xi : |xi| <= 1, A xi in [b] }` are a polytope of dimension `ng`; its vertices are enumerated exactly, and their
    /// images span the set. Images inside the hull are not removed ([`VPolytope::remove_redundant`] does that). For few generators.
    ///
    /// **Guarantee:** superset of the set, by rounding only.
    ///
    /// # Errors
    /// [`SetError::EmptySet`], proven; [`SetError::OverBudget`]; [`SetError::Overflow`].
    pub fn to_v_polytope(&self) -> Result<VPolytope, SetError> {
        self.to_v_polytope_within(MAX_FACES)
    }

    /// [`to_v_polytope`](Self::to_v_polytope) with a limit on the number of vertices at every stage.
    ///
    /// # Errors
    /// As [`to_v_polytope`](Self::to_v_polytope).
    pub fn to_v_polytope_within(&self, max_vertices: usize) -> Result<VPolytope, SetError> {
        let (n, m) = (self.dim(), self.num_generators());
        let spread = if m == 0 {
            if self.ranges.iter().any(|range| !range.contains(0.0)) {
                return Err(SetError::EmptySet);
            }
            VPolytope::new(Matrix::zeros(n, 1))?
        } else {
            let coordinates = self.coordinates()?.to_v_polytope_within(max_vertices)?;
            coordinates.linear_map(self.generators())?
        };
        let (mut vertices, mut remainder) = (spread.vertices().clone(), spread.remainder().to_vec());
        for i in 0..n {
            let mut lost = 0.0_f64;
            for j in 0..vertices.cols() {
                let (moved, error) = crate::bounds::two_sum(vertices[(i, j)], self.center()[i]);
                vertices[(i, j)] = moved;
                lost = lost.max(error.abs());
                if !moved.is_finite() {
                    return Err(SetError::Overflow { row: i });
                }
            }
            remainder[i] = add_lengths(add_lengths(remainder[i], lost), self.remainder()[i]);
        }
        VPolytope::with_remainder(vertices, &remainder)
    }

    /// The set in half-space form, by way of its vertices; for few generators.
    ///
    /// **Guarantee:** superset of the set, by rounding only.
    ///
    /// # Errors
    /// As [`to_v_polytope`](Self::to_v_polytope).
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Workspace};
    /// let mut triangle = ConstrainedZonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?;
    /// triangle.intersect_half_space(&[1.0, 1.0], 0.0, &mut Workspace::new())?;
    /// let polytope = triangle.to_h_polytope()?;
    /// assert!((polytope.volume()?.mid() - 2.0).abs() < 1e-12);
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn to_h_polytope(&self) -> Result<HPolytope, SetError> {
        self.to_v_polytope()?.to_h_polytope()
    }

    /// An outer polytope: the interval hull, and one half-space for each sign of each direction.
    ///
    /// **Guarantee:** superset of the set that touches it in every direction given, up to rounding. For any number of generators.
    ///
    /// # Errors
    /// [`SetError::Dimension`]; [`SetError::EmptySet`], proven; [`SetError::TooLarge`]; [`SetError::Overflow`].
    pub fn outer_h_polytope(&self, directions: &Directions, workspace: &mut Workspace) -> Result<HPolytope, SetError> {
        SetError::check_size(Part::Direction, self.dim(), directions.dim())?;
        let mut optimizer = self.optimizer(workspace)?;
        let mut hull = vec![Interval::EMPTY; self.dim()];
        optimizer.interval_hull_into(&mut hull)?;
        if hull.iter().any(Interval::is_empty) {
            return Err(SetError::EmptySet);
        }
        let (mut rows, mut offsets) = (Vec::new(), Vec::new());
        for direction in directions.iter() {
            for sign in [1.0, -1.0] {
                let row: Vec<f64> = direction.iter().map(|d| sign * d).collect();
                offsets.push(optimizer.support(&row)?);
                rows.push(row);
            }
        }
        if offsets.contains(&f64::NEG_INFINITY) {
            return Err(SetError::EmptySet);
        }
        if let Some(row) = offsets.iter().position(|h| !h.is_finite()) {
            return Err(SetError::Overflow { row });
        }
        let rows: Vec<&[f64]> = rows.iter().map(Vec::as_slice).collect();
        let sides = HPolytope::from_intervals(&hull)?;
        if rows.is_empty() {
            Ok(sides)
        } else {
            sides.intersection(&HPolytope::new(Matrix::from_rows(&rows)?, &offsets)?)
        }
    }

    /// A bounded polytope in half-space form: the box around it, cut by its half-spaces.
    ///
    /// **Guarantee:** superset of the polytope, by the rounding of the rows; exact in real arithmetic. A polytope that is proven empty
    /// gives a set that is proven empty.
    ///
    /// # Errors
    /// [`SetError::Unbounded`] if no [bound](HPolytope::bounding_box) is found, [`SetError::TooLarge`], [`SetError::Overflow`].
    pub fn from_h_polytope(polytope: &HPolytope, workspace: &mut Workspace) -> Result<Self, SetError> {
        let hull = polytope.bounding_box(workspace)?;
        if hull.iter().any(Interval::is_empty) {
            let mut empty = Self::from_box(&vec![0.0; polytope.dim()], &vec![0.0; polytope.dim()])?;
            empty.become_empty(1);
            return Ok(empty);
        }
        if hull.iter().any(|side| !side.is_bounded()) {
            return Err(SetError::Unbounded);
        }
        let mut set = Self::from_intervals(&hull)?;
        set.intersect_h_polytope(polytope, workspace)?;
        Ok(set)
    }

    /// A polytope in vertex form: `{ V l : l >= 0, sum_j l_j = 1 }` with `l = (1 + xi) / 2`, as many generators as vertices and one
    /// constraint, `sum_j xi_j = 2 - m`.
    ///
    /// **Guarantee:** superset of the polytope, by rounding only.
    ///
    /// # Errors
    /// [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::{ConstrainedZonotope, Matrix, VPolytope, Workspace};
    /// let triangle = VPolytope::new(Matrix::from_columns(&[&[0.0, 0.0], &[1.0, 0.0], &[0.0, 1.0]])?)?;
    /// let set = ConstrainedZonotope::from_v_polytope(&triangle)?;
    /// assert_eq!((set.num_generators(), set.num_constraints()), (3, 1));
    /// assert!((1.0..1.0 + 1e-14).contains(&set.support(&[1.0, 1.0], &mut Workspace::new())?));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn from_v_polytope(polytope: &VPolytope) -> Result<Self, SetError> {
        let (n, m) = (polytope.dim(), polytope.num_vertices());
        let pivot = polytope.interval_hull().mid();
        let mut generators = Matrix::zeros(n, m);
        let (mut center, mut remainder) = (vec![0.0; n], vec![0.0; n]);
        for i in 0..n {
            // x = p + sum_j 2 g_j l_j with 2 g_j = v_j - p up to an error of which a convex combination counts.
            let (mut middle, mut lost) = (Interval::point(pivot[i]), 0.0_f64);
            for j in 0..m {
                let half = (Interval::point(polytope.vertices()[(i, j)]) - Interval::point(pivot[i])).scale(0.5);
                generators[(i, j)] = half.mid();
                middle += Interval::point(half.mid());
                lost = lost.max(2.0 * half.rad());
            }
            center[i] = middle.mid();
            remainder[i] = add_up(add_lengths(lost, middle.rad()), polytope.remainder()[i]);
            if !(center[i].is_finite() && remainder[i].is_finite()) {
                return Err(SetError::Overflow { row: i });
            }
        }
        let body = Zonotope::with_remainder(&center, &generators, &remainder)?;
        let row = Matrix::from_column_slice(1, m, &vec![1.0; m])?;
        // A number of vertices is far below 2^53.
        Self::with_constraints(&body, &row, &[Interval::point(2.0 - m as f64)])
    }

    /// `{ xi : |xi| <= 1, A xi in [b] }` in half-space form.
    fn coordinates(&self) -> Result<HPolytope, SetError> {
        let (m, k) = (self.num_generators(), self.num_constraints());
        let cube = HPolytope::from_intervals(&vec![Interval::new(-1.0, 1.0).unwrap_or(Interval::ENTIRE); m])?;
        let mut normals = Matrix::zeros(2 * k, m);
        let mut offsets = Vec::with_capacity(2 * k);
        for (i, range) in self.ranges.iter().enumerate() {
            for j in 0..m {
                normals[(2 * i, j)] = self.constraints[(i, j)];
                normals[(2 * i + 1, j)] = -self.constraints[(i, j)];
            }
            offsets.extend([range.hi(), -range.lo()]);
        }
        if k == 0 { Ok(cube) } else { cube.intersection(&HPolytope::new(normals, &offsets)?) }
    }
}

/// A zonotope as a polytope: [`ConstrainedZonotope::to_v_polytope`] without constraints.
impl Zonotope {
    /// The set as the convex hull of vertices; for few generators.
    ///
    /// **Guarantee:** superset of the set, by rounding only.
    ///
    /// # Errors
    /// [`SetError::OverBudget`]; [`SetError::Overflow`].
    pub fn to_v_polytope(&self) -> Result<VPolytope, SetError> {
        ConstrainedZonotope::from(self.clone()).to_v_polytope()
    }

    /// The set in half-space form; for few generators.
    ///
    /// **Guarantee:** superset of the set, by rounding only.
    ///
    /// # Errors
    /// As [`to_v_polytope`](Self::to_v_polytope).
    pub fn to_h_polytope(&self) -> Result<HPolytope, SetError> {
        self.to_v_polytope()?.to_h_polytope()
    }
}

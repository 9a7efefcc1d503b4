//! What a user asks of the set.

use scalars::Interval;
use scalars::rounding::{add_up, sqrt_up};
use setrep::{HPolytope, Matrix};

use super::InvariantStrips;
use super::arc::TURN;
use super::plane::{middle, product, unit};
use super::reframe::turned_arm;
use crate::error::{check_finite, check_size};
use crate::{EstimatorError, PlanarBox};

/// Half-planes of the polygon behind a distance.
const DISTANCE_DIRECTIONS: usize = 16;

/// How a box of states lies to the set, as far as it is proven.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Position {
    Inside,
    Outside,
    Open,
}

impl InvariantStrips {
    /// Number of predictions so far.
    #[must_use]
    pub fn step_count(&self) -> u64 {
        self.step
    }

    /// Number of rows kept: past measurements and bounds.
    #[must_use]
    pub fn num_rows(&self) -> usize {
        self.rows.len()
    }

    /// Linear programs solved by the last update.
    #[must_use]
    pub fn programs(&self) -> usize {
        self.programs
    }

    /// The sum of the turns so far: the heading that the coordinates of the embedding are relative to.
    #[must_use]
    pub fn reference_heading_rad(&self) -> f64 {
        self.reference
    }

    /// Whether the set and a box of states are proven disjoint: some row, the arc, the scale, a position or an arm excludes all of them.
    ///
    /// **Guarantee:** true only if no state of the box is in the set.
    ///
    /// # Errors
    /// A box with another number of vectors, an empty or unbounded side.
    pub fn excludes(&self, states: &PlanarBox) -> Result<bool, EstimatorError> {
        Ok(self.position_of(states)? == Position::Outside)
    }

    /// Whether a box of states is proven to lie in the set.
    ///
    /// **Guarantee:** true only if every state of the box is in the set.
    ///
    /// # Errors
    /// As [`excludes`](Self::excludes).
    pub fn includes(&self, states: &PlanarBox) -> Result<bool, EstimatorError> {
        Ok(self.position_of(states)? == Position::Inside)
    }

    fn position_of(&self, states: &PlanarBox) -> Result<Position, EstimatorError> {
        states.check()?;
        let set = &self.enclosure;
        check_size("vectors of the world", set.fixed.len(), states.fixed.len())?;
        check_size("vectors of the body", set.body.len(), states.body.len())?;
        let phi = states.heading_rad - Interval::point(self.reference);
        let mut inside = true;
        if !self.arc.is_whole() {
            // The copies of the heading around the arc, modulo 2 pi.
            let turns = ((self.arc.middle() - phi.mid()) / TURN).round();
            let turns = if turns.is_finite() { turns } else { 0.0 };
            let copies = [-1.0, 0.0, 1.0].map(|k| phi + Interval::PI.scale(2.0 * (turns + k)));
            // Of huge angles the number of turns is rounded as well.
            if phi.mag() < 1e9 && phi.width() < TURN && copies.iter().all(|copy| copy.disjoint(&self.arc.angles())) {
                return Ok(Position::Outside);
            }
            inside = copies.iter().any(|copy| copy.subset_of(&self.arc.angles()));
        }
        let known = set.fixed.as_flattened().iter().chain(set.body.as_flattened()).chain([&set.scale]);
        let asked = states.fixed.as_flattened().iter().chain(states.body.as_flattened()).chain([&states.scale]);
        for (known, asked) in known.zip(asked) {
            if known.disjoint(asked) {
                return Ok(Position::Outside);
            }
            inside &= asked.subset_of(known);
        }
        let heading = unit(phi);
        let z = heading.map(|side| side * states.scale);
        for i in 0..self.rows.len() {
            let value = self.row_range(i, &z, &states.fixed, &states.body, &heading);
            let limit = self.rows.offsets()[i];
            if value.lo() > limit {
                return Ok(Position::Outside);
            }
            inside &= value.hi() <= limit;
        }
        Ok(if inside { Position::Inside } else { Position::Open })
    }

    /// Encloses the value of row `i` over a box of states.
    fn row_range(
        &self,
        i: usize,
        z: &[Interval; 2],
        fixed: &[[Interval; 2]],
        body: &[[Interval; 2]],
        heading: &[Interval; 2],
    ) -> Interval {
        use super::plane::{conjugate_product, difference, inner, point};
        let normal = self.rows.normal(i);
        let pair = |column: usize| point([normal[column], normal[column + 1]]);
        // <a, z> + <d, x - S z> = <a - conj(S) d, z> + <d, x>
        let mut lever = pair(0);
        let mut value = Interval::ZERO;
        for (j, x) in fixed.iter().enumerate() {
            let d = pair(self.embedding.fixed(j));
            lever = difference(&lever, &conjugate_product(&point(self.path[j]), &d));
            value += inner(&d, x);
        }
        for (l, arm) in body.iter().enumerate() {
            value += inner(&pair(self.embedding.body(l)), &turned_arm(heading, arm));
        }
        value + inner(&lever, z)
    }

    /// A polygon around vector `vector` of the world, world coordinates: half-planes in `directions` evenly spaced directions.
    ///
    /// **Guarantee:** superset of the positions of the set.
    ///
    /// # Errors
    /// No such vector, fewer than 3 directions, positions that overflow, [`EstimatorError::Inconsistent`] if it turns out here that nothing is left.
    pub fn polygon(&mut self, vector: usize, directions: usize) -> Result<HPolytope, EstimatorError> {
        if vector >= self.enclosure.fixed.len() {
            let expected = self.enclosure.fixed.len();
            return Err(EstimatorError::Size {
                what: "vectors of the world",
                expected,
                found: vector.saturating_add(1),
            });
        }
        if directions < 3 {
            return Err(EstimatorError::Size { what: "directions", expected: 3, found: directions });
        }
        self.fit_box()?;
        let offsets = self.with_derived(|set| set.polygon_offsets(vector, directions))?;
        let normals = (0..directions).flat_map(|k| direction(k, directions)).collect::<Vec<_>>();
        let mut matrix = Matrix::zeros(directions, 2);
        for k in 0..directions {
            matrix[(k, 0)] = normals[2 * k];
            matrix[(k, 1)] = normals[2 * k + 1];
        }
        Ok(HPolytope::new(matrix, &offsets)?)
    }

    fn polygon_offsets(&mut self, vector: usize, directions: usize) -> Result<Vec<f64>, EstimatorError> {
        (0..directions).map(|k| self.place_support(vector, direction(k, directions))).collect()
    }

    /// Upper bound of the distance of the position from `point`: a protection level around it.
    ///
    /// **Guarantee:** no state of the set is farther away; the corners of a polygon of 16 half-planes are, if anything.
    ///
    /// # Errors
    /// A point that is not finite; as [`polygon`](Self::polygon).
    pub fn max_distance_from(&mut self, point: [f64; 2]) -> Result<f64, EstimatorError> {
        check_finite("point", &point)?;
        let corners = self.polygon(0, DISTANCE_DIRECTIONS)?.to_v_polytope()?;
        let remainder = corners.remainder();
        let mut farthest = 0.0_f64;
        for corner in corners.vertices().columns() {
            let away =
                [0, 1].map(|k| (Interval::point(corner[k]) - Interval::point(point[k])).inflate(remainder[k]).sqr());
            farthest = farthest.max(sqrt_up(add_up(away[0].hi(), away[1].hi())));
        }
        Ok(farthest)
    }

    /// The set in the embedding, `(Re z, Im z, Re x_0, Im x_0, .., Re xi_0, Im xi_0, ..)`, `z = s e^{i(theta - theta_hat)}`,
    /// `xi_l = e^{i(theta - theta_hat)} X_l`, with `theta_hat` the [`reference_heading_rad`](Self::reference_heading_rad).
    ///
    /// Its rows are those kept, the relaxations of arc, scale and arms, and a box.
    ///
    /// **Guarantee:** superset of the embedded set.
    ///
    /// # Errors
    /// A box that overflows.
    pub fn polytope(&mut self) -> Result<HPolytope, EstimatorError> {
        self.start_anew()?;
        self.with_derived(|set| Ok(set.rows.to_polytope()?))
    }

    /// Runs `question` with the rows of the arc in place.
    fn with_derived<T>(
        &mut self,
        question: impl FnOnce(&mut Self) -> Result<T, EstimatorError>,
    ) -> Result<T, EstimatorError> {
        let programs = self.programs;
        self.suspects.clear();
        let answer = self.push_derived().and_then(|()| question(self));
        self.drop_derived();
        self.programs = programs;
        answer
    }
}

/// Direction `k` of `count`.
fn direction(k: usize, count: usize) -> [f64; 2] {
    middle(&product(&unit(Interval::point(TURN * k as f64 / count as f64)), &[Interval::ONE, Interval::ZERO]))
}

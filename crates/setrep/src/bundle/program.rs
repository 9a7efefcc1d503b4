//! What is asked of all members together, through one linear program: supports, hull, emptiness; and membership.

use scalars::Interval;

use super::ZonotopeBundle;
use crate::support_function::check_direction;
use crate::{ConstrainedZonotope, Emptiness, IntervalVector, Membership, SetError, SupportFunction, Workspace};

impl ZonotopeBundle {
    /// Support function `h(d) = max { d'x : x in X }`, shape `d: n`: the least of the program's bound and the members' supports.
    ///
    /// **Guarantee:** an upper bound of the exact value, `-inf` only if the set is proven empty, `inf` where it overflows.
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::NonFinite`] in the direction, [`SetError::TooLarge`], [`SetError::Overflow`].
    pub fn support(&self, direction: &[f64], workspace: &mut Workspace) -> Result<f64, SetError> {
        check_direction(self.dim(), direction, None)?;
        self.with_program(workspace, |program, workspace| {
            let bound = program.support(direction, workspace)?;
            self.least_support(bound, direction)
        })
    }

    /// The least of a bound and the members' supports.
    fn least_support(&self, bound: f64, direction: &[f64]) -> Result<f64, SetError> {
        self.members.iter().try_fold(bound, |least, member| Ok(least.min(member.support(direction)?)))
    }

    /// Interval hull of the intersection, by one program and `2n` objectives, cut with the hulls of the members.
    ///
    /// **Guarantee:** superset of the exact hull, hence of the set; empty only if the set is proven empty.
    ///
    /// # Errors
    /// [`SetError::TooLarge`], [`SetError::Overflow`].
    pub fn interval_hull(&self, workspace: &mut Workspace) -> Result<IntervalVector, SetError> {
        let mut hull = IntervalVector::new(vec![Interval::EMPTY; self.dim()]);
        self.interval_hull_into(&mut hull, workspace)?;
        Ok(hull)
    }

    /// [`interval_hull`](Self::interval_hull) into a slice of length `n`; allocates nothing within the capacity of the workspace.
    ///
    /// # Errors
    /// As [`interval_hull`](Self::interval_hull); [`SetError::Dimension`] if the slice has another length.
    pub fn interval_hull_into(&self, hull: &mut [Interval], workspace: &mut Workspace) -> Result<(), SetError> {
        self.with_program(workspace, |program, workspace| program.interval_hull_into(hull, workspace))?;
        let sides = &mut workspace.ranges;
        sides.clear();
        sides.resize(self.dim(), Interval::EMPTY);
        for member in &self.members {
            member.interval_hull_into(sides)?;
            hull.iter_mut().zip(sides.iter()).for_each(|(side, own)| *side = side.intersection(*own));
        }
        // Proven bounds that contradict each other on one axis prove the set empty.
        if hull.iter().any(Interval::is_empty) {
            hull.fill(Interval::EMPTY);
        }
        Ok(())
    }

    /// Decides whether the intersection is empty, with a proof either way.
    ///
    /// The rows that a contradiction names are those of [`to_constrained_zonotope`](Self::to_constrained_zonotope), against which it
    /// can be verified.
    ///
    /// **Guarantee:** both proofs hold for the exact set: emptiness is proven of the program, which rounding only widens, the opposite
    /// of one whose ranges are rounded inward.
    ///
    /// # Errors
    /// [`SetError::TooLarge`], [`SetError::Overflow`].
    ///
    /// ```
    /// # use setrep::{Emptiness, Workspace, Zonotope, ZonotopeBundle};
    /// let mut bundle = ZonotopeBundle::from(Zonotope::from_box(&[0.0, 0.0], &[1.0, 1.0])?);
    /// bundle.intersect(&Zonotope::from_box(&[1.5, 0.0], &[1.0, 1.0])?)?;
    /// let mut workspace = Workspace::new();
    /// assert!(matches!(bundle.emptiness(&mut workspace)?, Emptiness::ProvenNonEmpty(_)));
    /// bundle.intersect(&Zonotope::from_box(&[0.0, 0.0], &[0.25, 1.0])?)?;
    /// let Emptiness::ProvenEmpty(proof) = bundle.emptiness(&mut workspace)? else { panic!() };
    /// assert!(proof.verify(&bundle.to_constrained_zonotope()?));
    /// # Ok::<(), setrep::SetError>(())
    /// ```
    pub fn emptiness(&self, workspace: &mut Workspace) -> Result<Emptiness, SetError> {
        let verdict = self.with_program(workspace, ConstrainedZonotope::emptiness)?;
        if !matches!(verdict, Emptiness::ProvenNonEmpty(_)) {
            return Ok(verdict);
        }
        let Some(inner) = self.inner_program()? else { return Ok(Emptiness::Undecided) };
        Ok(match inner.emptiness(workspace)? {
            Emptiness::ProvenNonEmpty(witness) => Emptiness::ProvenNonEmpty(witness),
            _ => Emptiness::Undecided,
        })
    }

    /// Whether the set is proven to have no point.
    ///
    /// # Errors
    /// As [`emptiness`](Self::emptiness).
    pub fn is_proven_empty(&self, workspace: &mut Workspace) -> Result<bool, SetError> {
        self.with_program(workspace, ConstrainedZonotope::is_proven_empty)
    }

    /// Whether a point, known to lie in a box `P`, lies in the set: inside if `P` is a subset of every member, outside if it is disjoint
    /// from one.
    ///
    /// **Guarantee:** both proofs hold for the exact set and every point of `P`; see
    /// [`ConstrainedZonotope::membership`](crate::ConstrainedZonotope::membership).
    ///
    /// # Errors
    /// [`SetError::Dimension`], [`SetError::UnboundedInterval`], [`SetError::Overflow`], [`SetError::TooLarge`].
    pub fn membership(&self, point: &[Interval], workspace: &mut Workspace) -> Result<Membership, SetError> {
        let mut verdict = Membership::ProvenInside;
        for member in &self.members {
            match ConstrainedZonotope::from(member.clone()).membership(point, workspace)? {
                Membership::ProvenOutside => return Ok(Membership::ProvenOutside),
                Membership::ProvenInside => {}
                Membership::Undecided => verdict = Membership::Undecided,
            }
        }
        Ok(verdict)
    }

    /// Runs a question on the constrained zonotope of the bundle, which the workspace holds.
    fn with_program<T>(
        &self,
        workspace: &mut Workspace,
        ask: impl FnOnce(&ConstrainedZonotope, &mut Workspace) -> Result<T, SetError>,
    ) -> Result<T, SetError> {
        let mut program = workspace.program.take().unwrap_or_else(|| self.first().clone().into());
        let answer = self.assemble(&mut program).and_then(|()| ask(&program, workspace));
        workspace.program = Some(program);
        answer
    }
}

impl SupportFunction for ZonotopeBundle {
    fn dim(&self) -> usize {
        self.dim()
    }

    fn support(&self, direction: &[f64], workspace: &mut Workspace) -> Result<f64, SetError> {
        self.support(direction, workspace)
    }

    fn support_vector(&self, direction: &[f64], point: &mut [f64], workspace: &mut Workspace) -> Result<f64, SetError> {
        self.with_program(workspace, |program, workspace| {
            let bound = program.support_vector(direction, point, workspace)?;
            self.least_support(bound, direction)
        })
    }

    fn interval_hull(&self, workspace: &mut Workspace) -> Result<IntervalVector, SetError> {
        self.interval_hull(workspace)
    }
}

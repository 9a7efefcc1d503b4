//! [`Comb`]: several filters at once, all of them on the intersection of their sets.

use scalars::Interval;
use scalars::rounding::sub_down;
use setrep::{HPolytope, VPolytope, Workspace};

use super::forms::materialized;
use crate::error::check_size;
use crate::set_filter::{inconsistent, under};
use crate::{Culprit, Estimator, EstimatorError, Evidence, Guarantee};

mod member;

pub use member::CombMember;

/// New vertices that lie in the hull of the others up to this share of the set's extents are dropped.
const THIN: f64 = 1e-10;

/// How large the sets of a [`Comb`] may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CombOptions {
    /// Most half-spaces of each member's set, at least the `2 n` of a box.
    pub half_spaces: usize,
    /// Most vertices of the intersection, at least the `2^n` of a box.
    pub vertices: usize,
}

impl Default for CombOptions {
    /// 60 half-spaces, 64 vertices.
    fn default() -> Self {
        Self { half_spaces: 60, vertices: 64 }
    }
}

/// The intersection of the sets of several filters (COMB): after every call all of them go on from it.
///
/// The set of the first member in vertex form is cut with the half-spaces of the others, in up to three dimensions all of their facets
/// ([`HPolytope::around`]). So the order of the members matters for rounding only, unless a set has more facets than
/// [`CombOptions::half_spaces`].
///
/// **Guarantee:** [`Guarantee::Rigorous`] if all members are; else that of the weakest.
/// **Source:** paper 004, Section VII.
///
/// ```
/// use estimators::{Comb, CombOptions, DCz, DCzOptions, Estimator, Relation, System, Vh, VhOptions};
/// use nonlin_bounds::function;
/// use setrep::{ConstrainedZonotope, VPolytope, Zonotope};
///
/// let grow = function!(|[x, y, w]: 3| -> 2 { [x + y.scale(0.5) + w, y - (x * y).scale(0.25)] });
/// let product = function!(|[x, y, error]: 3| -> 1 { [x * y + error] });
/// let small = Zonotope::from_box(&[0.0], &[0.01])?;
/// let system = System::new(Relation::new(grow), small.clone(), Relation::new(product), small)?;
/// let start = ConstrainedZonotope::from_box(&[1.0, 1.0], &[0.3, 0.3])?;
/// let vertices: VPolytope = start.to_v_polytope()?;
/// let alone = Vh::new(system.clone(), vertices.clone(), VhOptions::paper())?;
/// let other = DCz::new(system, start, DCzOptions::new(2))?;
/// let mut comb = Comb::new(vec![Box::new(alone.clone()), Box::new(other)], vertices, CombOptions::default())?;
/// let mut alone = alone;
/// comb.step(&[], &[1.0])?;
/// alone.step(&[], &[1.0])?;
/// assert!(comb.enclosure().volume()?.hi() <= alone.enclosure().volume()?.hi());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Comb {
    members: Vec<Box<dyn CombMember>>,
    options: CombOptions,
    set: VPolytope,
    hull: Vec<Interval>,
    step: u64,
    workspace: Workspace,
}

impl Comb {
    /// Puts all members on the first set.
    ///
    /// # Errors
    /// [`EstimatorError::Size`] without members, for members of other dimensions, and for limits below those of a box.
    pub fn new(
        members: Vec<Box<dyn CombMember>>,
        initial: VPolytope,
        options: CombOptions,
    ) -> Result<Self, EstimatorError> {
        let n = initial.dim();
        if members.is_empty() {
            check_size("members", 1, 0)?;
        }
        for member in &members {
            check_size("states of a member", n, member.states())?;
        }
        let corners = u32::try_from(n).ok().and_then(|n| 1_usize.checked_shl(n)).unwrap_or(usize::MAX);
        for (what, least, found) in
            [("half-space budget", 2 * n, options.half_spaces), ("vertex budget", corners, options.vertices)]
        {
            if found < least {
                check_size(what, least, found)?;
            }
        }
        let set = materialized(initial)?;
        let hull = set.interval_hull().to_vec();
        let mut comb = Self { members, options, set, hull, step: 0, workspace: Workspace::new() };
        comb.restart(0)?;
        Ok(comb)
    }

    /// A box that contains the state.
    #[must_use]
    pub fn hull(&self) -> &[Interval] {
        &self.hull
    }

    /// Number of predictions so far.
    #[must_use]
    pub fn step_index(&self) -> u64 {
        self.step
    }

    /// [`update`](Estimator::update) for a measurement of which some entries may be missing.
    ///
    /// # Errors
    /// As [`update`](Estimator::update).
    pub fn update_some(&mut self, output: &[Option<f64>]) -> Result<(), EstimatorError> {
        let present = (0..output.len()).filter(|&i| output[i].is_some());
        let culprits: Vec<Culprit> = present.map(Culprit::Measurement).collect();
        self.call(self.step, &culprits, &|member| member.correct(Some(output)))
    }

    /// Puts all members on the set.
    fn restart(&mut self, step: u64) -> Result<(), EstimatorError> {
        let Self { members, set, workspace, .. } = self;
        members.iter_mut().try_for_each(|member| member.restart(set, step, workspace))
    }

    /// Moves all members, intersects their sets and goes on from there; after an error all are as before.
    fn call(
        &mut self,
        step: u64,
        culprits: &[Culprit],
        act: &dyn Fn(&mut dyn CombMember) -> Result<(), EstimatorError>,
    ) -> Result<(), EstimatorError> {
        let result = self
            .members
            .iter_mut()
            .try_for_each(|member| act(&mut **member))
            .and_then(|()| self.intersection(step, culprits))
            .and_then(|set| {
                let before = (core::mem::replace(&mut self.set, set), self.step);
                self.step = step;
                self.restart(step).inspect_err(|_| (self.set, self.step) = before)
            });
        if result.is_err() {
            self.restart(self.step)?;
        }
        self.hull.clear();
        self.hull.extend_from_slice(&self.set.interval_hull());
        result.map_err(|error| under(self.guarantee(), error))
    }

    /// The intersection of the members' sets.
    fn intersection(&mut self, step: u64, culprits: &[Culprit]) -> Result<VPolytope, EstimatorError> {
        let Self { members, options, workspace, .. } = self;
        let mut set = members[0].vertices(options.half_spaces, workspace)?;
        for member in &members[1..] {
            let half_spaces = member.half_spaces(options.half_spaces, workspace)?;
            for (i, &offset) in half_spaces.offsets().iter().enumerate() {
                let values: Vec<f64> = set.vertices().columns().map(|v| least(&half_spaces, i, v, &set)).collect();
                if values.iter().all(|&value| value > offset) {
                    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
                    let sides = (Interval::new(least, f64::INFINITY), Interval::new(f64::NEG_INFINITY, offset));
                    let evidence = match sides {
                        (Ok(predicted), Ok(required)) => Evidence::Disjoint { predicted, required },
                        _ => Evidence::Propagation { hull: set.interval_hull().to_vec() },
                    };
                    return Err(inconsistent(step, culprits.to_vec(), evidence));
                }
                set = set.cut_by_values(&values, offset, THIN)?;
            }
        }
        if set.num_vertices() > options.vertices {
            set = set.enclosed_within(options.vertices, workspace)?;
        }
        Ok(set.absorb_remainder())
    }
}

/// A lower bound of `a'x` for `x` in `v + [-r, r]`, for row `i`.
fn least(half_spaces: &HPolytope, i: usize, v: &[f64], set: &VPolytope) -> f64 {
    let mut sum = Interval::ZERO;
    let mut reach = Interval::ZERO;
    for (k, (&x, &r)) in v.iter().zip(set.remainder()).enumerate() {
        let a = half_spaces.normals()[(i, k)];
        sum += Interval::point(x).scale(a);
        reach += Interval::point(r).scale(a.abs());
    }
    sub_down(sum.lo(), reach.hi())
}

impl Estimator for Comb {
    type Input = [f64];
    type Output = [f64];
    type Set = VPolytope;

    fn predict(&mut self, input: &[f64]) -> Result<(), EstimatorError> {
        self.call(self.step + 1, &[], &|member| member.advance(input))
    }

    fn update(&mut self, output: &[f64]) -> Result<(), EstimatorError> {
        self.update_some(&output.iter().map(|&y| Some(y)).collect::<Vec<_>>())
    }

    fn step(&mut self, input: &[f64], output: &[f64]) -> Result<(), EstimatorError> {
        let before = (self.set.clone(), self.hull.clone());
        self.update(output)?;
        self.predict(input).inspect_err(|_| {
            (self.set, self.hull) = before;
            // The set is one that the members were on before.
            let _ = self.restart(self.step);
        })
    }

    fn consistency(&mut self) -> Result<(), EstimatorError> {
        self.call(self.step, &[], &|member| member.correct(None))
    }

    fn enclosure(&self) -> &VPolytope {
        &self.set
    }

    fn guarantee(&self) -> Guarantee {
        let weaker = |a: Guarantee, b: Guarantee| match (a, b) {
            (Guarantee::Statistical, _) | (_, Guarantee::Statistical) => Guarantee::Statistical,
            (Guarantee::FirstOrder, _) | (_, Guarantee::FirstOrder) => Guarantee::FirstOrder,
            _ => Guarantee::Rigorous,
        };
        self.members.iter().map(|member| member.promise()).fold(Guarantee::Rigorous, weaker)
    }
}

//! The filter of strips: guaranteed enclosures on planar groups, from a heading that may be totally unknown.
//!
//! Reading order: [`PlanarBox`], [`PlanarIncrement`], [`PlanarMeasurement`]; then `embedding` (the coordinates), `sweep` (the suprema of
//! noise terms), `transport` (prediction), `measured` and `derived` (rows), `contraction` and `pieces` (what they say), `bounds` and `tags` (which
//! rows stay).

mod arc;
mod bounds;
mod contraction;
mod contradiction;
mod derived;
mod embedding;
mod increment;
mod measured;
mod measurement;
mod options;
mod outputs;
mod pieces;
mod planar_box;
mod plane;
mod reframe;
mod spans;
mod sweep;
mod tags;
mod transport;
mod way;

pub use increment::PlanarIncrement;
pub use measurement::PlanarMeasurement;
pub use options::StripsOptions;
pub use planar_box::PlanarBox;
pub(crate) use planar_box::check_bounded;
pub(crate) use tags::{Origin, Pruning, Tag};

use arc::{Arc, Cap};
use embedding::Embedding;
use pieces::Union;
use plane::{Region, Vector, largest_modulus};
use scalars::Interval;
use setrep::BoxedRows;
use spans::Spans;
use transport::Motion;

use crate::{Estimator, EstimatorError, Guarantee};

/// Widest arc whose bounds are worth rows of their own.
const REFRESH_WIDTH: f64 = 2.0;

/// The filter of strips on a planar group: which one, the prior says ([`PlanarBox`]).
///
/// The set is a polytope in the linear matrix embedding of the group, where composition with an increment and measurements of places
/// are exactly linear for every heading: with `z = s e^{i phi}` and `xi = e^{i phi} X`, `phi` the heading relative to the sum of the turns,
///
/// ```text
/// z+ = e^{i alpha} z,   x+ = x + e^{i theta_hat} z (U + m),   xi+ = e^{i alpha} xi,   y = x + e^{i theta_hat} xi + v
/// ```
///
/// Its rows are past measurements ("strips"), each carried along exactly; only the products of noise and state cost anything, and their
/// suprema are known in closed form. What is not linear, `s1 <= |z| <= s2` and the box of the arms, contracts an arc of headings, an
/// interval of scales and boxes of arms by a few linear programs a step. Rows are dropped by age and use, which is always sound. There is
/// no gain, no linearisation and no estimate: the result does not depend on one.
///
/// **Guarantee:** [`Guarantee::Rigorous`]: if the state lies in the prior and all noises in their ranges, it lies in every set, rounding
/// included. A contradiction is proven and names the measurements that take part, this step's as [`Culprit::Measurement`] and
/// older ones as [`Culprit::Earlier`]; entry `2 m + k` is number `k` of measurement `m`. The set is then the predicted one. Its evidence
/// are rows with multipliers, two disjoint bounds, or such for each part of the circle of headings ([`Evidence::Cases`]), and can be
/// checked again as far as rows go that hold in each part; where bounds cross without one of these, it is [`Evidence::Propagation`].
///
/// [`Evidence::Cases`]: crate::Evidence::Cases
/// [`Evidence::Propagation`]: crate::Evidence::Propagation
/// [`Culprit::Measurement`]: crate::Culprit::Measurement
/// [`Culprit::Earlier`]: crate::Culprit::Earlier
///
/// ```
/// use estimators::{Estimator, InvariantStrips, PlanarBox, PlanarIncrement, PlanarMeasurement, StripsOptions};
/// use lie_groups::{LieGroup, SE2};
/// use nalgebra::Vector3;
/// use scalars::Interval;
///
/// // A vehicle on a circle of 20 m radius at 8 m/s, position measured to 1 m at 100 Hz, heading unknown.
/// let side = Interval::new(-5.0, 5.0)?;
/// let mut filter = InvariantStrips::new(&PlanarBox::se2(Interval::ENTIRE, [side, side]), StripsOptions::pose())?;
/// let odometry = Interval::new(-1e-3, 1e-3)?;
/// let receiver = Interval::new(-1.0, 1.0)?;
/// let step = PlanarIncrement::exponential([0.004, 0.08, 0.0].map(Interval::point), [odometry; 3]);
///
/// let mut truth = SE2::identity();
/// for _ in 0..300 {
///     truth = truth.compose(&SE2::exp(&Vector3::new(0.004, 0.08, 0.0)));
///     filter.predict(&step)?;
///     let [x, y] = truth.translation().into();
///     filter.update(&[PlanarMeasurement::position([x, y], [receiver; 2])])?;
/// }
/// let (from, to) = filter.enclosure().heading_ends_rad().unwrap_or_default();
/// assert!(from < 1.2 && 1.2 < to && filter.enclosure().heading_width_rad() < 0.6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct InvariantStrips {
    options: StripsOptions,
    embedding: Embedding,
    step: u64,
    /// Number of updates.
    instant: u64,
    /// `theta_hat`.
    reference: f64,
    /// Headings relative to `theta_hat`.
    arc: Arc,
    enclosure: PlanarBox,
    /// `S_j`.
    path: Vec<Vector>,
    /// Holds the `q_j`.
    reach: Vec<Region>,
    /// Direction of the middle of the arc at the last update, and boxes of `xi_l / axis`.
    axis: Vector,
    turned: Vec<Region>,
    rows: BoxedRows,
    tags: Vec<Tag>,
    /// Room for the `q_j` beyond the radii of their hulls.
    drift: Vec<f64>,
    programs: usize,
    /// Whether the last program was proven to have no point.
    emptied: bool,
    /// Rows that carry the bounds of the contraction under way: what takes part if it leaves nothing.
    suspects: Vec<usize>,
    motion: Motion,
    spans: Spans,
    before: Before,
    pruning: Pruning,
    normal: Vec<f64>,
    center: Vec<f64>,
    sides: Vec<Interval>,
    caps: Vec<Cap>,
    union: Union,
}

/// What an update changes beside the rows.
#[derive(Debug, Clone)]
struct Before {
    tags: Vec<Tag>,
    arc: Arc,
    enclosure: PlanarBox,
    axis: Vector,
    turned: Vec<Region>,
}

impl InvariantStrips {
    /// A filter whose state lies in `prior`.
    ///
    /// # Errors
    /// A side of the prior that is empty or unbounded (but for the heading), a scale that is not positive, no vector of the world,
    /// options without memory.
    pub fn new(prior: &PlanarBox, options: StripsOptions) -> Result<Self, EstimatorError> {
        prior.check()?;
        options.check()?;
        let (fixed, body) = (prior.fixed.len(), prior.body.len());
        let embedding = Embedding::new(fixed, body);
        let reference = if prior.heading_rad.is_bounded() { prior.heading_rad.mid() } else { 0.0 };
        let arc = Arc::new(prior.heading_rad - Interval::point(reference));
        let turned: Vec<Region> =
            prior.body.iter().map(|arm| [Interval::ZERO.inflate(largest_modulus(arm)); 2]).collect();
        let drift = vec![0.0; fixed];
        let mut sides = Vec::new();
        reframe::fill_sides(&mut sides, embedding, prior, &drift);
        let mut filter = Self {
            options,
            embedding,
            step: 0,
            instant: 0,
            reference,
            arc,
            enclosure: prior.clone(),
            path: vec![[0.0; 2]; fixed],
            reach: prior.fixed.clone(),
            axis: [1.0, 0.0],
            turned: turned.clone(),
            rows: BoxedRows::new(&sides)?,
            tags: Vec::new(),
            drift,
            programs: 0,
            emptied: false,
            suspects: Vec::new(),
            motion: Motion::new(fixed, body),
            spans: Spans::default(),
            before: Before { tags: Vec::new(), arc, enclosure: prior.clone(), axis: [1.0, 0.0], turned },
            pruning: Pruning::default(),
            normal: vec![0.0; embedding.dim()],
            center: Vec::new(),
            sides,
            caps: Vec::new(),
            union: Union::default(),
        };
        filter.enclosure.heading_rad = filter.heading();
        filter.push_hulls()?;
        Ok(filter)
    }

    /// All of an update that a contradiction undoes.
    fn correct(&mut self, measurements: &[PlanarMeasurement]) -> Result<(), EstimatorError> {
        self.push_measurements(measurements)?;
        self.contract()?;
        let every = self.options.refresh as u64;
        if every > 0 && self.instant.is_multiple_of(every) {
            if self.options.aligned {
                self.push_aligned(measurements)?;
            } else if self.arc.width() < REFRESH_WIDTH {
                self.push_hulls()?;
            }
        }
        Ok(())
    }

    /// Drops the rows that are not worth their time.
    fn prune(&mut self) {
        self.find_center();
        let Self { rows, tags, spans, pruning, center, options, instant, .. } = self;
        let slack = |i: usize| {
            let reached: f64 = rows.normal(i).iter().zip(&*center).map(|(a, x)| a * x).sum();
            rows.offsets()[i] - reached
        };
        pruning.choose(tags, *instant, options, slack);
        rows.retain(|i| pruning.keep[i]);
        spans.retain(&pruning.keep);
        let mut i = 0;
        tags.retain(|_| {
            i += 1;
            pruning.keep[i - 1]
        });
    }

    fn keep(&mut self, rows: usize) {
        self.rows.retain(|i| i < rows);
        self.tags.truncate(rows);
    }
}

impl PlanarBox {
    /// Becomes a copy without allocating.
    fn assign(&mut self, other: &Self) {
        self.heading_rad = other.heading_rad;
        self.scale = other.scale;
        self.fixed.clone_from(&other.fixed);
        self.body.clone_from(&other.body);
    }
}

impl Estimator for InvariantStrips {
    type Input = PlanarIncrement;
    /// All measurements of one instant.
    type Output = [PlanarMeasurement];
    /// The hull of the set: intervals of heading and scale, boxes of positions and arms.
    type Set = PlanarBox;

    fn predict(&mut self, input: &PlanarIncrement) -> Result<(), EstimatorError> {
        self.plan(input)?;
        self.transport();
        // Here, so that an update that is refused leaves rows and coordinates as they are; should it fail, the update says why.
        let _ = self.fit_box();
        Ok(())
    }

    /// Corrects the set by all measurements of one instant; none at all change nothing.
    fn update(&mut self, output: &[PlanarMeasurement]) -> Result<(), EstimatorError> {
        let set = &self.enclosure;
        output.iter().try_for_each(|y| y.check(set.fixed.len(), set.body.len(), set.scale))?;
        if output.is_empty() {
            return Ok(());
        }
        self.fit_box()?;
        self.programs = 0;
        self.instant += 1;
        let kept = self.rows.len();
        self.before.tags.clone_from(&self.tags);
        self.before.arc = self.arc;
        self.before.axis = self.axis;
        self.before.turned.clone_from(&self.turned);
        self.before.enclosure.assign(&self.enclosure);
        if let Err(error) = self.correct(output) {
            self.keep(kept);
            self.arc = self.before.arc;
            self.axis = self.before.axis;
            core::mem::swap(&mut self.turned, &mut self.before.turned);
            core::mem::swap(&mut self.enclosure, &mut self.before.enclosure);
            // Rows count as used at this instant only by an update that stands.
            core::mem::swap(&mut self.tags, &mut self.before.tags);
            self.instant -= 1;
            return Err(error);
        }
        self.prune();
        Ok(())
    }

    /// The update of `x_k` by `y_k`, then the prediction of `x_k+1`.
    fn step(&mut self, input: &PlanarIncrement, output: &[PlanarMeasurement]) -> Result<(), EstimatorError> {
        // What the set before the update can do, the one after it can: it is smaller.
        self.plan(input)?;
        self.update(output)?;
        self.predict(input)
    }

    fn enclosure(&self) -> &PlanarBox {
        &self.enclosure
    }

    fn guarantee(&self) -> Guarantee {
        Guarantee::Rigorous
    }
}

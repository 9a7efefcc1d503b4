//! The filter of strips in space: guaranteed enclosures on `SE(3)` and `SE_K(3)`, from an attitude that may be unknown.
//!
//! Reading order: [`SpatialBox`], [`SpatialIncrement`], [`SpatialMeasurement`]; then `space` and `spread` (small rotations, boxes of them), `cell` (sets of
//! attitudes), `frame` (the coordinates), `transport` (prediction), `measured` and `derived` (rows), `contraction` and `cells` (what they say).

mod cell;
mod cells;
mod contraction;
mod contradiction;
mod derived;
mod frame;
mod increment;
mod measured;
mod measurement;
mod outputs;
mod reframe;
mod space;
mod spatial_box;
mod spread;
mod transport;

pub use increment::SpatialIncrement;
pub use measurement::SpatialMeasurement;
pub use spatial_box::SpatialBox;

use cell::Cell;
use frame::Frame;
use scalars::Interval;
use setrep::BoxedRows;
use space::Region;
use transport::Motion;

use crate::invariant_strips::{Pruning, Tag};
use crate::{Estimator, EstimatorError, Guarantee, StripsOptions};

/// The filter of strips on `SE(3)`, `SE_2(3)` and any `SE_K(3)`: how many vectors, the prior says ([`SpatialBox`]).
///
/// The set is a polytope in the entries of `Z = R P'` (nine, `P` the attitude that the turns add up to) and of the vectors, where composition with an
/// increment, gravity, the coupling of position and velocity, and measurements of places and directions are exactly linear for every attitude.
/// Its rows are past measurements, each carried along exactly; only the products of noise and state cost anything. What is not linear, that `Z` is a
/// rotation, is kept as boxes of rotation vectors ([`cells`](Self::cells)), which the rows contract and which give bounds on the entries of `Z` in turn. One cell
/// is enough once the attitude is known to a quarter of a radian; before that a wide one is cut into at most [`StripsOptions::caps`], and those that the
/// rows refute are dropped. [`StripsOptions::aligned`] and [`StripsOptions::spans`] have no meaning here.
///
/// **Guarantee:** [`Guarantee::Rigorous`]: if the state lies in the prior and all noises in their ranges, it lies in every set, rounding
/// included. A contradiction is proven and names the measurements that take part, as [`InvariantStrips`](crate::InvariantStrips) does; entry `3 m + k` is number `k` of
/// measurement `m`. The set is then the predicted one. A proof within the last cell takes as premise that the others are excluded.
///
/// ```
/// use estimators::{Estimator, SpatialBox, SpatialIncrement, SpatialMeasurement, SpatialStrips, StripsOptions};
/// use lie_groups::{LieGroup, SO3};
/// use nalgebra::Vector3;
/// use scalars::Interval;
///
/// // A vehicle with two antennas, 1 m ahead and 1 m to the left, and an accelerometer at rest; its heading is known to 1 rad, its tilt to 0.5.
/// let within = |radius: f64| [Interval::point(0.0).inflate(radius); 3];
/// let turn = [0.5, 0.5, 1.0].map(|radius| Interval::point(0.0).inflate(radius));
/// let prior = SpatialBox::new(SO3::identity(), turn, &[within(5.0)]);
/// let mut filter = SpatialStrips::new(&prior, StripsOptions::pose())?;
///
/// let truth = SO3::exp(&Vector3::new(0.2, -0.1, 0.7));
/// let antennas = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|arm| {
///     let place = truth.act(&Vector3::from(arm)).into();
///     SpatialMeasurement::vector(place, within(0.02)).with_arm(arm)
/// });
/// let gravity = [0.0, 0.0, -9.81];
/// let seen = truth.inverse().act(&Vector3::from(gravity)).into();
/// let vertical = SpatialMeasurement::direction(gravity.map(Interval::point), seen, within(0.1));
/// filter.update(&[antennas[0], antennas[1], vertical])?;
///
/// let set = filter.enclosure();
/// let off = truth.compose(&set.center.inverse()).log()?;
/// assert!((0..3).all(|k| set.turn_rad[k].contains(off[k])) && set.angle_rad() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct SpatialStrips {
    options: StripsOptions,
    frame: Frame,
    step: u64,
    /// Number of updates.
    instant: u64,
    cells: Vec<Cell>,
    enclosure: SpatialBox,
    /// Holds the `q_j`.
    reach: Vec<Region>,
    rows: BoxedRows,
    tags: Vec<Tag>,
    /// Room for the `q_j` beyond the radii of their hulls.
    room: Vec<f64>,
    programs: usize,
    /// Whether the last program was proven to have no point.
    emptied: bool,
    /// Rows that carry the bounds of the contraction under way: what takes part if it leaves nothing.
    suspects: Vec<usize>,
    motion: Motion,
    before: Before,
    pruning: Pruning,
    normal: Vec<f64>,
    exact: Vec<Interval>,
    middle: Vec<f64>,
    sides: Vec<Interval>,
    seen: Vec<Region>,
    parted: Vec<Cell>,
}

/// What an update changes beside the rows.
#[derive(Debug, Clone)]
struct Before {
    tags: Vec<Tag>,
    cells: Vec<Cell>,
    enclosure: SpatialBox,
}

impl SpatialStrips {
    /// A filter whose state lies in `prior`.
    ///
    /// # Errors
    /// A side of the prior that is empty or unbounded (but for the attitude), no vector of the world, options without memory.
    pub fn new(prior: &SpatialBox, options: StripsOptions) -> Result<Self, EstimatorError> {
        prior.check()?;
        options.check()?;
        let vectors = prior.vectors.len();
        let frame = Frame::new(prior.center, vectors);
        let cells = vec![Cell::new(&prior.turn_rad)];
        let room = vec![0.0; vectors];
        let mut sides = Vec::new();
        reframe::fill_sides(&mut sides, &prior.vectors, &room);
        let mut filter = Self {
            options,
            step: 0,
            instant: 0,
            before: Before { tags: Vec::new(), cells: cells.clone(), enclosure: prior.clone() },
            cells,
            enclosure: prior.clone(),
            reach: prior.vectors.clone(),
            rows: BoxedRows::new(&sides)?,
            tags: Vec::new(),
            room,
            programs: 0,
            emptied: false,
            suspects: Vec::new(),
            motion: Motion::new(&frame),
            pruning: Pruning::default(),
            normal: vec![0.0; frame.dim()],
            exact: vec![Interval::ZERO; frame.dim()],
            middle: Vec::new(),
            sides,
            seen: Vec::new(),
            parted: Vec::new(),
            frame,
        };
        filter.enclose_attitude()?;
        filter.push_hulls()?;
        Ok(filter)
    }

    /// All of an update that a contradiction undoes.
    fn correct(&mut self, measurements: &[SpatialMeasurement]) -> Result<(), EstimatorError> {
        let first = self.rows.len();
        self.push_measurements(measurements)?;
        self.contract(measurements, first)?;
        let every = self.options.refresh as u64;
        if every > 0 && self.instant.is_multiple_of(every) {
            self.push_hulls()?;
        }
        Ok(())
    }

    /// Drops the rows that are not worth their time.
    fn prune(&mut self) {
        self.find_middle();
        let Self { rows, tags, pruning, middle, options, instant, .. } = self;
        let slack = |i: usize| {
            let reached: f64 = rows.normal(i).iter().zip(&*middle).map(|(a, x)| a * x).sum();
            rows.offsets()[i] - reached
        };
        pruning.choose(tags, *instant, options, slack);
        rows.retain(|i| pruning.keep[i]);
        let mut i = 0;
        tags.retain(|_| {
            i += 1;
            pruning.keep[i - 1]
        });
    }

    /// Drops all rows but the first.
    fn keep(&mut self, rows: usize) {
        self.rows.retain(|i| i < rows);
        self.tags.truncate(rows);
    }
}

impl Estimator for SpatialStrips {
    type Input = SpatialIncrement;
    /// All measurements of one instant.
    type Output = [SpatialMeasurement];
    /// The hull of the set.
    type Set = SpatialBox;

    fn predict(&mut self, input: &SpatialIncrement) -> Result<(), EstimatorError> {
        self.plan(input)?;
        self.transport();
        // Here, so that an update that is refused leaves rows and coordinates as they are; should it fail, the update says why.
        let _ = self.fit_box();
        Ok(())
    }

    /// Corrects the set by all measurements of one instant; none at all change nothing.
    fn update(&mut self, output: &[SpatialMeasurement]) -> Result<(), EstimatorError> {
        output.iter().try_for_each(|y| y.check(self.frame.vectors()))?;
        if output.is_empty() {
            return Ok(());
        }
        self.fit_box()?;
        self.programs = 0;
        self.instant += 1;
        let kept = self.rows.len();
        self.before.tags.clone_from(&self.tags);
        self.before.cells.clone_from(&self.cells);
        self.before.enclosure.assign(&self.enclosure);
        if let Err(error) = self.correct(output) {
            self.keep(kept);
            core::mem::swap(&mut self.cells, &mut self.before.cells);
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
    fn step(&mut self, input: &SpatialIncrement, output: &[SpatialMeasurement]) -> Result<(), EstimatorError> {
        // What the set before the update can do, the one after it can: it is smaller.
        self.plan(input)?;
        self.update(output)?;
        self.predict(input)
    }

    fn enclosure(&self) -> &SpatialBox {
        &self.enclosure
    }

    fn guarantee(&self) -> Guarantee {
        Guarantee::Rigorous
    }
}

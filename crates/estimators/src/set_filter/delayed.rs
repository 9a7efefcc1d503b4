//! [`DelayedFilter`]: measurements that come a few steps late.

use super::{FilterState, Method, SetFilter};
use crate::{Estimator, EstimatorError, Guarantee, System};

/// A [`SetFilter`] that remembers its last few steps, so that measurements may come late: they are used at the step they belong to, and the
/// steps since are run again.
///
/// The result is, bit for bit, that of a filter that was given the same measurements in time, those of one step in the order of their
/// arrival. A step may last as long as it likes (its duration is a parameter of the dynamics); a measurement between two steps is not
/// foreseen. In steady state nothing is allocated: what is remembered lives in storage that is used again.
///
/// A call that fails leaves everything as it was. If a late measurement contradicts what came after it, it is refused as a whole.
///
/// **Guarantee:** that of the method.
///
/// ```
/// use estimators::{DelayedFilter, Estimator, Rcz, RczOptions, Relation, System};
/// use nonlin_bounds::function;
/// use setrep::{ConstrainedZonotope, Zonotope};
///
/// let noise = Zonotope::from_box(&[0.0], &[0.1])?;
/// let walk = Relation::new(function!(|[x, w]: 2| -> 1 { [x + w] }));
/// let seen = Relation::new(function!(|[x, v]: 2| -> 1 { [x + v] }));
/// let system = System::new(walk, noise.clone(), seen, noise)?;
/// let filter = Rcz::new(system, ConstrainedZonotope::from_box(&[0.0], &[1.0])?, RczOptions::fast(1))?;
///
/// let mut filter = DelayedFilter::new(filter, 3);
/// filter.predict(&[])?;
/// filter.predict(&[])?;
/// assert!(filter.filter().hull()[0].rad() > 1.19);
/// // What was measured at the first step, two predictions ago.
/// filter.update_at(0, &[Some(0.5)], &[])?;
/// assert!(filter.filter().hull()[0].rad() < 0.31 && filter.filter().hull()[0].contains(0.5));
/// assert!(filter.update_at(7, &[Some(0.5)], &[]).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct DelayedFilter<M: Method> {
    filter: SetFilter<M>,
    /// The last steps, of which `len` from `first` on are remembered; the oldest is overwritten.
    records: Vec<Record<M>>,
    first: usize,
    len: usize,
    /// What has been done at the step under way.
    events: Events,
    /// The filter's states to come back to: of one call, and of a step of two.
    saved: FilterState<M::Set, M::Memory>,
    before: FilterState<M::Set, M::Memory>,
}

/// A step that is over.
#[derive(Debug, Clone)]
struct Record<M: Method> {
    /// The state at its end, before the prediction.
    state: FilterState<M::Set, M::Memory>,
    /// The same in a run that is not yet accepted.
    draft: FilterState<M::Set, M::Memory>,
    /// What has been done at the step.
    events: Events,
    /// The input of the prediction.
    input: Vec<f64>,
}

/// What has been done to a state at one step, in order; storage is kept.
#[derive(Debug, Clone, Default)]
struct Events {
    list: Vec<Event>,
    len: usize,
}

#[derive(Debug, Clone, Default)]
struct Event {
    kind: Kind,
    output: Vec<Option<f64>>,
    parameters: Vec<f64>,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
enum Kind {
    #[default]
    Update,
    Consistency,
    Reduction,
}

impl Events {
    fn push(&mut self, kind: Kind, output: impl Iterator<Item = Option<f64>>, parameters: &[f64]) {
        if self.len == self.list.len() {
            self.list.push(Event::default());
        }
        let event = &mut self.list[self.len];
        event.kind = kind;
        event.output.clear();
        event.output.extend(output);
        event.parameters.clear();
        event.parameters.extend_from_slice(parameters);
        self.len += 1;
    }

    fn iter(&self) -> impl Iterator<Item = &Event> {
        self.list[..self.len].iter()
    }
}

impl Event {
    fn apply<M: Method>(&self, filter: &mut SetFilter<M>) -> Result<(), EstimatorError> {
        match self.kind {
            Kind::Update => filter.update_some(&self.output, &self.parameters),
            Kind::Consistency => filter.consistency(),
            Kind::Reduction => filter.reduce(),
        }
    }
}

impl<M: Method> DelayedFilter<M> {
    /// A filter that remembers as many predictions as `steps` says.
    #[must_use]
    pub fn new(filter: SetFilter<M>, steps: usize) -> Self {
        let state = filter.state();
        let record =
            Record { state: state.clone(), draft: state.clone(), events: Events::default(), input: Vec::new() };
        let (saved, before) = (state.clone(), state.clone());
        Self { records: vec![record; steps], first: 0, len: 0, events: Events::default(), saved, before, filter }
    }

    /// The filter, with all that has come so far.
    #[must_use]
    pub fn filter(&self) -> &SetFilter<M> {
        &self.filter
    }

    /// The filter alone.
    #[must_use]
    pub fn into_filter(self) -> SetFilter<M> {
        self.filter
    }

    /// The system, whose parts may be replaced. What is remembered belongs to the old one and is forgotten; a model that changes all the time
    /// does so through its parameters.
    pub fn system_mut(&mut self) -> &mut System {
        self.len = 0;
        self.filter.system_mut()
    }

    /// The oldest step for which a measurement can still come.
    #[must_use]
    pub fn oldest_step(&self) -> u64 {
        self.filter.step_index() - self.len as u64
    }

    /// [`update_some`](SetFilter::update_some) with a measurement of the step under way.
    ///
    /// # Errors
    /// As [`update`](Estimator::update).
    pub fn update_some(&mut self, output: &[Option<f64>], p: &[f64]) -> Result<(), EstimatorError> {
        self.filter.update_some(output, p)?;
        self.events.push(Kind::Update, output.iter().copied(), p);
        Ok(())
    }

    /// Uses a measurement of the step with index `step`, the number of predictions before it, and runs the steps since again.
    ///
    /// # Errors
    /// [`EstimatorError::OutOfReach`] for a step that is no longer remembered or not yet reached; those of [`update`](Estimator::update) and
    /// [`predict`](Estimator::predict) on the way, a contradiction with the measurements since among them. Everything is then as before.
    pub fn update_at(&mut self, step: u64, output: &[Option<f64>], p: &[f64]) -> Result<(), EstimatorError> {
        let (oldest, now) = (self.oldest_step(), self.filter.step_index());
        if step < oldest || step > now {
            return Err(EstimatorError::OutOfReach { step, oldest, newest: now });
        }
        if step == now {
            return self.update_some(output, p);
        }
        // The difference is at most the number of records.
        let start = (step - oldest) as usize;
        self.saved.clone_from(self.filter.state());
        if let Err(error) = self.run_again(start, output, p) {
            self.filter.restore(&self.saved)?;
            return Err(error);
        }
        for k in start..self.len {
            let slot = self.slot(k);
            let Record { state, draft, .. } = &mut self.records[slot];
            core::mem::swap(state, draft);
        }
        let slot = self.slot(start);
        self.records[slot].events.push(Kind::Update, output.iter().copied(), p);
        Ok(())
    }

    /// Runs from the end of remembered step `start`, with one more measurement there; new states go to the drafts.
    fn run_again(&mut self, start: usize, output: &[Option<f64>], p: &[f64]) -> Result<(), EstimatorError> {
        for k in start..self.len {
            let slot = self.slot(k);
            let Record { state, draft, events, input } = &mut self.records[slot];
            if k == start {
                self.filter.restore(state)?;
                self.filter.update_some(output, p)?;
            } else {
                events.iter().try_for_each(|event| event.apply(&mut self.filter))?;
            }
            draft.clone_from(self.filter.state());
            self.filter.predict(input)?;
        }
        self.events.iter().try_for_each(|event| event.apply(&mut self.filter))
    }

    /// Where the `k`-th remembered step lies.
    fn slot(&self, k: usize) -> usize {
        (self.first + k) % self.records.len()
    }

    /// Encloses the set in a small one now.
    ///
    /// # Errors
    /// As [`SetFilter::reduce`].
    pub fn reduce(&mut self) -> Result<(), EstimatorError> {
        self.filter.reduce()?;
        self.events.push(Kind::Reduction, core::iter::empty(), &[]);
        Ok(())
    }
}

impl<M: Method> Estimator for DelayedFilter<M> {
    type Input = [f64];
    type Output = [f64];
    type Set = M::Set;

    fn predict(&mut self, input: &[f64]) -> Result<(), EstimatorError> {
        self.saved.clone_from(self.filter.state());
        self.filter.predict(input)?;
        if self.records.is_empty() {
            self.events.len = 0;
            return Ok(());
        }
        if self.len == self.records.len() {
            self.first = self.slot(1);
            self.len -= 1;
        }
        let slot = self.slot(self.len);
        let record = &mut self.records[slot];
        core::mem::swap(&mut record.state, &mut self.saved);
        core::mem::swap(&mut record.events, &mut self.events);
        record.input.clear();
        record.input.extend_from_slice(input);
        self.events.len = 0;
        self.len += 1;
        Ok(())
    }

    fn update(&mut self, output: &[f64]) -> Result<(), EstimatorError> {
        self.filter.update(output)?;
        self.events.push(Kind::Update, output.iter().map(|&y| Some(y)), &[]);
        Ok(())
    }

    fn step(&mut self, input: &[f64], output: &[f64]) -> Result<(), EstimatorError> {
        self.before.clone_from(self.filter.state());
        self.update(output)?;
        if let Err(error) = self.predict(input) {
            self.filter.restore(&self.before)?;
            self.events.len -= 1;
            return Err(error);
        }
        Ok(())
    }

    fn consistency(&mut self) -> Result<(), EstimatorError> {
        self.filter.consistency()?;
        self.events.push(Kind::Consistency, core::iter::empty(), &[]);
        Ok(())
    }

    fn enclosure(&self) -> &M::Set {
        self.filter.enclosure()
    }

    fn guarantee(&self) -> Guarantee {
        M::GUARANTEE
    }
}

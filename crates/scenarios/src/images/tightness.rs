//! How tight the methods are: widths and areas against those of sampled images and solutions.

use std::time::Instant;

use nonlin_bounds::{DynFunction, Jet, Order, Workspace};
use rand::{Rng, RngExt};
use scalars::Interval;
use setrep::{IntervalVector, Matrix};

use super::enclosure::Enclosure;
use super::families::Family;
use super::methods::{Method, method_name};
use super::sets::{Form, Sets};
use super::yardstick::Yardstick;
use crate::region::Containment;
use crate::{Context, Mode, Row, ScenarioError, monte_carlo};

/// Sizes of the sets, in the scale of their family.
pub const SIZES: [f64; 2] = [0.1, 0.5];
/// Members of a set whose images are looked at.
const MEMBERS: usize = 400;
/// Members whose membership in the enclosure is asked.
const WATCHED: usize = 24;
/// Half-width of the box of values of a solution set, as a share of the half-width of the values in the set.
const SLACK: f64 = 0.2;
/// Least time given to a timing, in seconds.
const TIMED_S: f64 = 4e-3;
/// Least number of calls timed.
const CALLS: usize = 7;

/// What is enclosed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Task {
    /// Images.
    Images,
    /// Solution sets.
    Solutions,
}

impl Task {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Images, Self::Solutions];

    /// The table's name.
    #[must_use]
    pub fn table(self) -> &'static str {
        match self {
            Self::Images => "Tightness of images",
            Self::Solutions => "Tightness of solution sets",
        }
    }

    fn families(self) -> &'static [Family] {
        match self {
            Self::Images => &Family::IMAGES,
            Self::Solutions => &Family::SOLUTIONS,
        }
    }

    fn methods(self, form: Form) -> &'static [Method] {
        match self {
            Self::Images => Method::of_images(form),
            Self::Solutions => Method::of_solutions(form),
        }
    }
}

/// What one method made of one set.
#[derive(Debug, Clone, Copy)]
struct Outcome {
    method: Method,
    form: Form,
    width_ratio: f64,
    area_ratio: Option<f64>,
    generators_added: f64,
    constraints_added: f64,
    containment: Containment,
}

/// One drawn case: the function, the sets, the box of values.
struct Case {
    function: Box<dyn DynFunction + Send + Sync>,
    sets: Sets,
}

/// The rows of both tables: mean and standard deviation over the drawn cases.
///
/// # Errors
/// Those of the methods: no family leaves the domain of its functions.
pub fn rows(context: &Context<'_>, runs: usize) -> Result<Vec<Row>, ScenarioError> {
    let mut rows = Vec::new();
    for task in Task::ALL {
        for &family in task.families() {
            for size in SIZES {
                let label = label(family, size);
                let cases = monte_carlo::run(context, &label, runs, |_, rng| study(task, family, size, rng))?;
                let outcomes: Vec<Outcome> = cases.into_iter().flatten().collect();
                for form in Form::ALL {
                    for &method in task.methods(form) {
                        let own: Vec<&Outcome> =
                            outcomes.iter().filter(|o| o.method == method && o.form == form).collect();
                        rows.extend(summary(task, &label, method, form, &own));
                    }
                }
            }
        }
    }
    Ok(rows)
}

/// What varies, in words.
#[must_use]
pub fn label(family: Family, size: f64) -> String {
    format!("{}, size {size}", family.name())
}

fn summary(task: Task, label: &str, method: Method, form: Form, outcomes: &[&Outcome]) -> Vec<Row> {
    let row = |metric: &str, samples: Vec<f64>| {
        Row::new(task.table(), label, method_name(method, form))
            .mode(Mode::Rigorous)
            .metric(metric, "")
            .mean_of(&samples)
    };
    let each = |pick: fn(&Outcome) -> f64| outcomes.iter().map(|o| pick(o)).collect::<Vec<f64>>();
    let mut rows = vec![row("width ratio", each(|o| o.width_ratio))];
    let areas: Vec<f64> = outcomes.iter().filter_map(|o| o.area_ratio).collect();
    if !areas.is_empty() {
        rows.push(row("area ratio", areas));
    }
    rows.push(row(
        if form == Form::Vertices { "vertices added" } else { "generators added" },
        each(|o| o.generators_added),
    ));
    rows.push(row("constraints added", each(|o| o.constraints_added)));
    let shares: Vec<(f64, f64)> = outcomes.iter().filter_map(|o| o.containment.shares()).collect();
    rows.push(row("containment", shares.iter().map(|share| share.0).collect()));
    rows.push(row("contained_proven", shares.iter().map(|share| share.1).collect()));
    rows
}

fn draw(family: Family, size: f64, rng: &mut impl Rng, workspace: &mut Workspace) -> Result<Case, ScenarioError> {
    let drawn = family.draw(rng);
    let sets = Sets::draw(&drawn, size, rng, &mut workspace.sets)?;
    Ok(Case { function: drawn.function, sets })
}

fn study(task: Task, family: Family, size: f64, rng: &mut impl Rng) -> Result<Vec<Outcome>, ScenarioError> {
    let workspace = &mut Workspace::new();
    let case = draw(family, size, rng, workspace)?;
    let f: &dyn DynFunction = &*case.function;
    let mut outcomes = Vec::new();
    for form in Form::ALL {
        if task.methods(form).is_empty() {
            continue;
        }
        let members = case.sets.members(form, MEMBERS, rng, &mut workspace.sets)?;
        let (points, watched, values) = match task {
            Task::Images => {
                let images = values_of(f, &members)?;
                let mut jet = Jet::new();
                let boxes = members.columns().take(WATCHED).map(|x| {
                    f.enclose(Order::Value, &IntervalVector::point(x), &[], &mut jet)?;
                    Ok(jet.values().to_vec())
                });
                let boxes = boxes.collect::<Result<Vec<_>, ScenarioError>>()?;
                (images, boxes, Vec::new())
            }
            Task::Solutions => {
                let values = target(f, &members)?;
                let solutions = solutions(f, &members, &values, rng)?;
                let last = solutions.cols().saturating_sub(WATCHED)..solutions.cols();
                let boxes = last.map(|j| IntervalVector::point(solutions.col(j)).to_vec()).collect();
                (solutions, boxes, values)
            }
        };
        let yardstick = Yardstick::new(&points, rng)?;
        let before = match form {
            Form::Zonotope => Enclosure::Zonotope(case.sets.zonotope.clone()),
            Form::Constrained => Enclosure::Constrained(case.sets.constrained.clone()),
            Form::Vertices => Enclosure::Vertices(case.sets.vertices.clone()),
        };
        for &method in task.methods(form) {
            let set = match task {
                Task::Images => method.image(f, &case.sets, form, workspace)?,
                Task::Solutions => method.solution(f, &case.sets, form, &values, workspace)?,
            };
            let (width_ratio, area_ratio) = yardstick.compare(set.region(), &mut workspace.sets)?;
            let containment = Containment::of(set.region(), &watched, &mut workspace.sets)?;
            outcomes.push(Outcome {
                method,
                form,
                width_ratio,
                area_ratio,
                generators_added: set.region().columns() as f64 - before.region().columns() as f64,
                constraints_added: set.region().constraints() as f64 - before.region().constraints() as f64,
                containment,
            });
        }
    }
    Ok(outcomes)
}

/// Values of the columns.
fn values_of(f: &dyn DynFunction, points: &Matrix) -> Result<Matrix, ScenarioError> {
    let mut values = Matrix::zeros(f.outputs(), points.cols());
    for j in 0..points.cols() {
        f.value(points.col(j), &[], values.col_mut(j))?;
    }
    Ok(values)
}

/// A box around the value of one member, of a share of the width of all values.
fn target(f: &dyn DynFunction, members: &Matrix) -> Result<Vec<Interval>, ScenarioError> {
    let values = values_of(f, members)?;
    let chosen = members.cols() - 1;
    let side = |i: usize| {
        let all = values.columns().map(|y| Interval::point(y[i]));
        let width = all.reduce(Interval::hull).map_or(0.0, |hull| hull.width());
        Interval::point(values[(i, chosen)]).inflate(0.5 * SLACK * width)
    };
    Ok((0..f.outputs()).map(side).collect())
}

/// The members with values in the box, and points on the way from them to the others where the values leave it.
fn solutions(
    f: &dyn DynFunction,
    members: &Matrix,
    y: &[Interval],
    rng: &mut impl Rng,
) -> Result<Matrix, ScenarioError> {
    let mut jet = Jet::new();
    let mut solves = |x: &[f64]| -> Result<bool, ScenarioError> {
        f.enclose(Order::Value, &IntervalVector::point(x), &[], &mut jet)?;
        Ok(jet.values().iter().zip(y).all(|(value, side)| value.subset_of(side)))
    };
    let (mut inside, mut outside) = (Matrix::zeros(members.rows(), 0), Vec::new());
    for x in members.columns() {
        if solves(x)? {
            inside.push_col(x)?;
        } else {
            outside.push(x);
        }
    }
    let mut found = inside.clone();
    for end in &outside {
        for _ in 0..4 {
            let start = inside.col(rng.random_range(0..inside.cols())).to_vec();
            let at = |t: f64| -> Vec<f64> { start.iter().zip(*end).map(|(a, b)| a + t * (b - a)).collect() };
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..24 {
                let middle = 0.5 * (low + high);
                if solves(&at(middle))? {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            found.push_col(&at(low))?;
        }
    }
    Ok(found)
}

/// Times of one call, on one thread.
///
/// # Errors
/// Those of the methods.
pub fn timings(context: &Context<'_>) -> Result<Vec<Row>, ScenarioError> {
    let mut rows = Vec::new();
    for task in Task::ALL {
        for &family in task.families() {
            let size = SIZES[0];
            let workspace = &mut Workspace::new();
            let rng = &mut monte_carlo::stream(context.seed, &label(family, size), 0);
            let case = draw(family, size, rng, workspace)?;
            let f: &dyn DynFunction = &*case.function;
            for form in Form::ALL {
                let members = case.sets.members(form, MEMBERS, rng, &mut workspace.sets)?;
                let values = target(f, &members)?;
                for &method in task.methods(form) {
                    let (start, mut times) = (Instant::now(), Vec::new());
                    while times.len() < CALLS || start.elapsed().as_secs_f64() < TIMED_S {
                        let call = Instant::now();
                        match task {
                            Task::Images => method.image(f, &case.sets, form, workspace)?,
                            Task::Solutions => method.solution(f, &case.sets, form, &values, workspace)?,
                        };
                        times.push(call.elapsed().as_nanos() as f64);
                    }
                    times.sort_unstable_by(f64::total_cmp);
                    // The median: other work on the machine slows some calls down.
                    let ns = times[times.len() / 2];
                    let row = Row::new(task.table(), label(family, size), method_name(method, form));
                    rows.push(row.metric("ns_per_call", "ns").value(ns));
                }
            }
        }
    }
    Ok(rows)
}

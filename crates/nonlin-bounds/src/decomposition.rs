//! Remainder-form decomposition over the generators of a set.
//!
//! On a box of coordinates `zeta` in `[-1, 1]^k` with `x = c + T zeta`, and for shifts `m` that make `g = f_i(c + T zeta) - m'zeta` monotone in
//! every coordinate, `g` lies between its values at two opposite corners: `f_i` in `m'zeta + [g(zl), g(zu)]`. Two frames `T` are tried, the
//! generators of the set (`zeta = xi`, the corners may lie outside of a constrained set) and the axes of its hull (`zeta` linear in `x`), each with
//! several choices of signs, and the rows whose residuals are narrowest are kept.

use scalars::Interval;
use scalars::rounding::add_up;
use setrep::{ConstrainedZonotope, IntervalVector, Matrix, SetError};

use crate::directional::Directional;
use crate::function::evaluate;
use crate::quadratic::is_model_size;
use crate::signs::{Purpose, Signs};
use crate::{BoundError, DynFunction, Jet, Operand, Order, Smoothness, Workspace};

/// Rows over the generators of a set: `f_i(x)` lies in `rows_i xi + residuals_i` for every point `x = c + G xi + e` of `set` in its hull.
pub(crate) struct Decomposition {
    /// The set with a remainder of model size turned into generators, and rescaled.
    pub(crate) set: ConstrainedZonotope,
    /// Its interval hull.
    pub(crate) hull: IntervalVector,
    /// The rows, `m x ng`, one an output.
    pub(crate) rows: Matrix,
    /// Their residuals, the narrowest found.
    pub(crate) residuals: Vec<Interval>,
    /// The next rows and residuals, if they were asked for; an output with fewer repeats its first.
    pub(crate) others: Vec<(Matrix, Vec<Interval>)>,
}

impl Decomposition {
    /// Decomposes `f` over a set in up to `count` ways. Outputs that are not asked for may be unbounded: their residual is the whole line.
    pub(crate) fn of(
        f: &dyn DynFunction,
        set: &ConstrainedZonotope,
        p: &[Interval],
        (count, is_asked_for): (usize, &dyn Fn(usize) -> bool),
        workspace: &mut Workspace,
    ) -> Result<Self, BoundError> {
        BoundError::check_size(Operand::Variables, f.variables(), set.dim())?;
        BoundError::check_box(Operand::Parameters, f.parameters(), p)?;
        let hull = set.interval_hull(&mut workspace.sets)?;
        if hull.iter().any(Interval::is_empty) {
            return Err(SetError::EmptySet.into());
        }
        BoundError::check_box(Operand::Hull, f.variables(), &hull)?;
        let mut set = set.clone();
        if set.remainder().iter().zip(hull.iter()).any(|(&r, side)| is_model_size(r, side.rad(), side.mag())) {
            set.materialize();
        }
        set.rescale(&mut workspace.sets)?;

        let middle: Vec<f64> = hull.iter().map(Interval::mid).collect();
        let over_hull = Directional::over(f, &hull, &middle, p)?;
        BoundError::check_smooth_where(&over_hull.over, Smoothness::C1, is_asked_for)?;
        // Outside of the hull, where the generators of a constrained set reach, the function may not be smooth: then they give no rows.
        let over_body = Directional::over(f, &set.unconstrained().interval_hull(), set.center(), p).ok();
        let m = f.outputs();
        let empty = (Matrix::zeros(m, set.num_generators()), Vec::with_capacity(m));
        let mut ways = vec![empty; count.max(1)];
        let signs = Signs::default();
        let mut search = Search { f, p, set: &set, hull: &hull, i: 0, signs, jet: Jet::new(), count, best: Vec::new() };
        for i in 0..m {
            if !is_asked_for(i) {
                ways.iter_mut().for_each(|(_, residuals)| residuals.push(Interval::ENTIRE));
                continue;
            }
            (search.i, search.best) = (i, Vec::new());
            search.over_axes(&over_hull.along_axes(i, &hull, &middle))?;
            if let Some(body) = over_body.as_ref().filter(|body| body.over.smoothness()[i] >= Smoothness::C1) {
                search.over_generators(&body.along_generators(i, &set))?;
            }
            let first = search.best.first().ok_or(BoundError::UnboundedResult { output: i })?;
            for (way, (rows, residuals)) in ways.iter_mut().enumerate() {
                let (row, residual) = search.best.get(way).unwrap_or(first);
                row.iter().enumerate().for_each(|(j, &entry)| rows[(i, j)] = entry);
                residuals.push(*residual);
            }
        }
        let others = ways.split_off(1);
        let (rows, residuals) = ways.pop().unwrap_or_default();
        Ok(Self { set, hull, rows, residuals, others })
    }
}

/// The search for the best rows of one output.
struct Search<'a> {
    f: &'a dyn DynFunction,
    p: &'a [Interval],
    set: &'a ConstrainedZonotope,
    hull: &'a [Interval],
    i: usize,
    signs: Signs,
    jet: Jet,
    /// Most rows to keep, and those found, the narrowest residual first.
    count: usize,
    best: Vec<(Vec<f64>, Interval)>,
}

impl Search<'_> {
    /// Rows over the axes of the hull: `f_i(x)` in `m'(x - c) + [g]` on the hull, then `x - c = G xi + e`.
    fn over_axes(&mut self, slopes: &[Interval]) -> Result<(), BoundError> {
        let (hull, center) = (self.hull, self.set.center());
        self.signs.plan(Purpose::Rows, slopes.iter().copied(), |k| hull[k].width());
        for choice in 0..self.signs.choices() {
            self.signs.choose(choice);
            let signs = &self.signs;
            let corner = |low: bool| {
                let at = |k: usize| if signs.rises(k) == low { hull[k].lo() } else { hull[k].hi() };
                (0..hull.len()).map(|k| Interval::point(at(k))).collect::<Vec<_>>()
            };
            let (low, high) = (corner(true), corner(false));
            let linear = |corner: &[Interval]| {
                (0..hull.len())
                    .fold(Interval::ZERO, |sum, k| sum + (corner[k].add_f64(-center[k])).scale(signs.shift(k)))
            };
            let (below, above) = (linear(&low), linear(&high));
            let shifts: Vec<f64> = (0..hull.len()).map(|k| signs.shift(k)).collect();
            let (low, high) = (self.value(&low)?, self.value(&high)?);
            let residual = Signs::between(low - below, high - above, 0.0);
            self.offer_combination(&shifts, residual);
        }
        Ok(())
    }

    /// Rows over the generators. A remainder of rounding size widens the corners.
    fn over_generators(&mut self, slopes: &[Interval]) -> Result<(), BoundError> {
        let generators = self.set.generators();
        self.signs.plan(Purpose::Rows, slopes.iter().copied(), |_| 2.0);
        for choice in 0..self.signs.choices() {
            self.signs.choose(choice);
            let signs = &self.signs;
            let corner = |low: bool| {
                let mut x: Vec<Interval> = self.set.center().iter().map(|&c| Interval::point(c)).collect();
                for (j, column) in generators.columns().enumerate() {
                    let sign = if signs.rises(j) == low { -1.0 } else { 1.0 };
                    x.iter_mut().zip(column).for_each(|(x, &g)| *x = x.add_f64(sign * g));
                }
                x.iter().zip(self.set.remainder()).map(|(x, &r)| x.inflate(r)).collect::<Vec<_>>()
            };
            let (low, high) = (corner(true), corner(false));
            // m'zl = -s and m'zu = s.
            let sign = |j: usize| if signs.rises(j) { 1.0 } else { -1.0 };
            let row: Vec<f64> = (0..generators.cols()).map(|j| signs.shift(j)).collect();
            let s = row.iter().enumerate().fold(Interval::ZERO, |sum, (j, &m)| sum.add_f64(sign(j) * m));
            let (low, high) = match (self.value(&low), self.value(&high)) {
                (Ok(low), Ok(high)) => (low, high),
                // Outside of a constrained set the function may not be defined.
                (Err(error), _) | (_, Err(error)) if error.is_of_the_box() => continue,
                (Err(error), _) | (_, Err(error)) => return Err(error),
            };
            self.offer(row, Signs::between(low + s, high - s, 0.0));
        }
        Ok(())
    }

    /// The output at a corner.
    fn value(&mut self, at: &[Interval]) -> Result<Interval, BoundError> {
        evaluate(self.f, Order::Value, at, self.p, &mut self.jet)?;
        Ok(self.jet.values()[self.i])
    }

    /// Offers `m'(x - c) + residual` as a row over the generators.
    fn offer_combination(&mut self, shifts: &[f64], residual: Interval) {
        let mut rounding = 0.0;
        let mut row = Vec::with_capacity(self.set.num_generators());
        for column in self.set.generators().columns() {
            let terms = shifts.iter().zip(column).filter(|(_, g)| **g != 0.0);
            let entry = terms.fold(Interval::ZERO, |sum, (&m, &g)| sum + Interval::point(g).scale(m));
            row.push(entry.mid());
            rounding = add_up(rounding, entry.rad());
        }
        let remainder = shifts.iter().zip(self.set.remainder());
        let spread = remainder.fold(Interval::ZERO, |sum, (&m, &r)| sum + Interval::ZERO.inflate(r).scale(m));
        self.offer(row, (residual + spread).inflate(rounding));
    }

    /// Keeps a row if it is finite and its residual is among the narrowest so far.
    fn offer(&mut self, row: Vec<f64>, residual: Interval) {
        let finite = residual.is_bounded() && row.iter().all(|entry| entry.is_finite());
        let place = self.best.partition_point(|(known, better)| cost(known, better) <= cost(&row, &residual));
        let is_known = self.best[..place].iter().any(|(known, _)| *known == row);
        if finite && place < self.count.max(1) && !is_known {
            // The same row with a wider residual says nothing more.
            self.best.retain(|(known, _)| *known != row);
            self.best.truncate(self.count.max(1) - 1);
            self.best.insert(place, (row, residual));
        }
    }
}

/// The width of a residual. Where two are the same but for rounding, as by symmetry, the shorter row is better: less of it is lost with the constraints.
fn cost(row: &[f64], residual: &Interval) -> f64 {
    residual.width() + 1e-6 * row.iter().map(|entry| entry.abs()).sum::<f64>()
}

//! Prediction: how a step moves the coordinates of the embedding and each row.
//!
//! `Z+ = Z E` with `E = exp(mu) exp(beta)`, `beta = P+ alpha`, `mu` the rounding of `P+`; with `W = T+^-1` and the noises `n_j`,
//!
//! ```text
//! q+_i = q_i + sum_j W_ij ( Z P n_j + Z (I - E) S+_j + misses )
//! ```
//!
//! A row `<D, Z> + sum <e_i, q_i> <= h` stays as it is but for `h`: with `f_j = sum_i W_ij e_i` and the lever `G = D - sum f_j S+_j'`
//!
//! ```text
//! h+ = h + sup <G, Z (E - I)> + sum_j sup <f_j, Z P n_j> + misses
//! ```
//!
//! With `Z = exp(r) C` and `p_i` the columns of `C P+` (of `C P` in the second), both are sums of `|alpha_i|`, `|n_ji|` times functionals of `exp(-r)`:
//! `<G, Z beta^> = sum alpha_i <p_i^ (G C')', exp(-r)>` and `<f, Z P n> = sum n_i <p_i f', exp(-r)>`. What is left of the first has second order:
//! `|exp(beta) - I - beta^|_F <= |beta|^2 / sqrt 2`, `|exp(mu) - I|_F <= sqrt 2 |mu|`.

use lie_groups::{Enclose, LieGroup, SO3};
use scalars::Interval;
use scalars::rounding::{ETA, UNIT_ROUNDOFF, add_up, mul_up};

use super::SpatialStrips;
use super::cell::Cell;
use super::frame::{ENTRIES, Frame, Misses};
use super::increment::SpatialIncrement;
use super::space::{
    Matrix, Region, Vector, apply, cross, exp, exp_of, hull, largest_length, largest_radius, length_up, matrix,
    matrix_of, middle, middle_of, norm1, point, product, rest, slip, sum,
};
use super::spread::Spread;
use crate::EstimatorError;
use crate::error::check_finite;
use crate::invariant_strips::check_bounded;

/// The rounding of a sum of some hundred terms of one sign, relative.
const SLACK: f64 = 1.0 + 1e-13;

/// Just above `1 / sqrt 2` and `sqrt 2`.
const SQUARE: f64 = 0.7072;
const CHORD: f64 = 1.4143;

/// What a cell adds to the rows: its attitudes, as seen by the noises.
#[derive(Debug, Clone, Copy)]
struct View {
    spread: Spread,
    /// `C`.
    correction: Matrix,
    /// The columns of `C P+` and of `C P`.
    turning: Matrix,
    moving: Matrix,
}

/// The constants of one step, reused by all rows.
#[derive(Debug, Clone)]
pub(super) struct Motion {
    frame: Frame,
    views: Vec<View>,
    cells: Vec<Cell>,
    misses: Misses,
    /// Radii of the noises of the turn, of each vector along the body's axes, and along the world's.
    turns: Vector,
    noises: Vec<Vector>,
    drifts: Vec<Vector>,
    /// Factor of `|G|_F`: terms of second order and the rounding of the attitude.
    bent: f64,
    /// The largest turn.
    angle: f64,
    /// Error of a functional of 1-norm 1.
    pad: f64,
    vectors: Vec<Region>,
    reach: Vec<Region>,
    room: Vec<f64>,
    pulled: Vec<Vector>,
}

impl Motion {
    pub(super) fn new(frame: &Frame) -> Self {
        Self {
            frame: frame.clone(),
            views: Vec::new(),
            cells: Vec::new(),
            misses: Vec::new(),
            turns: [0.0; 3],
            noises: Vec::new(),
            drifts: Vec::new(),
            bent: 0.0,
            angle: 0.0,
            pad: 0.0,
            vectors: Vec::new(),
            reach: Vec::new(),
            room: Vec::new(),
            pulled: Vec::new(),
        }
    }
}

impl SpatialStrips {
    /// Prepares a step; only the scratch changes.
    pub(super) fn plan(&mut self, input: &SpatialIncrement) -> Result<(), EstimatorError> {
        input.check(self.frame.vectors())?;
        let Self { frame, motion, cells, enclosure, reach, .. } = self;
        // exp(alpha) = exp(middle) exp(rest).
        let known = middle(&input.turn_noise);
        let offset: Region = core::array::from_fn(|k| input.turn_noise[k] - Interval::point(known[k]));
        let alpha = rest(known, &offset)?;
        let attitude = frame.attitude.compose(&exp_of(input.turn)).compose(&exp_of(known));
        check_finite("turn", &attitude.quaternion())?;
        let moved = frame.attitude.enclose().compose(&exp(&point(input.turn))).compose(&exp(&point(known)));
        let missed = slip(&moved.compose(&attitude.enclose().inverse()))?;

        motion.turns = alpha.map(|side| side.mag());
        let angle = largest_length(&alpha);
        motion.angle = add_up(angle, missed);
        motion.bent = add_up(mul_up(SQUARE, mul_up(angle, angle)), mul_up(CHORD, missed));
        let facing = matrix_of(&frame.attitude);
        motion.frame.advance(frame, attitude, &facing, input, reach, &mut motion.misses);
        motion.noises.clear();
        motion.drifts.clear();
        for vector in &input.vectors {
            motion.noises.push(vector.noise.map(|side| side.rad()));
            motion.drifts.push(vector.drift.map(|side| side.rad()));
        }
        motion.look(cells, &frame.attitude, missed, &alpha)?;
        motion.move_hulls(cells, &frame.attitude, input, &enclosure.vectors);
        motion.move_reach(input, reach);
        check_bounded("vectors of the world", motion.vectors.as_flattened())?;
        check_bounded("vectors of the world", motion.reach.as_flattened())?;
        check_finite("path", motion.frame.path.as_flattened())?;
        check_finite("shift", motion.frame.shift.as_flattened())?;
        check_finite("mixing", &motion.frame.mixing)?;
        check_finite("drift", &motion.room)
    }

    /// Takes the step that has been prepared.
    pub(super) fn transport(&mut self) {
        for i in 0..self.rows.len() {
            let growth = self.motion.growth(self.rows.normal(i));
            self.rows.raise(i, growth);
        }
        let motion = &mut self.motion;
        core::mem::swap(&mut self.frame, &mut motion.frame);
        core::mem::swap(&mut self.cells, &mut motion.cells);
        core::mem::swap(&mut self.enclosure.vectors, &mut motion.vectors);
        core::mem::swap(&mut self.reach, &mut motion.reach);
        core::mem::swap(&mut self.room, &mut motion.room);
        self.step += 1;
        // The hull of cells that could not be found is that of all attitudes.
        if self.enclose_attitude().is_err() {
            self.enclosure.turn_rad = super::space::any_turn();
        }
    }
}

impl Motion {
    /// The cells after the step, and what the rows need of those before it.
    fn look(&mut self, cells: &[Cell], attitude: &SO3<f64>, missed: f64, alpha: &Region) -> Result<(), EstimatorError> {
        self.views.clear();
        self.cells.clear();
        let (before, after) = (matrix_of(attitude), matrix_of(&self.frame.attitude));
        let mut off = 0.0_f64;
        for cell in cells {
            let correction = matrix_of(&cell.center);
            let (turning, moving) = (product(&correction, &after), product(&correction, &before));
            for block in [&correction, &turning, &moving] {
                off = off.max(largest_radius(block));
            }
            let columns = |block| middle_of(&super::space::transposed(block));
            self.views.push(View {
                spread: Spread::new(&cell.turn),
                correction: middle_of(&correction),
                turning: columns(&turning),
                moving: columns(&moving),
            });
            // C exp(mu) exp(beta) C' = exp(C mu) exp(C beta); the first factor moves the vector of the second by less than 2 |mu|.
            let delta = apply(&turning, alpha).map(|side| side.inflate(mul_up(2.0, missed)));
            let mut next = *cell;
            next.grow(&delta)?;
            self.cells.push(next);
        }
        if self.cells.iter().any(Cell::is_whole) {
            self.cells.clear();
            self.cells.push(Cell::whole());
        }
        // Entries off by `off` change a functional by less than 30 off; it is a sum of less than 1000 + 100 K roundings.
        let roundings = 1000.0 + 100.0 * self.misses.len() as f64;
        self.pad = add_up(mul_up(30.0, off), roundings * UNIT_ROUNDOFF);
        Ok(())
    }

    /// The boxes of the vectors after the step, world axes.
    fn move_hulls(&mut self, cells: &[Cell], attitude: &SO3<f64>, input: &SpatialIncrement, vectors: &[Region]) {
        self.vectors.clear();
        for (j, step) in input.vectors.iter().enumerate() {
            let body = sum(&step.shift, &step.noise);
            let mut moved = [Interval::EMPTY; 3];
            for cell in cells {
                let facing = exp(&cell.turn).compose(&cell.center.enclose()).compose(&attitude.enclose());
                moved = hull(&moved, &apply(&matrix(&facing), &body));
            }
            let start = sum(&vectors[j], &step.drift);
            let start =
                step.couplings.iter().fold(start, |start, &(i, c)| sum(&start, &vectors[i].map(|side| side.scale(c))));
            self.vectors.push(sum(&start, &moved));
        }
    }

    /// `|q+_i - q_i| <= sum_j |W_ij| (|n_j| + |E - I| |S+_j| + misses)`, and room for 128 such steps.
    fn move_reach(&mut self, input: &SpatialIncrement, reach: &[Region]) {
        let n = reach.len();
        self.reach.clear();
        self.room.clear();
        for i in 0..n {
            let (mut growth, mut room) = (0.0, 0.0);
            for j in 0..n {
                let noise = add_up(length_up(self.noises[j]), length_up(self.drifts[j]));
                let lever = mul_up(self.angle, length_up(self.frame.path[j]));
                let moved = add_up(add_up(noise, lever), self.misses[j]);
                growth = add_up(growth, mul_up(self.frame.inverse[i * n + j].mag(), moved));
                // After 64 steps, on average, the path has 64 of them and the coupling is 64 times as strong.
                let coupled: f64 =
                    input.vectors[i].couplings.iter().filter(|c| c.0 == j).map(|c| 64.0 * c.1.abs()).sum();
                let share = if i == j { 1.0 } else { coupled };
                let path = 64.0 * largest_length(&input.vectors[j].shift);
                room += 128.0 * share * (noise + self.angle * path);
            }
            self.reach.push(reach[i].map(|side| side.inflate(growth)));
            self.room.push(room);
        }
    }

    /// Upper bound of what the step adds to a row.
    fn growth(&mut self, normal: &[f64]) -> f64 {
        let n = self.misses.len();
        let mut lever: Matrix = core::array::from_fn(|k| [normal[3 * k], normal[3 * k + 1], normal[3 * k + 2]]);
        let (mut size, mut shifted) = (lever.iter().map(|row| norm1(*row)).sum::<f64>(), 0.0);
        let mut plain = 0.0;
        self.pulled.clear();
        for j in 0..n {
            let (mut f, mut extent, mut lost) = ([0.0; 3], 0.0, 0.0);
            for i in 0..=j {
                let weight = self.frame.inverse[i * n + j];
                let e = &normal[ENTRIES + 3 * i..ENTRIES + 3 * i + 3];
                for k in 0..3 {
                    f[k] += weight.mid() * e[k];
                    extent += (weight.mid() * e[k]).abs();
                    lost += weight.rad() * e[k].abs();
                }
            }
            self.pulled.push(f);
            if extent == 0.0 && lost == 0.0 {
                continue;
            }
            let path = self.frame.path[j];
            for k in 0..3 {
                for l in 0..3 {
                    lever[k][l] -= f[k] * path[l];
                }
            }
            let (noise, drift) = (norm1(self.noises[j]), self.drifts[j]);
            size += extent * norm1(path);
            shifted += extent * noise;
            // |f|_2 <= |f|_1 <= extent.
            plain += extent * self.misses[j] + drift[0] * f[0].abs() + drift[1] * f[1].abs() + drift[2] * f[2].abs();
            plain += lost * (noise + norm1(drift) + self.misses[j] + 2.0 * self.angle * norm1(path))
                + extent * norm1(drift) * 1e-13;
        }
        let frobenius = lever.as_flattened().iter().map(|x| x * x).sum::<f64>().sqrt();
        let widest = self.views.iter().map(|view| self.charge(view, &lever)).fold(0.0, larger);
        let pad = self.pad * (size * norm1(self.turns) + shifted);
        (widest + self.bent * (frobenius + 1e-13 * size) + plain + pad) * SLACK + 1e3 * ETA
    }

    /// The suprema of the noise terms over a cell, rounded.
    fn charge(&self, view: &View, lever: &Matrix) -> f64 {
        let mut charge = 0.0;
        // G C'.
        let corrected: Matrix = lever.map(|row| view.correction.map(|c| row[0] * c[0] + row[1] * c[1] + row[2] * c[2]));
        for i in 0..3 {
            let crossed = corrected.map(|row| cross(view.turning[i], row));
            let k: Matrix = core::array::from_fn(|a| [crossed[0][a], crossed[1][a], crossed[2][a]]);
            charge += self.turns[i] * view.spread.sup_abs(&k);
        }
        for (f, noise) in self.pulled.iter().zip(&self.noises) {
            if *f == [0.0; 3] {
                continue;
            }
            for i in 0..3 {
                let k: Matrix = view.moving[i].map(|p| f.map(|f| p * f));
                charge += noise[i] * view.spread.sup_abs(&k);
            }
        }
        charge
    }
}

/// The larger of two numbers, NaN if one is.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

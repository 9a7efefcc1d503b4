//! Cells: sets of attitudes, each a box of rotation vectors around a center of its own.
//!
//! The correction `Z = R P'` of the dead reckoned attitude `P` lies in one of the cells: `Z = exp(r) C` with `r` in the box, world axes. What
//! holds at every member of every cell holds at the truth.

use lie_groups::{Enclose, LieGroup, SO3};
use scalars::Interval;

use super::space::{
    Region, any_turn, exp, exp_of, hull, largest_length, middle, point, recentered, slip, turned_before, turned_on,
};
use crate::EstimatorError;

/// How far the middle of a box may be off its center, in radii of the box.
const OFF_CENTER: f64 = 0.5;

/// The sum of the radii up to which a box is not cut for a change of its center: vectors from its middle are shorter.
const PART: f64 = 0.45;

/// The sum of the radii from which on a box is not followed to another center.
const PARTED: f64 = 1.6;

/// Just above `2 (sqrt 2 - 1)`.
const COVERING: f64 = 0.828_43;

/// The corrections `exp(r) C`, `r` in a box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cell {
    pub(super) center: SO3<f64>,
    pub(super) turn: Region,
}

impl Cell {
    /// The corrections `exp(r)`.
    pub(super) fn new(turn: &Region) -> Self {
        let known = turn.iter().all(Interval::is_bounded) && largest_length(turn) < super::space::LONGEST;
        Self { center: SO3::identity(), turn: if known { *turn } else { any_turn() } }
    }

    /// All rotations.
    pub(super) fn whole() -> Self {
        Self { center: SO3::identity(), turn: any_turn() }
    }

    /// Whether it is the cell of all rotations.
    pub(super) fn is_whole(&self) -> bool {
        self.turn == any_turn()
    }

    /// 24 cells that cover all rotations: around those of the cube.
    ///
    /// Let `q` be a unit quaternion, `p` the one of the 48 of the cube's rotations (both signs) with the largest `q . p`, and `q p^-1 = (w, x)`. The 48
    /// are a group with `(1, +-e_k) / sqrt 2` in it, so `(w +- x_k) / sqrt 2 <= w`, that is `|x_k| <= (sqrt 2 - 1) w`. The rotation vector is
    /// `2 atan(|x| / w) x / |x|`, whose entries are at most `2 |x_k| / w`.
    pub(super) fn cover(cells: &mut Vec<Self>) {
        let turn = [Interval::ZERO.inflate(COVERING); 3];
        let quarter = core::f64::consts::FRAC_PI_2;
        let around = |axis: usize, quarters: f64| exp_of(super::space::AXES[axis].map(|x| x * quarter * quarters));
        cells.clear();
        // The third axis of the cube to each of the six faces, then a turn about it.
        for face in [(0, 0.0), (0, 1.0), (0, 2.0), (0, 3.0), (1, 1.0), (1, 3.0)] {
            for turns in [0.0, 1.0, 2.0, 3.0] {
                let center = around(face.0, face.1).compose(&around(2, turns));
                cells.push(Self { center, turn });
            }
        }
    }

    /// The radius of the widest side.
    pub(super) fn size(&self) -> f64 {
        self.turn.iter().fold(0.0, |most, side| side.rad().max(most))
    }

    /// Moves the center to the middle of the box, if it is far off.
    pub(super) fn recenter(&mut self) -> Result<(), EstimatorError> {
        let far = |side: &Interval| side.mid().abs() > OFF_CENTER * self.size();
        if self.turn.iter().any(far) {
            let center = exp_of(middle(&self.turn)).compose(&self.center);
            let turn = self.around(&center)?;
            if turn != any_turn() {
                *self = Self { center, turn };
            }
        }
        Ok(())
    }

    /// `Z+ = Z exp(beta)`: `delta = C beta` in a box.
    pub(super) fn grow(&mut self, delta: &Region) -> Result<(), EstimatorError> {
        match turned_on(&self.turn, delta)? {
            Some(turn) => self.turn = turn,
            None => *self = Self::whole(),
        }
        Ok(())
    }

    /// The two halves across the widest side.
    pub(super) fn halves(&self) -> [Self; 2] {
        let widest = (0..3).fold(0, |best, k| if self.turn[k].rad() > self.turn[best].rad() { k } else { best });
        let (side, cut) = (self.turn[widest], self.turn[widest].mid());
        let mut halves = [*self; 2];
        halves[0].turn[widest] = Interval::new(side.lo(), cut).unwrap_or(side);
        halves[1].turn[widest] = Interval::new(cut, side.hi()).unwrap_or(side);
        halves
    }

    /// The box of the cell around another center, the hull over its parts where it is large; all rotations if it may reach far.
    fn around(&self, center: &SO3<f64>) -> Result<Region, EstimatorError> {
        if *center == self.center {
            return Ok(self.turn);
        }
        let extent = self.turn.iter().map(Interval::rad).sum::<f64>();
        if extent <= PART {
            return self.part_around(center);
        }
        if extent > PARTED {
            return Ok(any_turn());
        }
        let [first, second] = self.halves();
        Ok(hull(&first.around(center)?, &second.around(center)?))
    }

    /// The box of a small cell around another center.
    ///
    /// `exp(r) C_1 = exp(y) exp(c) C_1` with `c` the middle of the box, and `exp(c) C_1 = exp(nu) exp(x) C` for a number `x`, where `nu` is rounding; the
    /// factor `exp(nu)` moves a vector by less than `2 |nu|`.
    fn part_around(&self, center: &SO3<f64>) -> Result<Region, EstimatorError> {
        let by = middle(&self.turn);
        let x = exp_of(by).compose(&self.center).compose(&center.inverse()).log()?;
        let x = [x[0], x[1], x[2]];
        let exact = exp(&point(by)).compose(&self.center.enclose()).compose(&center.enclose().inverse());
        let missed = slip(&exact.compose(&exp(&point(x)).inverse()))?;
        let y = recentered(&self.turn, by)?;
        let Some(y) = turned_on(&y, &[Interval::ZERO.inflate(missed); 3])? else { return Ok(any_turn()) };
        Ok(turned_before(&y, x)?.unwrap_or_else(any_turn))
    }
}

/// The hull of cells around the center of the middle one.
pub(super) fn merged(cells: &[Cell]) -> Result<Cell, EstimatorError> {
    let Some(middle) = cells.get(cells.len() / 2) else { return Ok(Cell::whole()) };
    let mut turn = middle.turn;
    for cell in cells {
        turn = hull(&turn, &cell.around(&middle.center)?);
    }
    Ok(Cell { center: middle.center, turn })
}

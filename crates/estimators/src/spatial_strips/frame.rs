//! The coordinates of the polytope: the entries of `Z` and the vectors as they were when the coordinates began.
//!
//! With the dead reckoned attitude `P`, `Z = R P'`, and the *mixing* `T`, the *shift* `o` and the *path* `S` of all steps since,
//!
//! ```text
//! x_j = sum_i T_ji q_i + o_j + Z S_j
//! ```
//!
//! Without noise `Z` and all `q_i` stay where they are. `T` is unit upper triangular, numbers exact by definition as `o` and `S` are.

use lie_groups::SO3;
use scalars::Interval;
use scalars::rounding::{add_up, mul_up};

use super::increment::SpatialIncrement;
use super::space::{Block, Region, Vector, apply, inner, middle, point, radius, sum};

/// Number of entries of `Z`, the first coordinates, row by row.
pub(super) const ENTRIES: usize = 9;

/// `P`, `T`, `o` and `S`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Frame {
    pub(super) attitude: SO3<f64>,
    /// `T`, row by row.
    pub(super) mixing: Vec<f64>,
    pub(super) shift: Vec<Vector>,
    pub(super) path: Vec<Vector>,
    /// Encloses `T^-1`, row by row.
    pub(super) inverse: Vec<Interval>,
}

/// By how much the numbers of a frame miss what a step makes of them: `|x_j - (..)| <= miss_j` for coordinates in a box.
pub(super) type Misses = Vec<f64>;

impl Frame {
    pub(super) fn new(attitude: SO3<f64>, vectors: usize) -> Self {
        let mut frame = Self {
            attitude,
            mixing: vec![0.0; vectors * vectors],
            shift: vec![[0.0; 3]; vectors],
            path: vec![[0.0; 3]; vectors],
            inverse: vec![Interval::ZERO; vectors * vectors],
        };
        frame.begin();
        frame
    }

    pub(super) fn vectors(&self) -> usize {
        self.path.len()
    }

    /// Number of coordinates.
    pub(super) fn dim(&self) -> usize {
        ENTRIES + 3 * self.vectors()
    }

    /// Coordinates that begin now: `q_j = x_j`.
    pub(super) fn begin(&mut self) {
        let n = self.vectors();
        for j in 0..n {
            for i in 0..n {
                let entry = if i == j { 1.0 } else { 0.0 };
                self.mixing[j * n + i] = entry;
                self.inverse[j * n + i] = Interval::point(entry);
            }
        }
        self.shift.fill([0.0; 3]);
        self.path.fill([0.0; 3]);
    }

    /// Becomes `before` moved by a step, `attitude` already known: `T+ = A T`, `o+ = A o + w`, `S+ = A S + P U`; the misses of the rounded numbers.
    pub(super) fn advance(
        &mut self,
        before: &Self,
        attitude: SO3<f64>,
        facing: &Block,
        step: &SpatialIncrement,
        reach: &[Region],
        misses: &mut Misses,
    ) {
        let n = before.vectors();
        self.attitude = attitude;
        misses.clear();
        for j in 0..n {
            let motion = &step.vectors[j];
            let mut missed = 0.0;
            for i in 0..n {
                let mixed = before.coupled(motion.couplings.iter(), j, |l| Interval::point(before.mixing[l * n + i]));
                self.mixing[j * n + i] = mixed.mid();
                let q = super::space::largest_length(&reach[i]);
                missed = add_up(missed, mul_up(mixed.rad(), q));
            }
            let drift = point(middle(&motion.drift));
            let coupled = |vectors: &[Vector]| -> Region {
                core::array::from_fn(|k| before.coupled(motion.couplings.iter(), j, |l| Interval::point(vectors[l][k])))
            };
            let shift = sum(&coupled(&before.shift), &drift);
            let moved = sum(&motion.shift, &point(middle(&motion.noise)));
            let path = sum(&coupled(&before.path), &apply(facing, &moved));
            self.shift[j] = middle(&shift);
            self.path[j] = middle(&path);
            misses.push(add_up(missed, add_up(radius(&shift), radius(&path))));
        }
        self.invert();
    }

    /// `v_j + sum_i c_ji v_i`.
    fn coupled<'a>(
        &self,
        couplings: impl Iterator<Item = &'a (usize, f64)>,
        j: usize,
        v: impl Fn(usize) -> Interval,
    ) -> Interval {
        couplings.fold(v(j), |sum, &(i, c)| sum + Interval::point(c) * v(i))
    }

    /// `W = T^-1`, from the last row up: `W_ji = I_ji - sum_{l > j} T_jl W_li`.
    fn invert(&mut self) {
        let n = self.vectors();
        for j in (0..n).rev() {
            for i in 0..n {
                let start = if i == j { Interval::ONE } else { Interval::ZERO };
                let entry = (j + 1..n)
                    .fold(start, |sum, l| sum - Interval::point(self.mixing[j * n + l]) * self.inverse[l * n + i]);
                self.inverse[j * n + i] = entry;
            }
        }
    }

    /// Writes the functional `u'(x_j + Z a) - constant` of the coordinates; returns the constant `u'o_j`.
    pub(super) fn aim(&self, normal: &mut [Interval], j: Option<usize>, u: &Region, a: &Region) -> Interval {
        let n = self.vectors();
        normal.fill(Interval::ZERO);
        let lever = j.map_or(*a, |j| sum(a, &point(self.path[j])));
        for k in 0..3 {
            for l in 0..3 {
                normal[3 * k + l] = u[k] * lever[l];
            }
        }
        let Some(j) = j else { return Interval::ZERO };
        for i in 0..n {
            for k in 0..3 {
                normal[ENTRIES + 3 * i + k] = u[k].scale(self.mixing[j * n + i]);
            }
        }
        inner(u, &point(self.shift[j]))
    }
}

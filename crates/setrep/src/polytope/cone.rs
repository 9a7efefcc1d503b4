//! Extreme rays of a polyhedral cone by the double description method, with exact combinatorics.
//!
//! `C = { y in R^d : a_i'y >= 0 }`. The method keeps the extreme rays of the cone of the constraints inserted so far, each with the
//! set `T` of inserted constraints that are tight at it. Inserting `a` splits the rays by the sign of `a'y` into `+`, `0`, `-`; those
//! of `-` die, and each pair of adjacent rays `p` of `+` and `n` of `-` has the child `(a'p) n - (a'n) p` with `T = (T_p & T_n) + a`.
//!
//! - **Signs are exact** ([`rays`](super::rays)), so the tight sets are, and the result is the one of real arithmetic.
//! - **Adjacency.** `p`, `n` are adjacent iff the smallest face that holds both has no other extreme ray: no other `T` contains
//!   `T_p & T_n` (needed: at least `d - 2` members). If `T_p` and `T_n` have just `d - 1` members, which are then independent, sharing
//!   `d - 2` of them is enough, and a hash table over these subsets finds the partner; only degenerate rays are paired one by one.
//! - **Waiting constraints.** Each keeps one ray that violates it as witness; without one it is redundant and dropped. When the
//!   witness dies it is enough to look among the new rays and those of `0`: the rays that violate a constraint are connected by
//!   edges, so if one lives on, an edge leads from a dead to a living one, and its child (or its end in `0`) violates too.
//!
//! **Source:** Motzkin et al., *The double description method* (1953); Fukuda, Prodon, *Double description method revisited*
//! (1996), propositions 5-7; the witnesses are the outside sets of Barber, Dobkin, Huhdanpaa, *The quickhull algorithm* (1996).

use core::cmp::Ordering;

use super::exact::Echelon;
use super::incidence::{common, count, is_subset, iter};
use super::rays::{Rays, Value};
use super::rows::{FacetRows, Rows};
use super::solve::{Solver, pivots};
use super::table::{NONE, Table, slot_key};
use super::waiting::Waiting;
use crate::SetError;

/// Word operations of adjacency tests before an enumeration is refused: some seconds.
const WORK_LIMIT: u64 = 4_000_000_000;

/// What the constraints span.
pub(super) enum Span {
    /// `dim` independent rows.
    Full(Vec<usize>),
    /// Fewer: columns on which the rows are independent; the others depend on them.
    Columns(Vec<usize>),
}

/// Independent rows, exactly. `first` comes first where the rank is not full.
pub(super) fn span(rows: &Rows<'_>, first: Option<usize>) -> Span {
    let dim = rows.dim();
    if let Some((order, _)) = pivots(&mut rows.scaled().to_vec(), dim, dim) {
        let basis: Vec<usize> = order[..dim].to_vec();
        let matrix: Vec<f64> = basis.iter().flat_map(|&i| rows.row(i)).copied().collect();
        // Regularity of the floats is that of the rows if scaling lost nothing.
        if !rows.has_underflow() && Solver::default().solve(dim, &matrix, &vec![0.0; dim]) {
            return Span::Full(basis);
        }
    }
    let mut echelon = Echelon::new(dim);
    let mut basis = Vec::with_capacity(dim);
    for i in first.into_iter().chain(0..rows.len()) {
        if echelon.push(&rows.integers(i).entries) {
            basis.push(i);
            if basis.len() == dim {
                return Span::Full(basis);
            }
        }
    }
    let mut columns = echelon.pivots().to_vec();
    columns.sort_unstable();
    Span::Columns(columns)
}

/// The extreme rays of a pointed cone.
pub(super) struct Cone<'a> {
    rows: &'a Rows<'a>,
    /// Ray storage; only `live` slots count.
    pub(super) rays: Rays,
    /// Slots of the extreme rays.
    pub(super) live: Vec<u32>,
    /// The row of each inserted constraint.
    pub(super) slots: Vec<u32>,
    free: Vec<u32>,
    keys: Vec<u64>,
    counts: Vec<u32>,
    values: Vec<Value>,
    waiting: Waiting,
    table: Table,
    max_rays: usize,
    work: u64,
}

impl<'a> Cone<'a> {
    /// Enumerates the extreme rays of a cone from `dim` independent rows.
    ///
    /// # Errors
    /// [`SetError::OverBudget`] if more than `max_rays` rays are alive at some stage, or pairing them takes too long.
    pub(super) fn enumerate(rows: &'a Rows<'a>, basis: &[usize], max_rays: usize) -> Result<Self, SetError> {
        Self::enumerate_first(rows, basis, rows.len(), max_rays)
    }

    /// [`enumerate`](Self::enumerate) for the cone of the first `count` rows only; the others can be evaluated at its rays.
    ///
    /// # Errors
    /// As [`enumerate`](Self::enumerate).
    pub(super) fn enumerate_first(
        rows: &'a Rows<'a>,
        basis: &[usize],
        count: usize,
        max_rays: usize,
    ) -> Result<Self, SetError> {
        let mut cone = Self::empty(rows, basis.iter().map(|&i| i as u32).collect(), max_rays);
        cone.start();
        cone.run(0..count)?;
        Ok(cone)
    }

    /// No rays, and some rows that count as inserted.
    fn empty(rows: &'a Rows<'a>, slots: Vec<u32>, max_rays: usize) -> Self {
        Self {
            rows,
            rays: Rays::new(rows.dim(), slots.len().max(64)),
            live: Vec::new(),
            slots,
            free: Vec::new(),
            keys: Vec::new(),
            counts: Vec::new(),
            values: Vec::new(),
            waiting: Waiting::new(rows.len()),
            table: Table::default(),
            max_rays,
            work: 0,
        }
    }

    /// Inserts the rows of a range that are not inserted yet, those that cut off the most first.
    fn run(&mut self, range: core::ops::Range<usize>) -> Result<(), SetError> {
        let everyone = self.live.clone();
        for row in range {
            if !self.slots.contains(&(row as u32)) && self.rows.norm(row) > 0.0 {
                self.waiting.rows.push(row as u32);
                self.find_witness(row, &everyone);
            }
        }
        self.waiting.drop_settled();
        while let Some(row) = self.waiting.take_worst() {
            self.insert(row as usize)?;
        }
        Ok(())
    }

    /// The simplicial cone of the basis: ray `i` is tight at all of it but constraint `i`.
    fn start(&mut self) {
        let dim = self.rows.dim();
        for i in 0..dim {
            let ray = self.new_ray();
            for slot in (0..dim).filter(|&slot| slot != i) {
                self.rays.tight.insert(ray, slot);
                self.keys[ray] ^= slot_key(slot);
            }
            self.counts[ray] = dim as u32 - 1;
            self.live.push(ray as u32);
            self.rays.solve(self.rows, &self.slots, ray);
        }
    }

    /// Cuts the hull of some points, given with its facets as the first rows, by the other rows. `extreme` lists its vertices as members
    /// of the incidence; ray `i` starts as the `i`-th of them.
    ///
    /// # Errors
    /// As [`enumerate`](Self::enumerate).
    pub(super) fn cut(
        rows: &'a Rows<'a>,
        facets: &FacetRows,
        extreme: &[usize],
        max_rays: usize,
    ) -> Result<Self, SetError> {
        let count = facets.incidence.len();
        let mut cone = Self::empty(rows, (0..count as u32).collect(), max_rays);
        let facets_of = facets.incidence.transpose(facets.columns.len());
        for &k in extreme {
            let ray = cone.new_ray();
            for facet in iter(facets_of.get(k)) {
                cone.rays.tight.insert(ray, facet);
                cone.keys[ray] ^= slot_key(facet);
                cone.counts[ray] += 1;
            }
            cone.rays.set_exact(ray, &facets.points, facets.columns[k]);
            cone.live.push(ray as u32);
        }
        cone.run(count..rows.len())?;
        Ok(cone)
    }

    fn new_ray(&mut self) -> usize {
        if let Some(ray) = self.free.pop() {
            let ray = ray as usize;
            self.rays.clear(ray);
            (self.keys[ray], self.counts[ray], self.waiting.first[ray]) = (0, 0, NONE);
            return ray;
        }
        self.keys.push(0);
        self.counts.push(0);
        self.waiting.first.push(NONE);
        self.values.push(Value { sign: Ordering::Equal, mid: 0.0, err: 0.0 });
        self.rays.push()
    }

    /// Hands a waiting row to the candidate that it cuts off the most, or settles it if it cuts off none.
    fn find_witness(&mut self, row: usize, candidates: &[u32]) {
        let (mut witness, mut worst) = (NONE, 0.0);
        let mut undecided = false;
        for &ray in candidates {
            match self.rays.estimate(self.rows, ray as usize, row) {
                Some(value) if value.mid < worst => (witness, worst) = (ray, value.mid),
                Some(_) => {}
                None => undecided = true,
            }
        }
        if witness == NONE && undecided {
            for &ray in candidates {
                let value = self.rays.value(self.rows, &self.slots, ray as usize, row);
                if value.sign.is_lt() {
                    (witness, worst) = (ray, value.mid);
                    break;
                }
            }
        }
        self.waiting.violation[row] = -1.0;
        if witness != NONE {
            self.waiting.violation[row] = -worst / self.rows.norm(row);
            self.waiting.next[row] = core::mem::replace(&mut self.waiting.first[witness as usize], row as u32);
        }
    }

    /// Inserts one constraint that some ray violates.
    fn insert(&mut self, row: usize) -> Result<(), SetError> {
        let dim = self.rows.dim();
        let slot = self.slots.len();
        let (mut plus, mut zero, mut minus) = (Vec::new(), Vec::new(), Vec::new());
        for &ray in &self.live {
            let value = self.rays.value(self.rows, &self.slots, ray as usize, row);
            self.values[ray as usize] = value;
            match value.sign {
                Ordering::Greater => plus.push(ray),
                Ordering::Equal => zero.push(ray),
                Ordering::Less => minus.push(ray),
            }
        }
        let pairs = self.adjacent_pairs(&plus, &minus)?;
        let alive = plus.len() + zero.len() + pairs.len();
        if alive > self.max_rays {
            return Err(SetError::OverBudget { count: alive, limit: self.max_rays });
        }
        self.slots.push(row as u32);
        self.rays.tight.grow_universe(slot + 1);
        for &ray in &zero {
            self.rays.tight.insert(ray as usize, slot);
            self.keys[ray as usize] ^= slot_key(slot);
            self.counts[ray as usize] += 1;
        }
        let mut candidates = Vec::with_capacity(pairs.len() + zero.len());
        for &(p, n) in &pairs {
            candidates.push(self.child(p as usize, n as usize, slot) as u32);
        }
        self.live = plus;
        self.live.extend_from_slice(&zero);
        self.live.extend_from_slice(&candidates);
        candidates.extend_from_slice(&zero);
        debug_assert!(self.live.iter().all(|&ray| self.counts[ray as usize] as usize + 1 >= dim));
        for &ray in &minus {
            let mut orphan = core::mem::replace(&mut self.waiting.first[ray as usize], NONE);
            while orphan != NONE {
                let next = self.waiting.next[orphan as usize];
                if orphan as usize != row {
                    self.find_witness(orphan as usize, &candidates);
                }
                orphan = next;
            }
        }
        self.free.extend_from_slice(&minus);
        self.waiting.drop_settled();
        Ok(())
    }

    /// The ray of the edge from `p` to `n` on which constraint `slot` is tight.
    fn child(&mut self, p: usize, n: usize, slot: usize) -> usize {
        let ray = self.new_ray();
        let (mut key, mut tight_count) = (slot_key(slot), 1);
        for word in 0..self.rays.tight.get(ray).len() {
            let mut both = self.rays.tight.get(p)[word] & self.rays.tight.get(n)[word];
            self.rays.tight.get_mut(ray)[word] = both;
            tight_count += both.count_ones();
            while both != 0 {
                key ^= slot_key(64 * word + both.trailing_zeros() as usize);
                both &= both - 1;
            }
        }
        self.rays.tight.insert(ray, slot);
        (self.keys[ray], self.counts[ray]) = (key, tight_count);
        self.rays.combine(ray, (p, self.values[p]), (n, self.values[n]));
        if self.rays.is_coarse(ray) {
            self.rays.solve(self.rows, &self.slots, ray);
        }
        ray
    }

    /// The adjacent pairs of a ray of `plus` and a ray of `minus`.
    fn adjacent_pairs(&mut self, plus: &[u32], minus: &[u32]) -> Result<Vec<(u32, u32)>, SetError> {
        let dim = self.rows.dim() as u32;
        let shared = dim.saturating_sub(2);
        let tight = &self.rays.tight;
        let is_simple = |&ray: &u32| self.counts[ray as usize] + 1 == dim;
        // A partner shares `dim - 2` constraints with a ray of `minus`, all the more with their union.
        let mut union = vec![0; tight.get(minus[0] as usize).len()];
        for &ray in minus {
            for (all, word) in union.iter_mut().zip(tight.get(ray as usize)) {
                *all |= word;
            }
        }
        let near: Vec<u32> =
            plus.iter().copied().filter(|&ray| common(tight.get(ray as usize), &union) >= shared).collect();
        let (simple_minus, other_minus): (Vec<u32>, Vec<u32>) = minus.iter().copied().partition(is_simple);
        let (simple_near, other_near): (Vec<u32>, Vec<u32>) = near.iter().copied().partition(is_simple);
        let mut pairs = Vec::new();
        self.table.reset(simple_minus.len() * (dim as usize - 1));
        for &ray in &simple_minus {
            for slot in iter(tight.get(ray as usize)) {
                self.table.insert(self.keys[ray as usize] ^ slot_key(slot), ray);
            }
        }
        for &p in &simple_near {
            for slot in iter(tight.get(p as usize)) {
                self.table.find(self.keys[p as usize] ^ slot_key(slot), |n| {
                    if common(tight.get(p as usize), tight.get(n as usize)) == shared {
                        pairs.push((p, n));
                    }
                });
            }
        }
        let mut both = vec![0; union.len()];
        for (left, right) in [(&near, &other_minus), (&other_near, &simple_minus)] {
            for &p in left {
                for &n in right {
                    for ((word, a), b) in both.iter_mut().zip(tight.get(p as usize)).zip(tight.get(n as usize)) {
                        *word = a & b;
                    }
                    self.work += both.len() as u64;
                    if count(&both) < shared {
                        continue;
                    }
                    self.work += (self.live.len() * both.len()) as u64;
                    let is_face_of = |&ray: &u32| ray != p && ray != n && is_subset(&both, tight.get(ray as usize));
                    match self.live.iter().position(is_face_of) {
                        // The next pair often fails on the same ray.
                        Some(at) => self.live.swap(0, at),
                        None => pairs.push((p, n)),
                    }
                }
                if self.work > WORK_LIMIT {
                    return Err(SetError::OverBudget { count: self.live.len(), limit: self.max_rays });
                }
            }
        }
        Ok(pairs)
    }
}

//! Random constrained zonotopes with exact members, and exact proofs that points lie in sets.

use nonlin_bounds::AffineEnclosure;
use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Zonotope};

use crate::polynomials::Polynomials;
use crate::sets::dyadic::Dyadic;
use crate::sets::exact::{Member, is_witness, member, times};
use crate::sets::random::Random;

/// A random set with `count` members: entries over 16 decades, integers, zeros; remainders of all sizes; ranges with and without width.
pub(crate) fn constrained(random: &mut Random, n: usize, count: usize) -> (ConstrainedZonotope, Vec<Member>) {
    let (m, rows) = (random.between(0, 6), random.between(0, 3));
    let body = random.set(n, m);
    let members: Vec<Member> = (0..count).map(|_| member(&body, random)).collect();
    (with_rows(random, &body, rows, &members), members)
}

/// The same on a grid of few bits, where the members' coordinates and their products are exact floats.
pub(crate) fn on_grid(random: &mut Random, n: usize, count: usize) -> (ConstrainedZonotope, Vec<Member>) {
    let (m, rows) = (random.between(1, 4), random.between(0, 2));
    let grid = |random: &mut Random| (random.below(65) as f64 - 32.0) / 16.0;
    let center: Vec<f64> = (0..n).map(|_| grid(random)).collect();
    let entries: Vec<f64> = (0..n * m).map(|_| grid(random)).collect();
    let g = Matrix::from_column_slice(n, m, &entries).unwrap();
    let large = random.below(2) as f64;
    let remainder: Vec<f64> = (0..n).map(|_| large * grid(random).abs()).collect();
    let body = Zonotope::with_remainder(&center, &g, &remainder).unwrap();
    let vertex = random.below(3) == 0;
    let unit = |random: &mut Random| {
        if vertex { 1.0 - 2.0 * random.below(2) as f64 } else { (random.below(17) as f64 - 8.0) / 8.0 }
    };
    let members: Vec<Member> = (0..count)
        .map(|_| {
            let xi: Vec<f64> = (0..m).map(|_| unit(random)).collect();
            let eta: Vec<f64> = (0..n).map(|_| unit(random)).collect();
            let mut x = times(&g, &xi);
            for k in 0..n {
                x[k] += &(&Dyadic::from(center[k]) + &(&Dyadic::from(remainder[k]) * &Dyadic::from(eta[k])));
            }
            Member { xi, eta, x }
        })
        .collect();
    (with_rows(random, &body, rows, &members), members)
}

/// The set with random constraints that its members fulfil, at the ends of the ranges if there are no widths.
fn with_rows(random: &mut Random, body: &Zonotope, rows: usize, members: &[Member]) -> ConstrainedZonotope {
    let a = random.matrix(rows, body.num_generators());
    let mut ranges = vec![Interval::EMPTY; rows];
    for member in members {
        for (range, value) in ranges.iter_mut().zip(times(&a, &member.xi)) {
            let width = if random.below(2) == 0 { 0.0 } else { (value.approx().abs() + 1e-3) * random.unit().abs() };
            *range = range.hull(around(&value, 0.0, width));
        }
    }
    ConstrainedZonotope::with_constraints(body, &a, &ranges).unwrap()
}

/// An interval that contains `value`, its ends about `below` and `above` away.
pub(crate) fn around(value: &Dyadic, below: f64, above: f64) -> Interval {
    let (mut lo, mut hi) = (value.approx() - below, value.approx() + above);
    while &Dyadic::from(lo) > value {
        lo = lo.next_down();
    }
    while &Dyadic::from(hi) < value {
        hi = hi.next_up();
    }
    Interval::new(lo, hi).unwrap()
}

/// Whether `value` lies in the interval, exactly.
pub(crate) fn contains(side: Interval, value: &Dyadic) -> bool {
    (side.lo() == f64::NEG_INFINITY || &Dyadic::from(side.lo()) <= value)
        && (side.hi() == f64::INFINITY || value <= &Dyadic::from(side.hi()))
}

/// Whether `f(x) - J (x - gamma)` lies in `[e]`, exactly.
pub(crate) fn is_enclosed(enclosure: &AffineEnclosure, x: &[Dyadic], y: &[Dyadic]) -> bool {
    (0..enclosure.outputs()).all(|i| {
        let mut rest = y[i].clone();
        for k in 0..enclosure.variables() {
            let step = &x[k] - &Dyadic::from(enclosure.at()[k]);
            rest += &-(&Dyadic::from(enclosure.jacobian()[(i, k)]) * &step);
        }
        contains(enclosure.offsets()[i], &rest)
    })
}

/// Whether the member's coordinates, those of its remainder where that has become generators, and `tail` prove that `x` lies in the
/// result of an operation on `set`.
pub(crate) fn is_proven_member(
    set: &ConstrainedZonotope,
    result: &ConstrainedZonotope,
    member: &Member,
    tail: &[f64],
    x: &[Dyadic],
) -> bool {
    let Some(extra) = result.num_generators().checked_sub(set.num_generators() + tail.len()) else { return false };
    (0_u32..1 << set.dim()).filter(|rows| rows.count_ones() as usize == extra).any(|rows| {
        let mut xi = member.xi.clone();
        xi.extend((0..set.dim()).filter(|k| rows >> k & 1 == 1).map(|k| member.eta[k]));
        xi.extend_from_slice(tail);
        let activity = times(result.constraints(), &xi);
        is_witness(result.unconstrained(), &xi, x)
            && activity.iter().zip(result.ranges()).all(|(value, &range)| contains(range, value))
    })
}

/// The exact values of polynomials.
pub(crate) fn values(f: &Polynomials, x: &[Dyadic]) -> Vec<Dyadic> {
    let term = |(c, factors): &(f64, Vec<usize>)| factors.iter().fold(Dyadic::from(*c), |product, &k| &product * &x[k]);
    f.outputs.iter().map(|terms| terms.iter().map(term).fold(Dyadic::zero(), |sum, y| &sum + &y)).collect()
}

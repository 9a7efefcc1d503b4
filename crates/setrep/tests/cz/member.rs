//! Random constrained zonotopes with an exact member, and exact proofs of membership.
// Each binary uses its own part.
#![allow(dead_code)]

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Membership, Workspace, Zonotope};

use crate::common::dyadic::Dyadic;
use crate::common::exact::{Member, image, is_witness, member, times};
use crate::common::random::Random;

/// A random set with a random member: entries over 16 decades, integers, zeros, or a dyadic grid; ranges with and without width.
pub(crate) fn constrained(random: &mut Random, n: usize, m: usize, rows: usize) -> (ConstrainedZonotope, Member) {
    if random.below(3) == 0 {
        return on_grid(random, n, m, rows);
    }
    let body = random.set(n, m);
    let member = member(&body, random);
    let a = random.matrix(rows, m);
    let activity = times(&a, &member.xi);
    let ranges: Vec<Interval> = activity
        .iter()
        .map(|value| {
            let reach = value.approx().abs() + 1e-3;
            let width = |random: &mut Random| if random.below(2) == 0 { 0.0 } else { reach * random.unit().abs() };
            let (below, above) = (width(random), width(random));
            around(value, below, above)
        })
        .collect();
    (ConstrainedZonotope::with_constraints(&body, &a, &ranges).unwrap(), member)
}

/// All numbers are multiples of 2^-6 of modest size: sums and products are exact, so equalities and points are representable.
fn on_grid(random: &mut Random, n: usize, m: usize, rows: usize) -> (ConstrainedZonotope, Member) {
    let mut grid =
        |count: usize| -> Vec<f64> { (0..count).map(|_| (random.below(257) as f64 - 128.0) / 64.0).collect() };
    let (center, g, a) = (grid(n), grid(n * m), grid(rows * m));
    let g = Matrix::from_column_slice(n, m, &g).unwrap();
    let a = Matrix::from_column_slice(rows, m, &a).unwrap();
    let body = Zonotope::new(&center, &g).unwrap();
    let vertex = random.below(3);
    let xi: Vec<f64> = (0..m)
        .map(|_| match vertex {
            0 => 1.0 - 2.0 * random.below(2) as f64,
            _ => (random.below(33) as f64 - 16.0) / 16.0,
        })
        .collect();
    let mut x = times(&g, &xi);
    x.iter_mut().zip(&center).for_each(|(x, &c)| *x += &Dyadic::from(c));
    let ranges: Vec<Interval> =
        times(&a, &xi).iter().map(|b| Interval::point(b.approx()).inflate([0.0, 0.0, 0.25][random.below(3)])).collect();
    let set = ConstrainedZonotope::with_constraints(&body, &a, &ranges).unwrap();
    (set, Member { xi, eta: vec![0.0; n], x })
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

/// Whether `xi` proves `x` a member: `|xi| <= 1`, `A xi in [b]` and `|x - c - G xi| <= r`, exactly.
pub(crate) fn is_constrained_witness(set: &ConstrainedZonotope, xi: &[f64], x: &[Dyadic]) -> bool {
    let activity = times(set.constraints(), xi);
    is_witness(set.unconstrained(), xi, x)
        && activity
            .iter()
            .zip(set.ranges())
            .all(|(a, range)| &Dyadic::from(range.lo()) <= a && a <= &Dyadic::from(range.hi()))
}

/// The same if components of the remainder of `set` have become generators behind the first `own` ones of `result`: their
/// coordinates are those of the member. `tail` are the coordinates behind them.
pub(crate) fn is_extended_witness(
    set: &ConstrainedZonotope,
    result: &ConstrainedZonotope,
    member: &Member,
    tail: &[f64],
    x: &[Dyadic],
) -> bool {
    let extra = result.num_generators() - set.num_generators() - tail.len();
    (0_u32..1 << set.dim()).filter(|rows| rows.count_ones() as usize == extra).any(|rows| {
        let mut xi = member.xi.clone();
        xi.extend((0..set.dim()).filter(|k| rows >> k & 1 == 1).map(|k| member.eta[k]));
        xi.extend_from_slice(tail);
        is_constrained_witness(result, &xi, x)
    })
}

/// The same set with every range wider by a share of its row's 1-norm on either side.
///
/// What rounding does to a row is a share of its 1-norm, whether the row is rewritten or a linear program may miss it by a few
/// roundings. How far the set moves with its rows is its own affair: by 1e-7 of its size for 1e-16, if its rows are nearly
/// dependent. So two forms of a set agree up to the size of this one.
pub(crate) fn loosened(set: &ConstrainedZonotope, share: f64) -> ConstrainedZonotope {
    let norm = |i: usize| set.constraints().columns().map(|column| column[i].abs()).sum::<f64>();
    let ranges: Vec<Interval> = set.ranges().iter().enumerate().map(|(i, b)| b.inflate(share * norm(i))).collect();
    ConstrainedZonotope::with_constraints(set.unconstrained(), set.constraints(), &ranges).unwrap()
}

/// `d'x`, exactly.
pub(crate) fn dot(d: &[f64], x: &[Dyadic]) -> Dyadic {
    image(&Matrix::from_column_slice(1, d.len(), d).unwrap(), x).remove(0)
}

/// Panics if `x` is proven not to lie in the set: by a support value below `d'x` (compared exactly), by the hull, by a proof of
/// emptiness, or by a proof of non-membership.
pub(crate) fn assert_not_refuted(
    set: &ConstrainedZonotope,
    x: &[Dyadic],
    random: &mut Random,
    workspace: &mut Workspace,
    context: &dyn Fn() -> String,
) {
    let n = set.dim();
    let hull = set.interval_hull(workspace).unwrap();
    for (side, x) in hull.iter().zip(x) {
        let inside = !side.is_empty() && &Dyadic::from(side.lo()) <= x && x <= &Dyadic::from(side.hi());
        assert!(inside, "outside the hull {hull:?}: {}", context());
    }
    for _ in 0..2 {
        let d: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        let h = set.support(&d, workspace).unwrap();
        assert!(
            h == f64::INFINITY || dot(&d, x) <= Dyadic::from(h),
            "above the support {h} along {d:?}: {}",
            context()
        );
    }
    let point: Vec<Interval> = x.iter().map(|x| around(x, 0.0, 0.0)).collect();
    let verdict = set.membership(&point, workspace).unwrap();
    assert!(verdict != Membership::ProvenOutside, "proven outside: {}", context());
}

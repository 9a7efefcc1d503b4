//! Outlines and meshes: the outside contains the set exactly, the inside has the right vertices, sizes and orientation.

// A failed `unwrap` is a failed test, in helpers as in tests.
#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod meshes;
mod outlines;

use common::dyadic::Dyadic;
use common::exact::{Member, member, times};
use common::random::Random;
use scalars::Interval;
use setrep::{ConstrainedZonotope, Zonotope};

/// Seed of all batteries; printed with every failing case.
const SEED: u64 = 20_261_124;

/// A zonotope, and a constrained zonotope of the same body by a row whose range holds the member.
fn cut_at_a_member(random: &mut Random, body: &Zonotope) -> (ConstrainedZonotope, Member) {
    let member = member(body, random);
    let row = random.matrix(1, body.num_generators());
    let value = &times(&row, &member.xi)[0];
    let middle = value.approx();
    let width = 1e-15 * middle.abs() + [0.0, 0.3 * middle.abs()][random.below(2)] + f64::MIN_POSITIVE;
    let range = Interval::point(middle).inflate(width);
    assert!(Dyadic::from(range.lo()) <= *value && *value <= Dyadic::from(range.hi()));
    (ConstrainedZonotope::with_constraints(body, &row, &[range]).unwrap(), member)
}

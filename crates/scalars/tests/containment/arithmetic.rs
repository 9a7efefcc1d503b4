//! Random operations against exact numbers: the exact results at the ends of the boxes and at random members lie in the
//! computed interval.

use scalars::Interval;

use crate::support::cases;
use crate::support::dyadic::{Dyadic, contains, contains_ratio};
use crate::support::random::Random;

const OPERATIONS: usize = 1_000_000;

/// Members of a box to test: its finite ends and a random one.
fn members(random: &mut Random, x: Interval) -> [f64; 3] {
    [x.lo().max(f64::MIN), x.hi().min(f64::MAX), random.member(x)]
}

fn check(name: &str, inputs: &[Interval], points: &[f64], result: Interval, inside: bool) {
    assert!(inside, "{name} {inputs:?} = {result:?} misses the exact result at {points:?}");
}

/// Binary operations at all pairs of members; division by zero has no result.
fn binary(random: &mut Random, count: usize) {
    let one = Dyadic::from_float(1.0);
    for i in 0..count {
        let (x, y) = (random.interval(), random.interval());
        let (name, result) = match i % 4 {
            0 => ("add", x + y),
            1 => ("sub", x - y),
            2 => ("mul", x * y),
            _ => ("div", x / y),
        };
        let (xs, ys) = (members(random, x), members(random, y));
        for (a, b) in [(0, 0), (0, 1), (1, 0), (1, 1), (2, 2)].map(|(i, j)| (xs[i], ys[j])) {
            let (p, q) = (Dyadic::from_float(a), Dyadic::from_float(b));
            let inside = match i % 4 {
                0 => contains(result, &p.add(&q)),
                1 => contains(result, &p.add(&q.neg())),
                2 => contains(result, &p.mul(&q)),
                _ if b == 0.0 => continue,
                _ => contains_ratio(result, &p, &q),
            };
            check(name, &[x, y], &[a, b], result, inside);
        }
        if i % 4 == 1 {
            let k = random.float();
            let (scaled, moved, a) = (x.scale(k), x.add_f64(k), random.member(x));
            let (p, q) = (Dyadic::from_float(a), Dyadic::from_float(k));
            check("scale", &[x], &[a, k], scaled, contains_ratio(scaled, &p.mul(&q), &one));
            check("add_f64", &[x], &[a, k], moved, contains(moved, &p.add(&q)));
        }
    }
}

/// Unary operations at all members; roots are tested by the squares of the bounds.
fn unary(random: &mut Random, count: usize) {
    let one = Dyadic::from_float(1.0);
    for i in 0..count {
        let x = random.interval();
        let n = random.below(25) as i32 - 12;
        let (name, result) = match i % 4 {
            0 => ("sqr".to_owned(), x.sqr()),
            1 => ("recip".to_owned(), x.recip()),
            2 => ("sqrt".to_owned(), x.sqrt()),
            _ => (format!("powi({n})"), x.powi(n)),
        };
        for a in members(random, x) {
            let p = Dyadic::from_float(a);
            let inside = match i % 4 {
                0 => contains(result, &p.mul(&p)),
                2 if a < 0.0 => continue,
                2 => contains_root(result, &p),
                _ if a == 0.0 && (i % 4 == 1 || n < 0) => continue,
                1 => contains_ratio(result, &one, &p),
                _ if n < 0 => contains_ratio(result, &one, &p.pow(n.unsigned_abs())),
                _ => contains(result, &p.pow(n.unsigned_abs())),
            };
            check(&name, &[x], &[a], result, inside);
        }
    }
}

/// `sqrt(x)` lies in the interval: the exact squares of its bounds lie around `x`.
fn contains_root(root: Interval, x: &Dyadic) -> bool {
    let square = |bound: f64| Dyadic::from_float(bound).pow(2);
    let above = root.hi() == f64::INFINITY || square(root.hi()).compare(x).is_ge();
    root.lo() >= 0.0 && square(root.lo()).compare(x).is_le() && above
}

#[test]
fn random_operations_contain_exact_results() {
    let mut random = Random::new("random operations", 20_240_601);
    binary(&mut random, cases(OPERATIONS) / 2);
    unary(&mut random, cases(OPERATIONS) / 2);
}

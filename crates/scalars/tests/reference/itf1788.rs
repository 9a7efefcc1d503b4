//! ITF1788, the test vectors of IEEE Std 1788-2015: every assertion on bare intervals and an operation of this crate.
//!
//! The vectors give the tightest result. An interval result must contain it and may exceed it by a few floats per bound;
//! exact operations must agree. Assertions on operations the crate does not have are counted by name.

use std::collections::BTreeMap;
use std::path::PathBuf;

use scalars::Interval;

use crate::itl::{Assertion, Value, assertions};

/// Floats per bound that an interval result may exceed the tightest one: none for exact operations.
const EXACT: u32 = 0;
const BASIC: u32 = 2;
const ELEMENTARY: u32 = 4;
/// No budget: the worst is reported.
const REPORTED: u32 = u32::MAX;

enum Outcome {
    /// Interval result and its budget.
    Interval(Interval, u32),
    /// Any other result, which must be equal.
    Equal(Vec<Value>),
    NotImplemented,
}

/// Runs an operation of the crate; decorated arguments are for operations the crate does not have.
fn run(assertion: &Assertion) -> Outcome {
    use Outcome::{Equal, NotImplemented};
    use Value::{Bool, Interval as I, Number, Text};
    let exact = |x| Outcome::Interval(x, EXACT);
    let basic = |x| Outcome::Interval(x, BASIC);
    let elementary = |x| Outcome::Interval(x, ELEMENTARY);
    let yes = |b| Equal(vec![Bool(b)]);
    let number = |x: f64| Equal(vec![Number(x)]);
    match (assertion.operation.as_str(), assertion.arguments.as_slice()) {
        ("pos", [I(x)]) => exact(*x),
        ("neg", [I(x)]) => exact(-*x),
        ("add", [I(x), I(y)]) => basic(*x + *y),
        ("sub", [I(x), I(y)]) => basic(*x - *y),
        ("mul", [I(x), I(y)]) => basic(*x * *y),
        ("div", [I(x), I(y)]) => basic(*x / *y),
        ("recip", [I(x)]) => basic(x.recip()),
        ("sqr", [I(x)]) => basic(x.sqr()),
        ("sqrt", [I(x)]) => basic(x.sqrt()),
        // Two roundings: reported, contained like the rest.
        ("fma", [I(x), I(y), I(z)]) => Outcome::Interval(*x * *y + *z, REPORTED),
        ("pown", [I(x), Number(n)]) => {
            Outcome::Interval(x.powi(*n as i32), if n.abs() <= 8.0 { ELEMENTARY } else { REPORTED })
        }
        ("exp", [I(x)]) => elementary(x.exp()),
        ("log", [I(x)]) => elementary(x.ln()),
        ("sin", [I(x)]) => elementary(x.sin()),
        ("cos", [I(x)]) => elementary(x.cos()),
        ("tan", [I(x)]) => elementary(x.tan()),
        ("asin", [I(x)]) => elementary(x.asin()),
        ("acos", [I(x)]) => elementary(x.acos()),
        ("atan", [I(x)]) => elementary(x.atan()),
        ("atan2", [I(y), I(x)]) => elementary(y.atan2(*x)),
        ("sinh", [I(x)]) => elementary(x.sinh()),
        ("cosh", [I(x)]) => elementary(x.cosh()),
        ("tanh", [I(x)]) => elementary(x.tanh()),
        ("abs", [I(x)]) => exact(x.abs()),
        ("min", [I(x), I(y)]) => exact(x.min(*y)),
        ("max", [I(x), I(y)]) => exact(x.max(*y)),
        ("intersection", [I(x), I(y)]) => exact(x.intersection(*y)),
        ("convexHull", [I(x), I(y)]) => exact(x.hull(*y)),
        ("b-numsToInterval", [Number(lo), Number(hi)]) => exact(Interval::new(*lo, *hi).unwrap_or(Interval::EMPTY)),
        ("b-textToInterval", [Text(text)]) => match text.parse() {
            Ok(x) => Outcome::Interval(x, REPORTED),
            Err(_) if assertion.signal.is_some() => exact(Interval::EMPTY),
            Err(error) => panic!("{}: {error}", assertion.source),
        },
        ("inf", [I(x)]) => number(if x.is_empty() { f64::INFINITY } else { x.lo() }),
        ("sup", [I(x)]) => number(if x.is_empty() { f64::NEG_INFINITY } else { x.hi() }),
        ("mid", [I(x)]) => number(x.mid()),
        ("rad", [I(x)]) => number(x.rad()),
        ("midRad", [I(x)]) => Equal(vec![Number(x.mid()), Number(x.rad())]),
        ("wid", [I(x)]) => number(x.width()),
        ("mag", [I(x)]) => number(x.mag()),
        ("mig", [I(x)]) => number(x.mig()),
        ("isMember", [Number(x), I(y)]) => yes(y.contains(*x)),
        ("isEmpty", [I(x)]) => yes(x.is_empty()),
        ("isEntire", [I(x)]) => yes(*x == Interval::ENTIRE),
        ("isCommonInterval", [I(x)]) => yes(x.is_bounded()),
        ("isSingleton", [I(x)]) => yes(x.lo() == x.hi()),
        ("equal", [I(x), I(y)]) => yes(x == y),
        ("subset", [I(x), I(y)]) => yes(x.subset_of(y)),
        ("interior", [I(x), I(y)]) => yes(x.interior_of(y)),
        ("disjoint", [I(x), I(y)]) => yes(x.disjoint(y)),
        _ => NotImplemented,
    }
}

/// Decorated intervals and NaI are another flavour of the standard.
fn is_bare(assertion: &Assertion) -> bool {
    let decorated = |v: &Value| matches!(v, Value::Other(t) if t.starts_with("[nai]") || t.contains("]_"));
    let name = assertion.operation.as_str();
    !(name.starts_with("d-") || assertion.arguments.iter().chain(&assertion.results).any(decorated))
}

/// Floats from one bound to another.
fn distance(a: f64, b: f64) -> u32 {
    let position = |x: f64| {
        let magnitude = (x.to_bits() & !(1 << 63)) as i64;
        if x.is_sign_negative() { -magnitude } else { magnitude }
    };
    u32::try_from(position(a).abs_diff(position(b))).unwrap_or(u32::MAX)
}

fn same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => a == b || (a.is_nan() && b.is_nan()),
        _ => a == b,
    }
}

#[derive(Default)]
struct Tally {
    count: u32,
    worst: u32,
}

fn files() -> Option<Vec<PathBuf>> {
    let folder = PathBuf::from(std::env::var_os("ORBITOPE_DATA")?).join("itf1788");
    let mut files: Vec<_> = std::fs::read_dir(folder).ok()?.filter_map(|entry| Some(entry.ok()?.path())).collect();
    files.retain(|path| path.extension().is_some_and(|e| e == "itl"));
    files.sort();
    (!files.is_empty()).then_some(files)
}

#[test]
fn every_implemented_bare_assertion_is_contained() {
    let Some(files) = files() else {
        println!(
            "skipped: set ORBITOPE_DATA to a folder with itf1788/*.itl (directory itl of github.com/oheim/ITF1788)"
        );
        return;
    };
    let mut implemented: BTreeMap<String, Tally> = BTreeMap::new();
    let mut missing: BTreeMap<String, u32> = BTreeMap::new();
    let (mut total, mut decorated) = (0_u32, 0_u32);
    let mut failures = Vec::new();
    for assertion in files.iter().flat_map(|path| assertions(&std::fs::read_to_string(path).unwrap())) {
        total += 1;
        if !is_bare(&assertion) {
            decorated += 1;
            continue;
        }
        let outcome = run(&assertion);
        if matches!(outcome, Outcome::NotImplemented) {
            *missing.entry(assertion.operation).or_default() += 1;
            continue;
        }
        let tally = implemented.entry(assertion.operation.clone()).or_default();
        tally.count += 1;
        match (outcome, assertion.results.as_slice()) {
            (Outcome::Interval(ours, budget), [Value::Interval(tightest)]) => {
                let off = if ours.is_empty() || tightest.is_empty() {
                    if ours == *tightest { 0 } else { u32::MAX }
                } else {
                    distance(ours.lo(), tightest.lo()).max(distance(ours.hi(), tightest.hi()))
                };
                tally.worst = tally.worst.max(off);
                if !tightest.subset_of(&ours) || off > budget {
                    failures.push(format!("{}: ours is {ours:?}, {off} floats off", assertion.source));
                }
            }
            (Outcome::Equal(ours), expected) => {
                if ours.len() != expected.len() || !ours.iter().zip(expected).all(|(a, b)| same(a, b)) {
                    failures.push(format!("{}: ours is {ours:?}", assertion.source));
                }
            }
            _ => failures.push(format!("{}: unexpected kind of result", assertion.source)),
        }
    }
    let contained: u32 = implemented.values().map(|t| t.count).sum();
    println!("operation: assertions contained, floats per bound from the tightest at worst");
    for (name, tally) in &implemented {
        println!("  {name}: {}, {}", tally.count, tally.worst);
    }
    println!(
        "contained: {} of {contained} assertions on {} operations",
        contained - failures.len() as u32,
        implemented.len()
    );
    println!("not implemented: {} assertions: {missing:?}", missing.values().sum::<u32>());
    println!("decorated or NaI: {decorated}; all assertions: {total}");
    assert_eq!(contained + missing.values().sum::<u32>() + decorated, total);
    assert!(contained > 1500, "the vectors were not found or not read");
    assert!(failures.is_empty(), "{} failures:\n{}", failures.len(), failures.join("\n"));
}

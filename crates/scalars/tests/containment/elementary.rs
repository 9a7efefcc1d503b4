//! Elementary functions of points and boxes against fixed-point arithmetic of at least 200 significant bits.

use num_bigint::BigInt;
use scalars::Interval;

use crate::support::cases;
use crate::support::oracle::Fixed;
use crate::support::random::Random;

const POINTS: usize = 10_000;

/// A function with its oracle and its hard arguments.
struct Function {
    name: &'static str,
    interval: fn(Interval) -> Interval,
    exact: fn(Fixed, f64) -> BigInt,
    argument: fn(&mut Random) -> f64,
    /// A number of the size of the result, from which the precision follows.
    size: fn(f64) -> f64,
}

fn any(random: &mut Random) -> f64 {
    match random.below(4) {
        0 => random.uniform(-20.0, 20.0),
        1 => random.log_uniform(-1074.0, 0.0),
        2 => random.log_uniform(-40.0, 30.0),
        _ => random.sign() * random.below(1 << 20) as f64,
    }
}

/// Also floats next to multiples of a quarter turn, and arguments up to the largest.
fn angle(random: &mut Random) -> f64 {
    match random.below(4) {
        0 | 1 => any(random),
        2 => {
            let exponent = random.below(31);
            let quarter_turns = random.below(1 << exponent) as f64;
            let near = quarter_turns * std::f64::consts::FRAC_PI_2;
            let steps = random.below(7);
            random.sign() * (0..steps).fold(near.next_down().next_down().next_down(), |x, _| x.next_up())
        }
        _ => random.log_uniform(30.0, 1023.9),
    }
}

fn moderate(random: &mut Random) -> f64 {
    match random.below(3) {
        0 => random.uniform(-745.0, 709.7),
        1 => random.log_uniform(-1074.0, 0.0),
        _ => random.log_uniform(-10.0, 9.4),
    }
}

fn positive(random: &mut Random) -> f64 {
    match random.below(3) {
        0 => random.log_uniform(-1074.0, 1023.9).abs().max(f64::from_bits(1)),
        1 => 1.0 + random.log_uniform(-52.0, -1.0),
        _ => random.uniform(0.1, 10.0),
    }
}

fn unit(random: &mut Random) -> f64 {
    match random.below(4) {
        0 => random.uniform(-1.0, 1.0),
        1 => random.log_uniform(-1074.0, 0.0),
        2 => random.sign() * (1.0 - random.log_uniform(-53.0, -1.0).abs()),
        _ => random.sign() * (random.below(3) as f64 / 2.0),
    }
}

const FUNCTIONS: &[Function] = &[
    Function {
        name: "exp",
        interval: Interval::exp,
        exact: |p, x| p.exp(&p.float(x)),
        argument: moderate,
        size: f64::exp,
    },
    Function { name: "ln", interval: Interval::ln, exact: Fixed::ln, argument: positive, size: |_| 1e-17 },
    Function { name: "sin", interval: Interval::sin, exact: |p, x| p.sin_cos(x).0, argument: angle, size: tiny },
    Function { name: "cos", interval: Interval::cos, exact: |p, x| p.sin_cos(x).1, argument: angle, size: |_| 1e-30 },
    Function { name: "tan", interval: Interval::tan, exact: Fixed::tan, argument: angle, size: tiny },
    Function { name: "asin", interval: Interval::asin, exact: Fixed::asin, argument: unit, size: tiny },
    Function { name: "acos", interval: Interval::acos, exact: Fixed::acos, argument: unit, size: |_| 1e-8 },
    Function { name: "atan", interval: Interval::atan, exact: |p, x| p.atan(&p.float(x)), argument: any, size: tiny },
    Function {
        name: "sinh",
        interval: Interval::sinh,
        exact: |p, x| p.sinh_cosh(&p.float(x)).0,
        argument: moderate,
        size: tiny,
    },
    Function {
        name: "cosh",
        interval: Interval::cosh,
        exact: |p, x| p.sinh_cosh(&p.float(x)).1,
        argument: moderate,
        size: |_| 1.0,
    },
    Function {
        name: "tanh",
        interval: Interval::tanh,
        exact: |p, x| p.tanh(&p.float(x)),
        argument: moderate,
        size: tiny,
    },
];

/// Of the size of a function with `f(x) ~ x`, with room for values near multiples of pi.
fn tiny(x: f64) -> f64 {
    x.abs().min(1e-30)
}

/// Values at points lie inside, and the bounds are at most four floats from the tightest.
#[test]
fn points_are_enclosed_tightly() {
    for function in FUNCTIONS {
        let mut random = Random::new(function.name, 11);
        let mut worst = 0;
        for _ in 0..cases(POINTS) {
            let x = (function.argument)(&mut random);
            let result = (function.interval)(Interval::point(x));
            let precision = Fixed::for_size((function.size)(x));
            let exact = precision.enclose(&(function.exact)(precision, x));
            assert!(exact.may_lie_in(result), "{}({x:e}) = {result:?} misses", function.name);
            worst = worst.max(exact.excess_of(result));
        }
        println!("{}: at most {worst} floats from the tightest bound", function.name);
        assert!(worst <= 4, "{}: {worst} floats from the tightest bound", function.name);
    }
}

/// The angle of points in all quadrants, on the axes, and of very unequal coordinates.
#[test]
fn angles_of_points_are_enclosed_tightly() {
    let mut random = Random::new("atan2", 12);
    let mut worst = 0;
    for _ in 0..cases(POINTS) {
        let (y, x) = match random.below(4) {
            0 => (random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)),
            1 => (random.log_uniform(-500.0, 500.0), random.log_uniform(-500.0, 500.0)),
            2 => (random.log_uniform(-60.0, 0.0), random.sign()),
            _ => (random.sign(), random.log_uniform(-60.0, 0.0)),
        };
        let result = Interval::point(y).atan2(Interval::point(x));
        let precision = Fixed::for_size((y / x).abs().min(1.0));
        let exact = precision.enclose(&precision.atan2(y, x));
        assert!(exact.may_lie_in(result), "atan2({y:e}, {x:e}) = {result:?} misses");
        worst = worst.max(exact.excess_of(result));
    }
    println!("atan2: at most {worst} floats from the tightest bound");
    assert!(worst <= 4, "atan2: {worst} floats from the tightest bound");
}

/// Values at random members of boxes lie in the range of the box.
#[test]
fn ranges_enclose_values_of_members() {
    for function in FUNCTIONS {
        let mut random = Random::new(function.name, 13);
        for _ in 0..cases(POINTS) {
            let (a, b) = ((function.argument)(&mut random), (function.argument)(&mut random));
            let b = if random.below(2) == 0 { a + random.uniform(0.0, 8.0) } else { b };
            let domain = Interval::new(a.min(b), a.max(b)).unwrap();
            let domain = if matches!(function.name, "asin" | "acos") {
                domain.intersection(Interval::new(-1.0, 1.0).unwrap())
            } else {
                domain
            };
            let range = (function.interval)(domain);
            // A member halfway in value, not in the order of the floats, finds inner extrema and poles.
            let x = random.uniform(domain.lo(), domain.hi()).clamp(domain.lo(), domain.hi());
            if (function.interval)(Interval::point(x)).is_bounded() {
                let value = (function.interval)(Interval::point(x));
                let inner = value.mid();
                assert!(
                    value.subset_of(&range) || range.contains(inner),
                    "{} {domain:?} = {range:?} misses {value:?} at {x:e}",
                    function.name
                );
            }
        }
    }
}

/// Extrema inside the box are found and none is invented: sine and cosine over boxes between known extrema.
#[test]
fn sine_and_cosine_know_their_extrema() {
    let quarter = std::f64::consts::FRAC_PI_2;
    for first in -40..40_i32 {
        for quarters in 1..5_i32 {
            // From just after one quarter-turn point to just before another: the extrema strictly between are inside.
            let domain =
                Interval::new(f64::from(first) * quarter + 0.01, f64::from(first + quarters) * quarter - 0.01).unwrap();
            let (sin, cos) = domain.sin_cos();
            let inside = |residue: i32| (first + 1..first + quarters).any(|q| q.rem_euclid(4) == residue);
            assert_eq!((sin.hi() == 1.0, sin.lo() == -1.0), (inside(1), inside(3)), "sin {domain:?} = {sin:?}");
            assert_eq!((cos.hi() == 1.0, cos.lo() == -1.0), (inside(0), inside(2)), "cos {domain:?} = {cos:?}");
            let pole = inside(1) || inside(3);
            assert_eq!(domain.tan() == Interval::ENTIRE, pole, "tan {domain:?}");
        }
    }
}

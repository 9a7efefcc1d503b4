//! Enclosures of value, Jacobian and Hessians against the point values of `num-dual`.

use nonlin_bounds::{DynFunction, Function, Jet, Order};
use num_dual::{DualNum, HyperDual64};
use num_traits::{One, Zero};
use scalars::{Interval, Scalar};

use crate::common::functions::{Domain, Visitor, each};
use crate::common::random::{Random, cases};

/// A hyper-dual number of `num-dual` as a scalar of ours.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Peer(HyperDual64);

macro_rules! operators {
    ($($trait:ident $method:ident $assign:ident $assign_method:ident $op:tt),*) => {$(
        impl std::ops::$trait for Peer {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(self.0 $op other.0)
            }
        }
        impl std::ops::$assign for Peer {
            fn $assign_method(&mut self, other: Self) {
                self.0 = self.0 $op other.0;
            }
        }
    )*};
}
operators!(Add add AddAssign add_assign +, Sub sub SubAssign sub_assign -, Mul mul MulAssign mul_assign *, Div div DivAssign div_assign /);

impl std::ops::Neg for Peer {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Zero for Peer {
    fn zero() -> Self {
        Self(HyperDual64::from(0.0))
    }
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl One for Peer {
    fn one() -> Self {
        Self(HyperDual64::from(1.0))
    }
}

macro_rules! forward {
    ($($method:ident),*) => {$(
        fn $method(self) -> Self {
            Self(DualNum::$method(&self.0))
        }
    )*};
}

impl Scalar for Peer {
    fn from_f64(x: f64) -> Self {
        Self(HyperDual64::from(x))
    }
    fn lit(lo: f64, hi: f64) -> Self {
        Self::from_f64(f64::lit(lo, hi))
    }
    fn ratio(p: i64, q: i64) -> Self {
        Self::from_f64(f64::ratio(p, q))
    }
    fn decimal(text: &str) -> Self {
        Self::from_f64(f64::decimal(text))
    }
    fn pi() -> Self {
        Self::from_f64(f64::pi())
    }
    fn scale(self, k: f64) -> Self {
        Self(self.0 * k)
    }
    fn add_f64(self, k: f64) -> Self {
        Self(self.0 + k)
    }
    fn sqr(self) -> Self {
        self * self
    }
    forward!(recip, sqrt, exp, ln, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh);
    fn powi(self, n: i32) -> Self {
        Self(DualNum::powi(&self.0, n))
    }
    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }
    fn atan2(self, x: Self) -> Self {
        // The peer takes the arctangent of y / x: on the far side of the diagonal that of x / y is the accurate one.
        if self.0.re.abs() <= x.0.re.abs() {
            return Self(self.0.atan2(x.0));
        }
        let quarter = Self::from_f64(std::f64::consts::FRAC_PI_2.copysign(self.0.re));
        quarter - (x / self).atan()
    }
    fn abs(self) -> Self {
        if self.0.re < 0.0 { -self } else { self }
    }
    fn sign(self) -> Self {
        Self::from_f64(self.0.re.signum())
    }
    fn min(self, other: Self) -> Self {
        if self.0.re < other.0.re { self } else { other }
    }
    fn max(self, other: Self) -> Self {
        if self.0.re < other.0.re { other } else { self }
    }
    fn stumpff(self, k: usize) -> Self {
        // The series, to rounding for the arguments of the examples.
        let mut term = (1..=k).fold(Self::one(), |term, i| term.scale(1.0 / i as f64));
        let mut sum = term;
        for j in 1..40 {
            term = -term * self.scale(1.0 / ((2 * j + k - 1) * (2 * j + k)) as f64);
            sum += term;
        }
        sum
    }
}

/// Boxes and points of each function, and how many boxes were tight enough to find a wrong derivative.
struct Compare {
    points: usize,
    jet: Jet,
    tight: usize,
}

impl Visitor for Compare {
    fn visit<F: Function + 'static>(&mut self, function: F, domain: Domain) {
        const SEED: u64 = 0x0d_0a_15;
        let (n, m) = (Function::variables(&function), Function::outputs(&function));
        let boxes = self.points.div_ceil(10);
        let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p)).collect();
        let constants: Vec<Peer> = domain.parameters.iter().map(|&p| Peer::from_f64(p)).collect();
        let mut y = vec![Peer::zero(); m];
        for case in 0..boxes {
            let mut random = Random::new(SEED, case);
            let cube = random.subbox(&domain.center, &domain.radius);
            function.enclose(Order::Hessian, &cube, &p, &mut self.jet).unwrap();
            let jet = &self.jet;
            let check = |what: &str, output: usize, range: Interval, value: f64| {
                // The peer rounds: its value stands for its neighbourhood.
                let about = Interval::point(value).inflate(1e-12 * (1.0 + value.abs()));
                assert!(
                    !about.disjoint(&range),
                    "{} {what} {output}: {value} outside {range:?}, seed {SEED:#x}, case {case}",
                    domain.name
                );
            };
            self.tight += usize::from(jet.hessians().iter().all(|h| h.width() <= 1e-6 * (1.0 + h.mag())));
            for _ in 0..10 {
                let at = random.point(&cube);
                // One pair of directions a point, the diagonal now and then: a pass of the peer gives the second derivative by both.
                let (i, j) = (random.below(n), random.below(n));
                let x: Vec<Peer> = at
                    .iter()
                    .enumerate()
                    .map(|(k, &x)| {
                        let seed = |index| f64::from(u8::from(k == index));
                        Peer(HyperDual64::new(x, seed(i), seed(j), 0.0))
                    })
                    .collect();
                function.eval(&x, &constants, &mut y);
                for (output, Peer(y)) in y.iter().enumerate() {
                    let (row, column) = (i.min(j), i.max(j));
                    let entry = row * (2 * n - row + 1) / 2 + column - row;
                    check("value", output, jet.values()[output], y.re);
                    check("first", output, jet.jacobian()[output * n + i], y.eps1);
                    check("first", output, jet.jacobian()[output * n + j], y.eps2);
                    check("second", output, jet.hessians()[output * n * (n + 1) / 2 + entry], y.eps1eps2);
                }
            }
        }
    }
}

/// 1e4 random points of 1e3 random boxes for each function: value, both first derivatives, the second one.
#[test]
fn contain_the_values_of_num_dual() {
    let mut compare = Compare { points: cases(10_000), jet: Jet::new(), tight: 0 };
    each(&mut compare);
    assert!(compare.tight > compare.points / 10, "the boxes are too wide to find errors: {}", compare.tight);
}

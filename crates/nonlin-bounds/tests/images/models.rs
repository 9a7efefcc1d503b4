//! The twelve functions on random constrained zonotopes, by interval evaluation of exact points: a violation is a proof.

use nonlin_bounds::{
    AffineEnclosure, Copies, Domain, DynFunction, Form, Function, Jet, Order, QuadraticEnclosure, Workspace,
};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Zonotope};

use crate::SEED;
use crate::common::functions::{self, Visitor, each};
use crate::sets::random::{Random, cases};

/// A set in `center +- radius` with the coordinates of some members.
fn draw(random: &mut Random, domain: &functions::Domain, size: f64) -> (ConstrainedZonotope, Vec<Vec<f64>>) {
    let n = domain.center.len();
    let (m, rows) = (n + random.below(3), random.below(3));
    let center: Vec<f64> =
        domain.center.iter().zip(&domain.radius).map(|(c, r)| c + 0.5 * random.moderate() * r).collect();
    let mut g = Matrix::zeros(n, m);
    for j in 0..m {
        for k in 0..n {
            g[(k, j)] = 0.5 * size * domain.radius[k] * random.moderate() / m as f64;
        }
    }
    let body = Zonotope::new(&center, &g).unwrap();
    let members: Vec<Vec<f64>> = (0..3).map(|_| random.cube(m)).collect();
    let mut a = Matrix::zeros(rows, m);
    a.as_mut_slice().iter_mut().for_each(|x| *x = random.moderate());
    let range = |i: usize| members.iter().fold(Interval::EMPTY, |range, xi| range.hull(row(&a, i, xi)));
    let ranges: Vec<Interval> = (0..rows).map(range).collect();
    (ConstrainedZonotope::with_constraints(&body, &a, &ranges).unwrap(), members)
}

/// Row `i` of `M xi`.
fn row(matrix: &Matrix, i: usize, xi: &[f64]) -> Interval {
    matrix.columns().zip(xi).fold(Interval::ZERO, |sum, (column, &t)| sum + Interval::point(column[i]).scale(t))
}

/// `c + G xi`.
fn point(set: &Zonotope, xi: &[f64]) -> Vec<Interval> {
    (0..set.dim()).map(|k| row(set.generators(), k, xi).add_f64(set.center()[k])).collect()
}

/// Panics unless the coordinates may be those of `x` in the set: `|x - c - G xi| <= r` and `A xi in [b]` are not refuted.
fn check(set: &ConstrainedZonotope, xi: &[f64], x: &[Interval], context: &dyn Fn() -> String) {
    assert_eq!(set.num_generators(), xi.len(), "{}", context());
    for (k, near) in point(set.unconstrained(), xi).iter().enumerate() {
        let distance = (x[k] - *near).mig();
        assert!(distance <= set.remainder()[k], "output {k} is {distance} off: {}", context());
    }
    for (i, range) in set.ranges().iter().enumerate() {
        assert!(!row(set.constraints(), i, xi).disjoint(range), "constraint {i}: {}", context());
    }
}

#[derive(Default)]
struct Battery {
    triples: usize,
}

impl Visitor for Battery {
    fn visit<F: Function + 'static>(&mut self, f: F, domain: functions::Domain) {
        let (mut w, mut enclosure, mut jet) = (Workspace::new(), AffineEnclosure::new(), Jet::new());
        let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p)).collect();
        for case in 0..cases(if domain.center.len() > 8 { 20 } else { 80 }) {
            let mut random = Random::new(SEED + 7, case);
            let size = 10f64.powf(-8.0 * random.unit().abs());
            let (set, members) = draw(&mut random, &domain, size);
            let hull = set.interval_hull(&mut w.sets).unwrap();
            let at: Vec<f64> =
                hull.iter().map(|side| side.mid() + 0.5 * side.rad() * f64::from(case as u32 % 3)).collect();
            let noises = random.below(hull.len());
            let place = Domain::new(&hull, &at).with_parameters(&p).with_noises(noises);
            let context = |what: &str| format!("{} {what}, seed {SEED}+7 case {case}, size {size}", domain.name);
            for form in [Form::Natural, Form::MeanValue, Form::Slope, Form::Taylor] {
                enclosure.enclose(form, &f, &place, &mut w).unwrap();
                let image = enclosure.image(&set, &mut w).unwrap();
                let plain = enclosure.image(set.unconstrained(), &mut w).unwrap();
                assert_eq!(image.unconstrained(), &plain);
                for xi in &members {
                    let x = point(set.unconstrained(), xi);
                    f.enclose(Order::Value, &x, &p, &mut jet).unwrap();
                    check(&image, xi, jet.values(), &|| context(&format!("{form:?} image")));
                    let mut cut = set.clone();
                    enclosure.intersect(&mut cut, jet.values(), &mut w).unwrap();
                    check(&cut, xi, &x, &|| context(&format!("{form:?} solution")));
                    self.triples += 2;
                }
            }
            if domain.center.len() > 4 {
                continue;
            }
            let quadratic = QuadraticEnclosure::new(&f, &set, &place, Copies::Shared, &mut w).unwrap();
            let image = quadratic.image(&set, &mut w).unwrap();
            for xi in &members {
                let mut tail: Vec<f64> = xi.iter().map(|t| 2.0 * t * t - 1.0).collect();
                for a in 0..xi.len() {
                    tail.extend((a + 1..xi.len()).map(|b| xi[a] * xi[b]));
                }
                if quadratic.curvature().num_generators() == tail.len() && xi.iter().all(|t| t.abs() == 1.0) {
                    // At a vertex the products are exact.
                    f.enclose(Order::Value, &point(set.unconstrained(), xi), &p, &mut jet).unwrap();
                    check(&image, &[&xi[..], &tail].concat(), jet.values(), &|| context("quadratic image"));
                    self.triples += 1;
                }
            }
        }
    }
}

#[test]
fn the_twelve_functions_are_enclosed() {
    let mut battery = Battery::default();
    each(&mut battery);
    assert!(battery.triples >= 20_000, "{}", battery.triples);
}

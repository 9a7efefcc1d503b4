//! Laws of the set operations, one line a law: supports add, map and scale; hulls are supports along the axes.

// A failed `unwrap` is a failed test, in helpers as in tests.
#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod set_laws;
mod support_functions;

use common::random::{Random, cases};
use scalars::Interval;
use setrep::{IntervalMatrix, Matrix, Membership, Workspace, Zonotope};

const SEED: u64 = 7;

/// Two sets, a map and a direction of one dimension; moderate entries, so that tolerances mean something.
struct Draw {
    x: Zonotope,
    y: Zonotope,
    map: Matrix,
    direction: Vec<f64>,
    point: Vec<f64>,
}

fn moderate(random: &mut Random, n: usize) -> Zonotope {
    let m = random.between(0, 9);
    let data: Vec<f64> = (0..n * m).map(|_| random.moderate()).collect();
    let center: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
    let remainder: Vec<f64> =
        (0..n).map(|_| if random.below(2) == 0 { 0.0 } else { random.moderate().abs() }).collect();
    Zonotope::with_remainder(&center, &Matrix::from_column_slice(n, m, &data).unwrap(), &remainder).unwrap()
}

fn for_each_draw(law: impl Fn(&Draw) -> Result<(), String>) {
    for case in 0..cases(400) {
        let mut random = Random::new(SEED, case);
        let n = random.between(1, 6);
        let (x, y) = (moderate(&mut random, n), moderate(&mut random, n));
        let entries: Vec<f64> = (0..n * n).map(|_| random.moderate()).collect();
        let map = Matrix::from_column_slice(n, n, &entries).unwrap();
        let direction: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        let point: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
        if let Err(violation) = law(&Draw { x, y, map, direction, point }) {
            panic!("seed {SEED} case {case}: {violation}");
        }
    }
}

fn close(what: &str, a: f64, b: f64) -> Result<(), String> {
    if (a - b).abs() <= 1e-12 * (1.0 + a.abs() + b.abs()) { Ok(()) } else { Err(format!("{what}: {a} against {b}")) }
}

/// The two sets agree: equal supports along the axes, the diagonals and a random direction.
fn same_set(what: &str, a: &Zonotope, b: &Zonotope, direction: &[f64]) -> Result<(), String> {
    let n = a.dim();
    let mut directions = vec![direction.to_vec(), vec![1.0; n]];
    for k in 0..n {
        let mut axis = vec![0.0; n];
        axis[k] = 1.0;
        directions.push(axis.clone());
        axis[k] = -1.0;
        directions.push(axis);
    }
    directions.iter().try_for_each(|d| close(what, a.support(d).unwrap(), b.support(d).unwrap()))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn mapped(map: &Matrix, x: &[f64]) -> Vec<f64> {
    (0..map.rows()).map(|i| (0..map.cols()).map(|k| map[(i, k)] * x[k]).sum()).collect()
}

macro_rules! laws {
    ($($(#[$doc:meta])* $name:ident: |$draw:ident| $law:expr;)*) => {
        $($(#[$doc])* #[test] fn $name() { for_each_draw(|$draw| $law); })*
    };
}

laws! {
    sum_is_commutative: |d| same_set("x + y", &d.x.minkowski_sum(&d.y).unwrap(), &d.y.minkowski_sum(&d.x).unwrap(), &d.direction);
    sum_is_associative: |d| {
        let z = d.x.linear_map(&d.map).unwrap();
        let left = d.x.minkowski_sum(&d.y).unwrap().minkowski_sum(&z).unwrap();
        let right = d.x.minkowski_sum(&d.y.minkowski_sum(&z).unwrap()).unwrap();
        same_set("(x + y) + z", &left, &right, &d.direction)
    };
    origin_is_neutral: |d| {
        let sum = d.x.minkowski_sum(&Zonotope::point(&vec![0.0; d.x.dim()]).unwrap()).unwrap();
        if sum == d.x { Ok(()) } else { Err(format!("{sum:?}")) }
    };
    supports_add: |d| {
        let h = d.x.minkowski_sum(&d.y).unwrap().support(&d.direction).unwrap();
        close("h(x + y)", h, d.x.support(&d.direction).unwrap() + d.y.support(&d.direction).unwrap())
    };
    support_of_an_image: |d| {
        let h = d.x.linear_map(&d.map).unwrap().support(&d.direction).unwrap();
        close("h(R x)", h, d.x.support(&mapped(&d.map.transpose(), &d.direction)).unwrap())
    };
    support_of_a_multiple: |d| {
        let mut scaled = d.x.clone();
        scaled.scale(-2.5).unwrap();
        let opposite: Vec<f64> = d.direction.iter().map(|x| -x).collect();
        close("h(-2.5 x)", scaled.support(&d.direction).unwrap(), 2.5 * d.x.support(&opposite).unwrap())
    };
    support_of_a_translate: |d| {
        let mut moved = d.x.clone();
        moved.translate(&d.point).unwrap();
        close("h(x + t)", moved.support(&d.direction).unwrap(), d.x.support(&d.direction).unwrap() + dot(&d.direction, &d.point))
    };
    support_of_a_product: |d| {
        let both = [d.direction.clone(), d.point.clone()].concat();
        let h = d.x.cartesian_product(&d.y).support(&both).unwrap();
        close("h(x, y)", h, d.x.support(&d.direction).unwrap() + d.y.support(&d.point).unwrap())
    };
    hull_is_the_support_along_the_axes: |d| {
        let hull = d.x.interval_hull();
        (0..d.x.dim()).try_for_each(|k| {
            let mut axis = vec![0.0; d.x.dim()];
            axis[k] = 1.0;
            close("upper", hull[k].hi(), d.x.support(&axis).unwrap())?;
            axis[k] = -1.0;
            close("lower", -hull[k].lo(), d.x.support(&axis).unwrap())
        })
    };
    maps_compose: |d| {
        let twice = d.x.linear_map(&d.map).unwrap().linear_map(&d.map).unwrap();
        let square = IntervalMatrix::point(d.map.clone()).unwrap();
        let at_once = d.x.linear_map(square.mul(&square).unwrap().mid()).unwrap();
        same_set("R R x", &twice, &at_once, &d.direction)
    };
    in_place_equals_by_value: |d| {
        let mut workspace = Workspace::new();
        let mut inner = d.y.clone();
        inner.linear_map_in_place(&d.map, &mut workspace).unwrap();
        if inner == d.y.linear_map(&d.map).unwrap() { Ok(()) } else { Err(format!("{inner:?}")) }
    };
    point_interval_map_is_the_linear_map: |d| {
        let map = IntervalMatrix::point(d.map.clone()).unwrap();
        same_set("[R, R] x", &d.x.interval_map(&map).unwrap(), &d.x.linear_map(&d.map).unwrap(), &d.direction)
    };
    materializing_keeps_the_set: |d| {
        let mut whole = d.x.clone();
        whole.materialize();
        same_set("materialized", &whole, &d.x, &d.direction)
    };
    the_center_is_a_member: |d| {
        let center: Vec<Interval> = d.x.center().iter().map(|&c| Interval::point(c)).collect();
        match d.x.membership(&center).unwrap() {
            Membership::ProvenOutside => Err("center proven outside".into()),
            _ => Ok(()),
        }
    };
    the_gauge_is_one_at_a_support_point: |d| {
        // The support point has coordinates sign(d'g_j); it lies on the boundary.
        let mut x = d.x.center().to_vec();
        for g in d.x.generators().columns() {
            let sign = dot(g, &d.direction).signum();
            x.iter_mut().zip(g).for_each(|(x, g)| *x += sign * g);
        }
        x.iter_mut().zip(d.x.remainder()).zip(&d.direction).for_each(|((x, r), t)| *x += r * t.signum());
        if d.x.radius() == 0.0 { return Ok(()); }
        let gauge = d.x.gauge_approx(&x).unwrap();
        if (gauge - 1.0).abs() < 1e-6 { Ok(()) } else { Err(format!("gauge {gauge}")) }
    };
    volume_scales_with_the_determinant: |d| {
        if d.x.dim() > 3 { return Ok(()); }
        let mut scaled = d.x.clone();
        scaled.scale(2.0).unwrap();
        close("vol(2 x)", scaled.volume().unwrap().mid(), d.x.volume().unwrap().mid() * 2f64.powi(d.x.dim() as i32))
    };
    planar_volume_is_the_area_of_the_vertices: |d| {
        if d.x.dim() != 2 { return Ok(()); }
        let v = d.x.vertices_2d().unwrap();
        let area: f64 = (0..v.len()).map(|i| { let (a, b) = (v[i], v[(i + 1) % v.len()]); 0.5 * (a[0] * b[1] - a[1] * b[0]) }).sum();
        close("area", area, d.x.volume().unwrap().mid())
    };
    covariation_has_the_f_radius_as_trace: |d| {
        let covariation = d.x.covariation();
        let trace: f64 = (0..d.x.dim()).map(|k| covariation[(k, k)]).sum();
        close("trace", trace.sqrt(), d.x.f_radius())
    };
}

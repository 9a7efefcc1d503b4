//! Support functions of every type: the vector attains the value, values of one set in two types agree.

use setrep::{ConstrainedZonotope, HPolytope, IntervalVector, Matrix, SupportFunction, VPolytope, Workspace, Zonotope};

use crate::common::random::{Random, cases};

const SEED: u64 = 11;

/// The box of one draw in every type.
pub(crate) fn boxes(random: &mut Random, n: usize) -> Vec<(&'static str, Box<dyn SupportFunction>)> {
    let center: Vec<f64> = (0..n).map(|_| random.moderate()).collect();
    let radius: Vec<f64> = (0..n).map(|_| random.moderate().abs()).collect();
    let sides = IntervalVector::from_center(&center, &radius).unwrap();
    let zonotope = Zonotope::from_intervals(&sides).unwrap();
    let mut constrained = ConstrainedZonotope::from(zonotope.clone());
    constrained.materialize();
    let mut strips = ConstrainedZonotope::from_box(&vec![0.0; n], &vec![5.0; n]).unwrap();
    strips.intersect_rows(&Matrix::identity(n), &sides, &mut Workspace::new()).unwrap();
    vec![
        ("box", Box::new(sides.clone())),
        ("zonotope", Box::new(zonotope)),
        ("constrained zonotope", Box::new(constrained)),
        ("constrained zonotope of strips", Box::new(strips)),
        ("vertices", Box::new(VPolytope::from_intervals(&sides).unwrap())),
        ("half-spaces", Box::new(HPolytope::from_intervals(&sides).unwrap())),
    ]
}

#[test]
fn every_type_knows_the_support_of_a_box() {
    let mut workspace = Workspace::new();
    for case in 0..cases(200) {
        let mut random = Random::new(SEED, case);
        let n = random.between(1, 5);
        let sets = boxes(&mut random, n);
        let directions = random.matrix(n, 4);
        let mut points = Matrix::zeros(0, 0);
        let first = sets[0].1.support_vectors(&directions, &mut points, &mut workspace).unwrap();
        for (name, set) in &sets {
            let hull = set.interval_hull(&mut workspace).unwrap();
            let values = set.support_vectors(&directions, &mut points, &mut workspace).unwrap();
            for (k, (&value, &expected)) in values.iter().zip(&first).enumerate() {
                let d = directions.col(k);
                let magnitude = 1e-300 + 4.0 * d.iter().map(|d| d.abs()).sum::<f64>();
                let reached: f64 = points.col(k).iter().zip(d).map(|(x, d)| x * d).sum();
                let context = || format!("{name}, seed {SEED} case {case}: {value} against {expected}, {reached}");
                assert!((value - expected).abs() <= 1e-12 * magnitude, "{}", context());
                assert!((value - reached).abs() <= 1e-12 * magnitude, "{}", context());
                assert!(
                    hull.iter().zip(points.col(k)).all(|(side, &x)| side.inflate(1e-12).contains(x)),
                    "{}",
                    context()
                );
            }
        }
    }
}

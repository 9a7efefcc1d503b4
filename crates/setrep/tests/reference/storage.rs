//! Sets read back from JSON are the same to the bit, and broken ones are refused.

use core::fmt::Debug;

use scalars::Interval;
use serde::{Serialize, de::DeserializeOwned};
use setrep::{HPolytope, HalfSpace, IntervalMatrix, Matrix, Strip, VPolytope, Zonotope};

use crate::common::random::Random;

#[test]
fn round_trip_is_bit_exact() {
    for case in 0..200 {
        let mut random = Random::new(6, case);
        let set = random.set(3, 5);
        let text = serde_json::to_string(&set).unwrap();
        assert_eq!(serde_json::from_str::<Zonotope>(&text).unwrap(), set);
        let hull = set.interval_hull();
        assert_eq!(
            serde_json::from_str::<setrep::IntervalVector>(&serde_json::to_string(&hull).unwrap()).unwrap(),
            hull
        );
        let map = IntervalMatrix::new(set.generators().clone(), Matrix::zeros(3, 5)).unwrap();
        assert_eq!(serde_json::from_str::<IntervalMatrix>(&serde_json::to_string(&map).unwrap()).unwrap(), map);
    }
}

fn assert_same_again<T: Serialize + DeserializeOwned + PartialEq + Debug>(set: &T) {
    let text = serde_json::to_string(set).unwrap();
    assert_eq!(serde_json::from_str::<T>(&text).unwrap(), *set, "{text}");
}

#[test]
fn polytopes_strips_and_half_spaces_come_back() {
    for case in 0..200 {
        let mut random = Random::new(7, case);
        let (n, m) = (random.between(1, 4), random.between(1, 6));
        let normals = random.matrix(m, n);
        let offsets: Vec<f64> = (0..m).map(|_| random.wide()).collect();
        let remainder: Vec<f64> = (0..n).map(|_| random.wide().abs()).collect();
        let polytope = HPolytope::new(normals.clone(), &offsets).unwrap();
        assert_same_again(&polytope);
        assert_same_again(&polytope.half_space(0).unwrap());
        assert_same_again(&VPolytope::with_remainder(normals.transpose(), &remainder).unwrap());
        let (lo, hi) = (offsets[0], offsets[0] + random.wide().abs());
        for range in [(lo, hi), (f64::NEG_INFINITY, hi), (lo, f64::INFINITY), (f64::NEG_INFINITY, f64::INFINITY)] {
            assert_same_again(&Strip::new(&remainder, Interval::new(range.0, range.1).unwrap()).unwrap());
        }
    }
}

#[test]
fn broken_polytopes_strips_and_half_spaces_are_refused() {
    let matrix = r#"{"rows":1,"cols":1,"data":[1.0]}"#;
    let refused = |text: &str| {
        serde_json::from_str::<HPolytope>(text).is_err()
            && serde_json::from_str::<VPolytope>(text).is_err()
            && serde_json::from_str::<Strip>(text).is_err()
            && serde_json::from_str::<HalfSpace>(text).is_err()
    };
    for broken in [
        format!(r#"{{"normals":{matrix},"offsets":[]}}"#),
        r#"{"normals":{"rows":1,"cols":0,"data":[]},"offsets":[1.0]}"#.into(),
        format!(r#"{{"vertices":{matrix},"remainder":[-1.0]}}"#),
        format!(r#"{{"vertices":{matrix},"remainder":[0.0,0.0]}}"#),
        r#"{"vertices":{"rows":1,"cols":0,"data":[]},"remainder":[0.0]}"#.into(),
        r#"{"direction":[],"range":[0.0,1.0]}"#.into(),
        r#"{"direction":[1.0],"range":[1.0,0.0]}"#.into(),
        r#"{"direction":[1.0],"range":null}"#.into(),
        r#"{"normal":[],"offset":1.0}"#.into(),
        r#"{"normal":[1.0],"offset":1e999}"#.into(),
    ] {
        assert!(refused(&broken), "{broken}");
    }
}

#[test]
fn invariants_are_checked() {
    for broken in [
        r#"{"center":[0.0],"generators":{"rows":1,"cols":1,"data":[1.0]},"remainder":[-1.0]}"#,
        r#"{"center":[0.0],"generators":{"rows":2,"cols":1,"data":[1.0,1.0]},"remainder":[0.0]}"#,
        r#"{"center":[0.0],"generators":{"rows":1,"cols":2,"data":[1.0]},"remainder":[0.0]}"#,
        r#"{"center":[],"generators":{"rows":0,"cols":0,"data":[]},"remainder":[]}"#,
    ] {
        assert!(serde_json::from_str::<Zonotope>(broken).is_err(), "{broken}");
    }
}

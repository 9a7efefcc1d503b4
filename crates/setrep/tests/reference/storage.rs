//! Sets read back from JSON are the same to the bit, and broken ones are refused.

use setrep::{IntervalMatrix, Matrix, Zonotope};

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

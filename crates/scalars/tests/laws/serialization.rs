//! JSON gives every interval back bit by bit.

use proptest::prelude::*;
use scalars::Interval;

use crate::boxes::{interval, settings};

fn bits(x: Interval) -> (u64, u64) {
    (x.lo().to_bits(), x.hi().to_bits())
}

proptest! {
    #![proptest_config(settings())]

    #[test]
    fn json_round_trip_is_exact(x in interval()) {
        let text = serde_json::to_string(&x).unwrap();
        let back: Interval = serde_json::from_str(&text).unwrap();
        prop_assert_eq!(bits(back), bits(x), "{}", text);
    }
}

#[test]
fn the_form_is_readable_and_checked() {
    let right = Interval::new(-0.0, f64::INFINITY).unwrap();
    assert_eq!(serde_json::to_string(&right).unwrap(), r#"[-0.0,"inf"]"#);
    assert_eq!(serde_json::to_string(&Interval::EMPTY).unwrap(), "null");
    for text in ["[2, 1]", r#"["inf", "inf"]"#, r#"["nan", 1]"#, "[1]", "1"] {
        assert!(serde_json::from_str::<Interval>(text).is_err(), "{text}");
    }
}

//! States through text and back.

use estimators::{Estimator, FilterState, Method, SetFilter};
use serde::{Serialize, de::DeserializeOwned};

fn text<T: Serialize>(value: &T) -> String {
    serde_json::to_string(value).unwrap()
}

/// Runs a filter over outputs and inputs. In the middle its state and options go through text into a new filter, which must go on like
/// the old one: every state after it is the same to the bit (text keeps every bit, the sign of zero included).
pub(crate) fn goes_on_to_the_bit<M: Method>(
    make: impl Fn(M::Options) -> SetFilter<M>,
    options: M::Options,
    run: &[(Vec<f64>, Vec<f64>)],
) where
    M::Set: Serialize + DeserializeOwned,
    M::Memory: Serialize + DeserializeOwned,
    M::Options: Serialize + DeserializeOwned,
{
    let (first, second) = run.split_at(run.len() / 2);
    let mut filter = make(options);
    for (y, u) in first {
        filter.update(y).unwrap();
        filter.predict(u).unwrap();
    }
    let saved = text(filter.state());
    let state: FilterState<M::Set, M::Memory> = serde_json::from_str(&saved).unwrap();
    assert_eq!(text(&state), saved);
    let options: M::Options = serde_json::from_str(&text(filter.options())).unwrap();
    let mut restored = make(options);
    restored.restore(&state).unwrap();
    for (k, (y, u)) in second.iter().enumerate() {
        filter.update(y).unwrap();
        restored.update(y).unwrap();
        assert_eq!(text(restored.state()), text(filter.state()), "update {k}");
        filter.predict(u).unwrap();
        restored.predict(u).unwrap();
        assert_eq!(text(restored.state()), text(filter.state()), "prediction {k}");
    }
    assert_ne!(text(restored.state()), saved);
}

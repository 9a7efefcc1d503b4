//! How option records store the parts that other crates define.

use nonlin_bounds::{Copies, Expansion, Form, ForwardBackward};
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
#[serde(remote = "ForwardBackward")]
pub(crate) struct StoredContraction {
    sweeps: usize,
    least_gain: f64,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "Form")]
pub(crate) enum StoredForm {
    Natural,
    MeanValue,
    Slope,
    Taylor,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "Copies")]
pub(crate) enum StoredCopies {
    Shared,
    Separate,
}

/// The expansion points that need no numbers, under the names they have.
#[expect(clippy::enum_variant_names, reason = "these are the names")]
#[derive(Serialize, Deserialize)]
pub(crate) enum StoredExpansion {
    HullCenter,
    EliminationCenter,
    SetCenter,
}

impl StoredExpansion {
    pub(crate) fn serialize<S: serde::Serializer>(choice: &Expansion<'_>, serializer: S) -> Result<S::Ok, S::Error> {
        let stored = match choice {
            Expansion::HullCenter => Self::HullCenter,
            Expansion::EliminationCenter => Self::EliminationCenter,
            Expansion::SetCenter => Self::SetCenter,
            Expansion::Point(_) => {
                return Err(serde::ser::Error::custom("a point given by reference can not be stored"));
            }
        };
        Serialize::serialize(&stored, serializer)
    }

    pub(crate) fn deserialize<'a, D: serde::Deserializer<'a>>(deserializer: D) -> Result<Expansion<'static>, D::Error> {
        let stored = <Self as Deserialize>::deserialize(deserializer)?;
        Ok(match stored {
            Self::HullCenter => Expansion::HullCenter,
            Self::EliminationCenter => Expansion::EliminationCenter,
            Self::SetCenter => Expansion::SetCenter,
        })
    }
}

#[cfg(test)]
mod tests {
    use setrep::{ConstrainedZonotope, VPolytope, Zonotope, ZonotopeBundle};

    use crate::{
        CombOptions, CzOptions, DCzOptions, DZbOptions, FilterState, LinearOptions, RczOptions, RczState, VhOptions,
        ZfOptions, ZonotopeOptions,
    };

    /// All records of options and all states of filters can be stored.
    #[test]
    fn options_and_states_can_be_stored() {
        fn stored<T: serde::Serialize + serde::de::DeserializeOwned>() {}
        stored::<CzOptions>();
        stored::<ZonotopeOptions>();
        stored::<ZfOptions>();
        stored::<RczOptions>();
        stored::<LinearOptions>();
        stored::<VhOptions>();
        stored::<DCzOptions>();
        stored::<DZbOptions>();
        stored::<CombOptions>();
        stored::<RczState>();
        stored::<FilterState<Zonotope>>();
        stored::<FilterState<ConstrainedZonotope>>();
        stored::<FilterState<VPolytope>>();
        stored::<FilterState<ZonotopeBundle>>();
    }
}

//! [`Case`]: a system with a first set, and the filters for it by their names.

use estimators::{Rcz, RczOptions, System};
use setrep::{Complexity, ConstrainedZonotope, Strip, Zonotope};

use super::Contender;
use crate::Mode;

/// What all filters of a study are given.
#[derive(Debug, Clone)]
pub struct Case {
    /// The model.
    pub system: System,
    /// The first set.
    pub start: Zonotope,
    /// How large the sets of the paper's filters may be.
    pub limit: Complexity,
    /// Strips that hold every state, for the filters named +F.
    pub feasible: Vec<Strip>,
}

impl Case {
    /// The filter of a name: `czmv`, `czfo`, each alone or with `+c`, `+f`, `+fc`; `zmv`, `zfo`, alone or with `+f`; `rcz` and `rcz/cheap`, which
    /// solves no linear programs. None for other names.
    #[must_use]
    pub fn contender(&self, name: &str, mode: Mode) -> Option<Contender> {
        let (family, parts) = name.split_once('+').unwrap_or((name, ""));
        if !["", "c", "f", "fc"].contains(&parts) {
            return None;
        }
        let case = self.clone();
        Some(match family {
            "rcz" | "rcz/cheap" if parts.is_empty() => {
                let n = self.system.states();
                let options = if family == "rcz" { RczOptions::fast(n) } else { RczOptions::cheap(n) };
                Contender::new(name, mode, move |()| {
                    Ok(Box::new(Rcz::new(case.system.clone(), case.constrained(), options)?))
                })
            }
            _ => return None,
        })
    }

    /// The first set as a constrained zonotope.
    fn constrained(&self) -> ConstrainedZonotope {
        self.start.clone().into()
    }
}

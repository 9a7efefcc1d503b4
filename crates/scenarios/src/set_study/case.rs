//! [`Case`]: a system with a first set, and the filters for it by their names.

use estimators::{CzFilter, CzOptions, EstimatorError, Rcz, RczOptions, System, ZonotopeFilter, ZonotopeOptions};
use setrep::{Complexity, ConstrainedZonotope, Strip, Zonotope};

use super::Contender;
use crate::{Mode, ScenarioError};

/// How many candidates filters named `/compared` compare.
pub const CANDIDATES: usize = 4;

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
    /// The filter of a name: `zmv`, `zfo`, `czmv`, `czfo`, each alone or with `+c`, `+f`, `+fc`, the last two also with `/compared` behind it,
    /// for eliminations that compare [`CANDIDATES`]; `rcz`, and `rcz/cheap`, which solves no linear programs. None for other names.
    ///
    /// # Errors
    /// None: a system fits its own noises.
    pub fn contender(&self, name: &str, mode: Mode) -> Result<Option<Contender>, EstimatorError> {
        let (paper, candidates) = name.strip_suffix("/compared").map_or((name, 1), |paper| (paper, CANDIDATES));
        let (family, parts) = paper.split_once('+').unwrap_or((paper, ""));
        if !["", "c", "f", "fc"].contains(&parts) {
            return Ok(None);
        }
        let feasible = if parts.contains('f') { self.feasible.clone() } else { Vec::new() };
        let mut case = self.clone();
        if !family.starts_with("rcz") {
            case.system = with_noise_generators(case.system)?;
        }
        Ok(Some(match family {
            "zmv" | "zfo" if candidates == 1 => {
                let limit = self.limit.generators;
                let options = if family == "zmv" { ZonotopeOptions::zmv(limit) } else { ZonotopeOptions::zfo(limit) };
                let options = ZonotopeOptions { consistency: parts.contains('c'), ..options.with_feasible(feasible) };
                Contender::new(name, mode, move |()| {
                    Ok(Box::new(ZonotopeFilter::new(case.system.clone(), case.start.clone(), options.clone())?))
                })
            }
            "czmv" | "czfo" => {
                let limit = Some(self.limit);
                let options = if family == "czmv" { CzOptions::czmv(limit) } else { CzOptions::czfo(limit) };
                let options = CzOptions { consistency: parts.contains('c'), ..options.with_feasible(feasible) };
                let options = options.with_candidates(candidates);
                Contender::new(name, mode, move |()| {
                    Ok(Box::new(CzFilter::new(case.system.clone(), case.constrained(), options.clone())?))
                })
            }
            "rcz" | "rcz/cheap" if parts.is_empty() && candidates == 1 => {
                let n = self.system.states();
                let options = if family == "rcz" { RczOptions::fast(n) } else { RczOptions::cheap(n) };
                Contender::new(name, mode, move |()| {
                    Ok(Box::new(Rcz::new(case.system.clone(), case.constrained(), options)?))
                })
            }
            _ => return Ok(None),
        }))
    }

    /// The filters of these names, in their order.
    ///
    /// # Errors
    /// [`ScenarioError::UnknownFilter`].
    pub fn contenders(&self, names: &[&str], mode: Mode) -> Result<Vec<Contender>, ScenarioError> {
        let named = |name: &&str| {
            self.contender(name, mode)?.ok_or_else(|| ScenarioError::UnknownFilter { name: (*name).to_owned() })
        };
        names.iter().map(named).collect()
    }

    /// The first set as a constrained zonotope.
    fn constrained(&self) -> ConstrainedZonotope {
        self.start.clone().into()
    }
}

/// The system with its process noise as generators, as the paper has it: a box remainder comes free of charge in a reduction.
fn with_noise_generators(mut system: System) -> Result<System, EstimatorError> {
    let mut noise = system.process_noise().clone();
    noise.materialize();
    system.set_dynamics(system.dynamics().clone(), noise)?;
    Ok(system)
}

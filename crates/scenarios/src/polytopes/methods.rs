//! [`PolytopeCase`]: a system with a first set, and the filters for it by their names.

use estimators::{
    Comb, CombMember, CombOptions, CzFilter, CzOptions, DCz, DCzOptions, DZb, DZbOptions, Estimator, EstimatorError,
    Phase, Rcz, RczOptions, System, Vh, VhOptions,
};
use scalars::Interval;
use setrep::{ConstrainedZonotope, VPolytope, Zonotope};

use crate::region::Region;
use crate::set_study::{Contender, SetEstimator};
use crate::{Mode, ScenarioError};

/// The filters of paper 004, in the order of its tables.
pub const PAPER: [&str; 5] = ["rrsr", "vh", "d-zb", "d-cz", "comb"];
/// What a user would take: V-H with three passes and tight ranges, and the ranged constrained zonotopes.
pub const DEFAULTS: [&str; 2] = ["vh/tight", "rcz"];

/// Corners of the first set that are one up to this share of its extents.
const THIN: f64 = 1e-12;

/// What all filters of a study are given.
#[derive(Debug, Clone)]
pub struct PolytopeCase {
    /// The model.
    pub system: System,
    /// The first set.
    pub start: Zonotope,
    /// What is added to the names of the paper's filters, such as `/tight-jacobian`.
    pub variant: &'static str,
}

impl PolytopeCase {
    /// The filter of a name of [`PAPER`] or [`DEFAULTS`]; none for other names.
    #[must_use]
    pub fn contender(&self, name: &str) -> Option<Contender> {
        let case = self.clone();
        let n = self.system.states();
        let build: Box<dyn Fn() -> Result<Box<dyn SetEstimator>, ScenarioError> + Send + Sync> = match name {
            "vh" => Box::new(move || Ok(Box::new(case.vh(VhOptions::paper())?))),
            "vh/tight" => Box::new(move || Ok(Box::new(case.vh(VhOptions::tight())?))),
            "rrsr" => Box::new(move || Ok(Box::new(case.rrsr()?))),
            "d-cz" => Box::new(move || Ok(Box::new(case.d_cz()?))),
            "d-zb" => Box::new(move || Ok(Box::new(case.d_zb()?))),
            "comb" => Box::new(move || Ok(Box::new(case.comb()?))),
            "rcz" => {
                Box::new(move || Ok(Box::new(Rcz::new(case.system.clone(), case.constrained(), RczOptions::fast(n))?)))
            }
            _ => return None,
        };
        Some(Contender::new(self.method(name), Mode::Rigorous, move |()| build()))
    }

    /// The name in the rows.
    #[must_use]
    pub fn method(&self, name: &str) -> String {
        if PAPER.contains(&name) { format!("{name}{}", self.variant) } else { name.to_owned() }
    }

    /// V-H.
    ///
    /// # Errors
    /// None: the sizes fit.
    pub fn vh(&self, options: VhOptions) -> Result<Vh, ScenarioError> {
        Ok(Vh::new(self.system.clone(), self.vertices()?, options)?)
    }

    fn rrsr(&self) -> Result<CzFilter, ScenarioError> {
        Ok(CzFilter::new(self.system.clone(), self.constrained(), CzOptions::rrsr())?)
    }

    fn d_cz(&self) -> Result<DCz, ScenarioError> {
        Ok(DCz::new(self.system.clone(), self.constrained(), DCzOptions::new(self.system.states()))?)
    }

    fn d_zb(&self) -> Result<DZb, ScenarioError> {
        Ok(DZb::new(self.system.clone(), self.start.clone().into(), DZbOptions::new(self.system.states()))?)
    }

    /// The polytopic filters of the paper at once: V-H, D-ZB and D-CZ.
    fn comb(&self) -> Result<Comb, ScenarioError> {
        let members: Vec<Box<dyn CombMember>> =
            vec![Box::new(self.vh(VhOptions::paper())?), Box::new(self.d_zb()?), Box::new(self.d_cz()?)];
        Ok(Comb::new(members, self.vertices()?, CombOptions::default())?)
    }

    fn constrained(&self) -> ConstrainedZonotope {
        self.start.clone().into()
    }

    fn vertices(&self) -> Result<VPolytope, ScenarioError> {
        Ok(self.start.to_v_polytope()?.thinned(THIN).absorb_remainder())
    }
}

/// COMB reports each call as one phase.
impl SetEstimator for Comb {
    fn predict(&mut self, input: &[f64], trace: &mut dyn FnMut(Phase)) -> Result<(), EstimatorError> {
        Estimator::predict(self, input)?;
        trace(Phase::Prediction);
        Ok(())
    }

    fn update(&mut self, output: &[f64], trace: &mut dyn FnMut(Phase)) -> Result<(), EstimatorError> {
        Estimator::update(self, output)?;
        trace(Phase::Update);
        Ok(())
    }

    fn hull(&self) -> &[Interval] {
        Comb::hull(self)
    }

    fn region(&self) -> &dyn Region {
        self.enclosure()
    }
}

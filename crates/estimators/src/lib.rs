//! Set-membership and Kalman filters on vector spaces and Lie groups.
//!
//! A filter keeps a set that holds the state. Between measurements the set moves with the model and grows by the process noise; a
//! measurement cuts it ([`Rcz`]), or corrects an estimate in it by a gain `L` times the innovation ([`Zsmf`], [`InZsmf`]).
//!
//! | filter | state | set | guarantee |
//! |---|---|---|---|
//! | [`Zsmf`] | `R^N`, any model with derivatives | zonotope around the estimate | first order |
//! | [`InZsmf`] | a Lie group, left- or right-invariant error by type | image of a zonotope of tangent vectors | first order |
//! | [`InvariantStrips`] | `SE(2)`, `SE_K(2)`, planar two-frame groups (lever arms, scale of the odometry) | polytope in the matrix embedding, past measurements as its rows | rigorous |
//! | [`SpatialStrips`] | `SE(3)`, `SE_2(3)`, any `SE_K(3)` | the same in space | rigorous |
//! | [`CzFilter`] | `R^n`, a [`System`] of functions written once, invariants | constrained zonotope: CZMV and CZFO of paper 003 | rigorous |
//! | [`ZonotopeFilter`] | `R^n`, a [`System`] | zonotope: ZMV and ZFO of paper 003 | rigorous |
//! | [`Zf`] | `R^n`, a [`System`] | zonotope: ZF of paper 001, linear systems included | rigorous |
//! | [`LinearizedZf`] | `R^n`, a [`System`] | the same, linearised at the center | first order |
//! | [`LinearCz`] | `R^n`, a [`LinearSystem`] | constrained zonotope, exact but for rounding | rigorous |
//! | [`Rcz`] | `R^n`, a [`System`] of functions written once, invariants | constrained zonotope and box | rigorous |
//! | [`Vh`] | the same | polytope, by its vertices | rigorous |
//! | [`Rrsr`], [`DCz`] | the same | constrained zonotope | rigorous |
//! | [`DZb`] | the same | zonotope bundle | rigorous |
//! | [`Comb`] | as its members | polytope, the intersection of their sets | as its members |
//! | [`kalman`]: `Kf`, `Ekf`, `Ukf` | `R^N`, or a Lie group | mean and covariance | statistical |
//! | [`kalman::wheels`]: `TfgIekf`, `ImperfectIekf`, `WheelEkf` | a wheeled robot, paper 002 | mean and covariance | statistical |
//!
//! Filters of a [`System`] are a [`SetFilter`] with a [`Method`]. All filters are an [`Estimator`]: [`predict`](Estimator::predict),
//! [`update`](Estimator::update), or both in one [`step`](Estimator::step). What a set promises is its [`Guarantee`]; [`Guarantee::FirstOrder`] means that the state can leave
//! the set, and the documentation of each filter says how often it did. A rigorous filter that is left without a state says so with
//! proof, [`EstimatorError::Inconsistent`], and keeps its predicted set.
//!
//! The gain is a rule, [`Gain`]: F-radius optimal ([`f_radius_gain`]), by pole placement for several outputs ([`place`]), or fixed.
//!
//! A call that fails leaves the filter as it was. In steady state (order reduction, F-radius or fixed gain, any gain whose pair
//! `A, C` is constant) a call allocates nothing. The state of a filter is saved by `clone`, or by its getters and restored by its
//! constructor.
//!
//! ```
//! use estimators::{Estimator, InZsmf, Left, Outputs};
//! use lie_groups::SE2;
//! use nalgebra::Vector3;
//! use setrep::{Reduction, Zonotope};
//!
//! let around_zero = |radii: &[f64]| Zonotope::from_box(&vec![0.0; radii.len()], radii);
//! let mut filter: InZsmf<SE2<f64>, 3, 2, Left> = InZsmf::new(
//!     SE2::from_pose(0.0, 0.0, 0.0),
//!     &around_zero(&[0.3, 1.0, 1.0])?, // heading in rad, position in m, body coordinates
//!     Outputs::position(),
//!     &around_zero(&[0.001, 0.01, 0.01])?,
//!     &around_zero(&[0.5, 0.5])?,
//! )?
//! .with_reduction(Reduction::Girard, 40)?;
//! filter.update(&[0.2, -0.1])?; // a position fix
//! filter.predict(&Vector3::new(0.01, 0.1, 0.0))?; // a step of 0.1 m with a turn of 0.01 rad
//! # Ok::<(), estimators::EstimatorError>(())
//! ```

mod case_proof;
mod constrained;
mod error;
mod error_set;
mod estimator;
pub mod gain;
mod inconsistency;
mod invariant_strips;
mod inzsmf;
pub mod kalman;
mod linear_cz;
mod polytopic;
mod rcz;
#[cfg(feature = "serde")]
mod remote;
mod set_filter;
mod spatial_strips;
mod system;
mod zonotopic;
mod zsmf;

pub use case_proof::Case;
pub use constrained::{
    ConstrainedMethod, Curvature, CzFilter, CzOptions, Extension, Inclusion, ReduceAfter, ReductionPolicy,
};
pub use error::EstimatorError;
pub use estimator::{Estimator, Guarantee};
pub use gain::{Gain, f_radius_gain, observability_rank, place};
pub use inconsistency::{Culprit, Evidence, Inconsistency};
pub use invariant_strips::{InvariantStrips, PlanarBox, PlanarIncrement, PlanarMeasurement, StripsOptions};
pub use inzsmf::{ErrorSide, InZsmf, Left, Outputs, Right};
pub use linear_cz::{LinearCz, LinearOptions, LinearSystem, NoiseForm};
pub use polytopic::{
    Comb, CombMember, CombOptions, DCz, DCzOptions, DCzScratch, DZb, DZbOptions, DZbScratch, DecomposedBundle,
    DecomposedConstrained, PolytopeForm, Rrsr, Stability, VertexPolytopes, Vh, VhCenter, VhOptions, VhScratch,
    WidthBound, stability,
};
pub use rcz::{RangedCz, Rcz, RczMemory, RczOptions, RczState, Tier};
pub use set_filter::{
    DelayedFilter, Fault, FaultPolicy, FilterState, Inflate, Measured, Method, Phase, Recovery, SetFilter,
};
pub use spatial_strips::{SpatialBox, SpatialIncrement, SpatialMeasurement, SpatialStrips};
pub use system::{Invariant, Relation, System};
pub use zonotopic::{
    LinearizedZf, StripForm, Zf, ZfMethod, ZfOptions, ZonotopeFilter, ZonotopeOptions, ZonotopicMethod,
};
pub use zsmf::{Model, Zsmf};

/// The README's example is a doctest.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;

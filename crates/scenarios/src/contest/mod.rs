//! What the experiments of paper 001 share: statistical and set-valued filters on the same noises, and what is counted.
//!
//! Reading order: [`truth`] (noises and proven runs), [`contestant`] (what is asked of a filter of either kind), [`follow`](mod@follow) (one filter in
//! one run), [`study`](mod@study) (all runs of all filters), [`cell`] (their rows).

pub mod cell;
pub mod contestant;
pub mod follow;
pub mod study;
pub mod truth;

pub use cell::{Cell, Paper};
pub use contestant::{Contestant, Held, SIGMAS, Zonotopic};
pub use follow::{Course, Named, Record, Watch, follow};
pub use study::{Arena, Contender, course, study, timings};
pub use truth::{Noise, Source, Truth, measured};

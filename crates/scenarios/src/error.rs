//! What can go wrong in an experiment.

use std::path::PathBuf;

/// Errors of experiments, their data and their artefacts.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ScenarioError {
    /// Data that does not ship with the project was not found; the experiment is skipped, the others run.
    #[error("{experiment}: no {file} found; {how}")]
    DataMissing {
        /// Experiment that needs the data.
        experiment: &'static str,
        /// File that was looked for, without its ending.
        file: String,
        /// How a reader can get the data.
        how: &'static str,
    },
    /// A file could not be read.
    #[error("cannot read {}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The operating system's reason.
        source: std::io::Error,
    },
    /// A data file was found and read, but its content is not what the format says.
    #[error("in {}", path.display())]
    Log {
        /// The file.
        path: PathBuf,
        /// Where and what.
        source: crate::data::LogError,
    },
    /// The columns of a table or the coordinates of a curve differ in length.
    #[error("{name}: column {column} has {found} entries, expected {expected}")]
    Ragged {
        /// Table or figure.
        name: String,
        /// Offending column or series.
        column: String,
        /// Its length.
        found: usize,
        /// The length of the first column.
        expected: usize,
    },
    /// A row or curve could not be serialised.
    #[error("cannot serialise {name}")]
    Serialise {
        /// The artefact.
        name: String,
        /// The serialiser's reason.
        source: Box<dyn std::error::Error + Send + Sync>,
    },
    /// A setting outside its range.
    #[error("{name} must be {expected}, got {value}")]
    Setting {
        /// Which setting.
        name: &'static str,
        /// The admissible values in words.
        expected: &'static str,
        /// The given value.
        value: f64,
    },
    /// No filter has this name.
    #[error("no filter is named {name}")]
    UnknownFilter {
        /// The name.
        name: String,
    },
    /// A simulated step could not be proven to be one of the model.
    #[error("the simulated trajectory is not proven to be one of the model")]
    Truth(#[from] crate::truth::TruthError),
    /// A group operation failed.
    #[error("a group operation failed")]
    Group(#[from] lie_groups::GroupError),
    /// A filter failed.
    #[error("a filter failed")]
    Estimator(#[from] estimators::EstimatorError),
    /// An enclosure of a function failed.
    #[error("an enclosure of a function failed")]
    Bound(#[from] nonlin_bounds::BoundError),
    /// A set operation failed.
    #[error("a set operation failed")]
    Set(#[from] setrep::SetError),
}

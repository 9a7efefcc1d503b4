//! One number of an experiment and where it belongs.

use serde::Serialize;

use super::mean_and_sd;

/// How an algorithm was run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Mode {
    /// As the paper's numbers imply, flaws included.
    Published,
    /// The paper's algorithm with valid set operations; still first order.
    Sound,
    /// Encloses the state, linearisation remainders and rounding included.
    Rigorous,
}

impl Mode {
    /// The name that stands in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Published => "published",
            Self::Sound => "sound",
            Self::Rigorous => "rigorous",
        }
    }
}

/// Why a row has no value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// The computation left the finite numbers.
    Diverged,
    /// The quantity is not defined here (nothing to average, a step that never came).
    Undefined,
}

/// One number, beside the paper's where the settings are the paper's.
///
/// Built from the left: `Row::new("Table I", "theta0=0,x0=(5,5)", "inzsmf").mode(Mode::Sound).metric("AAR(x)", "m^2").mean_of(&runs)`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    table: String,
    row: String,
    method: String,
    mode: Option<Mode>,
    metric: String,
    paper: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    paper_ref: Option<f64>,
    value: Option<f64>,
    sd: Option<f64>,
    unit: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    status: Option<Status>,
}

impl Row {
    /// A row of `table`, labelled `row` (what varies, in ASCII), for `method`; without a value yet (status `undefined`).
    #[must_use]
    pub fn new(table: impl Into<String>, row: impl Into<String>, method: impl Into<String>) -> Self {
        Self {
            table: table.into(),
            row: row.into(),
            method: method.into(),
            mode: None,
            metric: String::new(),
            paper: None,
            paper_ref: None,
            value: None,
            sd: None,
            unit: String::new(),
            status: Some(Status::Undefined),
        }
    }

    /// Sets the mode.
    #[must_use]
    pub fn mode(mut self, mode: Mode) -> Self {
        self.mode = Some(mode);
        self
    }

    /// Sets what is measured and its unit (empty for a pure number).
    #[must_use]
    pub fn metric(mut self, metric: impl Into<String>, unit: impl Into<String>) -> Self {
        self.metric = metric.into();
        self.unit = unit.into();
        self
    }

    /// Sets the paper's number; only on the one row of a cell whose settings reproduce the paper's.
    #[must_use]
    pub fn paper(mut self, value: f64) -> Self {
        self.paper = finite(value);
        self
    }

    /// Sets the paper's number for reference, on a row whose settings differ from the paper's.
    #[must_use]
    pub fn paper_ref(mut self, value: f64) -> Self {
        self.paper_ref = finite(value);
        self
    }

    /// Sets the value; infinities and NaN become `null` with [`Status::Diverged`].
    #[must_use]
    pub fn value(mut self, value: f64) -> Self {
        self.value = finite(value);
        self.status = self.value.is_none().then_some(Status::Diverged);
        self
    }

    /// Sets the standard deviation over runs (not of the mean).
    #[must_use]
    pub fn sd(mut self, sd: f64) -> Self {
        self.sd = finite(sd);
        self
    }

    /// Sets the mean over runs and, with two runs or more, their sample standard deviation.
    ///
    /// No samples leave the row undefined; a sample that is not finite makes it diverged.
    #[must_use]
    pub fn mean_of(mut self, samples: &[f64]) -> Self {
        let Some((mean, sd)) = mean_and_sd(samples) else {
            self.value = None;
            self.sd = None;
            self.status = Some(Status::Undefined);
            return self;
        };
        self = self.value(mean);
        self.sd = sd.and_then(finite).filter(|_| self.value.is_some());
        self
    }

    /// Sets a status and removes the value.
    #[must_use]
    pub fn status(mut self, status: Status) -> Self {
        self.value = None;
        self.sd = None;
        self.status = Some(status);
        self
    }

    /// The table of the paper, or our own name for it.
    #[must_use]
    pub fn table_name(&self) -> &str {
        &self.table
    }
    /// The label of what varies.
    #[must_use]
    pub fn row_name(&self) -> &str {
        &self.row
    }
    /// The method's name.
    #[must_use]
    pub fn method_name(&self) -> &str {
        &self.method
    }
    /// The mode, where one applies.
    #[must_use]
    pub fn get_mode(&self) -> Option<Mode> {
        self.mode
    }
    /// The metric's name.
    #[must_use]
    pub fn metric_name(&self) -> &str {
        &self.metric
    }
    /// The unit, empty for a pure number.
    #[must_use]
    pub fn unit(&self) -> &str {
        &self.unit
    }
    /// The paper's number: of the same settings, else for reference.
    #[must_use]
    pub fn paper_number(&self) -> Option<f64> {
        self.paper.or(self.paper_ref)
    }
    /// True if the paper's number is of the same settings.
    #[must_use]
    pub fn reproduces_paper(&self) -> bool {
        self.paper.is_some()
    }
    /// Our number.
    #[must_use]
    pub fn get_value(&self) -> Option<f64> {
        self.value
    }
    /// The standard deviation over runs.
    #[must_use]
    pub fn get_sd(&self) -> Option<f64> {
        self.sd
    }
    /// Why there is no value.
    #[must_use]
    pub fn get_status(&self) -> Option<Status> {
        self.status
    }
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

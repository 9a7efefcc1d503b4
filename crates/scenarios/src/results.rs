//! Rows of numbers that can be compared by machine: `results.json` and `timings.json`.
//!
//! Every figure an experiment claims is one [`Row`]: where it stands in the paper, what method and mode produced it, the paper's
//! number and ours. A row never holds an infinity or a NaN: such a value becomes `null` with a [`Status`].

use serde::Serialize;

use crate::ScenarioError;

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

/// The numbers of one experiment, serialised to the same bytes for the same seed whatever the number of threads.
#[derive(Debug, Clone, PartialEq)]
pub struct Results {
    /// Name of the experiment.
    pub experiment: String,
    /// Seed of all random streams.
    pub seed: u64,
    /// Monte Carlo runs per case.
    pub runs: usize,
    /// The numbers, in the order of the report.
    pub rows: Vec<Row>,
}

impl Results {
    /// Results without rows.
    #[must_use]
    pub fn new(experiment: impl Into<String>, seed: u64, runs: usize) -> Self {
        Self { experiment: experiment.into(), seed, runs, rows: Vec::new() }
    }

    /// Adds a row.
    pub fn push(&mut self, row: Row) {
        self.rows.push(row);
    }

    /// The rows of one table, in order.
    pub fn table<'a>(&'a self, table: &'a str) -> impl Iterator<Item = &'a Row> {
        self.rows.iter().filter(move |row| row.table == table)
    }

    /// JSON text: the head, then one row a line (readable in a diff).
    ///
    /// # Errors
    /// [`ScenarioError::Serialise`] if the serialiser fails (it has no reason to: the rows hold finite numbers and text).
    pub fn to_json(&self) -> Result<String, ScenarioError> {
        let json = |text: Result<String, serde_json::Error>| {
            text.map_err(|e| ScenarioError::Serialise { name: self.experiment.clone(), source: Box::new(e) })
        };
        let name = json(serde_json::to_string(&self.experiment))?;
        let rows = self.rows.iter().map(|row| json(serde_json::to_string(row))).collect::<Result<Vec<_>, _>>()?;
        let (seed, runs) = (self.seed, self.runs);
        let body = if rows.is_empty() { String::new() } else { format!("\n  {}\n", rows.join(",\n  ")) };
        Ok(format!("{{\"experiment\": {name}, \"seed\": {seed}, \"runs\": {runs}, \"rows\": [{body}]}}\n"))
    }
}

/// Mean and sample standard deviation (`n - 1`; none for one sample), summed in order; none for no samples.
#[must_use]
pub fn mean_and_sd(samples: &[f64]) -> Option<(f64, Option<f64>)> {
    if samples.is_empty() {
        return None;
    }
    let n = samples.len() as f64;
    let mean = samples.iter().sum::<f64>() / n;
    let squares: f64 = samples.iter().map(|x| (x - mean) * (x - mean)).sum();
    let sd = (samples.len() > 1).then(|| (squares / (n - 1.0)).sqrt());
    Some((mean, sd))
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row() -> Row {
        Row::new("Table I", "theta0=0,x0=(5,5)", "inzsmf").mode(Mode::Published).metric("AAR(x)", "m^2")
    }

    /// The line of the contract, key by key and in its order.
    #[test]
    fn a_row_reads_as_the_contract_says() {
        let mut results = Results::new("inzsmf", 1, 100);
        results.push(row().paper(4.41341).value(4.42).sd(0.02));
        let expected = concat!(
            r#"{"experiment": "inzsmf", "seed": 1, "runs": 100, "rows": ["#,
            "\n  ",
            r#"{"table":"Table I","row":"theta0=0,x0=(5,5)","method":"inzsmf","mode":"published","metric":"AAR(x)","#,
            r#""paper":4.41341,"value":4.42,"sd":0.02,"unit":"m^2"}"#,
            "\n]}\n"
        );
        assert_eq!(results.to_json().unwrap(), expected);
    }

    /// No infinity or NaN reaches the file; the reason does.
    #[test]
    fn non_finite_values_become_null_with_a_status() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let text = serde_json::to_string(&row().paper_ref(1.5).value(bad).sd(bad)).unwrap();
            assert!(text.contains(r#""paper":null,"paper_ref":1.5,"value":null,"sd":null"#), "{text}");
            assert!(text.ends_with(r#""status":"diverged"}"#), "{text}");
        }
        let none = row().mean_of(&[]);
        assert_eq!((none.get_value(), none.get_status()), (None, Some(Status::Undefined)));
        let one_bad = row().mean_of(&[1.0, f64::NAN]);
        assert_eq!((one_bad.get_value(), one_bad.get_sd(), one_bad.get_status()), (None, None, Some(Status::Diverged)));
    }

    #[test]
    fn mean_and_sample_deviation_by_hand() {
        assert_eq!(mean_and_sd(&[1.0, 2.0, 3.0, 6.0]), Some((3.0, Some((14.0_f64 / 3.0).sqrt()))));
        assert_eq!(mean_and_sd(&[4.0]), Some((4.0, None)));
        assert_eq!(mean_and_sd(&[]), None);
    }

    #[test]
    fn empty_results_are_valid_json() {
        let text = Results::new("none", 7, 0).to_json().unwrap();
        let parsed: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(parsed["rows"].as_array().map(Vec::len), Some(0));
    }
}

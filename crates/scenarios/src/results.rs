//! Rows of numbers that can be compared by machine: `results.json` and `timings.json`.
//!
//! Every figure an experiment claims is one [`Row`]: where it stands in the paper, what method and mode produced it, the paper's
//! number and ours. A row never holds an infinity or a NaN: such a value becomes `null` with a [`Status`].

use crate::ScenarioError;

mod row;

pub use row::{Mode, Row, Status};

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
        self.rows.iter().filter(move |row| row.table_name() == table)
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

//! [`Cell`]: all runs of one filter in one setting, and the rows made of them.

use super::Record;
use crate::{Mode, Row};

/// All runs of one filter in one setting.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell<const N: usize> {
    /// What varies, in ASCII.
    pub label: String,
    /// Name in the rows.
    pub method: String,
    /// What is rigorous, for sets.
    pub mode: Option<Mode>,
    /// Run by run.
    pub runs: Vec<Record<N>>,
}

/// The paper's numbers beside ours: of the same settings, or for reference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Paper<const N: usize> {
    /// Same settings.
    Same([f64; N]),
    /// Other settings.
    Other([f64; N]),
}

impl<const N: usize> Cell<N> {
    /// A row of a table about this cell, without a number yet.
    #[must_use]
    pub fn row(&self, table: &str, metric: impl Into<String>, unit: &str) -> Row {
        let row = Row::new(table, &*self.label, &*self.method).metric(metric, unit);
        if let Some(mode) = self.mode { row.mode(mode) } else { row }
    }

    /// A number of every run.
    pub fn samples(&self, of: impl Fn(&Record<N>) -> f64) -> Vec<f64> {
        self.runs.iter().map(of).collect()
    }

    /// Number of runs that diverged.
    #[must_use]
    pub fn diverged(&self) -> usize {
        self.runs.iter().filter(|run| run.diverged.is_some()).count()
    }

    /// Errors of all states, over all steps or over the late ones; `paper` has the paper's.
    pub fn error_rows(&self, table: &str, units: [&str; N], late: bool, paper: Option<Paper<N>>) -> Vec<Row> {
        let row = |i: usize| {
            let row = self.row(table, format!("RMSE(x{})", i + 1), units[i]);
            let row = match paper {
                Some(Paper::Same(numbers)) => row.paper(numbers[i]),
                Some(Paper::Other(numbers)) => row.paper_ref(numbers[i]),
                None => row,
            };
            row.mean_of(&self.samples(|run| if late { run.late_rmse[i] } else { run.rmse[i] }))
        };
        (0..N).map(row).collect()
    }

    /// Half widths of the given states at the marks.
    #[must_use]
    pub fn half_width_rows(&self, table: &str, units: [&str; N], states: &[usize], marks: &[usize]) -> Vec<Row> {
        let row = |mark: usize, i: usize| {
            let metric = format!("half-width(x{})@{}", i + 1, marks[mark]);
            self.row(table, metric, units[i]).mean_of(&self.samples(|run| run.marks[mark][i]))
        };
        states.iter().flat_map(|&i| (0..marks.len()).map(move |mark| (mark, i))).map(|(mark, i)| row(mark, i)).collect()
    }

    /// How often the truth was held, and what went wrong.
    #[must_use]
    pub fn containment_rows(&self, table: &str) -> Vec<Row> {
        let share = |count: fn(&Record<N>) -> usize| {
            self.samples(|run| if run.watched == 0 { f64::NAN } else { count(run) as f64 / run.watched as f64 })
        };
        let throughout = self.runs.iter().filter(|run| run.held == run.watched && run.diverged.is_none()).count();
        let refuted: usize = self.runs.iter().map(|run| run.refuted).sum();
        let mut rows = vec![
            self.row(table, "containment", "").mean_of(&share(|run| run.held)),
            self.row(table, "containment(hull)", "").mean_of(&share(|run| run.boxed)),
        ];
        if self.mode.is_some() {
            rows.push(self.row(table, "contained_proven", "").mean_of(&share(|run| run.proven)));
        }
        rows.extend([
            self.row(table, "runs_contained", "runs").value(throughout as f64),
            self.row(table, "empty_intersections", "steps").value(refuted as f64),
            self.row(table, "divergences", "runs").value(self.diverged() as f64),
        ]);
        rows
    }
}

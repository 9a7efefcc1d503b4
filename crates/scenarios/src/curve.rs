//! Columns of numbers, written as CSV.

use crate::ScenarioError;

/// A table of columns with a header; cells are numbers or text. A number that is not finite is an empty cell.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve {
    name: String,
    columns: Vec<(String, Column)>,
}

#[derive(Debug, Clone, PartialEq)]
enum Column {
    Numbers(Vec<f64>),
    Labels(Vec<String>),
}

impl Column {
    fn len(&self) -> usize {
        match self {
            Self::Numbers(cells) => cells.len(),
            Self::Labels(cells) => cells.len(),
        }
    }

    fn cell(&self, row: usize) -> String {
        match self {
            Self::Numbers(cells) => {
                cells.get(row).filter(|x| x.is_finite()).map(ToString::to_string).unwrap_or_default()
            }
            Self::Labels(cells) => cells.get(row).cloned().unwrap_or_default(),
        }
    }
}

impl Curve {
    /// An empty table; `name` is the file name without its ending.
    #[must_use]
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), columns: Vec::new() }
    }

    /// Adds a column of numbers; units belong in the header (`t_s`, `x1_m`).
    #[must_use]
    pub fn column(mut self, header: impl Into<String>, cells: impl IntoIterator<Item = f64>) -> Self {
        self.columns.push((header.into(), Column::Numbers(cells.into_iter().collect())));
        self
    }

    /// Adds a column of text.
    #[must_use]
    pub fn labels<T: Into<String>>(mut self, header: impl Into<String>, cells: impl IntoIterator<Item = T>) -> Self {
        self.columns.push((header.into(), Column::Labels(cells.into_iter().map(Into::into).collect())));
        self
    }

    /// File name without its ending.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// CSV text with a header line; numbers in the shortest form that reads back to the same f64.
    ///
    /// # Errors
    /// [`ScenarioError::Ragged`] if columns differ in length, [`ScenarioError::Serialise`] if the writer fails.
    pub fn to_csv(&self) -> Result<String, ScenarioError> {
        let rows = self.columns.first().map_or(0, |(_, column)| column.len());
        if let Some((header, column)) = self.columns.iter().find(|(_, column)| column.len() != rows) {
            let (name, column_name) = (self.name.clone(), header.clone());
            return Err(ScenarioError::Ragged { name, column: column_name, found: column.len(), expected: rows });
        }
        self.write(rows).map_err(|source| ScenarioError::Serialise { name: self.name.clone(), source })
    }

    fn write(&self, rows: usize) -> Result<String, Box<dyn std::error::Error + Send + Sync>> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(self.columns.iter().map(|(header, _)| header))?;
        for row in 0..rows {
            writer.write_record(self.columns.iter().map(|(_, column)| column.cell(row)))?;
        }
        Ok(String::from_utf8(writer.into_inner()?)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn writes_shortest_numbers_quotes_labels_and_leaves_gaps() {
        let curve = Curve::new("c").column("t_s", [0.1, 1e-300]).column("x", [f64::NAN, 2.0]).labels("s", ["a,b", "c"]);
        let expected = format!("t_s,x,s\n0.1,,\"a,b\"\n{},2,c\n", 1e-300);
        assert_eq!(curve.to_csv().unwrap(), expected);
    }

    #[test]
    fn ragged_columns_are_an_error() {
        let error = Curve::new("c").column("a", [1.0]).column("b", [1.0, 2.0]).to_csv().unwrap_err();
        assert!(matches!(error, ScenarioError::Ragged { found: 2, expected: 1, .. }));
    }
}

//! Logs of a wheeled robot: wheel odometry, gyro and a motion-capture reference at about 50 Hz.
//!
//! Seven columns: time (s), gyro (rad/s), forward and lateral speed from the wheels (m/s), reference heading (rad) and position (m).
//! Two spellings are read: CSV with a header, and the whitespace text of the public repository the logs come from (same columns, same order,
//! no header).

use std::path::Path;

use crate::ScenarioError;
use crate::data::{LogError, locate};

/// How a reader gets the logs.
pub const HOW_TO_GET: &str = "copy python/examples/data/wifibot2.txt and wifibot3.txt of the GitHub repository \
     CAOR-MINES-ParisTech/ukfm (BSD 3-Clause) into a folder DIR and pass --data DIR (or set ORBITOPE_DATA)";

/// Header of the CSV spelling, in the order of the columns.
const COLUMNS: [&str; 7] = ["t_s", "gyro_rad_s", "vx_m_s", "vy_m_s", "theta_rad", "px_m", "py_m"];

/// What each column can plausibly hold; headings may be unwrapped. Guards against files with other columns.
const PLAUSIBLE: [(f64, f64); 7] =
    [(0.0, 1e7), (-20.0, 20.0), (-10.0, 10.0), (-10.0, 10.0), (-100.0, 100.0), (-1e4, 1e4), (-1e4, 1e4)];

/// One line of a log.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Time, strictly increasing along a log.
    pub time_s: f64,
    /// Yaw rate from the gyro, over the interval since the sample before.
    pub gyro_rad_s: f64,
    /// Forward speed from the wheels, over the interval since the sample before.
    pub forward_m_s: f64,
    /// Lateral speed from the wheels (zero in these logs).
    pub lateral_m_s: f64,
    /// Reference heading.
    pub heading_rad: f64,
    /// Reference position.
    pub position_m: [f64; 2],
}

/// Reads the text of a log in either spelling; blank lines and `#` comments are skipped.
///
/// # Errors
/// [`LogError`] naming line and column: wrong number of columns, foreign header, cell that is not a finite number or implausible,
/// time that does not increase, fewer than two samples.
pub fn parse(text: &str) -> Result<Vec<Sample>, LogError> {
    let mut samples: Vec<Sample> = Vec::new();
    let lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    let mut lines = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#')).peekable();
    if let Some((line, cells)) =
        lines.next_if(|(_, line)| line.starts_with(|c: char| c.is_ascii_alphabetic() || c == '"'))
    {
        check_header(line, &split(cells))?;
    }
    for (line, cells) in lines {
        let sample = parse_sample(line, &split(cells))?;
        if let Some(previous) = samples.last().filter(|previous| sample.time_s <= previous.time_s) {
            return Err(LogError::Time { line, time_s: sample.time_s, previous_s: previous.time_s });
        }
        samples.push(sample);
    }
    if samples.len() < 2 {
        return Err(LogError::TooShort { found: samples.len(), needed: 2 });
    }
    Ok(samples)
}

/// Reads log `number` below `root`, or below nothing if no folder is given.
///
/// # Errors
/// [`ScenarioError::DataMissing`] if there is no such file, [`ScenarioError::Read`] and [`ScenarioError::Log`] for a file that cannot be used.
pub fn load(root: Option<&Path>, experiment: &'static str, number: u32) -> Result<Vec<Sample>, ScenarioError> {
    let stem = format!("wifibot{number}");
    let path = root.and_then(|root| locate(root, "wifibot", &stem, &["csv", "txt"]));
    let path = path.ok_or(ScenarioError::DataMissing { experiment, file: stem, how: HOW_TO_GET })?;
    let text = std::fs::read_to_string(&path).map_err(|source| ScenarioError::Read { path: path.clone(), source })?;
    parse(&text).map_err(|source| ScenarioError::Log { path, source })
}

fn split(line: &str) -> Vec<&str> {
    if line.contains(',') { line.split(',').map(str::trim).collect() } else { line.split_whitespace().collect() }
}

fn check_header(line: usize, cells: &[&str]) -> Result<(), LogError> {
    check_count(line, cells)?;
    let wrong = cells.iter().zip(COLUMNS).position(|(cell, name)| cell.trim_matches('"') != name);
    wrong.map_or(Ok(()), |k| {
        Err(LogError::Header { line, column: k + 1, found: cells[k].to_owned(), expected: COLUMNS[k] })
    })
}

fn check_count(line: usize, cells: &[&str]) -> Result<(), LogError> {
    let (found, expected) = (cells.len(), COLUMNS.len());
    if found == expected { Ok(()) } else { Err(LogError::Columns { line, found, expected }) }
}

fn parse_sample(line: usize, cells: &[&str]) -> Result<Sample, LogError> {
    check_count(line, cells)?;
    let mut values = [0.0; 7];
    for (k, (cell, value)) in cells.iter().zip(&mut values).enumerate() {
        let (column, name, (low, high)) = (k + 1, COLUMNS[k], PLAUSIBLE[k]);
        *value = match cell.parse::<f64>() {
            Ok(number) if number.is_finite() => number,
            _ => return Err(LogError::Number { line, column, name, found: (*cell).to_owned() }),
        };
        if !(low..=high).contains(value) {
            return Err(LogError::Implausible { line, column, name, value: *value, low, high });
        }
    }
    let [time_s, gyro_rad_s, forward_m_s, lateral_m_s, heading_rad, px, py] = values;
    Ok(Sample { time_s, gyro_rad_s, forward_m_s, lateral_m_s, heading_rad, position_m: [px, py] })
}

#[cfg(test)]
mod tests {
    use super::*;

    const CSV: &str = "t_s,gyro_rad_s,vx_m_s,vy_m_s,theta_rad,px_m,py_m\n1.5,0,0.2,0,-3.1,0.5,-0.25\n1.52,0.1,0.2,0,3.1,0.504,-0.25\n";
    const TEXT: &str = "  1.5000000e+00   0.0  2e-1 0 -3.1e+00 5.0e-01 -2.5e-01\n\n1.52 1e-1 0.2 0 3.1 0.504 -0.25\n";

    #[test]
    fn both_spellings_read_alike() {
        let samples = parse(CSV).unwrap();
        assert_eq!(samples, parse(TEXT).unwrap());
        let second = Sample {
            time_s: 1.52,
            gyro_rad_s: 0.1,
            forward_m_s: 0.2,
            lateral_m_s: 0.0,
            heading_rad: 3.1,
            position_m: [0.504, -0.25],
        };
        assert_eq!(samples[1], second);
    }

    #[test]
    fn errors_name_line_and_column() {
        let with = |line: &str| parse(&format!("{CSV}{line}\n")).unwrap_err();
        assert_eq!(with("1.6,0,0.2,0,0,0"), LogError::Columns { line: 4, found: 6, expected: 7 });
        for bad in ["nan", "inf", "x", ""] {
            let expected = LogError::Number { line: 4, column: 3, name: "vx_m_s", found: bad.to_owned() };
            assert_eq!(with(&format!("1.6,0,{bad},0,0,0,0")), expected);
        }
        assert_eq!(with("1.52,0,0,0,0,0,0"), LogError::Time { line: 4, time_s: 1.52, previous_s: 1.52 });
        assert!(matches!(with("1.6,0,55,0,0,0,0"), LogError::Implausible { line: 4, column: 3, value: 55.0, .. }));
        assert_eq!(parse("1.6 0 0 0 0 0 0"), Err(LogError::TooShort { found: 1, needed: 2 }));
        assert_eq!(parse(""), Err(LogError::TooShort { found: 0, needed: 2 }));
        let swapped = CSV.replace("vx_m_s,vy_m_s", "vy_m_s,vx_m_s");
        let header = LogError::Header { line: 1, column: 3, found: "vy_m_s".to_owned(), expected: "vx_m_s" };
        assert_eq!(parse(&swapped), Err(header));
    }

    #[test]
    fn missing_data_says_how_to_get_it() {
        let error = load(None, "wifibot", 2).unwrap_err();
        assert!(matches!(&error, ScenarioError::DataMissing { .. }));
        assert!(error.to_string().contains("--data") && !error.to_string().contains('\n'));
    }
}

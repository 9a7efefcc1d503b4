//! How the cost of an interval hull grows with the dimension, the generators and the constraints.

use std::time::Duration;

use scenarios::figure::{Figure, Look, Panel, Series};

use crate::cz_sets::Size;
use crate::hulls::random_hull;
use crate::timing::{Budget, Row};

/// Few windows: the largest sets take Clarabel a second.
const BUDGET: Budget = Budget { window: Duration::from_millis(4), windows: 25, patience: Duration::from_secs(3) };

/// One size grows, the others stay.
pub struct Sweep {
    /// What grows.
    parameter: &'static str,
    /// What stays.
    fixed: &'static str,
    /// The sizes of what grows, with their times.
    rows: Vec<(f64, Row)>,
}

impl Sweep {
    fn measure(parameter: &'static str, fixed: &'static str, values: &[usize], size: impl Fn(usize) -> Size) -> Self {
        println!("{parameter} grows, {fixed}");
        let time = |&value: &usize| {
            let row = random_hull(size(value)).run(BUDGET);
            println!("{:>6} {:>14.0} ns {:>16.0} ns {:>8.1}", value, row.ours_ns, row.peer_ns, row.ratio);
            (value as f64, row)
        };
        let sweep = Self { parameter, fixed, rows: values.iter().map(time).collect() };
        println!("exponents: ours {:.2}, Clarabel {:.2}", fit(&sweep.ours()).1, fit(&sweep.peer()).1);
        sweep
    }

    fn ours(&self) -> Vec<(f64, f64)> {
        self.rows.iter().map(|(x, row)| (*x, 1e-3 * row.ours_ns)).collect()
    }

    fn peer(&self) -> Vec<(f64, f64)> {
        self.rows.iter().map(|(x, row)| (*x, 1e-3 * row.peer_ns)).collect()
    }
}

/// Measures all sweeps and prints the figures.
pub fn sweeps() -> Vec<Sweep> {
    vec![
        Sweep::measure("n", "ng = 100, nc = 20", &[2, 4, 8, 16, 32, 64], |n| Size { n, ng: 100, nc: 20 }),
        Sweep::measure("ng", "n = 4, nc = 10", &[16, 32, 63, 125, 250, 500], |ng| Size { n: 4, ng, nc: 10 }),
        Sweep::measure("nc", "n = 4, ng = 250", &[3, 6, 12, 25, 50, 100], |nc| Size { n: 4, ng: 250, nc }),
        Sweep::measure("ng", "n = 4, nc = ng/5", &[15, 30, 60, 125, 250, 500], |ng| Size { n: 4, ng, nc: ng / 5 }),
    ]
}

/// A panel a sweep: times, and the power laws fitted to them.
pub fn figure(sweeps: &[Sweep]) -> Figure {
    let figure = Figure::new("hull-growth", "Interval hull of a constrained zonotope, time in microseconds", 2);
    sweeps.iter().fold(figure, |figure, sweep| {
        let both = [("boxlp, proven bounds", 0, sweep.ours()), ("Clarabel, objective updated", 1, sweep.peer())];
        let panel = Panel::new(sweep.fixed, sweep.parameter, "time [us]").log_x().log_y();
        figure.with(both.into_iter().fold(panel, |panel, (label, look, points)| {
            let (scale, exponent) = fit(&points);
            let law = points.iter().map(move |(x, _)| (*x, scale * x.powf(exponent))).collect::<Vec<_>>();
            panel.with(Series::points(label, Look::nth(look), points)).with(Series::line(
                "power law fitted",
                Look::nth(look),
                law,
            ))
        }))
    })
}

/// Factor and exponent of the power law that fits best in logarithms.
pub fn fit(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len() as f64;
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let (x, y) = logs.iter().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / count, b + y / count));
    let (covariance, variance) =
        logs.iter().fold((0.0, 0.0), |(c, v), (a, b)| (c + (a - x) * (b - y), v + (a - x) * (a - x)));
    let exponent = covariance / variance;
    ((y - exponent * x).exp(), exponent)
}

#[cfg(test)]
mod tests {
    use super::fit;

    #[test]
    fn a_power_law_is_recovered() {
        let (scale, exponent) = fit(&[(1.0, 3.0), (2.0, 12.0), (4.0, 48.0)]);
        assert!((scale - 3.0).abs() < 1e-12 && (exponent - 2.0).abs() < 1e-12);
    }
}

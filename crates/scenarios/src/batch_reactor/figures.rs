//! Figure 1 of the paper: one run, means and centers with their bounds.

use crate::contest::{Course, Named, Truth};
use crate::figure::{Figure, Look, Panel, Series};

/// Every so many steps are drawn.
const STRIDE: usize = 5;

/// Both pressures: the truth, centers, and bounds (three standard deviations, or the hull of the set).
#[must_use]
pub fn figure_1(name: &str, title: &str, truth: &Truth<2, 1>, courses: &[Named<2>]) -> Figure {
    let panel = |i: usize| {
        let title = format!("({}) x{}", char::from(b'a' + i as u8), i + 1);
        let mut panel = Panel::new(title, "t [s]", format!("x{} [atm]", i + 1));
        for (index, (method, course)) in courses.iter().enumerate() {
            let look = Look::nth(index);
            panel = panel.with(Series::line(*method, look.solid(), drawn(course, |(center, _)| center[i])));
            for sign in [-1.0, 1.0] {
                let bound = drawn(course, |(center, half)| center[i] + sign * half[i]);
                panel = panel.with(Series::line(format!("{method}: bounds"), look.dashed(2), bound));
            }
        }
        let states = truth.states.iter().enumerate().filter(|(k, _)| k % STRIDE == 0);
        panel.with(Series::line("truth", Look::REFERENCE, states.map(|(k, x)| (time_s(k), x[i])))).y_range(-0.5, 4.5)
    };
    Figure::new(name, title, 2).with(panel(0)).with(panel(1))
}

/// The points of a course that are drawn.
fn drawn(course: &Course<2>, value: impl Fn(&([f64; 2], [f64; 2])) -> f64) -> impl Iterator<Item = (f64, f64)> {
    course.iter().enumerate().filter(|(k, _)| k % STRIDE == 0).map(move |(k, step)| (time_s(k), value(step)))
}

/// Time of step `k + 1`.
fn time_s(k: usize) -> f64 {
    (k + 1) as f64
}

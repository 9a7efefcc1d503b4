//! (19) as it is printed, with the quotient `sin(p) / p`.

use nonlin_bounds::Function;
use scalars::Scalar;

use super::plant::{half_turn, turn};

/// The same function as [`AttitudeStep`](super::plant::AttitudeStep), but `p` stands twice in `sin(p) / p`, whose range and derivatives over
/// intervals are therefore too wide. The zonotope columns of the paper's Table 3 come with this form.
#[derive(Debug, Clone, Copy, Default)]
pub struct TextbookStep;

impl Function for TextbookStep {
    const VARIABLES: Option<usize> = Some(7);

    fn parameters(&self) -> usize {
        3
    }

    fn outputs(&self) -> usize {
        4
    }

    fn eval<S: Scalar>(&self, x: &[S], u: &[S], y: &mut [S]) {
        let half = half_turn(&x[4..], u);
        let angle = (half[0].sqr() + half[1].sqr() + half[2].sqr()).sqrt();
        turn(&x[..4], half, angle.cos(), angle.sin() / angle, y);
    }
}

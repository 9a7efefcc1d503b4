//! [`Flow`]: one step of the flow of a differential equation, proven.

use scalars::{Interval, Scalar};

use super::check_field;
use super::series::Series;
use crate::buffer::with_zeros;
use crate::derivative::{self, Enclosure, Evaluate};
use crate::{BoundError, Decorated, Dual, DynFunction, Function, Jet, Operand, Order, Smoothness};

/// Number of Taylor coefficients: order four and the remainder.
const TERMS: usize = 6;

/// The flow `y = x(h)` of `x' = f(x, w, p)`, `x(0) = x`, over one step: variables `(x, w)`, parameters `(p, h)`.
///
/// `x(h) = sum_{k <= 4} h^k x_k + h^5 x_5(B)`, where `x_k` are the Taylor coefficients of the solution from the initial box, found by power
/// series arithmetic, and the last is taken over an a-priori enclosure `B` of the solution: `X + [0, h] f(B) subset of B` (Picard and
/// Lindeloef). Derivatives by the initial states and `w` are the same formula for the variational equation, which dual numbers carry
/// along: value and derivatives are enclosed together.
///
/// **Guarantee:** encloses `x(h)`, and its derivatives if asked for, for all initial states and `w` in the box, all constant parameters, and
/// all steps in `h` (of either sign), remainder and rounding included; the solution exists over the step.
///
/// [`enclose`](DynFunction::enclose) has two errors more than a function: [`BoundError::NoAPrioriEnclosure`] if no `B` is found (a
/// shorter step helps), [`BoundError::NotSmooth`] if `f` is not proven smooth on `B`. The order is [`Order::Value`] or [`Order::Jacobian`].
///
/// ```
/// use nonlin_bounds::{DynFunction, Flow, Jet, Order, function};
/// use scalars::Interval;
/// let flow = Flow::new(function!(|[x]: 1| -> 1 { [x.sqr()] }))?; // x(h) = x / (1 - h x)
/// let mut jet = Jet::new();
/// flow.enclose(Order::Value, &[Interval::point(1.0)], &[Interval::point(0.125)], &mut jet)?;
/// assert!(jet.values()[0].width() < 1e-4);
/// assert!(jet.values()[0].lo() < 8.0 / 7.0 && 8.0 / 7.0 < jet.values()[0].hi());
/// # Ok::<(), nonlin_bounds::BoundError>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Flow<F> {
    field: F,
}

impl<F: Function> Flow<F> {
    /// The flow of a vector field.
    ///
    /// # Errors
    /// [`BoundError::Dimension`] if the field has more outputs than variables.
    pub fn new(field: F) -> Result<Self, BoundError> {
        check_field(&field)?;
        Ok(Self { field })
    }

    /// Taylor coefficients of the solutions from `x` up to `degree`, as series.
    fn solve<S: Scalar>(&self, x: &[S], p: &[S], degree: usize, solution: &mut [Series<S, TERMS>]) {
        let n = self.field.outputs();
        for (i, (series, &x)) in solution.iter_mut().zip(x).enumerate() {
            *series = if i < n { Series::start(x) } else { Series::constant(x) };
        }
        with_zeros(p.len(), |parameters: &mut [Series<S, TERMS>]| {
            for (series, &p) in parameters.iter_mut().zip(p) {
                *series = Series::constant(p);
            }
            with_zeros(n, |slope: &mut [Series<S, TERMS>]| {
                for k in 0..degree {
                    self.field.eval(solution, parameters, slope);
                    for (x, f) in solution.iter_mut().zip(&*slope) {
                        x.push(f.coefficient(k) / S::from_f64((k + 1) as f64));
                    }
                }
            });
        });
    }

    /// `y = x + span f(b)`, a step of Picard's iteration.
    fn picard<D: Enclosure>(&self, x: &[D], b: &[D], p: &[D], span: D, y: &mut [D]) {
        self.field.eval(b, p, y);
        for (y, &x) in y.iter_mut().zip(x) {
            *y = x + span * *y;
        }
    }

    /// Finds `b` with `x + span f(b) subset of b`; the entries beyond the states are those of `x`. `image` is scratch.
    fn enclose_a_priori<D: Enclosure>(
        &self,
        x: &[D],
        p: &[D],
        span: D,
        b: &mut [D],
        image: &mut [D],
    ) -> Result<(), BoundError> {
        let n = image.len();
        b.copy_from_slice(x);
        self.picard(x, b, p, span, image);
        for attempt in 0..ATTEMPTS {
            let growth = 0.05 * f64::from(1_u32 << attempt.min(16));
            for (b, image) in b.iter_mut().zip(&*image) {
                *b = b.zip_ranges(image, |b, image| widened(b.hull(image), growth));
            }
            self.picard(x, b, p, span, image);
            if !image.iter().all(|y| y.all_ranges(y, |range, _| range.is_bounded())) {
                break;
            }
            if image.iter().zip(&*b).all(|(y, b)| y.all_ranges(b, |y, b| y.subset_of(&b))) {
                // The exact image of a part of `b` lies in the image found and, if that of `b` does, in `b`: the intersection of both
                // holds its own exact image, however the computed ones round. Smooth there, the field has a solution that stays.
                for _ in 0..2 {
                    for (b, image) in b[..n].iter_mut().zip(&*image) {
                        *b = b.zip_ranges(image, Interval::intersection);
                    }
                    self.picard(x, b, p, span, image);
                    check_smooth(image)?;
                }
                return Ok(());
            }
        }
        Err(BoundError::NoAPrioriEnclosure { step: span.value().range().mag() })
    }
}

/// Attempts to find an a-priori enclosure, each with twice the growth of the one before.
const ATTEMPTS: u32 = 12;

/// `Ok` if all outputs are proven to be `C2`.
fn check_smooth<D: Enclosure>(y: &[D]) -> Result<(), BoundError> {
    match y.iter().map(|y| y.value().smoothness()).enumerate().find(|&(_, found)| found < Smoothness::C2) {
        Some((output, found)) => Err(BoundError::NotSmooth { output, required: Smoothness::C2, found }),
        None => Ok(()),
    }
}

/// The interval with `growth` of its width added on each side, and a little of its magnitude.
fn widened(x: Interval, growth: f64) -> Interval {
    x.inflate(growth * x.width() + 1e-14 * x.mag() + f64::MIN_POSITIVE)
}

impl<F: Function, D: Enclosure> Evaluate<D> for Flow<F> {
    fn outputs(&self) -> usize {
        self.field.outputs()
    }

    fn evaluate(&self, x: &[D], p: &[D], y: &mut [D]) -> Result<(), BoundError> {
        let (p, step) = p.split_at(self.field.parameters());
        let range = step[0].value().range();
        let span = D::seed(Decorated::constant(range.hull(Interval::ZERO)), None);
        with_zeros(x.len(), |b| {
            self.enclose_a_priori(x, p, span, b, y)?;
            with_zeros(x.len(), |solution| {
                self.solve(b, p, TERMS - 1, solution);
                for (y, series) in y.iter_mut().zip(&*solution) {
                    *y = series.coefficient(TERMS - 1);
                }
                self.solve(x, p, TERMS - 2, solution);
                for (y, series) in y.iter_mut().zip(&*solution) {
                    // Horner's rule, the remainder innermost.
                    *y = (0..TERMS - 1).rev().fold(*y, |sum, k| sum * step[0] + series.coefficient(k));
                }
                check_smooth(y)
            })
        })
    }
}

impl<F: Function> DynFunction for Flow<F> {
    fn variables(&self) -> usize {
        self.field.variables()
    }

    fn parameters(&self) -> usize {
        self.field.parameters() + 1
    }

    fn outputs(&self) -> usize {
        self.field.outputs()
    }

    /// The Taylor polynomial of the solution, of degree five.
    fn value(&self, x: &[f64], p: &[f64], y: &mut [f64]) -> Result<(), BoundError> {
        BoundError::check_size(Operand::Variables, DynFunction::variables(self), x.len())?;
        BoundError::check_size(Operand::Parameters, DynFunction::parameters(self), p.len())?;
        BoundError::check_size(Operand::Outputs, DynFunction::outputs(self), y.len())?;
        let (p, step) = p.split_at(self.field.parameters());
        with_zeros(x.len(), |solution| {
            self.solve(x, p, TERMS - 1, solution);
            for (y, series) in y.iter_mut().zip(&*solution) {
                *y = (0..TERMS).rev().fold(0.0, |sum, k| sum * step[0] + series.coefficient(k));
            }
        });
        Ok(())
    }

    fn enclose(&self, order: Order, x: &[Interval], p: &[Interval], jet: &mut Jet) -> Result<(), BoundError> {
        BoundError::check_box(Operand::Variables, DynFunction::variables(self), x)?;
        BoundError::check_box(Operand::Parameters, DynFunction::parameters(self), p)?;
        let mut draft = jet.scratch.draft.take().unwrap_or_default();
        let result = match order {
            Order::Hessian => Err(BoundError::OrderNotAvailable { order: 2 }),
            Order::Jacobian if !x.is_empty() => {
                derivative::jacobian::<_, Dual<Interval, 8, Decorated>>(self, x, p, &mut draft)
            }
            _ => derivative::values(self, order, x, p, &mut draft),
        };
        if result.is_ok() {
            jet.swap_results(&mut draft);
        }
        jet.scratch.draft = Some(draft);
        result
    }
}

//! [`IntervalNewton`]: contraction by the linear system of the mean value theorem.

use scalars::Interval;

use super::linear::{left_inverse, revise_row};
use super::{Conflict, Contraction, check_box, gain};
use crate::function::evaluate;
use crate::{BoundError, DynFunction, Jet, Operand, Order, Smoothness, Workspace};

/// Interval Newton contraction: Krawczyk's operator and Gauss-Seidel steps, preconditioned where there are as many outputs as variables
/// or more.
///
/// With `m` the midpoint of the box `X` and `J` an enclosure of the Jacobian over `X` and all parameters, every solution `x = m + d` of
/// `f(x, p) in y` satisfies `J d = v` for a matrix in `J` and a `v` in `y - f(m, p)`. A sweep revises `d` by the rows of that system,
/// and by those of `C J d = C v` with an approximate (left) inverse `C` of the midpoint of `J`, whose Krawczyk image
/// `C v + (I - C J) (X - m)` is taken first.
///
/// **Guarantee:** no solution is lost, rounding included. For a square system whose Krawczyk image lies in the interior of the box, the
/// answer is [`Contraction::ProvenUnique`]: for every `p` in the parameters' box and every value in `y` there is exactly one solution.
///
/// **Source:** Krawczyk, *Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken*, Computing 4, 1969; Neumaier,
/// *Interval Methods for Systems of Equations*, 1990, sections 4.3 and 5.1-5.2.
///
/// ```
/// # use nonlin_bounds::{Contraction, Function, IntervalNewton, Workspace};
/// # use scalars::{Interval, Scalar};
/// struct Parabola; // x^2 = 2
/// impl Function for Parabola {
///     const VARIABLES: Option<usize> = Some(1);
///     fn outputs(&self) -> usize { 1 }
///     fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
///         y[0] = x[0].sqr();
///     }
/// }
/// let mut x = [Interval::new(1.0, 2.0)?];
/// let outcome =
///     IntervalNewton::default().contract(&Parabola, &mut x, &[], &[Interval::point(2.0)], &mut Workspace::new())?;
/// assert!(matches!(outcome, Contraction::ProvenUnique { .. }));
/// assert!(x[0].contains(2.0_f64.sqrt()) && x[0].width() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntervalNewton {
    /// Most sweeps.
    pub sweeps: usize,
    /// Stop after a sweep in which no side of the box lost more than this share of its width.
    pub least_gain: f64,
}

impl Default for IntervalNewton {
    /// Ten sweeps, 2 %.
    fn default() -> Self {
        Self { sweeps: 10, least_gain: 0.02 }
    }
}

/// Buffers of the sweeps.
#[derive(Debug, Default, Clone)]
pub(super) struct Buffers {
    /// The box being shrunk, its midpoint, and the box less the midpoint.
    sides: Vec<Interval>,
    mid: Vec<Interval>,
    offsets: Vec<Interval>,
    /// The function at the midpoint.
    at_mid: Jet,
    /// `y - f(m)`.
    residuals: Vec<Interval>,
    jacobian_mid: Vec<f64>,
    inverse: Vec<f64>,
    normal: Vec<f64>,
    /// `C J` and `C (y - f(m))`.
    preconditioned: Vec<Interval>,
    right_hand_side: Vec<Interval>,
    suffix: Vec<Interval>,
}

impl IntervalNewton {
    /// Shrinks the box `x` around the solutions of `f(x, p) in y`.
    ///
    /// After [`Contraction::ProvenEmpty`] and after an error the box is as it was. Allocates nothing once the workspace has grown, if the
    /// function does not.
    ///
    /// # Errors
    /// [`BoundError::Dimension`]; [`BoundError::EmptyInterval`]; [`BoundError::NotSmooth`] where `f` is not proven continuously
    /// differentiable on the box; what `f` answers, as [`BoundError::NonFinite`] for an unbounded box.
    pub fn contract(
        &self,
        f: &dyn DynFunction,
        x: &mut [Interval],
        p: &[Interval],
        y: &[Interval],
        workspace: &mut Workspace,
    ) -> Result<Contraction, BoundError> {
        check_box(Operand::Variables, f.variables(), x)?;
        check_box(Operand::Parameters, f.parameters(), p)?;
        check_box(Operand::Outputs, f.outputs(), y)?;
        let (jet, buffers) = (&mut workspace.jet, &mut workspace.contract.newton);
        buffers.sides.clear();
        buffers.sides.extend_from_slice(x);
        let (mut sweeps, mut unique) = (0, false);
        while sweeps < self.sweeps {
            sweeps += 1;
            buffers.linearize(f, p, y, jet)?;
            let proven = match buffers.sweep(jet) {
                Ok(proven) => proven,
                Err(emptied) => return Ok(Contraction::ProvenEmpty(emptied.conflict(sweeps))),
            };
            unique |= proven;
            let gained = match buffers.shrink() {
                Ok(gained) => gained,
                Err(emptied) => return Ok(Contraction::ProvenEmpty(emptied.conflict(sweeps))),
            };
            if gained == 0.0 || gained < self.least_gain {
                break;
            }
        }
        x.copy_from_slice(&buffers.sides);
        Ok(if unique { Contraction::ProvenUnique { sweeps } } else { Contraction::Undecided { sweeps } })
    }
}

/// What left nothing.
enum Emptied {
    Row(usize),
    Variable(usize),
}

impl Emptied {
    fn conflict(&self, sweep: usize) -> Conflict {
        match *self {
            Self::Row(output) => Conflict::Output { output, sweep },
            Self::Variable(variable) => Conflict::Variable { variable, sweep },
        }
    }
}

impl Buffers {
    /// Midpoint, offsets, residuals, and the Jacobian over the box (in the jet).
    fn linearize(
        &mut self,
        f: &dyn DynFunction,
        p: &[Interval],
        y: &[Interval],
        jet: &mut Jet,
    ) -> Result<(), BoundError> {
        evaluate(f, Order::Jacobian, &self.sides, p, jet)?;
        BoundError::check_smooth(jet, Smoothness::C1)?;
        self.mid.clear();
        self.mid.extend(self.sides.iter().map(|side| Interval::point(side.mid())));
        evaluate(f, Order::Value, &self.mid, p, &mut self.at_mid)?;
        self.offsets.clear();
        self.offsets.extend(self.sides.iter().zip(&self.mid).map(|(&side, &mid)| side - mid));
        self.residuals.clear();
        self.residuals.extend(y.iter().zip(self.at_mid.values()).map(|(&y, &value)| y - value));
        Ok(())
    }

    /// Revises the offsets; true if a solution is proven to exist and to be the only one.
    fn sweep(&mut self, jet: &Jet) -> Result<bool, Emptied> {
        let (m, n) = (self.residuals.len(), self.offsets.len());
        let j = jet.jacobian();
        for (i, &residual) in self.residuals.iter().enumerate() {
            if !revise_row(&j[i * n..][..n], residual, &mut self.offsets, &mut self.suffix) {
                return Err(Emptied::Row(i));
            }
        }
        self.jacobian_mid.clear();
        self.jacobian_mid.extend(j.iter().map(Interval::mid));
        if n == 0 || m < n || !left_inverse(&self.jacobian_mid, m, n, &mut self.inverse, &mut self.normal) {
            return Ok(false);
        }
        self.precondition(j, m, n);
        let proven = self.krawczyk(n)? && m == n;
        for (i, &b) in self.right_hand_side.iter().enumerate() {
            if !revise_row(&self.preconditioned[i * n..][..n], b, &mut self.offsets, &mut self.suffix) {
                return Err(Emptied::Variable(i));
            }
        }
        Ok(proven)
    }

    /// `C J` and `C (y - f(m))`.
    fn precondition(&mut self, j: &[Interval], m: usize, n: usize) {
        self.preconditioned.clear();
        self.right_hand_side.clear();
        for c in self.inverse.chunks_exact(m) {
            for l in 0..n {
                let entry = c.iter().enumerate().map(|(i, &c)| j[i * n + l].scale(c));
                self.preconditioned.push(entry.fold(Interval::ZERO, |sum, term| sum + term));
            }
            let entry = c.iter().zip(&self.residuals).map(|(&c, residual)| residual.scale(c));
            self.right_hand_side.push(entry.fold(Interval::ZERO, |sum, term| sum + term));
        }
    }

    /// Intersects the offsets with the Krawczyk image `C (y - f(m)) + (I - C J) (X - m)`; true if the image of the whole box lies in
    /// the interior of the box.
    fn krawczyk(&mut self, n: usize) -> Result<bool, Emptied> {
        let mut interior = true;
        for i in 0..n {
            let row = &self.preconditioned[i * n..][..n];
            let mut image = self.right_hand_side[i];
            for (l, (&a, (&side, &mid))) in row.iter().zip(self.sides.iter().zip(&self.mid)).enumerate() {
                let identity = if l == i { Interval::ONE } else { Interval::ZERO };
                image += (identity - a) * (side - mid);
            }
            interior &= (self.mid[i] + image).interior_of(&self.sides[i]) && self.sides[i].is_bounded();
            self.offsets[i] = self.offsets[i].intersection(image);
            if self.offsets[i].is_empty() {
                return Err(Emptied::Variable(i));
            }
        }
        Ok(interior)
    }

    /// Intersects the box with midpoint plus offsets, and returns the largest share that a side has lost.
    fn shrink(&mut self) -> Result<f64, Emptied> {
        let mut largest = 0.0_f64;
        for (variable, (side, (&mid, &offset))) in
            self.sides.iter_mut().zip(self.mid.iter().zip(&self.offsets)).enumerate()
        {
            let after = side.intersection(mid + offset);
            if after.is_empty() {
                return Err(Emptied::Variable(variable));
            }
            largest = largest.max(gain(*side, after));
            *side = after;
        }
        Ok(largest)
    }
}

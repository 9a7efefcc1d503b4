//! Images by DC programming: a function as a difference of convex ones, whose errors are largest at vertices.

use scalars::Interval;
use scalars::rounding::{add_up, div_up, mul_up};
use setrep::{ConstrainedZonotope, IntervalMatrix, Zonotope};

use crate::function::evaluate;
use crate::parallelotope::Parallelotope;
use crate::{BoundError, DynFunction, Jet, Operand, Order, Smoothness, Workspace};

/// A function as a difference of functions that are convex in every output.
#[derive(Clone, Copy)]
pub enum ConvexSplit<'a> {
    /// `f = plus - minus`, of the same variables, parameters and outputs. **That both are convex, on the parallelotope around the set and its center,
    /// is the caller's claim**, on which the guarantee rests.
    Given {
        /// The convex part.
        plus: &'a dyn DynFunction,
        /// What is subtracted.
        minus: &'a dyn DynFunction,
    },
    /// `f = (f + q) - q` and `f = q - (q - f)` with quadratic functions `q` that are steep enough by the interval Hessian of `f` (Gershgorin), which
    /// is proven; both splits are used.
    Automatic(&'a dyn DynFunction),
}

/// Image `{ f(x, p) : x in X }` of a constrained zonotope by DC programming.
///
/// With `x_0` the center of a parallelotope `P` around `X` along its principal axes, the image lies in `f(x_0) + J(x_0) (X - x_0) + [e]`. For
/// `f = f_a - f_b` the error `e` of the linearisation is that of `f_a` minus that of `f_b`, both convex and nonnegative:
/// `-max_v e_b(v) <= e <= max_v e_a(v)` over the `2^n` vertices `v` of `P`. The result has the generators and constraints of `X`; `[e]` goes to the
/// box remainder.
///
/// **Guarantee:** superset of the image, rounding included; for [`ConvexSplit::Given`], if the two functions are convex as claimed.
/// **Source:** Alamo, Bravo, Redondo, Camacho, *A Set-Membership State Estimation Algorithm Based on DC Programming*, Automatica 44 (2008); for constrained
/// zonotopes de Paula, Rego, Raffo 2024.
///
/// # Errors
/// [`BoundError::Dimension`]; [`BoundError::NotSmooth`] unless every output is proven `C2` on the box around `P` (automatic), or `C1` at `x_0` (given);
/// [`BoundError::UnboundedResult`]; [`BoundError::Set`], among them an empty set and more than 16 dimensions.
///
/// ```
/// use nonlin_bounds::{ConvexSplit, Function, Workspace, dc_image};
/// use scalars::Scalar;
/// use setrep::ConstrainedZonotope;
///
/// struct Square;
/// impl Function for Square {
///     const VARIABLES: Option<usize> = Some(1);
///     fn outputs(&self) -> usize {
///         1
///     }
///     fn eval<S: Scalar>(&self, x: &[S], _: &[S], y: &mut [S]) {
///         y[0] = x[0].sqr();
///     }
/// }
/// let set = ConstrainedZonotope::from_box(&[1.0], &[1.0])?;
/// let image = dc_image(&ConvexSplit::Automatic(&Square), &set, &[], &mut Workspace::new())?;
/// // 1 + 2 (x - 1) + [0, 1].
/// let side = image.unconstrained().interval_hull()[0];
/// assert!(side.lo() > -1.0 - 1e-12 && side.hi() < 4.0 + 1e-12);
/// # Ok::<(), nonlin_bounds::BoundError>(())
/// ```
pub fn dc_image(
    split: &ConvexSplit<'_>,
    set: &ConstrainedZonotope,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<ConstrainedZonotope, BoundError> {
    split.check(set.dim(), p)?;
    let sets = &mut workspace.sets;
    let mut frame_workspace = setrep::Workspace::new();
    let frame = Parallelotope::around(set.unconstrained(), |axis| set.support(axis, sets), &mut frame_workspace)?;
    let line = Linearization::of(split, &frame, p)?;
    let mut image = set.clone();
    image.translate(&opposite(&frame.center))?;
    let hull = image.interval_hull(sets)?;
    image.interval_map_in_place(&line.map, &hull, sets)?;
    image.add_box(&line.offsets)?;
    Ok(image)
}

/// Image `{ f(x, p) : x in X }` of a zonotope by DC programming; see [`dc_image`].
///
/// **Guarantee:** as [`dc_image`].
///
/// # Errors
/// As [`dc_image`].
pub fn dc_image_of_zonotope(
    split: &ConvexSplit<'_>,
    set: &Zonotope,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<Zonotope, BoundError> {
    split.check(set.dim(), p)?;
    let frame = Parallelotope::around(set, |axis| set.support(axis), &mut workspace.sets)?;
    let line = Linearization::of(split, &frame, p)?;
    let mut image = set.clone();
    image.translate(&opposite(&frame.center))?;
    image.interval_map_in_place(&line.map, &mut workspace.sets)?;
    image.add_box(&line.offsets)?;
    Ok(image)
}

impl ConvexSplit<'_> {
    /// A function with the variables, parameters and outputs of the split.
    fn function(&self) -> &dyn DynFunction {
        match self {
            Self::Given { plus, .. } => *plus,
            Self::Automatic(f) => *f,
        }
    }

    /// `Ok` if set and parameters fit.
    fn check(&self, dim: usize, p: &[Interval]) -> Result<(), BoundError> {
        let f = self.function();
        BoundError::check_size(Operand::Variables, f.variables(), dim)?;
        BoundError::check_box(Operand::Parameters, f.parameters(), p)?;
        let Self::Given { plus, minus } = self else { return Ok(()) };
        BoundError::check_size(Operand::Variables, plus.variables(), minus.variables())?;
        BoundError::check_size(Operand::Parameters, plus.parameters(), minus.parameters())?;
        BoundError::check_size(Operand::Outputs, plus.outputs(), minus.outputs())
    }
}

/// `f(x)` in `map (x - x_0) + offsets` on a parallelotope.
struct Linearization {
    map: IntervalMatrix,
    offsets: Vec<Interval>,
}

impl Linearization {
    /// Linearises about the center of `frame`.
    fn of(split: &ConvexSplit<'_>, frame: &Parallelotope, p: &[Interval]) -> Result<Self, BoundError> {
        let (m, n) = (split.function().outputs(), frame.center.len());
        let (values, jacobian, errors) = match split {
            ConvexSplit::Given { plus, minus } => {
                let (a, b) = (Expanded::at(*plus, frame, p)?, Expanded::at(*minus, frame, p)?);
                let none = vec![0.0; m * n];
                let (above, below) = (a.largest_error(frame, 1.0, &none)?, b.largest_error(frame, 1.0, &none)?);
                let difference =
                    |a: &[Interval], b: &[Interval]| a.iter().zip(b).map(|(a, b)| *a - *b).collect::<Vec<_>>();
                let errors = above.iter().zip(&below).map(|(&above, &below)| (-below, above)).collect();
                (difference(a.jet.values(), b.jet.values()), difference(a.jet.jacobian(), b.jet.jacobian()), errors)
            }
            ConvexSplit::Automatic(f) => {
                let a = Expanded::at(*f, frame, p)?;
                let errors = automatic_errors(*f, &a, frame, p)?;
                (a.jet.values().to_vec(), a.jet.jacobian().to_vec(), errors)
            }
        };
        let mut offsets = Vec::with_capacity(m);
        for (output, (value, (lo, hi))) in values.iter().zip(errors).enumerate() {
            let offset = *value + Interval::new(lo, hi).unwrap_or(Interval::ENTIRE);
            if !offset.is_bounded() {
                return Err(BoundError::UnboundedResult { output });
            }
            offsets.push(offset);
        }
        let columns: Vec<Interval> = (0..n * m).map(|k| jacobian[(k % m) * n + k / m]).collect();
        if let Some(k) = columns.iter().position(|slope| !slope.is_bounded()) {
            return Err(BoundError::UnboundedResult { output: k % m });
        }
        Ok(Self { map: IntervalMatrix::from_intervals(m, n, &columns)?, offsets })
    }
}

/// A function with its value and Jacobian at the center of a parallelotope.
struct Expanded<'a> {
    f: &'a dyn DynFunction,
    p: &'a [Interval],
    jet: Jet,
}

impl<'a> Expanded<'a> {
    fn at(f: &'a dyn DynFunction, frame: &Parallelotope, p: &'a [Interval]) -> Result<Self, BoundError> {
        let center: Vec<Interval> = frame.center.iter().map(|&c| Interval::point(c)).collect();
        let mut jet = Jet::new();
        evaluate(f, Order::Jacobian, &center, p, &mut jet)?;
        BoundError::check_smooth(&jet, Smoothness::C1)?;
        Ok(Self { f, p, jet })
    }

    /// Upper bounds of `max_v sign (f_i(v) - f_i(x_0) - J_i (v - x_0)) + sum_j curvature_ij zeta_j^2 / 2` over the vertices.
    fn largest_error(&self, frame: &Parallelotope, sign: f64, curvatures: &[f64]) -> Result<Vec<f64>, BoundError> {
        let n = frame.center.len();
        let mut offset = vec![Interval::ZERO; n];
        let mut vertex = offset.clone();
        let mut jet = Jet::new();
        // The error is nonnegative on the whole parallelotope, and so is its maximum.
        let mut largest = vec![0.0_f64; self.jet.outputs()];
        frame.each_vertex(|zeta| {
            frame.offset(zeta, &mut offset);
            vertex.iter_mut().zip(offset.iter().zip(&frame.center)).for_each(|(v, (o, &c))| *v = o.add_f64(c));
            evaluate(self.f, Order::Value, &vertex, self.p, &mut jet)?;
            for (i, largest) in largest.iter_mut().enumerate() {
                let slopes = &self.jet.jacobian()[i * n..(i + 1) * n];
                let linear = slopes.iter().zip(&offset).fold(self.jet.values()[i], |sum, (j, o)| sum + *j * *o);
                let error = (jet.values()[i] - linear).scale(sign).hi();
                let bowl = zeta.iter().zip(&curvatures[i * n..]).map(|(z, &q)| mul_up(mul_up(0.5, q), z.sqr().hi()));
                // An empty value, at a vertex where the function is not defined, has no bound.
                let error = bowl.fold(if error.is_nan() { f64::INFINITY } else { error }, add_up);
                *largest = largest.max(error);
            }
            Ok(())
        })?;
        Ok(largest)
    }
}

/// Bounds of the linearisation error of each output by the two automatic splits.
fn automatic_errors(
    f: &dyn DynFunction,
    expanded: &Expanded<'_>,
    frame: &Parallelotope,
    p: &[Interval],
) -> Result<Vec<(f64, f64)>, BoundError> {
    let (m, n) = (f.outputs(), frame.center.len());
    let mut jet = Jet::new();
    evaluate(f, Order::Hessian, &frame.hull(), p, &mut jet)?;
    BoundError::check_smooth(&jet, Smoothness::C2)?;
    let (mut convex, mut concave) = (Vec::with_capacity(m * n), Vec::with_capacity(m * n));
    for packed in jet.hessians().chunks_exact((n * (n + 1) / 2).max(1)) {
        let hessian = rotated(packed, frame);
        for j in 0..n {
            let radius = |k: usize| frame.sides[k].mag();
            // Coordinates in units of their sides; one that does not move has no curvature.
            let coupling = (0..n)
                .filter(|&k| k != j && radius(k) > 0.0 && radius(j) > 0.0)
                .fold(0.0, |sum, k| add_up(sum, div_up(mul_up(hessian[j * n + k].mag(), radius(k)), radius(j))));
            let moves = radius(j) > 0.0;
            let steep = |curvature: f64| if moves { add_up(coupling, curvature).max(0.0) } else { 0.0 };
            convex.push(steep(-hessian[j * n + j].lo()));
            concave.push(steep(hessian[j * n + j].hi()));
        }
    }
    let bowl = |curvatures: &[f64], i: usize| {
        let terms = curvatures[i * n..(i + 1) * n].iter().zip(&frame.sides);
        terms.fold(0.0, |sum, (&q, side)| add_up(sum, mul_up(mul_up(0.5, q), side.sqr().hi())))
    };
    let above = expanded.largest_error(frame, 1.0, &convex)?;
    let below = expanded.largest_error(frame, -1.0, &concave)?;
    Ok((0..m).map(|i| (-below[i].min(bowl(&convex, i)), above[i].min(bowl(&concave, i)))).collect())
}

/// `V'HV` with `V` the axes of the frame, row by row.
fn rotated(packed: &[Interval], frame: &Parallelotope) -> Vec<Interval> {
    let n = frame.center.len();
    let mut hessian = vec![Interval::ZERO; n * n];
    let mut entries = packed.iter();
    for j in 0..n {
        for k in j..n {
            let entry = entries.next().copied().unwrap_or(Interval::ENTIRE);
            (hessian[j * n + k], hessian[k * n + j]) = (entry, entry);
        }
    }
    let mut half = vec![Interval::ZERO; n * n];
    for i in 0..n {
        for j in 0..n {
            half[i * n + j] = (0..n).fold(Interval::ZERO, |sum, k| sum + hessian[i * n + k] * frame.axis(k, j));
        }
    }
    let mut rotated = vec![Interval::ZERO; n * n];
    for i in 0..n {
        for j in 0..n {
            rotated[i * n + j] = (0..n).fold(Interval::ZERO, |sum, k| sum + frame.axis(k, i) * half[k * n + j]);
        }
    }
    rotated
}

/// `-x`.
fn opposite(x: &[f64]) -> Vec<f64> {
    x.iter().map(|x| -x).collect()
}

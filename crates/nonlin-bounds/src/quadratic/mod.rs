//! [`QuadraticEnclosure`]: an affine enclosure and the quadratic term of Taylor's theorem in the coordinates of a set.

mod parts;
mod products;

pub(crate) use parts::Parts;
pub(crate) use products::is_model_size;

use scalars::Interval;
use scalars::rounding::add_up;
use setrep::ConstrainedZonotope;

use crate::function::evaluate;
use crate::{AffineEnclosure, BoundError, Domain, DynFunction, GeneratorSet, Operand, Order, Smoothness, Workspace};

/// Which coordinates the term `2 L G xi` of Lemma 2 depends on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Copies {
    /// Those of the set: the term joins the linear part, and costs nothing.
    Shared,
    /// A second copy, as the paper has it: wider, and one generator and constraint more for each of the set.
    Separate,
}

/// Taylor's theorem of first order on a set `Z = c + G xi`, `A xi in [b]`, in the hull `H`, with its quadratic term as a set of its own:
/// `f(z)` lies in `J (z - gamma) + [e] + K` for every `z` in `Z` and `H`.
///
/// `z - gamma = p + G xi` with `p = c - gamma`, so the quadratic term `(z - gamma)' Q (z - gamma)`, `Q = f''(H) / 2` symmetric, is
/// `p'Q p + 2 p'Q G xi + xi'(G'Q G) xi`. In the last one `xi_i^2 = (1 + zeta_i) / 2` and the products `xi_i xi_j` become new coordinates in
/// `[-1, 1]`: `K = { sum_i q_ii zeta_i / 2 + sum_{i<j} 2 q_ij zeta_ij }` with the midpoints of `G'Q G`, whose radii widen `[e]`. Products of
/// pairs of constraints hold in the new coordinates, `(A_r xi)(A_s xi) in [b_r][b_s]`.
///
/// At most `ng (ng + 1) / 2` generators and `nc (nc + 1) / 2` constraints are added. Against [`Form::Taylor`](crate::Form::Taylor), which
/// adds none, this keeps the shape of a curved image and what the constraints cut off from it; for a set near a box the other
/// is as tight.
///
/// **Source:** paper 003, Lemma 2, Propositions 2 and 4, Corollary 2; for zonotopes Combastel 2005. The paper prints `L = p'Q` with `Q`
/// upper triangular, which is false unless `p = 0` or `Q` is diagonal; here `Q` is symmetric.
#[derive(Debug, Clone, PartialEq)]
pub struct QuadraticEnclosure {
    affine: AffineEnclosure,
    curvature: ConstrainedZonotope,
    /// The range of each output over the box.
    ranges: Vec<Interval>,
}

impl QuadraticEnclosure {
    /// Encloses `f` on a set that lies in the box of `domain`, which should be its interval hull.
    ///
    /// **Guarantee:** `f(z, p)` lies in `J (z - gamma) + [e] + K` for every `z` in the set and the box; remainder and rounding included.
    ///
    /// # Errors
    /// Sizes, an empty or unbounded box, [`BoundError::NotSmooth`] unless every output is proven `C2` on the box,
    /// [`BoundError::UnboundedResult`], and what `f` reports.
    pub fn new<S: GeneratorSet>(
        f: &dyn DynFunction,
        set: &S,
        domain: &Domain<'_>,
        copies: Copies,
        workspace: &mut Workspace,
    ) -> Result<Self, BoundError> {
        let mut enclosure = Self::unknown(f.outputs())?;
        enclosure.renew(f, set, domain, copies, workspace)?;
        Ok(enclosure)
    }

    /// An enclosure of nothing, to be [renewed](Self::renew_for) for a function with so many outputs.
    ///
    /// # Errors
    /// [`BoundError::Set`] for no outputs.
    pub fn unknown(outputs: usize) -> Result<Self, BoundError> {
        let curvature = ConstrainedZonotope::from_box(&vec![0.0; outputs], &vec![0.0; outputs])?;
        Ok(Self { affine: AffineEnclosure::new(), curvature, ranges: Vec::new() })
    }

    /// [`new`](Self::new) in place; allocates nothing within the capacity of enclosure and workspace.
    ///
    /// # Errors
    /// As [`new`](Self::new); the enclosure is then unchanged.
    pub fn renew<S: GeneratorSet>(
        &mut self,
        f: &dyn DynFunction,
        set: &S,
        domain: &Domain<'_>,
        copies: Copies,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        self.renew_for(|_| true, f, set, (domain, copies), workspace)
    }

    /// [`renew`](Self::renew) for the outputs that are `wanted`. The others need be neither smooth nor bounded, and nothing is known of them:
    /// their `[e]` is the whole line, so that there is no [`image`](Self::image), and [`intersect`](Self::intersect) takes no bounds on them.
    ///
    /// # Errors
    /// As [`new`](Self::new) for the outputs that are wanted; the enclosure is then unchanged.
    pub fn renew_for<S: GeneratorSet>(
        &mut self,
        wanted: impl Fn(usize) -> bool,
        f: &dyn DynFunction,
        set: &S,
        (domain, copies): (&Domain<'_>, Copies),
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        domain.check(f)?;
        BoundError::check_size(Operand::Variables, f.variables(), set.dim())?;
        domain.evaluate(f, Order::Hessian, workspace)?;
        let required = Smoothness::C2;
        let rough = |&(output, found): &(usize, Smoothness)| wanted(output) && found < required;
        if let Some((output, found)) = workspace.over_box.smoothness().iter().copied().enumerate().find(rough) {
            return Err(BoundError::NotSmooth { output, required, found });
        }
        workspace.point.clear();
        workspace.point.extend(domain.at.iter().map(|&x| Interval::point(x)));
        evaluate(f, Order::Jacobian, &workspace.point, domain.parameters, &mut workspace.at_point)?;
        let mut parts = core::mem::take(&mut workspace.quadratic);
        let result = self.build(&wanted, &mut parts, set, (domain, copies), workspace);
        workspace.quadratic = parts;
        result
    }

    /// The affine part: expansion point, box, `J` and `[e]`.
    #[must_use]
    pub fn affine(&self) -> &AffineEnclosure {
        &self.affine
    }

    /// The set `K`, about the origin of the outputs.
    #[must_use]
    pub fn curvature(&self) -> &ConstrainedZonotope {
        &self.curvature
    }

    /// Replaces `K` by its interval hull, if that is bounded: [`intersect`](Self::intersect) then appends a row an output and nothing else.
    ///
    /// What is lost is what `K` knows of several outputs together. For a measurement, whose rows speak of `K` and of the set, that is little; but
    /// with its generators the set has a column more for each of their pairs, of which a reduction can keep few.
    ///
    /// **Guarantee:** as before.
    ///
    /// # Errors
    /// [`BoundError::Set`]; the enclosure is then unchanged.
    pub fn box_curvature(&mut self, workspace: &mut Workspace) -> Result<(), BoundError> {
        let mut hull = core::mem::take(&mut workspace.offsets);
        hull.clear();
        hull.resize(self.curvature.dim(), Interval::EMPTY);
        let found = self.curvature.interval_hull_into(&mut hull, &mut workspace.sets);
        let Parts { zeros, kept, kept_rows, .. } = &mut workspace.quadratic;
        let result = found.and_then(|()| {
            // An empty set stays one. Sums of sides do not overflow, so that neither of the two calls below can fail.
            if !hull.iter().all(|side| !side.is_empty() && side.mag() < f64::MAX / 8.0) {
                return Ok(());
            }
            zeros.clear();
            zeros.resize(hull.len(), 0.0);
            kept.reset(hull.len(), 0);
            kept_rows.reset(0, 0);
            self.curvature.assign(zeros, kept, kept_rows, &[])?;
            self.curvature.add_box(&hull)
        });
        workspace.offsets = hull;
        Ok(result?)
    }

    /// Image of the set that the enclosure was made for: `J (X - gamma) + [e] + K`. A zonotope leaves the constraints of `K` out; it has
    /// none if it was made for a zonotope.
    ///
    /// **Guarantee:** superset of `{ f(z) : z in Z and H }`, rounding included.
    /// **Source:** paper 003, Proposition 2; for zonotopes Combastel 2005.
    ///
    /// # Errors
    /// As [`AffineEnclosure::image`].
    pub fn image<S: GeneratorSet>(&self, set: &S, workspace: &mut Workspace) -> Result<S, BoundError> {
        let mut image = set.clone();
        self.image_in_place(&mut image, workspace)?;
        Ok(image)
    }

    /// [`image`](Self::image) in place; allocates nothing within the capacity of set and workspace.
    ///
    /// # Errors
    /// As [`image`](Self::image); the set is then unchanged.
    pub fn image_in_place<S: GeneratorSet>(&self, set: &mut S, workspace: &mut Workspace) -> Result<(), BoundError> {
        BoundError::check_size(Operand::Variables, self.affine.variables(), set.dim())?;
        self.affine.image_plus(set, Some(&self.curvature), workspace)
    }

    /// Intersection of the set that the enclosure was made for with the solutions of `f(z) in Y`, `Y` a box:
    /// `{ z in Z : J z in Y - [e] - K + J gamma }` as a generalised intersection.
    ///
    /// Sides of `Y` may be unbounded. An output without any bound gives no row; one with a bound on one side is bounded by its range over the
    /// box on the other. The first constraints appended are those of `K`, the last one row for each output that is left, in order.
    ///
    /// Noises are among the variables: stack their set with the states', cut the product, and project it afterwards. Where they act along
    /// axes, the set of the states alone is cut (the first variables): the others then range over their sides of the box, without generators.
    ///
    /// **Guarantee:** superset of `{ z in Z and H : f(z) in Y }`, or of its states.
    /// **Source:** paper 003, Proposition 4, Corollary 2, Remark 13.
    ///
    /// # Errors
    /// [`BoundError::Dimension`], [`BoundError::EmptyInterval`] for an empty side of `Y`, [`BoundError::UnboundedResult`],
    /// [`BoundError::Set`]; the set is then unchanged.
    pub fn intersect(
        &self,
        set: &mut ConstrainedZonotope,
        values: &[Interval],
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        let (states, m) = (set.dim(), self.affine.outputs());
        self.affine.check_solution(states, values.len())?;
        if let Some(index) = values.iter().position(Interval::is_empty) {
            return Err(BoundError::EmptyInterval { operand: Operand::Outputs, index });
        }
        let says = |i: usize| values[i] != Interval::ENTIRE;
        let kept = (0..m).filter(|&i| says(i)).count();
        if kept == 0 {
            return Ok(());
        }
        let bounds = |i: usize| says(i).then(|| bounded_by(values[i], self.ranges[i]));
        self.affine.shifts_into(bounds, states, states, workspace)?;
        let outputs = || (0..m).filter(|&i| says(i)).enumerate();
        let mut map = core::mem::take(&mut workspace.map);
        let mut other = workspace.constrained.take().unwrap_or_else(|| set.clone());
        let mut steps = || -> Result<(), BoundError> {
            other.clone_from(&self.curvature);
            map.reset(kept, m);
            outputs().for_each(|(row, i)| map[(row, i)] = -1.0);
            other.linear_map_in_place(&map, &mut workspace.sets)?;
            other.add_box(&workspace.offsets)?;
            map.reset(kept, states);
            for k in 0..states {
                outputs().for_each(|(row, i)| map[(row, k)] = self.affine.jacobian[(i, k)]);
            }
            Ok(set.intersect(&map, &other, &mut workspace.sets)?)
        };
        let result = steps();
        workspace.constrained = Some(other);
        workspace.map = map;
        result
    }

    /// Overwrites the enclosure, given the derivatives in the workspace.
    fn build<S: GeneratorSet>(
        &mut self,
        wanted: &dyn Fn(usize) -> bool,
        parts: &mut Parts,
        set: &S,
        (domain, copies): (&Domain<'_>, Copies),
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        let (body, constrained) = set.body();
        let (n, m) = (body.dim(), workspace.over_box.outputs());
        parts.split(body);
        let at = if copies == Copies::Shared { body.center() } else { domain.at };
        parts.boxes(domain, body.center());
        let count = parts.columns.cols();
        let pairs = count * (count + 1) / 2;
        // Without a cross term there is nothing to copy.
        let crossed = parts.shift.iter().any(|shift| *shift != Interval::ZERO);
        let copied = if copies == Copies::Separate && crossed { count } else { 0 };
        parts.generators.reset(m, pairs + copied);
        workspace.jacobian.reset(m, n);
        workspace.offsets.clear();
        let size = n * (n + 1) / 2;
        for i in 0..m {
            if !wanted(i) {
                workspace.offsets.push(Interval::ENTIRE);
                continue;
            }
            let hessian = &workspace.over_box.hessians()[i * size..(i + 1) * size];
            let gradient = &workspace.at_point.jacobian()[i * n..(i + 1) * n];
            parts.cross(hessian);
            let mut offset = workspace.at_point.values()[i];
            let mut error = parts.lost(hessian);
            for k in 0..n {
                // f'(gamma) (z - gamma) + L (p + 2 (z - c)), each factor by its midpoint and the rest over the box.
                let (slope, cross) = (midpoint(gradient[k]), midpoint(parts.cross[k]));
                offset += gradient[k].add_f64(-slope) * parts.steps[k];
                offset += parts.cross[k].add_f64(-cross) * (parts.shift[k] + parts.about_center[k].scale(2.0));
                offset += parts.shift[k].scale(cross);
                workspace.jacobian[(i, k)] = match copies {
                    Copies::Separate => slope,
                    Copies::Shared => {
                        let entry = slope + 2.0 * cross;
                        let rounding = Interval::point(slope).add_f64(2.0 * cross).add_f64(-entry);
                        offset += parts.shift[k].scale(slope) + rounding * parts.about_center[k];
                        entry
                    }
                };
            }
            if copied > 0 {
                error = add_up(error, parts.copy_cross(i, pairs));
            }
            let (center, radius) = parts.square(hessian, i);
            offset = (offset + center).inflate(add_up(error, radius));
            if !offset.is_bounded() {
                return Err(BoundError::UnboundedResult { output: i });
            }
            workspace.offsets.push(offset);
        }
        parts.products(constrained, count, copied);
        parts.drop_zero_columns(m);
        parts.zeros.clear();
        parts.zeros.resize(m, 0.0);
        self.curvature.assign(&parts.zeros, &parts.kept, &parts.kept_rows, &parts.ranges)?;
        self.affine.at.clear();
        self.affine.at.extend_from_slice(at);
        self.affine.hull.clear();
        self.affine.hull.extend_from_slice(domain.hull);
        self.ranges.clear();
        self.ranges.extend_from_slice(workspace.over_box.values());
        core::mem::swap(&mut self.affine.jacobian, &mut workspace.jacobian);
        core::mem::swap(&mut self.affine.offsets, &mut workspace.offsets);
        Ok(())
    }
}

/// A value with its unbounded sides replaced by those of a range, where it reaches as far.
fn bounded_by(value: Interval, range: Interval) -> Interval {
    let lo = if value.lo() == f64::NEG_INFINITY { range.lo().min(value.hi()) } else { value.lo() };
    let hi = if value.hi() == f64::INFINITY { range.hi().max(value.lo()) } else { value.hi() };
    Interval::new(lo, hi).unwrap_or(value)
}

/// A midpoint; 0 for what is unbounded.
fn midpoint(x: Interval) -> f64 {
    if x.is_bounded() { x.mid() } else { 0.0 }
}

//! Images of zonotopes and constrained zonotopes by affine enclosures: the mean value, slope and Taylor extensions.

use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, SetError};

use super::GeneratorSet;
use crate::{AffineEnclosure, BoundError, Domain, DynFunction, Expansion, Form, Operand, Workspace};

impl AffineEnclosure {
    /// Image of the part of a set in the box `H` under the function that is enclosed: `J (X - gamma) + [e]`.
    ///
    /// The set may have fewer dimensions than the function has variables. The others are then noises that range over their sides of the
    /// box, and `J_w (H_w - gamma_w)` joins `[e]`: right for noises that act along axes. Noises that mix axes keep their shape if they are
    /// stacked with the set ([`cartesian_product`](setrep::Zonotope::cartesian_product)).
    ///
    /// The generators of the set are mapped, none is added: the width of `[e]` goes to the box remainder. The `P B` of the paper is
    /// that remainder after [`materialize`](setrep::Zonotope::materialize).
    ///
    /// **Guarantee:** superset of `{ f(x, w) : x in X, (x, w) in H }`, rounding included.
    /// **Source:** paper 003, Proposition 1 (mean value) with the hull in place of Theorem 1's elimination; paper 001, Fact 2.3.
    ///
    /// # Errors
    /// [`BoundError::Dimension`], [`BoundError::UnboundedResult`] if an offset has no finite bounds, [`BoundError::Set`].
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
        self.image_plus(set, None, workspace)
    }

    /// The image, and the sum with another set.
    pub(crate) fn image_plus<S: GeneratorSet>(
        &self,
        set: &mut S,
        other: Option<&ConstrainedZonotope>,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        let n = set.dim();
        if n > self.variables() {
            return Err(BoundError::Dimension { operand: Operand::Variables, expected: self.variables(), found: n });
        }
        workspace.offsets.clear();
        workspace.offsets.extend_from_slice(&self.offsets);
        for (k, column) in self.jacobian.columns().enumerate().skip(n) {
            let step = self.hull[k].add_f64(-self.at[k]);
            for (offset, &j) in workspace.offsets.iter_mut().zip(column) {
                *offset += step.scale(j);
            }
        }
        if let Some(output) = workspace.offsets.iter().position(|e| !e.is_bounded()) {
            return Err(BoundError::UnboundedResult { output });
        }
        let mut map = core::mem::take(&mut workspace.map);
        let mut draft = S::draft(workspace).take().unwrap_or_else(|| set.clone());
        draft.clone_from(set);
        let result = self
            .steps(&mut draft, &mut map, workspace)
            .and_then(|()| other.map_or(Ok(()), |other| Ok(draft.add_set(other)?)));
        if result.is_ok() {
            core::mem::swap(set, &mut draft);
        }
        *S::draft(workspace) = Some(draft);
        workspace.map = map;
        result
    }

    /// The steps of [`image_in_place`](Self::image_in_place), given the offsets in the workspace.
    fn steps<S: GeneratorSet>(
        &self,
        set: &mut S,
        map: &mut Matrix,
        workspace: &mut Workspace,
    ) -> Result<(), BoundError> {
        let (m, n) = (self.outputs(), set.dim());
        workspace.row.clear();
        workspace.row.extend(self.at[..n].iter().map(|x| -x));
        set.shift(&workspace.row)?;
        if n == self.variables() {
            set.map(&self.jacobian, &mut workspace.sets)?;
        } else {
            map.assign_column_slice(m, n, &self.jacobian.as_slice()[..m * n])?;
            set.map(map, &mut workspace.sets)?;
        }
        Ok(set.add_sides(&workspace.offsets)?)
    }
}

/// Image of a set under a function in one of the forms of [`Form`], over the interval hull of the set.
///
/// To enclose several times over one hull, to name noises, or to allocate nothing, use [`AffineEnclosure`].
///
/// **Guarantee:** superset of `{ f(x, p) : x in X }` for every `p` in the parameters, remainder and rounding included.
///
/// # Errors
/// As [`AffineEnclosure::enclose`] and [`AffineEnclosure::image`]; [`SetError::EmptySet`] if the set is proven empty.
///
/// ```
/// use nonlin_bounds::{Expansion, Form, Function, Workspace, affine_image};
/// use scalars::Scalar;
/// use setrep::ConstrainedZonotope;
///
/// struct Product;
/// impl Function for Product {
///     const VARIABLES: Option<usize> = Some(2);
///     fn outputs(&self) -> usize { 1 }
///     fn eval<S: Scalar>(&self, x: &[S], _p: &[S], y: &mut [S]) { y[0] = x[0] * x[1]; }
/// }
/// let set = ConstrainedZonotope::from_box(&[2.0, 3.0], &[0.5, 0.5])?;
/// let mut workspace = Workspace::new();
/// let image = affine_image(Form::Taylor, &Product, &set, Expansion::HullCenter, &[], &mut workspace)?;
/// let range = image.interval_hull(&mut workspace.sets)?;
/// assert!(range[0].contains(1.5 * 2.5) && range[0].contains(2.5 * 3.5) && range[0].width() < 5.5 + 1e-12);
/// # Ok::<(), nonlin_bounds::BoundError>(())
/// ```
pub fn affine_image<S: GeneratorSet>(
    form: Form,
    f: &dyn DynFunction,
    set: &S,
    at: Expansion<'_>,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<S, BoundError> {
    enclose_over_hull(form, f, set, at, p, workspace)?.image(set, workspace)
}

/// Encloses a function over the interval hull of a set.
pub(crate) fn enclose_over_hull<S: GeneratorSet>(
    form: Form,
    f: &dyn DynFunction,
    set: &S,
    at: Expansion<'_>,
    p: &[Interval],
    workspace: &mut Workspace,
) -> Result<AffineEnclosure, BoundError> {
    let mut hull = vec![Interval::EMPTY; set.dim()];
    set.hull_into(&mut hull, &mut workspace.sets)?;
    if hull.iter().any(Interval::is_empty) {
        return Err(SetError::EmptySet.into());
    }
    let mut point = vec![0.0; set.dim()];
    set.expand(&at, &hull, workspace, &mut point)?;
    let mut enclosure = AffineEnclosure::new();
    enclosure.enclose(form, f, &Domain::new(&hull, &point).with_parameters(p), workspace)?;
    Ok(enclosure)
}

//! The methods that are compared, by name and set form.

use nonlin_bounds::{
    AffineEnclosure, BoundError, ConvexSplit, Copies, Domain, DynFunction, Expansion, Form as Affine,
    QuadraticEnclosure, RangeMethod, Workspace, affine_image, dc_image, dc_image_of_zonotope, decomposition_image,
    decomposition_image_of_zonotope, decomposition_solution, polytopic_image, polytopic_solution,
    polytopic_solution_lift, range,
};
use scalars::Interval;
use setrep::{HPolytope, IntervalVector};

use super::enclosure::Enclosure;
use super::sets::{Form, Sets};

/// A way to enclose an image or a solution set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The range over the hull: all range methods intersected.
    Range,
    /// An affine enclosure in one of its forms.
    Affine(Affine),
    /// Taylor with the quadratic term as a set.
    Quadratic,
    /// Remainder-form decomposition in the coordinates of the generators.
    Decomposition,
    /// DC programming with the automatic split.
    Dc,
    /// Boxes around the vertices' images; for solutions, cuts of the vertices' hull row by row.
    Polytopic,
    /// The simplex over the vertices with all rows.
    Lift,
}

impl Method {
    /// Methods for images of a form.
    #[must_use]
    pub fn of_images(form: Form) -> &'static [Self] {
        match form {
            Form::Vertices => &[Self::Polytopic],
            Form::Zonotope | Form::Constrained => &[
                Self::Range,
                Self::Affine(Affine::Natural),
                Self::Affine(Affine::MeanValue),
                Self::Affine(Affine::Slope),
                Self::Affine(Affine::Taylor),
                Self::Quadratic,
                Self::Decomposition,
                Self::Dc,
            ],
        }
    }

    /// Methods for solution sets in a form.
    #[must_use]
    pub fn of_solutions(form: Form) -> &'static [Self] {
        match form {
            Form::Zonotope => &[],
            Form::Constrained => &[
                Self::Affine(Affine::Natural),
                Self::Affine(Affine::MeanValue),
                Self::Affine(Affine::Slope),
                Self::Affine(Affine::Taylor),
                Self::Quadratic,
                Self::Decomposition,
            ],
            Form::Vertices => &[Self::Polytopic, Self::Lift],
        }
    }

    /// The name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Range => "range",
            Self::Affine(Affine::Natural) => "natural",
            Self::Affine(Affine::MeanValue) => "mean value",
            Self::Affine(Affine::Slope) => "slope",
            Self::Affine(Affine::Taylor) => "taylor",
            Self::Quadratic => "quadratic",
            Self::Decomposition => "decomposition",
            Self::Dc => "dc",
            Self::Polytopic => "polytopic",
            Self::Lift => "simplex lift",
        }
    }

    /// Encloses the image of the set in its form.
    ///
    /// # Errors
    /// Those of the method.
    pub fn image(
        self,
        f: &dyn DynFunction,
        sets: &Sets,
        form: Form,
        workspace: &mut Workspace,
    ) -> Result<Enclosure, BoundError> {
        let hull = hull(sets, form, workspace)?;
        let at = hull.mid();
        let domain = Domain::new(&hull, &at);
        Ok(match (self, form) {
            (Self::Range, _) => {
                let mut sides = vec![Interval::ZERO; f.outputs()];
                range(f, &hull, &[], RangeMethod::Tight, workspace, &mut sides)?;
                Enclosure::Box(IntervalVector::new(sides))
            }
            (_, Form::Vertices) => {
                Enclosure::Vertices(polytopic_image(f, &sets.vertices, Expansion::HullCenter, &[], workspace)?)
            }
            (Self::Affine(affine), Form::Zonotope) => {
                Enclosure::Zonotope(affine_image(affine, f, &sets.zonotope, Expansion::HullCenter, &[], workspace)?)
            }
            (Self::Affine(affine), Form::Constrained) => Enclosure::Constrained(affine_image(
                affine,
                f,
                &sets.constrained,
                Expansion::HullCenter,
                &[],
                workspace,
            )?),
            (Self::Quadratic, Form::Zonotope) => {
                let quadratic = QuadraticEnclosure::new(f, &sets.zonotope, &domain, Copies::Shared, workspace)?;
                Enclosure::Zonotope(quadratic.image(&sets.zonotope, workspace)?)
            }
            (Self::Quadratic, Form::Constrained) => {
                let quadratic = QuadraticEnclosure::new(f, &sets.constrained, &domain, Copies::Shared, workspace)?;
                Enclosure::Constrained(quadratic.image(&sets.constrained, workspace)?)
            }
            (Self::Dc, Form::Zonotope) => {
                Enclosure::Zonotope(dc_image_of_zonotope(&ConvexSplit::Automatic(f), &sets.zonotope, &[], workspace)?)
            }
            (Self::Dc, Form::Constrained) => {
                Enclosure::Constrained(dc_image(&ConvexSplit::Automatic(f), &sets.constrained, &[], workspace)?)
            }
            (_, Form::Zonotope) => {
                Enclosure::Zonotope(decomposition_image_of_zonotope(f, &sets.zonotope, &[], workspace)?)
            }
            (_, Form::Constrained) => {
                Enclosure::Constrained(decomposition_image(f, &sets.constrained, &[], workspace)?)
            }
        })
    }

    /// Encloses the members of the set in its form whose value lies in the box `y`.
    ///
    /// # Errors
    /// Those of the method.
    pub fn solution(
        self,
        g: &dyn DynFunction,
        sets: &Sets,
        form: Form,
        y: &[Interval],
        workspace: &mut Workspace,
    ) -> Result<Enclosure, BoundError> {
        let hull = hull(sets, form, workspace)?;
        let at = hull.mid();
        let domain = Domain::new(&hull, &at);
        Ok(match self {
            Self::Affine(affine) => {
                let (mut enclosure, mut set) = (AffineEnclosure::new(), sets.constrained.clone());
                enclosure.enclose(affine, g, &domain, workspace)?;
                enclosure.intersect(&mut set, y, workspace)?;
                Enclosure::Constrained(set)
            }
            Self::Quadratic => {
                let mut set = sets.constrained.clone();
                let quadratic = QuadraticEnclosure::new(g, &set, &domain, Copies::Shared, workspace)?;
                quadratic.intersect(&mut set, y, workspace)?;
                Enclosure::Constrained(set)
            }
            Self::Decomposition | Self::Range | Self::Dc => {
                Enclosure::Constrained(decomposition_solution(g, &sets.constrained, y, &[], workspace)?)
            }
            Self::Polytopic => {
                let y = HPolytope::from_intervals(y)?;
                Enclosure::Vertices(polytopic_solution(g, &sets.vertices, &y, Expansion::HullCenter, &[], workspace)?)
            }
            Self::Lift => {
                let y = HPolytope::from_intervals(y)?;
                Enclosure::Constrained(polytopic_solution_lift(
                    g,
                    &sets.vertices,
                    &y,
                    Expansion::HullCenter,
                    &[],
                    workspace,
                )?)
            }
        })
    }
}

/// The method with the form of its sets.
#[must_use]
pub fn method_name(method: Method, form: Form) -> String {
    format!("{}/{}", method.name(), form.name())
}

fn hull(sets: &Sets, form: Form, workspace: &mut Workspace) -> Result<IntervalVector, BoundError> {
    Ok(match form {
        Form::Zonotope => sets.zonotope.interval_hull(),
        Form::Constrained => sets.constrained.interval_hull(&mut workspace.sets)?,
        Form::Vertices => sets.vertices.interval_hull(),
    })
}

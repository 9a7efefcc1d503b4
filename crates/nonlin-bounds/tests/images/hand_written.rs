//! Functions by hand whose jets are short, empty or left from another call: typed errors, no panic, nothing proven by what is missing.

use nonlin_bounds::{
    AffineEnclosure, BoundError, ConvexSplit, Copies, Domain, DynFunction, Expansion, Form, IntervalNewton, Jet, Order,
    QuadraticEnclosure, RangeMethod, Smoothness, Workspace, affine_image, dc_image, decomposition_image,
    decomposition_solution, function, polytopic_image, polytopic_solution, polytopic_solution_lift, range,
};
use scalars::Interval;
use setrep::{ConstrainedZonotope, HPolytope, Matrix, VPolytope};

/// What [`Careless`] leaves out of its jet.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Missing {
    /// Everything: the jet is not touched.
    Jet,
    /// Outputs, with what is proven of them.
    Outputs,
    /// One output of two.
    Output,
    /// One variable of two.
    Variable,
    /// The derivatives.
    Derivatives,
}

/// `(x y, x + y)` by a careless author.
struct Careless(Missing);

impl DynFunction for Careless {
    fn variables(&self) -> usize {
        2
    }
    fn parameters(&self) -> usize {
        0
    }
    fn outputs(&self) -> usize {
        2
    }
    fn value(&self, x: &[f64], _: &[f64], y: &mut [f64]) -> Result<(), BoundError> {
        (y[0], y[1]) = (x[0] * x[1], x[0] + x[1]);
        Ok(())
    }
    fn enclose(&self, order: Order, x: &[Interval], _: &[Interval], jet: &mut Jet) -> Result<(), BoundError> {
        match self.0 {
            Missing::Jet => return Ok(()),
            Missing::Outputs => jet.reset(order, 2, 0),
            Missing::Output => jet.reset(order, 2, 1),
            Missing::Variable => jet.reset(order, 1, 2),
            Missing::Derivatives => jet.reset(Order::Value, 2, 2),
        }
        let (values, _, _, smoothness) = jet.parts_mut();
        values.iter_mut().zip([x[0] * x[1], x[0] + x[1]]).for_each(|(value, range)| *value = range);
        smoothness.fill(Smoothness::C2);
        Ok(())
    }
}

/// Every entry point, by name, with the workspace that it finds.
fn errors(f: &dyn DynFunction, warm: impl Fn() -> Workspace) -> Vec<(&'static str, Option<BoundError>)> {
    let unit = [Interval::new(-1.0, 1.0).unwrap(); 2];
    let set = ConstrainedZonotope::from_box(&[0.0; 2], &[1.0; 2]).unwrap();
    let polytope = VPolytope::from_intervals(&unit).unwrap();
    let y = HPolytope::from_intervals(&[Interval::new(0.25, 0.5).unwrap(); 2]).unwrap();
    let (at, domain) = (Expansion::HullCenter, Domain::new(&unit, &[0.0; 2]));
    let mut results = Vec::new();
    for (name, method) in [
        ("mean value range", RangeMethod::MeanValue),
        ("slope range", RangeMethod::Slope),
        ("second-order range", RangeMethod::SecondOrder),
        ("mixed-monotone range", RangeMethod::MixedMonotone),
        ("tight range", RangeMethod::Tight),
    ] {
        let mut bounds = [Interval::ZERO; 2];
        results.push((name, range(f, &unit, &[], method, &mut warm(), &mut bounds).err()));
    }
    for form in [Form::Natural, Form::MeanValue, Form::Slope, Form::Taylor] {
        results.push(("affine", affine_image(form, f, &set, at, &[], &mut warm()).err()));
    }
    let mut enclosure = AffineEnclosure::new();
    let possible = enclosure.enclose_where_possible(f, &domain, &mut warm());
    // Without any bound it is an answer: rows that say nothing.
    let says_nothing = possible.is_ok() && enclosure.offsets() == [Interval::ENTIRE; 2];
    results
        .push(("where possible", possible.err().or(says_nothing.then_some(BoundError::UnboundedResult { output: 0 }))));
    results.push(("quadratic", QuadraticEnclosure::new(f, &set, &domain, Copies::Shared, &mut warm()).err()));
    results.push(("decomposition", decomposition_image(f, &set, &[], &mut warm()).err()));
    results.push(("decomposition", decomposition_solution(f, &set, &unit, &[], &mut warm()).err()));
    results.push(("dc", dc_image(&ConvexSplit::Automatic(f), &set, &[], &mut warm()).err()));
    results.push(("dc", dc_image(&ConvexSplit::Given { plus: f, minus: f }, &set, &[], &mut warm()).err()));
    results.push(("polytopic", polytopic_image(f, &polytope, at, &[], &mut warm()).err()));
    results.push(("polytopic", polytopic_solution(f, &polytope, &y, at, &[], &mut warm()).err()));
    results.push(("lift", polytopic_solution_lift(f, &polytope, &y, at, &[], &mut warm()).err()));
    let newton = IntervalNewton::default().contract(f, &mut unit.clone(), &[], &unit, &mut warm());
    results.push(("newton", newton.err()));
    results
}

/// A workspace whose jets hold what another function of the same shape has proven.
fn warm() -> Workspace {
    let product = function!(|[x, y]: 2| -> 2 { [x * y, x + y] });
    let mut workspace = Workspace::new();
    let unit = [Interval::new(-1.0, 1.0).unwrap(); 2];
    let set = ConstrainedZonotope::from_box(&[0.0; 2], &[1.0; 2]).unwrap();
    range(&product, &unit, &[], RangeMethod::Tight, &mut workspace, &mut [Interval::ZERO; 2]).unwrap();
    affine_image(Form::Taylor, &product, &set, Expansion::HullCenter, &[], &mut workspace).unwrap();
    let polytope = VPolytope::from_intervals(&unit).unwrap();
    polytopic_image(&product, &polytope, Expansion::HullCenter, &[], &mut workspace).unwrap();
    let _ = IntervalNewton::default().contract(&product, &mut unit.clone(), &[], &unit, &mut workspace).unwrap();
    workspace
}

#[test]
fn what_is_missing_is_an_error() {
    for missing in [Missing::Jet, Missing::Outputs, Missing::Output, Missing::Variable, Missing::Derivatives] {
        for (name, error) in errors(&Careless(missing), warm) {
            let Some(error) = error else { panic!("{name} takes a jet without {missing:?}") };
            match missing {
                Missing::Jet => {
                    let typed = matches!(error, BoundError::NotSmooth { .. } | BoundError::UnboundedResult { .. });
                    assert!(typed, "{name} {missing:?}: {error}");
                }
                _ => assert!(matches!(error, BoundError::Dimension { .. }), "{name} {missing:?}: {error}"),
            }
        }
    }
}

/// `x^2` whose author bounds it on `[-1/2, 1/2]` and, with derivatives, on all boxes.
struct Within;

impl DynFunction for Within {
    fn variables(&self) -> usize {
        1
    }
    fn parameters(&self) -> usize {
        0
    }
    fn outputs(&self) -> usize {
        1
    }
    fn value(&self, x: &[f64], _: &[f64], y: &mut [f64]) -> Result<(), BoundError> {
        y[0] = x[0] * x[0];
        Ok(())
    }
    fn enclose(&self, order: Order, x: &[Interval], p: &[Interval], jet: &mut Jet) -> Result<(), BoundError> {
        if order == Order::Value && x[0].mag() > 0.75 {
            return Err(BoundError::NoAPrioriEnclosure { step: 1.0 });
        }
        function!(|[x]: 1| -> 1 { [x.sqr()] }).enclose(order, x, p, jet)
    }
}

/// The generators reach from -2 to 2, the set from -1/2 to 1/2: a corner outside of it costs a row and no more.
#[test]
fn an_error_outside_of_a_constrained_set_costs_a_row() {
    let sum = Matrix::from_rows(&[&[1.0, 1.0]]).unwrap();
    let half = Interval::new(-0.5, 0.5).unwrap();
    let set = ConstrainedZonotope::new(&[0.0], &sum, &sum, &[half]).unwrap();
    let mut w = Workspace::new();
    let image = decomposition_image(&Within, &set, &[], &mut w).unwrap();
    assert!(image.interval_hull(&mut w.sets).unwrap()[0].width() < 0.26);
}

//! Reverse mode against forward mode: two enclosures of the same derivatives.

use allocation_counter::measure;
use nonlin_bounds::{BoundError, DynFunction, Function, Jet, Operand, Order, Smoothness, Tape, Workspace};
use scalars::{Interval, Scalar};

use crate::common::functions::{Attitude, Domain, Visitor, each};
use crate::common::random::{Random, cases};
use crate::recording::function;

const SEED: u64 = 77;

#[derive(Default)]
struct Compare {
    forward: Jet,
    backward: Jet,
    at_point: Jet,
    workspace: Workspace,
}

impl Visitor for Compare {
    fn visit<F: Function + 'static>(&mut self, function: F, domain: Domain) {
        let (tape, name) = (Tape::record(&function), domain.name);
        let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p)).collect();
        let (mut width, mut forward_width) = (0.0, 0.0);
        for case in 0..cases(300) {
            let mut random = Random::new(SEED, case);
            let x = random.subbox(&domain.center, &domain.radius);
            let point: Vec<Interval> = random.point(&x).into_iter().map(Interval::point).collect();
            tape.enclose(Order::Jacobian, &x, &p, &mut self.forward).unwrap();
            function.enclose(Order::Jacobian, &point, &p, &mut self.at_point).unwrap();
            tape.enclose_backward(&x, &p, &mut self.backward, &mut self.workspace).unwrap();
            let context = || format!("{name}, seed {SEED}, case {case}");
            assert_eq!(self.backward.values(), self.forward.values(), "{}", context());
            assert_eq!(self.backward.smoothness(), self.forward.smoothness(), "{}", context());
            let entries = self.backward.jacobian().iter().zip(self.forward.jacobian()).zip(self.at_point.jacobian());
            for ((&backward, &forward), &exact) in entries {
                // Proven disjoint from what encloses the derivative at a point of the box: a violation.
                assert!(!backward.disjoint(&exact) && !backward.disjoint(&forward), "{}", context());
                assert_eq!(forward == Interval::ZERO, backward == Interval::ZERO, "{}", context());
                width += backward.width();
                forward_width += forward.width();
            }
        }
        println!("{name}: width of the Jacobian {:.4} of that of forward mode", width / forward_width);
        assert!(width < 1.5 * forward_width || width < 1e-9, "{name}: {width} {forward_width}");
    }
}

#[test]
fn agrees_with_forward_mode() {
    each(&mut Compare::default());
}

#[test]
fn what_is_not_smooth_has_no_derivative() {
    function!(Rough, 3, |x, y| {
        y[0] = x[0].sqrt() + x[1] * x[1];
        y[1] = x[1].abs();
        y[2] = (x[0].exp() / x[0].exp()).atan2(x[0].exp());
    });
    let tape = Tape::record(&Rough);
    let (mut jet, mut workspace) = (Jet::new(), Workspace::new());
    let x = [Interval::new(0.0, 1.0).unwrap(), Interval::new(-1.0, 2.0).unwrap()];
    tape.enclose_backward(&x, &[], &mut jet, &mut workspace).unwrap();
    assert_eq!(jet.smoothness()[..2], [Smoothness::C0; 2]);
    let entire = Interval::ENTIRE;
    assert_eq!(jet.jacobian()[..4], [entire, entire, Interval::ZERO, entire]);
    // Both operands of the quotient are the same slot: d atan2(1, e^x) / dx = -e^x / (1 + e^2x).
    let point = [Interval::ONE; 2];
    tape.enclose_backward(&point, &[], &mut jet, &mut workspace).unwrap();
    let slope = -1.0_f64.exp() / (1.0 + 2.0_f64.exp());
    assert!(jet.jacobian()[4].inflate(1e-14).contains(slope) && jet.jacobian()[4].width() < 1e-13);
}

/// An output may be a variable, a parameter, a constant, or the operand of another output.
#[test]
fn outputs_may_be_any_slot() {
    function!(Slots, 4, |x, y| {
        y[0] = x[1];
        y[1] = S::pi();
        y[2] = x[0].sqr();
        y[3] = x[0].sqr() * x[1];
    });
    let (mut jet, mut workspace) = (Jet::new(), Workspace::new());
    let x = [3.0, 2.0].map(Interval::point);
    Tape::record(&Slots).enclose_backward(&x, &[], &mut jet, &mut workspace).unwrap();
    let mids: Vec<f64> = jet.jacobian().iter().map(Interval::mid).collect();
    assert_eq!(mids, [0.0, 1.0, 0.0, 0.0, 6.0, 0.0, 12.0, 9.0]);
    assert!(jet.jacobian().iter().all(|j| j.width() < 1e-13));
}

#[test]
fn bad_input_and_memory() {
    let (tape, mut jet, mut workspace) = (Tape::record(&Attitude), Jet::new(), Workspace::new());
    let (x, p) = ([Interval::new(0.1, 0.2).unwrap(); 7], [Interval::ONE; 3]);
    let result = tape.enclose_backward(&x[..6], &p, &mut jet, &mut workspace);
    assert_eq!(result, Err(BoundError::Dimension { operand: Operand::Variables, expected: 7, found: 6 }));
    let result = tape.enclose_backward(&x, &[Interval::ENTIRE; 3], &mut jet, &mut workspace);
    assert_eq!(result, Err(BoundError::NonFinite { operand: Operand::Parameters, index: 0 }));
    let mut run = || tape.enclose_backward(&x, &p, &mut jet, &mut workspace).is_ok();
    assert!(run());
    assert_eq!(measure(|| assert!(run())).count_total, 0);
}

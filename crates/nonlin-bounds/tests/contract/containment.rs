//! The twelve example functions: both contractors keep every solution they are shown, and shrink the boxes.

use nonlin_bounds::{Contraction, ForwardBackward, Function, IntervalNewton, Tape, Workspace};
use scalars::Interval;

use crate::common::functions::{Domain, Visitor, each};
use crate::common::random::{Random, cases};

const SEED: u64 = 47;

#[derive(Default)]
struct Keep {
    workspace: Workspace,
    checked: usize,
}

impl Visitor for Keep {
    fn visit<F: Function + 'static>(&mut self, function: F, domain: Domain) {
        let tape = Tape::record(&function);
        let (mut forward_backward, mut newton) = (0.0, 0.0);
        let count = cases(2500);
        for case in 0..count {
            let mut random = Random::new(SEED, case);
            let start = random.subbox(&domain.center, &domain.radius);
            let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p).inflate(1e-4)).collect();
            let point = random.point(&start);
            // Values at an exact point, for exact parameters of their box.
            let x: Vec<Interval> = point.iter().map(|&x| Interval::point(x)).collect();
            let q: Vec<Interval> = random.point(&p).iter().map(|&p| Interval::point(p)).collect();
            let mut y = vec![Interval::ZERO; function.outputs()];
            function.eval(&x, &q, &mut y);
            if random.below(2) == 0 {
                y.iter_mut().for_each(|y| *y = y.inflate(1e-3 * random.fraction()));
            }
            let mut boxes = [start.clone(), start.clone()];
            let outcomes = [
                ForwardBackward::default().contract(&tape, &mut boxes[0], &p, &y, &mut self.workspace),
                IntervalNewton::default().contract(&function, &mut boxes[1], &p, &y, &mut self.workspace),
            ];
            for (outcome, x) in outcomes.into_iter().zip(&boxes) {
                let kept = x.iter().zip(&point).all(|(x, &point)| x.contains(point));
                let name = domain.name;
                assert!(
                    kept && !matches!(outcome, Ok(Contraction::ProvenEmpty(_)) | Err(_)),
                    "{name}, seed {SEED}, case {case}: {outcome:?}, {point:?} not in {x:?} from {start:?}"
                );
                self.checked += 1;
            }
            forward_backward += size(&boxes[0]) / size(&start) / count as f64;
            newton += size(&boxes[1]) / size(&start) / count as f64;
        }
        println!("{}: mean width left {forward_backward:.3}, Newton {newton:.3}", domain.name);
        assert!(forward_backward < 1.0 && newton < 1.0);
    }
}

/// Sum of the widths.
fn size(x: &[Interval]) -> f64 {
    x.iter().map(Interval::width).sum::<f64>().max(f64::MIN_POSITIVE)
}

#[test]
fn solutions_stay() {
    let mut keep = Keep::default();
    each(&mut keep);
    assert!(keep.checked >= 50_000.min(cases(50_000)));
}

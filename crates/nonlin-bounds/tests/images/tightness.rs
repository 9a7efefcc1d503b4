//! Sizes against sampled images, as bands: too small is a violation, too large a loss that containment does not see.

use nonlin_bounds::{
    Copies, Domain, DynFunction, Expansion, Form, Function, QuadraticEnclosure, Workspace, affine_image,
};
use scalars::Interval;
use setrep::{ConstrainedZonotope, Matrix, Zonotope};

use crate::common::functions::{self, Visitor, each};
use crate::sets::random::Random;

/// Ratios of the widths of the images' hulls to those of samples: one list a method.
struct Widths {
    size: f64,
    ratios: [Vec<f64>; 5],
}

/// Hull width of a set's image over the width of its samples, the mean over the outputs that are not affine.
impl Visitor for Widths {
    fn visit<F: Function + 'static>(&mut self, f: F, domain: functions::Domain) {
        let n = domain.center.len();
        // Some of the elementary functions are constant, written so that no enclosure knows.
        if n > 6 || domain.name == "elementary functions" {
            return;
        }
        let mut random = Random::new(11, n);
        let mut w = Workspace::new();
        let mut g = Matrix::zeros(n, n + 1);
        for j in 0..=n {
            for k in 0..n {
                let share = if j == k { 0.7 } else { 0.3 * random.moderate() / n as f64 };
                g[(k, j)] = self.size * domain.radius[k] * share;
            }
        }
        let set = ConstrainedZonotope::from(Zonotope::new(&domain.center, &g).unwrap());
        let p: Vec<Interval> = domain.parameters.iter().map(|&p| Interval::point(p)).collect();
        let mut samples = vec![Interval::EMPTY; DynFunction::outputs(&f)];
        let mut y = vec![0.0; samples.len()];
        for _ in 0..20_000 {
            let xi = random.cube(n + 1);
            let x: Vec<f64> =
                (0..n).map(|k| domain.center[k] + (0..=n).map(|j| g[(k, j)] * xi[j]).sum::<f64>()).collect();
            f.value(&x, &domain.parameters, &mut y).unwrap();
            samples.iter_mut().zip(&y).for_each(|(range, &y)| *range = range.hull(Interval::point(y)));
        }
        let mut record = |method: usize, image: &ConstrainedZonotope, w: &mut Workspace| {
            let hull = image.interval_hull(&mut w.sets).unwrap();
            for (side, sample) in hull.iter().zip(&samples) {
                self.ratios[method].push(side.width() / sample.width());
            }
        };
        for (k, form) in [Form::Natural, Form::MeanValue, Form::Slope, Form::Taylor].into_iter().enumerate() {
            let image = affine_image(form, &f, &set, Expansion::HullCenter, &p, &mut w).unwrap();
            record(k, &image, &mut w);
        }
        let hull = set.interval_hull(&mut w.sets).unwrap();
        let domain = Domain::new(&hull, &domain.center).with_parameters(&p);
        let quadratic = QuadraticEnclosure::new(&f, &set, &domain, Copies::Shared, &mut w).unwrap();
        record(4, &quadratic.image(&set, &mut w).unwrap(), &mut w);
    }
}

#[test]
fn images_are_as_tight_as_their_order_says() {
    // Size of the sets as a share of the functions' boxes; upper ends of the mean ratios of natural, mean value, slope, Taylor and
    // quadratic images.
    for (size, bands) in [(0.03, [4.2, 1.09, 1.035, 1.025, 1.025]), (0.3, [4.2, 1.8, 1.5, 1.4, 1.4])] {
        let mut widths = Widths { size, ratios: Default::default() };
        each(&mut widths);
        let mean = |ratios: &Vec<f64>| ratios.iter().sum::<f64>() / ratios.len() as f64;
        let means: Vec<f64> = widths.ratios.iter().map(mean).collect();
        assert!(widths.ratios.iter().flatten().all(|&ratio| ratio >= 1.0), "smaller than its samples");
        assert!(means.iter().zip(bands).all(|(mean, band)| *mean <= band), "{means:?} above {bands:?}");
        // Taylor is at most as wide as the slope form, and that as the mean value form, about the middle of the hull.
        assert!(means[3] <= means[2] * (1.0 + 1e-9) && means[2] <= means[1], "{means:?}");
    }
}

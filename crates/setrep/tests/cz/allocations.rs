//! What a filter step asks of its sets allocates nothing once the buffers have grown.

use allocation_counter::measure;
use scalars::Interval;
use setrep::{
    Complexity, ConstrainedZonotope, Directions, Matrix, Reduction, Reencoding, TemplateWidths, Workspace, Zonotope,
};

use crate::common::random::Random;

#[test]
fn a_warm_step_allocates_nothing() {
    let mut random = Random::new(5, 0);
    let mut matrix = |rows: usize, cols: usize| {
        let entries: Vec<f64> = (0..rows * cols).map(|_| 0.3 * random.moderate()).collect();
        Matrix::from_column_slice(rows, cols, &entries).unwrap()
    };
    let (n, m, rows) = (4, 12, 5);
    let (body, a) = (Zonotope::new(&[0.0; 4], &matrix(n, m)).unwrap(), matrix(rows, m));
    let band = Interval::point(0.0).inflate(0.125);
    let start = ConstrainedZonotope::with_constraints(&body, &a, &[band; 5]).unwrap();
    let noise = ConstrainedZonotope::from(Zonotope::new(&[0.0; 4], &matrix(n, 3)).unwrap());
    let (map, c) = (matrix(n, n), matrix(2, n));
    let (mut set, mut hull, mut workspace) = (start.clone(), vec![Interval::ZERO; n], Workspace::new());
    let mut reduced = start.clone();
    let mut directions = Directions::new(n);
    let mut step = || {
        set.clone_from(&start);
        set.linear_map_in_place(&map, &mut workspace).unwrap();
        set.add_assign(&noise).unwrap();
        set.intersect_rows(&c, &[band; 2], &mut workspace).unwrap();
        for method in [Reduction::Method4, Reduction::Girard, Reduction::Combastel, Reduction::Pca] {
            reduced.clone_from(&set);
            reduced.reduce(Complexity { generators: 9, constraints: 4 }, method, &mut workspace).unwrap();
            reduced.clone_from(&set);
            let limit = Complexity { generators: 9, constraints: 2 };
            reduced.reduce_comparing(limit, method, 3, &mut workspace).unwrap();
        }
        directions.transport(&map, &mut workspace).unwrap();
        directions.push_rows(&c).unwrap();
        reduced.clone_from(&set);
        for widths in [TemplateWidths::SingleRows, TemplateWidths::LinearPrograms] {
            let options = Reencoding { widths, ..Reencoding::new(6) };
            reduced.reencode(options, &mut directions, &mut workspace).unwrap();
        }
        set.interval_hull_into(&mut hull, &mut workspace).unwrap();
        set.support(&[1.0, 2.0, 3.0, 4.0], &mut workspace).unwrap() + hull[0].hi()
    };
    let expected: f64 = (0..20).map(|_| step()).sum();
    let mut sum = 0.0;
    let count = measure(|| (0..20).for_each(|_| sum += step()));
    assert!(expected.is_finite() && sum.is_finite());
    assert_eq!(count.count_total, 0);
}

//! What a filter step does to its sets allocates nothing once the buffers have grown.

use allocation_counter::measure;
use setrep::{Matrix, Reduction, Workspace, Zonotope};

use crate::common::random::Random;

fn steps(n: usize, method: Reduction) {
    let mut random = Random::new(5, n);
    let mut entries = || 0.3 * random.moderate();
    let map = Matrix::from_column_slice(n, n, &(0..n * n).map(|_| entries()).collect::<Vec<_>>()).unwrap();
    let noise = Matrix::from_column_slice(n, 5, &(0..n * 5).map(|_| entries()).collect::<Vec<_>>()).unwrap();
    let generators = Matrix::from_column_slice(n, 20, &(0..n * 20).map(|_| entries()).collect::<Vec<_>>()).unwrap();
    let disturbance = Zonotope::with_remainder(&vec![0.1; n], &noise, &vec![0.01; n]).unwrap();
    let mut set = Zonotope::new(&vec![1.0; n], &generators).unwrap();
    let (mut backup, mut hull) = (set.clone(), set.interval_hull());
    let (mut workspace, mut covariation, direction) = (Workspace::new(), Matrix::zeros(n, n), vec![1.0; n]);
    let mut step = || {
        backup.clone_from(&set);
        set.linear_map_in_place(&map, &mut workspace).unwrap();
        set.add_assign(&disturbance).unwrap();
        set.append_generators(&noise).unwrap();
        set.translate(&direction).unwrap();
        set.reduce(method, 20, &mut workspace).unwrap();
        set.interval_hull_into(&mut hull).unwrap();
        set.covariation_into(&mut covariation);
        set.support(&direction).unwrap() + set.f_radius()
    };
    for _ in 0..50 {
        step();
    }
    let mut sum = 0.0;
    let count = measure(|| (0..50).for_each(|_| sum += step()));
    assert!(sum.is_finite());
    assert_eq!(count.count_total, 0, "{method:?} in dimension {n}");
}

#[test]
fn a_warm_step_allocates_nothing() {
    for method in [Reduction::Combastel, Reduction::Girard, Reduction::Pca, Reduction::Method4] {
        for n in [2, 3, 4, 7] {
            steps(n, method);
        }
    }
}

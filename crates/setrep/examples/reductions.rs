//! What each order reduction makes of one set: generators, area, hull, and an outline for a plot.
//!
//! `cargo run --release -p setrep --example reductions`

use setrep::{Matrix, Reduction, SetError, Workspace, Zonotope};

fn main() -> Result<(), SetError> {
    // A short history: a set that turns, shrinks, and collects noise along one direction.
    let mut workspace = Workspace::new();
    let turn = Matrix::from_rows(&[&[0.9, -0.3], &[0.3, 0.9]])?;
    let noise = Matrix::from_columns(&[&[0.2, 0.05]])?;
    let mut set = Zonotope::new(&[1.0, 2.0], &Matrix::identity(2))?;
    for _ in 0..12 {
        set.linear_map_in_place(&turn, &mut workspace)?;
        set.append_generators(&noise)?;
    }
    let area = set.volume()?;
    println!("the set: {} generators, area {area}, hull {:?}", set.num_generators(), set.interval_hull());

    for method in [Reduction::Combastel, Reduction::Girard, Reduction::Pca, Reduction::Method4] {
        let mut reduced = set.clone();
        reduced.reduce(method, 4, &mut workspace)?;
        println!(
            "{method:?}: {} generators, area x {:.4}, radius x {:.4}, remainder {:?}",
            reduced.num_generators(),
            reduced.volume()?.mid() / area.mid(),
            reduced.radius() / set.radius(),
            reduced.remainder(),
        );
        println!("  outline {:.2?}", reduced.outline_2d(0, 1)?);
    }
    Ok(())
}

//! Meshes in space.

use std::collections::BTreeSet;

use setrep::{ConstrainedZonotope, IntervalVector, Matrix, Mesh, SetError, VPolytope, Workspace, Zonotope};

use crate::common::dyadic::Dyadic;
use crate::common::exact::member;
use crate::common::random::{Random, cases};
use crate::{SEED, cut_at_a_member};

/// Whether the point fulfils the outer half-spaces, exactly.
fn lies_in_outer(mesh: &Mesh, x: [&Dyadic; 3]) -> bool {
    (0..mesh.outer.num_half_spaces()).all(|i| {
        let mut sum = -Dyadic::from(mesh.outer.offsets()[i]);
        (0..3).for_each(|k| sum += &(&Dyadic::from(mesh.outer.normals()[(i, k)]) * x[k]));
        sum.sign().is_le()
    })
}

/// Signed volume: positive if the triangles are counterclockwise from outside.
fn volume(mesh: &Mesh) -> f64 {
    let origin = mesh.vertices[0];
    let det = |t: &[usize; 3]| {
        let [a, b, c]: [[f64; 3]; 3] = t.map(|k| core::array::from_fn(|i| mesh.vertices[k][i] - origin[i]));
        a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    };
    mesh.triangles.iter().map(|t| det(t) / 6.0).sum()
}

/// Every directed edge once, and its opposite: closed and oriented; and a sphere by Euler's count.
fn assert_closed(mesh: &Mesh, context: &str) {
    let edges: Vec<(usize, usize)> = mesh.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]).collect();
    let unique: BTreeSet<(usize, usize)> = edges.iter().copied().collect();
    assert_eq!(unique.len(), edges.len(), "{context}");
    assert!(unique.iter().all(|&(a, b)| unique.contains(&(b, a))), "{context}");
    assert_eq!(mesh.vertices.len() + mesh.triangles.len(), edges.len() / 2 + 2, "{context}");
}

#[test]
fn meshes_are_closed_and_hold_every_member() {
    let mut workspace = Workspace::new();
    let mut solid = 0;
    for case in 0..cases(250) {
        let mut random = Random::new(SEED + 2, case);
        let (n, m) = (random.between(3, 4), random.between(1, 7));
        let body = random.set(n, m);
        let (cut, inside) = cut_at_a_member(&mut random, &body);
        let axes = [n - 1, 0, 1];
        let context = || format!("seed {SEED}+2 case {case}: {cut:?}");
        let whole = Mesh::new(&body, axes, &mut workspace).unwrap();
        let part = Mesh::new(&cut, axes, &mut workspace).unwrap();
        for _ in 0..10 {
            let x = member(&body, &mut random).x;
            assert!(lies_in_outer(&whole, axes.map(|k| &x[k])), "{}", context());
        }
        assert!(lies_in_outer(&part, axes.map(|k| &inside.x[k])), "{}", context());
        if whole.triangles.len() > 2 && whole.outer.num_half_spaces() == whole.triangles.len() {
            solid += 1;
            assert_closed(&whole, &context());
            assert!(volume(&whole) > 0.0, "{}", context());
        }
    }
    assert!(2 * solid > cases(250), "{solid}");
}

/// Volumes agree with the exact ones, and the gap is rounding.
#[test]
fn meshes_are_as_large_as_the_set() {
    let mut workspace = Workspace::new();
    for case in 0..cases(60) {
        let mut random = Random::new(SEED + 3, case);
        let m = random.between(3, 10);
        let data: Vec<f64> = (0..3 * m).map(|_| random.moderate()).collect();
        let set = Zonotope::new(&[1.0, -2.0, 0.5], &Matrix::from_column_slice(3, m, &data).unwrap()).unwrap();
        let mesh = Mesh::new(&set, [0, 1, 2], &mut workspace).unwrap();
        let exact = set.volume().unwrap().mid();
        assert!((volume(&mesh) / exact - 1.0).abs() < 1e-9, "case {case}: {} {exact}", volume(&mesh));
        // Facets are the pairs of generators: m (m - 1) of them, two triangles each.
        assert_eq!(mesh.triangles.len(), 2 * m * (m - 1), "case {case}");
        assert!(mesh.gap < 1e-9, "case {case}: {}", mesh.gap);
        assert_closed(&mesh, "generic");
    }
}

/// A cube without its corners, cut by eight half-spaces: the cuboctahedron.
#[test]
fn a_cuboctahedron() {
    let mut workspace = Workspace::new();
    let mut set = ConstrainedZonotope::from_box(&[0.0; 3], &[1.0; 3]).unwrap();
    for signs in 0..8_u32 {
        let normal: [f64; 3] = core::array::from_fn(|k| if signs >> k & 1 == 1 { 1.0 } else { -1.0 });
        set.intersect_half_space(&normal, 2.0, &mut workspace).unwrap();
    }
    let mesh = Mesh::new(&set, [0, 1, 2], &mut workspace).unwrap();
    assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (12, 20));
    assert!((volume(&mesh) - 20.0 / 3.0).abs() < 1e-10 && mesh.gap < 1e-10, "{} {}", volume(&mesh), mesh.gap);
    assert_closed(&mesh, "cuboctahedron");
}

#[test]
fn points_segments_and_flat_sets() {
    let mut workspace = Workspace::new();
    let point = IntervalVector::point(&[0.1, 1e6, 0.0]);
    let mesh = Mesh::new(&point, [0, 1, 2], &mut workspace).unwrap();
    assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (1, 0));
    assert!(mesh.gap < 1e-8);
    let segment = Zonotope::new(&[1.0, 2.0, 3.0], &Matrix::from_columns(&[&[0.3, 0.1, -0.7]]).unwrap()).unwrap();
    let mesh = Mesh::new(&segment, [0, 1, 2], &mut workspace).unwrap();
    assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (2, 0), "{mesh:?}");
    assert!(mesh.gap < 1e-11, "{}", mesh.gap);
    // Slanted, along the axes, and by a constraint: a parallelogram has two triangles a side.
    let slanted = Matrix::from_columns(&[&[0.3, 0.1, -0.7], &[0.2, 1.0, 0.4]]).unwrap();
    let along = Matrix::from_columns(&[&[0.0, 2.0, 0.0], &[0.0, 0.0, 0.5]]).unwrap();
    for generators in [slanted, along] {
        let flat = Zonotope::new(&[1.0, 2.0, 3.0], &generators).unwrap();
        let mesh = Mesh::new(&flat, [0, 1, 2], &mut workspace).unwrap();
        assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (4, 4), "{mesh:?}");
        assert!(mesh.gap < 1e-11, "{}", mesh.gap);
    }
    let mut hexagon = ConstrainedZonotope::from_box(&[0.0; 3], &[1.0; 3]).unwrap();
    hexagon.intersect_strip(&[1.0, 1.0, 1.0], scalars::Interval::ZERO, &mut workspace).unwrap();
    let mesh = Mesh::new(&hexagon, [0, 1, 2], &mut workspace).unwrap();
    assert_eq!((mesh.vertices.len(), mesh.triangles.len()), (6, 8), "{mesh:?}");
    assert!(mesh.gap < 1e-10, "{}", mesh.gap);
}

#[test]
fn what_has_no_mesh_is_refused() {
    let mut workspace = Workspace::new();
    let cube = VPolytope::from_intervals(&IntervalVector::from_center(&[0.0; 3], &[1.0; 3]).unwrap()).unwrap();
    assert_eq!(Mesh::new(&cube, [2, 1, 0], &mut workspace).unwrap().triangles.len(), 12);
    for axes in [[0, 1, 3], [0, 1, 0]] {
        assert!(matches!(Mesh::new(&cube, axes, &mut workspace), Err(SetError::Dimension { .. })));
    }
    let mut nothing = ConstrainedZonotope::from_box(&[0.0; 3], &[1.0; 3]).unwrap();
    nothing.intersect_half_space(&[1.0, 1.0, 1.0], -4.0, &mut workspace).unwrap();
    assert_eq!(Mesh::new(&nothing, [0, 1, 2], &mut workspace), Err(SetError::EmptySet));
}

//! The stored sets of the peer comparison: exact hulls and supports, the ladder of nearly empty sets, a witness point.

use scalars::Interval;
use serde_json::Value;
use setrep::{ConstrainedZonotope, Emptiness, IntervalVector, Matrix, Membership, Workspace};

/// The file of that name under `$ORBITOPE_DATA/peers/data`, if the variable is set.
fn stored(name: &str) -> Option<Value> {
    let Ok(root) = std::env::var("ORBITOPE_DATA") else {
        eprintln!("skipped: set ORBITOPE_DATA to the folder that holds peers/data/{name}");
        return None;
    };
    let text = std::fs::read_to_string(format!("{root}/peers/data/{name}")).unwrap();
    Some(serde_json::from_str(&text).unwrap())
}

fn vector(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn matrix(value: &Value) -> Matrix {
    let rows: Vec<Vec<f64>> = value.as_array().unwrap().iter().map(vector).collect();
    Matrix::from_rows(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>()).unwrap()
}

fn set(value: &Value, b: &Value) -> ConstrainedZonotope {
    let (c, g, a) = (vector(&value["c"]), matrix(&value["G"]), matrix(&value["A"]));
    ConstrainedZonotope::from_cg_rep(&c, &g, &a, &vector(b)).unwrap()
}

/// Compares a hull with the stored one: it contains it (up to the stored one's own accuracy) and exceeds it by little.
fn check_hull(hull: &[Interval], lo: &[f64], hi: &[f64], own: f64, excess: f64, what: &str) {
    for (side, (lo, hi)) in hull.iter().zip(lo.iter().zip(hi)) {
        let width = hi - lo;
        let (below, above) = (lo - side.lo(), side.hi() - hi);
        assert!(below >= -own * width && above >= -own * width, "{what}: cut off, {below:e} {above:e} of {width}");
        assert!(below <= excess * width && above <= excess * width, "{what}: excess, {below:e} {above:e} of {width}");
    }
}

fn check(name: &str, excess: f64) {
    let Some(file) = stored(&format!("{name}.json")) else { return };
    let mut workspace = Workspace::new();
    for (k, instance) in file["instances"].as_array().unwrap().iter().enumerate() {
        // References in exact arithmetic are rounded to f64, those of an LP solver are right to its tolerance.
        let own = if instance["ref"] == "exact" { 1e-15 } else { excess };
        let z = set(instance, &instance["b"]);
        let what = format!("{name}[{k}]");
        let hull = z.interval_hull(&mut workspace).unwrap();
        check_hull(&hull, &vector(&instance["hull_lo"]), &vector(&instance["hull_hi"]), own, excess, &what);
        let supports = vector(&instance["support"]);
        for (d, h) in instance["dirs"].as_array().unwrap().iter().map(vector).zip(supports) {
            let width: f64 = hull.iter().zip(&d).map(|(side, d)| side.width() * d.abs()).sum();
            let above = z.support(&d, &mut workspace).unwrap() - h;
            assert!(above >= -own * width && above <= excess * width, "{what}: support off by {above:e}");
        }
        assert!(matches!(z.emptiness(&mut workspace).unwrap(), Emptiness::ProvenNonEmpty(_)), "{what}");
        // Points are stored rounded, and need not be exact members.
        let mut ask =
            |key: &str| z.membership(&IntervalVector::point(&vector(&instance[key])), &mut workspace).unwrap();
        assert_ne!(ask("point_in"), Membership::ProvenOutside, "{what}");
        assert_eq!(ask("point_out"), Membership::ProvenOutside, "{what}");
        let inter = &instance["ops"]["inter"];
        if let (Some(_), Some(lo)) = (inter.get("G"), instance["ops"].get("inter_hull_lo")) {
            let mut both = z.clone();
            let other = set(inter, &inter["b"]);
            let map = matrix(&inter["C"]);
            both.intersect(&map, &other, &mut workspace).unwrap();
            let hull = both.interval_hull(&mut workspace).unwrap();
            let hi = vector(&instance["ops"]["inter_hull_hi"]);
            check_hull(&hull, &vector(lo), &hi, own, excess, &format!("{what} intersection"));
        }
    }
    let ladder = &file["empty_ladder"];
    for case in ladder["cases"].as_array().unwrap() {
        let (gap, empty) = (case["gap"].as_f64().unwrap(), case["empty"].as_bool().unwrap());
        let z = set(ladder, &case["b"]);
        let verdict = z.emptiness(&mut workspace).unwrap();
        match &verdict {
            Emptiness::ProvenEmpty(proof) => assert!(empty && proof.verify(&z), "{name}: false empty at gap {gap}"),
            Emptiness::ProvenNonEmpty(_) => assert!(!empty, "{name}: false non-empty at gap {gap}"),
            _ => assert!(gap.abs() < 1e-6, "{name}: undecided at gap {gap}"),
        }
    }
}

#[test]
fn two_dimensions() {
    check("cz_n2_g8_c3", 1e-10);
}

#[test]
fn four_dimensions() {
    check("cz_n4_g12_c5", 1e-10);
}

#[test]
fn ten_dimensions() {
    check("cz_n10_g40_c10", 1e-8);
}

#[test]
fn twenty_dimensions() {
    check("cz_n20_g200_c40", 1e-8);
}

/// A point of the set that another library's box leaves out lies in ours.
#[test]
fn the_witness_point_is_inside() {
    let (Some(file), Some(witness)) = (stored("cz_n2_g8_c3.json"), stored("zonoopt_box_witness.json")) else { return };
    let instance = &file["instances"][3];
    let hull = set(instance, &instance["b"]).interval_hull(&mut Workspace::new()).unwrap();
    assert!(hull.contains(&vector(&witness["x"])));
}

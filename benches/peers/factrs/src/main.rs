//! The group operations of `lie-groups` against `sophus_lie` and `factrs`, interleaved in one run: `cargo run --release [NAME..]`.

#[path = "../../../src/draw.rs"]
#[allow(dead_code, reason = "the groups use a part of it")]
mod draw;
#[path = "../../../src/groups.rs"]
mod groups;
#[path = "../../../src/timing.rs"]
#[allow(dead_code, reason = "the groups use a part of it")]
mod timing;

use factrs::linalg::VectorX;
use factrs::variables::{MatrixLieGroup, Variable};
use groups::{Ours, each, pairs, versus};
use lie_groups::{LieGroup, SE2, SE3, SE23};
use timing::{Bench, Budget};

/// The rows of one group: our type, the peer's, the kinds of the coordinates. The peer has no Jacobians.
macro_rules! against_factrs {
    ($name:literal, $ours:ty, $peer:ty, $kinds:literal) => {{
        type Peer = $peer;
        let ours = Ours::<$ours, { $kinds.len() }>::new($kinds);
        let peer_xis: Vec<VectorX> = ours.xis.iter().map(|xi| VectorX::from_column_slice(xi.as_slice())).collect();
        let peers: Vec<Peer> = peer_xis.iter().map(|xi| <Peer as Variable>::exp(xi.as_view())).collect();
        let row = |what: &str, ours, theirs| versus(&format!("{}/{what}", $name), "factrs", ours, theirs);
        let mut rows = vec![
            row("exp", ours.on_xis(<$ours>::exp), each(peer_xis, |xi| <Peer as Variable>::exp(xi.as_view()))),
            row("log", ours.on_elements(<$ours>::log), each(peers.clone(), Variable::log)),
            row("compose", ours.on_pairs(|(a, b)| a.compose(b)), each(pairs(&peers), |(a, b)| Variable::compose(a, b))),
            row("inverse", ours.on_elements(<$ours>::inverse), each(peers.clone(), Variable::inverse)),
        ];
        // The adjoint of its SE2 indexes out of bounds (factrs 0.3.0).
        if $name != "se2" {
            rows.push(row("adjoint", ours.on_elements(<$ours>::adjoint), each(peers, |x| MatrixLieGroup::adjoint(x))));
        }
        rows
    }};
}

fn all() -> Vec<Bench> {
    let mut rows = groups::benches();
    rows.extend(against_factrs!("se2", SE2<f64>, factrs::variables::SE2, "rxx"));
    rows.extend(against_factrs!("se3", SE3<f64>, factrs::variables::SE3, "wwwxxx"));
    rows.extend(against_factrs!("se23", SE23<f64>, factrs::variables::SE23, "wwwxxxxxx"));
    let space = Ours::<SE23<f64>, 9>::new("wwwxxxxxx");
    let pose = Ours::<SE3<f64>, 6>::new("wwwxxx");
    rows.push(versus("se23/jl", "our SE3", space.on_xis(SE23::jl), pose.on_xis(SE3::jl)));
    rows.push(versus("se23/jl-inv", "our SE3", space.on_xis(SE23::jl_inv), pose.on_xis(SE3::jl_inv)));
    rows
}

fn main() {
    let names: Vec<String> = std::env::args().skip(1).collect();
    println!("{:<20} {:>10}  {:<12} {:>10} {:>8}", "name", "ours ns", "peer", "peer ns", "ratio");
    for mut bench in all() {
        if names.is_empty() || names.iter().any(|name| bench.name.starts_with(name.as_str())) {
            let row = bench.run(Budget::default());
            println!(
                "{:<20} {:>10.2}  {:<12} {:>10.2} {:>8.3}",
                row.name, row.ours_ns, row.peer, row.peer_ns, row.ratio
            );
        }
    }
    println!("ratio = peer / ours, both timed in alternating windows of this run");
}

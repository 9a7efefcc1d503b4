//! The filters of paper 004 go on from a state that was stored as text as if nothing had happened, bit for bit.

use estimators::{DCz, DCzOptions, DZb, DZbOptions, Vh, VhOptions};

use crate::plants::{Draw, planar};
use crate::saved_states::goes_on_to_the_bit;
use crate::support::Random;

#[test]
fn filters_on_polytopes_and_decompositions() {
    let example = planar(3.0);
    let run: Vec<_> =
        example.run(Draw::Uniform, 7, &mut Random::new(93)).into_iter().map(|(_, y)| (y, Vec::new())).collect();
    for options in [VhOptions::paper(), VhOptions::tight()] {
        goes_on_to_the_bit(|o| Vh::new(example.system.clone(), example.vertices(), o).unwrap(), options, &run);
    }
    let make = |o| DCz::new(example.system.clone(), example.start.clone().into(), o).unwrap();
    goes_on_to_the_bit(make, DCzOptions::new(2), &run);
    let make = |o| DZb::new(example.system.clone(), example.start.clone().into(), o).unwrap();
    goes_on_to_the_bit(make, DZbOptions::new(2), &run);
}

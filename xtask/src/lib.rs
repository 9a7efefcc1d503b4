//! What the project's commands share: `cargo xtask` and the program behind `cargo xtask reproduce`.

mod process;

pub use process::{DATA_VARIABLE, cargo, cargo_program, data_folder, exit, root, succeed};

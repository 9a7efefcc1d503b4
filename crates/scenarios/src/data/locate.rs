//! Finding a data file below the folder the user named.

use std::path::{Path, PathBuf};

/// The first existing file `stem.<ending>` in `root/data/<set>`, `root/<set>` or `root`, endings in the given order.
///
/// So the folder may be a collection of data sets, the `data` folder itself, or the folder of the one set.
#[must_use]
pub fn locate(root: &Path, set: &str, stem: &str, endings: &[&str]) -> Option<PathBuf> {
    let folders = [root.join("data").join(set), root.join(set), root.to_path_buf()];
    let files =
        folders.iter().flat_map(|folder| endings.iter().map(move |ending| folder.join(format!("{stem}.{ending}"))));
    files.into_iter().find(|file| file.is_file())
}

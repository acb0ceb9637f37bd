//! Place of the checkout, for all chores.

use std::path::{Path, PathBuf};

/// Path in the checkout, from its top. The checkout is the one in which cargo was called, not necessarily the one that
/// compiled this: two of them may share a target folder.
///
/// # Panics
/// If no folder above the manifest of the chore has a `rust-toolchain.toml`.
#[must_use]
pub fn checkout(path: &str) -> PathBuf {
    let package = std::env::var_os("CARGO_MANIFEST_DIR")
        .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from);
    let top = package.ancestors().find(|folder| folder.join("rust-toolchain.toml").exists());
    let top = top.map(Path::to_owned).expect("chores lie in the checkout");
    if path.is_empty() { top } else { top.join(path) }
}

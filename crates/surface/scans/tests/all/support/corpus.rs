//! Inputs that fuzzing starts from: small synthetic files, in `fuzz/corpus`.

use std::path::{Path, PathBuf};

/// Set this variable to have the inputs written anew.
const WRITE: &str = "WRITE_FUZZ_CORPUS";

/// Bytes to which the fuzzer cuts inputs.
const MOST_BYTES: usize = 8192;

fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../fuzz/corpus")
}

/// Asserts that an input lies in its folder and is small; writes it where that is asked for.
pub fn keep(folder: &str, name: &str, bytes: &[u8]) {
    let path = corpus().join(folder).join(name);
    if std::env::var_os(WRITE).is_some() {
        std::fs::create_dir_all(corpus().join(folder)).unwrap();
        std::fs::write(&path, bytes).unwrap();
    }
    assert!(path.exists(), "{} is missing; set {WRITE}=1 to write it", path.display());
    assert!(bytes.len() <= MOST_BYTES, "{folder}/{name} has {} bytes", bytes.len());
}

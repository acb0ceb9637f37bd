//! Reference of the Python package, from its signatures and docstrings.

use std::path::Path;
use std::process::Command;

/// Reads the sources of the package with Python's own parser and returns the page.
pub(super) fn page(root: &Path) -> Result<String, Box<dyn std::error::Error>> {
    let python = std::env::var_os("PYTHON").unwrap_or_else(|| "python3".into());
    let output = Command::new(python)
        .args(["-c", include_str!("python_reference.py")])
        .arg(root.join("python/package/truearea"))
        .output()
        .map_err(|error| format!("running python3: {error}"))?;
    if output.status.success() {
        Ok(String::from_utf8(output.stdout)?)
    } else {
        Err(format!("the reference of Python: {}", String::from_utf8_lossy(&output.stderr)).into())
    }
}

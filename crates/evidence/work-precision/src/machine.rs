//! Machine and versions of a measurement.

use std::path::PathBuf;
use std::process::Command;

/// Line of the report: name and value.
pub type Fact = (String, String);

/// Date, processor, compiler and the state of the sources; nothing that identifies a single machine.
pub fn facts() -> Vec<Fact> {
    let dirty = said("git", &["status", "--porcelain", "--untracked-files=no", "--", "crates"]);
    let changed = if dirty.as_deref().is_some_and(|text| !text.is_empty()) { ", changed" } else { "" };
    let commit = said("git", &["rev-parse", "--short", "HEAD"]).map(|commit| commit + changed);
    [
        ("date", said("date", &["-u", "+%Y-%m-%d"])),
        ("processor", std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| processor(&text))),
        ("rustc", said("rustc", &["--version"]).map(|text| text.replace("rustc ", ""))),
        ("truearea", Some(commit.map_or_else(String::new, |commit| format!("commit {commit}")))),
    ]
    .into_iter()
    .map(|(name, value)| (name.to_owned(), value.unwrap_or_else(|| "unknown".to_owned())))
    .collect()
}

/// Path of this program, which scripts call.
///
/// # Errors
/// The message of the system.
pub fn own_program() -> Result<PathBuf, String> {
    std::env::current_exe().map_err(|error| error.to_string())
}

fn said(program: &str, arguments: &[&str]) -> Option<String> {
    let output =
        Command::new(program).args(arguments).output().ok().filter(|output| output.status.success())?;
    Some(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

fn processor(cpuinfo: &str) -> Option<String> {
    let line = cpuinfo.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.split_whitespace().collect::<Vec<_>>().join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_processor_is_named_without_its_padding() {
        let text = "processor\t: 0\nmodel name\t: Some(R) Maker  9000 @ 2.50GHz\nmodel name\t: other\n";
        assert_eq!(processor(text).unwrap(), "Some(R) Maker 9000 @ 2.50GHz");
        assert_eq!(processor("nothing"), None);
    }
}

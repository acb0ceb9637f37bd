//! Instruction counts of the main kernels and of the whole paper, compared with the accepted ones.
//!
//! Instructions do not depend on the load of the machine, so that they can be a gate where times cannot. The profile
//! is the one that tests are built with.

use std::collections::BTreeMap;
use std::io;
use std::process::{Command, ExitCode, Output};

use xtask::checkout;

/// Growth of a count from which it fails, as a share of the accepted one.
const MOST_GROWTH: f64 = 0.05;
/// Growth of the count of a piece whose input is ten times as large where that does not matter.
const MOST_GROWTH_TENFOLD: f64 = 0.1;
/// End of the name of such a piece; what precedes it names the piece that it repeats.
const TENFOLD: &str = "-tenfold";
/// Accepted counts, by piece of work.
const ACCEPTED: &str = "tests/instructions.csv";
const HEADER: &str = "work,instructions";

pub(crate) fn run(accept: bool) -> ExitCode {
    match compare(accept) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Counts every piece of work and prints it beside the accepted count; returns true if all stay within the bound.
fn compare(accept: bool) -> io::Result<bool> {
    build()?;
    let accepted = accepted()?;
    let (mut counts, mut within) = (Vec::new(), true);
    for work in pieces()? {
        let count = count(&work)?;
        let verdict = accepted.get(&work).map_or(Verdict::New, |&before| Verdict::moved(count, before));
        println!("{count:>13}  {work:32} {}", verdict.text());
        within &= verdict.is_within();
        counts.push((work, count));
    }
    let mut scales = true;
    for Growth { work, share } in growths_tenfold(&counts) {
        let is_within = share <= MOST_GROWTH_TENFOLD;
        let verdict = match is_within {
            true => String::new(),
            false => format!("  GROWN by more than {} %", 100.0 * MOST_GROWTH_TENFOLD),
        };
        println!("{:>13}  {work:32} {:+6.1} %{verdict}", "ten times", 100.0 * share);
        scales &= is_within;
    }
    if accept {
        let rows = counts.iter().map(|(work, count)| format!("{work},{count}\n"));
        std::fs::write(checkout(ACCEPTED), format!("{HEADER}\n{}", rows.collect::<String>()))?;
        println!("\naccepted in {ACCEPTED}");
        return Ok(scales);
    }
    if !within {
        println!(
            "\nsome work is not as accepted in {ACCEPTED}; where the cost has a reason, take it with \
             cargo xtask instructions --accept and give the reason in the commit"
        );
    }
    Ok(within && scales)
}

/// Growth of a piece of work with ten times the input.
struct Growth<'c> {
    work: &'c str,
    share: f64,
}

/// The growth of every piece that is also counted with ten times the input.
fn growths_tenfold(counts: &[(String, u64)]) -> Vec<Growth<'_>> {
    let growth = |(name, count): &(String, u64)| {
        let work = name.strip_suffix(TENFOLD)?;
        let (name, once) = counts.iter().find(|(other, _)| other == work)?;
        Some(Growth { work: name, share: *count as f64 / *once as f64 - 1.0 })
    };
    counts.iter().filter_map(growth).collect()
}

/// Comparison of a count with the accepted one.
enum Verdict {
    New,
    Moved { growth: f64 },
}

impl Verdict {
    fn moved(count: u64, before: u64) -> Self {
        Verdict::Moved { growth: count as f64 / before as f64 - 1.0 }
    }

    fn is_within(&self) -> bool {
        matches!(self, Verdict::Moved { growth } if *growth <= MOST_GROWTH)
    }

    fn text(&self) -> String {
        match self {
            Verdict::New => "NEW".to_owned(),
            Verdict::Moved { growth } if *growth > MOST_GROWTH => {
                format!("{:+6.1} %  GROWN by more than {} %", 100.0 * growth, 100.0 * MOST_GROWTH)
            }
            Verdict::Moved { growth } if *growth < -MOST_GROWTH => {
                format!("{:+6.1} %  less: accept it, so that it stays", 100.0 * growth)
            }
            Verdict::Moved { growth } => format!("{:+6.1} %", 100.0 * growth),
        }
    }
}

fn accepted() -> io::Result<BTreeMap<String, u64>> {
    let path = checkout(ACCEPTED);
    let text = match std::fs::read_to_string(&path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(BTreeMap::new()),
        text => text?,
    };
    counts(&text)
}

/// Parses the rows below the header.
fn counts(text: &str) -> io::Result<BTreeMap<String, u64>> {
    let row = |line: &str| {
        let (work, count) = line.split_once(',')?;
        Some((work.to_owned(), count.parse().ok()?))
    };
    let broken = |line: &str| io::Error::other(format!("{ACCEPTED}: {line:?} is not a name and a count"));
    text.lines().skip(1).map(|line| row(line).ok_or_else(|| broken(line))).collect()
}

fn build() -> io::Result<()> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    // With the features of the whole workspace, as `cargo test --workspace` has built it. Its work runs on one thread.
    let arguments = ["build", "--quiet", "--workspace", "--bin", "instruction_counts"];
    output(Command::new(cargo).args(arguments)).map(drop)
}

fn pieces() -> io::Result<Vec<String>> {
    let listed = output(&mut Command::new(program()))?;
    Ok(String::from_utf8_lossy(&listed.stdout).lines().map(str::to_owned).collect())
}

/// Counts the instructions of one piece of work.
fn count(work: &str) -> io::Result<u64> {
    const COUNTED: &str = "instruction_counts::counted";
    let counted = output(
        Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(format!("--toggle-collect={COUNTED}"))
            .arg(program())
            .arg(work)
            // The mathematical functions of the C library come in several variants, chosen by processor.
            .env("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4"),
    )
    .map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => io::Error::other("valgrind is not installed, and it does the counting"),
        _ => error,
    })?;
    let said = String::from_utf8_lossy(&counted.stderr);
    let total = said.lines().find_map(|line| line.split_once("Collected :")?.1.trim().parse().ok());
    match total {
        Some(total) if total > 0 => Ok(total),
        _ => Err(io::Error::other(format!("valgrind counted nothing of {work}:\n{said}"))),
    }
}

/// Path of the program that does the work, beside this one.
fn program() -> std::path::PathBuf {
    let here = std::env::current_exe().expect("this program has a path");
    here.with_file_name(format!("instruction_counts{}", std::env::consts::EXE_SUFFIX))
}

/// Runs a command to its end; the error of a failing one is its output.
fn output(command: &mut Command) -> io::Result<Output> {
    let output = command.output()?;
    if output.status.success() {
        return Ok(output);
    }
    Err(io::Error::other(format!("{command:?}: {}", String::from_utf8_lossy(&output.stderr))))
}

#[cfg(test)]
mod test {
    use super::*;

    #[test]
    fn growth_beyond_the_bound_fails_and_less_work_does_not() {
        for (count, before, within) in [(1049, 1000, true), (1051, 1000, false), (50, 100, true)] {
            assert_eq!(Verdict::moved(count, before).is_within(), within, "{count} after {before}");
        }
        assert!(!Verdict::New.is_within());
    }

    #[test]
    fn a_piece_with_ten_times_the_input_is_compared_with_the_piece_itself() {
        let counts =
            [("judge".to_owned(), 1000), ("judge-tenfold".to_owned(), 1050), ("paper".to_owned(), 7)];
        let growths = growths_tenfold(&counts);
        assert_eq!(growths.len(), 1);
        assert!(growths[0].work == "judge" && (growths[0].share - 0.05).abs() < 1e-12);
    }

    #[test]
    fn the_accepted_counts_can_be_read_and_a_broken_row_is_named() {
        assert!(accepted().unwrap()["paper"] > 0);
        let error = counts("work,instructions\nsphere;12\n").unwrap_err();
        assert_eq!(error.to_string(), "tests/instructions.csv: \"sphere;12\" is not a name and a count");
    }
}

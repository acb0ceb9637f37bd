//! Processor time and memory of programs and of this process, as Linux counts them.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Total time of repeated runs, long enough for the kernel's ticks.
const LEAST_TOTAL_S: f64 = 0.6;
/// Ticks per second, whatever the kernel's clock: `USER_HZ` of Linux.
const TICKS_PER_S: f64 = 100.0;
/// Interval at which memory is sampled; the kernel keeps the peak, so that only the last moment could be missed.
const GLANCE: Duration = Duration::from_micros(300);
/// Places of the times of a process in its `stat`, behind the name.
const OWN: [usize; 2] = [11, 12];
/// Places of the times of its children that have ended.
const OF_CHILDREN: [usize; 2] = [13, 14];

/// Returns the path of a program that cargo has built beside this one.
///
/// # Errors
/// A message with the command that builds it, if it is missing.
pub fn program(name: &str, package: &str) -> Result<PathBuf, String> {
    let program = std::env::current_exe().map_err(|error| error.to_string())?.with_file_name(name);
    let missing = || format!("{name} is not built: cargo build --release --package {package}");
    program.exists().then_some(program).ok_or_else(missing)
}

/// Returns the mean processor time \[s\] of a run on one thread.
///
/// # Errors
/// A message if the program fails or the system does not report times.
pub fn processor_s(program: &Path, arguments: &[String]) -> Result<f64, String> {
    let before = ticks_of(OF_CHILDREN)?;
    let mut runs = 0;
    loop {
        succeed(&mut command(program, arguments, 1))?;
        runs += 1;
        let taken_s = (ticks_of(OF_CHILDREN)? - before) / TICKS_PER_S;
        if taken_s >= LEAST_TOTAL_S {
            return Ok(taken_s / f64::from(runs));
        }
    }
}

/// Returns the processor time \[s\] of this process so far, on all of its threads.
///
/// # Errors
/// A message if the system does not report times.
pub fn own_processor_s() -> Result<f64, String> {
    Ok(ticks_of(OWN)? / TICKS_PER_S)
}

/// Returns the largest memory \[bytes\] that a run holds; `None` if the system does not report it.
///
/// # Errors
/// A message if the program cannot be run.
pub fn peak_bytes(program: &Path, arguments: &[String]) -> Result<Option<u64>, String> {
    let mut child = command(program, arguments, 1).spawn().map_err(|error| error.to_string())?;
    let process = child.id().to_string();
    let mut peak = None;
    while child.try_wait().map_err(|error| error.to_string())?.is_none() {
        peak = high_water_bytes_of(&process).max(peak);
        std::thread::sleep(GLANCE);
    }
    Ok(peak)
}

/// Returns the largest memory \[bytes\] that this process has held; `None` if the system does not report it.
pub fn own_peak_bytes() -> Option<u64> {
    high_water_bytes_of("self")
}

/// Returns the shortest wall time \[s\] of five runs.
///
/// # Errors
/// A message if the program fails.
pub fn wall_s(program: &Path, arguments: &[String], threads: usize) -> Result<f64, String> {
    let mut shortest = f64::INFINITY;
    for _ in 0..5 {
        let start = Instant::now();
        succeed(&mut command(program, arguments, threads))?;
        shortest = shortest.min(start.elapsed().as_secs_f64());
    }
    Ok(shortest)
}

fn command(program: &Path, arguments: &[String], threads: usize) -> Command {
    let mut command = Command::new(program);
    command.args(arguments).env("RAYON_NUM_THREADS", threads.to_string());
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

fn succeed(command: &mut Command) -> Result<(), String> {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{command:?}: {status}")),
        Err(error) => Err(format!("{command:?}: {error}")),
    }
}

/// Sum of two times of this process, in the kernel's ticks.
fn ticks_of(places: [usize; 2]) -> Result<f64, String> {
    let stat =
        std::fs::read_to_string("/proc/self/stat").map_err(|error| format!("/proc/self/stat: {error}"))?;
    ticks(&stat, places).ok_or_else(|| format!("/proc/self/stat: {stat}"))
}

/// Sum of two fields; the name in parentheses before them may hold any character.
fn ticks(stat: &str, places: [usize; 2]) -> Option<f64> {
    let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
    places.iter().map(|&place| fields.get(place)?.parse::<f64>().ok()).sum()
}

fn high_water_bytes_of(process: &str) -> Option<u64> {
    high_water_bytes(&std::fs::read_to_string(format!("/proc/{process}/status")).ok()?)
}

fn high_water_bytes(status: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.split_whitespace().next()?.parse::<u64>().ok()? * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_systems_figures_are_read() {
        let stat = "123 (a (strange) name) S 1 2 3 4 5 6 7 8 9 10 11 12 250 50 20 0 1";
        assert_eq!((ticks(stat, OWN), ticks(stat, OF_CHILDREN)), (Some(23.0), Some(300.0)));
        assert_eq!(high_water_bytes("VmPeak:\t 9 kB\nVmHWM:\t    2048 kB\n"), Some(2 << 20));
        assert_eq!(high_water_bytes("Threads: 1"), None);
    }

    #[test]
    fn a_program_that_is_missing_is_named_with_the_command_that_builds_it() {
        let missing = program("no-such-program", "truearea-cli").unwrap_err();
        assert!(missing.ends_with("cargo build --release --package truearea-cli"), "{missing}");
    }
}

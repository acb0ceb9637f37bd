//! The keys behind the name of a file with heights, as requests for scans know them, and the columns of lists of files.

use std::sync::atomic::{AtomicUsize, Ordering};

use measurements::ScanRequest;

use super::walk::{Folder, Outcome, in_every, split};

/// Keys that change nothing by right: words of the command in which, the key, and the reason.
const IDLE_BY_RIGHT: &[(&str, &str, &str)] = &[
    ("on holed.txt", "channel", "the file has one channel, which is read anyway"),
    ("on one.001", "channel", "likewise"),
    ("--areal on holed.txt", "gaps", "they are filled anyway, and nothing but a whole map is taken"),
    ("--pressure 50MPa on holed.txt", "gaps", "likewise"),
    ("flow FILE on map.txt", "size", "flow factors of square points do not depend on their size"),
];

/// Files of every kind, with the keys that they need.
const FILES: &[(&str, &str)] = &[
    ("trace.txt", "unit=um"),
    ("named.txt", ""),
    ("map.txt", "unit=um,size=10um"),
    ("holed.txt", ""),
    ("one.001", ""),
    ("two.001", ""),
    ("two.001", "channel=Height"),
    ("heights.xlsx", ""),
];

/// Commands that take such a file, in place of `FILE`.
const COMMANDS: &[&str] = &[
    "scan FILE",
    "scan FILE --figure f.svg",
    "roughness FILE",
    "roughness FILE --scales",
    "psd FILE",
    "psd FILE map.txt:unit=um,size=10um",
    "psd FILE --per-scan",
    "psd FILE --areal",
    "flow FILE",
    "bem FILE --youngs-modulus 200GPa --poisson-ratio 0.3 --pressure 50MPa",
    "report FILE --material silver --pressure 50MPa --out o",
    "report FILE map.txt:unit=um,size=10um --material silver --pressure 50MPa --out o",
    "psd --list keys.csv",
];

/// Values of a key that matter.
fn values(key: &str) -> Vec<&'static str> {
    macro_rules! named {
        ($type:ty) => {
            <$type>::ALL.iter().map(|value| value.name()).collect()
        };
    }
    match key {
        "unit" | "height-unit" => vec!["nm", "mm"],
        "channel" => vec!["Height", "Height Sensor", "Topo"],
        "size" => vec!["7um", "20um"],
        "tip-radius" => vec!["2um", "3um", "auto", "none"],
        "shortest" => vec!["3um", "4um"],
        "gaps" => named!(topography::GapTreatment),
        "direction" => named!(topography::Direction),
        "detrend" => named!(topography::Detrend),
        "instrument" => vec!["one", "two"],
        "z-calibration" => vec!["2%", "30%"],
        "slope-uncertainty" => vec!["0.1", "0.3"],
        _ => panic!("give two values of {key} that matter"),
    }
}

/// Runs a command on a file with keys; what comes out is without what repeats them.
fn run(folder: &mut Folder, command: &str, file: &str, keys: &[String]) -> Outcome {
    if command.contains("keys.csv") {
        let cells = keys.iter().map(|key| key.split_once('=').unwrap());
        let (names, values): (Vec<_>, Vec<_>) =
            cells.map(|(key, value)| (key.replace('-', "_"), value)).unzip();
        folder.write("keys.csv", &format!("file,{}\n{file},{}\n", names.join(","), values.join(",")));
    }
    let request = if keys.is_empty() { file.to_owned() } else { format!("{file}:{}", keys.join(",")) };
    let words = split(command).into_iter().map(|word| if word == "FILE" { request.clone() } else { word });
    let mut found = folder.run(&words.collect::<Vec<_>>()).without_comments();
    found.files.retain(|name, _| !name.ends_with(".html") && !name.ends_with(".toml"));
    found.printed = found.printed.lines().filter(|line| !line.starts_with('#')).collect();
    found
}

/// Walks every key in one of so many contexts. Returns how many pairs.
fn walk(step: usize) -> usize {
    let contexts = COMMANDS.iter().flat_map(|command| FILES.iter().map(move |file| (*command, *file)));
    let contexts: Vec<_> = contexts.step_by(step).collect();
    let walked = AtomicUsize::new(0);
    let silent = in_every(&contexts, |folder, (command, (file, needed))| {
        let needed: Vec<String> =
            needed.split(',').filter(|key| !key.is_empty()).map(str::to_owned).collect();
        let usual = run(folder, command, file, &needed);
        let mut silent = Vec::new();
        for (key, _) in ScanRequest::OPTIONS.iter().filter(|_| usual.status == 0) {
            walked.fetch_add(1, Ordering::Relaxed);
            let mut given: Vec<_> = needed.iter().filter(|other| !other.starts_with(key)).cloned().collect();
            let mut found = Vec::new();
            for value in values(key) {
                given.push(format!("{key}={value}"));
                found.push(run(folder, command, file, &given));
                given.pop();
            }
            let of = format!("{key} of {command} on {file}:{}", needed.join(","));
            let is_named = |found: &Outcome| {
                [key.to_string(), key.replace('-', "_")].iter().any(|key| found.said.contains(key))
            };
            if found.iter().all(|found| found.status != 0 && !is_named(found)) {
                silent.push(format!("UNNAMED {of}: {}", found[0].said));
            }
            let accepted: Vec<_> = found.iter().filter(|found| found.status == 0).collect();
            let is_idle = !accepted.is_empty() && accepted.iter().all(|found| **found == usual);
            let is_right = |(words, right, _): &(&str, &str, &str)| of.contains(words) && right == key;
            if is_idle && !IDLE_BY_RIGHT.iter().any(is_right) {
                silent.push(format!("SILENT {of}"));
            }
        }
        silent
    });
    assert!(silent.is_empty(), "{} of {walked:?}\n{}", silent.len(), silent.join("\n"));
    walked.into_inner()
}

#[test]
fn keys_behind_files_change_something_or_are_named() {
    let walked = walk(9);
    assert!(walked > 60, "{walked} keys");
}

#[test]
#[ignore = "takes minutes: .ci/slow runs it"]
fn every_key_behind_a_file_changes_something_or_is_named() {
    let walked = walk(1);
    assert!(walked > 500, "{walked} keys");
}

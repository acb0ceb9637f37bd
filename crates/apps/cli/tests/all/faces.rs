//! Two rough faces: their spectra add, by whatever door the second face comes in.

use crate::support::Bench;
use serde_json::Value;

const BODIES: &[&str] = &["--youngs-modulus", "200GPa", "--poisson-ratio", "0.3", "--yield-strength", "2GPa"];

/// A trace [um] of 1,200 points, `step` apart, of waves whose phases depend on the seed.
fn trace(seed: f64, rms: f64, step: f64) -> String {
    let height = |x: f64| -> f64 {
        (1..150)
            .map(|n| {
                let n = f64::from(n);
                n.powf(-1.2) * (0.035 * n * x + 7.3 * seed * n * n).sin()
            })
            .sum()
    };
    (0..1200).map(|at| format!("{} {}\n", step * f64::from(at), rms * height(step * f64::from(at)))).collect()
}

/// A turned ring and a lapped face, by two scans each; those of the face are of another instrument, with another band.
fn bench() -> Bench {
    let bench = Bench::new();
    for (name, seed, rms, step) in [
        ("ring1.txt", 0.11, 0.4, 0.5),
        ("ring2.txt", 0.57, 0.4, 0.5),
        ("face1.txt", 0.23, 0.1, 0.3),
        ("face2.txt", 0.71, 0.1, 0.3),
    ] {
        bench.write(name, trace(seed, rms, step));
    }
    for name in ["ring", "face"] {
        let scans = [1, 2].map(|at| format!("{name}{at}.txt:unit=um"));
        bench.run(&["psd", &scans[0], &scans[1], "--out", &format!("{name}.csv")]).ok();
    }
    bench
}

/// The words of a line, in one list with others.
fn words<'w>(parts: &[&'w str]) -> Vec<&'w str> {
    parts.iter().flat_map(|part| part.split(' ')).collect()
}

/// Every number of a table without its comments.
fn numbers(table: &str) -> Vec<f64> {
    let rows = table.lines().filter(|line| !line.starts_with(['#', '*']));
    rows.flat_map(|row| row.split(',')).filter_map(|cell| cell.parse().ok()).collect()
}

#[track_caller]
fn assert_alike(one: &[f64], other: &[f64]) {
    assert_eq!(one.len(), other.len());
    for (a, b) in one.iter().zip(other) {
        assert!((a - b).abs() <= 1e-9 * a.abs().max(b.abs()), "{a} {b}");
    }
}

const RING: &str = "ring1.txt:unit=um ring2.txt:unit=um";
const FACE: &str = "--counterface-scans face1.txt:unit=um face2.txt:unit=um";

#[test]
fn the_spectra_of_two_faces_add_whatever_holds_them() {
    let bench = bench();
    bench.run(&words(&["psd", RING, FACE, "--out both.csv"])).ok();
    let sum = bench.run(&words(&["psd ring.csv face.csv --sum"])).ok();
    let both = numbers(&bench.read("both.csv"));
    assert_alike(&numbers(&sum), &both);
    assert_alike(&numbers(&bench.run(&words(&["psd", RING, "--counterface-psd face.csv"])).ok()), &both);
    // It is the sum and not the mean, at the wavelengths of either.
    let column = |table: &str| -> Vec<(f64, f64)> {
        let rows = table.lines().filter(|line| line.starts_with(|first: char| first.is_ascii_digit()));
        let cells = rows.map(|row| row.split(',').map(str::parse).collect::<Vec<Result<f64, _>>>());
        cells.map(|cells| (cells[0].clone().unwrap(), cells[2].clone().unwrap())).collect()
    };
    let [sum, ring, face] = [sum, bench.read("ring.csv"), bench.read("face.csv")].map(|table| column(&table));
    let shared = |(wavelength_m, _): &&(f64, f64)| face.iter().any(|(other_m, _)| other_m == wavelength_m);
    for (wavelength_m, value) in ring.iter().filter(shared) {
        let at = |of: &[(f64, f64)]| of.iter().find(|(other_m, _)| other_m == wavelength_m).unwrap().1;
        assert!((at(&sum) / (value + at(&face)) - 1.0).abs() < 1e-12);
    }
    assert!(sum.len() > ring.len() && sum.iter().all(|(_, value)| *value > 0.0));
}

#[test]
fn every_command_on_a_spectrum_takes_scans_and_the_other_face() {
    let bench = bench();
    bench.run(&words(&["psd", RING, FACE, "--out both.csv"])).ok();
    for command in [
        "moments",
        "amplitude",
        "fit",
        "stacked --model elastic-plastic --pressure 10MPa",
        "statistical --model hertz --pressure 10MPa --tolerance 1e-6",
        "persson --model elastic --pressure 10MPa",
        "gap --model persson --pressure 10MPa",
        "tangential --model persson --pressure 10MPa --friction 0.3",
        "law --model persson --dialect csv --pressure-range 1MPa:10MPa",
        "law --model yovanovich --quantity heat --thermal-conductivity 20W/(m~K) --counterface-thermal-conductivity 40W/(m~K) \
         --dialect csv --pressure-range 1MPa:10MPa",
        "bem --grid 32 --realisations 1 --shortest 10um --pressure 10MPa",
    ] {
        let name = command.split(' ').next().unwrap();
        let is_on_spectrum = ["moments", "amplitude", "fit"].contains(&name);
        let bodies = match (is_on_spectrum, command.contains("yovanovich")) {
            (true, _) => &[],
            (false, true) => &BODIES[4..],
            (false, false) if ["tangential", "bem"].contains(&name) => &BODIES[..4],
            _ if command.contains("hertz") || command.contains("--model persson") => &BODIES[..4],
            _ if command.contains("elastic --") => &BODIES[..4],
            _ => BODIES,
        };
        let (_, options) = command.split_once(' ').unwrap_or((command, ""));
        let on = |surface: &str, face: &str| {
            let line = format!("{name} {surface} {options} {face}");
            let words: Vec<String> = line.split_whitespace().map(|word| word.replace('~', " ")).collect();
            let words = words.iter().map(String::as_str).chain(bodies.iter().copied());
            numbers(&bench.run(&words.collect::<Vec<_>>()).ok())
        };
        let both = on("both.csv", "");
        assert!(!both.is_empty(), "{command}");
        assert_alike(&on("ring.csv", "--counterface-psd face.csv"), &both);
        if name == "bem" {
            assert!(both != on("ring.csv", ""));
        } else {
            assert_alike(&on(RING, FACE), &both);
            assert!(both.len() != on(RING, "").len() || both != on(RING, ""), "{command}");
        }
    }
}

#[test]
fn a_report_on_two_faces_is_that_of_a_scene_with_both() {
    let bench = bench();
    let scans = |name: &str| {
        format!(
            "scans = [{{ file = \"{name}1.txt\", unit = \"um\" }}, {{ file = \"{name}2.txt\", unit = \"um\" }}]"
        )
    };
    bench.write(
        "scene.toml",
        format!(
            "[surface]\n{}\n[material]\nname = \"100Cr6\"\n[counterface]\nname = \"100Cr6\"\n[counterface.surface]\n{}\n[interface]\n[seal]\n\
             [loads]\npressures = [\"10 MPa\"]\n",
            scans("ring"),
            scans("face")
        ),
    );
    let answer = |folder: &str| -> Value {
        let mut answer: Value = serde_json::from_str(&bench.read(&format!("{folder}/answer.json"))).unwrap();
        answer.as_object_mut().unwrap().remove("title");
        answer
    };
    bench.run(&["run", "scene.toml", "--out", "by-scene"]).ok();
    let options = "--material 100Cr6 --on 100Cr6 --pressure 10MPa --seal --out by-flags";
    bench.run(&words(&["report", RING, FACE, options])).ok();
    // The whole answer: area, gap, heat, leak, range, models, cautions.
    assert_eq!(answer("by-flags"), answer("by-scene"));
    assert!(bench.read("by-flags/scene.toml").contains("[counterface.surface]"));
    let own = "--material 100Cr6 --on 100Cr6 --pressure 10MPa --seal --out own";
    bench.run(&words(&["report", RING, own])).ok();
    assert_ne!(answer("own")["loads"], answer("by-flags")["loads"]);
    // By spectra the faces are the same, and only their scatter is not drawn in the same way.
    let by_psd = "--material 100Cr6 --on 100Cr6 --pressure 10MPa --seal --out by-psd";
    bench.run(&words(&["report ring.csv --counterface-psd face.csv", by_psd])).ok();
    let interface = |folder: &str| bench.read(&format!("{folder}/report-interface.csv"));
    let values = |table: String| -> Vec<f64> {
        let rows = table.lines().filter(|line| !line.starts_with('#')).map(str::to_owned).collect::<Vec<_>>();
        let at = rows[0].split(',').position(|column| column == "value").unwrap();
        rows[1..].iter().filter_map(|row| row.split(',').nth(at)?.parse().ok()).collect()
    };
    assert_alike(&values(interface("by-psd/data")), &values(interface("by-scene")));
    // Gap, law of the gap and seal of single commands are those of the scene.
    let gap = bench
        .run(&words(&[
            "gap",
            RING,
            FACE,
            "--model persson-plastic --pressure 10MPa --material 100Cr6 --on 100Cr6",
        ]))
        .ok();
    let [mean_gap_m, stiffness] = [2, 4].map(|at| numbers(&gap)[at]);
    let found = interface("by-scene");
    for (name, value) in [("mean_gap_m,", mean_gap_m), ("stiffness_pa_per_m,", stiffness)] {
        let row = found.lines().find(|line| line.starts_with(name)).unwrap();
        assert_alike(&[numbers(row)[1]], &[value]);
    }
}

#[test]
fn what_is_no_second_face_is_refused_with_the_way_out() {
    let bench = bench();
    let map: String = (0..32).map(|row| format!("{}\n", vec![(row % 5).to_string(); 32].join(" "))).collect();
    bench.write("map.txt", map);
    let gap = "--model persson --pressure 10MPa --youngs-modulus 200GPa --poisson-ratio 0.3";
    for (line, names) in [
        (format!("gap ring.csv --counterface-psd face1.txt {gap}"), &["face1.txt", "--counterface-scans"][..]),
        (format!("gap ring.csv --counterface-scans face.csv {gap}"), &["face.csv", "--counterface-psd"]),
        (format!("gap ring.csv --counterface-scans face1.txt {gap}"), &["face1.txt:unit=um"]),
        (format!("gap ring.csv --counterface-psd face.csv:unit=um {gap}"), &["face.csv", "unit"]),
        (format!("gap ring.csv face.csv {gap}"), &["ring.csv", "--counterface-psd"]),
        (format!("gap ring.csv --counterface-scans a.txt --counterface-psd b.csv {gap}"), &["--counterface-psd"]),
        ("psd ring.csv --sum".to_owned(), &["--sum", "1 file"]),
        ("psd ring1.txt ring2.txt face1.txt --unit um --sum".to_owned(), &["--sum", "3 files", "--counterface-scans"]),
        ("psd ring.csv face.csv --sum --per-scan".to_owned(), &["--sum", "--per-scan"]),
        (
            "bem map.txt:unit=um,size=10um --counterface-psd face.csv --pressure 1MPa --youngs-modulus 1GPa --poisson-ratio 0".to_owned(),
            &["map.txt", "--sum"],
        ),
        (
            "report ring.csv --counterface-psd face1.txt --material 100Cr6 --pressure 1MPa --out o".to_owned(),
            &["face1.txt", "--counterface-scans"],
        ),
        (
            "report ring.csv --counterface-scans face1.txt --material 100Cr6 --pressure 1MPa --out o".to_owned(),
            &["face1.txt", "face1.txt:unit=um"],
        ),
        (
            "report ring.csv --counterface-scans no.txt --material 100Cr6 --pressure 1MPa --out o".to_owned(),
            &["no.txt"],
        ),
    ] {
        bench.run(&words(&[&line])).refused_naming(names);
    }
}

#[test]
fn scans_that_differ_beyond_their_scatter_are_asked_for_two_faces() {
    let bench = bench();
    let ran = bench.run(&["psd", "ring1.txt", "face1.txt", "--unit", "um", "--out", "mean.csv"]);
    assert!(ran.stderr.contains("two faces? give one as --counterface-scans"), "{}", ran.stderr);
    let report = "report ring1.txt face1.txt --unit um --material 100Cr6 --pressure 10MPa --out o -v";
    let found = bench.run(&words(&[report])).ok();
    assert!(found.contains("Two faces?") && found.contains("--counterface-scans"), "{found}");
    let answer: Value = serde_json::from_str(&bench.read("o/answer.json")).unwrap();
    assert_eq!(answer["cautions"][0]["caution"], "instruments-disagree");
    let alike = bench.run(&["psd", "ring1.txt", "ring2.txt", "--unit", "um", "--out", "mean.csv"]);
    assert!(!alike.stderr.contains("two faces?"), "{}", alike.stderr);
}

#[cfg(unix)]
#[test]
fn a_terminal_is_asked_for_the_unit_of_the_other_face() {
    let bench = bench();
    let line =
        "report ring1.txt:unit=um --counterface-scans face1.txt --material 100Cr6 --pressure 10MPa --out o";
    let ran = bench.run_on_terminal(&words(&[line]), "um\n\n");
    assert_eq!(ran.status, 0, "{}", ran.stderr);
    let scene = bench.read("o/scene.toml");
    let (own, other) = scene.split_once("[counterface.surface]").unwrap();
    assert!([own, other].iter().all(|face| face.contains("unit = \"µm\"")), "{scene}");
}

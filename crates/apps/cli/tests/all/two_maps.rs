//! Two maps that face each other, maps with missing points, and the compliance of a specimen.

use std::fmt::Write;

use crate::support::{Bench, column, numbers};

const SIDE: usize = 48;

const STEEL: &str = "--youngs-modulus 200GPa --poisson-ratio 0.3";
const ON_GLASS: &str = "--counterface-youngs-modulus 70GPa --counterface-poisson-ratio 0.2";
const GLASS_ON_STEEL: &str = "--youngs-modulus 70GPa --poisson-ratio 0.2 --counterface-youngs-modulus 200GPa --counterface-poisson-ratio 0.3";
const LOADS: &str = "--pressure 5MPa --pressure 50MPa --tolerance 1e-9";

/// Heights \[um\] over column and row in waves of all directions, with phases by a seed.
fn heights(seed: f64) -> Vec<Vec<Option<f64>>> {
    let waves: Vec<(f64, f64, f64)> = (1..60)
        .map(|n| {
            let n = f64::from(n);
            let angle = 2.4 * n + seed;
            let size = 0.2 + 0.004 * n * n;
            (size * angle.cos(), size * angle.sin(), 7.1 * seed * n * n)
        })
        .collect();
    let height = |x: f64, y: f64| -> f64 {
        waves.iter().map(|(kx, ky, phase)| (kx * x + ky * y + phase).sin() / (kx.hypot(*ky) + 0.3)).sum()
    };
    (0..SIDE).map(|row| (0..SIDE).map(|at| Some(0.05 * height(at as f64, row as f64))).collect()).collect()
}

/// Takes the heights outside a disc, and those of a small place inside, away.
fn disc(mut heights: Vec<Vec<Option<f64>>>) -> Vec<Vec<Option<f64>>> {
    let middle = 0.5 * (SIDE - 1) as f64;
    for (row, heights) in heights.iter_mut().enumerate() {
        for (column, height) in heights.iter_mut().enumerate() {
            let (x, y) = (column as f64 - middle, row as f64 - middle);
            if x.hypot(y) > 22.0 || (x - 6.0).hypot(y) < 2.5 {
                *height = None;
            }
        }
    }
    heights
}

fn sum(own: &[Vec<Option<f64>>], other: &[Vec<Option<f64>>]) -> Vec<Vec<Option<f64>>> {
    let rows = own.iter().zip(other);
    rows.map(|(own, other)| own.iter().zip(other.iter().rev()).map(|(a, b)| Some((*a)? + (*b)?)).collect())
        .collect()
}

fn text(heights: &[Vec<Option<f64>>]) -> String {
    let mut text = String::new();
    for row in heights {
        let cells =
            row.iter().map(|height| height.map_or("nan".to_owned(), |height| format!("{height:.17e}")));
        let _ = writeln!(text, "{}", cells.collect::<Vec<_>>().join(" "));
    }
    text
}

fn bench() -> Bench {
    let bench = Bench::new();
    let (own, other) = (heights(0.3), heights(0.7));
    let small: Vec<Vec<Option<f64>>> = other[4..44].iter().map(|row| row[4..44].to_vec()).collect();
    for (name, heights) in [
        ("sum.txt", sum(&own, &other)),
        ("disc-sum.txt", sum(&disc(own.clone()), &disc(other.clone()))),
        ("disc-own.txt", disc(own.clone())),
        ("disc-other.txt", disc(other.clone())),
        ("small.txt", small),
        ("own.txt", own),
        ("other.txt", other),
    ] {
        bench.write(name, text(&heights));
    }
    bench.write("line.txt", "0 1\n1 3\n2 2\n3 2\n4 1\n5 3\n");
    bench.write("psd.csv", "wavelength_m,C1D_m3\n1e-4,1e-18\n1e-5,1e-20\n1e-6,1e-22\n");
    bench
}

fn run(bench: &Bench, words: &str) -> (String, String) {
    let words: Vec<&str> = ["bem"].into_iter().chain(words.split_whitespace()).collect();
    let ran = bench.run(&words);
    let said = ran.stderr.clone();
    (ran.ok(), said)
}

/// Columns that are areas, counted or computed of counts.
const AREAS: [&str; 5] = [
    "area_fraction",
    "area_fraction_corrected",
    "area_fraction_extrapolated",
    "open_along_x",
    "open_along_y",
];
const NUMBERS: [&str; 3] = ["stiffness_pa_per_m", "mean_gap_m", "nominal_pressure_pa"];

#[track_caller]
fn assert_equal(one: &str, other: &str) {
    for name in AREAS {
        assert_eq!(column(one, name), column(other, name), "{name}");
    }
    for name in NUMBERS {
        for (a, b) in numbers(one, name).iter().zip(numbers(other, name)) {
            assert!((a / b - 1.0).abs() < 1e-9, "{name}: {a} {b}");
        }
    }
}

const OPTIONS: &str = "--unit um --size 0.48mm";

#[test]
fn two_maps_are_their_sum_on_a_flat_and_may_change_places() {
    let bench = bench();
    for (own, other, sum, more) in [
        ("own.txt", "other.txt", "sum.txt", ""),
        ("own.txt", "other.txt", "sum.txt", "--detrend mean --compliance punch"),
        ("own.txt", "other.txt", "sum.txt", "--boundary periodic"),
        ("disc-own.txt", "disc-other.txt", "disc-sum.txt", "--gaps keep --compliance even"),
        ("disc-own.txt", "disc-other.txt", "disc-sum.txt", "--gaps keep --detrend line"),
    ] {
        let common = format!("{OPTIONS} {LOADS} {more}");
        let (pair, said) =
            run(&bench, &format!("{own} --counterface-scans {other} {STEEL} {ON_GLASS} {common}"));
        assert!(said.contains(&format!("{other} faces {own}")), "{said}");
        let (on_flat, _) = run(&bench, &format!("{sum} {STEEL} {ON_GLASS} {common}"));
        assert_equal(&pair, &on_flat);
        let (exchanged, _) =
            run(&bench, &format!("{other} --counterface-scans {own} {GLASS_ON_STEEL} {common}"));
        assert_equal(&pair, &exchanged);
        let (one_alone, _) = run(&bench, &format!("{own} {STEEL} {ON_GLASS} {common}"));
        assert_ne!(column(&pair, "area_fraction"), column(&one_alone, "area_fraction"));
    }
}

#[test]
fn missing_points_of_two_maps_stay_missing() {
    let bench = bench();
    let pair = "disc-own.txt --counterface-scans disc-other.txt";
    let (kept, said) = run(&bench, &format!("{pair} {STEEL} {ON_GLASS} {OPTIONS} {LOADS}"));
    let (told_to, _) = run(&bench, &format!("{pair} --gaps keep {STEEL} {ON_GLASS} {OPTIONS} {LOADS}"));
    assert_eq!(kept, told_to);
    assert!(said.contains("missing points never touch"), "{said}");
    // A map alone is filled, or refused with the way to keep them.
    let alone = bench
        .run(&format!("bem disc-own.txt {STEEL} {OPTIONS} --pressure 5MPa").split(' ').collect::<Vec<_>>());
    alone.refused_naming(&["disc-own.txt", "20 %", "keep"]);
}

#[test]
fn maps_of_different_sizes_meet_in_their_middle() {
    let bench = bench();
    let small = "small.txt:size=0.4mm,unit=um";
    let (_, said) = run(
        &bench,
        &format!("own.txt:size=0.48mm,unit=um --counterface-scans {small} {STEEL} {LOADS} --patches p.csv"),
    );
    assert!(
        said.contains("48 x 48 points") && said.contains("40 x 40 points over 400 µm x 400 µm"),
        "{said}"
    );
    let (_, said) = run(
        &bench,
        &format!(
            "own.txt:size=0.48mm,unit=um --counterface-scans other.txt:size=480mm,unit=um {STEEL} {LOADS}"
        ),
    );
    assert!(said.contains("warning: other.txt is 1000 times as large as own.txt"), "{said}");
}

#[test]
fn what_does_not_face_a_map_is_refused_with_what_to_type() {
    let bench = bench();
    let cases: [(&str, &[&str]); 8] = [
        ("--counterface-scans psd.csv", &["psd.csv", "--counterface-scans", "psd own.txt psd.csv --sum"]),
        ("--counterface-psd psd.csv", &["psd.csv", "--counterface-scans", "psd own.txt psd.csv --sum"]),
        ("--counterface-scans line.txt", &["line.txt", "own.txt", "profile"]),
        ("--counterface-scans line.txt --boundary periodic", &["line.txt", "own.txt", "profile"]),
        ("--counterface-scans other.txt sum.txt", &["--counterface-scans", "2 files", "own.txt"]),
        ("--counterface-scans other.txt:detrend=mean", &["other.txt", "detrend"]),
        ("--counterface-scans no.txt", &["no.txt", "no such file"]),
        ("--boundary periodic --compliance punch", &["--compliance", "free edges"]),
    ];
    for (more, names) in cases {
        let words = format!("bem own.txt {OPTIONS} {STEEL} --pressure 5MPa {more}");
        bench.run(&words.split(' ').collect::<Vec<_>>()).refused_naming(names);
    }
    let unknown = "bem own.txt --size 0.48mm --counterface-scans other.txt:unit=um --pressure 5MPa";
    let words = format!("{unknown} {STEEL}");
    bench.run(&words.split(' ').collect::<Vec<_>>()).refused_naming(&["own.txt:", "unit=um"]);
    let of_spectrum = format!("bem psd.csv --compliance even --pressure 5MPa {STEEL}");
    bench.run(&of_spectrum.split(' ').collect::<Vec<_>>()).refused_naming(&["--compliance", "spectrum"]);
}

#[test]
fn fields_of_a_map_with_missing_points_mark_them() {
    let bench = bench();
    let words = format!("disc-own.txt --gaps keep {STEEL} {OPTIONS} --pressure 5MPa --fields fields");
    run(&bench, &words);
    let names: Vec<String> = bench.files().into_iter().filter(|name| name == "fields").collect();
    assert_eq!(names.len(), 1);
    let field = "fields/load-1-surface-1.nc";
    let found = bench.run(&[
        "bem",
        &format!("{field}:gaps=keep,channel=heights"),
        "--youngs-modulus",
        "200GPa",
        "--poisson-ratio",
        "0.3",
        "--pressure",
        "5MPa",
    ]);
    assert!(found.stderr.contains("missing points never touch"), "{}", found.stderr);
}

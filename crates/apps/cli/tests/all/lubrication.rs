//! `law --quantity asperity-pressure`: a table for solvers of mixed lubrication.

use crate::support::{Bench, Ran};

const UNCD: &str = "builtin:uncd-measured";
const BODIES: &str = " --youngs-modulus 463GPa --poisson-ratio 0.2";
const SUMMITS: &str = "--summit-density 1.25e9/m^2 --summit-radius 0.2mm --rms-height 0.2um";

fn card(bench: &Bench, words: &str) -> Ran {
    let words = format!("law --quantity asperity-pressure --dialect csv {words}");
    bench.run(&words.split_whitespace().collect::<Vec<_>>())
}

/// Comment lines without their sign, and rows of numbers.
fn parts(text: &str) -> (String, Vec<Vec<Option<f64>>>) {
    let (comments, rows): (Vec<&str>, Vec<&str>) = text.lines().partition(|line| line.starts_with('#'));
    let numbers = |row: &&str| row.split(',').map(|cell| cell.parse().ok()).collect();
    (comments.join("\n"), rows[1..].iter().map(numbers).collect())
}

#[test]
fn a_card_has_its_conventions_in_front_and_rising_separations() {
    let bench = Bench::new();
    let ran =
        card(&bench, &format!("{UNCD} --model persson --separation-range 0.5:3{BODIES} --output card.csv"));
    assert_eq!((ran.status, ran.stdout.as_str()), (0, ""));
    let (comments, rows) = parts(&bench.read("card.csv"));
    for said in [UNCD, "1/E* = (1 - nu1^2)/E1", "cutoff of 3.5 nm", "eta beta sigma = ", "factor of", "12 mu"]
    {
        assert!(comments.contains(said), "{said}");
    }
    assert_eq!(rows.len(), 26);
    assert!(rows.windows(2).all(|pair| pair[0][3] < pair[1][3] && pair[0][0] > pair[1][0]));
}

#[test]
fn summits_maps_and_scenes_take_the_place_of_a_spectrum() {
    let bench = Bench::new();
    let modulus = "--youngs-modulus 217GPa --poisson-ratio 0";
    let (_, rows) = parts(&card(&bench, &format!("{SUMMITS} --separation-range 1:2 {modulus}")).ok());
    for (row, expected_pa) in [(0, 6.550e6), (25, 4.410e5)] {
        assert!((rows[row][0].unwrap() / expected_pa - 1.0).abs() < 5e-4, "{:?}", rows[row]);
    }
    let same = SUMMITS.replace("1.25e9/m^2", "1250/mm^2");
    let (_, in_mm) = parts(&card(&bench, &format!("{same} --separation-range 1:2 {modulus}")).ok());
    assert!(
        in_mm.iter().zip(&rows).all(|(one, other)| (one[0].unwrap() / other[0].unwrap() - 1.0).abs() < 1e-12)
    );

    let row = |y: i32| -> String {
        (0..32)
            .map(|x| format!("{:.4} ", 0.1 * (f64::from(x * x + 7 * y * y + 3 * x * y) * 0.21).sin()))
            .collect()
    };
    bench.write("map.txt", (0..32).map(|y| row(y) + "\n").collect::<String>());
    let map = "map.txt:unit=um,size=10um --model bem --as-scanned --pressure-range 1GPa:10GPa";
    let (comments, rows) = parts(&card(&bench, &format!("{map}{BODIES}")).ok());
    assert!(comments.contains("1 map as scanned") && rows.len() == 11 && rows[0][7].is_some());
    let hill = |y: i32| -> String {
        (0..32).map(|x| format!("{:.4} ", (f64::from(x * x) * 0.01 + f64::from(y) * 0.2).sin())).collect()
    };
    bench.write("hill.txt", (0..32).map(|y| hill(y) + "\n").collect::<String>());
    let map = "hill.txt:unit=um,size=100um --model bem --as-scanned --separation-range 0.5:1";
    card(&bench, &format!("{map}{BODIES}")).refused_naming(&["range of pressures"]);

    bench.write(
        "scene.toml",
        "[surface]\npsd = \"builtin:uncd-measured\"\n[material]\nyoungs_modulus = \"463 GPa\"\npoisson_ratio = 0.2\n\
         [loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \"persson\"\n",
    );
    let of_scene = parts(&card(&bench, "scene.toml --model persson --separation-range 0.5:3").ok());
    let own = parts(&card(&bench, &format!("{UNCD} --model persson --separation-range 0.5:3{BODIES}")).ok());
    assert_eq!(of_scene.1, own.1);
    card(&bench, &format!("scene.toml --model persson --separation-range 0.5:3{BODIES}"))
        .refused_naming(&["bodies"]);
    card(&bench, "scene.toml --model persson --separation-range 0.5:3 --column C1D_m3")
        .refused_naming(&["scene"]);
}

#[test]
fn what_no_card_has_is_refused() {
    let bench = Bench::new();
    let persson = format!("{UNCD} --model persson{BODIES}");
    for (words, named) in [
        (persson.clone(), "--pressure-range"),
        (format!("{persson} --separation-range 0.5"), "FROM:TO"),
        (format!("{persson} --separation-range 3:0.5"), "--separation-range"),
        (format!("{persson} --separation-range 0.5:3 --units N-mm"), "--units"),
        (format!("{persson} --separation-range 0.5:3 --error 0.1"), "--error"),
        (format!("{persson} --separation-range 0.5:3 --gas air"), "--gas"),
        (format!("{persson} --separation-range 0.5:3 --as-scanned"), "--as-scanned"),
        (format!("{UNCD} --model yovanovich --separation-range 0.5:3{BODIES}"), "yovanovich"),
        (format!("{UNCD} {SUMMITS} --separation-range 0.5:3{BODIES}"), "--summit-density"),
        (format!("{SUMMITS} --cutoff 1um --separation-range 0.5:3{BODIES}"), "--cutoff"),
        (format!("{SUMMITS} --column C1D_m3 --separation-range 0.5:3{BODIES}"), "--column"),
        (format!("--summit-density 3 --separation-range 0.5:3{BODIES}"), "1.25e9/m^2"),
        (format!("--summit-density 3/m^2 --separation-range 0.5:3{BODIES}"), "--summit-radius"),
    ] {
        card(&bench, &words).refused_naming(&[named]);
    }
    let other = format!("law {UNCD} --model persson --dialect csv --separation-range 0.5:3{BODIES}");
    bench.run(&other.split_whitespace().collect::<Vec<_>>()).refused_naming(&["--separation-range"]);
    let code =
        format!("law {persson} --quantity asperity-pressure --dialect abaqus --separation-range 0.5:3");
    bench.run(&code.split_whitespace().collect::<Vec<_>>()).refused_naming(&["--dialect csv"]);
}

//! Files of instruments on the command line: what is in them, gaps, directions.

use crate::nanoscope::{Image, NanoscopeFile};
use crate::support::{Bench, assert_names, column, numbers};

/// A map of 64 x 48 points, 1 nm apart, rough along its rows and wavy across them; so many points, one in each row from the
/// first on, have no height.
fn map(gaps: usize) -> String {
    let height = |x: usize, y: usize| {
        let rough = ((x * 7919 + y * 104_729) % 1009) as f64 / 1009.0;
        let is_gap = y < gaps && x == (y * 37) % 64;
        if is_gap { "nan".to_owned() } else { format!("{:.6}", rough + 0.3 * (y as f64 / 4.0).sin()) }
    };
    let row = |y| (0..64).map(|x| height(x, y)).collect::<Vec<_>>().join("\t");
    let rows: Vec<String> = (0..48).map(row).collect();
    format!("# Channel: Topo\n# Width: 64 nm\n# Height: 48 nm\n# Value units: nm\n{}\n", rows.join("\n"))
}

#[test]
fn a_row_tells_what_is_in_a_channel() {
    let bench = Bench::new();
    bench.write("map.txt", map(5)).write("line.txt", "# x (um) h (nm)\n0 1\n0.5 3\n1 2\n1.5 2\n");
    let run = bench.run(&["scan", "map.txt", "line.txt"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert_eq!(
        run.stdout.lines().next().unwrap(),
        "file,format,channel,points_x,points_y,size_x_m,size_y_m,rms_height_m,peak_to_valley_m,gaps,rms_slope_x,\
         rms_slope_y,note"
    );
    assert_eq!(column(&run.stdout, "channel"), ["Topo", ""]);
    assert_eq!(column(&run.stdout, "points_x"), ["64", "4"]);
    assert_eq!(column(&run.stdout, "points_y"), ["48", "1"]);
    assert_eq!(column(&run.stdout, "gaps"), ["5", "0"]);
    assert_eq!(column(&run.stdout, "size_x_m"), ["6.4e-8", "2e-6"]);
    let [of_map, of_line] = column(&run.stdout, "size_y_m")[..] else { panic!("{}", run.stdout) };
    assert!((of_map.parse::<f64>().unwrap() / 4.8e-8 - 1.0).abs() < 1e-12 && of_line.is_empty(), "{of_map}");
    assert_eq!(column(&run.stdout, "rms_slope_y")[1], "");
    // Of 1, 3, 2, 2 nm about their mean.
    let rms: f64 = column(&run.stdout, "rms_height_m")[1].parse().unwrap();
    assert!((rms / 0.5f64.sqrt() / 1e-9 - 1.0).abs() < 1e-12, "{rms}");
}

#[test]
fn a_file_that_cannot_be_read_does_not_hide_the_others() {
    let bench = Bench::new();
    bench.write("map.txt", map(0)).write("notes.md", "# Nothing\nto see\n");
    let run = bench.run(&["scan", "notes.md", "map.txt"]);
    assert_eq!(run.status, 2);
    assert_eq!(column(&run.stdout, "file"), ["map.txt"]);
    assert!(run.stderr.starts_with("error: notes.md: "), "{}", run.stderr);
}

#[test]
fn a_file_that_leaves_its_unit_open_names_the_option_that_tells_it() {
    let bench = Bench::new();
    bench.write("bare.txt", "0 1\n1 2\n2 1\n");
    let run = bench.run(&["scan", "bare.txt"]);
    assert_eq!(run.status, 2);
    assert_names(&run.stderr, &["bare.txt: ", ":unit=um"]);
    assert_eq!(column(&bench.run(&["scan", "bare.txt", "--unit", "um"]).stdout, "size_x_m"), ["3e-6"]);
}

#[test]
fn a_channel_without_lengths_is_shown_and_drawn_in_its_unit_and_is_no_scan() {
    let bench = Bench::new();
    let values: Vec<f64> = (0..32).map(|point| f64::from(point * 7 % 32) * 1e-9).collect();
    let image = |name| Image { name, direction: "Trace", heights_m: &values };
    let images = vec![image("Phase"), image("Height")];
    bench.write("scan.001", NanoscopeFile { images, ..NanoscopeFile::new(8, 4, &values) }.to_bytes());
    let run = bench.run(&["scan", "scan.001", "--all-channels", "--figure", "drawn.svg"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert_eq!(column(&run.stdout, "channel"), ["Phase (Trace)", "Height (Trace)"]);
    let [phase, height] = ["drawn.svg", "drawn-2.svg"].map(|name| bench.read(name));
    assert!(phase.contains(" V</text>") && height.contains("nm</text>"), "{phase}");
}

#[test]
fn heights_are_drawn_a_picture_for_each_channel() {
    let bench = Bench::new();
    bench.write("map.txt", map(3)).write("line.txt", "# x (um) h (nm)\n0 1\n0.5 3\n1 2\n1.5 2\n");
    let run = bench.run(&["scan", "map.txt", "line.txt", "--figure", "heights.svg", "--output", "found.csv"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert_eq!(bench.files(), ["found.csv", "heights-2.svg", "heights.svg", "line.txt", "map.txt"]);
    assert_eq!(run.remarks(&["heights-2.svg", "line.txt"]).len(), 1, "{}", run.stderr);
    let of_map = bench.read("heights.svg");
    assert!(of_map.contains("grey: 3 without a height") && of_map.contains("data:image/png;base64,"));
    assert!(
        roxmltree::Document::parse(&of_map).is_ok() && bench.read("heights-2.svg").contains("position (µm)")
    );
    let refused = bench.run(&["scan", "map.txt", "--figure", "map.txt"]);
    assert_eq!(refused.status, 2, "{}", refused.stderr);
}

#[test]
fn missing_points_are_filled_and_counted_left_out_or_refused() {
    let bench = Bench::new();
    bench.write("map.txt", map(20));
    let run = |options: &[&str]| bench.run(&[&["psd", "map.txt"], options].concat());
    let filled = run(&[]);
    assert_eq!(filled.status, 0, "{}", filled.stderr);
    assert_eq!(filled.remarks(&["0.65 %", "20 holes"]).len(), 1, "{}", filled.stderr);
    let lines = run(&["--gaps", "lines"]);
    assert_eq!(lines.remarks(&["28 ", "64 nm"]).len(), 1, "{}", lines.stderr);
    assert_ne!(numbers(&filled.stdout, "C1D_m3"), numbers(&lines.stdout, "C1D_m3"));
    assert_eq!(bench.run(&["psd", "map.txt:gaps=refuse", "--gaps", "lines"]).status, 2);
}

#[test]
fn a_map_is_looked_at_along_either_axis_or_both() {
    let bench = Bench::new();
    bench.write("map.txt", map(0));
    let spectrum = |direction: &str| bench.run(&["psd", "map.txt", "--direction", direction]);
    let [x, y, both] = ["x", "y", "both"].map(spectrum);
    assert_eq!(x.stdout.lines().last(), bench.run(&["psd", "map.txt"]).stdout.lines().last());
    assert_ne!(x.stdout, y.stdout);
    assert_eq!(both.status, 0, "{}", both.stderr);
    assert!(both.stdout.contains("map.txt") && numbers(&both.stdout, "measurements").contains(&2.0));
    assert!(both.stderr.contains("along y"), "{}", both.stderr);
    let of_axis = |axis: &str| format!("# scan: map.txt (text, channel Topo, along {axis}), SHA-256 ");
    assert!(["x", "y"].iter().all(|axis| both.stdout.contains(&of_axis(axis))), "{}", both.stdout);
    assert!(x.stdout.contains("# scan: map.txt (text, channel Topo), SHA-256 "), "{}", x.stdout);
    assert_eq!(spectrum("z").status, 2);
}

#[test]
fn scenes_have_the_same_keys() {
    let bench = Bench::new();
    let scene = |keys: &str| {
        format!(
            "surface = {{ scans = [{{ file = \"map.txt\", shortest_wavelength = \"4 nm\"{keys} }}] }}\n\
             material = {{ youngs_modulus = \"100 GPa\", poisson_ratio = 0.3, yield_strength = \"1 GPa\" }}\n\
             loads = {{ pressures = [\"1 MPa\"] }}\n[[curve]]\nmodel = \"elastic\"\n"
        )
    };
    bench.write("map.txt", map(20));
    bench.write("filled.toml", scene(""));
    bench.write("both.toml", scene(", gaps = \"lines\", direction = \"both\""));
    let run = |name: &str| bench.run(&["run", name, "--no-judge", "--output", "-", "--out", "results"]);
    assert_eq!(run("filled.toml").status, 0, "{}", run("filled.toml").stderr);
    assert_eq!(run("both.toml").status, 0, "{}", run("both.toml").stderr);
}

#[test]
fn the_keys_of_scans_that_the_template_shows_are_keys_that_there_are() {
    let bench = Bench::new();
    let template = bench.run(&["scene", "new"]).ok();
    let at = |text: &str| template.find(text).unwrap_or_else(|| panic!("there is no {text}"));
    let shown = template[at("# scans = [")..at("# gaps: harmonic")].replace("# ", "");
    bench.write("own.toml", template.replace("psd = \"my_psd.csv\"\n", &shown));
    bench.run(&["run", "own.toml"]).refused_naming(&["map.001"]);
}

#[test]
fn heights_are_written_for_other_programs() {
    let bench = Bench::new();
    bench.write("map.txt", map(5)).write("line.txt", "# x (um) h (nm)\n0 1\n0.5 3\n1 2\n1.5 2\n");
    let rms = |name: &str| {
        let run = bench.run(&["scan", name]);
        assert_eq!((run.status, column(&run.stdout, "gaps")[0]), (0, "5"), "{}", run.stderr);
        numbers(&run.stdout, "rms_height_m")[0]
    };
    for (name, accuracy) in [("map.gsf", 1e-6), ("map.x3p", 1e-14), ("map.nc", 1e-14)] {
        let run = bench.run(&["scan", "map.txt", "--write", name]);
        assert_eq!(run.status, 0, "{}", run.stderr);
        assert!(run.stderr.contains(&format!("{name}: map.txt, Topo")), "{}", run.stderr);
        assert!((rms(name) / rms("map.txt") - 1.0).abs() < accuracy);
    }
    for (call, word) in [
        (vec!["map.txt", "--write", "map.txt"], "must end in .gsf, .x3p, .nc"),
        (vec!["map.gsf", "--write", "map.gsf"], "--write"),
        (vec!["map.txt", "line.txt", "--write", "both.nc"], "takes one file"),
        (vec!["line.txt", "--write", "line.gsf"], "write it as .x3p or .nc"),
        (vec!["map.txt", "--all-channels", "--write", "all.nc"], "--all-channels"),
    ] {
        let run = bench.run(&[vec!["scan"], call].concat());
        assert_eq!(run.status, 2, "{}", run.stderr);
        assert!(run.stderr.contains(word), "{}", run.stderr);
    }
    assert!(!bench.path("both.nc").exists() && !bench.path("line.gsf").exists());
    let run = bench.run(&["scan", "line.txt", "--write", "line.x3p"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
}

#[test]
fn a_file_without_heights_ends_with_its_channels() {
    let bench = Bench::new();
    let field =
        b"Gwyddion Simple Field 1.0\nXRes = 2\nYRes = 2\nXReal = 1\nYReal = 1\nXYUnits = m\nZUnits = V\n\
                  Title = Amplitude\n\0";
    let mut bytes = field.to_vec();
    bytes.resize(bytes.len().next_multiple_of(4) + 16, 0);
    bench.write("volts.gsf", bytes);
    let run = bench.run(&["scan", "volts.gsf"]);
    assert_eq!((run.status, run.stdout.as_str()), (2, ""));
    assert!(run.stderr.contains("'Amplitude'"), "{}", run.stderr);
    assert_eq!(bench.run(&["scan", "volts.gsf", "--all-channels"]).status, 0);
}

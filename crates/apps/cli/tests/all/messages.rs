//! Messages of the program for wrong calls and doubtful results, all in one snapshot.

use std::fmt::Write;

use crate::nanoscope::{Image, NanoscopeFile};
use crate::support::Bench;

/// A call a line, as in a shell without quotes.
const CALLS: &str = include_str!("messages/calls.txt");

/// Texts below their names, and texts made from others above them by replacements.
const FILES: &str = include_str!("messages/files.txt");

/// Words of [`CALLS`] that stand for several.
const SHORTHAND: [(&str, &str); 8] = [
    (
        "$HEAT",
        "$LAW --quantity heat --thermal-conductivity 20W/m/K --counterface-thermal-conductivity 60W/m/K",
    ),
    ("$LAW", "law power.csv --pressure-range 1Pa:2Pa --dialect abaqus $UNIT"),
    ("$SOFT", "--youngs-modulus 1GPa --poisson-ratio 0.3"),
    ("$RIGID", "--youngs-modulus 1GPa --poisson-ratio 0"),
    ("$UNIT", "--youngs-modulus 1Pa --poisson-ratio 0"),
    ("$PLASTIC", "--model elastic-plastic $DIAMOND --indentation-hardness 5.4GPa"),
    ("$STEEL", "$DIAMOND --yield-strength 1.8GPa"),
    ("$DIAMOND", "--youngs-modulus 463GPa --poisson-ratio 0.2"),
];

fn write_texts(bench: &Bench) {
    for file in FILES.split("=== ").skip(1) {
        let (heading, lines) = file.split_once('\n').unwrap();
        let Some((name, base)) = heading.split_once(" from ") else {
            bench.write(heading, lines);
            continue;
        };
        let text = lines.lines().fold(bench.read(base), |text, line| {
            let (from, to) = line.split_once(" =>").unwrap();
            let [from, to] = [from, to.trim_start()].map(|words| words.replace("\\n", "\n"));
            assert!(text.contains(&from), "{heading}: {from}");
            text.replacen(&from, &to, 1)
        });
        bench.write(name, text);
    }
}

/// Lines of text, one for each index.
fn lines(indices: std::ops::Range<usize>, line: impl Fn(usize) -> String) -> String {
    indices.map(|at| line(at) + "\n").collect()
}

/// Rough heights in nm along a line.
fn profile(spacing_nm: f64, scale: f64) -> String {
    lines(0..512, |at| format!("{:.3} {:.6}", spacing_nm * at as f64, scale * ((at * 7919) % 101) as f64))
}

/// A map of rough rows, shifted up or down by as much as `offset`, with so many points without height.
fn map(missing: usize, offset: f64) -> String {
    let height = |x: usize, y: usize| {
        let shift = offset * ((y * 6007) % 97) as f64 / 97.0;
        match y < missing && x == (y * 37) % 64 {
            true => "nan".to_owned(),
            false => format!("{:.6}", ((x * 7919 + y * 104_729) % 1009) as f64 / 1009.0 + shift),
        }
    };
    let row = |y| (0..64).map(|x| height(x, y)).collect::<Vec<_>>().join("\t");
    format!("# Channel: Topo\n# Width: 64 nm\n# Height: 48 nm\n# Value units: nm\n{}", lines(0..48, row))
}

/// A workbook of Excel with a profile in mm and um, and notes on a sheet before it.
pub fn workbook() -> Vec<u8> {
    let cell = |place: String, value: String| format!(r#"<c r="{place}"><v>{value}</v></c>"#);
    let text =
        |place: &str, text: &str| format!(r#"<c r="{place}" t="inlineStr"><is><t>{text}</t></is></c>"#);
    let row = |at: usize| {
        let cells = [
            cell(format!("A{}", at + 2), (0.1 * at as f64).to_string()),
            cell(format!("B{}", at + 2), (at * 7 % 32).to_string()),
        ];
        format!(r#"<row r="{}">{}</row>"#, at + 2, cells.concat())
    };
    let sheet = |rows: String| {
        format!(
            r#"<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData>{rows}</sheetData></worksheet>"#
        )
    };
    let notes = sheet(format!(r#"<row r="1">{}</row>"#, text("A1", "a flange")));
    let heading = format!(r#"<row r="1">{}{}</row>"#, text("A1", "X (mm)"), text("B1", "Z (um)"));
    let heights = sheet(heading + &(0..64).map(row).collect::<String>());
    let office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let packed = "http://schemas.openxmlformats.org/package/2006/relationships";
    let root = format!(
        r#"<Relationships xmlns="{packed}"><Relationship Id="rId1" Type="{office}/officeDocument" Target="xl/workbook.xml"/></Relationships>"#
    );
    let links = ["1", "2"].map(|n| {
        format!(r#"<Relationship Id="rId{n}" Type="{office}/worksheet" Target="worksheets/sheet{n}.xml"/>"#)
    });
    let links = format!(r#"<Relationships xmlns="{packed}">{}</Relationships>"#, links.concat());
    let index = format!(
        r#"<workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" xmlns:r="{office}"><sheets><sheet name="Notes" sheetId="1" r:id="rId1"/><sheet name="Trace" sheetId="2" r:id="rId2"/></sheets></workbook>"#
    );
    crate::zip_file::zipped(&[
        ("_rels/.rels", root.as_bytes()),
        ("xl/workbook.xml", index.as_bytes()),
        ("xl/_rels/workbook.xml.rels", links.as_bytes()),
        ("xl/worksheets/sheet1.xml", notes.as_bytes()),
        ("xl/worksheets/sheet2.xml", heights.as_bytes()),
    ])
}

/// A spectrum that falls as a power of the wavevector above 1 um and faster below.
fn settling(rows: usize, decades: f64, errors: bool) -> String {
    let row = |at: usize| {
        let wavelength_m = 1e-3 * 10f64.powf(-decades * at as f64 / (rows - 1) as f64);
        let q = std::f64::consts::TAU / wavelength_m;
        let c1d_m3 = 1e-4 * q.powf(-2.2) / (1.0 + (q / 6e6).powi(2));
        let error = if errors { format!(",{:e}", 0.1 * c1d_m3) } else { String::new() };
        format!("{wavelength_m:e},{c1d_m3:e}{error}")
    };
    let error = if errors { ",C1D_se_m3" } else { "" };
    format!("wavelength_m,C1D_m3{error}\n{}", lines(0..rows, row))
}

fn write_surfaces(bench: &Bench) {
    for (name, spacing_nm, scale) in
        [("line.txt", 1.0, 0.1), ("fine.txt", 5.0, 0.1), ("copy.txt", 5.0, 0.1), ("coarse.txt", 20.0, 0.1)]
    {
        bench.write(name, profile(spacing_nm, scale));
    }
    bench.write("rough.txt", profile(200.0, 0.1)).write("apart.txt", profile(20.0, 10.0));
    bench.write("high.txt", profile(5.0, 100.0)).write("heights.xlsx", workbook());
    bench
        .write("picture.png", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")
        .write("old.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1");
    bench.write("steep.csv", "wavelength_m,C1D_m3\n1e-5,1e-13\n1e-6,1e-16\n1e-7,1e-19\n");
    let whole = profile(5.0, 0.1);
    bench.write(
        "cut.txt",
        whole.lines().take(100).chain(whole.lines().skip(160)).collect::<Vec<_>>().join("\n"),
    );
    bench.write("map.txt", map(20, 0.0)).write("areal.txt", map(0, 0.0)).write("offset.txt", map(0, 4.0));
    bench.write("map.001", "\\*File list\r\n\\Version: 0x05120000\r\n").write("map.nc", "CDF\x01\0\0\0\0");
    let values: Vec<f64> = (0..32).map(|point| f64::from(point * 7 % 32) * 1e-9).collect();
    let images = ["Phase", "Height"].map(|name| Image { name, direction: "Trace", heights_m: &values });
    let file = NanoscopeFile { images: images.into(), ..NanoscopeFile::new(8, 4, &values) };
    bench.write("scan.001", file.to_bytes());
    let wave = |at: usize| format!("{:e}", 0.1 * (std::f64::consts::TAU * at as f64 / 32.0).cos());
    let waves = lines(0..8, |_| (0..32).map(wave).collect::<Vec<_>>().join(" "));
    bench.write("missing.txt", waves.replacen("1e-1", "nan", 1)).write("waves.txt", waves);
    let power = |exponent: f64, scale: f64| {
        move |q: f64| format!("{:e},{:e}\n", std::f64::consts::TAU / q, scale * q.powf(exponent))
    };
    let (c1d, ciso) = (power(-2.6, 2.274e-4), power(-3.6, 7.5e-7));
    bench.write("power.csv", format!("lambda_m,C1D_m3\n{}{}", c1d(1e4), c1d(1e6)));
    bench.write("ciso.csv", format!("wavelength_m,Ciso_m4\n{}{}{}", ciso(20.0), ciso(50.0), ciso(110.0)));
    for (name, rows, decades, errors) in [
        ("settling.csv", 61, 6.0, false),
        ("ending.csv", 25, 2.4, false),
        ("four.csv", 4, 3.0, false),
        ("short-band.csv", 20, 0.9, false),
        ("errors.csv", 31, 3.0, true),
    ] {
        bench.write(name, settling(rows, decades, errors));
    }
    bench.write("utf-16.csv", b"\xff\xfe\0b").write("latin-1.toml", b"title = \"\xb5m\"");
    bench.write("blank.toml", bench.run(&["scene", "new"]).ok());
    for folder in ["folder", "sub", "optical", "day"] {
        std::fs::create_dir(bench.path(folder)).unwrap();
    }
    bench
        .write("day/a.txt", profile(5.0, 0.1))
        .write("day/b.txt", profile(20.0, 0.1))
        .write("day/readme.md", "# Nothing\n");
    let optical = "surfaces:\n- topographies:\n  - {name: m, datafile: {original: map.txt}, unit: nm, instrument: {type: microscope-based}}\n";
    bench.write("optical/map.txt", map(0, 0.0)).write("optical/meta.yml", optical);
    let meta = "surfaces:\n- topographies:\n  - {name: my line, datafile: {original: line.txt}, unit: nm}\n";
    bench.write("sub/line.txt", profile(1.0, 0.1)).write("sub/meta.yml", meta);
}

#[test]
fn messages_are_those_of_the_snapshot() {
    let bench = Bench::new();
    write_texts(&bench);
    write_surfaces(&bench);
    // Every platform has its own words for it.
    let not_found = std::fs::read(bench.path("absent")).unwrap_err().to_string();
    let mut said = String::new();
    for call in CALLS.lines() {
        let call = SHORTHAND.iter().fold(call.to_owned(), |call, (word, words)| call.replace(word, words));
        let files = bench.files();
        let ran = match call.split_once(" < ") {
            Some((call, input)) => {
                bench.run_with_input(&call.split(' ').collect::<Vec<_>>(), &bench.read(input))
            }
            None => bench.run(&call.split(' ').collect::<Vec<_>>()),
        };
        assert!(ran.status == 0 || bench.files() == files, "{call}: {:?}", bench.files());
        // A scene is answered in words.
        let words = if call.starts_with("run ") { ran.stdout.as_str() } else { "" };
        let stderr = ran.stderr.replace(&not_found, "NOT FOUND");
        let _ = writeln!(said, "$ truearea {call}\n[{}]\n{stderr}{words}", ran.status);
    }
    insta::with_settings!({ prepend_module_to_snapshot => false }, {
        insta::assert_snapshot!("messages", said);
    });
}

//! Files of Gwyddion.

use scans::{Measure, ScanFormat, Unitless};

use super::bytes::Bytes;
use super::{Sample, assert_holds, channels, heights, heights_if_told};

/// A component: its name, the letter of its type, its value.
fn component(name: &str, letter: u8, value: impl AsRef<[u8]>) -> Vec<u8> {
    Bytes::default().put(name).zeros(1).put([letter]).put(value).0.clone()
}

fn object(class: &str, components: &[Vec<u8>]) -> Vec<u8> {
    let body = components.concat();
    Bytes::default().put(class).zeros(1).put((body.len() as u32).to_le_bytes()).put(body).0.clone()
}

fn integer(name: &str, value: i32) -> Vec<u8> {
    component(name, b'i', value.to_le_bytes())
}

fn real(name: &str, value: f64) -> Vec<u8> {
    component(name, b'd', value.to_le_bytes())
}

fn text(name: &str, value: &str) -> Vec<u8> {
    component(name, b's', [value.as_bytes(), b"\0"].concat())
}

fn reals(name: &str, values: &[f64]) -> Vec<u8> {
    let numbers: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    component(name, b'D', [&(values.len() as u32).to_le_bytes()[..], &numbers].concat())
}

fn unit(name: &str, unit: &str) -> Vec<u8> {
    component(name, b'o', object("GwySIUnit", &[text("unitstr", unit)]))
}

/// An image of 3 x 2 points.
fn field(lateral: &str, value: &str, values: &[f64]) -> Vec<u8> {
    field_of([3, 2], lateral, value, values)
}

fn field_of(points: [i32; 2], lateral: &str, value: &str, values: &[f64]) -> Vec<u8> {
    let parts = [
        integer("xres", points[0]),
        integer("yres", points[1]),
        real("xreal", 3.0),
        real("yreal", -1.0),
        real("xoff", 7.0),
        unit("si_unit_xy", lateral),
        unit("si_unit_z", value),
        reals("data", values),
    ];
    object("GwyDataField", &parts)
}

const VALUES: [f64; 6] = [1.0, 2.0, 3.0, 4.0, 5.0, 3.0];

/// Every type of component, and three images.
fn whole() -> Vec<u8> {
    let meta = object("GwyContainer", &[text("Comment", "tip radius 8 nm"), text("Empty", "")]);
    let brick = object("GwyBrick", &[]);
    let names = Bytes::default().put(2u32.to_le_bytes()).put(b"one\0two\0").0.clone();
    let objects = Bytes::default().put(1u32.to_le_bytes()).put(object("GwySelection", &[])).0.clone();
    let parts = [
        component("/0/base/visible", b'b', [1]),
        component("/0/letter", b'c', b"x"),
        component("/0/number", b'q', 7u64.to_le_bytes()),
        component("/1/data", b'o', field("m", "V", &VALUES)),
        text("/1/data/title", "Phase"),
        component("/0/data", b'o', field("um", "nm", &VALUES)),
        text("/0/data/title", "Height µ"),
        component("/0/meta", b'o', meta),
        component("/2/data", b'o', field("", "", &VALUES)),
        component("/3/data", b'o', field("m", "m", &VALUES)),
        text("/3/data/title", "Amplitude"),
        component("/brick/0", b'o', brick),
        component("/0/names", b'S', names),
        component("/0/objects", b'O', objects),
        component("/0/letters", b'C', [2, 0, 0, 0, 1, 2]),
        component("/0/integers", b'I', [1, 0, 0, 0, 1, 2, 3, 4]),
        component("/0/longs", b'Q', [0; 4]),
    ];
    file(&parts)
}

/// The container of version 1, whose types come first and are numbers.
fn old() -> Vec<u8> {
    let mut body = Bytes::default();
    body.put(80u32.to_le_bytes()).put(b"/0/data\0").put(field("m", "m", &VALUES));
    body.put(64u32.to_le_bytes()).put(b"/0/data/title\0").put(b"Old\0");
    body.put(20u32.to_le_bytes()).put(b"/0/flag\0").put([1]);
    let size = (body.0.len() as u32).to_le_bytes();
    Bytes::default().put(b"GWYOGwyContainer\0").put(size).put(&body.0).0.clone()
}

fn masked(values: &[f64], mask: &[f64]) -> Vec<u8> {
    let parts = [
        component("/0/data", b'o', field("m", "m", values)),
        component("/0/mask", b'o', field("m", "", mask)),
    ];
    file(&parts)
}

/// A curve of a graph; components without values are left out, as Gwyddion does.
fn curve(description: &str, x: &[f64], y: &[f64]) -> Vec<u8> {
    let arrays = [("xdata", x), ("ydata", y)].into_iter().filter(|(_, values)| !values.is_empty());
    let mut parts: Vec<_> = arrays.map(|(name, values)| reals(name, values)).collect();
    parts.extend([text("description", description), integer("type", 2)]);
    object("GwyGraphCurveModel", &parts)
}

/// A graph under its key.
fn graph(number: u32, units: [&str; 2], title: &str, curves: &[Vec<u8>]) -> Vec<u8> {
    let count = (curves.len() as u32).to_le_bytes();
    let parts = [
        component("x_is_logarithmic", b'b', [0]),
        unit("x_unit", units[0]),
        unit("y_unit", units[1]),
        text("title", title),
        text("bottom_label", "x"),
        component("curves", b'O', [&count[..], &curves.concat()].concat()),
    ];
    component(&format!("/0/graph/graph/{number}"), b'o', object("GwyGraphModel", &parts))
}

/// The graph of a file that comes first stands behind that of a lower number, and both behind the image.
fn graphs() -> Vec<u8> {
    let parts = [
        graph(
            12,
            ["um", "nm"],
            "Stylus",
            &[
                curve("", &[0.0, 1.0, 4.0], &[1.0, 2.0, 3.0]),
                curve("Falling", &[0.9, 0.6, 0.3, 0.0], &[1.0, f64::NAN, 3.0, 4.0]),
                curve("Deflection", &[0.0, 1.0, 2.0], &[1.0, 2.0, 3.0]),
            ],
        ),
        graph(3, ["m", "m"], "Profiles", &[curve("Profile µ", &[1.0, 1.5, 2.0, 2.5], &[4.0, 3.0, 2.0, 1.0])]),
        graph(4, ["m", "m^-1"], "Height distribution", &[curve("", &[0.0, 1.0], &[1.0, 2.0])]),
        graph(5, ["s", "m"], "Drift", &[curve("", &[0.0, 1.0], &[1.0, 2.0])]),
        component("/0/data", b'o', field("m", "m", &VALUES)),
    ];
    file(&parts)
}

fn file(parts: &[Vec<u8>]) -> Vec<u8> {
    [b"GWYP".to_vec(), object("GwyContainer", parts)].concat()
}

pub fn samples() -> Vec<Sample> {
    vec![
        Sample { name: "four images", bytes: whole() },
        Sample { name: "version 1", bytes: old() },
        Sample { name: "masked", bytes: masked(&VALUES, &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0]) },
        Sample { name: "graphs", bytes: graphs() },
    ]
}

#[test]
fn images_are_read_with_their_units_titles_and_comments() {
    let all = channels(&whole(), true);
    let names: Vec<_> =
        all.iter().map(|channel| channel.as_ref().ok().and_then(|file| file.channel.clone())).collect();
    assert_eq!(
        names,
        [Some("Height µ".to_owned()), Some("Phase".to_owned()), None, Some("Amplitude".to_owned())]
    );
    let first = all[0].as_ref().unwrap();
    let expected: Vec<_> = VALUES.iter().map(|value| Some(value * 1e-9)).collect();
    assert_holds(&first.scan, (3e-6, Some(1e-6)), &expected, 1e-24);
    assert_eq!(first.format, ScanFormat::Gwyddion);
    assert_eq!(first.free_text, "Comment: tip radius 8 nm\n");
    assert_eq!(all[1].as_ref().unwrap().measure, Measure::Other("V".to_owned()));
    assert_eq!(all[3].as_ref().unwrap().measure, Measure::Length);
    // Without any unit the size must be given.
    refused!(all[2].as_ref().unwrap_err(), NoUnit { what: Unitless::Heights });
}

#[test]
fn an_image_without_units_takes_those_that_are_given() {
    let parts = [component("/0/data", b'o', field("", "", &VALUES))];
    let found = &heights_if_told(&file(&parts)).unwrap()[0];
    let expected = VALUES.map(|value| Some(value * 1e-9));
    assert_holds(&found.scan, (1e-6, Some(2.0 / 3.0 * 1e-6)), &expected, 1e-24);
}

#[test]
fn containers_of_version_1_are_read() {
    let found = heights(&old());
    assert_eq!(found[0].channel.as_deref(), Some("Old"));
    assert_holds(&found[0].scan, (3.0, Some(1.0)), &VALUES.map(Some), 0.0);
}

#[test]
fn a_mask_over_filled_in_points_makes_missing_points() {
    let filled = [1.0, 2.5, 3.0, 2.5, 5.0, 0.5];
    let found = heights(&masked(&filled, &[0.0, 1.0, 0.0, 0.7, 0.5, 0.0]));
    let expected = [Some(1.0), None, Some(3.0), None, Some(5.0), Some(0.5)];
    assert_holds(&found[0].scan, (3.0, Some(1.0)), &expected, 0.0);
    assert_eq!(
        found[0].notes,
        [
            "2 points under the mask of the file hold values that were filled in: they count as points without a height"
        ]
    );
    let zeros = heights(&masked(&[0.0, 0.0, 1.0, 2.0, 3.0, 0.0], &[0.0, 1.0, 0.0, 0.0, 0.0, 0.0]));
    assert_eq!(zeros[0].scan.missing_points().count(), 1);
}

#[test]
fn a_mask_over_interpolated_points_makes_missing_points() {
    let mut values: Vec<f64> = (0..49).map(|index| f64::from(index * 37 % 11)).collect();
    let covered: Vec<usize> = (16..=32).filter(|index| (2..5).contains(&(index % 7))).collect();
    let measured = values.clone();
    for _ in 0..100 {
        for &at in &covered {
            values[at] = (values[at - 7] + values[at - 1] + values[at + 1] + values[at + 7]) / 4.0;
        }
    }
    let mask: Vec<f64> = (0..49).map(|index| f64::from(u8::from(covered.contains(&index)))).collect();
    let missing = |values: &[f64]| {
        let image = component("/0/data", b'o', field_of([7, 7], "m", "m", values));
        let mask = component("/0/mask", b'o', field_of([7, 7], "m", "", &mask));
        heights(&file(&[image, mask]))[0].scan.missing_points().count()
    };
    assert_eq!((missing(&values), missing(&measured)), (9, 0));
}

#[test]
fn a_mask_over_other_points_is_told_and_changes_nothing() {
    for mask in [[1.0, 1.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]] {
        let found = heights(&masked(&VALUES, &mask));
        assert!(found[0].scan.missing_points().is_empty());
        let count = mask.iter().filter(|cover| **cover > 0.5).count();
        assert_eq!(
            found[0].notes,
            [format!("{count} points are marked by the mask of the file; they have heights, which count")]
        );
    }
    assert!(heights(&masked(&VALUES, &[0.0; 6]))[0].notes.is_empty());
}

#[test]
fn values_that_are_not_finite_are_missing_points() {
    let values = [1.0, f64::NAN, 3.0, 4.0, f64::INFINITY, 6.0];
    let found = heights(&masked(&values, &[0.0; 6]));
    assert_eq!(found[0].scan.missing_points().indices().collect::<Vec<_>>(), [1, 4]);
}

#[test]
fn curves_over_a_length_are_lines_behind_the_images() {
    let all: Vec<_> = channels(&graphs(), true).into_iter().map(Result::unwrap).collect();
    let names: Vec<_> = all.iter().map(|channel| channel.channel.as_deref()).collect();
    assert_eq!(names, [None, Some("Profile µ"), Some("Stylus"), Some("Falling"), Some("Deflection")]);
    assert_holds(&all[1].scan, (2.0, None), &[Some(4.0), Some(3.0), Some(2.0), Some(1.0)], 0.0);
    assert_holds(&all[2].scan, (4e-6, None), &[Some(1e-9), Some(2e-9), Some(3e-9)], 1e-24);
    let found: Vec<_> = all[2].scan.positions_m().unwrap().to_vec();
    assert!(found.iter().zip([0.0, 1e-6, 4e-6]).all(|(found, expected)| (found - expected).abs() < 1e-20));
    assert_holds(&all[3].scan, (1.2e-6, None), &[Some(4e-9), Some(3e-9), None, Some(1e-9)], 1e-24);
    assert_eq!(all[3].notes, ["positions fall from point to point: the profile is read from its end"]);
    assert_eq!(all[4].measure, Measure::Length);
}

#[test]
fn a_damaged_curve_stands_in_the_way_of_no_other() {
    let line = |description, x: &[f64], y: &[f64]| curve(description, x, y);
    let curves = [
        line("short", &[0.0, 1.0], &[1.0]),
        line("empty", &[], &[]),
        line("no place", &[0.0, f64::NAN], &[1.0, 2.0]),
        line("to and fro", &[0.0, 2.0, 1.0], &[1.0, 2.0, 3.0]),
        object("GwyGraphCurveModel", &[component("name", b'?', [])]),
        line("whole", &[0.0, 1.0], &[1.0, 2.0]),
    ];
    let broken = object("GwyGraphModel", &[component("name", b'?', [])]);
    let found = channels(
        &file(&[graph(1, ["m", "m"], "", &curves), component("/0/graph/graph/2", b'o', broken)]),
        false,
    );
    let messages: Vec<_> = found
        .iter()
        .map(|found| found.as_ref().map_or_else(ToString::to_string, |_| String::new()))
        .collect();
    let expected = [
        "/0/graph/graph/1, curve 1: 'ydata' is an array of 1 values, it must be an array of 2 values, as 'xdata' is; the \
         file is damaged: save it again from Gwyddion",
        "/0/graph/graph/1, curve 2: there is no component 'xdata'",
        "/0/graph/graph/1, curve 3: 'xdata' is no number at point 2, it must be an array of finite numbers",
        "position",
        "the type of a component is '?'",
        "",
        "the type of a component is '?'",
    ];
    assert_eq!(messages.len(), expected.len());
    for (message, expected) in messages.iter().zip(expected) {
        assert!(message.contains(expected) && message.is_empty() == expected.is_empty(), "{message}");
    }
    assert_eq!(
        heights(&file(&[graph(1, ["m", "m"], "Title", &curves[5..])]))[0].channel.as_deref(),
        Some("whole")
    );
}

#[test]
fn more_curves_than_any_file_has_are_refused() {
    let curves = vec![curve("", &[0.0], &[0.0]); 1025];
    let found = scans::read_scans(
        &file(&[graph(1, ["m", "m"], "", &curves)]),
        "scan",
        &scans::ScanOptions::default(),
    );
    refused!(found.unwrap_err(), BadField { field: "the number of channels", value: "at least 1025" });
    // Curves of no heights are none of them.
    let parts = [graph(1, ["m", "N"], "", &curves), component("/0/data", b'o', field("m", "m", &VALUES))];
    assert_eq!(heights(&file(&parts)).len(), 1);
}

#[test]
fn what_is_damaged_is_refused_with_its_place() {
    let message =
        |bytes: &[u8]| scans::read_scans(bytes, "scan", &scans::ScanOptions::default()).unwrap_err();
    let short = component("/0/data", b'o', field("m", "m", &VALUES[1..]));
    refused!(message(&file(&[short])), BadField { field: "'data'", value: "an array of 5 values" });
    let empty = component("/0/data", b'o', object("GwyDataField", &[]));
    refused!(message(&file(&[empty])), MissingField { field: "component 'xres'" });
    let negative = component("/0/data", b'o', object("GwyDataField", &[integer("xres", -3)]));
    refused!(message(&file(&[negative])), BadField { field: "'xres'", value: "-3" });
    let unknown = component("name", b'?', []);
    refused!(
        message(&file(&[unknown])),
        BadField { field: "the type of a component", value: "'?'", place: scans::FilePlace::Byte(26) }
    );
    refused!(
        message(&file(&[])),
        Unsupported { found: "a file without any image or profile, such as one of volume data" }
    );
    let mut cut = whole();
    cut.truncate(500);
    refused!(message(&cut), Truncated { needed: 1194, available: 479 });
}

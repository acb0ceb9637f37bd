//! Requests of the page, answered without a browser.

use std::collections::BTreeMap;

use questions::{BodyText, Unwatched};
use report::run_stamp::RunStamp;
use web::{Desk, EXAMPLES, FileKind, FileRequest, FileSight, Request, judged, pressed, products};

type Files = BTreeMap<String, Vec<u8>>;

fn example(key: &str) -> Request {
    Request { example: Some(key.to_owned()), ..Request::default() }
}

fn trace(header: &str) -> Vec<u8> {
    trace_of(header, 1e-7)
}

/// A trace of an amplitude [m].
fn trace_of(header: &str, amplitude_m: f64) -> Vec<u8> {
    let height = |at: usize| amplitude_m * ((at as f64 / 9.0).sin() + 0.3 * (at as f64 * 1.7).sin());
    let rows: String = (0..512).map(|at| format!("{},{}\n", at as f64 * 1e-6, height(at))).collect();
    format!("{header}\n{rows}").into_bytes()
}

fn file(name: &str) -> FileRequest {
    FileRequest { name: name.to_owned(), ..FileRequest::default() }
}

#[test]
fn every_example_answers_with_all_models() {
    for example_of_page in EXAMPLES {
        let reply = Desk::default().answer(&example(example_of_page.key), &Files::new()).unwrap();
        let screen = reply.screen.unwrap();
        assert!(screen.models.len() >= 5, "{}", example_of_page.key);
        assert!(screen.models.iter().any(|model| model.area_fraction.is_some_and(|area| area > 0.0)));
        assert!(reply.opened.unwrap().spectrum.figure.contains("<svg"));
    }
}

#[test]
fn a_slider_moves_the_answer_without_reading_the_surface_again() {
    let mut desk = Desk::default();
    let request = example("uncd-measured");
    let first = desk.answer(&request, &Files::new()).unwrap();
    let other = Request {
        pressure: Some("54 MPa".to_owned()),
        shortest_wavelength: Some("100 nm".to_owned()),
        ..request.clone()
    };
    let second = desk.answer(&other, &Files::new()).unwrap();
    assert!(second.opened.is_none());
    let area = |screen: Option<report::page::LiveScreen>| screen.unwrap().models[0].area_fraction.unwrap();
    assert!(area(second.screen) > area(first.screen));
    assert!(second.scene.contains("100 nm") && !first.scene.contains("cutoffs"));
    // Back at the first conditions the scene has no trace of the others.
    let third = desk.answer(&request, &Files::new()).unwrap();
    assert_eq!(third.scene, first.scene);
}

#[test]
fn scans_are_seen_and_answered() {
    let files = Files::from([("a.csv".to_owned(), trace("x (m),z (m)"))]);
    let sight = FileSight::new(&file("a.csv"), &files);
    assert_eq!(sight.kind, FileKind::Scan);
    assert!(
        sight.line.is_some() && sight.refusal.is_none() && sight.words.contains("Ra "),
        "{}",
        sight.words
    );
    let request = Request {
        files: vec![file("a.csv")],
        material: Some(BodyText { name: Some("steel C45".to_owned()), ..BodyText::default() }),
        ..Request::default()
    };
    let reply = Desk::default().answer(&request, &files).unwrap();
    let opened = reply.opened.unwrap();
    assert!(!opened.scans.is_empty() && opened.maps.is_empty());
    let lines = opened.spectrum.reading.lines;
    assert_eq!(lines.len(), 2, "the scan and the whole");
    assert!(opened.spectrum.figure.contains("ends at 2 pixels"), "{}", opened.spectrum.figure);
}

#[test]
fn the_other_face_is_that_of_a_scene_with_both() {
    let files = Files::from([
        ("ring.csv".to_owned(), trace("x (m),z (m)")),
        ("face.csv".to_owned(), trace_of("x (m),z (m)", 1e-8)),
        (
            "both.toml".to_owned(),
            b"[surface]\nscans = [\"ring.csv\"]\n[material]\nname = \"steel C45\"\n[counterface.surface]\nscans = [\"face.csv\"]\n\
              [loads]\npressures = [\"10 MPa\"]\n[interface]\n[seal]\n"
                .to_vec(),
        ),
    ]);
    let face = FileRequest { is_counterface: true, ..file("face.csv") };
    let steel = Some(BodyText { name: Some("steel C45".to_owned()), ..BodyText::default() });
    let answer = |request: &Request| Desk::default().answer(request, &files);
    let areas = |request: &Request| -> Vec<Option<f64>> {
        answer(request).unwrap().screen.unwrap().models.iter().map(|model| model.area_fraction).collect()
    };
    let own = Request { files: vec![file("ring.csv")], material: steel, seal: true, ..Request::default() };
    let both = Request { files: vec![file("ring.csv"), face.clone()], ..own.clone() };
    let scene = Request {
        files: vec![FileRequest { kind: FileKind::Scene, ..file("both.toml") }],
        ..Request::default()
    };
    assert_eq!(areas(&both), areas(&scene));
    assert_ne!(areas(&both), areas(&own));
    let [of_both, of_scene] =
        [&both, &scene].map(|request| answer(request).unwrap().screen.unwrap().interface);
    assert_eq!(of_both, of_scene);
    let reply = answer(&both).unwrap();
    assert!(reply.scene.contains("[counterface.surface]"), "{}", reply.scene);
    let opened = reply.opened.unwrap();
    assert!(["ring.csv", "face.csv"].iter().all(|name| opened.scans.contains(name)), "{}", opened.scans);
    // An example and a scene take another face as well.
    let with_face = |request: Request| Request {
        files: [&request.files[..], std::slice::from_ref(&face)].concat(),
        ..request
    };
    assert_ne!(areas(&with_face(example("uncd-measured"))), areas(&example("uncd-measured")));
    assert_eq!(areas(&with_face(scene.clone())), areas(&scene));
    // What is no face is refused by its name.
    let other = |kind| FileRequest { kind, is_counterface: true, ..file("both.toml") };
    let refused =
        |file| answer(&Request { files: vec![own.files[0].clone(), file], ..own.clone() }).unwrap_err();
    assert_eq!(refused(other(FileKind::Scene)).file.as_deref(), Some("both.toml"));
    assert!(refused(other(FileKind::Other)).message.contains("other face"));
    let alone = Request { files: vec![face.clone()], ..own.clone() };
    assert!(answer(&alone).is_err());
}

#[test]
fn scans_of_two_faces_are_asked_for_the_other_face() {
    let files = Files::from([
        ("ring.csv".to_owned(), trace("x (m),z (m)")),
        ("face.csv".to_owned(), trace_of("x (m),z (m)", 1e-8)),
    ]);
    let request = Request {
        files: vec![file("ring.csv"), file("face.csv")],
        material: Some(BodyText { name: Some("steel C45".to_owned()), ..BodyText::default() }),
        ..Request::default()
    };
    let notes = Desk::default().answer(&request, &files).unwrap().opened.unwrap().notes;
    assert!(notes.iter().any(|note| note.is_warning && note.text.contains("the other face")));
}

/// A map of 48 x 32 points in um, as text with a header of Gwyddion.
fn map_file() -> Vec<u8> {
    let (columns, rows) = (48, 32);
    let height = |at: usize| {
        let (x, y) = ((at % columns) as f64, (at / columns) as f64);
        1e-8 * ((x / 2.1).sin() * (y / 1.7).cos() + 0.4 * (1.3 * x + 0.7 * y).sin())
    };
    let mut text = "# Channel: Height\n# Width: 48 um\n# Height: 32 um\n# Value units: m\n".to_owned();
    for row in 0..rows {
        let line: Vec<String> =
            (0..columns).map(|column| height(row * columns + column).to_string()).collect();
        text += &(line.join("\t") + "\n");
    }
    text.into_bytes()
}

#[test]
fn a_map_of_a_scene_is_pressed_apart_from_it() {
    let files = Files::from([("map.txt".to_owned(), map_file())]);
    let request = Request {
        files: vec![file("map.txt")],
        material: Some(BodyText { name: Some("steel C45".to_owned()), ..BodyText::default() }),
        ..Request::default()
    };
    let mut desk = Desk::default();
    let opened = desk.answer(&request, &files).unwrap().opened.unwrap();
    assert_eq!(opened.maps, ["map.txt"]);
    let map = desk.map(&request, &files, 0).unwrap();
    assert!(map.question.is_whole() && map.heights.is_some(), "{}", map.words);
    // The page passes the map on as JSON.
    let question = serde_json::to_value(&map.question).unwrap();
    let press = |nominal_pressure_pa: f64| {
        let request = serde_json::json!({ "question": question, "nominal_pressure_pa": nominal_pressure_pa });
        pressed(&serde_json::from_value(request).unwrap(), |_| numerics::parallel::Unobserved).unwrap()
    };
    let [light, heavy] = [1e6, 1e7].map(press);
    assert!(light.area_fraction < heavy.area_fraction, "{} {}", light.area, heavy.area);
    let touching = heavy.states.iter().filter(|state| **state > 0).count() as f64;
    let counted = touching / heavy.states.len() as f64;
    assert!(heavy.quantities.iter().any(|(name, value)| *name == "points in contact"
        && (value.trim_end_matches(" %").parse::<f64>().unwrap() / (100.0 * counted) - 1.0).abs() < 0.01));
    assert!(desk.map(&request, &files, 1).is_err());
    assert!(desk.map(&example("uncd-measured"), &files, 0).is_err());
}

#[test]
fn a_file_without_a_unit_is_asked_for_it() {
    let text: String = (0..100).map(|at| format!("{}\n", at * at % 7)).collect();
    let files = Files::from([("plain.txt".to_owned(), text.into_bytes())]);
    let mut request = file("plain.txt");
    for (option, value) in [("unit", "um"), ("size", "1 mm")] {
        let refusal = FileSight::new(&request, &files).refusal.unwrap();
        assert_eq!(refusal.option, Some(option), "{}", refusal.message);
        request.options.insert(option.to_owned(), value.to_owned());
    }
    assert!(FileSight::new(&request, &files).refusal.is_none());
}

#[test]
fn files_that_cannot_be_used_are_refused_one_by_one() {
    let bad: [(&str, &[u8]); 4] = [
        ("empty.txt", b""),
        ("words.txt", b"no heights\n"),
        ("paper.pdf", b"%PDF-1.4\n"),
        ("a.zip", b"PK\x03\x04 no"),
    ];
    for (name, bytes) in bad {
        let files = Files::from([(name.to_owned(), bytes.to_vec())]);
        let sight = FileSight::new(&file(name), &files);
        assert!(sight.refusal.is_some() && sight.kind == FileKind::Other, "{name}: {sight:?}");
    }
}

#[test]
fn verdicts_follow_and_the_report_holds_the_same() {
    let request = example("gasket");
    let screen =
        judged(&mut Desk::default(), &request, &Files::new(), false, &Unwatched).unwrap().screen.unwrap();
    assert!(screen.models.iter().all(|model| model.verdict.is_some()));
    let made = products(&request, &Files::new(), &RunStamp::default(), &Unwatched).unwrap();
    let names: Vec<&str> = made.iter().map(|file| file.name.as_str()).collect();
    for name in ["scene.toml", "report.html", "answer.json", "persson.csv"] {
        assert!(names.contains(&name), "{names:?}");
    }
}

#[test]
fn bodies_of_a_scene_are_replaced_as_a_whole() {
    let steel = BodyText { name: Some("steel 100Cr6".to_owned()), ..BodyText::default() };
    let request =
        Request { material: Some(steel), counterface: Some(BodyText::default()), ..example("uncd-measured") };
    let reply = Desk::default().answer(&request, &Files::new()).unwrap();
    assert!(!reply.scene.contains("1.8 GPa") && reply.scene.contains("100Cr6"));
}

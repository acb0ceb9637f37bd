//! Errors of scenes, and keys without effect.

use scans::{ForeignFile, ScanFormat};
use scene::{Overrides, Scene, SceneError, SceneProblem};
use study::NoFiles;
use study::figure::{FigureStyle, PictureFormat};
use study::plan::Sampling;
use study::surface::SurfaceError;
use units::{Remark, RemarkCode};

const STEEL: &str = "[surface]\npsd = \"builtin:uncd-measured\"\n\
                     [material]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\nyield_strength = \"1 GPa\"\n\
                     strain_gradient_length = \"5 um\"\n[loads]\npressures = [\"1 MPa\"]\n";
const HERTZ: &str = "[[curve]]\nmodel = \"hertz\"\n";

fn parsed(text: &str) -> Result<Scene, SceneError> {
    Scene::parse(text, &NoFiles, &Overrides::default())
}

fn refused(sections: &str) -> SceneError {
    parsed(&format!("{STEEL}{sections}")).unwrap_err()
}

fn notes(sections: &str) -> Vec<(String, usize, RemarkCode)> {
    let scene = parsed(&format!("{STEEL}{sections}")).unwrap();
    let place = |note: Remark| Some((note.place.key?, note.place.line?, note.code));
    scene.notes.into_iter().filter_map(place).collect()
}

#[test]
fn keys_of_bodies_without_a_use_are_noted() {
    let keys = |text: &str| {
        let scene = parsed(text).unwrap();
        let key = |note: Remark| Some((note.place.key?, note.code));
        scene.notes.into_iter().filter_map(key).collect::<Vec<_>>()
    };
    let elastic = STEEL.replace("yield_strength = \"1 GPa\"\n", "");
    let growth = ("material.strain_gradient_length".to_owned(), RemarkCode::NoBodyYields);
    assert_eq!(keys(&format!("{elastic}{HERTZ}")), [growth]);
    assert_eq!(keys(&format!("{STEEL}{HERTZ}")), []);
    // The strength of the body that does not flow, whichever it is.
    let against = |strength: &str| {
        format!("{STEEL}{HERTZ}[counterface]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n{strength}")
    };
    let harder = |key: &str| (key.to_owned(), RemarkCode::OtherBodyYields);
    let of_counterface = against("indentation_hardness = \"6 GPa\"\n");
    assert_eq!(keys(&of_counterface), [harder("counterface.indentation_hardness")]);
    assert_eq!(keys(&against("indentation_hardness = \"3 GPa\"\n")), []);
    let of_material =
        against("yield_strength = \"100 MPa\"\n").replace("strain_gradient_length = \"5 um\"\n", "");
    assert_eq!(keys(&of_material), [harder("material.yield_strength")]);
    let spectrum = "[surface]\npsd = \"builtin:uncd-measured\"\n[counterface]\nname = \"gold\"\n\
                    [[figure]]\nname = \"psd\"\nshows = \"psd\"\n";
    assert_eq!(keys(spectrum), [("counterface.name".to_owned(), RemarkCode::NoCurveUsesIt)]);
}

#[test]
fn keys_of_curves_that_have_no_effect_are_noted_with_their_lines() {
    let idle = "[[curve]]\nmodel = \"hertz\"\nstrain_gradient = true\ninterference_law = \"bem\"\n";
    assert_eq!(
        notes(idle),
        [
            ("curve.strain_gradient".to_owned(), 12, RemarkCode::NeverYields),
            ("curve.interference_law".to_owned(), 13, RemarkCode::NoSuchOption),
        ]
    );
    let used = "[[curve]]\nmodel = \"ep-sphere\"\nstrain_gradient = true\n\
                [[curve]]\nmodel = \"elastic-sine\"\ninterference_law = \"bem\"\n";
    assert_eq!(notes(used), []);
    for beside in ["nix-gao", "power:0.2"] {
        let growing = notes(&format!(
            "[[curve]]\nmodel = \"persson-plastic\"\nhardness_law = \"{beside}\"\nstrain_gradient = true\n"
        ));
        let code = if beside == "nix-gao" { RemarkCode::Replaced } else { RemarkCode::OtherHardnessLaw };
        assert_eq!(growing, [("curve.strain_gradient".to_owned(), 13, code)]);
    }
    // A growth that is turned off says nothing of a model without one.
    let off = notes("[[curve]]\nmodel = \"hertz\"\nstrain_gradient = false\n");
    assert_eq!(off, [("curve.strain_gradient".to_owned(), 12, RemarkCode::NeverYields)]);
}

#[test]
fn keys_of_figures_that_have_no_effect_are_noted() {
    let figure = "[[figure]]\nname = \"f\"\nshows = \"psd\"\ncurves = [\"hertz\"]\ncutoff_multiples = [1, 2]\n\
                  loads = { from = \"1 Pa\", to = \"1 MPa\", points = 3 }\n";
    let found = notes(&format!("{HERTZ}{figure}"));
    let keys: Vec<&str> = found.iter().map(|(key, ..)| key.as_str()).collect();
    assert_eq!(keys, ["figure.curves", "figure.loads", "figure.cutoff_multiples"]);
    assert!(found.iter().all(|(.., reason)| *reason == RemarkCode::FigureShowsSomethingElse));
    // Settings of all figures, where no figure takes them, or each has its own.
    let area = "[[figure]]\nname = \"g\"\nshows = \"area\"\nwidth = \"80 mm\"\nmodels = [\"hertz\"]\n";
    let settings = "[figures]\nmodels = [\"hertz\"]\nloads = [\"1 MPa\"]\nwidth = \"60 mm\"\n";
    let idle = |figures: &str| -> Vec<String> {
        let found = notes(&format!("{HERTZ}{figures}{settings}"));
        found.into_iter().filter_map(|(key, ..)| Some(key.strip_prefix("figures.")?.to_owned())).collect()
    };
    assert_eq!(idle(figure), ["models", "loads"]);
    assert_eq!(idle(area), ["models", "width"]);
    assert_eq!(idle(&format!("{figure}{area}")), ["models"]);
    let drawn = figure.replace("\"psd\"", "\"area-against-load\"");
    assert_eq!(notes(&format!("{HERTZ}{drawn}")), []);
}

#[test]
fn settings_of_all_figures_hold_where_a_figure_has_none_of_its_own() {
    let steel = STEEL.replace("[\"1 MPa\"]", "[\"1 MPa\", \"2 MPa\"]");
    let curves = format!("{HERTZ}[[curve]]\nmodel = \"persson\"\n");
    let settings = "width = \"8.5 cm\"\nfont_size = 9\ntitle = false\nformat = [\"pdf\", \"svg\"]\nmodels = [\"hertz\"]\nloads = [\"2e6 Pa\"]\n";
    let table = parsed(&format!("{steel}{curves}[figures]\n{settings}")).unwrap();
    let style = FigureStyle { width_mm: Some(85.0), font_size_pt: Some(9.0), hides_title: true };
    let [all] = &table.figures[..] else { panic!("{:?}", table.figures) };
    assert_eq!((&all.style, &all.curves, &all.loads), (&style, &vec![0], &Some(vec![1])));
    assert_eq!(all.formats, [PictureFormat::Svg, PictureFormat::Pdf]);

    let own = "[[figure]]\nname = \"f\"\nshows = \"area\"\ntitle = \"t\"\nwidth = \"120 mm\"\n\
               models = [\"persson\"]\nloads = [\"1 MPa\"]\n[[figure]]\nname = \"g\"\nshows = \"area\"\n";
    let list = parsed(&format!("{steel}{curves}{own}[figures]\n{settings}")).unwrap();
    let [own, common] = &list.figures[..] else { panic!("{:?}", list.figures) };
    let wider = FigureStyle { width_mm: Some(120.0), hides_title: false, ..style };
    assert_eq!((&own.style, &own.curves, &own.loads), (&wider, &vec![1], &Some(vec![0])));
    assert_eq!((&common.style, &common.curves, &common.loads), (&style, &vec![0], &Some(vec![1])));
    assert_eq!(list.notes, []);
}

#[test]
fn wrong_settings_of_figures_are_refused_at_their_values() {
    for (key, value) in [
        ("width", "\"85\""),
        ("width", "\"2 mm\""),
        ("font_size", "100"),
        ("title", "3"),
        ("format", "[\"doc\"]"),
        ("models", "[\"hertzian\"]"),
        ("loads", "[\"3 MPa\"]"),
    ] {
        let figure = format!("[[figure]]\nname = \"f\"\nshows = \"area\"\n{key} = {value}\n");
        let text = format!("{STEEL}{HERTZ}{figure}");
        let error = parsed(&text).unwrap_err();
        assert_eq!(&text[error.span.unwrap()], value.trim_matches(['[', ']']), "{key}");
    }
    assert!(parsed(&format!("{STEEL}{HERTZ}[figure]\ntitle = false\n[figures]\ntitle = true\n")).is_err());
}

#[test]
fn options_and_cutoffs_that_have_no_effect_are_noted() {
    let options = "[cutoffs]\nshortest_wavelength = \"1 nm\"\n[options]\nhardness_formula = \"cosine\"\nstrength_cap = \"9 GPa\"\n\
                   interference_law = \"bem\"\namplitude = \"parseval\"\nnormalisation = \"as-printed\"\n";
    let keys = |curve: &str| -> Vec<String> {
        notes(&format!("{curve}{options}")).into_iter().map(|(key, ..)| key).collect()
    };
    assert_eq!(
        keys(HERTZ),
        [
            "cutoffs.shortest_wavelength",
            "options.amplitude",
            "options.hardness_formula",
            "options.strength_cap",
            "options.interference_law"
        ]
    );
    // Friction and gaps take moments by Parseval's theorem, whatever their normalisation.
    let theory = "[[curve]]\nmodel = \"persson\"\n[interface]\nshear_strength = \"1 MPa\"\n";
    assert!(keys(theory).contains(&"options.normalisation".to_owned()));
    let every = "[[curve]]\nmodel = \"ep-sphere\"\nstrain_gradient = true\n[[curve]]\nmodel = \"elastic-sine\"\n\
                 [[curve]]\nmodel = \"elastic\"\n";
    assert_eq!(keys(every), ["cutoffs.shortest_wavelength"]);
}

#[test]
fn draws_for_the_shares_of_one_uncertain_input_are_noted() {
    let idle = |hardness: &str, modulus: &str| {
        let text = STEEL.replace("\"1 GPa\"", hardness).replace("\"210 GPa\"", modulus);
        let scene = parsed(&format!("{text}{HERTZ}[uncertainty]\nshares_draws = 64\n")).unwrap();
        scene.notes.into_iter().map(|note| note.code).collect::<Vec<_>>()
    };
    assert_eq!(idle("\"1 GPa\"", "\"210 GPa\""), [RemarkCode::NothingScatters]);
    assert_eq!(idle("\"1 GPa +- 10 %\"", "\"210 GPa\""), [RemarkCode::OneInputScatters]);
    assert_eq!(idle("\"1 GPa\"", "\"210 GPa +- 10 GPa\""), [RemarkCode::OneInputScatters]);
    assert_eq!(idle("\"1 GPa +- 10 %\"", "\"210 GPa +- 10 GPa\""), []);
}

#[test]
fn a_tolerance_that_cannot_be_had_is_noted_and_the_used_one_reported() {
    let sections = format!("{HERTZ}[options]\ntolerance = 1e-300\n");
    assert_eq!(notes(&sections), [("options.tolerance".to_owned(), 13, RemarkCode::ToleranceTooFine)]);
    let scene = parsed(&format!("{STEEL}{sections}")).unwrap();
    assert!(scene.model_choices().contains(&"tolerance of statistical states: 1e-13".to_owned()));
}

#[test]
fn scenes_that_come_with_the_program_have_no_idle_keys() {
    // That of a new scene names a file of one's own.
    for template in scene::Template::ALL.iter().filter(|template| **template != scene::Template::New) {
        let scene = Scene::builtin(*template).unwrap();
        // Scenes of two metals give the strength of both, of which one flows.
        let is_idle = |note: &Remark| note.code != RemarkCode::OtherBodyYields;
        assert!(!scene.notes.iter().any(is_idle), "{:?}", scene.notes);
        assert_eq!(scene.sampling, Sampling::default());
    }
}

#[test]
fn names_whose_files_would_replace_others_are_refused() {
    let taken = |sections: &str, name: &str, by: &str| {
        let error = refused(sections);
        let SceneProblem::FileNameTaken { name: found, by: other } = &error.problem else {
            panic!("{error}")
        };
        assert_eq!((found.as_str(), other.as_str()), (name, by));
    };
    let named = |name: &str| format!("{HERTZ}name = \"{name}\"\n");
    for name in ["report-scales", "report-decades", "report-sensitivity", "report", "area-fraction"] {
        taken(&named(name), name, name);
    }
    taken(&named("Report"), "Report", "report");
    taken(&[named("A"), named("a")].concat(), "a", "A");
    let figure = "[[figure]]\nshows = \"psd\"\nname = ";
    taken(&format!("{HERTZ}{figure}\"HERTZ\"\n"), "HERTZ", "hertz");
    taken(&format!("{HERTZ}{figure}\"report-scales\"\n"), "report-scales", "report-scales");
    // Where the scene has figures of its own, none is drawn under this name.
    assert!(parsed(&format!("{STEEL}{}{figure}\"f\"\n", named("area-fraction"))).is_ok());
}

#[test]
fn unknown_keys_and_values_are_told_with_what_was_meant() {
    let unknown_key = |text: &str| match parsed(text).unwrap_err().problem {
        SceneProblem::UnknownKey { key, known, meant } => (key, known, meant),
        other => panic!("{other}"),
    };
    let in_steel = |text: &str| unknown_key(&format!("{STEEL}{text}"));
    let (key, _, meant) = in_steel("[[curve]]\nmodle = \"hertz\"\n");
    assert_eq!((key.as_str(), meant.as_deref()), ("modle", Some("model")));
    let (key, known, meant) = in_steel("[colour]\n");
    assert_eq!(
        (key.as_str(), &known[..2], meant),
        ("colour", &["title".to_owned(), "surface".to_owned()][..], None)
    );
    let (key, _, meant) = unknown_key("[surface]\nscans = [{ fiel = \"a.txt\" }]\n");
    assert_eq!((key.as_str(), meant.as_deref()), ("fiel", Some("file")));
    let error = refused("[[curve]]\nmodel = \"ep-spheres\"\n");
    let SceneProblem::UnknownValue { value, meant, .. } = &error.problem else { panic!("{error}") };
    assert_eq!((value.as_str(), meant.as_deref()), ("ep-spheres", Some("ep-sphere")));
    let figure = "[[figure]]\nname = \"f\"\nshows = \"area\"\ncurves = [\"herz\"]\n";
    assert_eq!(refused(&format!("{HERTZ}{figure}")).span.map(|span| span.len()), Some("\"herz\"".len()));
}

#[test]
fn values_of_another_kind_are_told_in_the_words_of_a_scene() {
    let wrong = |text: &str| match parsed(text).unwrap_err().problem {
        SceneProblem::WrongType { found, .. } => found,
        other => panic!("{other}"),
    };
    let material = "[material]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = \"x\"\n";
    assert_eq!(wrong(&format!("[surface]\npsd = \"builtin:uncd-measured\"\n{material}")), "string \"x\"");
    assert_eq!(wrong("[surface]\npsd = 5\n"), "integer 5");
    assert_eq!(wrong("[surface]\nscans = [5]\n"), "integer 5");
    let missing = parsed("[surface]\nscans = [{ unit = \"nm\" }]\n").unwrap_err();
    assert!(matches!(&missing.problem, SceneProblem::MissingKey { key } if key == "file"), "{missing}");
}

#[test]
fn a_scan_may_be_given_by_its_file_alone() {
    let heights = "0 0\n1e-6 1e-9\n2e-6 -1e-9\n3e-6 2e-9\n4e-6 0\n5e-6 1e-9\n6e-6 0\n7e-6 1e-9\n";
    let files = std::collections::BTreeMap::from([("a.txt".to_owned(), heights.as_bytes().to_vec())]);
    let scene = |scan: &str| {
        let text = format!("[surface]\nscans = [{scan}]\n[[figure]]\nname = \"f\"\nshows = \"psd\"\n");
        Scene::parse(&text, &files, &Overrides::default())
            .map(|scene| scene.surface.psd)
            .map_err(|e| e.to_string())
    };
    assert_eq!(scene("\"a.txt\""), scene("{ file = \"a.txt\" }"));
}

#[test]
fn errors_of_values_carry_key_and_value() {
    let error = refused(&format!("{HERTZ}[cutoffs]\nshortest_wavelength = \"5 GPa\"\n"));
    assert!(matches!(
        &error.problem,
        SceneProblem::Value { key, value, .. } if key == "cutoffs.shortest_wavelength" && value == "5 GPa"
    ));
}

#[test]
fn options_of_perssons_theory_tell_curves_apart() {
    let sections = "[[curve]]\nmodel = \"persson\"\ncorrection = \"algebraic-nayak\"\nband = \"1d\"\ngamma = 0.5\n\
                    [[curve]]\nmodel = \"persson\"\ngamma = 0.45\n\
                    [[curve]]\nmodel = \"persson-plastic\"\nhardness_law = \"power:0.25\"\n\
                    [[curve]]\nmodel = \"persson-plastic\"\nhardness_law = \"nix-gao\"\n\
                    [[curve]]\nmodel = \"persson-plastic\"\nname = \"other\"\nstrain_gradient = true\n";
    let scene = parsed(&format!("{STEEL}{sections}")).unwrap();
    assert_eq!(scene.notes, []);
    let curves = &scene.needs.curves;
    let names: Vec<&str> = curves.iter().map(|curve| curve.name.as_str()).collect();
    let expected = [
        "persson-algebraic-nayak-1d-gamma-0.5",
        "persson",
        "persson-plastic-power-0.25",
        "persson-plastic-strain-gradient",
        "other",
    ];
    assert_eq!(names, expected);
    assert_eq!(curves[3].model, curves[4].model);
    assert!(scene.needs.amplitudes.is_some());
}

#[test]
fn options_that_a_model_of_perssons_theory_ignores_are_noted_and_wrong_ones_refused() {
    let ignored = "[[curve]]\nmodel = \"persson\"\nhardness_law = \"nix-gao\"\n\
                   [[curve]]\nmodel = \"persson-plastic\"\nstrain_gradient = true\ncorrection = \"algebraic\"\n\
                   hardness_law = \"power:1\"\n[[curve]]\nmodel = \"hertz\"\nband = \"1d\"\n";
    assert_eq!(
        notes(ignored),
        [
            ("curve.hardness_law".to_owned(), 12, RemarkCode::NeverYields),
            ("curve.strain_gradient".to_owned(), 15, RemarkCode::OtherHardnessLaw),
            ("curve.correction".to_owned(), 16, RemarkCode::CorrectionsAreElastic),
            ("curve.band".to_owned(), 20, RemarkCode::NoSuchOption),
        ]
    );
    for (key, value) in [
        ("gamma", "0.0"),
        ("hardness_law", "\"power:-1\""),
        ("hardness_law", "\"table:none.csv\""),
        ("hardness_law", "\"steep\""),
    ] {
        let error = refused(&format!("[[curve]]\nmodel = \"persson-plastic\"\n{key} = {value}\n"));
        let SceneProblem::Value { key: found, .. } = &error.problem else { panic!("{error}") };
        assert_eq!(*found, format!("curve.{key}"));
        assert!(error.span.is_some());
    }
}

#[test]
fn a_hardness_is_read_from_a_table_beside_the_scene() {
    let curve = "[[curve]]\nmodel = \"persson-plastic\"\nhardness_law = \"table:h.csv\"\n";
    let csv = b"contact_size_m,hardness_pa\n1e-5,3e9\n1e-7,6e9\n".to_vec();
    let files = std::collections::BTreeMap::from([("h.csv".to_owned(), csv)]);
    let scene = Scene::parse(&format!("{STEEL}{curve}"), &files, &Overrides::default()).unwrap();
    assert_eq!(scene.needs.curves[0].name, "persson-plastic-hardness-table");
    assert!(scene.plan().compute().is_ok());
}

#[test]
fn heights_and_pictures_in_place_of_a_spectrum_are_named_as_what_they_are() {
    let files = std::collections::BTreeMap::from([
        ("trace.txt".to_owned(), b"X (mm),Z (um)\n0,0.5\n0.1,0.25\n0.2,0.75\n".to_vec()),
        ("bare.txt".to_owned(), b"0 1\n1 2\n2 1\n".to_vec()),
        ("psd.txt".to_owned(), b"1e-5 1e-20\n1e-6 1e-23\n".to_vec()),
        ("picture.png".to_owned(), b"\x89PNG\r\n\x1a\n".to_vec()),
    ]);
    let refused = |name: &str| {
        let text = format!("[surface]\npsd = \"{name}\"\n[[figure]]\nname = \"p\"\nshows = \"psd\"\n");
        match Scene::parse(&text, &files, &Overrides::default()).unwrap_err().problem {
            SceneProblem::Surface(error) => *error,
            other => panic!("{name}: {other}"),
        }
    };
    for name in ["trace.txt", "bare.txt"] {
        let error = refused(name);
        assert!(matches!(error, SurfaceError::Scan { format: ScanFormat::Text, .. }), "{error}");
    }
    assert!(matches!(refused("psd.txt"), SurfaceError::Spectrum { .. }));
    let picture = refused("picture.png");
    assert!(matches!(picture, SurfaceError::Foreign { kind: ForeignFile::Picture("PNG"), .. }), "{picture}");
}

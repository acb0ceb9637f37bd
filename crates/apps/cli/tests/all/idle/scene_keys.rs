//! The keys of scenes, as the reader of scenes knows them.

use std::sync::atomic::{AtomicUsize, Ordering};

use scene::{keys_by_section, with_keys};
use study::models::MODELS;

use super::walk::{Outcome, in_every, split};

/// Keys that change nothing by right: words of the scene in which, the end of their place, and the reason.
const IDLE_BY_RIGHT: &[(&str, &str, &str)] = &[
    ("psd.csv", "surface.column", "the file has one spectrum, which is read anyway"),
    ("psd.csv", "surface.x", "the header of the file says so"),
    ("yield_strength = \"900 MPa\"", "material.name", "a name gives only what is not given by itself"),
    ("pressures = [\"10 MPa\"]", "figures.loads", "all loads are drawn anyway"),
    (
        "two.001",
        "surface.scans.0.tip_radius",
        "points lie farther apart than the tip can hide; a warning goes",
    ),
    ("model = \"hertz\"", "options.tolerance", "its integrals have a closed form"),
    ("model = \"bgt\"", "options.tolerance", "likewise"),
    (
        "yield_strength = \"100 MPa\"\n[loads]",
        "curve.0.strain_gradient",
        "no growth is the default, and a growth is refused without its length",
    ),
    ("curves = [\"hertz\"]", "figure.0.curves", "the figure draws this curve anyway"),
    ("curves = [\"hertz\"]", "figure.0.models", "likewise"),
    ("curves = [\"hertz\"]", "figures.models", "likewise"),
    ("model = \"persson\"\n[", "figures.models", "the scene has no other model"),
    ("model = \"hertz\"\n[judge]", "figures.models", "likewise"),
    ("scans = [{ file = \"named.txt\" }]", "surface.scans", "the list has the same scan"),
    ("base = \"rigid\"", "material.layer.base", "an elastic base is refused without its constants"),
    ("yield_strength = \"900 MPa\"", "counterface.name", "a name gives only what is not given by itself"),
    ("yield_strength = \"100 MPa\"", "material.name", "a name gives only what is not given by itself"),
];

/// Scenes of every kind.
const SCENES: &[&str] = &[
    // Models that yield and models that do not, drawn, and judged.
    "[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nyield_strength = \"100 MPa\"\n\
     strain_gradient_length = \"1 um\"\n[loads]\npressures = [\"10 MPa\", \"50 MPa\"]\n\
     [[curve]]\nmodel = \"elastic-plastic\"\nstrain_gradient = true\n[[curve]]\nmodel = \"ep-sphere\"\n[[curve]]\nmodel = \"elastic-sine\"\n\
     [[figure]]\nname = \"area\"\nshows = \"area\"\n[[figure]]\nname = \"amplitude\"\nshows = \"amplitude\"\n[judge]\ngrid = 32\n\
     realisations = 2\n",
    // Persson's theory against a softer body whose strength grows, with a figure against the load.
    "[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nyield_strength = \"900 MPa\"\n\
     [counterface]\nyoungs_modulus = \"70 GPa\"\npoisson_ratio = 0.3\nyield_strength = \"100 MPa\"\nstrain_gradient_length = \"1 um\"\n\
     [loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \"persson-plastic\"\nhardness_law = \"nix-gao\"\n[[curve]]\nmodel = \"hertz\"\n\
     [[figure]]\nname = \"load\"\nshows = \"area-against-load\"\ncurves = [\"hertz\"]\nloads = { from = \"1 MPa\", to = \"50 MPa\", points = 3 }\n\
     [figures]\nwidth = \"80 mm\"\n[judge]\ngrid = 32\nrealisations = 2\n",
    // A force, against an elastic counterface, and the moments.
    "[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nyield_strength = \"100 MPa\"\n\
     [counterface]\nyoungs_modulus = \"70 GPa\"\npoisson_ratio = 0.3\n[loads]\nforce = \"1 N\"\nnominal_area = \"0.1 mm^2\"\n\
     [[curve]]\nmodel = \"persson\"\n[[figure]]\nname = \"moments\"\nshows = \"moments\"\n[cutoffs]\nshortest_wavelength = \"300 nm\"\n[judge]\ngrid = 32\nrealisations = 2\n",
    // No curve at all.
    "[surface]\npsd = \"psd.csv\"\n[[figure]]\nname = \"psd\"\nshows = \"psd\"\n",
    // Several scans, with their uncertainty; one; a map; without the analysis.
    "[surface]\nscans = [{ file = \"trace.txt\", unit = \"um\" }, { file = \"named.txt\" }]\n[material]\nname = \"silver\"\n\
     [loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \"persson\"\n[uncertainty]\ndraws = 20\n[judge]\ngrid = 32\nrealisations = 2\n",
    "[surface]\nscans = [{ file = \"named.txt\" }]\n[material]\nname = \"silver\"\n[loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \"hertz\"\n[judge]\ngrid = 32\nrealisations = 2\n",
    "[surface]\nscans = [{ file = \"map.txt\", unit = \"um\", size = \"10 um\" }, { file = \"holed.txt\" }]\n[material]\nname = \"silver\"\n\
     [loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \"persson\"\n[uncertainty]\noff = true\n[judge]\ngrid = 32\nrealisations = 2\n",
    "[surface]\nscans = [{ file = \"two.001\" }]\n[material]\nyoungs_modulus = { distribution = \"uniform\", from = \"70 GPa\", to = \"90 GPa\" }\n\
     poisson_ratio = 0.3\nindentation_hardness = { distribution = \"log-normal\", median = \"300 MPa\", standard_uncertainty = \"30 MPa\" }\n\
     [loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \"persson-plastic\"\n[judge]\ngrid = 32\n[uncertainty]\ndraws = 20\n",
    // The interface: gas, adhesion, shear, leakage, heat and current.
    "[surface]\npsd = \"psd.csv\"\n[material]\nname = \"silver\"\n[counterface]\nname = \"gold\"\n[loads]\npressures = [\"1 MPa\"]\n\
     [interface]\ngas = \"air\"\nwork_of_adhesion = \"50 mJ/m^2\"\nfriction = 0.3\nshare_of_sliding = 0.5\n[seal]\n\
     pressure_drop = \"1 bar\"\nviscosity = \"1 mPa s\"\nbreadth = \"1 mm\"\nlength = \"1 mm\"\n[judge]\ngrid = 32\nrealisations = 2\n",
    "[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\n[loads]\npressures = [\"1 MPa\"]\n\
     [interface]\nfriction = 0.3\ntangential_stress = \"100 kPa\"\n[[curve]]\nmodel = \"persson\"\n[judge]\ngrid = 32\nrealisations = 2\n",
    "[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\n[loads]\npressures = [\"1 MPa\"]\n[seal]\n[judge]\ngrid = 32\nrealisations = 2\n",
    "[surface]\npsd = \"psd.csv\"\n[material]\nname = \"silver\"\n[loads]\npressures = [\"1 MPa\"]\n[seal]\npressure_drop = \"1 bar\"\ngas = \"helium\"\n\
     leak_unit = \"g/year\"\nbreadth = \"1 mm\"\nlength = \"1 mm\"\n[judge]\ngrid = 32\nrealisations = 2\n",
    // A layer on its material and on a rigid base; roughness parameters in place of a spectrum.
    "[surface]\nrms_height = \"50 nm\"\nrms_slope = 0.05\nmean_width = \"20 um\"\n[material]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\n\
     [material.layer]\nthickness = \"5 um\"\nyoungs_modulus = \"20 GPa\"\npoisson_ratio = 0.4\n[loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \"persson\"\n[judge]\ngrid = 32\nrealisations = 2\n",
    "[surface]\nrms_height = \"50 nm\"\nrms_slope = 0.05\nrolloff_wavelength = \"20 um\"\nhurst = 0.8\n[material.layer]\nthickness = \"5 um\"\n\
     youngs_modulus = \"20 GPa\"\npoisson_ratio = 0.4\nbase = \"rigid\"\n[loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \"persson\"\n[judge]\ngrid = 32\nrealisations = 2\n",
    // Figures with settings of their own, one curve at the shortest cutoff, and a judge that is off.
    "[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"200 GPa +- 10 GPa\"\npoisson_ratio = 0.3\nyield_strength = \"100 MPa\"\n\
     [loads]\npressures = [\"0.01 H\", \"20 MPa\"]\n[[curve]]\nmodel = \"bgt\"\n[[curve]]\nmodel = \"hertz\"\ncutoffs = \"shortest\"\n\
     [[figure]]\nname = \"area\"\nshows = \"area\"\ntitle = \"own\"\nwidth = \"70 mm\"\nfont_size = 8\nformat = [\"svg\"]\n\
     loads = [\"20 MPa\"]\n[judge]\noff = true\n[uncertainty]\ndraws = 20\n",
    // A soft body that flows everywhere, in a seal, with draws of its hardness alone.
    "[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"10 GPa\"\npoisson_ratio = 0.4\nindentation_hardness = \"200 MPa +- 20 MPa\"\n\
     [counterface]\nname = \"steel C45\"\n[loads]\npressures = [\"150 MPa\"]\n[[curve]]\nmodel = \"persson-plastic\"\n\
     hardness_law = \"power:0.3\"\n[seal]\n[interface]\nwork_of_adhesion = \"40 mJ/m^2\"\n[judge]\ngrid = 32\nrealisations = 2\n\
     [uncertainty]\ndraws = 20\n",
    // Scans against scans, elastic, with heat and current through typed properties.
    "[surface]\nscans = [{ file = \"named.txt\" }]\n[material]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nresistivity = \"2e-8 ohm m\"\n\
     thermal_conductivity = \"20 W/(m K)\"\n[counterface]\nyoungs_modulus = \"70 GPa\"\npoisson_ratio = 0.2\nresistivity = \"3e-8 ohm m\"\n\
     thermal_conductivity = \"30 W/(m K)\"\nsurface = { scans = [{ file = \"map.txt\", unit = \"um\", size = \"10 um\" }] }\n[loads]\n\
     force = \"2 N\"\nnominal_area = \"1 mm^2\"\n[[curve]]\ncorrection = \"algebraic\"\nmodel = \"persson\"\n[judge]\ngrid = 32\nrealisations = 2\n\
     [uncertainty]\ndraws = 20\n",
    // All models, a tangential load and a layer's worth of numbers without draws.
    "[surface]\nrms_height = \"20 nm\"\nrms_slope = 0.02\nmean_width = \"10 um\"\n[material]\nname = \"gold\"\n[counterface]\nname = \"silver\"\n\
     [loads]\npressures = [\"5 MPa\", \"10 MPa\"]\n[interface]\ntangential_stress = \"1 MPa\"\nfriction = 0.4\n[judge]\ngrid = 32\n\
     realisations = 2\nall_models = true\n[uncertainty]\noff = true\n",
    // A counterface that is rough as well.
    "[surface]\npsd = \"psd.csv\"\n[material]\nname = \"silver\"\n[counterface]\nname = \"gold\"\nsurface = { psd = \"psd.csv\" }\n\
     [loads]\npressures = [\"10 MPa\"]\n[[curve]]\nmodel = \"bgt\"\n[judge]\ngrid = 32\nrealisations = 2\n",
];

/// A model alone, its material, and its words.
fn scenes() -> Vec<String> {
    let of_model = |name: &str| {
        format!(
            "[surface]\npsd = \"psd.csv\"\n[material]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nyield_strength = \"100 MPa\"\n\
             [loads]\npressures = [\"10 MPa\", \"50 MPa\"]\n[[curve]]\nmodel = \"{name}\"\n[[figure]]\nname = \"area\"\nshows = \"area\"\n\
             [judge]\ngrid = 32\nrealisations = 2\n"
        )
    };
    SCENES
        .iter()
        .map(|&scene| scene.to_owned())
        .chain(MODELS.iter().map(|entry| of_model(entry.name)))
        .collect()
}

/// The words of a key that takes one of several, as TOML.
fn words(key: &str) -> Option<Vec<String>> {
    macro_rules! named {
        ($type:ty) => {
            <$type>::ALL.iter().map(|value| format!("\"{}\"", value.name())).collect()
        };
    }
    Some(match key {
        "x" => named!(spectrum::Abscissa),
        "convention" => named!(spectrum::Convention),
        "detrend" => named!(topography::Detrend),
        "window" => named!(topography::Window),
        "average" => named!(topography::Average),
        "line_average" => named!(topography::LineAverage),
        "gaps" => named!(topography::GapTreatment),
        "direction" => named!(topography::Direction),
        "base" => named!(study::layer_base::LayerBase),
        "interference_law" => named!(stat_contact::InterferenceLaw),
        "flattening" => named!(stat_contact::Flattening),
        "elastic_plastic_area" => named!(stacked_contact::YieldingAreaLaw),
        "correction" => named!(persson::corrections::Correction),
        "band" => named!(persson::Band),
        "normalisation" => named!(spectrum::Normalisation),
        "amplitude" => named!(spectrum::AmplitudeDefinition),
        "hardness_formula" => named!(asperity::Hardness),
        "gas" => named!(interface::gas::NamedGas),
        "leak_unit" => named!(interface::sealed_fluid::LeakUnit),
        "strain_gradient" | "all_models" | "off" | "remove_spikes" => {
            vec!["true".to_owned(), "false".to_owned()]
        }
        _ => return None,
    })
}

/// Values of each other key that matter, by the end of its place, as TOML.
const VALUES: &[(&str, &[&str])] = &[
    ("surface.psd", &["\"builtin:uncd-measured\"", "\"builtin:contact-challenge\""]),
    ("column", &["\"C1D_m3\"", "\"other\""]),
    ("series", &["\"a\"", "\"b\""]),
    ("subject", &["\"a\"", "\"b\""]),
    ("x_unit", &["\"um\"", "\"nm\""]),
    ("psd_unit", &["\"um^3\"", "\"nm^3\""]),
    ("surface.scans", &["[\"trace.txt\"]", "[\"named.txt\"]"]),
    ("bins_per_decade", &["3", "5"]),
    ("rms_height", &["\"70 nm\"", "\"30 nm\""]),
    ("rms_slope", &["0.04", "0.06"]),
    ("mean_width", &["\"15 um\"", "\"30 um\""]),
    ("rolloff_wavelength", &["\"15 um\"", "\"30 um\""]),
    ("hurst", &["0.7", "0.9"]),
    ("file", &["\"named.txt\"", "\"heights.xlsx\""]),
    ("height_unit", &["\"nm\"", "\"mm\""]),
    ("unit", &["\"nm\"", "\"mm\""]),
    ("channel", &["\"Height\"", "\"Height Sensor\""]),
    ("size", &["\"7 um\"", "\"20 um\""]),
    ("tip_radius", &["\"3 um\"", "\"10 um\""]),
    ("scans.0.shortest_wavelength", &["\"2 um\"", "\"3 um\""]),
    ("cutoffs.shortest_wavelength", &["\"500 nm\"", "\"1 um\""]),
    ("instrument", &["\"one\"", "\"two\""]),
    ("z_calibration", &["\"2 %\"", "\"30 %\""]),
    ("slope_uncertainty", &["0.1", "0.3"]),
    ("material.name", &["\"gold\"", "\"steel C45\""]),
    ("counterface.name", &["\"silver\"", "\"steel C45\""]),
    ("name", &["\"one\"", "\"two\""]),
    ("youngs_modulus", &["\"70 GPa\"", "\"300 GPa\""]),
    ("poisson_ratio", &["0.1", "0.45"]),
    ("yield_strength", &["\"50 MPa\"", "\"600 MPa\""]),
    ("indentation_hardness", &["\"150 MPa\"", "\"2 GPa\""]),
    ("strain_gradient_length", &["\"300 nm\"", "\"5 um\""]),
    ("thermal_conductivity", &["\"10 W/(m K)\"", "\"300 W/(m K)\""]),
    ("resistivity", &["\"1e-8 ohm m\"", "\"1e-7 ohm m\""]),
    (
        "material.layer",
        &[
            "{ thickness = \"1 um\", youngs_modulus = \"2 GPa\", poisson_ratio = 0.4 }",
            "{ thickness = \"2 um\", youngs_modulus = \"2 GPa\", poisson_ratio = 0.4 }",
        ],
    ),
    ("thickness", &["\"1 um\"", "\"3 um\""]),
    ("counterface.surface", &["{ psd = \"psd.csv\" }", "{ psd = \"builtin:uncd-measured\" }"]),
    ("pressures", &["[\"5 MPa\"]", "[\"20 MPa\"]"]),
    ("force", &["\"2 N\"", "\"3 N\""]),
    ("nominal_area", &["\"1 mm^2\"", "\"2 mm^2\""]),
    ("model", &["\"elastic\"", "\"bgt\""]),
    ("gamma", &["0.6", "\"fitted\""]),
    ("hardness_law", &["\"power:0.2\"", "\"nix-gao\""]),
    ("curve.0.cutoffs", &["\"shortest\"", "\"all\""]),
    ("shows", &["\"psd\"", "\"amplitude\"", "\"moments\"", "\"area\""]),
    ("figures.title", &["true", "false"]),
    ("title", &["\"one\"", "\"two\""]),
    ("curves", &["[\"hertz\"]", "[\"persson\"]"]),
    ("models", &["[\"hertz\"]", "[\"persson\"]"]),
    ("loads", &["[\"10 MPa\"]", "[\"50 MPa\"]", "{ from = \"2 MPa\", to = \"30 MPa\", points = 4 }"]),
    ("cutoff_multiples", &["[1.0, 2.0]", "[1.0, 4.0]"]),
    ("width", &["\"85 mm\"", "\"60 mm\""]),
    ("format", &["[\"svg\", \"pdf\"]", "[\"png\"]"]),
    ("font_size", &["7", "12"]),
    ("scales_per_decade", &["7", "13"]),
    ("strength_cap", &["\"120 MPa\"", "\"250 MPa\""]),
    ("tolerance", &["1e-3", "1e-5"]),
    ("grid", &["64", "48"]),
    ("realisations", &["3", "4"]),
    ("seed", &["5", "7"]),
    ("budget", &["1e4", "1e6"]),
    ("level", &["0.5", "0.8"]),
    ("draws", &["30", "40"]),
    ("shares_draws", &["64", "70"]),
    ("shear_strength", &["\"100 MPa\"", "\"200 MPa\""]),
    ("work_of_adhesion", &["\"20 mJ/m^2\"", "\"80 mJ/m^2\""]),
    ("range_of_attraction", &["\"1 nm\"", "\"3 nm\""]),
    ("gas_temperature", &["\"400 K\"", "\"500 K\""]),
    ("gas_pressure", &["\"10 kPa\"", "\"1 MPa\""]),
    ("gas_conductivity", &["\"0.1 W/(m K)\"", "\"0.2 W/(m K)\""]),
    ("gas_parameter", &["\"100 nm\"", "\"1 um\""]),
    ("flatness", &["\"1 um over 10 mm\"", "\"5 um over 40 mm\""]),
    ("friction", &["0.2", "0.5"]),
    ("tangential_stress", &["\"50 kPa\"", "\"200 kPa\""]),
    ("share_of_sliding", &["0.3", "0.8"]),
    ("percolation_threshold", &["0.4", "0.45"]),
    ("pressure_drop", &["\"2 bar\"", "\"5 bar\""]),
    ("outlet_pressure", &["\"1 kPa\"", "\"2 bar\""]),
    ("viscosity", &["\"2 mPa s\"", "\"5 mPa s\""]),
    ("breadth", &["\"2 mm\"", "\"5 mm\""]),
    ("length", &["\"2 mm\"", "\"5 mm\""]),
];

fn values(place: &str) -> Vec<String> {
    let key = place.rsplit('.').next().unwrap();
    let is_meant = |end: &str| place == end || place.ends_with(&format!(".{end}"));
    words(key).unwrap_or_else(|| {
        let found = VALUES.iter().find(|(end, _)| is_meant(end));
        let (_, values) = found.unwrap_or_else(|| panic!("give two values of {place} that matter"));
        values.iter().map(|&value| value.to_owned()).collect()
    })
}

/// The scene with a key set; none where it has no such section.
fn with_key(scene: &str, place: &str, value: &str) -> Option<String> {
    let value = format!("v = {value}").parse::<toml::Table>().unwrap().remove("v").unwrap();
    with_keys(scene, [(place, value)]).ok()
}

/// Every place of a key.
fn places() -> Vec<String> {
    let sections = keys_by_section();
    let of_surface =
        |keys: &[String]| keys.iter().map(|key| format!("counterface.surface.{key}")).collect::<Vec<_>>();
    let mut places = vec!["title".to_owned()];
    for (section, keys) in &sections {
        let at = if matches!(*section, "curve" | "figure") { ".0" } else { "" };
        places.extend(keys.iter().map(|key| format!("{section}{at}.{key}")));
        if *section == "surface" {
            places.extend(of_surface(keys));
        }
    }
    places
}

/// Walks one of so many pairs of a key and a scene. Returns how many.
fn walk(step: usize) -> usize {
    let scenes = scenes();
    // What a model alone decides is walked for each model.
    let of_model = ["curve.", "options.", "material."];
    let is_walked = |at: usize, place: &String| {
        at < SCENES.len() || of_model.iter().any(|start| place.starts_with(start))
    };
    let mut count = 0..;
    let contexts: Vec<(&String, Vec<String>)> = scenes
        .iter()
        .enumerate()
        .map(|(at, scene)| {
            let places = places().into_iter().filter(|place| is_walked(at, place));
            (
                scene,
                places
                    .filter(|_| count.next().is_some_and(|count: usize| count.is_multiple_of(step)))
                    .collect(),
            )
        })
        .collect();
    let walked = AtomicUsize::new(0);
    let silent = in_every(&contexts, |folder, (scene, places)| {
        let mut run = |text: &str| {
            folder.write("scene.toml", text);
            folder.run(&split("run scene.toml --no-report --out o")).without_comments()
        };
        let usual = run(scene);
        assert_eq!(usual.status, 0, "{scene}{}", usual.said);
        assert_eq!(run(&format!("{scene}\n# a comment\n")), usual, "what comes out repeats the scene");
        let mut silent = Vec::new();
        for place in places {
            let section = place.rsplit_once('.').map_or("", |(section, _)| section);
            let has_none =
                !section.contains('.') && !section.is_empty() && !scene.contains(&format!("[{section}]\n"));
            let usual = if has_none { run(&format!("{scene}[{section}]\n")) } else { usual.clone() };
            let found: Vec<Outcome> =
                values(place).iter().filter_map(|value| Some(run(&with_key(scene, place, value)?))).collect();
            walked.fetch_add(usize::from(!found.is_empty()), Ordering::Relaxed);
            let key = place.rsplit('.').next().unwrap();
            let names = |said: &str| {
                let list = section.split('.').next().unwrap_or_default();
                said.contains(key) || (!section.is_empty() && said.contains(&format!("[{list}]")))
            };
            if !found.is_empty() && found.iter().all(|found| found.status != 0 && !names(&found.said)) {
                silent.push(format!("UNNAMED {place}: {} in {scene}", found[0].said));
            }
            let accepted: Vec<_> = found.iter().filter(|found| found.status == 0).collect();
            let is_idle = accepted.iter().all(|found| *found == accepted[0])
                // Keys that were in the scene before are named before.
                && accepted.first().is_some_and(|found| !found.said.contains(key))
                && (usual.status != 0 && accepted.len() > 1 || *accepted[0] == usual);
            let is_right =
                |(words, end, _): &(&str, &str, &str)| scene.contains(words) && place.ends_with(end);
            // Of a key of a few words, all but the usual one may be refused.
            let is_refused = words(key).is_some()
                && found.iter().any(|found| found.status != 0 && found.said.contains(key));
            if is_idle && !is_refused && !IDLE_BY_RIGHT.iter().any(is_right) {
                silent.push(format!("SILENT {place} in {scene}"));
            }
        }
        silent
    });
    assert!(
        silent.is_empty(),
        "{}\n{}",
        silent.len(),
        silent.iter().map(|line| line.replace('\n', " ") + "\n").collect::<String>()
    );
    walked.into_inner()
}

#[test]
fn keys_of_scenes_change_something_or_are_named() {
    let walked = walk(7);
    assert!(walked > 250, "{walked} keys");
}

#[test]
#[ignore = "takes minutes: .ci/slow runs it"]
fn every_key_of_every_scene_changes_something_or_is_named() {
    let walked = walk(1);
    assert!(walked > 1500, "{walked} keys");
}

//! The options of every command, as clap knows them.

use std::sync::atomic::{AtomicUsize, Ordering};

use clap::{Arg, ArgAction, CommandFactory};

use super::walk::{Folder, Outcome, in_every, split};

/// Options that change nothing by right, each with words of the contexts in which, and its reason.
const IDLE_BY_RIGHT: &[(&str, &str, &str)] = &[
    ("report", "open", "shows the report, which no test does"),
    ("--youngs-modulus 200GPa", "material", "a name gives only what is not given by itself"),
    ("--layer-base rigid", "material", "likewise of the body below a layer"),
    ("--counterface-youngs-modulus", "on", "likewise for the counterface"),
    ("--no-report", "provenance", "the report alone quotes the command"),
    ("scan in/trace.txt", "all_channels", "a file of one channel has no other"),
    ("scan in/named.txt", "all_channels", "likewise"),
    ("50MPa --model hertz", "tolerance", "its integrals have a closed form"),
    ("50MPa --model bgt", "tolerance", "likewise"),
    ("1e-6 --model hertz", "tolerance", "likewise"),
    ("1e-6 --model bgt", "tolerance", "likewise"),
    ("--cylinder-radius", "tolerance", "few points agree to all printed digits at any tolerance"),
    ("--model elastic-plastic --material silver --on gold", "gamma", "all flows, and there is no gap"),
    ("50MPa --model elastic-plastic --youngs-modulus 200GPa", "gamma", "likewise"),
    (
        "--form exponential",
        "yield_strength",
        "the model needs it, and light loads are those of the elastic theory",
    ),
    ("--form exponential", "indentation_hardness", "likewise"),
    ("--summit-density", "provenance", "comments are always there, and no path is typed"),
    (
        "flow in/map.txt",
        "size",
        "flow factors have no size where points are evenly spaced in both directions",
    ),
];

/// Bodies: elastic, yielding by each property, growing, named, against another body, under a layer.
const BODIES: &[&str] = &[
    "--youngs-modulus 200GPa --poisson-ratio 0.3",
    "--youngs-modulus 200GPa --poisson-ratio 0.3 --indentation-hardness 300MPa",
    "--youngs-modulus 200GPa --poisson-ratio 0.3 --yield-strength 100MPa --strain-gradient-length 1um",
    "--material silver --on gold",
    "--youngs-modulus 200GPa --poisson-ratio 0.3 --counterface-youngs-modulus 70GPa --counterface-poisson-ratio 0.2",
    "--youngs-modulus 200GPa --poisson-ratio 0.3 --layer-thickness 5um --layer-youngs-modulus 20GPa --layer-poisson-ratio 0.4",
    "--layer-thickness 5um --layer-youngs-modulus 20GPa --layer-poisson-ratio 0.4 --layer-base rigid",
];

/// Commands with the words that they need, and alternatives of which each context takes one; `*` stands for every value of the
/// option before it.
type Walk = (&'static str, &'static str, &'static [&'static [&'static str]]);

const WALKS: &[Walk] = &[
    ("moments", "psd.csv", &[]),
    ("amplitude", "psd.csv", &[]),
    ("fit", "psd.csv", &[&["", "--from 8um --to 200nm"]]),
    ("stacked", "psd.csv --pressure 50MPa", &[&["--model *"], BODIES]),
    (
        "statistical",
        "psd.csv --tolerance 1e-6",
        &[&["--model *"], BODIES, &["--pressure 50MPa", "--separation 10nm"]],
    ),
    ("statistical", "--input rows.csv --tolerance 1e-6", &[&["--model *"], BODIES, &["--pressure 50MPa"]]),
    ("statistical", "--input full.csv --tolerance 1e-6", &[&["", "--given pressure"]]),
    (
        "persson",
        "psd.csv --pressure 50MPa",
        &[
            &["--model *"],
            BODIES,
            &["", "--hardness-law power:0.2", "--hardness-law nix-gao", "--correction algebraic-nayak"],
        ],
    ),
    ("persson", "--input flat.csv", &[&["", "--model *"], &["", "--indentation-hardness 300MPa"]]),
    ("persson", "--input hard.csv", &[&["", "--model *"]]),
    ("gap", "psd.csv --pressure 50MPa", &[&["--model *"], BODIES]),
    ("tangential", "psd.csv --pressure 50MPa --friction 0.3", &[&["--model *"], BODIES]),
    (
        "law",
        "in/psd.csv --pressure-range 1MPa:50MPa --error 0.1",
        &[
            &["--model *"],
            BODIES,
            &[
                "",
                "--form exponential",
                "--quantity heat --thermal-conductivity 20W/(mK) --counterface-thermal-conductivity 40W/(mK)",
                "--quantity heat --thermal-conductivity 20W/(mK) --counterface-thermal-conductivity 40W/(mK) --gas air",
                "--quantity current --resistivity 2e-8ohmm --counterface-resistivity 3e-8ohmm",
            ],
            &["--dialect calculix"],
        ],
    ),
    (
        "law",
        "in/psd.csv --pressure-range 1MPa:50MPa --error 0.1 --model hertz --material silver",
        &[&["--dialect *"]],
    ),
    (
        "law",
        "in/psd.csv --quantity asperity-pressure --dialect csv --separation-range 0.5:3",
        &[
            &["--model persson", "--model hertz", "--model bem --grid 32 --realisations 1 --shortest 2um"],
            BODIES,
        ],
    ),
    (
        "law",
        "--quantity asperity-pressure --dialect csv --separation-range 0.5:3 --summit-density 1e12/m^2 --summit-radius 1um \
         --rms-height 10nm",
        &[BODIES],
    ),
    (
        "law",
        "in/map.txt:unit=um,size=10um --model bem --as-scanned --material silver --quantity asperity-pressure --dialect csv \
         --pressure-range 1MPa:50MPa",
        &[],
    ),
    ("bem", "psd.csv --grid 32 --realisations 1 --shortest 2um", &[BODIES, PRESSED]),
    ("bem", "map.txt --unit um --size 10um", &[BODIES, PRESSED]),
    (
        "bem",
        "map.txt --unit um --size 10um --material silver --pressure 50MPa --flow",
        &[&["", "--boundary periodic"]],
    ),
    ("flow", "in/map.txt:unit=um,size=10um", &[]),
    ("flow", "in/map.txt", &[&["--unit um --size 10um"]]),
    ("scan", "in/trace.txt:unit=um", &[]),
    ("scan", "in/named.txt map.txt:unit=um,size=10um", &[&["", "--figure f.svg"]]),
    ("scan", "two.001", &[&["", "--channel Phase"]]),
    ("roughness", "trace.txt:unit=um", &[&["", "--scales"]]),
    ("roughness", "named.txt", &[&["", "--scales"]]),
    ("roughness", "map.txt --unit um --size 10um", &[&["", "--scales"]]),
    ("psd", "in/trace.txt:unit=um", &[&["", "--per-scan"]]),
    ("psd", "in/named.txt", &[]),
    ("psd", "in/named.txt in/psd.csv --sum", &[]),
    (
        "gap",
        "in/trace.txt:unit=um --model persson --pressure 50MPa --youngs-modulus 200GPa --poisson-ratio 0.3",
        &[],
    ),
    ("psd", "--list in/list.csv", &[]),
    ("psd", "in/map.txt --unit um --size 10um", &[&["", "--areal"]]),
    ("psd", "in/holed.txt", &[&["", "--areal"]]),
    ("report", "in/psd.csv --material silver --pressure 50MPa --out o", &[]),
    ("report", "in/trace.txt:unit=um --material silver --pressure 50MPa --out o", &[]),
    ("report", "in/map.txt:unit=um,size=10um --material silver --pressure 50MPa --out o", &[]),
    ("run", "in/scene.toml --out o", &[&["", "--no-report"]]),
    ("run", "in/scene.toml --dry-run", &[]),
    ("figure", "scene.toml --out o", &[&["", "--picture *"]]),
    ("scene", "new", &[]),
    ("completions", "bash", &[]),
    ("man", "--out o", &[]),
    ("asperity sphere", "--input spheres.csv", &[]),
    ("asperity sinusoid", "--input sinusoids.csv", &[]),
    ("asperity sinusoid-interference", "--input pressed.csv", &[]),
];

/// Random surfaces that take no time.
const GRID: &str = "--grid 32 --realisations 1 --shortest 2um";

/// Ways to press a surface by elements.
const PRESSED: &[&str] = &[
    "--pressure 50MPa",
    "--pressure 50MPa --saturation 200MPa",
    "--ball-radius 1mm --force 1mN",
    "--cylinder-radius 1mm --force-per-length 10N/m",
    "--work-of-adhesion 50mJ/m^2 --adhesion-range 1um --pressure 50MPa",
    "--work-of-adhesion 50mJ/m^2 --adhesion-range 1um --pull-off",
];

/// Two values of each option that matter, by its name or else by the name of its value.
const VALUES: &[(&str, [&str; 2])] = &[
    ("input", ["rows.csv", "hard.csv"]),
    ("list", ["list.csv", "other.csv"]),
    ("output", ["out.csv", "out.csv"]),
    ("figure", ["g.svg", "h.svg"]),
    ("write", ["heights.nc", "heights.gsf"]),
    ("out", ["elsewhere", "elsewhere"]),
    ("material", ["silver", "gold"]),
    ("on", ["silver", "gold"]),
    ("column", ["C1D_m3", "wavelength_m"]),
    ("counterface_scans", ["in/trace.txt:unit=um", "in/named.txt"]),
    ("counterface_psd", ["in/psd.csv", "builtin:contact-challenge"]),
    ("series", ["a", "b"]),
    ("subject", ["a", "b"]),
    ("x_unit", ["um", "nm"]),
    ("psd_unit", ["um^3", "nm^3"]),
    ("channel", ["a", "b"]),
    ("unit", ["nm", "mm"]),
    ("youngs_modulus", ["70GPa", "300GPa"]),
    ("counterface_youngs_modulus", ["70GPa", "300GPa"]),
    ("layer_youngs_modulus", ["2GPa", "300GPa"]),
    ("yield_strength", ["20MPa", "150MPa"]),
    ("indentation_hardness", ["60MPa", "450MPa"]),
    ("strength_cap", ["120MPa", "250MPa"]),
    ("saturation", ["100MPa", "300MPa"]),
    ("pressures", ["20MPa", "80MPa"]),
    ("pressure", ["20MPa", "80MPa"]),
    ("pressure_ranges", ["10MPa:60MPa:2", "1MPa:60MPa:2"]),
    ("pressure_range", ["2MPa:40MPa", "1MPa:10MPa"]),
    ("separation_range", ["0.6:2", "1:2.5"]),
    ("summit_density", ["2e12/m^2", "5e11/m^2"]),
    ("summit_radius", ["2um", "500nm"]),
    ("rms_height", ["20nm", "5nm"]),
    ("gas_pressure", ["10kPa", "1MPa"]),
    ("gas", ["air", "helium"]),
    ("gas_temperature", ["400K", "500K"]),
    ("hardness_law", ["power:0.3", "nix-gao"]),
    ("gamma", ["0.6", "fitted"]),
    ("tolerance", ["1e-3", "1e-5"]),
    ("error", ["0.02", "0.2"]),
    ("friction", ["0.2", "0.5"]),
    ("stresses", ["1MPa", "3MPa"]),
    ("name", ["ONE", "TWO"]),
    ("title", ["one", "two"]),
    ("separations", ["5nm", "20nm"]),
    ("scales_per_decade", ["7", "13"]),
    ("bins_per_decade", ["3", "5"]),
    ("grid", ["64", "48"]),
    ("realisations", ["2", "3"]),
    ("seed", ["5", "7"]),
    ("side", ["20um", "30um"]),
    ("height_unit", ["nm", "mm"]),
    ("size", ["7um", "20um"]),
    ("tip_radius", ["3um", "10um"]),
    ("filter", ["3um", "1um"]),
    ("short_filter", ["200nm", "1um"]),
    ("ratio_height", ["10nm", "-10nm"]),
    ("strain_gradient_length", ["300nm", "5um"]),
    ("layer_thickness", ["1um", "3um"]),
    ("ball_radius", ["2mm", "500um"]),
    ("cylinder_radius", ["2mm", "500um"]),
    ("adhesion_range", ["500nm", "2um"]),
    ("gas_parameter", ["100nm", "1um"]),
    ("flatness", ["1 um over 10 mm", "5 um over 40 mm"]),
    ("cutoff", ["500nm", "2um"]),
    ("shortest", ["3um", "2500nm"]),
    ("longest", ["9um", "7um"]),
    ("from", ["5um", "4um"]),
    ("to", ["300nm", "500nm"]),
    ("width", ["85mm", "60mm"]),
    ("font_size", ["7", "12"]),
    ("only", ["area", "moments"]),
    ("models", ["elastic", "persson"]),
    ("loads", ["10 MPa", "100 MPa"]),
    ("thermal_conductivity", ["10W/(mK)", "300W/(mK)"]),
    ("counterface_thermal_conductivity", ["10W/(mK)", "300W/(mK)"]),
    ("gas_conductivity", ["0.1W/(mK)", "0.2W/(mK)"]),
    ("resistivity", ["1e-8ohmm", "1e-7ohmm"]),
    ("counterface_resistivity", ["1e-8ohmm", "1e-7ohmm"]),
    ("force", ["2mN", "500uN"]),
    ("force_per_length", ["20N/m", "5N/m"]),
    ("work_of_adhesion", ["20mJ/m^2", "80mJ/m^2"]),
    ("fields", ["fields", "fields"]),
    ("patches", ["patches.csv", "patches.csv"]),
    ("spots", ["spots.csv", "spots.csv"]),
    ("film_resistance", ["1e-12 ohm m^2", "1e-10 ohm m^2"]),
    ("mean_free_path", ["40nm", "1um"]),
    ("poisson_ratio", ["0.1", "0.45"]),
    ("counterface_poisson_ratio", ["0.1", "0.45"]),
    ("layer_poisson_ratio", ["0.1", "0.45"]),
];

/// A command by its words, with its options and those of every command.
fn command(words: &str) -> clap::Command {
    let mut found = cli::args::Args::command();
    found.build();
    for word in words.split(' ') {
        found = found.find_subcommand(word).unwrap_or_else(|| panic!("no command {word}")).clone();
    }
    found
}

fn options(command: &clap::Command) -> Vec<Arg> {
    let told =
        |arg: &&Arg| matches!(arg.get_action(), ArgAction::Set | ArgAction::Append | ArgAction::SetTrue);
    command.get_arguments().filter(|arg| arg.get_long().is_some()).filter(told).cloned().collect()
}

fn flag(arg: &Arg) -> String {
    format!("--{}", arg.get_long().unwrap())
}

fn is_flag(arg: &Arg) -> bool {
    matches!(arg.get_action(), ArgAction::SetTrue)
}

/// The values that an option is walked with.
fn values(arg: &Arg) -> Vec<String> {
    let possible: Vec<String> =
        arg.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect();
    if is_flag(arg) {
        return vec![String::new()];
    }
    if !possible.is_empty() {
        return possible;
    }
    let id = arg.get_id().as_str();
    let found = VALUES.iter().find(|(name, _)| *name == id);
    let (_, values) = found.unwrap_or_else(|| panic!("give two values of --{id} that matter"));
    values.map(str::to_owned).to_vec()
}

/// The words with an option set: in place of its value, or behind them.
fn with(words: &[String], arg: &Arg, value: &str) -> Vec<String> {
    let mut words = words.to_vec();
    let flag = flag(arg);
    let at = words.iter().position(|word| *word == flag);
    match at {
        _ if is_flag(arg) => words.push(flag),
        Some(at) if !matches!(arg.get_action(), ArgAction::Append) => value.clone_into(&mut words[at + 1]),
        _ => words.push(format!("{flag}={value}")),
    }
    words
}

/// All contexts: each command with one of each of its alternatives.
fn contexts() -> Vec<(&'static str, Vec<String>)> {
    let mut all = Vec::new();
    for (name, words, alternatives) in WALKS {
        let of_command = options(&command(name));
        let mut contexts = vec![split(words)];
        for alternative in *alternatives {
            let mut choices = Vec::new();
            for choice in *alternative {
                match choice.strip_suffix(" *") {
                    None => choices.push(split(choice)),
                    Some(option) => {
                        let arg = of_command.iter().find(|arg| flag(arg) == option).unwrap();
                        choices.extend(values(arg).into_iter().map(|value| {
                            let more = if value == "bem" { split(GRID) } else { Vec::new() };
                            [vec![option.to_owned(), value], more].concat()
                        }));
                    }
                }
            }
            contexts = contexts
                .iter()
                .flat_map(|context| choices.iter().map(move |choice| [&context[..], choice].concat()))
                .collect();
        }
        all.extend(contexts.into_iter().map(|context| (*name, [split(name), context].concat())));
    }
    all
}

/// The first option that a refusal asks for and that is not given.
fn asked_for<'a>(said: &str, words: &[String], options: &'a [Arg]) -> Option<&'a Arg> {
    let named =
        said.split(|c: char| !(c.is_alphanumeric() || c == '-')).filter(|word| word.starts_with("--"));
    let is_given = |flag: &str| words.iter().any(|word| word.split('=').next() == Some(flag));
    let mut new = named.filter(|flag| !is_given(flag));
    new.find_map(|flag_named| options.iter().find(|option| flag(option) == flag_named))
}

/// Walks one option in one context. What it cannot do without is given as well, in the usual outcome too where that is possible.
/// Returns true if it changes nothing.
fn is_silent(folder: &Folder, words: &[String], arg: &Arg, options: &[Arg], usual: &Outcome) -> bool {
    let (mut words, mut usual) = (words.to_vec(), Some(usual.clone()));
    let mut seen: Vec<Outcome> = Vec::new();
    let values = values(arg);
    let mut at = 0;
    while at < values.len() {
        let typed = with(&words, arg, &values[at]);
        let found = folder.run(&typed);
        let more = if found.status == 2 && words.len() < 30 && !found.said.contains(&flag(arg)) {
            asked_for(&found.said, &typed, options)
        } else {
            None
        };
        if let Some(more) = more {
            words = with(&words, more, &self::values(more)[0]);
            usual = Some(folder.run(&words)).filter(|usual| usual.status == 0);
            (seen, at) = (Vec::new(), 0);
            continue;
        }
        if found.status != 0
            || usual.as_ref().is_some_and(|usual| *usual != found)
            || seen.iter().any(|other| *other != found)
        {
            return false;
        }
        seen.push(found);
        at += 1;
    }
    usual.is_some() || seen.len() > 1
}

#[test]
fn every_option_of_every_command_changes_something_or_is_named() {
    // A seventh of the contexts; all take minutes.
    walk(7, 900);
}

#[test]
#[ignore = "takes minutes: .ci/slow runs it"]
fn every_option_in_every_context_changes_something_or_is_named() {
    walk(1, 5000);
}

/// Walks every option in one of so many contexts.
fn walk(step: usize, least_options: usize) {
    let contexts: Vec<_> = contexts().into_iter().step_by(step).collect();
    let walked = AtomicUsize::new(0);
    let silent = in_every(&contexts, |folder, (name, words)| {
        let (usual, typed) = (folder.run(words), words.join(" "));
        // A context that is refused is none.
        let options = if usual.status == 0 { options(&command(name)) } else { Vec::new() };
        let is_right = |arg: &&Arg| {
            let mut entries = IDLE_BY_RIGHT.iter();
            !entries.any(|(context, option, _)| typed.contains(context) && *option == arg.get_id().as_str())
        };
        let found = options.iter().filter(is_right).filter(|arg| {
            walked.fetch_add(1, Ordering::Relaxed);
            is_silent(folder, words, arg, &options, &usual)
        });
        found.map(|arg| format!("{} of {typed}", flag(arg))).collect()
    });
    assert!(silent.is_empty(), "{}", silent.join("\n"));
    let walked = walked.into_inner();
    assert!(walked > least_options, "{walked} options");
}

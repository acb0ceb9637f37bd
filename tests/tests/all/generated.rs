//! Scenes and questions made at random, far beyond what is sensible: none panics, and no answer holds a number that cannot be.
//! `TRUEAREA_CASES` sets how many are made.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind};

use elements::{ElementsError, IndenterShape};
use numerics::parallel::Unobserved;
use questions::{
    AdhesionQuestion, Answer, BodyInput, CurveQuestion, ElementsLoad, ElementsQuestion, GapModel,
    GapQuestion, IndenterQuestion, LawAnswer, LawQuantity, LawQuestion, LawTableQuestion, LoadInput,
    MaterialInput, QuestionError, RandomInput, RunOptions, TangentialQuestion, TransportInput, Unwatched,
    run_scene,
};
use report::products::{Product, SceneProducts, figure_documents};
use report::run_stamp::RunStamp;
use scene::{Overrides, Scene};
use spectrum::ReadOptions;
use study::models::{Choice, MODELS, ModelEntry, ModelOptions};
use study::surface::Surface;
use tables::{Cells, Format, Table};
use units::{Pressure, Remark, SceneKeys};

use crate::relations::Dice;

/// Cases of a run of all tests; the slow checks make more.
const CASES: u64 = 600;

type Files = BTreeMap<String, Vec<u8>>;

/// Draws on many decades.
struct Draws(Dice);

impl Draws {
    fn below(&mut self, count: usize) -> usize {
        ((self.0.number() * count as f64) as usize).min(count - 1)
    }

    fn one<T: Clone>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())].clone()
    }

    fn is(&mut self, share: f64) -> bool {
        self.0.number() < share
    }

    /// A number between two powers of ten, evenly in its logarithm.
    fn decades(&mut self, from: f64, to: f64) -> f64 {
        10f64.powf(from + (to - from) * self.0.number())
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.0.number()
    }

    /// A spectrum of profiles: a power law, a roll-off, steps, or noise over decades.
    fn spectrum(&mut self) -> String {
        let (rows, longest_m) = (2 + self.below(30), self.decades(-8.0, -1.0));
        let decades = self.decades(-1.0, 0.7);
        let level = self.decades(-32.0, -8.0);
        let (power, kind, scatter) = (self.between(-0.5, 4.5), self.below(4), self.between(0.0, 6.0));
        let mut text = "wavelength_m,C1D_m3\n".to_owned();
        for row in 0..rows {
            let down = row as f64 / (rows - 1) as f64;
            let fall = 10f64.powf(-decades * down * power);
            let value = match kind {
                0 => fall,
                1 => 1.0 / (1.0 + 1.0 / fall),
                2 => {
                    if down < 0.5 {
                        1.0
                    } else {
                        1e-6
                    }
                }
                _ => fall * 10f64.powf(scatter * (self.0.number() - 0.5)),
            };
            let _ = writeln!(text, "{:e},{:e}", longest_m * 10f64.powf(-decades * down), level * value);
        }
        text
    }

    /// Modulus, Poisson's ratio and hardness \[Pa\].
    fn body(&mut self) -> (f64, f64, f64) {
        let modulus_pa = self.decades(4.0, 12.3);
        (modulus_pa, self.one(&[-0.5, 0.0, 0.2, 0.3, 0.45, 0.5]), modulus_pa * self.decades(-6.0, -0.6))
    }

    fn material(&mut self) -> MaterialInput {
        let (modulus_pa, poisson_ratio, hardness_pa) = self.body();
        let counterface = self.is(0.3).then(|| self.body());
        MaterialInput {
            youngs_modulus_pa: Some(modulus_pa),
            poisson_ratio: Some(poisson_ratio),
            indentation_hardness_pa: self.is(0.8).then_some(hardness_pa),
            strain_gradient_length_m: self.is(0.3).then(|| self.decades(-9.0, -3.0)),
            counterface: counterface
                .map(|(youngs_modulus_pa, poisson_ratio, _)| BodyInput { youngs_modulus_pa, poisson_ratio }),
            ..MaterialInput::default()
        }
    }

    fn pressure_pa(&mut self, material: &MaterialInput) -> f64 {
        material.youngs_modulus_pa.unwrap_or(1e9) * self.decades(-10.0, 0.5)
    }

    fn options(&mut self, entry: &ModelEntry, material: &MaterialInput) -> ModelOptions {
        let grows = material.strain_gradient_length_m.is_some() && entry.has(Choice::StrainGradient);
        let mut options = ModelOptions { strain_gradient: grows && self.is(0.7), ..ModelOptions::default() };
        if entry.has(Choice::Interference) && self.is(0.5) {
            options.interference_law = Some(self.one(stat_contact::InterferenceLaw::ALL));
        }
        if entry.has(Choice::Flattening) && self.is(0.5) {
            options.flattening = Some(self.one(stat_contact::Flattening::ALL));
        }
        if entry.has(Choice::Band) && self.is(0.5) {
            options.band = Some(self.one(persson::Band::ALL));
        }
        options
    }
}

/// Faults of what came out, with the place of each.
#[derive(Default)]
struct Faults(Vec<String>);

impl Faults {
    fn table(&mut self, name: &str, table: &Table) {
        for (column, cells) in table.columns() {
            let Cells::Numbers(numbers) = cells else { continue };
            // A tangential stress may be many times what slides, and a decade's share of ln A is negative where A rises.
            let is_share = (column.contains("area_fraction") || column.contains("share"))
                && !column.starts_with("ln_")
                && column != "share_of_sliding"
                && name != "report-decades";
            let is_positive =
                ["dissipation", "damping", "energy", "stiffness", "conductance", "real_pressure", "leak"]
                    .iter()
                    .any(|word| column.contains(word));
            for (row, number) in
                numbers.iter().enumerate().filter_map(|(row, number)| Some((row, (*number)?)))
            {
                let holds = number.is_finite()
                    && (!is_share || (0.0..=1.0 + 1e-9).contains(&number))
                    && (!is_positive || number >= 0.0);
                if !holds {
                    self.0.push(format!("{name}, {column}, row {row}: {number:e}"));
                }
            }
        }
    }

    fn text(&mut self, name: &str, text: &str) {
        let words = text.split(|c: char| !c.is_alphanumeric());
        if let Some(word) = words.into_iter().find(|word| ["NaN", "nan", "inf", "Infinity"].contains(word)) {
            self.0.push(format!("{name} holds {word}"));
        }
    }

    fn notes(&mut self, notes: &[Remark]) {
        for note in notes {
            self.text("a note", &note.words(&SceneKeys));
        }
    }

    fn answer(&mut self, name: &str, answer: &Answer) {
        self.table(name, &answer.table);
        self.notes(&answer.notes);
        for series in answer.figure.iter().flat_map(|figure| &figure.series) {
            if series.points.iter().any(|(x, y)| !(x.is_finite() && y.is_finite())) {
                self.0.push(format!("{name}: a line of its figure is not finite"));
            }
        }
    }
}

/// Asks one question, and tells whether it has an answer.
fn ask(draws: &mut Draws, faults: &mut Faults) -> bool {
    let files = Files::from([("s.csv".to_owned(), draws.spectrum().into_bytes())]);
    let Ok(surface) = Surface::load("s.csv", &files, &ReadOptions::default()) else { return false };
    let material = draws.material();
    let entry = draws.one(&MODELS.iter().collect::<Vec<_>>());
    let loads: Vec<LoadInput> = (0..=draws.below(3))
        .map(|at| LoadInput {
            pressure: Pressure::Pascals(draws.pressure_pa(&material)),
            label: format!("load {at}"),
        })
        .collect();
    let of_model = |model| GapModel { model, material, ..GapModel::default() };
    let by = GapModel { options: draws.options(entry, &material), ..of_model(Some(entry)) };
    let random =
        RandomInput { grid: Some(32), realisations: Some(1), seed: Some(7), ..RandomInput::default() };
    let found: Result<Answer, QuestionError> = match draws.below(12) {
        0..=3 => CurveQuestion {
            model: Some(entry),
            options: by.options.clone(),
            material,
            pressures: loads,
            figure: true,
            ..CurveQuestion::default()
        }
        .answer(&surface, &Unobserved),
        4 | 5 => GapQuestion { by, pressures: loads, ..GapQuestion::default() }.answer(&surface, &Unobserved),
        6 | 7 => {
            let friction = Some(draws.decades(-3.0, 1.0));
            let stresses = match draws.is(0.5) {
                true => vec![LoadInput {
                    pressure: Pressure::Pascals(draws.pressure_pa(&material)),
                    label: String::new(),
                }],
                false => Vec::new(),
            };
            TangentialQuestion {
                by,
                friction,
                pressures: loads,
                stresses,
                figure: draws.is(0.5),
                ..TangentialQuestion::default()
            }
            .answer(&surface, &Unobserved)
        }
        8 => {
            let [from, to] = [draws.pressure_pa(&material), draws.pressure_pa(&material)];
            let is_heat = draws.is(0.5);
            let conductivity = is_heat.then(|| draws.decades(-3.0, 3.0));
            let question = LawTableQuestion {
                law: LawQuestion {
                    by,
                    from: Pressure::Pascals(from.min(to)),
                    to: Pressure::Pascals(from.max(to)),
                },
                quantity: if is_heat { LawQuantity::Heat } else { LawQuantity::Pressure },
                transport: TransportInput {
                    thermal_conductivity_w_per_m_k: conductivity,
                    counterface_thermal_conductivity_w_per_m_k: conductivity,
                    ..TransportInput::default()
                },
                ..LawTableQuestion::default()
            };
            let Ok(found) = question.answer(&surface, &Unobserved) else { return false };
            let (notes, is_sound) = match &found {
                LawAnswer::Pressure(law) => (
                    &law.notes,
                    law.sampled(0.01, &Unobserved).map(|law| {
                        law.points.iter().all(|point| {
                            point.pressure_pa >= 0.0
                                && point.mean_gap_m.is_finite()
                                && point.area_fraction <= 1.0
                        })
                    }),
                ),
                LawAnswer::Conductance(law) => (
                    &law.notes,
                    law.sampled(0.01, &Unobserved).map(|table| {
                        table
                            .points
                            .iter()
                            .all(|point| point.contact_si >= 0.0 && point.total_si().is_finite())
                    }),
                ),
            };
            faults.notes(notes);
            if matches!(is_sound, Ok(false)) {
                faults.0.push(format!("law of {entry}"));
            }
            return is_sound.is_ok();
        }
        9 => {
            let saturation = draws.is(0.3).then_some(Pressure::Hardnesses(1.0));
            let loads = loads.into_iter().map(ElementsLoad::Pressure).collect();
            let question =
                ElementsQuestion { material, loads, saturation, random, ..ElementsQuestion::default() };
            let pressed = question
                .on(&surface)
                .and_then(|prepared| Ok(prepared.answer::<ElementsError>(|_| Ok(()), &Unobserved)?));
            pressed.map(|(loads, notes)| Answer { table: elements::means_table(&loads), notes, figure: None })
        }
        10 => {
            let shape = draws.one(&[IndenterShape::Ball, IndenterShape::Cylinder]);
            let (radius_m, force) = (draws.decades(-6.0, 0.0), draws.decades(-9.0, 3.0));
            let question =
                IndenterQuestion { material, shape, radius_m, force, random, ..IndenterQuestion::default() };
            question.on(&surface).and_then(|prepared| prepared.answer(&Unobserved))
        }
        _ => {
            let question = AdhesionQuestion {
                material,
                pressures: loads,
                work_of_adhesion_j_per_m2: draws.decades(-4.0, 0.0),
                range_m: draws.decades(-10.0, -7.0),
                pull_off: false,
                random,
                tolerance: Some(1e-3),
                ..AdhesionQuestion::default()
            };
            question.on(&surface).and_then(|prepared| prepared.answer(&Unobserved))
        }
    };
    if let Ok(answer) = &found {
        faults.answer(entry.name, answer);
    }
    found.is_ok()
}

/// The text of a scene with its files.
fn scene(draws: &mut Draws) -> (String, Files) {
    let mut text = "[surface]\n".to_owned();
    if draws.is(0.6) {
        text += "psd = \"s.csv\"\n";
    } else {
        let (height_m, rolloff_m) = (draws.decades(-10.0, -4.0), draws.decades(-7.0, -2.0));
        let (slope, hurst) = (draws.decades(-4.0, 0.7), draws.between(0.1, 1.0));
        let _ = writeln!(
            text,
            "rms_height = \"{height_m:e} m\"\nrms_slope = {slope:e}\nrolloff_wavelength = \"{rolloff_m:e} m\"\nhurst = {hurst:.3}"
        );
    }
    let (modulus_pa, poisson_ratio, hardness_pa) = draws.body();
    let _ =
        writeln!(text, "[material]\nyoungs_modulus = \"{modulus_pa:e} Pa\"\npoisson_ratio = {poisson_ratio}");
    if draws.is(0.8) {
        let _ = writeln!(text, "indentation_hardness = \"{hardness_pa:e} Pa\"");
    }
    if draws.is(0.3) {
        text += "strain_gradient_length = \"1 um\"\n";
    }
    text += "thermal_conductivity = \"40 W/(m K)\"\nresistivity = \"2e-7 ohm m\"\n";
    if draws.is(0.4) {
        let (modulus_pa, poisson_ratio, _) = draws.body();
        let _ = writeln!(
            text,
            "[counterface]\nyoungs_modulus = \"{modulus_pa:e} Pa\"\npoisson_ratio = {poisson_ratio}\n\
             thermal_conductivity = \"200 W/(m K)\"\nresistivity = \"2e-8 ohm m\""
        );
    }
    let pressures: Vec<String> =
        (0..=draws.below(2)).map(|_| format!("\"{:e} Pa\"", modulus_pa * draws.decades(-9.0, 0.3))).collect();
    text += "[loads]\n";
    text += &match draws.is(0.7) {
        true => format!("pressures = [{}]\n", pressures.join(", ")),
        false => format!(
            "force = \"{:e} N\"\nnominal_area = \"1 cm^2\"\n",
            modulus_pa * draws.decades(-13.0, -4.0)
        ),
    };
    for curve in 0..draws.below(3) {
        let model = draws.one(&MODELS.iter().collect::<Vec<_>>());
        let _ = writeln!(text, "[[curve]]\nmodel = \"{model}\"\nname = \"curve-{curve}\"");
    }
    if draws.is(0.6) {
        text += "[interface]\n";
        let parts = [
            format!("friction = {:e}\n", draws.decades(-3.0, 0.5)),
            "gas = \"air\"\n".to_owned(),
            format!("work_of_adhesion = \"{:e} J/m^2\"\n", draws.decades(-5.0, 1.0)),
            format!("shear_strength = \"{:e} Pa\"\n", draws.decades(3.0, 10.0)),
        ];
        text.extend(parts.into_iter().filter(|_| draws.is(0.5)));
        if text.contains("friction") {
            text += &format!("share_of_sliding = {:.3}\n", draws.between(0.001, 0.999));
        }
    }
    if draws.is(0.4) {
        let (drop_pa, viscosity) = (draws.decades(2.0, 8.0), draws.decades(-5.5, 1.0));
        let _ = writeln!(
            text,
            "[seal]\npressure_drop = \"{drop_pa:e} Pa\"\nviscosity = \"{viscosity:e} Pa s\"\nbreadth = \"1 cm\"\nlength = \"1 mm\""
        );
    }
    if draws.is(0.5) {
        text += "[[figure]]\nname = \"areas\"\nshows = \"area\"\n[[figure]]\nname = \"spectrum\"\nshows = \"psd\"\n";
    }
    (text, Files::from([("s.csv".to_owned(), draws.spectrum().into_bytes())]))
}

/// Runs one scene, and tells whether it has an answer.
fn run(draws: &mut Draws, faults: &mut Faults) -> bool {
    let (text, files) = scene(draws);
    let Ok(scene) = Scene::parse(&text, &files, &Overrides::default()) else { return false };
    let options = RunOptions { report: draws.is(0.2), judge: Some(false), uncertainty: Some(false) };
    let Ok(outcome) = run_scene(&scene, options, &Unwatched) else { return false };
    let products = SceneProducts {
        evidence: outcome.evidence(&scene),
        conclusions: &outcome.conclusions,
        sensitivities: outcome.sensitivities.as_deref(),
        run_stamp: &RunStamp { date: None, command: None },
    };
    let each = products.each::<()>(Format::Csv, |name, product| {
        match product {
            Product::Table { table, .. } => faults.table(name, table),
            Product::Text(found) => faults.text(name, found),
        }
        Ok(())
    });
    each.unwrap();
    for figure in figure_documents(&scene, &outcome.results, None) {
        faults.text("figure", &figure.svg());
    }
    true
}

#[test]
fn no_scene_or_question_has_a_number_that_cannot_be() {
    let cases = std::env::var("TRUEAREA_CASES").map_or(CASES, |cases| cases.parse().unwrap());
    let mut failures = Vec::new();
    let mut answered = 0;
    for seed in 0..cases {
        let mut faults = Faults::default();
        let case = || {
            let mut draws = Draws(Dice((seed + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15)));
            match seed % 3 {
                0 => run(&mut draws, &mut faults),
                _ => ask(&mut draws, &mut faults),
            }
        };
        match catch_unwind(AssertUnwindSafe(case)) {
            Ok(has_answer) => answered += u64::from(has_answer),
            Err(_) => failures.push(format!("case {seed} panics")),
        }
        failures.extend(faults.0.first().map(|fault| format!("case {seed}: {fault}")));
    }
    assert!(failures.is_empty(), "{} of {cases}:\n{}", failures.len(), failures.join("\n"));
    assert!(2 * answered > cases, "{answered} of {cases} have an answer");
}

//! What a scene found, for people: the answer in plain words, then area, real pressure and where the area settles, per load.

use std::fmt::Write;
use std::ops::Range;

use asperity::FLAGGED_ASPECT_RATIO_OVER_CRITICAL;
use spectrum::ProfilePsd;
use stacked_contact::{Convergence, Level, StackedModel, largest_full_contact_pressure_pa};

use crate::curve_names::in_full;
use crate::cut_counts::CutCounts;
use crate::trust::Trust;
use crate::yardstick_words::yardsticks;
use crate::{
    advice_words, answer_words, coverage, doubt_words, interface_words, opening, scan_words,
    uncertainty_words, verdict_words,
};
use findings::answer::{Answer, LoadAnswer};
use findings::doubts::Doubt;
use findings::interface::InterfaceStates;
use scene::Scene;
use state_tables::{NarrowSpectra, StateCounts};
use study::material::Material;
use study::plan::{Curve, CurveResult, CutoffState, Results, scales_per_decade};
use uncertainty::Uncertainty;
use units::display::{counted, length, pressure, three_digits};
use units::number;

/// The summary of a scene's results, which opens with how far they can be trusted, where that was asked.
pub fn summary(scene: &Scene, results: &Results, answer: &Answer, trust: Trust<'_>) -> String {
    // Names of curves are hyphenated and stay whole.
    let columns = textwrap::Options::new(100).word_splitter(textwrap::WordSplitter::NoHyphenation);
    let mut text = String::new();
    for first in opening::lines(scene, answer, trust) {
        let _ = writeln!(text, "{}\n", textwrap::fill(&first, &columns));
    }
    let _ = write!(text, "{}\n{}\n", scene.title, sampling(results));
    for warning in scan_words::warnings(&scene.surface) {
        let _ = writeln!(text, "Warning: {warning}");
    }
    text.push('\n');
    let judgement = trust.judgement;
    let mut paragraphs =
        judgement.map_or_else(Vec::new, |judgement| verdict_words::sentences(judgement, scene, answer));
    paragraphs.extend(answer_words::sentences(answer, scene, results));
    paragraphs.extend(answer_words::shortcomings(answer, scene, results));
    paragraphs.extend(answer_words::disagreements(answer, scene));
    for paragraph in paragraphs {
        let _ = writeln!(text, "{}\n", textwrap::fill(&paragraph, &columns));
    }
    if let Some(uncertainty) = trust.uncertainty {
        let advice = trust.foremost_advice().into_iter();
        let advice = advice.flat_map(|advice| advice_words::in_short(uncertainty, advice, scene));
        for line in uncertainty_words::sentences(uncertainty).into_iter().chain(advice) {
            let _ = writeln!(text, "{}", textwrap::fill(&line, &columns));
        }
        text.push('\n');
    }
    if let Some(states) = InterfaceStates::of_scene(scene, results) {
        for told in interface_words::told(&states, scene, trust.uncertainty) {
            let _ = writeln!(text, "{}", told.heading);
            let width = told.lines.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
            for (name, value) in &told.lines {
                let _ = writeln!(text, "  {name:<width$}  {value}");
            }
        }
        for note in interface_words::notes(&states, scene, trust.uncertainty) {
            let _ = writeln!(text, "note: {note}");
        }
        text.push('\n');
    }
    let doubts = Doubt::of_scene(scene, answer);
    for doubt in &doubts {
        let _ = writeln!(text, "doubtful: {}", doubt_words::line(doubt));
    }
    if !doubts.is_empty() {
        text.push('\n');
    }
    let material = scene.material.as_ref().map(Material::properties).unwrap_or_default();
    if !material.is_empty() {
        let told: Vec<String> = material.iter().map(|(name, value)| format!("{name} {value}")).collect();
        let _ = writeln!(text, "{}", textwrap::fill(&told.join(", "), &columns));
    }
    for line in scene.bodies.describe(&scene.spreads) {
        let _ = writeln!(text, "{}", textwrap::fill(&line, &columns));
    }
    for choice in scene.model_choices() {
        let _ = writeln!(text, "{choice}");
    }
    for (curve, loads) in answer.curves.iter().enumerate() {
        text.push('\n');
        text.push_str(&curve_summary(scene, results, curve, loads, trust.uncertainty));
    }
    text
}

/// How the spectrum is sampled, which the stacked area depends on.
pub fn sampling(results: &Results) -> String {
    sampling_of(&results.psd)
}

/// How a spectrum is sampled.
pub fn sampling_of(psd: &ProfilePsd) -> String {
    let density =
        scales_per_decade(psd).map_or(String::new(), |n| format!(", {} per decade", three_digits(n)));
    format!(
        "{} scales from {} to {}{density}",
        psd.len(),
        length(psd.longest_wavelength_m()),
        length(psd.shortest_wavelength_m())
    )
}

/// Where intervals stand among the columns of a curve.
const AFTER_THE_AREA: usize = 2;

fn curve_summary(
    scene: &Scene,
    results: &Results,
    at: usize,
    loads: &[Option<LoadAnswer>],
    uncertainty: Option<&Uncertainty>,
) -> String {
    let (curve, result) = (&scene.needs.curves[at], &results.curves[at]);
    let hardness_pa = scene.hardness_pa();
    let mut rows = vec![
        [
            "nominal pressure",
            "area fraction",
            "real pressure",
            "settled within 1 % at",
            "settled within 0.1 % at",
        ]
        .map(str::to_owned)
        .to_vec(),
    ];
    if let Some(uncertainty) = uncertainty {
        rows[0].insert(AFTER_THE_AREA, coverage::level(uncertainty));
    }
    for ((index, load), answer) in scene.needs.loads.iter().enumerate().zip(loads) {
        let Some(answer) = answer else { continue };
        let real_pressure = match hardness_pa {
            Some(hardness_pa) => format!("{} H", three_digits(answer.real_pressure_pa / hardness_pa)),
            None => pressure(answer.real_pressure_pa),
        };
        let mut row = vec![
            load.label.clone(),
            three_digits(answer.area_fraction),
            real_pressure,
            settled(answer, answer.within_1_percent),
            settled(answer, answer.within_01_percent),
        ];
        if let Some(uncertainty) = uncertainty {
            let interval = uncertainty.interval(at, index).map(uncertainty_words::ends);
            row.insert(AFTER_THE_AREA, interval.unwrap_or_else(|| "-".to_owned()));
        }
        rows.push(row);
    }
    let mut text = format!("{}\n{}", heading(curve), aligned(&rows));
    text.extend(yardsticks(scene, results, curve).map(|sentence| format!("  {sentence}\n")));
    match curve.model.stacked().zip(result.stacked()) {
        Some((model, levels)) => text.push_str(&stacked_remarks(model, results, levels, hardness_pa)),
        None => text.extend(statistical_notes(result).into_iter().map(|note| format!("  {note}\n"))),
    }
    text
}

/// The name of a curve's table, and what it is.
fn heading(curve: &Curve) -> String {
    let full = in_full(curve);
    if full.starts_with(&curve.name) { full } else { format!("{}: {full}", curve.name) }
}

fn stacked_remarks(
    model: &StackedModel,
    results: &Results,
    levels: &[Vec<Level>],
    hardness_pa: Option<f64>,
) -> String {
    let mut text = beyond_fitted_range(levels).map_or(String::new(), |beyond| format!("  {beyond}\n"));
    if let Some(limit_pa) = largest_full_contact_pressure_pa(model, results.scales.iter().copied()) {
        let in_hardnesses = hardness_pa
            .map_or(String::new(), |hardness_pa| format!(" ({} H)", three_digits(limit_pa / hardness_pa)));
        let _ = writeln!(
            text,
            "  for dense sampling the real pressure tends to {}{in_hardnesses}, or to the nominal one where that is higher",
            pressure(limit_pa)
        );
    }
    text
}

/// What the states of a statistical curve, or the cuts of Persson's theory, leave open or go beyond.
pub fn statistical_notes(result: &CurveResult) -> Vec<String> {
    let mut counts = CurveCounts::default();
    counts.add(result);
    counts.notes()
}

/// What there is to say of one block of a curve.
pub(crate) fn notes_of_block(result: &CurveResult, block: usize) -> Vec<String> {
    let mut counts = CurveCounts::default();
    counts.add_blocks(result, block..block + 1);
    counts.notes()
}

/// How many levels lie beyond what the elastic-plastic sinusoid is trusted for, if any.
pub fn beyond_fitted_range(curve: &[Vec<Level>]) -> Option<String> {
    let mut counts = LevelCounts::default();
    counts.add(curve);
    counts.note()
}

/// What there is to count of a curve, whose parts may come one by one.
#[derive(Debug, Default)]
pub struct CurveCounts {
    states: StateCounts,
    narrow: NarrowSpectra,
    levels: LevelCounts,
    cuts: CutCounts,
}

impl CurveCounts {
    /// Counts the rows of a curve, or of a part of one.
    pub fn add(&mut self, part: &CurveResult) {
        self.add_blocks(part, 0..part.blocks());
    }

    fn add_blocks(&mut self, part: &CurveResult, wanted: Range<usize>) {
        if let Some(blocks) = part.stacked() {
            self.levels.add(&blocks[wanted]);
        } else if let Some(blocks) = part.persson() {
            self.cuts.add(&blocks[wanted]);
        } else if let Some(blocks) = part.statistical() {
            blocks[wanted].iter().for_each(|rows| self.add_states(rows));
        }
    }

    fn add_states(&mut self, rows: &[CutoffState]) {
        let contacts = rows.iter().filter_map(|row| row.contact.as_ref());
        self.states.add(contacts.map(|(_, state)| state));
        rows.iter().filter_map(|row| row.too_narrow_alpha).for_each(|alpha| self.narrow.add(alpha));
    }

    /// What there is to say of them.
    pub fn notes(&self) -> Vec<String> {
        let all = counted(self.states.all + self.narrow.count, "row");
        let narrow = narrow_spectra(&self.narrow, &all);
        let of_states = notes_of_states(&self.states).into_iter().chain(narrow);
        of_states.chain(self.levels.note()).chain(self.cuts.notes()).collect()
    }
}

/// What there is to say of spectra that have no summits, if there are any.
pub(crate) fn narrow_spectra(narrow: &NarrowSpectra, of: &str) -> Option<String> {
    // Rounded down, so that none is told to be 1.5.
    let [lowest, highest] = narrow.alphas?.map(|alpha| number((1e3 * alpha).floor() / 1e3));
    let alphas = if lowest == highest { lowest } else { format!("{lowest} to {highest}") };
    Some(format!(
        "{} of {of}: alpha = m0 m4/m2^2 is {alphas}, below the 1.5 that every surface reaches: no summits, no result",
        narrow.count
    ))
}

/// What there is to say of states together, with those that are beyond complete contact.
pub fn notes_of_states(counts: &StateCounts) -> Vec<String> {
    let what = "beyond complete contact of every asperity, area fraction 1, no separation";
    of_states(counts.incomplete, counts, what).into_iter().chain(state_notes(counts)).collect()
}

/// What there is to say where each state beyond complete contact is told by itself.
pub(crate) fn state_notes(counts: &StateCounts) -> Vec<String> {
    let clamped = of_states(
        counts.clamped,
        counts,
        "more contact area than there is nominal area, held at an area fraction of 1",
    );
    let out_of_range = of_states(
        counts.out_of_range,
        counts,
        "most of the load on asperities outside the range their law was fitted in",
    );
    clamped.into_iter().chain(out_of_range).collect()
}

fn of_states(found: usize, counts: &StateCounts, what: &str) -> Option<String> {
    (found > 0).then(|| format!("{found} of {}: {what}", counted(counts.all, "state")))
}

/// How many levels lie beyond what their law is trusted for.
#[derive(Debug, Default)]
struct LevelCounts {
    all: usize,
    beyond: usize,
}

impl LevelCounts {
    fn add(&mut self, curve: &[Vec<Level>]) {
        let flagged =
            |level: &&Level| level.aspect_ratio_over_critical > Some(FLAGGED_ASPECT_RATIO_OVER_CRITICAL);
        self.all += curve.iter().map(Vec::len).sum::<usize>();
        self.beyond += curve.iter().flatten().filter(flagged).count();
    }

    fn note(&self) -> Option<String> {
        let LevelCounts { all, beyond } = self;
        (*beyond > 0).then(|| {
            format!(
                "{beyond} of {}: B/B_c above {FLAGGED_ASPECT_RATIO_OVER_CRITICAL}, beyond what the elastic-plastic \
                 sinusoid is trusted for",
                counted(*all, "level")
            )
        })
    }
}

fn settled(answer: &LoadAnswer, found: Convergence) -> String {
    match (answer.followed, answer.settled_at_m(found)) {
        (false, _) => "not asked for".to_owned(),
        (true, Some(wavelength_m)) => length(wavelength_m),
        (true, None) => "not settled".to_owned(),
    }
}

/// Rows as indented columns of equal width.
pub fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns)
        .map(|at| rows.iter().filter_map(|row| row.get(at)).map(|c| c.chars().count()).max().unwrap_or(0))
        .collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::from(" ");
        for (cell, width) in row.iter().zip(&widths) {
            let _ = write!(line, " {cell:<width$} ");
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

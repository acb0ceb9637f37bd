//! The first screen of one load in parts, for a page that stays open while its conditions change.

use conclusions::{Conclusions, Evidence};
use maud::Markup;
use serde::Serialize;
use study::figure::CurveLook;
use units::display::{share, three_digits, typeset};
use units::printable::printable;

use super::area_curve::{AreaCurve, drawn_at_first};
use super::contact_picture::contact_picture;
use super::reading::Reading;
use super::{SceneReport, cards, first_screen};
use crate::chart::palette::ModelStyle;
use crate::curve_names::{in_words_with_publication, short_name};

/// The first screen of one load in parts: HTML and SVG, and the models as data.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LiveScreen {
    /// The load as typed.
    pub load: String,
    /// The nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
    /// The bodies, if they have names: `diamond on a rigid flat`.
    pub bodies: Option<String>,
    /// The best estimate of the area fraction; absent if only its range is known.
    pub area_fraction: Option<f64>,
    /// The lower end of its range.
    pub low: Option<f64>,
    /// The upper end.
    pub high: Option<f64>,
    /// The picture of the contact, as HTML; absent before elements were pressed.
    pub contact: Option<String>,
    /// The card of the best estimate, as HTML.
    pub best: String,
    /// The card of the other assumption on the hardness, as HTML; empty if that does not matter.
    pub other_hardness: String,
    /// The card of cautions, as HTML.
    pub cautions: String,
    /// Seal, gap, heat and current, as HTML; empty if the scene asks for none.
    pub interface: String,
    /// The title of the figure of the area against the cutoff, which states what it shows.
    pub figure_title: Option<String>,
    /// The area against the cutoff, as SVG; absent if no curve was followed.
    pub figure: Option<String>,
    /// The values along its lines.
    pub reading: Option<Reading>,
    /// The models: if they were judged by the elements that they are compared with, the nearest first.
    pub models: Vec<LiveModel>,
}

/// A model on the first screen.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LiveModel {
    /// The curve, by index; its lines have the class `m` and this number.
    pub curve: usize,
    /// The name of the curve in tables.
    pub key: String,
    /// The short name in print.
    pub name: String,
    /// The model with its authors, its choices and its publication.
    pub in_words: String,
    /// The area fraction at the shortest wavelength.
    pub area_fraction: Option<f64>,
    /// The area fraction in print.
    pub area: Option<String>,
    /// The elements that it is compared with, in words; absent before the verdict.
    pub reference: Option<String>,
    /// The area over that of the elements.
    pub ratio: Option<f64>,
    /// The verdict: `agrees`, `large`, `small`, `invalid` or `unknown`; absent before it.
    pub verdict: Option<&'static str>,
    /// The verdict in a sign and a ratio.
    pub verdict_in_short: Option<String>,
    /// The reason for the verdict.
    pub reason: String,
    /// The strength of the fill of its cell, from 0 to 1.
    pub fill: f64,
    /// True if its lines are drawn before anybody chooses.
    pub is_drawn: bool,
    /// The colour of its lines on white.
    pub colour: &'static str,
    /// The colour of its lines on a dark page.
    pub dark_colour: &'static str,
}

impl LiveScreen {
    /// Makes the screen of the first load. The axis of the figure spans the whole spectrum of the surface, however short
    /// the shortest wavelength of the scene.
    #[must_use]
    pub fn new(evidence: Evidence<'_>, conclusions: &Conclusions) -> Option<Self> {
        let Evidence { scene, results, answer, .. } = evidence;
        let load = conclusions.loads.first()?;
        let report = SceneReport {
            label: "",
            scene,
            results,
            answer,
            evidence,
            conclusions,
            sensitivities: &[],
            figures: Vec::new(),
        };
        let styles: Vec<ModelStyle> =
            CurveLook::of_curves(&scene.needs.curves).into_iter().map(ModelStyle::new).collect();
        let psd = &scene.surface.psd;
        let band_m = [psd.shortest_wavelength_m(), psd.longest_wavelength_m()];
        let curve = AreaCurve::new(&report, load.load, band_m);
        let drawn = drawn_at_first(&conclusions.loads);
        let plain = |curve: usize| {
            let style = &styles[curve];
            let model = &scene.needs.curves[curve];
            let area_fraction = answer.curves[curve][load.load].as_ref().map(|found| found.area_fraction);
            LiveModel {
                curve,
                key: model.name.clone(),
                name: printable(&short_name(model)).into_owned(),
                in_words: in_words_with_publication(&model.model),
                area_fraction,
                area: area_fraction.map(share),
                reference: None,
                ratio: None,
                verdict: None,
                verdict_in_short: None,
                reason: String::new(),
                fill: 0.0,
                is_drawn: drawn.is_empty() || drawn.contains(&curve),
                colour: style.colour,
                dark_colour: style.dark_colour,
            }
        };
        let mut models: Vec<LiveModel> = Vec::new();
        for group in &load.references {
            let of_elements =
                first_screen::area_words(group).map_or_else(String::new, |area| format!(": {area}"));
            let reference =
                format!("against {}{of_elements}", first_screen::reference_words(group.reference));
            models.extend(group.models.iter().map(|cell| {
                let (class, glyph) = first_screen::class_and_glyph(cell.verdict);
                let ratio = cell.ratio.map_or_else(String::new, |ratio| format!(" ×{}", three_digits(ratio)));
                LiveModel {
                    reference: Some(reference.clone()),
                    ratio: cell.ratio,
                    verdict: Some(class),
                    verdict_in_short: Some(format!("{glyph}{ratio}")),
                    reason: typeset(&first_screen::reason(&report, cell, load.load)),
                    fill: first_screen::fill(cell),
                    ..plain(cell.curve)
                }
            }));
        }
        let is_new = |models: &[LiveModel], curve: usize| models.iter().all(|model| model.curve != curve);
        let rest: Vec<LiveModel> =
            (0..scene.needs.curves.len()).filter(|curve| is_new(&models, *curve)).map(plain).collect();
        models.extend(rest);
        let says_hardness = load.factor_of_hardness().is_some();
        Some(LiveScreen {
            load: load.label.clone(),
            nominal_pressure_pa: load.nominal_pressure_pa,
            bodies: first_screen::bodies(&report),
            area_fraction: load.area.area_fraction,
            low: Some(load.area.low),
            high: Some(load.area.high),
            contact: contact_picture(&report, std::slice::from_ref(load), |_| String::new())
                .map(Markup::into_string),
            best: cards::best_estimate(&report, load, &styles).into_string(),
            other_hardness: cards::other_hardness(load).into_string(),
            cautions: cards::before_quoting(conclusions, says_hardness).into_string(),
            interface: cards::interface_strip(&report, load).into_string(),
            figure_title: curve.as_ref().map(|curve| typeset(&curve.title())),
            figure: curve.as_ref().map(|curve| curve.figure(&styles).into_string()),
            reading: curve.as_ref().map(AreaCurve::reading),
            models,
        })
    }
}

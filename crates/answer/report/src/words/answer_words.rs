//! The answer in words.

use crate::curve_names::in_full;
use crate::listing::{at_loads, decade_name, listed, range, share_range};
use findings::answer::{Answer, DISAGREEMENT, Disagreement, LoadAnswer, MIN_DECADES, MIN_SCALES};
use scene::Scene;
use spectrum::ProfilePsd;
use study::plan::Results;
use topography::InstrumentsDisagree;
use units::display::{counted, length, pressure, three_digits};

/// The areas and the scales that decide them, for each curve whose area the spectrum determines.
pub(crate) fn sentences(answer: &Answer, scene: &Scene, results: &Results) -> Vec<String> {
    let mut sentences = Vec::new();
    for (curve, answers) in scene.needs.curves.iter().zip(&answer.curves) {
        let name = in_full(curve);
        let complete = |answer: &LoadAnswer| answer.area_fraction == 1.0;
        let settled = Group::new(answers, |answer| answer.settled && !complete(answer));
        if !settled.is_empty() {
            sentences.push(format!("{name}: {}", settled.found(scene, &results.psd)));
        }
        let flattened = Group::new(answers, |answer| answer.settled && complete(answer));
        if !flattened.is_empty() {
            sentences.push(format!(
                "{name}: everything touches {}; no scale of the roughness stays open.",
                flattened.loads_text(scene)
            ));
        }
        let ends = Group::new(answers, |answer| !answer.followed);
        if !ends.is_empty() {
            sentences.push(format!(
                "{name}: {} Computed at the shortest wavelength only, so whether the area has settled is unknown.",
                ends.touching(scene)
            ));
        }
    }
    sentences
}

/// A limit of what the spectrum determines.
pub(crate) struct Shortcoming {
    /// Remaining answer: `Upper bound`, `Order of magnitude` or `No answer`.
    pub heading: &'static str,
    /// The reason.
    pub reason: String,
}

impl std::fmt::Display for Shortcoming {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}. {}", self.heading, self.reason)
    }
}

/// The limits of what the spectrum determines.
pub(crate) fn shortcomings(answer: &Answer, scene: &Scene, results: &Results) -> Vec<Shortcoming> {
    let wavelengths_m = results.psd.wavelengths_m();
    let (longest_m, shortest_m) = (wavelengths_m[0], wavelengths_m[wavelengths_m.len() - 1]);
    if scene.needs.curves.is_empty() {
        return Vec::new();
    }
    if let Some(scales) = answer.too_few_scales {
        let reason = format!(
            "The spectrum is too short to tell how much touches: it has {} from {} to {}, and at least {MIN_SCALES} over \
             {MIN_DECADES} decade are needed. The tables hold what these scales alone give.",
            counted(scales, "scale"),
            length(longest_m),
            length(shortest_m)
        );
        return vec![Shortcoming { heading: "No answer", reason }];
    }
    if let Some(InstrumentsDisagree { names: [first, second], ratio, longest_m, shortest_m }) =
        &answer.instruments_disagree
    {
        let reason = format!(
            "The instruments do not show the same surface: {first} has {} times the spectrum of {second} from {} to {}, where both \
             measure. Check units, height scales and places, or leave one of them out. The tables hold the composite of both.",
            three_digits(*ratio),
            length(*longest_m),
            length(*shortest_m)
        );
        return vec![Shortcoming { heading: "Order of magnitude", reason }];
    }
    // Curves that fail in the same way share a sentence.
    let mut failing: Vec<(String, Vec<String>)> = Vec::new();
    for (curve, answers) in scene.needs.curves.iter().zip(&answer.curves) {
        let open = Group::new(answers, |answer| answer.followed && !answer.settled);
        if open.is_empty() {
            continue;
        }
        let loads = open.loads_text(scene);
        match failing.iter_mut().find(|(others, _)| *others == loads) {
            Some((_, names)) => names.push(in_full(curve)),
            None => failing.push((loads, vec![in_full(curve)])),
        }
    }
    let sentence = |(loads, names): (String, Vec<String>)| {
        let models = match names.len() {
            all if all == scene.needs.curves.len() && all > 2 => "any of the models".to_owned(),
            _ => listed(&names.iter().map(String::as_str).collect::<Vec<_>>()),
        };
        Shortcoming {
            heading: "Upper bound",
            reason: format!(
                "The spectrum stops at {}, and the area by {models} {loads} is still falling there (not settled within 1 % over half a \
                 decade); finer roughness can only lower it. The tables hold the area at that cutoff.",
                length(shortest_m)
            ),
        }
    };
    failing.into_iter().map(sentence).collect()
}

/// The loads at which the models disagree.
pub(crate) fn disagreements(answer: &Answer, scene: &Scene) -> Vec<String> {
    if answer.too_few_scales.is_some() {
        return Vec::new();
    }
    let mut groups: Vec<(usize, usize, Vec<&Disagreement>)> = Vec::new();
    for found in answer.disagreements.iter().filter(|found| found.ratio >= DISAGREEMENT) {
        match groups.iter_mut().find(|(least, most, _)| (*least, *most) == (found.least, found.most)) {
            Some((_, _, all)) => all.push(found),
            None => groups.push((found.least, found.most, vec![found])),
        }
    }
    let name = |curve: usize| in_full(&scene.needs.curves[curve]);
    let sentence = |(least, most, all): (usize, usize, Vec<&Disagreement>)| {
        let loads: Vec<usize> = all.iter().map(|found| found.load).collect();
        let ratios = range(all.iter().map(|found| found.ratio), three_digits);
        let parting: Vec<f64> = all.iter().filter_map(|found| found.parting_wavelength_m).collect();
        let parting = if parting.len() == all.len() {
            format!(
                "; they differ by more than {DISAGREEMENT}x for cutoffs below {}",
                range(parting.into_iter(), length)
            )
        } else {
            String::new()
        };
        format!(
            "The models disagree {}: at the shortest wavelength {} has {ratios} times the area of {}{parting}.",
            at_loads(scene, &loads),
            name(most),
            name(least)
        )
    };
    groups.into_iter().map(sentence).collect()
}

/// The loads under which a curve behaves alike.
struct Group<'a> {
    answers: Vec<(usize, &'a LoadAnswer)>,
}

impl<'a> Group<'a> {
    fn new(answers: &'a [Option<LoadAnswer>], belongs: impl Fn(&LoadAnswer) -> bool) -> Self {
        let answers = answers
            .iter()
            .enumerate()
            .filter_map(|(load, answer)| Some((load, answer.as_ref()?)))
            .filter(|(_, answer)| belongs(answer))
            .collect();
        Group { answers }
    }

    fn is_empty(&self) -> bool {
        self.answers.is_empty()
    }

    fn loads_text(&self, scene: &Scene) -> String {
        at_loads(scene, &self.answers.iter().map(|(load, _)| *load).collect::<Vec<_>>())
    }

    fn range(&self, of: impl Fn(&LoadAnswer) -> f64, display: impl Fn(f64) -> String) -> String {
        range(self.answers.iter().map(|(_, answer)| of(answer)), display)
    }

    /// The loads from the least to the largest, as the ranges are.
    fn load_range(&self, scene: &Scene) -> String {
        let pressure = |(load, _): &&(usize, &LoadAnswer)| scene.needs.loads[*load].nominal_pressure_pa();
        let rising =
            |a: &&(usize, &LoadAnswer), b: &&(usize, &LoadAnswer)| pressure(a).total_cmp(&pressure(b));
        let label = |(load, _): &(usize, &LoadAnswer)| scene.needs.loads[*load].label.as_str();
        let ends =
            (self.answers.iter().min_by(rising).map(label), self.answers.iter().max_by(rising).map(label));
        match ends {
            (Some(least), Some(most)) if least != most => format!("from {least} to {most}"),
            (Some(only), _) => format!("at {only}"),
            _ => String::new(),
        }
    }

    /// Area and real pressure.
    fn touching(&self, scene: &Scene) -> String {
        let real_pressure = |pressure_pa: f64| match scene.hardness_pa() {
            Some(hardness_pa) => format!("{} H", three_digits(pressure_pa / hardness_pa)),
            None => pressure(pressure_pa),
        };
        let areas = || self.answers.iter().map(|(_, answer)| answer.area_fraction);
        let (least, most) = (areas().fold(f64::INFINITY, f64::min), areas().fold(0.0, f64::max));
        format!(
            "{} of the area touches {}, at a real pressure of {}.",
            share_range(least, most),
            self.load_range(scene),
            self.range(|answer| answer.real_pressure_pa, real_pressure)
        )
    }

    /// Area, real pressure, the wavelength at which it settles, and the scales that decide it.
    fn found(&self, scene: &Scene, psd: &ProfilePsd) -> String {
        let mut text = self.touching(scene);
        text += &format!(
            " The area has settled within 1 % at {}",
            self.range(|answer| answer.within_1_percent.wavelength_m, length)
        );
        text += &if self.answers.iter().all(|(_, answer)| answer.within_01_percent.converged) {
            format!(
                " and within 0.1 % at {}.",
                self.range(|answer| answer.within_01_percent.wavelength_m, length)
            )
        } else {
            ", but not within 0.1 %.".to_owned()
        };
        text += &self.deciding(scene, psd);
        text += &self.by_construction().unwrap_or_default();
        text
    }

    /// The reason why a stack settles on any surface, so that this is no sign of accuracy.
    fn by_construction(&self) -> Option<String> {
        let setting: Vec<_> = self.answers.iter().map(|(_, answer)| answer.setting).collect::<Option<_>>()?;
        Some(format!(
            " A stack settles by construction: its pressure cannot exceed {}, which flattens the scale at {} that sets the real \
             pressure.",
            range(setting.iter().map(|scale| scale.full_contact_pressure_pa), pressure),
            range(setting.iter().map(|scale| scale.wavelength_m), length)
        ))
    }

    /// The decade that decides most, for all loads together or for each.
    fn deciding(&self, scene: &Scene, psd: &ProfilePsd) -> String {
        let decade = |answer: &LoadAnswer| {
            let decade = answer.decisive_decade()?;
            Some((decade_name(decade, psd), decade.share))
        };
        let mut decades: Vec<(String, Vec<usize>, Vec<f64>)> = Vec::new();
        for (load, answer) in &self.answers {
            let Some((name, share)) = decade(answer) else { continue };
            match decades.iter_mut().find(|(known, ..)| *known == name) {
                Some((_, loads, shares)) => {
                    loads.push(*load);
                    shares.push(share);
                }
                None => decades.push((name, vec![*load], vec![share])),
            }
        }
        let percent = |share: f64| format!("{:.0}\u{a0}%", 100.0 * share);
        let several = decades.len() > 1;
        let clause = |(name, loads, shares): &(String, Vec<usize>, Vec<f64>)| {
            let shares = range(shares.iter().copied(), percent);
            if several {
                format!("{name} {} ({shares})", at_loads(scene, loads))
            } else {
                format!("{name} ({shares})")
            }
        };
        if decades.is_empty() {
            return String::new();
        }
        let clauses: Vec<String> = decades.iter().map(clause).collect();
        format!(" The decisive decade is {}.", clauses.join(", "))
    }
}

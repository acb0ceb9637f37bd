//! Notes and errors of questions in words.

use asperity::FLAGGED_ASPECT_RATIO_OVER_CRITICAL;
use elements::half_space::HalfSpaceError;
use elements::{ElementsError, IndenterShape};
use questions::{
    CurveCounts, CutCounts, FEW_TOUCH, GapCounts, LawQuantity, LevelCounts, Note, OptionName, QuestionError,
    Reason, SampledScales, Spelling, UnusedOption,
};
use study::body_properties::BodyProperty;
use study::material::MaterialError;
use study::models::Choice;
use study::plan::Results;
use study::validity::SMALL_SLOPE_GRADIENT;
use topography::Severity;
use units::display::{counted, length, pressure, three_digits};
use units::number;

use super::state_words::{narrow_spectra, notes_of_states};
use crate::{doubt_words, elements_words, persson_words, row_notes, scan_words};

/// A sentence about an answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    /// Severity of the sentence.
    pub severity: Severity,
    /// The sentence, without a full stop.
    pub text: String,
}

/// A note in words; several lines if it has several sentences, none if there is nothing to say.
#[must_use]
pub fn lines(note: &Note, spelling: &dyn Spelling) -> Vec<Line> {
    if let Note::Surface(note) = note {
        return vec![Line { severity: note.severity(), text: scan_words::note(note) }];
    }
    texts(note, spelling).into_iter().map(|text| Line { severity: Severity::Note, text }).collect()
}

fn texts(note: &Note, spelling: &dyn Spelling) -> Vec<String> {
    match note {
        Note::Surface(note) => vec![scan_words::note(note)],
        Note::Doubt(doubt) => vec![format!("doubtful: {}", doubt_words::line(doubt))],
        Note::AssumedStrength { yield_strength_pa } => {
            vec![format!("no yield strength given: S0 = H/3 = {} is used", pressure(*yield_strength_pa))]
        }
        Note::ModulusOfLayer => vec![doubt_words::MODULUS_OF_LAYER.to_owned()],
        Note::ToleranceTooFine { asked, used } => vec![format!(
            "{} is finer than double precision reaches: {} is used",
            spelling.with_value(OptionName::Tolerance, &number(*asked)),
            number(*used)
        )],
        Note::Sampling(scales) => vec![format!(
            "{}; the area depends on how densely scales are sampled ({})",
            sampled_scales(scales),
            spelling.option(OptionName::ScalesPerDecade)
        )],
        Note::FirstRowIsEmpty => {
            vec!["the longest wavelength has no asperities yet: its row is empty".to_owned()]
        }
        Note::Counts(counts) => of_counts(counts),
        Note::Correction { .. } | Note::NoRollOff { .. } | Note::FewTouchBelow { .. } => {
            persson_words::words(note)
        }
        Note::WavesOfProfiles => {
            vec![persson_words::by_profiles(
                &spelling.with_value(OptionName::ModelOption(Choice::Band), "2d"),
            )]
        }
        Note::LightLoads { up_to_pa, share } => vec![format!(
            "below {} the logarithmic law u = u0 ln(p00/p), K = p/u0 is within {} % of the pressure",
            pressure(*up_to_pa),
            three_digits(100.0 * share)
        )],
        Note::Gaps(gaps) => of_gaps(gaps),
        Note::NotGaussian { cutoffs, range_m: [longest_m, shortest_m], least_alpha } => {
            let at = match cutoffs {
                1 => format!("the cutoff {}", length(*longest_m)),
                many => format!("{many} cutoffs between {} and {}", length(*longest_m), length(*shortest_m)),
            };
            vec![format!(
                "nayak_alpha lies below 1.5 (down to {}) at {at}: no Gaussian isotropic surface has such moments, for which \
                 the asperity parameters are derived",
                number((least_alpha * 1000.0).round() / 1000.0)
            )]
        }
        Note::PurePowerLaw => {
            vec!["no roll-off can be identified: the fit is a pure power law".to_owned()]
        }
        Note::HurstOutOfRange { hurst_exponent } => vec![format!(
            "the Hurst exponent {} lies outside 0 to 1: no self-affine surface",
            number((hurst_exponent * 1000.0).round() / 1000.0)
        )],
        Note::AreaSpectrumAsItIs => vec![elements_words::TAKEN_AS_IT_IS.to_owned()],
        Note::RandomSurfaces(made) => {
            elements_words::of_surfaces(&made.spectrum, &made.random, &made.grid, made.contact_modulus_pa)
        }
        Note::Pressed(loads) => elements_words::of_results(loads),
        Note::Ball(caution) => vec![elements_words::of_indenter(IndenterShape::Ball, caution)],
        Note::Cylinder(caution) => vec![elements_words::of_indenter(IndenterShape::Cylinder, caution)],
        Note::RepeatedMap => vec![
            "the map is taken to repeat itself along and across the cylinder; steps where its ends meet carry load".to_owned(),
        ],
        Note::Adhesion(found) => vec![elements_words::of_adhesion(found)],
        Note::OnePlace => vec![
            "one place decides little: its summits may carry half as much again as others; press several surfaces"
                .to_owned(),
        ],
        Note::Places { scatter } => {
            vec![format!("the real area differs by {} % between the places (standard deviation)", three_digits(100.0 * scatter))]
        }
        Note::CoupledTractions { mismatch } => vec![coupled_tractions(*mismatch)],
        Note::Sliding { sliding, all } => vec![format!(
            "{sliding} of {}: the tangential stress reaches friction times pressure, and everything slides",
            counted(*all, "load")
        )],
        Note::Rows(note) => row_notes::lines(note),
    }
}

/// Dundurs' beta, which superposition leaves out.
pub(crate) fn coupled_tractions(mismatch: f64) -> String {
    format!(
        "pressing these bodies shears them as well (Dundurs' beta {}), which is left out; displacement and \
         loss hold for equal bodies",
        three_digits(mismatch)
    )
}

/// Number and range of scales.
fn sampled_scales(scales: &SampledScales) -> String {
    let density = scales.per_decade.map_or(String::new(), |n| format!(", {} per decade", three_digits(n)));
    let (longest, shortest) = (length(scales.longest_m), length(scales.shortest_m));
    format!("{} scales from {longest} to {shortest}{density}", scales.scales)
}

/// Number and range of the scales of results, on which the stacked area depends.
pub(crate) fn sampling(results: &Results) -> String {
    sampled_scales(&SampledScales::of(&results.psd))
}

/// Counts of a curve in words.
pub(crate) fn of_counts(counts: &CurveCounts) -> Vec<String> {
    let all = counted(counts.states.all + counts.narrow.count, "row");
    let narrow = narrow_spectra(&counts.narrow, &all);
    let of_states = notes_of_states(&counts.states).into_iter().chain(narrow);
    of_states.chain(of_levels(&counts.levels)).chain(of_cuts(&counts.cuts)).collect()
}

fn of_levels(LevelCounts { all, beyond }: &LevelCounts) -> Option<String> {
    (*beyond > 0).then(|| {
        format!(
            "{beyond} of {}: B/B_c above {FLAGGED_ASPECT_RATIO_OVER_CRITICAL}, beyond the range of the elastic-plastic sinusoid",
            counted(*all, "level")
        )
    })
}

fn of_cuts(CutCounts { all, steep, longest_steep_m, steepest, flowing }: &CutCounts) -> Vec<String> {
    let of_flow = (*flowing > 0).then(|| {
        format!(
            "{}: the nominal pressure is not below the hardness; everything touches and flows, at every cutoff",
            counted(*flowing, "load")
        )
    });
    let of_slopes = (*steep > 0).then(|| {
        format!(
            "{steep} of {}, from {} down: the rms gradient h' exceeds {} (up to {}) and with it s = E* h'/2 exceeds E*/10; \
             the theory assumes small slopes",
            counted(*all, "cutoff"),
            length(*longest_steep_m),
            SMALL_SLOPE_GRADIENT,
            three_digits(*steepest)
        )
    });
    of_flow.into_iter().chain(of_slopes).collect()
}

/// Gaps that mean little, or are missing.
pub(crate) fn of_gaps(gaps: &GapCounts) -> Vec<String> {
    let GapCounts { all, few_touch, negative, missing } = *gaps;
    let at = |count: usize, told: &str| (count > 0).then(|| format!("at {count} of {all} loads {told}"));
    let few = format!(
        "the mean gap exceeds {FEW_TOUCH} rms heights: only a few asperities of a finite sample touch"
    );
    let below = "the mean gap is negative: the model ignores that asperities push their neighbours down";
    let none = "there is no mean gap: more than 3 % of the contact is plastic, or it is complete";
    [at(few_touch, &few), at(negative, below), at(missing, none)].into_iter().flatten().collect()
}

/// An unused option in words: `--gamma has no bearing on --model hertz; leave it out`.
#[must_use]
pub fn unused(UnusedOption { option, why }: &UnusedOption, spelling: &dyn Spelling) -> String {
    let option = spelling.option(*option);
    let on = |model: &str, why: &str| {
        format!("{option} has no bearing on {}{why}; leave it out", spelling.model(model))
    };
    let name = |option| spelling.option(option);
    match why {
        Reason::Model(model) => on(model, ""),
        Reason::OnlyOn { model, models } => on(model, &format!(", only on {}", models.join(", "))),
        Reason::DoesNotYield(model) => on(model, ", which does not yield"),
        Reason::CorrectionsAreElastic(model) => on(model, ": the corrected forms are elastic ones"),
        Reason::HardnessDoesNotGrow(model) => on(
            model,
            &format!(
                " without {} or {}: the hardness does not grow",
                name(OptionName::ModelOption(Choice::HardnessLaw)),
                name(OptionName::StrainGradientLength)
            ),
        ),
        Reason::OtherHardnessLaw(model) => on(
            model,
            &format!(" with a {} other than nix-gao", name(OptionName::ModelOption(Choice::HardnessLaw))),
        ),
        Reason::StrengthDoesNotGrow => format!(
            "{option} limits a strength that grows at small depths, and without {} none does; leave it out, or give that \
             length",
            name(OptionName::StrainGradientLength)
        ),
        Reason::BoundaryElements => on(
            "bem",
            &format!(
                ", which is elastic and takes its waves by {} and {}",
                name(OptionName::Longest),
                name(OptionName::Shortest)
            ),
        ),
        Reason::HalfSpaces(contact) => {
            format!(
                "{option} has no bearing on {contact}, which are computed for half-spaces alone; leave it out"
            )
        }
        Reason::RigidBase => format!(
            "{option} has no bearing on a rigid base: leave it out, or leave out {}",
            spelling.with_value(OptionName::LayerBase, "rigid")
        ),
        Reason::KindOfFile(kind) => format!("{option} has no bearing on a {kind}"),
        Reason::Quantity(quantity) => {
            let quantity = spelling.with_value(OptionName::Quantity, quantity);
            format!("{option} has no bearing on {quantity}; leave it out")
        }
        Reason::Beside(other) => {
            format!("{option} has no bearing beside {}; leave one of them out", name(*other))
        }
    }
}

/// An error in words, with the options that mend it.
#[must_use]
pub fn error(error: &QuestionError, spelling: &dyn Spelling) -> String {
    let name = |option: &OptionName| spelling.option(*option);
    match error {
        QuestionError::Unused(option) => unused(option, spelling),
        QuestionError::Missing(options) => {
            let names: Vec<String> = options.iter().map(name).collect();
            format!("{} is needed", names.join(" or "))
        }
        QuestionError::ElasticConstant(option) => {
            format!("{} is needed: every model is at least elastic", name(option))
        }
        QuestionError::Body { option, error } => format!("{}: {error}", name(option)),
        QuestionError::Material(error) => of_material(error, spelling),
        QuestionError::Load { option, label, error } => {
            let given = match label {
                Some(label) => spelling.with_value(*option, label),
                None => name(option),
            };
            format!("{given}: {}", of_material(error, spelling))
        }
        QuestionError::CutoffBelowData { cutoff_m, shortest_m, surface } => format!(
            "{} leaves nothing out: the shortest wavelength of {surface} is {}; leave it out, or choose a longer one",
            spelling.with_value(OptionName::Cutoff, &length(*cutoff_m)),
            length(*shortest_m)
        ),
        QuestionError::TooManyLines { lines, most } => format!(
            "{} draws a line for each pressure and separation, and {lines} are given; give at most {most}",
            name(&OptionName::Figure)
        ),
        QuestionError::TooManyLoops { loops, most } => format!(
            "{} draws a loop for each pressure and tangential stress, and {loops} are given; give at most {most}",
            name(&OptionName::Figure)
        ),
        QuestionError::NoLoop => format!(
            "{}: every tangential stress reaches friction times pressure, and what slides has no loop; lower {}",
            name(&OptionName::Figure),
            name(&OptionName::TangentialStress)
        ),
        QuestionError::ConductanceOnly(correlation) => format!(
            "{} has no overclosure, only conductances; add {} or {}",
            spelling.model(correlation.name()),
            spelling.with_value(OptionName::Quantity, LawQuantity::Heat.name()),
            spelling.with_value(OptionName::Quantity, LawQuantity::Current.name())
        ),
        QuestionError::NoExponentialLaw(model) => format!(
            "{} is the law of light loads of Persson's theory, and {} has none; take the table",
            spelling.with_value(OptionName::Form, "exponential"),
            spelling.model(model.name)
        ),
        QuestionError::NotElastic(model) => {
            format!(
                "{} yields, and only elastic contacts are sheared; take persson or bem",
                spelling.model(model.name)
            )
        }
        QuestionError::NoStiffness { pressure_pa } => {
            format!(
                "the model has no stiffness under {}; press harder, or take persson or bem",
                pressure(*pressure_pa)
            )
        }
        QuestionError::Value { option, error } => format!("{}: {error}", name(option)),
        QuestionError::SaturationWithoutHardness => format!(
            "{} is given in H, and the material has no hardness: add {} or {}",
            name(&OptionName::Saturation),
            name(&OptionName::IndentationHardness),
            name(&OptionName::YieldStrength)
        ),
        QuestionError::Elements(ElementsError::HalfSpace(HalfSpaceError::CannotBeCarried {
            nominal_pressure_pa,
            saturation_pa,
        })) => elements_words::cannot_be_carried(
            *nominal_pressure_pa,
            *saturation_pa,
            &name(&OptionName::Saturation),
        ),
        error => error.to_string(),
    }
}

/// An error of the material, with the options that mend it.
#[must_use]
pub fn of_material(error: &MaterialError, spelling: &dyn Spelling) -> String {
    let name = |option| spelling.option(option);
    let hardness = || name(OptionName::IndentationHardness);
    let strength = || name(OptionName::YieldStrength);
    match error {
        MaterialError::Missing(needed_for) => {
            let options = match needed_for.property() {
                BodyProperty::IndentationHardness => format!("{} or {}", hardness(), strength()),
                BodyProperty::YieldStrength => format!("{} or {}", strength(), hardness()),
                _ => name(OptionName::StrainGradientLength),
            };
            format!("{error}: give {}{options}", spelling.of_material())
        }
        MaterialError::HardnessOffStrength(_) => {
            format!("{error}: leave out {} or {}", hardness(), strength())
        }
        error => error.to_string(),
    }
}

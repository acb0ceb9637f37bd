//! Comments in front of the numbers.

use crate::finite_elements::{ContactLaw, ContactLawError, ExponentialLaw, UnitSystem};
use units::display::three_digits;
use units::number;

/// Longest line of comments; Abaqus reads 256 characters.
const WIDTH: usize = 100;
/// Letters of a name that Abaqus reads.
const LONGEST_NAME: usize = 80;

/// Caller's part of the comments, which comes before the description of the law.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Heading {
    /// Provenance of the law, in lines.
    pub provenance: Vec<String>,
    /// Name of the surface interaction.
    pub name: String,
}

impl Heading {
    /// Default name of the surface interaction.
    pub const NAME: &'static str = "ROUGH";

    /// Returns a name if it is valid in every code.
    ///
    /// # Errors
    /// [`ContactLawError::Name`] otherwise.
    pub fn checked_name(name: &str) -> Result<&str, ContactLawError> {
        let fits = name.len() <= LONGEST_NAME && name.starts_with(|c: char| c.is_ascii_alphabetic());
        let is_plain = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
        if fits && is_plain { Ok(name) } else { Err(ContactLawError::Name { most: LONGEST_NAME }) }
    }

    /// All comment lines in front of a table, without comment signs; `of_code` describes how the code reads it.
    pub(crate) fn of_table(&self, law: &ContactLaw, units: UnitSystem, of_code: Vec<String>) -> Vec<String> {
        let [first, last] = [1, law.points.len() - 1].map(|at| law.points[at].pressure_pa);
        let (pressure, length) = (units.pressure_symbol(), units.length_symbol());
        let cut = law.cut();
        let mut sentences = vec![
            format!(
                "Pressure against overclosure of a rough surface from {} {pressure} to {} {pressure}: {} rows, and straight \
                 lines between them, within {} % of the pressure of this model.",
                number(units.pressure(first)),
                number(units.pressure(last)),
                law.points.len(),
                number(100.0 * law.tolerance)
            ),
            self.of_units(units),
            NOMINAL.to_owned(),
            EXCESS.to_owned(),
            format!(
                "The overclosure is u_ref - u: u is the distance of the mean planes, which is the mean gap where nothing flows, and \
                 u_ref = {} {length} the one at {} {pressure}. There the law is cut off, the pressure is set to 0, and at larger \
                 distances there is none.",
                number(units.length(cut.mean_gap_m)),
                number(units.pressure(cut.pressure_pa))
            ),
        ];
        sentences.extend(of_code);
        self.wrapped(&sentences)
    }

    /// All comment lines in front of CalculiX' exponential form, without comment signs.
    pub(crate) fn of_exponential(&self, law: &ExponentialLaw, units: UnitSystem) -> Vec<String> {
        let (pressure, length) = (units.pressure_symbol(), units.length_symbol());
        let sentences = [
            format!(
                "Pressure against mean gap of a rough surface at light loads, p = p00 exp(-u/u0): u0 = {} {length}, p00 = {} \
                 {pressure}. CalculiX takes c0 = ln(100) u0 and p0 = p00, and the clearance of the mesh for the gap u.",
                number(units.length(law.decay_length_m)),
                number(units.pressure(law.reference_pressure_pa))
            ),
            format!(
                "Up to {} {pressure} it is within {} % of the pressure of Persson's theory. Where gaps exceed 1.5 rms heights the table \
                 carries less: heights end like a Gaussian.",
                three_digits(units.pressure(law.holds_up_to_pa)),
                number(100.0 * law.share)
            ),
            self.of_units(units),
            NOMINAL.to_owned(),
            EXCESS.to_owned(),
            format!(
                "CalculiX makes contact below the clearance c0 alone, that is above {} {pressure}: smaller pressures are cut \
                 off. Without a clearance in the mesh the pressure is p00. For smaller pressures take p0 = p00 exp(-s/u0) and \
                 a mesh whose clearance is u - s: that is the same law.",
                three_digits(units.pressure(0.01 * law.reference_pressure_pa))
            ),
            NODE_TO_SURFACE_EXPONENTIAL.to_owned(),
        ];
        self.wrapped(&sentences)
    }

    fn of_units(&self, units: UnitSystem) -> String {
        format!(
            "Units {units}: forces in {}, lengths in {}, pressures in {}; the model has to have the same.",
            units.force_symbol(),
            units.length_symbol(),
            units.pressure_symbol()
        )
    }

    fn wrapped(&self, sentences: &[String]) -> Vec<String> {
        let lines = self.provenance.iter().flat_map(|line| line.lines());
        let paragraphs = lines.chain(sentences.iter().map(String::as_str));
        paragraphs
            .flat_map(|paragraph| textwrap::wrap(paragraph, WIDTH))
            .map(std::borrow::Cow::into_owned)
            .collect()
    }
}

const NOMINAL: &str = "Pressures are nominal: force over the area that seems to touch.";

const EXCESS: &str = "The law is the compliance of the roughness, in excess of smooth bodies: those of the model deform \
                      beside it, and no half-space is in it, so that none counts twice.";

const NODE_TO_SURFACE_EXPONENTIAL: &str = "Take it with *CONTACT PAIR, TYPE=NODE TO SURFACE: in face-to-face contact CalculiX \
                                           2.20 makes no contact at a clearance.";

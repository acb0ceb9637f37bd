//! Uncertainties of the properties of a material.

use units::display::{length, pressure, three_digits};

use crate::spread::Spread;

/// Uncertainties of the properties of a material and its counterface; absent ones are taken for exact.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MaterialSpreads {
    /// Young's modulus of the rough body \[Pa\].
    pub youngs_modulus: Option<Spread>,
    /// Its Poisson's ratio.
    pub poisson_ratio: Option<Spread>,
    /// Young's modulus of the counterface \[Pa\].
    pub counterface_youngs_modulus: Option<Spread>,
    /// Its Poisson's ratio.
    pub counterface_poisson_ratio: Option<Spread>,
    /// The yield strength, and with it the hardness, over its centre.
    pub strength: Option<Spread>,
    /// The strain-gradient length \[m\].
    pub strain_gradient_length: Option<Spread>,
}

impl MaterialSpreads {
    /// Returns true if all properties are taken for exact.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.elastic_are_exact() && self.strength.is_none() && self.strain_gradient_length.is_none()
    }

    /// Returns true if the elastic constants of both bodies are taken for exact.
    #[must_use]
    pub fn elastic_are_exact(&self) -> bool {
        let elastic = [
            &self.youngs_modulus,
            &self.poisson_ratio,
            &self.counterface_youngs_modulus,
            &self.counterface_poisson_ratio,
        ];
        elastic.into_iter().all(Option::is_none)
    }

    /// A line for each property that scatters: its centre, its standard uncertainty, and the distribution.
    #[must_use]
    pub fn describe(&self) -> Vec<String> {
        type Words = fn(f64) -> String;
        let percent: Words = |share| format!("{} %", three_digits(100.0 * share));
        let properties: [(&str, &Option<Spread>, Words); 6] = [
            ("Young's modulus", &self.youngs_modulus, pressure),
            ("Poisson's ratio", &self.poisson_ratio, three_digits),
            ("Young's modulus of the counterface", &self.counterface_youngs_modulus, pressure),
            ("Poisson's ratio of the counterface", &self.counterface_poisson_ratio, three_digits),
            ("yield strength and hardness", &self.strength, percent),
            ("strain-gradient length", &self.strain_gradient_length, length),
        ];
        let line = |(name, spread, words): (&str, &Option<Spread>, Words)| {
            spread.as_ref().map(|spread| format!("{name} {}", in_words(spread, words)))
        };
        properties.into_iter().filter_map(line).collect()
    }
}

fn in_words(spread: &Spread, words: fn(f64) -> String) -> String {
    match spread {
        Spread::LogNormal { .. } | Spread::Beta { .. } => format!(
            "{}, standard uncertainty {} ({})",
            words(spread.centre()),
            words(spread.standard_uncertainty()),
            spread.distribution()
        ),
        Spread::Uniform { from, to } => format!("from {} to {} (uniform)", words(*from), words(*to)),
        Spread::Values(values) => format!(
            "{}, the median of {} values, standard uncertainty {}",
            words(spread.centre()),
            values.len(),
            words(spread.standard_uncertainty())
        ),
    }
}

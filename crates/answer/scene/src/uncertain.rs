//! Properties of a material as typed: a value, and its uncertainty if given.

use std::ops::Range;
use std::str::FromStr;

use serde_spanned::Spanned;
use units::{
    Bound, IndentationHardness, Length, Modulus, Pressure, QuantityError, Share, TypedSpread,
    standard_uncertainty,
};

use super::error::{SceneError, SceneProblem};
use super::raw::{Distribution, RawDistribution, RawProperty, RawQuantity};
use super::values::{text_of, value_error};
use study::body_properties::BodyProperty;
use study::material::MaterialError;
use study::spread::{Spread, SpreadError};

/// A value, which a plain run takes, and how well it is known.
pub(super) struct Uncertain<T> {
    pub value: T,
    pub spread: Option<Spread>,
}

impl<T> Uncertain<T> {
    fn exactly(value: T) -> Self {
        Uncertain { value, spread: None }
    }
}

/// A property > 0 with a unit.
pub(super) trait Property: FromStr<Err = QuantityError> {
    /// Returns the property in SI units, or a message if it cannot be converted.
    fn si(&self) -> Result<f64, String>;

    /// The property of a value in SI units.
    fn of_si(value: f64) -> Self;

    /// Returns a standard uncertainty in SI units if its size depends on the value; `None` if it can be read without the
    /// value.
    fn uncertainty_beside(_value: &str, _uncertainty: &str) -> Result<Option<f64>, QuantityError> {
        Ok(None)
    }
}

impl Property for Modulus {
    fn si(&self) -> Result<f64, String> {
        Ok(self.pa)
    }

    fn of_si(pa: f64) -> Self {
        Modulus { pa }
    }
}

impl Property for IndentationHardness {
    fn si(&self) -> Result<f64, String> {
        Ok(self.pa)
    }

    fn of_si(pa: f64) -> Self {
        IndentationHardness { pa }
    }

    fn uncertainty_beside(value: &str, uncertainty: &str) -> Result<Option<f64>, QuantityError> {
        IndentationHardness::uncertainty_of_steps(value, uncertainty)
    }
}

/// The yield strength.
impl Property for Pressure {
    fn si(&self) -> Result<f64, String> {
        self.pascals(None).ok_or_else(|| MaterialError::StrengthInHardnesses.to_string())
    }

    fn of_si(pa: f64) -> Self {
        Pressure::Pascals(pa)
    }
}

impl Property for Length {
    fn si(&self) -> Result<f64, String> {
        Ok(self.m)
    }

    fn of_si(m: f64) -> Self {
        Length { m }
    }
}

/// Returns the spread of a property with a standard uncertainty, typed as in a scene on either side of `+-`. Returns `None` if
/// the uncertainty is zero.
///
/// # Errors
/// A message if the value or the uncertainty is invalid, or if the property has no uncertainty.
pub fn spread_of(property: BodyProperty, value: &str, uncertainty: &str) -> Result<Option<Spread>, String> {
    let typed = TypedSpread::PlusMinus { value: value.trim(), uncertainty: uncertainty.trim() };
    match property {
        BodyProperty::YoungsModulus => with_unit::<Modulus>(typed).map(|known| known.spread),
        BodyProperty::PoissonRatio => without_unit(typed).map(|known| known.spread),
        BodyProperty::YieldStrength => with_unit::<Pressure>(typed).map(|known| known.spread),
        BodyProperty::IndentationHardness => {
            with_unit::<IndentationHardness>(typed).map(|known| known.spread)
        }
        BodyProperty::StrainGradientLength => with_unit::<Length>(typed).map(|known| known.spread),
        other => Err(format!("{} is taken without an uncertainty", other.key())),
    }
}

/// A property with a unit, under its key.
pub(super) fn property<T: Property>(
    key: &str,
    raw: &Spanned<RawProperty>,
) -> Result<Uncertain<T>, SceneError> {
    match raw.get_ref() {
        RawProperty::Other(value) => {
            let text = text_of(value);
            let blame = |problem: String| value_error(key, &text, raw.span(), problem);
            match TypedSpread::parse(&text) {
                None => text
                    .parse()
                    .map(Uncertain::exactly)
                    .map_err(|error: QuantityError| blame(error.to_string())),
                Some(spread) => with_unit::<T>(spread).map_err(blame),
            }
        }
        RawProperty::Table(table) => of_table(
            key,
            table,
            &raw.span(),
            &Reading {
                value: |text| text.parse::<T>().map_err(|error| error.to_string())?.si(),
                plus_minus: |value, uncertainty| with_unit(TypedSpread::PlusMinus { value, uncertainty }),
                of_si: T::of_si,
                about_the_median: Distribution::LogNormal,
                bound: Bound::Magnitude,
            },
        ),
    }
}

/// A Poisson's ratio under its key.
pub(super) fn poisson_ratio(key: &str, raw: &Spanned<RawProperty>) -> Result<Uncertain<f64>, SceneError> {
    match raw.get_ref() {
        RawProperty::Other(toml::Value::Float(ratio)) => Ok(Uncertain::exactly(*ratio)),
        RawProperty::Other(toml::Value::Integer(ratio)) => Ok(Uncertain::exactly(*ratio as f64)),
        RawProperty::Other(value) => {
            let text = text_of(value);
            let Some(spread) = TypedSpread::parse(&text) else {
                let found = match value {
                    toml::Value::String(text) => format!("string {text:?}"),
                    other => format!("{} {other}", other.type_str()),
                };
                let wanted = "a number".to_owned();
                return Err(SceneError::at(raw.span(), SceneProblem::WrongType { found, wanted }));
            };
            without_unit(spread).map_err(|problem| value_error(key, &text, raw.span(), problem))
        }
        RawProperty::Table(table) => of_table(
            key,
            table,
            &raw.span(),
            &Reading {
                value: ratio,
                plus_minus: |value, uncertainty| without_unit(TypedSpread::PlusMinus { value, uncertainty }),
                of_si: |ratio| ratio,
                about_the_median: Distribution::Beta,
                bound: asperity::ElasticBody::POISSON_RATIO,
            },
        ),
    }
}

fn with_unit<T: Property>(typed: TypedSpread<'_>) -> Result<Uncertain<T>, String> {
    let si = |text: &str| text.parse::<T>().map_err(|error| error.to_string())?.si();
    let in_words = |error: SpreadError| error.to_string();
    match typed {
        TypedSpread::PlusMinus { value: text, uncertainty } => {
            let value: T = text.parse().map_err(|error: QuantityError| error.to_string())?;
            let median = value.si()?;
            let beside = T::uncertainty_beside(text, uncertainty).map_err(|error| error.to_string())?;
            let uncertainty = match (share(uncertainty)?, beside) {
                (Some(share), _) => share * median,
                (None, Some(uncertainty)) => uncertainty,
                (None, None) => standard_uncertainty::<T>(uncertainty)
                    .map_err(|error| error.to_string())?
                    .map_or(Ok(0.0), |uncertainty| uncertainty.si())?,
            };
            if uncertainty > median {
                return Err("the uncertainty exceeds the value; write a smaller one, or an interval, as 100 MPa to 1 GPa".to_owned());
            }
            Ok(Uncertain { value, spread: Spread::log_normal(median, uncertainty).map_err(in_words)? })
        }
        TypedSpread::Interval { from, to } => {
            let (centre, spread) = Spread::log_normal_within(si(from)?, si(to)?).map_err(in_words)?;
            Ok(Uncertain { value: T::of_si(centre), spread })
        }
    }
}

fn without_unit(typed: TypedSpread<'_>) -> Result<Uncertain<f64>, String> {
    let in_words = |error: SpreadError| error.to_string();
    match typed {
        TypedSpread::PlusMinus { value, uncertainty } => {
            let median = ratio(value)?;
            let uncertainty = match share(uncertainty)? {
                Some(share) => share * median,
                None => ratio(uncertainty)?,
            };
            let spread = Spread::poisson_ratio(median, uncertainty).map_err(in_words)?;
            Ok(Uncertain { value: median, spread })
        }
        TypedSpread::Interval { from, to } => {
            let (value, spread) = Spread::poisson_ratio_within(ratio(from)?, ratio(to)?).map_err(in_words)?;
            Ok(Uncertain { value, spread })
        }
    }
}

/// A number without a unit.
fn ratio(text: &str) -> Result<f64, String> {
    text.trim().parse().map_err(|_| format!("expected a number such as 0.3, found '{text}'"))
}

/// A share, typed in percent only.
fn share(text: &str) -> Result<Option<f64>, String> {
    if !text.ends_with('%') {
        return Ok(None);
    }
    text.parse().map(|share: Share| Some(share.fraction)).map_err(|error| error.to_string())
}

/// Functions and bounds that read the values of a distribution's table.
struct Reading<T> {
    /// A value in SI units.
    value: fn(&str) -> Result<f64, String>,
    /// A median with its standard uncertainty.
    plus_minus: fn(&str, &str) -> Result<Uncertain<T>, String>,
    of_si: fn(f64) -> T,
    /// The distribution of a median with its standard uncertainty.
    about_the_median: Distribution,
    /// Bound of ends and values.
    bound: Bound,
}

/// Reads a property from the table of its distribution, at `span` in the text.
fn of_table<T>(
    key: &str,
    table: &RawDistribution,
    span: &Range<usize>,
    reading: &Reading<T>,
) -> Result<Uncertain<T>, SceneError> {
    let RawDistribution { distribution, median, standard_uncertainty, from, to, values } = table;
    let given = [
        ("median", median.is_some()),
        ("standard_uncertainty", standard_uncertainty.is_some()),
        ("from", from.is_some()),
        ("to", to.is_some()),
        ("values", values.is_some()),
    ];
    let (name, takes): (_, &[&str]) = match distribution {
        Distribution::LogNormal => ("log-normal", &["median", "standard_uncertainty"]),
        Distribution::Beta => ("beta", &["median", "standard_uncertainty"]),
        Distribution::Uniform => ("uniform", &["from", "to"]),
        Distribution::Values => ("values", &["values"]),
    };
    let has_median = matches!(distribution, Distribution::LogNormal | Distribution::Beta);
    if has_median && *distribution != reading.about_the_median {
        let right = if *distribution == Distribution::Beta { "log-normal" } else { "beta" };
        let message = format!("it cannot be {name}; it may be {right}, uniform or values");
        return Err(value_error(&format!("{key}.distribution"), name, span.clone(), message));
    }
    if let Some((wrong, is_given)) = given.into_iter().find(|(key, given)| takes.contains(key) != *given) {
        let message = match is_given {
            true => format!("key {key}.{wrong} says nothing about the distribution {name}; leave it out"),
            false => format!("key {key}: the distribution {name} needs {}", takes.join(" and ")),
        };
        return Err(SceneError::at(span.clone(), message));
    }
    let bounded = |name: &str, raw: &RawQuantity| {
        let text = text_of(raw.get_ref());
        let value = (reading.value)(&text).and_then(|value| {
            reading.bound.check("the value in SI units", value).map_err(|error| error.to_string())
        });
        value.map_err(|problem| value_error(&format!("{key}.{name}"), &text, raw.span(), problem))
    };
    let blame = |error: SpreadError| value_error(key, name, span.clone(), error);
    let (centre, spread) = match (median, standard_uncertainty, from, to, values) {
        (Some(median), Some(uncertainty), ..) => {
            let (median_text, uncertainty_text) = (text_of(median.get_ref()), text_of(uncertainty.get_ref()));
            let known = (reading.plus_minus)(&median_text, &uncertainty_text);
            return known.map_err(|problem| value_error(key, &median_text, span.clone(), problem));
        }
        (_, _, Some(from), Some(to), _) => {
            Spread::uniform(bounded("from", from)?, bounded("to", to)?).map_err(blame)?
        }
        (.., values) => {
            let values = values.iter().flatten().map(|raw| bounded("values", raw));
            Spread::values(values.collect::<Result<_, _>>()?).map_err(blame)?
        }
    };
    Ok(Uncertain { value: (reading.of_si)(centre), spread })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_beside_a_value_is_what_stands_behind_it_in_a_scene() {
        let modulus = |uncertainty| spread_of(BodyProperty::YoungsModulus, "210 GPa", uncertainty);
        assert_eq!(modulus("5 GPa"), Ok(Spread::log_normal(210e9, 5e9).unwrap()));
        assert_eq!(modulus(" 5 % "), Ok(Spread::log_normal(210e9, 0.05 * 210e9).unwrap()));
        assert_eq!(modulus("0 GPa"), Ok(None));
        assert!(modulus("5").unwrap_err().contains("unit"), "{:?}", modulus("5"));
        let ratio = spread_of(BodyProperty::PoissonRatio, "0.3", "0.02");
        assert_eq!(ratio, Ok(Spread::poisson_ratio(0.3, 0.02).unwrap()));
        let hardness = spread_of(BodyProperty::IndentationHardness, "300 HV", "10 HV").unwrap().unwrap();
        assert!((hardness.standard_uncertainty() / hardness.centre() - 1.0 / 30.0).abs() < 1e-12);
        let strength = spread_of(BodyProperty::YieldStrength, "0.3 H", "10 %");
        assert!(strength.unwrap_err().contains("cannot be given in H"));
        assert!(spread_of(BodyProperty::StrainGradientLength, "1 um", "0.1 um").unwrap().is_some());
    }
}

//! Options of questions.

use study::interface::GasOption;
use study::models::Choice;
use units::{Remark, RemarkCode};

/// An option of a question, whatever a front end calls it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum OptionName {
    /// Amplitude of a scale.
    Amplitude,
    /// Edges of a map.
    Boundary,
    /// Channel of a file of heights.
    Channel,
    /// Poisson's ratio of the counterface.
    CounterfacePoissonRatio,
    /// Electrical resistivity of the counterface.
    CounterfaceResistivity,
    /// Thermal conductivity of the counterface.
    CounterfaceThermalConductivity,
    /// Shortest wavelength that takes part.
    Cutoff,
    /// Trend that is subtracted from a map.
    Detrend,
    /// Lines of a map.
    Direction,
    /// Figure of the table.
    Figure,
    /// Form in which a law is written.
    Form,
    /// Coefficient of friction.
    Friction,
    /// Option of the gas in the gaps.
    Gas(GasOption),
    /// Points along a side of a random surface.
    Grid,
    /// Indentation hardness.
    IndentationHardness,
    /// Base of the layer.
    LayerBase,
    /// Poisson's ratio of the layer.
    LayerPoissonRatio,
    /// Thickness of the layer.
    LayerThickness,
    /// Young's modulus of the layer.
    LayerYoungsModulus,
    /// Longest wavelength of random surfaces.
    Longest,
    /// Treatment of points without a height.
    MissingPoints,
    /// Model.
    Model,
    /// Option of a model.
    ModelOption(Choice),
    /// Name of a surface interaction.
    Name,
    /// Normalisation of moments.
    Normalisation,
    /// Phases of random surfaces.
    Phases,
    /// Poisson's ratio of the rough body.
    PoissonRatio,
    /// Nominal pressure.
    Pressure,
    /// Range of nominal pressures of a law.
    PressureRange,
    /// Ranges of nominal pressures.
    Pressures,
    /// Quantity of a law.
    Quantity,
    /// Options for reading spectra.
    Reading,
    /// Number of random surfaces.
    Realisations,
    /// Electrical resistivity of the rough body.
    Resistivity,
    /// Pressure at which boundary elements yield.
    Saturation,
    /// Density of scales.
    ScalesPerDecade,
    /// Seed of random surfaces.
    Seed,
    /// Separation.
    Separation,
    /// Shortest wavelength of random surfaces.
    Shortest,
    /// Length of a side of a random surface.
    Side,
    /// Size of a scan.
    Size,
    /// Length of that growth.
    StrainGradientLength,
    /// Limit of that growth.
    StrengthCap,
    /// Tangential stress.
    TangentialStress,
    /// Thermal conductivity of the rough body.
    ThermalConductivity,
    /// Relative tolerance of statistical states.
    Tolerance,
    /// Unit of a scan.
    Unit,
    /// Yield strength.
    YieldStrength,
    /// Young's modulus.
    YoungsModulus,
}

impl OptionName {
    /// Returns the option of a choice; that of a strength is the yield strength.
    #[must_use]
    pub fn of_choice(choice: Choice) -> Self {
        match choice {
            Choice::Strength => OptionName::YieldStrength,
            choice => OptionName::ModelOption(choice),
        }
    }

    /// Returns the name in lower case, with underscores between its words: `interference_law`.
    #[must_use]
    pub fn snake_case(self) -> String {
        match self {
            OptionName::ModelOption(choice) => return choice.key().to_owned(),
            OptionName::Gas(option) => return option.key().to_owned(),
            _ => {}
        }
        let mut name = String::new();
        for letter in format!("{self:?}").chars() {
            if letter.is_uppercase() && !name.is_empty() {
                name.push('_');
            }
            name.extend(letter.to_lowercase());
        }
        name
    }
}

/// Refuses the first option of a list that is given, for the reason in a remark.
pub(crate) fn first_given(
    options: impl IntoIterator<Item = (OptionName, bool)>,
    reason: Remark,
) -> Result<(), Box<Remark>> {
    match options.into_iter().find(|(_, is_given)| *is_given) {
        Some((option, _)) => Err(Box::new(reason.on(option.snake_case()))),
        None => Ok(()),
    }
}

/// The reason that a model has no such option.
pub(crate) fn not_of_model(model: &'static str) -> Remark {
    Remark::new(RemarkCode::NoSuchOption).with("model", model)
}

//! The properties of a body: names, units, and which of them may be uncertain.

/// A property of a body that a scene may give, of the rough body as well as of its counterface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BodyProperty {
    /// Young's modulus.
    YoungsModulus,
    /// Poisson's ratio.
    PoissonRatio,
    /// The yield strength S0.
    YieldStrength,
    /// The indentation hardness H.
    IndentationHardness,
    /// The strain-gradient length h*.
    StrainGradientLength,
    /// The thermal conductivity.
    ThermalConductivity,
    /// The electrical resistivity.
    Resistivity,
}

impl BodyProperty {
    /// Every property, in the order of the keys of a scene.
    pub const ALL: [BodyProperty; 7] = [
        BodyProperty::YoungsModulus,
        BodyProperty::PoissonRatio,
        BodyProperty::YieldStrength,
        BodyProperty::IndentationHardness,
        BodyProperty::StrainGradientLength,
        BodyProperty::ThermalConductivity,
        BodyProperty::Resistivity,
    ];

    /// Those that give each other, H = 3 S0.
    pub const STRENGTHS: [BodyProperty; 2] = [BodyProperty::YieldStrength, BodyProperty::IndentationHardness];

    /// The key in scenes, the SI unit if it has one, and true if it may be uncertain.
    const fn facts(self) -> (&'static str, Option<&'static str>, bool) {
        match self {
            BodyProperty::YoungsModulus => ("youngs_modulus", Some("Pa"), true),
            BodyProperty::PoissonRatio => ("poisson_ratio", None, true),
            BodyProperty::YieldStrength => ("yield_strength", Some("Pa"), true),
            BodyProperty::IndentationHardness => ("indentation_hardness", Some("Pa"), true),
            BodyProperty::StrainGradientLength => ("strain_gradient_length", Some("m"), true),
            BodyProperty::ThermalConductivity => ("thermal_conductivity", Some("W/(m K)"), false),
            BodyProperty::Resistivity => ("resistivity", Some("ohm m"), false),
        }
    }

    /// Returns the key in scenes, e.g. `youngs_modulus`.
    #[must_use]
    pub const fn key(self) -> &'static str {
        self.facts().0
    }

    /// Returns the property of a key.
    #[must_use]
    pub fn of_key(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|property| property.key() == key)
    }

    /// Returns the SI unit, or nothing for a property without one.
    #[must_use]
    pub const fn unit(self) -> Option<&'static str> {
        self.facts().1
    }

    /// Returns true if a scene may give its uncertainty.
    #[must_use]
    pub const fn may_be_uncertain(self) -> bool {
        self.facts().2
    }
}

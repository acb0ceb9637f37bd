//! The quantities of an interface.

use serde::Serialize;

/// A quantity of an interface; all are > 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// Mean separation of the mean planes \[m\].
    MeanGap,
    /// Stiffness K = -dp/du per nominal area \[Pa/m\].
    Stiffness,
    /// Thermal conductance per nominal area by Barber's analogy \[W/(m^2 K)\].
    ThermalConductance,
    /// Thermal conductance per nominal area by Yovanovich's correlation for peaks that have flowed \[W/(m^2 K)\].
    YovanovichConductance,
    /// Thermal conductance per nominal area by the correlation of Cooper, Mikic & Yovanovich \[W/(m^2 K)\].
    CooperMikicYovanovichConductance,
    /// Distance Y of the mean planes where peaks have flowed at the hardness \[m\].
    FlowedGap,
    /// Thermal conductance of flowed peaks, by Yovanovich's correlation, and of the gas in their gap per nominal area
    /// \[W/(m^2 K)\].
    FlowedConductanceWithGas,
    /// Electrical conductance per nominal area by Yovanovich's correlation for peaks that have flowed \[S/m^2\].
    FlowedElectricalConductance,
    /// Thermal conductance of the gas in the gaps per nominal area \[W/(m^2 K)\].
    GasConductance,
    /// Thermal conductance of spots, by Barber's analogy, and gas per nominal area \[W/(m^2 K)\].
    ThermalConductanceWithGas,
    /// Thermal resistance of the nominal area \[K/W\].
    ThermalResistance,
    /// Electrical conductance per nominal area by Barber's analogy \[S/m^2\].
    ElectricalConductance,
    /// Electrical resistance of the nominal area \[ohm\].
    ElectricalResistance,
    /// The wavelength at which the last channel is narrowest \[m\].
    ChannelWavelength,
    /// The height of that place \[m\].
    ChannelHeight,
    /// Low end of the leak rate \[m^3/s\].
    LeakRateLow,
    /// High end of the leak rate \[m^3/s\].
    LeakRateHigh,
    /// The nominal pressure that closes the last channel, elastically or as the bodies flow \[Pa\].
    TightPressure,
    /// Friction per nominal area \[Pa\].
    FrictionStress,
    /// Friction over load.
    FrictionCoefficient,
    /// Tangential stiffness dq/dd at no tangential load, per nominal area \[Pa/m\].
    TangentialStiffness,
    /// Tangential displacement d on first loading \[m\].
    TangentialDisplacement,
    /// Share of the nominal area that sticks under the tangential load.
    StuckAreaFraction,
    /// Energy lost in a cycle of the tangential load between both signs, per nominal area \[J/m^2\].
    TangentialDissipation,
    /// Equivalent viscous damping ratio of that cycle, W/(2 pi q d).
    DampingRatio,
    /// The adhesion parameter of Fuller & Tabor.
    FullerTabor,
    /// The left side of the criterion of Pastewka & Robbins.
    PastewkaRobbins,
}

/// A place for a quantity: under a load, of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Slot {
    /// The quantity.
    pub quantity: Quantity,
    /// The load, by index; absent if the quantity does not depend on the load.
    pub load: Option<usize>,
    /// The curve whose area it is made from, by index; absent where Persson's elastic theory makes it.
    pub curve: Option<usize>,
}

impl Quantity {
    /// The quantities of a tangential load.
    pub const OF_SHEAR: [Quantity; 5] = [
        Quantity::TangentialStiffness,
        Quantity::TangentialDisplacement,
        Quantity::StuckAreaFraction,
        Quantity::TangentialDissipation,
        Quantity::DampingRatio,
    ];

    /// Its name in tables, with its unit.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Quantity::MeanGap => "mean_gap_m",
            Quantity::Stiffness => "stiffness_pa_per_m",
            Quantity::ThermalConductance => "thermal_conductance_w_per_m2_k",
            Quantity::YovanovichConductance => "yovanovich_conductance_w_per_m2_k",
            Quantity::CooperMikicYovanovichConductance => "cooper_mikic_yovanovich_conductance_w_per_m2_k",
            Quantity::FlowedGap => "flowed_gap_m",
            Quantity::FlowedConductanceWithGas => "flowed_conductance_with_gas_w_per_m2_k",
            Quantity::FlowedElectricalConductance => "flowed_electrical_conductance_s_per_m2",
            Quantity::GasConductance => "gas_conductance_w_per_m2_k",
            Quantity::ThermalConductanceWithGas => "thermal_conductance_with_gas_w_per_m2_k",
            Quantity::ThermalResistance => "thermal_resistance_k_per_w",
            Quantity::ElectricalConductance => "electrical_conductance_s_per_m2",
            Quantity::ElectricalResistance => "electrical_resistance_ohm",
            Quantity::ChannelWavelength => "channel_wavelength_m",
            Quantity::ChannelHeight => "channel_height_m",
            Quantity::LeakRateLow => "leak_rate_low_m3_per_s",
            Quantity::LeakRateHigh => "leak_rate_high_m3_per_s",
            Quantity::TightPressure => "tight_pressure_pa",
            Quantity::FrictionStress => "friction_stress_pa",
            Quantity::FrictionCoefficient => "friction_coefficient",
            Quantity::TangentialStiffness => "tangential_stiffness_pa_per_m",
            Quantity::TangentialDisplacement => "tangential_displacement_m",
            Quantity::StuckAreaFraction => "stuck_area_fraction",
            Quantity::TangentialDissipation => "tangential_dissipation_j_per_m2",
            Quantity::DampingRatio => "damping_ratio",
            Quantity::FullerTabor => "fuller_tabor",
            Quantity::PastewkaRobbins => "pastewka_robbins",
        }
    }

    /// Returns true if it follows the stiffness, some by Barber's analogy.
    #[must_use]
    pub fn follows_stiffness(self) -> bool {
        matches!(
            self,
            Quantity::Stiffness
                | Quantity::ThermalConductance
                | Quantity::ThermalConductanceWithGas
                | Quantity::ThermalResistance
                | Quantity::ElectricalConductance
                | Quantity::ElectricalResistance
                | Quantity::TangentialStiffness
                | Quantity::TangentialDisplacement
                | Quantity::TangentialDissipation
        )
    }

    /// Its name in sentences.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Quantity::MeanGap => "mean gap",
            Quantity::Stiffness => "stiffness",
            Quantity::ThermalConductance => "thermal conductance",
            Quantity::YovanovichConductance => "thermal conductance of flowed peaks (Yovanovich)",
            Quantity::CooperMikicYovanovichConductance => {
                "thermal conductance of flowed peaks (Cooper, Mikic & Yovanovich)"
            }
            Quantity::FlowedGap => "distance of the mean planes of flowed peaks",
            Quantity::FlowedConductanceWithGas => "thermal conductance of flowed peaks and gas",
            Quantity::FlowedElectricalConductance => "electrical conductance of flowed peaks (Yovanovich)",
            Quantity::GasConductance => "thermal conductance of the gas in the gaps",
            Quantity::ThermalConductanceWithGas => "thermal conductance of spots and gas",
            Quantity::ThermalResistance => "thermal resistance",
            Quantity::ElectricalConductance => "electrical conductance",
            Quantity::ElectricalResistance => "electrical resistance",
            Quantity::ChannelWavelength => "wavelength of the last channel",
            Quantity::ChannelHeight => "height of the last channel",
            Quantity::LeakRateLow => "leak rate, at least",
            Quantity::LeakRateHigh => "leak rate, at most",
            Quantity::TightPressure => "pressure that makes it tight",
            Quantity::FrictionStress => "friction per nominal area",
            Quantity::FrictionCoefficient => "coefficient of friction",
            Quantity::TangentialStiffness => "tangential stiffness before any slip",
            Quantity::TangentialDisplacement => "tangential displacement",
            Quantity::StuckAreaFraction => "share of the nominal area that sticks",
            Quantity::TangentialDissipation => "energy lost per tangential cycle",
            Quantity::DampingRatio => "equivalent damping ratio",
            Quantity::FullerTabor => "adhesion parameter of Fuller & Tabor",
            Quantity::PastewkaRobbins => "left side of Pastewka & Robbins’ criterion, sticky below 1.03",
        }
    }

    /// Its unit, empty of a number.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Quantity::MeanGap
            | Quantity::FlowedGap
            | Quantity::ChannelWavelength
            | Quantity::ChannelHeight
            | Quantity::TangentialDisplacement => "m",
            Quantity::Stiffness | Quantity::TangentialStiffness => "Pa/m",
            Quantity::TangentialDissipation => "J/m²",
            Quantity::ThermalConductance
            | Quantity::YovanovichConductance
            | Quantity::CooperMikicYovanovichConductance
            | Quantity::FlowedConductanceWithGas
            | Quantity::GasConductance
            | Quantity::ThermalConductanceWithGas => "W/(m² K)",
            Quantity::ThermalResistance => "K/W",
            Quantity::ElectricalConductance | Quantity::FlowedElectricalConductance => "S/m²",
            Quantity::ElectricalResistance => "Ω",
            Quantity::LeakRateLow | Quantity::LeakRateHigh => "m³/s",
            Quantity::TightPressure | Quantity::FrictionStress => "Pa",
            Quantity::FrictionCoefficient
            | Quantity::StuckAreaFraction
            | Quantity::DampingRatio
            | Quantity::FullerTabor
            | Quantity::PastewkaRobbins => "",
        }
    }
}

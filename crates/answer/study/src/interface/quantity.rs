//! The quantities of an interface.

use serde::Serialize;

/// Defines the quantities, each with its name in tables, its name in sentences, and its unit.
macro_rules! quantities {
    ($($(#[$doc:meta])* $quantity:ident = $key:literal, $words:literal, $unit:literal;)+) => {
        /// A quantity of an interface; all are > 0.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
        #[serde(rename_all = "kebab-case")]
        pub enum Quantity {
            $($(#[$doc])* $quantity,)+
        }

        impl Quantity {
            /// Its name in tables, with its unit.
            #[must_use]
            pub fn key(self) -> &'static str {
                match self { $(Self::$quantity => $key,)+ }
            }

            /// Its name in sentences.
            #[must_use]
            pub fn words(self) -> &'static str {
                match self { $(Self::$quantity => $words,)+ }
            }

            /// Its unit, empty of a number.
            #[must_use]
            pub fn unit(self) -> &'static str {
                match self { $(Self::$quantity => $unit,)+ }
            }
        }
    };
}

quantities! {
    /// Mean separation of the mean planes \[m\].
    MeanGap = "mean_gap_m", "mean gap", "m";
    /// Stiffness K = -dp/du per nominal area \[Pa/m\].
    Stiffness = "stiffness_pa_per_m", "stiffness", "Pa/m";
    /// Thermal conductance per nominal area by Barber's analogy \[W/(m^2 K)\].
    ThermalConductance = "thermal_conductance_w_per_m2_k", "thermal conductance", "W/(m² K)";
    /// Thermal conductance per nominal area by Yovanovich's correlation for peaks that have flowed \[W/(m^2 K)\].
    YovanovichConductance =
        "yovanovich_conductance_w_per_m2_k", "thermal conductance of flowed peaks (Yovanovich)", "W/(m² K)";
    /// Thermal conductance per nominal area by the correlation of Cooper, Mikic & Yovanovich \[W/(m^2 K)\].
    CooperMikicYovanovichConductance =
        "cooper_mikic_yovanovich_conductance_w_per_m2_k",
        "thermal conductance of flowed peaks (Cooper, Mikic & Yovanovich)", "W/(m² K)";
    /// Distance Y of the mean planes where peaks have flowed at the hardness \[m\].
    YovanovichGap = "yovanovich_gap_m", "distance of the mean planes of flowed peaks", "m";
    /// Thermal conductance of flowed peaks, by Yovanovich's correlation, and of the gas in their gap per nominal area
    /// \[W/(m^2 K)\].
    YovanovichConductanceWithGas =
        "yovanovich_conductance_with_gas_w_per_m2_k", "thermal conductance of flowed peaks and gas", "W/(m² K)";
    /// Electrical conductance per nominal area by Yovanovich's correlation for peaks that have flowed \[S/m^2\].
    YovanovichElectricalConductance =
        "yovanovich_electrical_conductance_s_per_m2",
        "electrical conductance of flowed peaks (Yovanovich)", "S/m²";
    /// Thermal conductance of the gas in the gaps per nominal area \[W/(m^2 K)\].
    GasConductance = "gas_conductance_w_per_m2_k", "thermal conductance of the gas in the gaps", "W/(m² K)";
    /// Thermal conductance of spots, by Barber's analogy, and gas per nominal area \[W/(m^2 K)\].
    ThermalConductanceWithGas =
        "thermal_conductance_with_gas_w_per_m2_k", "thermal conductance of spots and gas", "W/(m² K)";
    /// Thermal resistance of the nominal area \[K/W\].
    ThermalResistance = "thermal_resistance_k_per_w", "thermal resistance", "K/W";
    /// Electrical conductance per nominal area by Barber's analogy \[S/m^2\].
    ElectricalConductance = "electrical_conductance_s_per_m2", "electrical conductance", "S/m²";
    /// Electrical resistance of the nominal area \[ohm\].
    ElectricalResistance = "electrical_resistance_ohm", "electrical resistance", "Ω";
    /// The wavelength at which the last channel is narrowest \[m\].
    ChannelWavelength = "channel_wavelength_m", "wavelength of the last channel", "m";
    /// The height of that place \[m\].
    ChannelHeight = "channel_height_m", "height of the last channel", "m";
    /// Height of the parallel slot that leaks as much, by the effective medium \[m\].
    LeakGap = "leak_gap_m", "height of the slot that leaks as much", "m";
    /// Low end of the leak rate \[m^3/s\].
    LeakRateLow = "leak_rate_low_m3_per_s", "leak rate, at least", "m³/s";
    /// High end of the leak rate \[m^3/s\].
    LeakRateHigh = "leak_rate_high_m3_per_s", "leak rate, at most", "m³/s";
    /// The nominal pressure that closes the last channel, elastically or as the bodies flow \[Pa\].
    TightPressure = "tight_pressure_pa", "pressure that makes it tight", "Pa";
    /// Friction per nominal area \[Pa\].
    FrictionStress = "friction_stress_pa", "friction per nominal area", "Pa";
    /// Friction over load.
    FrictionCoefficient = "friction_coefficient", "coefficient of friction", "";
    /// Tangential stiffness dq/dd at no tangential load, per nominal area \[Pa/m\].
    TangentialStiffness = "tangential_stiffness_pa_per_m", "tangential stiffness before any slip", "Pa/m";
    /// Tangential displacement d on first loading \[m\].
    TangentialDisplacement = "tangential_displacement_m", "tangential displacement", "m";
    /// Share of the nominal area that sticks under the tangential load.
    StuckAreaFraction = "stuck_area_fraction", "share of the nominal area that sticks", "";
    /// Energy lost in a cycle of the tangential load between both signs, per nominal area \[J/m^2\].
    TangentialDissipation = "tangential_dissipation_j_per_m2", "energy lost per tangential cycle", "J/m²";
    /// Equivalent viscous damping ratio of that cycle, W/(2 pi q d).
    DampingRatio = "damping_ratio", "equivalent damping ratio", "";
    /// The adhesion parameter of Fuller & Tabor.
    FullerTabor = "fuller_tabor", "adhesion parameter of Fuller & Tabor", "";
    /// The left side of the criterion of Pastewka & Robbins.
    PastewkaRobbins = "pastewka_robbins", "left side of Pastewka & Robbins’ criterion, sticky below 1.03", "";
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
    /// Tells whether it is what leaks through a seal, and so nothing where that is tight.
    #[must_use]
    pub fn is_of_leak(self) -> bool {
        matches!(self, Quantity::LeakGap | Quantity::LeakRateLow | Quantity::LeakRateHigh)
    }

    /// The quantities of a tangential load.
    pub const OF_SHEAR: [Quantity; 5] = [
        Quantity::TangentialStiffness,
        Quantity::TangentialDisplacement,
        Quantity::StuckAreaFraction,
        Quantity::TangentialDissipation,
        Quantity::DampingRatio,
    ];

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
}

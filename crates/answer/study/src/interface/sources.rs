//! Publications of the formulas for an interface.

use super::Quantity;

impl Quantity {
    /// Returns the publication of its formula; `None` for what follows from another quantity alone.
    #[must_use]
    pub fn publication(self) -> Option<&'static str> {
        Some(match self {
            Quantity::MeanGap | Quantity::Stiffness => {
                "Persson (2007), Phys. Rev. Lett. 99:125502; Almqvist et al. (2011), J. Mech. Phys. Solids 59:2355"
            }
            Quantity::ThermalConductance | Quantity::ElectricalConductance => {
                "Barber (2003), Proc. R. Soc. A 459:53"
            }
            Quantity::YovanovichConductance
            | Quantity::YovanovichElectricalConductance
            | Quantity::YovanovichConductanceWithGas => "Yovanovich (1982), Prog. Astronaut. Aeronaut. 83:83",
            Quantity::CooperMikicYovanovichConductance => {
                "Cooper, Mikic & Yovanovich (1969), Int. J. Heat Mass Transfer 12:279"
            }
            Quantity::YovanovichGap | Quantity::GasConductance | Quantity::ThermalConductanceWithGas => {
                "Yovanovich (2005), IEEE Trans. Compon. Packag. Technol. 28:182"
            }
            Quantity::ChannelWavelength | Quantity::ChannelHeight | Quantity::TightPressure => {
                "Persson & Yang (2008), J. Phys.: Condens. Matter 20:315011; Dapp & Müser (2016), Sci. Rep. 6:19513"
            }
            Quantity::LeakGap | Quantity::LeakRateLow | Quantity::LeakRateHigh => {
                "Almqvist et al. (2011), J. Mech. Phys. Solids 59:2355; Bruggeman (1935), Ann. Phys. 416:636"
            }
            Quantity::FrictionStress | Quantity::FrictionCoefficient => {
                "Bowden & Tabor (1950), The Friction and Lubrication of Solids, Oxford"
            }
            Quantity::TangentialStiffness
            | Quantity::TangentialDisplacement
            | Quantity::StuckAreaFraction
            | Quantity::TangentialDissipation
            | Quantity::DampingRatio => {
                "Ciavarella (1998), Int. J. Solids Struct. 35:2349; Jäger (1998), Arch. Appl. Mech. 68:332"
            }
            Quantity::FullerTabor => "Fuller & Tabor (1975), Proc. R. Soc. A 345:327",
            Quantity::PastewkaRobbins => "Pastewka & Robbins (2014), Proc. Natl. Acad. Sci. 111:3298",
            Quantity::ThermalResistance | Quantity::ElectricalResistance => return None,
        })
    }
}

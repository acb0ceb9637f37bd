//! Scenes that come with the program, to run or to start one's own from.

/// A scene of the program's own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Template {
    /// A commented scene to fill in, about one's own spectrum.
    New,
    /// UNCD, the measured composite spectrum: every figure of the paper.
    UncdMeasured,
    /// UNCD, the reconstructed spectrum from centimetres to Angstroms: every figure of the paper.
    UncdReconstructed,
    /// A gasket: when it is tight, and what leaks before.
    Gasket,
    /// An electrical contact under a force: its resistance.
    ElectricalContact,
    /// A bolted joint: its stiffness and the heat that crosses it.
    BoltedJoint,
    /// The surface of the Contact-Mechanics Challenge, which others have solved, without adhesion.
    ContactChallenge,
}

units::named!(Template, "scene", {
    New => "new",
    UncdMeasured => "uncd-measured",
    UncdReconstructed => "uncd-reconstructed",
    Gasket => "gasket",
    ElectricalContact => "electrical-contact",
    BoltedJoint => "bolted-joint",
    ContactChallenge => "contact-challenge",
});

impl Template {
    /// The file that [`Template::New`] names in place of one's own.
    pub const PLACEHOLDER: &str = "my_psd.csv";

    /// The scene file.
    pub fn text(self) -> &'static str {
        match self {
            Template::New => data::scenes::NEW,
            Template::UncdMeasured => data::scenes::UNCD_MEASURED,
            Template::UncdReconstructed => data::scenes::UNCD_RECONSTRUCTED,
            Template::Gasket => data::scenes::GASKET,
            Template::ElectricalContact => data::scenes::ELECTRICAL_CONTACT,
            Template::BoltedJoint => data::scenes::BOLTED_JOINT,
            Template::ContactChallenge => data::scenes::CONTACT_CHALLENGE,
        }
    }
}

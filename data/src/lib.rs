#![doc = include_str!("../README.md")]

/// Spectra by name.
pub const SPECTRA: [(&str, &str); 3] = [
    ("builtin:uncd-measured", include_str!("../uncd_psd_measured.csv")),
    ("builtin:uncd-reconstructed", include_str!("../uncd_psd_reconstructed.csv")),
    ("builtin:contact-challenge", include_str!("../contact_challenge.csv")),
];

/// Table of materials, in TOML, with the source of every row.
pub const MATERIALS: &str = include_str!("../materials.toml");

/// Scenes, in TOML.
pub mod scenes {
    /// Scene to begin one's own with.
    pub const NEW: &str = include_str!("../scenes/new.toml");
    /// Diamond, measured spectrum.
    pub const UNCD_MEASURED: &str = include_str!("../scenes/uncd-measured.toml");
    /// Diamond, reconstructed spectrum.
    pub const UNCD_RECONSTRUCTED: &str = include_str!("../scenes/uncd-reconstructed.toml");
    /// Gasket between two flanges.
    pub const GASKET: &str = include_str!("../scenes/gasket.toml");
    /// Silver contact of a relay.
    pub const ELECTRICAL_CONTACT: &str = include_str!("../scenes/electrical-contact.toml");
    /// Bolted joint.
    pub const BOLTED_JOINT: &str = include_str!("../scenes/bolted-joint.toml");
    /// Surface of the Contact-Mechanics Challenge.
    pub const CONTACT_CHALLENGE: &str = include_str!("../scenes/contact-challenge.toml");
}

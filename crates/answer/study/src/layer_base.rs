//! The base that a layer is bonded to, by its name in flags and scenes.

use serde::{Deserialize, Serialize};

/// Base of a layer on the rough body.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LayerBase {
    /// A half-space of the material of the rough body.
    #[default]
    Material,
    /// A body that does not deform; no material is then given for it.
    Rigid,
}

units::named!(LayerBase, "base of a layer", { Material => "material", Rigid => "rigid" });

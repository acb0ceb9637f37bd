//! Boundary condition at the edges of a map.

use serde::{Deserialize, Serialize};
use units::named;

/// Boundary condition at the edges of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Boundary {
    /// The map repeats itself.
    Periodic,
    /// The map is surrounded by a half-space without load.
    Free,
}

named!(Boundary, "boundary", { Periodic => "periodic", Free => "free" });

//! A measured map of a scene, pressed as it was scanned.

use elements::{Boundary, ElementsError, ImposedLoad, Pressing, Relief, Surfaces};
use findings::doubts;
use measurements::PartialMap;
use scans::HeightMap;
use scene::Scene;
use serde::{Deserialize, Serialize};

use crate::{Prepared, PreparedElements};

/// The most points along a side, so that a page answers within a second.
const MOST_POINTS: usize = 256;

/// A map of a scene between the bodies of the scene: all that boundary elements need, so that it can be pressed elsewhere.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MapQuestion {
    /// The name of the measurement.
    pub name: String,
    /// Points of the whole map along x and along y; the relief is its middle.
    pub points_of_whole: [usize; 2],
    /// The heights without their trend.
    pub relief: Relief,
    /// The contact modulus E* \[Pa\].
    pub contact_modulus_pa: f64,
    /// The pressure at which the surface yields \[Pa\], the hardness of the material; elastic throughout if absent.
    pub saturation_pa: Option<f64>,
}

impl MapQuestion {
    /// Takes a map of a scene by its index; `None` if the scene has no such map, or no material, or a layer: measured maps seldom
    /// repeat themselves, which a layer needs.
    #[must_use]
    pub fn from_scene(scene: &Scene, map: usize) -> Option<Self> {
        let patch = scene.surface.maps().get(map)?.middle(MOST_POINTS);
        let material = scene.material.as_ref().filter(|material| material.pair.layer().is_none())?;
        let boundary = if patch.is_periodic { Boundary::Periodic } else { Boundary::Free };
        Some(MapQuestion {
            name: patch.name.clone(),
            points_of_whole: patch.points_of_whole,
            relief: relief(&patch.map, patch.heights_m(), boundary),
            contact_modulus_pa: material.pair.composite_modulus_pa(),
            saturation_pa: material.hardness_pa(),
        })
    }

    /// True if the relief is the whole map.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.points_of_whole == [self.relief.columns, self.relief.rows]
    }

    /// Prepares the map under a nominal pressure \[Pa\].
    ///
    /// # Errors
    /// [`ElementsError`] for a pressure that the surface cannot carry.
    pub fn under(&self, nominal_pressure_pa: f64) -> Result<PreparedElements, ElementsError> {
        let pressing = Pressing {
            loads: vec![ImposedLoad::PressurePa(nominal_pressure_pa)],
            saturation_pa: self.saturation_pa,
            stiffness: true,
            ..Pressing::elastic(self.contact_modulus_pa)
        };
        pressing.check()?;
        let notes = doubts::of_slope(self.relief.rms_slope()).into_iter().collect();
        let surfaces = Surfaces::Maps(vec![self.relief.clone()]);
        Ok(Prepared { surfaces, notes, pressing, hardness_pa: self.saturation_pa })
    }
}

/// Returns a map without its trend as it is pressed; its missing points never touch.
#[must_use]
pub fn relief_of_map(heights: &PartialMap, boundary: Boundary) -> Relief {
    Relief {
        is_missing: heights.is_missing(),
        ..relief(&heights.map, heights.map.heights_m().to_vec(), boundary)
    }
}

/// Returns a map, with heights \[m\] of its own or others in their place, as it is pressed.
#[must_use]
pub fn relief(map: &HeightMap, heights_m: Vec<f64>, boundary: Boundary) -> Relief {
    Relief {
        rows: map.rows(),
        columns: map.columns(),
        length_x_m: map.columns() as f64 * map.spacing_x_m(),
        length_y_m: map.rows() as f64 * map.spacing_y_m(),
        heights_m,
        boundary,
        is_missing: Vec::new(),
    }
}

//! Scene with an uncertain spectrum and an uncertain material, for intervals.

use std::collections::BTreeMap;

use scene::{Overrides, Scene};
use spectrum::ProfilePsd;
use study::NoFiles;

/// Relative standard error of every bin of the spectrum.
const ERROR_OF_A_BIN: f64 = 0.1;
/// Light and heavy loads, and a curve of each kind, elastic and plastic.
pub const LOADS_AND_CURVES: &str = r#"
[loads]
pressures = ["1e-3 H", "1e-1 H"]

[[curve]]
model = "elastic-plastic"
cutoffs = "shortest"

[[curve]]
model = "ep-sphere"
cutoffs = "shortest"

[[curve]]
model = "persson"
cutoffs = "shortest"
"#;
/// Uncertain material.
const MATERIAL: &str = r#"
[material]
youngs_modulus = "463 GPa +- 5 %"
poisson_ratio = 0.2
yield_strength = "10 GPa +- 5 %"
"#;

/// Text of the scene, and its spectrum with standard errors.
#[derive(Debug)]
pub struct SceneFiles {
    /// The scene, which reads [`SceneFiles::PSD`].
    pub scene: String,
    /// The spectrum as a table.
    pub psd: String,
}

impl SceneFiles {
    /// Name of the spectrum's file.
    pub const PSD: &str = "psd.csv";

    /// Adds standard errors to the spectrum of diamond.
    ///
    /// # Errors
    /// A message if the scene cannot be parsed.
    pub fn new() -> Result<Self, String> {
        let certain =
            "surface = { psd = \"builtin:uncd-measured\" }\n".to_owned() + MATERIAL + LOADS_AND_CURVES;
        let certain = Scene::parse(&certain, &NoFiles, &Overrides::default());
        let psd = with_errors(&certain.map_err(|error| error.to_string())?.surface.psd);
        Ok(SceneFiles {
            scene: format!("surface = {{ psd = \"{}\" }}\n{MATERIAL}{LOADS_AND_CURVES}", Self::PSD),
            psd,
        })
    }

    /// Parses the scene.
    ///
    /// # Errors
    /// A message if the scene cannot be parsed.
    pub fn parsed(&self) -> Result<Scene, String> {
        let files = BTreeMap::from([(Self::PSD.to_owned(), self.psd.clone().into_bytes())]);
        Scene::parse(&self.scene, &files, &Overrides::default()).map_err(|error| error.to_string())
    }
}

/// Spectrum as a table with a standard error in every row.
fn with_errors(psd: &ProfilePsd) -> String {
    let rows = psd.wavelengths_m().iter().zip(psd.c1d_m3());
    let row = |(wavelength_m, c1d_m3): (&f64, &f64)| {
        format!("{wavelength_m:e},{c1d_m3:e},{:e}\n", ERROR_OF_A_BIN * c1d_m3)
    };
    "wavelength_m,C1D_m3,C1D_se_m3\n".to_owned() + &rows.map(row).collect::<String>()
}

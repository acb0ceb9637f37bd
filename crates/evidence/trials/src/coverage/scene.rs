//! Scene of a synthetic study, as a user would write it.

use scene::{Overrides, Scene};

use super::instrument::{GAIN_SD, Instrument};
use super::synthetic::SyntheticStudy;
use crate::TrialError;

/// Rest of the scene: steel, light and heavy loads, and a model of each kind.
const REST: &str = r#"
[material]
youngs_modulus = "200 GPa"
poisson_ratio = 0.3
yield_strength = "1.5 GPa"

[loads]
pressures = ["10 MPa", "1 GPa"]

[[curve]]
model = "elastic"
cutoffs = "shortest"

[[curve]]
model = "elastic-plastic"
cutoffs = "shortest"

[[curve]]
model = "hertz"
cutoffs = "shortest"

[[curve]]
model = "ep-sphere"
cutoffs = "shortest"

[[curve]]
model = "elastic-sine"
cutoffs = "shortest"

[[curve]]
model = "ep-sine"
cutoffs = "shortest"

[[curve]]
model = "bgt"
cutoffs = "shortest"

[[curve]]
model = "persson"
cutoffs = "shortest"
"#;

impl SyntheticStudy {
    /// Returns the study as a scene, which states the true uncertainty of the height scales.
    ///
    /// # Errors
    /// [`TrialError::Scene`] if it cannot be read.
    pub fn scene(&self) -> Result<Scene, TrialError> {
        let scan = |file: &String, instrument: &Instrument| {
            let Instrument { name, length_m, shortest_m, .. } = instrument;
            format!(
                "    {{ file = \"{file}\", unit = \"m\", size = \"{length_m:e} m\", shortest_wavelength = \"{shortest_m:e} m\", \
                 instrument = \"{name}\", z_calibration = \"{} %\" }},\n",
                100.0 * GAIN_SD
            )
        };
        let scans: String =
            self.scans.iter().map(|(instrument, request)| scan(&request.path, instrument)).collect();
        let text = format!("title = \"A synthetic study\"\n\n[surface]\nscans = [\n{scans}]\n{REST}");
        Scene::parse(&text, &self.files, &Overrides::default())
            .map_err(|error| TrialError::Scene(error.to_string()))
    }
}

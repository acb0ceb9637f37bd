//! The answer for a surface of roughness parameters states that the spectrum was assumed.

use scene::{Overrides, Scene};
use study::NoFiles;
use units::SceneKeys;

#[test]
fn what_was_assumed_of_a_spectrum_is_told_with_its_numbers() {
    let told = |keys: &str| {
        let text = format!(
            "[surface]\nrms_height = \"0.4 um\"\nrms_slope = 0.15\n{keys}\n[material]\nname = \"steel C45\"\n[loads]\n\
             pressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n"
        );
        let scene = Scene::parse(&text, &NoFiles, &Overrides::default()).unwrap();
        scene.surface.notes[0].words(&SceneKeys)
    };
    assert_eq!(
        told("mean_width = \"80 um\""),
        "this spectrum was made from an rms height Rq of 400 nm and an rms slope Rdq of 0.15, not measured: level from 800 µm (assumed) \
         to the roll-off at 80 µm (the mean width RSm), then a Hurst exponent of 0.8 (assumed) down to 95.4 nm, where it reaches that \
         slope; shorter waves are missing. Its standard errors assume a Hurst exponent known to 0.1 and a roll-off known to a factor of 2"
    );
    let given = told("rolloff_wavelength = \"80 um\"\nhurst = 0.8");
    assert!(given.contains("80 µm (given), then a Hurst exponent of 0.8 (given)"), "{given}");
}

//! A surface of roughness parameters: that it was assumed stands beside its answer.

use report::scan_words;
use scene::{Overrides, Scene};
use study::NoFiles;

#[test]
fn what_was_assumed_of_a_spectrum_is_told_with_its_numbers() {
    let told = |keys: &str| {
        let text = format!(
            "[surface]\nrms_height = \"0.4 um\"\nrms_slope = 0.15\n{keys}\n[material]\nname = \"steel C45\"\n[loads]\n\
             pressures = [\"1 MPa\"]\n[[curve]]\nmodel = \"elastic\"\n"
        );
        let scene = Scene::parse(&text, &NoFiles, &Overrides::default()).unwrap();
        scan_words::note(&scene.surface.notes[0])
    };
    assert_eq!(
        told("mean_width = \"80 um\""),
        "this spectrum was not measured but made from an rms height Rq of 400 nm and an rms slope Rdq of 0.15, both of profiles of an \
         isotropic surface: level from 800 µm (assumed) to the roll-off at 80 µm (for which the mean width RSm is taken), a Hurst \
         exponent of 0.8 (assumed) from there to 95.4 nm, where it ends so as to have that slope; shorter waves are not in it. Its \
         standard errors are those of a Hurst exponent known to 0.1 and a roll-off known to a factor of 2"
    );
    let given = told("rolloff_wavelength = \"80 um\"\nhurst = 0.8");
    assert!(given.contains("80 µm (as given), a Hurst exponent of 0.8 (as given)"), "{given}");
}

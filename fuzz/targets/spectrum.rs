//! A table of a power spectrum, read as it is and with all that a caller can add.
#![no_main]

use spectrum::{Convention, PsdFile, ReadOptions, is_psd, read_psd, series_names};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let _ = (is_psd(bytes), series_names(bytes));
    let told = ReadOptions {
        convention: Some(Convention::C1D),
        x_unit: Some("um".to_owned()),
        psd_unit: Some("um^3".to_owned()),
        ..ReadOptions::default()
    };
    for options in [ReadOptions::default(), told] {
        match read_psd(bytes, &options) {
            Ok(file) => check(&file),
            Err(error) => fuzz::check_message(&error.to_string(), bytes),
        }
    }
});

fn check(PsdFile { psd, .. }: &PsdFile) {
    assert!(psd.len() >= 2 && psd.values().len() == psd.len());
    assert!(psd.wavelengths_m().windows(2).all(|pair| pair[0] > pair[1]));
    assert!(psd.wavelengths_m().iter().chain(psd.values()).all(|value| value.is_finite() && *value > 0.0));
    if let Ok(profile) = psd.profile() {
        assert!(profile.c1d_m3().iter().all(|value| value.is_finite() && *value > 0.0));
    }
}

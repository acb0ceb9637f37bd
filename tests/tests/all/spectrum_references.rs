//! Moments, McCool's parameters and amplitudes along whole spectra against high-precision tables.

use spectrum::random_surfaces::AreaSpectrum;
use spectrum::{
    AmplitudeDefinition, AsperityParameters, Moments, Normalisation, ProfilePsd, ReadOptions, amplitudes,
    cumulative_moments, read_psd,
};
use tests::{Deviations, ReferenceTable, committed_file};

const SPECTRA: [(&str, &str); 3] = [
    ("data/uncd_psd_measured.csv", "uncd_psd_measured"),
    ("data/uncd_psd_reconstructed.csv", "uncd_psd_reconstructed"),
    ("tests/reference/psd_synthetic.csv", "psd_synthetic"),
];

/// One column of a row of moments and asperity parameters.
type Quantity = fn(&(Moments, AsperityParameters)) -> f64;

fn profile(path: &str) -> ProfilePsd {
    let file = std::fs::File::open(committed_file(path)).unwrap();
    read_psd(file, &ReadOptions::default()).unwrap().psd.profile().unwrap()
}

#[test]
fn moments_and_asperity_parameters_agree_at_every_cutoff() {
    for (path, name) in SPECTRA {
        let table = ReferenceTable::committed(&format!("moments_{name}.csv"));
        let rows: Vec<_> = cumulative_moments(&profile(path), Normalisation::Parseval)
            .into_iter()
            .map(|moments| (moments, AsperityParameters::from_moments(&moments).unwrap()))
            .collect();
        assert_eq!(rows.len(), table.len(), "{name}");
        let columns: [(&str, Quantity); 8] = [
            ("m0_m2", |(m, _)| m.m0_m2),
            ("m2", |(m, _)| m.m2),
            ("m4_per_m2", |(m, _)| m.m4_per_m2),
            ("radius_m", |(_, p)| p.radius_m),
            ("density_per_m2", |(_, p)| p.density_per_m2),
            ("sigma_s_m", |(_, p)| p.sigma_s_m),
            ("offset_m", |(_, p)| p.offset_m),
            ("nayak_alpha", |(_, p)| p.nayak_alpha),
        ];
        for (column, of) in columns {
            let mut deviations = Deviations::default();
            for (row, reference) in rows.iter().zip(table.numbers(column)) {
                deviations.note(of(row), reference);
            }
            deviations.assert_within(&format!("{name} {column}"), 1e-14, 1e-12);
        }
    }
}

#[test]
fn both_amplitudes_agree_at_every_scale() {
    for (path, name) in SPECTRA {
        let table = ReferenceTable::committed(&format!("amplitudes_{name}.csv"));
        for (definition, column) in [
            (AmplitudeDefinition::Eq5, "amplitude_eq5_m"),
            (AmplitudeDefinition::Parseval, "amplitude_parseval_m"),
        ] {
            let scales = amplitudes(&profile(path), definition);
            let mut deviations = Deviations::default();
            for (scale, reference) in scales.iter().zip(table.numbers(column)) {
                deviations.note(scale.amplitude_m, reference);
            }
            deviations.assert_within(&format!("{name} {column}"), 1e-14, 1e-12);
        }
    }
}

/// Samples of a spectrum with those beyond its end, one decade of its last slope, as the conversion continues it.
fn continued(psd: &ProfilePsd) -> ProfilePsd {
    let (mut wavelengths_m, mut c1d_m3) = (psd.wavelengths_m().to_vec(), psd.c1d_m3().to_vec());
    let [before, last] = [2, 1].map(|from_end| psd.len() - from_end);
    let slope = (c1d_m3[last] / c1d_m3[before]).ln() / (wavelengths_m[before] / wavelengths_m[last]).ln();
    for step in 1..=10 {
        let factor = 10f64.powf(f64::from(step) / 10.0);
        wavelengths_m.push(psd.shortest_wavelength_m() / factor);
        c1d_m3.push(c1d_m3[last] * factor.powf(slope));
    }
    ProfilePsd::new(wavelengths_m, c1d_m3).unwrap()
}

#[test]
fn profiles_of_the_surface_keep_the_moments_of_the_table() {
    // The synthetic one rises and falls as no surface's does.
    for (path, name) in &SPECTRA[..2] {
        let table = profile(path);
        let surface = AreaSpectrum::from_profile(&continued(&table)).unwrap();
        // Dense samples, because C1D of a surface has a kink at each of the table's.
        let ratio = table.shortest_wavelength_m() / table.longest_wavelength_m();
        let wavelengths_m: Vec<f64> =
            (0..=2000).map(|at| table.longest_wavelength_m() * ratio.powf(f64::from(at) / 2000.0)).collect();
        let [found, given] = [surface.profile(&wavelengths_m).unwrap(), table]
            .map(|psd| *cumulative_moments(&psd, Normalisation::Parseval).last().unwrap());
        let off = [found.m0_m2 / given.m0_m2 - 1.0, found.m2 / given.m2 - 1.0];
        assert!(off.iter().all(|off| off.abs() < 0.01), "{name}: {off:?}");
    }
}

#[test]
fn gradients_of_surfaces_rise_from_sample_to_sample() {
    for (path, name) in &SPECTRA[..2] {
        let table = profile(path);
        let surface = AreaSpectrum::from_profile(&table).unwrap();
        let gradients = surface.mean_square_gradients(table.wavelengths_m());
        // By more than half a hundredth: no flat steps.
        assert!(gradients[0] == 0.0 && gradients[1] > 0.0, "{name}");
        let is_rising = |pair: &[f64]| pair[1] > 1.005 * pair[0];
        assert!(gradients.windows(2).skip(1).all(is_rising), "{name}: {gradients:?}");
        for (wavelength_m, gradient) in table.wavelengths_m().iter().zip(&gradients).skip(1) {
            let cut = surface.cut(table.longest_wavelength_m(), *wavelength_m).unwrap();
            assert!((cut.mean_square_gradient() / gradient - 1.0).abs() < 1e-9, "{name} {wavelength_m}");
        }
    }
}

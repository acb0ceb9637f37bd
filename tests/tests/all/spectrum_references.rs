//! Moments, McCool's parameters and amplitudes along whole spectra against high-precision tables.

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

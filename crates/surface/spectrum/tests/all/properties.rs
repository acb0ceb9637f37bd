//! Properties that hold for every spectrum.

use std::num::NonZeroU32;

use approx::{assert_relative_eq, relative_eq};
use proptest::prelude::*;
use spectrum::{
    AmplitudeDefinition, AsperityParameters, Convention, Normalisation, ProfilePsd, Psd, ReadOptions,
    amplitudes, cumulative_moments, cumulative_moments_to, read_psd,
};

/// Rows of 2 to 40 samples: steps of up to a decade, values between 1e-32 and 1e-18 m^3.
fn rows() -> impl Strategy<Value = Vec<(f64, f64)>> {
    prop::collection::vec((1e-4..1.0, -32.0..-18.0), 2..40).prop_map(|steps| {
        let mut decade = -3.0;
        let row = |(step, log_value): (f64, f64)| {
            decade -= step;
            (10f64.powf(decade), 10f64.powf(log_value))
        };
        steps.into_iter().map(row).collect()
    })
}

fn profile(rows: &[(f64, f64)]) -> ProfilePsd {
    let (wavelengths_m, values) = rows.iter().copied().unzip();
    Psd::new(wavelengths_m, values, Convention::C1D).unwrap().profile().unwrap()
}

proptest! {
    #[test]
    fn moments_and_asperities_scale_with_the_unit_of_length(rows in rows(), log_scale in -3.0..3.0) {
        let scale = 10f64.powf(log_scale);
        let scaled: Vec<_> = rows.iter().map(|(wavelength, value)| (scale * wavelength, scale.powi(3) * value)).collect();
        let original = cumulative_moments(&profile(&rows), Normalisation::Parseval);
        let enlarged = cumulative_moments(&profile(&scaled), Normalisation::Parseval);
        for (original, enlarged) in original.iter().zip(&enlarged) {
            assert_relative_eq!(enlarged.m0_m2, scale * scale * original.m0_m2, max_relative = 1e-11, epsilon = 0.0);
            assert_relative_eq!(enlarged.m2, original.m2, max_relative = 1e-11, epsilon = 0.0);
            assert_relative_eq!(enlarged.m4_per_m2, original.m4_per_m2 / (scale * scale), max_relative = 1e-11, epsilon = 0.0);
            let original = AsperityParameters::from_moments(original).unwrap();
            let enlarged = AsperityParameters::from_moments(enlarged).unwrap();
            assert_relative_eq!(enlarged.radius_m, scale * original.radius_m, max_relative = 1e-11, epsilon = 0.0);
            assert_relative_eq!(enlarged.nayak_alpha, original.nayak_alpha, max_relative = 1e-11, epsilon = 0.0);
        }
    }

    #[test]
    fn moments_grow_with_every_finer_cutoff(rows in rows()) {
        let moments = cumulative_moments(&profile(&rows), Normalisation::Parseval);
        prop_assert_eq!(moments.len(), rows.len() - 1);
        for pair in moments.windows(2) {
            prop_assert!(pair[1].m0_m2 >= pair[0].m0_m2);
            prop_assert!(pair[1].m2 >= pair[0].m2);
            prop_assert!(pair[1].m4_per_m2 >= pair[0].m4_per_m2);
        }
    }

    #[test]
    fn every_spectrum_has_asperities_and_a_nayak_parameter_of_at_least_1(rows in rows()) {
        for moments in cumulative_moments(&profile(&rows), Normalisation::Parseval) {
            let asperities = AsperityParameters::from_moments(&moments).unwrap();
            prop_assert!(asperities.nayak_alpha >= 1.0 - 1e-14);
            prop_assert!(asperities.sigma_s_m < moments.rms_height_m());
        }
    }

    #[test]
    fn a_cutoff_between_samples_is_a_sample_added_there(rows in rows(), fraction in 0.01..0.99) {
        let psd = profile(&rows);
        let (long, short) = (psd.wavelengths_m()[psd.len() - 2], psd.shortest_wavelength_m());
        let cutoff_m = long * (short / long).powf(fraction);
        let to_cutoff = cumulative_moments_to(&psd, Normalisation::Parseval, cutoff_m);
        let mut refined = rows.clone();
        refined.push((cutoff_m, psd.value_at(cutoff_m).unwrap()));
        let refined = cumulative_moments(&profile(&refined), Normalisation::Parseval);
        prop_assert_eq!(&refined[..to_cutoff.len()], &to_cutoff[..]);
        let whole = cumulative_moments(&psd, Normalisation::Parseval);
        prop_assert!(relative_eq!(refined[refined.len() - 1], whole[whole.len() - 1], max_relative = 1e-12));
    }

    #[test]
    fn resampling_keeps_the_ends_the_count_and_the_curve(rows in rows(), scales_per_decade in 1u32..60) {
        let psd = profile(&rows);
        let resampled = psd.resampled(NonZeroU32::new(scales_per_decade).unwrap());
        let decades = (psd.longest_wavelength_m() / psd.shortest_wavelength_m()).log10();
        let points = 1 + (f64::from(scales_per_decade) * decades).round().max(1.0) as usize;
        prop_assert_eq!(resampled.len(), points);
        prop_assert_eq!(resampled.longest_wavelength_m(), psd.longest_wavelength_m());
        prop_assert_eq!(resampled.shortest_wavelength_m(), psd.shortest_wavelength_m());
        prop_assert!(resampled.wavelengths_m().windows(2).all(|pair| pair[0] > pair[1]));
        for (&wavelength_m, &value) in resampled.wavelengths_m().iter().zip(resampled.c1d_m3()) {
            prop_assert_eq!(psd.value_at(wavelength_m), Some(value));
        }
    }

    #[test]
    fn parseval_amplitudes_share_out_the_variance(rows in rows()) {
        let psd = profile(&rows);
        let scales = amplitudes(&psd, AmplitudeDefinition::Parseval);
        let half_sum_m2 = scales.iter().map(|scale| scale.amplitude_m.powi(2)).sum::<f64>() / 2.0;
        let moments = cumulative_moments(&psd, Normalisation::Parseval);
        assert_relative_eq!(half_sum_m2, moments[moments.len() - 1].m0_m2, max_relative = 1e-12, epsilon = 0.0);
    }

    #[test]
    fn the_order_of_the_rows_does_not_matter((rows, shuffled) in rows().prop_flat_map(|rows| (Just(rows.clone()), Just(rows).prop_shuffle()))) {
        prop_assert_eq!(profile(&rows), profile(&shuffled));
    }

    #[test]
    fn numbers_written_to_a_file_are_read_back_exactly(rows in rows()) {
        let mut file = String::from("C1D_m3;lambda_m\n");
        for (wavelength_m, value) in &rows {
            file.push_str(&format!("{value:e};{wavelength_m:e}\n"));
        }
        let read = read_psd(file.as_bytes(), &ReadOptions::default()).unwrap();
        prop_assert_eq!(read.psd.profile().unwrap(), profile(&rows));
        prop_assert!(read.notes.is_empty());
    }

    #[test]
    fn conversions_there_and_back_change_at_most_the_last_digits(rows in rows()) {
        let psd = profile(&rows);
        for convention in [Convention::W1, Convention::Frequency] {
            let there = Psd::new(psd.wavelengths_m().to_vec(), psd.c1d_m3().to_vec(), Convention::C1D).unwrap().to(convention).unwrap();
            prop_assert_eq!(there.convention(), convention);
            for (back, original) in there.profile().unwrap().c1d_m3().iter().zip(psd.c1d_m3()) {
                assert_relative_eq!(*back, *original, max_relative = 4.0 * f64::EPSILON, epsilon = 0.0);
            }
        }
    }

    #[test]
    fn profiles_of_areas_are_positive_and_scale_with_the_unit_of_length(rows in rows(), log_scale in -3.0..3.0) {
        prop_assume!(rows.len() > 2);
        let scale = 10f64.powf(log_scale);
        let area = |scale: f64| {
            let (wavelengths_m, values) = rows.iter().map(|(wavelength, value)| (scale * wavelength, scale.powi(4) * value)).unzip();
            Psd::new(wavelengths_m, values, Convention::Ciso).unwrap().profile().unwrap()
        };
        let (original, enlarged) = (area(1.0), area(scale));
        prop_assert_eq!(original.len(), rows.len());
        for (original, enlarged) in original.c1d_m3().iter().zip(enlarged.c1d_m3()) {
            prop_assert!(*original > 0.0);
            assert_relative_eq!(*enlarged, scale.powi(3) * original, max_relative = 1e-9, epsilon = 0.0);
        }
    }

    #[test]
    fn mangled_files_are_read_or_refused(
        file in prop::sample::select(FILES.to_vec()),
        cuts in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..4),
    ) {
        // Rows, cells and signs are lost or moved.
        let mut characters: Vec<char> = file.chars().collect();
        for (from, to) in cuts {
            let (from, to) = (from.index(characters.len()), to.index(characters.len()));
            let length = from.abs_diff(to) % 12;
            let moved: Vec<char> = characters.drain(from..(from + length).min(characters.len())).collect();
            let to = to.min(characters.len());
            characters.splice(to..to, moved.into_iter().step_by(2));
            if characters.is_empty() {
                break;
            }
        }
        let text: String = characters.into_iter().collect();
        for options in [
            ReadOptions::default(),
            ReadOptions { series: Some("1D PSD along x".into()), x_unit: Some("1/um".into()), psd_unit: Some("um^3".into()), ..ReadOptions::default() },
        ] {
            match read_psd(text.as_bytes(), &options) {
                Ok(read) => prop_assert!(read.psd.values().iter().all(|value| value.is_finite() && *value > 0.0)),
                Err(error) => prop_assert!(!error.to_string().is_empty()),
            }
        }
    }
}

/// A small file of every layout of text.
const FILES: [&str; 7] = [
    "# a\nlambda_m,C1D_m3,C1D_se_m3\n1,2,3\n2,3,4\n",
    "Subject type;Subject name;Data series;Wavevector (1/m);PSD (m³)\nsurface;a;1D PSD along x;1;2\nsurface;a;1D PSD along x;2;\nsurface;b;1D PSD along y;2;3\n",
    "# t: a\n# ====\n#\n# 1D PSD along x\n# ----\n# Columns: Wavevector (1/m), PSD (m³)\n1 2\n2 nan\n\n# y\n# ----\n# Columns: q, PSD (m³)\n1 2\n",
    "{\"name\": \"1D PSD along x\", \"x\": [1, 2, 3], \"y\": [1e-3, null, 4], \"std_err_y\": [1, 2, null]}",
    "PSDF   Fit\nk   W<sub>1</sub>   k   W<sub>1</sub>\n[1/µm]   [µm^3]   [1/µm]   [µm^3]\n0 1   1 2\n2 3   -  -\n",
    "k;W1;\n[1/m];[m^3];\n1;2;\n2;3;\n",
    "# q (1/m)  C (m^4)\n1 2\n2 3\n3 4\n",
];

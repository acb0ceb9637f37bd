//! Transforms against sums by definition. They stand apart from the library, which would be compiled once more for them.

use numerics::transforms::{
    Complex, Complex64, Precision, forward, forward_of_real, inverse, inverse_to_real,
};

/// Numbers without any symmetry.
fn numbers(count: usize) -> Vec<f64> {
    (0..count).map(|i| ((i * i) as f64 * 0.7 + 0.3).sin()).collect()
}

#[test]
fn transforms_are_the_sums_by_definition_for_any_length() {
    for length in [1, 2, 7, 12, 64, 97] {
        let numbers = numbers(length);
        let sum = |wave: usize| -> Complex64 {
            let turn = -std::f64::consts::TAU / length as f64;
            let terms = numbers.iter().enumerate();
            terms.map(|(at, number)| Complex64::cis(turn * (at * wave % length) as f64) * number).sum()
        };
        let mut values: Vec<Complex64> = numbers.iter().map(|number| (*number).into()).collect();
        forward(length).process(&mut values);
        let real = forward_of_real(length);
        let mut waves = real.make_output_vec();
        real.process(&mut numbers.clone(), &mut waves).unwrap();
        for (wave, value) in values.iter().enumerate() {
            assert!((value - sum(wave)).norm() < 1e-13 * length as f64, "{length}, {wave}");
        }
        for (value, wave) in values.iter().zip(&waves) {
            assert!((value - wave).norm() < 1e-13 * length as f64, "{length}");
        }

        inverse(length).process(&mut values);
        let mut back = vec![0.0; length];
        inverse_to_real(length).process(&mut waves, &mut back).unwrap();
        for ((number, value), back) in numbers.iter().zip(&values).zip(&back) {
            let expected = number * length as f64;
            assert!((value.re - expected).abs() < 1e-13 * length as f64, "{length}");
            assert!((back - expected).abs() < 1e-13 * length as f64, "{length}");
        }
    }
}

#[test]
fn single_precision_goes_forth_and_back() {
    let [forth, back] = f32::plan_both_ways(24);
    let numbers = numbers(24);
    let mut values: Vec<Complex<f32>> = numbers.iter().map(|number| (*number as f32).into()).collect();
    forth.process(&mut values);
    back.process(&mut values);
    for (number, value) in numbers.iter().zip(&values) {
        assert!((f64::from(value.re) - 24.0 * number).abs() < 1e-4);
    }
}

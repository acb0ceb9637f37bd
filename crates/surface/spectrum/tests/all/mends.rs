//! Options that a caller can set to mend an error, as data.

use spectrum::{Abscissa, LineProblem, ReadError, ReadMend, ReadOption, ReadOptions, Wanted, read_psd};

fn mend(text: &str, options: &ReadOptions) -> Option<ReadMend> {
    let error = read_psd(text.as_bytes(), options).unwrap_err();
    // The front end knows the names of its options; the reader does not.
    assert!(!error.to_string().contains("--"), "{error}");
    error.mend()
}

fn wanted(option: ReadOption, values: &[&str]) -> Wanted {
    Wanted { option, values: values.iter().map(|value| (*value).to_owned()).collect() }
}

#[test]
fn what_a_file_does_not_tell_is_to_be_given() {
    let conventions = ["c1d", "w1", "frequency", "ciso", "persson"];
    let axes = ["wavelength", "wavevector", "frequency"];
    let unasked = ReadOptions::default();
    let column = ReadOptions { column: Some("Ciso_approx_m4".to_owned()), ..ReadOptions::default() };
    let series = |names: [&str; 2]| {
        let rows = names.map(|name| format!("{name},1,0.006\n{name},2,0.004\n"));
        format!("Subject,Series,Wavevector (1/m),PSD (m\u{b3})\n{}", rows.concat())
    };
    let [subjects, directions, both] = [["a,x", "b,x"], ["a,y", "a,z"], ["a,y", "b,z"]].map(series);
    for (text, options, expected) in [
        (
            "1 2\n2 3\n",
            &unasked,
            vec![wanted(ReadOption::X, &axes), wanted(ReadOption::Convention, &conventions)],
        ),
        ("lambda_m,psd_m3,Ciso_m4\n1,2,3\n2,3,4\n", &unasked, vec![wanted(ReadOption::Column, &[])]),
        ("lambda_m,height_m\n1,2\n2,3\n", &unasked, vec![wanted(ReadOption::Column, &[])]),
        (&subjects, &unasked, vec![wanted(ReadOption::Subject, &[])]),
        (&directions, &unasked, vec![wanted(ReadOption::Series, &[])]),
        (&both, &unasked, vec![wanted(ReadOption::Subject, &[]), wanted(ReadOption::Series, &[])]),
        (
            "{\"name\": \"a\", \"x\": [1, 2],\n \"y\": [2, 3]}",
            &unasked,
            vec![
                wanted(ReadOption::XUnit, &["m", "nm", "1/m", "1/um"]),
                wanted(ReadOption::PsdUnit, &["m^3", "um^3", "nm^3"]),
            ],
        ),
        ("lambda_m,psd_m4\n1,2\n2,3\n", &unasked, vec![wanted(ReadOption::Convention, &["ciso", "persson"])]),
        ("lambda_m,Ciso_approx_m4\n1,2\n2,3\n", &column, vec![wanted(ReadOption::Convention, &conventions)]),
    ] {
        assert_eq!(mend(text, options), Some(ReadMend::Give(expected)), "{text}");
    }
}

#[test]
fn a_unit_that_is_none_is_to_be_corrected_and_one_beside_the_files_own_left_out() {
    let text = "q_rad_per_m,C1D_m3\n1,2\n2,3\n";
    let x = |unit: &str| ReadOptions { x_unit: Some(unit.to_owned()), ..ReadOptions::default() };
    let psd = |unit: &str| ReadOptions { psd_unit: Some(unit.to_owned()), ..ReadOptions::default() };
    assert_eq!(mend(text, &x("furlong")), Some(ReadMend::Correct(ReadOption::XUnit)));
    assert_eq!(mend(text, &psd("um")), Some(ReadMend::Correct(ReadOption::PsdUnit)));
    assert_eq!(mend(text, &x("1/nm")), Some(ReadMend::LeaveOut(ReadOption::XUnit)));
    assert_eq!(mend(text, &psd("um^3")), Some(ReadMend::LeaveOut(ReadOption::PsdUnit)));
}

#[test]
fn what_no_option_mends_has_no_such_mend() {
    for text in ["", "lambda_m,C1D_m3\n1,2\n2\n", "depth,C1D_m3\n1,2\n2,3\n", "lambda_m,C1D_m3\n1,0\n2,3\n"] {
        assert_eq!(mend(text, &ReadOptions::default()), None, "{text}");
    }
}

#[test]
fn a_wavenumber_and_a_bare_wavevector_may_count_cycles() {
    let read = |text: &str, x: Option<Abscissa>| {
        read_psd(text.as_bytes(), &ReadOptions { x, ..ReadOptions::default() })
    };
    let longest_m = |text: &str, x| read(text, x).unwrap().psd.wavelengths_m()[0];
    let tau = std::f64::consts::TAU;
    let open = "wavenumber (1/m),C1D (m^3)\n1,2\n2,1\n";
    let error = read(open, None).unwrap_err();
    assert!(
        matches!(error, ReadError::AtLine { line: 1, problem: LineProblem::AmbiguousWavenumber(_) }),
        "{error}"
    );
    assert_eq!(error.mend(), Some(ReadMend::Give(vec![wanted(ReadOption::X, &["wavevector", "frequency"])])));
    assert_eq!(longest_m(open, Some(Abscissa::Wavevector)), tau);
    assert_eq!(longest_m(open, Some(Abscissa::Frequency)), 1.0);
    assert_eq!(longest_m("wavenumber (rad/m),C1D (m^3)\n1,2\n2,1\n", None), tau);
    assert_eq!(longest_m("wavenumber (1/m),lambda_m,C1D_m3\n1,1,2\n2,0.5,1\n", None), 1.0);
    let bare = "q (1/m),C1D (m^3)\n1,2\n2,1\n";
    assert_eq!(read(bare, None).unwrap().notes.len(), 1);
    assert_eq!(read("q (rad/m),C1D (m^3)\n1,2\n2,1\n", None).unwrap().notes.len(), 0);
    assert_eq!(read(bare, Some(Abscissa::Wavevector)).unwrap().notes.len(), 0);
    assert_eq!(longest_m(bare, Some(Abscissa::Frequency)), 1.0);
    assert_eq!(longest_m("spatial frequency (1/um),C1D (m^3)\n1,2\n2,1\n", None), 1e-6);
}

#[test]
fn a_two_dimensional_spectrum_does_not_tell_its_convention() {
    let read = |text: &str| read_psd(text.as_bytes(), &ReadOptions::default()).unwrap_err();
    let cubic = read("q_rad_per_m,C2D (m^3)\n1,2\n2,1\n");
    assert!(
        matches!(cubic, ReadError::AtLine { line: 1, problem: LineProblem::TwoDimensionalInCubicMetres(_) }),
        "{cubic}"
    );
    assert_eq!(cubic.mend(), Some(ReadMend::Give(vec![wanted(ReadOption::Convention, &["c1d", "w1"])])));
    let quartic = read("q_rad_per_m,C2D (m^4)\n1,2\n2,1\n");
    assert!(matches!(quartic, ReadError::AtLine { line: 1, problem: LineProblem::AmbiguousDensity(_) }));
    let options = ReadOptions { convention: Some(spectrum::Convention::C1D), ..ReadOptions::default() };
    assert!(read_psd(&b"q_rad_per_m,C2D (m^3)\n1,2\n2,1\n"[..], &options).is_ok());
}

#[test]
fn a_file_that_names_no_spectrum_may_hold_heights() {
    let names_none =
        |text: &str| read_psd(text.as_bytes(), &ReadOptions::default()).unwrap_err().names_no_spectrum();
    assert!(names_none("X (mm),Z (um)\n1,2\n2,1\n") && names_none("1 2 3\n2 3 4\n"));
    let is_one =
        |text: &str| read_psd(text.as_bytes(), &ReadOptions::default()).unwrap_err().is_of_a_spectrum();
    for rows in ["1,2\n2,-1", "1,2\n1,1", "1,2\n2,1e-9x", "1,2\n2,3,4"] {
        assert!(is_one(&format!("wavelength_m,PSD_m3\n{rows}\n")), "{rows}");
    }
    assert!(is_one("log10 q,log10 C\n4,-18\n5,-21\n"));
    assert!(!is_one("X (mm),Z (um)\n1,2\n2,1\n") && !is_one("lambda_m,height_m\n1,2\n2,3\n"));
    assert!(!names_none("lambda_m,height_m\n1,2\n2,3\n") && !names_none("a,psd_m3\n1,2\n2,3\n"));
}

//! Notes on a spectrum and the scans that it is made from, in words.

use scans::{Mend, ScanOption};
use spectrum::{HURST_UNCERTAINTY, Hole, ROLLOFF_UNCERTAINTY_FACTOR, RoughnessParameters};
use study::Note;
use study::given_roughness::{GivenRoughness, RollOffFrom};
use study::surface::Surface;
use topography::{
    BandEnd, DIRECTIONS_DIFFER, Derivative, Direction, DirectionRatio, FundamentalMode, Remark,
    SLOPES_DIFFER, SPECTRA_DIFFER, ScanRemark, Severity, TipIndication, TipWords, mixed_units,
    usual_tip_radii_m,
};
use units::display::{length, three_digits};

/// The least relative error that double precision resolves.
const MIN_RELATIVE_ERROR: f64 = 1e-15;
/// The most holes that are named; the others are counted.
const MAX_HOLES_NAMED: usize = 3;
/// The most scans that are named in one sentence; the others are counted.
const MAX_SCANS_NAMED: usize = 3;

/// A note in a sentence, without a full stop.
#[must_use]
pub fn note(note: &Note) -> String {
    match note {
        Note::Reading(text) => text.clone(),
        Note::Reconstruction => "this spectrum is a reconstruction, not the published one".to_owned(),
        Note::Holes(found) => holes(found),
        Note::OfParameters(given) => of_parameters(given),
        Note::Scans(of_scans) => remark(of_scans),
        Note::Superposition { shared_m: Some([longest_m, shortest_m]) } => format!(
            "both surfaces have a spectrum from {} to {}, where the two add; elsewhere one stands alone",
            length(*longest_m),
            length(*shortest_m)
        ),
        Note::Superposition { shared_m: None } => {
            "the two spectra share no wavelength: each stands alone on its own".to_owned()
        }
        Note::OfSurface { name, note } => format!("{name}: {}", self::note(note)),
    }
}

/// A note in a sentence for people who fill in options beside a file and type no command.
#[must_use]
pub fn note_beside_files(note: &Note) -> String {
    match note {
        Note::Scans(Remark::Scan { names, remark: ScanRemark::TipUnknown { shortest_m } }) => {
            let remedy = format!("fill it in beside the file, such as {}", sharp_tip(*shortest_m));
            format!("{}: {}", some(names), tip_unknown(*shortest_m, &remedy))
        }
        Note::OfSurface { name, note } => format!("{name}: {}", note_beside_files(note)),
        _ => self::note(note),
    }
}

/// The note on a spectrum made from roughness parameters: what was given and what was assumed.
fn of_parameters(given: &GivenRoughness) -> String {
    let RoughnessParameters { rms_height_m, rms_slope, rolloff_m, hurst_exponent } =
        given.profile.parameters();
    let rolloff = match given.rolloff_from {
        RollOffFrom::Given => "given",
        RollOffFrom::MeanWidth => "the mean width RSm",
    };
    let hurst = if given.hurst_is_assumed { "assumed" } else { "given" };
    format!(
        "this spectrum was made from an rms height Rq of {} and an rms slope Rdq of {}, not measured: level from {} (assumed) to the \
         roll-off at {} ({rolloff}), then a Hurst exponent of {} ({hurst}) down to {}, where it reaches that slope; shorter waves are \
         missing. Its standard errors assume a Hurst exponent known to {} and a roll-off known to a factor of {}",
        length(rms_height_m),
        three_digits(rms_slope),
        length(given.profile.longest_m()),
        length(rolloff_m),
        three_digits(hurst_exponent),
        length(given.profile.shortest_m()),
        three_digits(HURST_UNCERTAINTY),
        three_digits(ROLLOFF_UNCERTAINTY_FACTOR)
    )
}

/// The notes to read before the answer: warnings, and assumptions on the spectrum itself. Notes on single scans belong to the
/// provenance.
pub(crate) fn foremost(surface: &Surface) -> Vec<String> {
    let is_foremost = |it: &&Note| !matches!(it, Note::Scans(_)) || it.severity() == Severity::Warning;
    surface.notes.iter().filter(is_foremost).map(note).collect()
}

/// A remark in a sentence, without a full stop.
#[must_use]
pub fn remark(remark: &Remark) -> String {
    match remark {
        Remark::Scan { names, remark } => format!("{}: {}", some(names), scan_remark(remark)),
        Remark::SameData { names } => match names.as_slice() {
            [first, second] => format!("{first} and {second} hold the same data; leave one of them out"),
            _ => format!("{} hold the same data; keep one of them", some(names)),
        },
        Remark::Overlap { names: [first, second], ratio, bins, longest_m, shortest_m } => {
            if let Some(units) = mixed_units(*ratio) {
                let factor = three_digits(ratio.max(1.0 / ratio).sqrt());
                return format!(
                    "{first} and {second}: heights differ {factor} times where they overlap; {units} mixed up?"
                );
            }
            let doubt = if remark.severity() == Severity::Warning {
                format!("; they differ by more than {SPECTRA_DIFFER}x: check units, height scales and places")
            } else {
                String::new()
            };
            let shared = match bins {
                1 => format!("in the one bin they share, at {}", length(*longest_m)),
                _ => format!(
                    "in the mean of {bins} shared bins from {} to {}",
                    length(*longest_m),
                    length(*shortest_m)
                ),
            };
            format!("{first} over {second}: {} {shared}{doubt}", three_digits(*ratio))
        }
        Remark::OtherOverlaps { pairs, ratios: [lowest, highest] } => format!(
            "{pairs} more pairs of scans overlap; their spectra have ratios of {} to {}",
            three_digits(*lowest),
            three_digits(*highest)
        ),
        Remark::Directions { names: [along_x, along_y], ratios, fast } => {
            directions([along_x, along_y], ratios, *fast, remark.severity() == Severity::Warning)
        }
        Remark::BiasRemoved { factor, wavelength_m } => format!(
            "the mean of the scans' logarithms is corrected for the bias of few lines and Fourier bins, by up to {} at {}; average \
             \"log\" turns this off",
            three_digits(*factor),
            length(*wavelength_m)
        ),
        Remark::Holes(found) => holes(found),
    }
}

/// Names of scans, at most [`MAX_SCANS_NAMED`] of them: `a, b and c`, or `a, b, c and 2 more`.
fn some(names: &[String]) -> String {
    match names {
        [one] => one.clone(),
        [first @ .., last] if names.len() <= MAX_SCANS_NAMED => format!("{} and {last}", first.join(", ")),
        _ => {
            let (named, others) = names.split_at(MAX_SCANS_NAMED);
            format!("{} and {} more", named.join(", "), others.len())
        }
    }
}

/// The spectra of a map along both of its axes, decade by decade.
fn directions(
    [along_x, along_y]: [&String; 2],
    ratios: &[DirectionRatio],
    fast: Option<Direction>,
    is_doubtful: bool,
) -> String {
    let of_decade = |found: &DirectionRatio| match found.bins {
        1 => format!("{} at {}", three_digits(found.ratio), length(found.longest_m)),
        _ => format!(
            "{} from {} to {}",
            three_digits(found.ratio),
            length(found.longest_m),
            length(found.shortest_m)
        ),
    };
    let of_decades = ratios.iter().map(of_decade).collect::<Vec<_>>().join(", ");
    let scanned = fast.map_or(String::new(), |fast| format!("; {fast} is the fast axis of the scan"));
    let doubt = if is_doubtful {
        format!(
            "; a factor of {DIRECTIONS_DIFFER} or more: the surface has a direction, or its lines are offset against each other"
        )
    } else {
        String::new()
    };
    format!("{along_y} over {along_x}: {of_decades}{scanned}{doubt}")
}

/// Wavelengths that were not measured, in a sentence.
#[must_use]
pub fn holes(holes: &[Hole]) -> String {
    let ends = |hole: &Hole| format!("between {} and {}", length(hole.longest_m), length(hole.shortest_m));
    let named: Vec<String> = holes.iter().take(MAX_HOLES_NAMED).map(ends).collect();
    let more = match holes.len() - named.len() {
        0 => String::new(),
        more => format!(", and in {more} more such holes"),
    };
    format!(
        "nothing was measured {}{more}: the spectrum there is a straight line in logarithms from end to end",
        named.join(" and ")
    )
}

/// The remedy for an error of a scan, in words that follow the error. `name_of` returns the name of an option in the front end,
/// if it has that option.
#[must_use]
pub fn mend(mend: Mend, name_of: impl Fn(ScanOption) -> Option<&'static str>) -> String {
    let (Mend::Give(option) | Mend::LeaveOut(option)) = mend;
    match (mend, name_of(option)) {
        (_, None) => String::new(),
        (Mend::Give(_), Some(name)) => format!("; set it with {name}"),
        (Mend::LeaveOut(_), Some(name)) => format!("; leave out {name}"),
    }
}

fn scan_remark(remark: &ScanRemark) -> String {
    match remark {
        ScanRemark::Reading(text) => text.clone(),
        ScanRemark::Band { longest_m, shortest_m, end } => {
            format!("used from {} down to {} ({})", length(*longest_m), length(*shortest_m), band_end(end))
        }
        ScanRemark::TipUnknown { shortest_m } => {
            let usual = sharp_tip(*shortest_m);
            let typed = usual.replace(' ', "");
            let remedy = format!("write FILE:tip-radius={typed} (scene: tip_radius = \"{usual}\")");
            tip_unknown(*shortest_m, &remedy)
        }
        ScanRemark::TipIndicated(found) => tip_indicated(found),
        ScanRemark::TipWords { words: TipWords { radius_m, text }, is_used: true } => {
            format!("tip radius {} from the metadata ('{text}')", length(*radius_m))
        }
        ScanRemark::TipWords { words: TipWords { radius_m, text }, is_used: false } => format!(
            "the metadata mention a tip radius of {} ('{text}'); tip radius auto uses it",
            length(*radius_m)
        ),
        ScanRemark::NoiseFloor(floor) => format!(
            "the spectrum is level at {} m³ at its short end: noise of the instrument, which sets in at {}; trust only longer \
             wavelengths",
            three_digits(floor.c1d_m3),
            length(floor.wavelength_m)
        ),
        ScanRemark::Variance { share, evenly_spaced: true } => match remark.severity() {
            Severity::Warning => {
                format!("Parseval: the spectrum holds {:.1} % of the variance of the heights", 100.0 * share)
            }
            _ => format!("Parseval: relative error below {:.0e}", bound_of(share - 1.0)),
        },
        ScanRemark::Variance { share, evenly_spaced: false } => format!(
            "the spectrum holds {:.1} % of the variance of the trace, the rest lies below the distance of its points",
            100.0 * share
        ),
        ScanRemark::Gap { over_median } => match remark.severity() {
            Severity::Warning => format!(
                "missing points over {} times the usual spacing are bridged by a straight line",
                three_digits(*over_median)
            ),
            _ => format!(
                "no run of missing points is wider than {} times the usual spacing",
                three_digits(*over_median)
            ),
        },
        ScanRemark::Derivative { derivative, real, spectral, .. } => {
            let (what, unit) = match derivative {
                Derivative::Slope => ("slope", ""),
                Derivative::CurvaturePerM => ("curvature", " 1/m"),
            };
            format!(
                "rms {what} {}{unit} from neighbouring points, {}{unit} from the spectrum ({})",
                three_digits(*real),
                three_digits(*spectral),
                difference(*real, *spectral)
            )
        }
        ScanRemark::Slopes { along, across } => {
            let doubt = if remark.severity() == Severity::Warning {
                format!(
                    "; they differ by {SLOPES_DIFFER}x or more: lines are offset against each other, or the surface has a \
                     direction; the spectrum is that along the lines"
                )
            } else {
                String::new()
            };
            format!(
                "rms slope {} along the lines, {} across them{doubt}",
                three_digits(*along),
                three_digits(*across)
            )
        }
        ScanRemark::Fundamental(mode) => fundamental(mode),
    }
}

/// The limit of a scan whose tip is unknown, and the remedy.
fn tip_unknown(shortest_m: f64, remedy: &str) -> String {
    format!("tip radius unknown, used down to {}; {remedy}", length(shortest_m))
}

/// The radius of a sharp tip of the instrument that resolves a wavelength, as it is typed.
fn sharp_tip(shortest_m: f64) -> String {
    length(usual_tip_radii_m(shortest_m)[0]).replace('µ', "u")
}

/// The limits of a scan made with an unknown tip.
fn tip_indicated(found: &TipIndication) -> String {
    let sharpest = found.sharpest_peak_radius_m.map_or(String::new(), |radius_m| {
        format!(
            "the sharpest peaks have a radius of {}, which the tip does not exceed unless they are noise; ",
            length(radius_m)
        )
    });
    let trusted = found.trusted.iter().map(|trusted| {
        let of_scan = trusted
            .shortest_m
            .map_or("all of it".to_owned(), |shortest_m| format!("down to about {}", length(shortest_m)));
        format!("{of_scan} with a tip of {}", length(trusted.radius_m))
    });
    format!("{sharpest}to be trusted: {}", trusted.collect::<Vec<_>>().join(", "))
}

/// The limit of the band of a scan.
pub(crate) fn band_end(end: &BandEnd) -> String {
    match end {
        BandEnd::PixelsWithoutTip => "2 pixels; no tip radius given".to_owned(),
        BandEnd::Pixels => "2 pixels".to_owned(),
        BandEnd::Tip { radius_m } => format!("tip radius {}", length(*radius_m)),
        BandEnd::Given => "shortest given".to_owned(),
        BandEnd::Resolution => "resolution of the instrument".to_owned(),
    }
}

fn fundamental(mode: &FundamentalMode) -> String {
    match mode {
        FundamentalMode::Absent => "the mode of the full length is absent".to_owned(),
        FundamentalMode::Kept { share, used } => format!(
            "the mode of the full length keeps {:.0} % of its power; bin {}",
            100.0 * share,
            if *used { "used" } else { "not used" }
        ),
        FundamentalMode::MadeByWindow => {
            "the mode of the full length was made by the window alone; bin not used".to_owned()
        }
    }
}

/// The power of ten that a relative error stays below.
fn bound_of(error: f64) -> f64 {
    let power = error.abs().max(MIN_RELATIVE_ERROR).log10().ceil();
    // The logarithm of a power of ten may lie a rounding above it.
    10f64.powi((power - 1e-9) as i32)
}

/// The relative difference of the second value from the first.
fn difference(real: f64, spectral: f64) -> String {
    if real == 0.0 {
        return if spectral == 0.0 { "the same" } else { "none to compare with" }.to_owned();
    }
    format!("{:+.1} %", 100.0 * (spectral / real - 1.0))
}

#[cfg(test)]
mod tests {
    use topography::TrustedDownTo;

    use super::*;

    #[test]
    fn checks_are_worded_as_in_the_field() {
        let of_scan = |remark| scan_remark(&remark);
        assert_eq!(
            of_scan(ScanRemark::Variance { share: 1.0, evenly_spaced: true }),
            "Parseval: relative error below 1e-15"
        );
        assert_eq!(
            of_scan(ScanRemark::Variance { share: 1.0 - 3e-13, evenly_spaced: true }),
            "Parseval: relative error below 1e-12"
        );
        assert_eq!(
            of_scan(ScanRemark::Fundamental(FundamentalMode::Kept { share: 0.85, used: false })),
            "the mode of the full length keeps 85 % of its power; bin not used"
        );
        assert_eq!(
            of_scan(ScanRemark::Band {
                longest_m: 5e-7,
                shortest_m: 3.9e-10,
                end: BandEnd::PixelsWithoutTip
            }),
            "used from 500 nm down to 390 pm (2 pixels; no tip radius given)"
        );
        assert_eq!(
            of_scan(ScanRemark::Derivative {
                derivative: Derivative::Slope,
                real: 0.0,
                spectral: 0.1,
                evenly_spaced: true
            }),
            "rms slope 0 from neighbouring points, 0.1 from the spectrum (none to compare with)"
        );
    }

    #[test]
    fn directions_are_compared_decade_by_decade() {
        let decade = |longest_m: f64, bins, ratio| DirectionRatio {
            longest_m,
            shortest_m: longest_m / 8.0,
            bins,
            ratio,
        };
        let words = |ratio| {
            remark(&Remark::Directions {
                names: ["a, along x".to_owned(), "a, along y".to_owned()],
                ratios: vec![decade(8e-6, 9, 1.1), decade(8e-7, 1, ratio)],
                fast: Some(Direction::X),
            })
        };
        assert_eq!(
            words(3.0),
            "a, along y over a, along x: 1.1 from 8 µm to 1 µm, 3 at 800 nm; x is the fast axis of the scan"
        );
        let anisotropic = Remark::Directions {
            names: ["a, along x".to_owned(), "a, along y".to_owned()],
            ratios: vec![decade(8e-6, 9, 0.5)],
            fast: None,
        };
        assert_eq!(anisotropic.severity(), Severity::Warning);
        assert_eq!(
            remark(&anisotropic),
            "a, along y over a, along x: 0.5 from 8 µm to 1 µm; a factor of 1.5 or more: the surface has a direction, or its \
             lines are offset against each other"
        );
    }

    #[test]
    fn an_unknown_tip_is_described() {
        let words = TipWords { radius_m: 26e-9, text: "Final tip radii - 26 nm".to_owned() };
        assert_eq!(
            scan_remark(&ScanRemark::TipWords { words, is_used: false }),
            "the metadata mention a tip radius of 26 nm ('Final tip radii - 26 nm'); tip radius auto uses it"
        );
        let trusted = |radius_m, shortest_m| TrustedDownTo { radius_m, shortest_m };
        let indicated = TipIndication {
            sharpest_peak_radius_m: Some(12e-9),
            trusted: vec![trusted(5e-9, None), trusted(20e-9, Some(4e-9))],
        };
        assert_eq!(
            scan_remark(&ScanRemark::TipIndicated(indicated)),
            "the sharpest peaks have a radius of 12 nm, which the tip does not exceed unless they are noise; to be trusted: all \
             of it with a tip of 5 nm, down to about 4 nm with a tip of 20 nm"
        );
    }

    #[test]
    fn many_holes_are_counted() {
        let hole = |longest_m: f64| Hole { longest_m, shortest_m: longest_m / 4.0 };
        assert_eq!(
            holes(&[hole(1e-6)]),
            "nothing was measured between 1 µm and 250 nm: the spectrum there is a straight line in logarithms from end to end"
        );
        assert!(holes(&[hole(1e-3); 5]).contains(", and in 2 more such holes: "));
    }
}

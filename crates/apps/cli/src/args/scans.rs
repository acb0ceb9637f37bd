//! Arguments of `scan`, `psd` and `roughness`.

use std::num::NonZeroU32;

use clap::Args as ClapArgs;
use measurements::{Conventions, ScanRequest, TipRadius};
use roughness::FormRemoval;
use scans::LengthUnit;
use topography::{Average, DEFAULT_BINS_PER_DECADE, Detrend, Direction, GapTreatment, Window};
use units::{Length, SignedLength};

use super::parsers::{one_of, parse_count, parse_place};
use crate::failure::Failure;
use crate::picture::Picture;
use crate::place::Place;

/// Files of instruments to look into.
#[derive(Debug, ClapArgs)]
pub(crate) struct ScanArgs {
    /// The files, each perhaps with options of its own: FILE:unit=nm,channel=Height,size=1um
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<ScanRequest>,
    /// Every channel, whatever it measures: amplitude, phase, error, friction as well
    #[arg(long, conflicts_with = "channel")]
    pub all_channels: bool,
    #[command(flatten)]
    pub defaults: FileDefaults,
    /// Draw the heights: maps in colours with their gaps grey, the middle line, the histogram; of several channels, FILE-2, FILE-3 and so on
    #[arg(long, value_name = "FILE.svg|FILE.png")]
    pub figure: Option<Picture>,
}

/// Files of instruments, and the evaluation of their heights.
#[derive(Debug, ClapArgs)]
pub(crate) struct RoughnessArgs {
    /// The files, each perhaps with options of its own: FILE:unit=nm,channel=Height,size=1um
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<ScanRequest>,
    #[command(flatten)]
    pub defaults: FileDefaults,
    /// Form that is subtracted first
    #[arg(long, value_parser = one_of::<FormRemoval, _>(FormRemoval::ALL), default_value_t)]
    pub form: FormRemoval,
    /// Cut-off of the Gaussian filter of ISO 16610 that removes longer waves, such as 0.8mm; half of it is dropped at each
    /// end of a profile
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub filter: Option<Length>,
    /// Cut-off of the Gaussian filter that removes shorter waves, such as 2.5um
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub short_filter: Option<Length>,
    /// Height from the mean at which the material ratio Smr, Rmr is taken
    #[arg(long, value_name = "Z", allow_hyphen_values = true)]
    pub ratio_height: Option<SignedLength>,
    /// Conventions where several are in use: usual, the first of each, or all
    #[arg(long, value_parser = one_of::<Conventions, _>(Conventions::ALL), default_value_t)]
    pub convention: Conventions,
    /// Rms gradient and curvature of all roughness down to each wavelength, from the spectrum and from differences of heights half
    /// the wavelength apart, in place of the parameters
    #[arg(long, conflicts_with_all = ["ratio_height", "convention"])]
    pub scales: bool,
}

/// Values for files that state none of their own.
#[derive(Debug, ClapArgs)]
pub(crate) struct FileDefaults {
    /// Unit of lengths and heights where neither the file nor metadata beside it tell
    #[arg(long, value_name = "UNIT")]
    pub unit: Option<LengthUnit>,
    /// Size along the scan lines where neither the file nor metadata beside it tell
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub size: Option<Length>,
    /// The channel to read, of files that have several
    #[arg(long, value_name = "NAME")]
    pub channel: Option<String>,
}

/// An option for all files, whether it is given, and whether a file has its own.
type ForAll = (&'static str, bool, fn(&ScanRequest) -> bool);

/// Refuses an option for all files where each has its own.
fn refuse_replaced(files: &[ScanRequest], options: &[ForAll]) -> Result<(), Failure> {
    let is_idle = |(_, is_given, has_own): &&ForAll| *is_given && files.iter().all(has_own);
    options.iter().find(is_idle).map_or(Ok(()), |(option, ..)| {
        Err(Failure::Input(format!("{option} has no effect: every file has its own; leave one of them out")))
    })
}

impl FileDefaults {
    /// Returns files with these values wherever they have none of their own.
    pub fn complete_all(&self, files: &[ScanRequest]) -> Result<Vec<ScanRequest>, Failure> {
        let options: [ForAll; 3] = [
            ("--unit", self.unit.is_some(), |file| file.unit.is_some()),
            ("--size", self.size.is_some(), |file| file.size_m.is_some()),
            ("--channel", self.channel.is_some(), |file| file.channel.is_some()),
        ];
        refuse_replaced(files, &options)?;
        Ok(files.iter().map(|file| self.complete(file)).collect())
    }

    fn complete(&self, file: &ScanRequest) -> ScanRequest {
        ScanRequest {
            unit: file.unit.or(self.unit),
            channel: file.channel.clone().or_else(|| self.channel.clone()),
            size_m: file.size_m.or(self.size.map(|size| size.m)),
            ..file.clone()
        }
    }
}

/// Options for missing points of maps, and for the direction of their lines.
#[derive(Debug, ClapArgs)]
pub(crate) struct MapTreatmentArgs {
    /// Treatment of points without a height: harmonic, filled by the smoothest surface through the edges of each gap,
    /// up to 20 % of a scan; lines, left out with their lines or the stretches of them that they interrupt; or refuse
    #[arg(long, value_parser = one_of::<GapTreatment, _>(GapTreatment::ALL))]
    pub gaps: Option<GapTreatment>,
    /// The lines of a map: x, its rows; y, its columns; or both
    #[arg(long, value_parser = one_of::<Direction, _>(Direction::ALL))]
    pub direction: Option<Direction>,
}

impl MapTreatmentArgs {
    /// Returns files with these values wherever they have none of their own.
    pub fn complete_all(&self, files: Vec<ScanRequest>) -> Result<Vec<ScanRequest>, Failure> {
        let options: [ForAll; 2] = [
            ("--gaps", self.gaps.is_some(), |file| file.gaps.is_some()),
            ("--direction", self.direction.is_some(), |file| file.direction.is_some()),
        ];
        refuse_replaced(&files, &options)?;
        let complete = |file: ScanRequest| ScanRequest {
            gaps: file.gaps.or(self.gaps),
            direction: file.direction.or(self.direction),
            ..file
        };
        Ok(files.into_iter().map(complete).collect())
    }
}

/// Scans and how their spectra are made.
#[derive(Debug, ClapArgs)]
pub(crate) struct ScansArgs {
    /// The scans, each perhaps with options of its own:
    /// FILE:unit=nm,channel=Height,size=1um,tip-radius=20nm,shortest=46nm,gaps=lines,direction=y
    #[arg(required_unless_present = "list", value_name = "FILE")]
    pub files: Vec<ScanRequest>,
    /// A table of more scans: columns file, unit, channel, size, tip_radius, shortest, gaps, direction, detrend, all
    /// but file optional; files are relative to it
    #[arg(long, value_name = "PATH", value_parser = parse_place)]
    pub list: Option<Place>,
    /// Trend subtracted from the heights: by default a plane (from lines, a line), from periodic data the mean
    #[arg(long, value_parser = one_of::<Detrend, _>(Detrend::ALL))]
    pub detrend: Option<Detrend>,
    /// The window: by default Hann, for periodic data none
    #[arg(long, value_parser = one_of::<Window, _>(Window::ALL))]
    pub window: Option<Window>,
    /// Average over scans that share a bin
    #[arg(long, value_parser = one_of::<Average, _>(Average::ALL), default_value_t)]
    pub average: Average,
    /// Logarithmic bins per decade of wavevectors
    #[arg(long, value_name = "N", value_parser = parse_count, default_value_t = DEFAULT_BINS_PER_DECADE)]
    pub bins_per_decade: NonZeroU32,
    /// Radius of the tip, for every scan that has no other: wavelengths that it cannot follow are left out; auto takes what a
    /// file or the metadata beside it speak of
    #[arg(long, value_name = "L|auto", allow_hyphen_values = true)]
    pub tip_radius: Option<TipRadius>,
    #[command(flatten)]
    pub defaults: FileDefaults,
    #[command(flatten)]
    pub maps: MapTreatmentArgs,
    /// Destination of the table; the same as --output
    #[arg(long, value_name = "PATH", value_parser = parse_place)]
    pub out: Option<Place>,
    /// Write every scan's spectrum under its name in the column series, whole as NAME (incl. unreliable data), and the
    /// composite last
    #[arg(long)]
    pub per_scan: bool,
    /// Draw the spectra and their composite
    #[arg(long, value_name = "FILE.svg|FILE.png|FILE.pdf")]
    pub figure: Option<Picture>,
    /// The two-dimensional spectrum of one map instead, averaged radially: wavelength_m, wavevector_rad_per_m, Ciso_m4, modes
    #[arg(long, conflicts_with_all = ["per_scan", "figure", "average", "bins_per_decade"])]
    pub areal: bool,
}

impl ScansArgs {
    /// Returns files with these values wherever they have none of their own.
    pub fn with_common_options(&self, files: &[ScanRequest]) -> Result<Vec<ScanRequest>, Failure> {
        let options: [ForAll; 2] = [
            ("--detrend", self.detrend.is_some(), |file| file.detrend.is_some()),
            ("--tip-radius", self.tip_radius.is_some(), |file| file.tip_radius.is_some()),
        ];
        refuse_replaced(files, &options)?;
        self.maps.complete_all(self.defaults.complete_all(files)?)
    }
}

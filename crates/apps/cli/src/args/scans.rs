//! Arguments of `scan`, `psd` and `roughness`.

use std::num::NonZeroU32;

use clap::Args as ClapArgs;
use measurements::{Conventions, ScanRequest, TipRadius};
use roughness::FormRemoval;
use scans::LengthUnit;
use topography::{Average, DEFAULT_BINS_PER_DECADE, Detrend, Direction, GapTreatment, LineAverage, Window};
use units::{Length, Remark, RemarkCode, SignedLength, Spelling};

use super::groups::CounterfaceSurfaceArgs;
use super::parsers::{one_of, parse_count, parse_place};
use crate::failure::Failure;
use crate::flags::{Flags, refuse_first};
use crate::picture::Picture;
use crate::place::Place;
use crate::written::WrittenScan;

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
    /// Write the heights of one channel in m, with their gaps: .gsf (maps, single precision), .x3p, .nc (double precision)
    #[arg(long, value_name = "FILE.gsf|FILE.x3p|FILE.nc", conflicts_with = "all_channels")]
    pub write: Option<WrittenScan>,
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
    /// Unit of heights alone, such as um beside --unit mm
    #[arg(long, value_name = "UNIT")]
    pub height_unit: Option<LengthUnit>,
    /// Size along the scan lines where neither the file nor metadata beside it tell
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub size: Option<Length>,
    /// The channel to read, of files that have several
    #[arg(long, value_name = "NAME")]
    pub channel: Option<String>,
}

/// Refuses an option for all files where each has its own.
pub(crate) fn refuse_replaced(
    files: &[ScanRequest],
    options: impl IntoIterator<Item = (&'static str, bool)>,
) -> Result<(), Failure> {
    let is_own = |option: &str| {
        let own = ScanRequest::OPTIONS.into_iter().find(|(own, _)| Flags.option(own) == Flags.option(option));
        own.is_some_and(|(_, given)| files.iter().all(given))
    };
    let idle = options.into_iter().map(|(option, is_given)| (option, is_given && is_own(option)));
    refuse_first(idle, Remark::new(RemarkCode::EveryFileHasItsOwn))
}

impl FileDefaults {
    /// Returns files with these values wherever they have none of their own.
    pub fn complete_all(&self, files: &[ScanRequest]) -> Result<Vec<ScanRequest>, Failure> {
        let (unit, size) = (self.unit.is_some(), self.size.is_some());
        let (height_unit, channel) = (self.height_unit.is_some(), self.channel.is_some());
        let given = [("unit", unit), ("height_unit", height_unit), ("size", size), ("channel", channel)];
        refuse_replaced(files, given)?;
        Ok(files.iter().map(|file| self.complete(file)).collect())
    }

    /// Returns a file with these values wherever it has none of its own.
    pub fn complete(&self, file: &ScanRequest) -> ScanRequest {
        ScanRequest {
            unit: file.unit.or(self.unit),
            height_unit: file.height_unit.or(self.height_unit),
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
    /// up to 20 % of a scan; lines, left out with their lines or the stretches of them that they interrupt; refuse; or
    /// keep, of maps that are pressed on a flat without them, as two maps are by default
    #[arg(long, value_parser = one_of::<GapTreatment, _>(GapTreatment::ALL))]
    pub gaps: Option<GapTreatment>,
    /// The lines of a map: x, its rows; y, its columns; or both
    #[arg(long, value_parser = one_of::<Direction, _>(Direction::ALL))]
    pub direction: Option<Direction>,
}

impl MapTreatmentArgs {
    /// Returns a file with these values wherever it has none of its own.
    pub fn complete(&self, file: ScanRequest) -> ScanRequest {
        ScanRequest { gaps: file.gaps.or(self.gaps), direction: file.direction.or(self.direction), ..file }
    }
}

/// Scans and how their spectra are made.
#[derive(Debug, ClapArgs)]
pub(crate) struct ScansArgs {
    /// The scans, each perhaps with options of its own:
    /// FILE:unit=nm,channel=Height,size=1um,tip-radius=20nm,shortest=46nm,gaps=lines,direction=y
    #[arg(required_unless_present = "list", value_name = "FILE")]
    pub files: Vec<ScanRequest>,
    /// Add the spectra of two independent faces, a file each: a scan or a spectrum. Without it, all files are scans of one face
    #[arg(long, conflicts_with_all = ["list", "per_scan", "figure", "areal"], conflicts_with_all = CounterfaceSurfaceArgs::OPTIONS)]
    pub sum: bool,
    #[command(flatten)]
    pub other: CounterfaceSurfaceArgs,
    /// A table of more scans: columns file, unit, height_unit, channel, size, tip_radius, shortest, gaps, direction, detrend, all
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
    /// Average over the lines of a map: median is not moved by a few outlying lines
    #[arg(long, value_parser = one_of::<LineAverage, _>(LineAverage::ALL), default_value_t)]
    pub line_average: LineAverage,
    /// Fill spikes as missing points: those over 20 times as far from the points beside as others, if 0.5 % of all or fewer
    #[arg(long)]
    pub remove_spikes: bool,
    /// Logarithmic bins per decade of wavevectors
    #[arg(long, value_name = "N", value_parser = parse_count, default_value_t = DEFAULT_BINS_PER_DECADE)]
    pub bins_per_decade: NonZeroU32,
    /// Radius of the tip, for every scan that has no other: wavelengths that it cannot follow are left out; none if no tip
    /// matters, auto (the default) for what a file or the metadata beside it speak of
    #[arg(long, value_name = "L|auto|none", allow_hyphen_values = true)]
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
    #[arg(long, conflicts_with_all = CounterfaceSurfaceArgs::OPTIONS)]
    pub per_scan: bool,
    /// Draw the spectra and their composite
    #[arg(long, value_name = "FILE.svg|FILE.png|FILE.pdf", conflicts_with_all = CounterfaceSurfaceArgs::OPTIONS)]
    pub figure: Option<Picture>,
    /// The two-dimensional spectrum of one map instead, averaged radially: wavelength_m, wavevector_rad_per_m, Ciso_m4, modes
    #[arg(long, conflicts_with_all = ["per_scan", "figure", "average", "line_average", "remove_spikes", "bins_per_decade"], conflicts_with_all = CounterfaceSurfaceArgs::OPTIONS)]
    pub areal: bool,
}

impl ScansArgs {
    /// Returns files with these values wherever they have none of their own.
    pub fn with_common_options(&self, files: &[ScanRequest]) -> Result<Vec<ScanRequest>, Failure> {
        let (detrend, gaps) = (self.detrend.is_some(), self.maps.gaps.is_some());
        let (direction, radius) = (self.maps.direction.is_some(), self.tip_radius.is_some());
        let options =
            [("detrend", detrend), ("gaps", gaps), ("direction", direction), ("tip_radius", radius)];
        refuse_replaced(files, options)?;
        let files = self.defaults.complete_all(files)?;
        Ok(files.into_iter().map(|file| self.maps.complete(file)).collect())
    }
}

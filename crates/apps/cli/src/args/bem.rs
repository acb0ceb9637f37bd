//! Arguments of `bem`.

use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::Args as ClapArgs;
use elements::{Boundary, RandomChoices, SpecimenCompliance};
use measurements::ScanRequest;
use questions::flow::FlowEdges;
use questions::spots::SpotsInput;
use questions::{BranchChoice, LoadInput, MaterialInput, RandomInput};
use spectrum::random_surfaces::Phases;
use study::measured::Kind;
use topography::Detrend;
use units::{
    Force, ForcePerLength, Length, Pressure, PressureRange, Resistivity, SpecificResistance, WorkOfAdhesion,
};

use super::groups::{BodiesArgs, FigureArg, ReadingArgs};
use super::layer::LayerArgs;
use super::parsers::one_of;
use super::scans::{FileDefaults, MapTreatmentArgs};

/// Options that count no adhesion. clap demands no required option that conflicts with a given one, so that each option of
/// adhesion conflicts with these itself.
const NOT_ADHESIVE: [&str; 14] = [
    "saturation",
    "ball_radius",
    "force",
    "cylinder_radius",
    "force_per_length",
    "fields",
    "patches",
    "flow",
    "flow_edges",
    "spots",
    "resistivity",
    "counterface_resistivity",
    "film_resistance",
    "mean_free_path",
];

/// A surface, how it is pressed, and what is written.
#[derive(Debug, ClapArgs)]
#[command(group = clap::ArgGroup::new("pressed").required(true).multiple(true).args(["pressures", "pressure_ranges", "ball_radius", "cylinder_radius", "pull_off"]))]
pub(crate) struct BemArgs {
    /// A map of heights, perhaps with options of its own (FILE:unit=nm,channel=Height,size=1um), or a power spectrum: a file, `-` for standard input, or
    /// builtin:uncd-measured, builtin:uncd-reconstructed or builtin:contact-challenge
    pub surface: ScanRequest,
    /// Kind of the file, where its content does not tell
    #[arg(long = "as", value_name = "KIND", value_parser = one_of::<Kind, _>(Kind::ALL))]
    pub kind: Option<Kind>,
    #[command(flatten)]
    pub loads: SignedPressureArgs,
    /// The pressure at which the surface flows, an indentation hardness as 3GPa or 1H; elastic throughout where not given
    #[arg(long, value_name = "P", allow_hyphen_values = true)]
    pub saturation: Option<Pressure>,
    /// Radius of a smooth ball that is pressed onto the middle of the surface, whose edges are free; with --force, in place of pressures
    #[arg(long, value_name = "L", requires = "force", allow_hyphen_values = true, conflicts_with_all = ["pressures", "pressure_ranges", "saturation", "per_realisation", "fields", "patches", "boundary"])]
    pub ball_radius: Option<Length>,
    /// Force on the ball, such as 1N
    #[arg(long, value_name = "F", requires = "ball_radius", allow_hyphen_values = true, conflicts_with_all = ["pressures", "pressure_ranges", "cylinder_radius", "force_per_length"])]
    pub force: Option<Force>,
    /// Radius of a smooth cylinder along y that is pressed onto the middle of the surface, which repeats itself; with
    /// --force-per-length, in place of pressures
    #[arg(long, value_name = "L", requires = "force_per_length", allow_hyphen_values = true, conflicts_with_all = ["pressures", "pressure_ranges", "ball_radius", "saturation", "per_realisation", "fields", "patches", "figure", "boundary"])]
    pub cylinder_radius: Option<Length>,
    /// Force per length of the cylinder, such as 10N/mm
    #[arg(long, value_name = "F", requires = "cylinder_radius", allow_hyphen_values = true, conflicts_with_all = ["pressures", "pressure_ranges", "ball_radius"])]
    pub force_per_length: Option<ForcePerLength>,
    /// Work of adhesion w of the two surfaces, such as 50mJ/m^2; pressures may then be negative
    #[arg(long, value_name = "W", requires = "adhesion_range", allow_hyphen_values = true, conflicts_with_all = NOT_ADHESIVE)]
    pub work_of_adhesion: Option<WorkOfAdhesion>,
    /// Range rho of the attraction (w/rho) exp(-gap/rho), such as 2nm
    #[arg(long, value_name = "L", requires = "work_of_adhesion", allow_hyphen_values = true, conflicts_with_all = NOT_ADHESIVE)]
    pub adhesion_range: Option<Length>,
    /// History of the load with adhesion: apart, from first touch (where not given), contact, from full contact, or both
    #[arg(long, value_name = "BRANCH", requires = "work_of_adhesion", conflicts_with_all = NOT_ADHESIVE, value_parser = one_of::<BranchChoice, _>(BranchChoice::ALL))]
    pub branch: Option<BranchChoice>,
    /// Pull the surfaces apart in place of pressing them, and report the largest pull that they bear
    #[arg(long, requires = "work_of_adhesion", conflicts_with_all = ["pressures", "pressure_ranges", "branch", "per_realisation"], conflicts_with_all = NOT_ADHESIVE)]
    pub pull_off: bool,
    /// The largest residual, sum p|g| over sum p h_rms, above 0 and at most 0.1
    #[arg(long, value_name = "T", default_value_t = elements::Pressing::TOLERANCE, allow_hyphen_values = true)]
    pub tolerance: f64,
    /// A row for each surface instead of their mean
    #[arg(long)]
    pub per_realisation: bool,
    /// A folder for pressures and gaps of every surface under every load, as NetCDF and as pictures; made where absent
    #[arg(long, value_name = "DIR")]
    pub fields: Option<PathBuf>,
    /// Solve the flow through the gap along x and along y, with columns flow_factor_x and flow_factor_y; --fields draws it
    #[arg(long, conflicts_with_all = ["ball_radius", "cylinder_radius"])]
    pub flow: bool,
    /// Edges that the flow meets: periodic, where the surface repeats itself in both directions; reservoirs at two edges, the sides
    /// repeat themselves; channel, reservoirs and walls. By default periodic, and channel where edges are free
    #[arg(long, value_name = "KIND", requires = "flow", conflicts_with_all = ["ball_radius", "cylinder_radius"], value_parser = one_of::<FlowEdges, _>(FlowEdges::ALL))]
    pub flow_edges: Option<FlowEdges>,
    /// A file for a table of contact patches, the regions that touch without a break, with area and perimeter of each
    #[arg(long, value_name = "FILE")]
    pub patches: Option<PathBuf>,
    #[command(flatten)]
    pub spots: SpotsArgs,
    #[command(flatten)]
    pub figure: FigureArg,
    #[command(flatten)]
    pub material: BodiesArgs,
    #[command(flatten)]
    pub layer: LayerArgs,
    #[command(flatten)]
    pub map: MapArgs,
    #[command(flatten)]
    pub random: RandomArgs,
    #[command(flatten)]
    pub reading: ReadingArgs,
}

/// Current through the contact.
#[derive(Debug, ClapArgs)]
pub(crate) struct SpotsArgs {
    /// A file for a table of the spots, each with its place, radius and share of the current. The other table then ends with spots,
    /// largest_share, resistance_ohm, resistance_from_stiffness_ohm and resistance_from; --fields draws the spots
    #[arg(long, value_name = "FILE", conflicts_with_all = ["ball_radius", "cylinder_radius"])]
    pub spots: Option<PathBuf>,
    /// Electrical resistivity of the rough body; that of the table of materials where not given
    #[arg(long, value_name = "RHO", requires = "spots", conflicts_with_all = ["ball_radius", "cylinder_radius"], allow_hyphen_values = true)]
    pub resistivity: Option<Resistivity>,
    /// Electrical resistivity of the counterface
    #[arg(long, value_name = "RHO", requires = "spots", conflicts_with_all = ["ball_radius", "cylinder_radius"], allow_hyphen_values = true)]
    pub counterface_resistivity: Option<Resistivity>,
    /// Specific resistance of a film between the bodies, such as an oxide: 1e-12ohm m^2, say
    #[arg(long, value_name = "R", requires = "spots", conflicts_with_all = ["ball_radius", "cylinder_radius"], allow_hyphen_values = true)]
    pub film_resistance: Option<SpecificResistance>,
    /// Mean free path of electrons: spots below it conduct less (Sharvin)
    #[arg(long, value_name = "L", requires = "spots", conflicts_with_all = ["ball_radius", "cylinder_radius"], allow_hyphen_values = true)]
    pub mean_free_path: Option<Length>,
}

/// The loads on elements, which may pull if the surfaces attract each other.
#[derive(Debug, ClapArgs)]
pub(crate) struct SignedPressureArgs {
    /// Nominal pressure; give it several times for several loads. A negative one pulls, with --work-of-adhesion
    #[arg(long = "pressure", value_name = "P", value_parser = LoadInput::parse_signed, allow_hyphen_values = true)]
    pub pressures: Vec<LoadInput>,
    /// COUNT log-spaced pressures from FROM to TO, in addition to any --pressure
    #[arg(long = "pressures", value_name = "FROM:TO:COUNT", allow_hyphen_values = true)]
    pub pressure_ranges: Vec<PressureRange>,
}

/// Options of a map.
#[derive(Debug, ClapArgs)]
#[command(next_help_heading = "Options for maps")]
pub(crate) struct MapArgs {
    /// Surroundings of the map: the map again, or an unloaded half-space; by default as the file says, and free where
    /// it says nothing
    #[arg(long, value_parser = one_of::<Boundary, _>(Boundary::ALL))]
    pub boundary: Option<Boundary>,
    /// Trend subtracted from the heights: by default a plane, from periodic data the mean
    #[arg(long, value_parser = one_of::<Detrend, _>(Detrend::ALL))]
    pub detrend: Option<Detrend>,
    /// Compliance taken out of the stiffness of a map with free edges: none, the approach of its outline as a rigid punch, or the
    /// mean displacement under even pressure on it
    #[arg(long, value_name = "KIND", conflicts_with_all = ["ball_radius", "cylinder_radius", "work_of_adhesion"], value_parser = one_of::<SpecimenCompliance, _>(SpecimenCompliance::ALL))]
    pub compliance: Option<SpecimenCompliance>,
    #[command(flatten)]
    pub defaults: FileDefaults,
    #[command(flatten)]
    pub treatment: MapTreatmentArgs,
}

impl BemArgs {
    /// Conduction of the bodies, as questions take it.
    pub fn spots_input(&self) -> SpotsInput {
        let SpotsArgs { resistivity, counterface_resistivity, film_resistance, mean_free_path, .. } =
            self.spots;
        let given = SpotsInput {
            resistivity_ohm_m: resistivity.map(|resistivity| resistivity.ohm_m),
            counterface_resistivity_ohm_m: counterface_resistivity.map(|resistivity| resistivity.ohm_m),
            film_resistance_ohm_m2: film_resistance.map(|film| film.ohm_m2),
            mean_free_path_m: mean_free_path.map(|path| path.m),
        };
        given.filled_from(self.material.named.material.as_ref(), self.material.named.on.as_ref())
    }

    /// The material as questions take it.
    pub fn material(&self) -> MaterialInput {
        MaterialInput { layer: self.layer.input(), ..self.material.input() }
    }

    /// The option that leaves a strength without use: a pull, or a saturation in pascals where no pressure is in hardnesses.
    pub fn leaves_strength_unused(&self) -> Option<&'static str> {
        let loads = self.loads.pressures.iter().map(|load| &load.pressure);
        let mut all =
            loads.chain(self.loads.pressure_ranges.iter().map(|range| &range.from)).chain(&self.saturation);
        let is_saturated = self.saturation.is_some() && all.all(|pressure| pressure.pascals(None).is_some());
        if self.pull_off { Some("pull_off") } else { is_saturated.then_some("saturation") }
    }
}

impl MapArgs {
    /// The options of maps, and whether each is given.
    pub fn given(&self) -> [(&'static str, bool); 9] {
        [
            ("compliance", self.compliance.is_some()),
            ("boundary", self.boundary.is_some()),
            ("detrend", self.detrend.is_some()),
            ("unit", self.defaults.unit.is_some()),
            ("height_unit", self.defaults.height_unit.is_some()),
            ("size", self.defaults.size.is_some()),
            ("channel", self.defaults.channel.is_some()),
            ("missing_points", self.treatment.gaps.is_some()),
            ("direction", self.treatment.direction.is_some()),
        ]
    }
}

/// A range of counts as the parser of numbers takes it.
fn within(range: &RangeInclusive<u32>) -> RangeInclusive<i64> {
    i64::from(*range.start())..=i64::from(*range.end())
}

/// Options of random surfaces.
#[derive(Debug, ClapArgs)]
#[command(next_help_heading = "Options for spectra")]
pub(crate) struct RandomArgs {
    /// Points along each side of a surface; 512 where not given
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(within(&RandomChoices::POINTS)))]
    pub grid: Option<u32>,
    /// Number of surfaces made of the spectrum; 8 where not given
    #[arg(long, value_name = "R", value_parser = clap::value_parser!(u32).range(within(&RandomChoices::REALISATIONS)))]
    pub realisations: Option<u32>,
    /// The seed of their phases; 1 where not given
    #[arg(long, value_name = "SEED")]
    pub seed: Option<u64>,
    /// The shortest wavelength of the surfaces; that of the spectrum where not given
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub shortest: Option<Length>,
    /// The longest wavelength of the surfaces; where not given, as long as the grid holds with 4 points for the shortest
    /// wavelength and 2 lengths of the longest a side
    #[arg(long, value_name = "L", allow_hyphen_values = true)]
    pub longest: Option<Length>,
    /// Length of a side; where not given, what is left of the grid is shared between points and lengths
    #[arg(long = "box", value_name = "L", allow_hyphen_values = true)]
    pub side: Option<Length>,
    /// Random part of the spectrum: phases alone, or moduli as well
    #[arg(long, value_parser = one_of::<Phases, _>(Phases::ALL))]
    pub phases: Option<Phases>,
}

impl RandomArgs {
    /// Random surfaces as questions take them.
    pub fn input(&self) -> RandomInput {
        let metres = |length: Option<Length>| length.map(|length| length.m);
        RandomInput {
            grid: self.grid.map(|points| points as usize),
            realisations: self.realisations.map(|count| count as usize),
            seed: self.seed,
            longest_m: metres(self.longest),
            shortest_m: metres(self.shortest),
            side_m: metres(self.side),
            phases: self.phases,
        }
    }
}

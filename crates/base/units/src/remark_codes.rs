//! The table of remarks: public code, usual weight and words of every kind. [`Remark::words`](crate::Remark::words) fills in values,
//! and options as the front end spells them.

/// Weight of a remark for whoever relies on the result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum RemarkLevel {
    /// A passed check, for the record.
    Passed,
    /// An assumption, an omission or a finding.
    Note,
    /// A doubt that changes what to conclude from the result.
    Caution,
    /// Part of the result is missing because its input is bad.
    Error,
}

crate::named!(RemarkLevel, "level", {
    Passed => "passed", Note => "note", Caution => "caution", Error => "error",
});

/// Makes the kinds of remarks from rows of variant, public code, weight, words and, after `short`, the words for one line with
/// others.
macro_rules! remark_codes {
    ($($variant:ident $name:literal $level:ident $words:literal $(short $short:literal)?;)+) => {
        /// The kind of a remark.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum RemarkCode {
            $(#[doc = concat!("Worded as `", $words, "`.")] $variant,)+
        }

        impl RemarkCode {
            /// All kinds.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// Returns the public code; wordings of one fact share it.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name),+ }
            }

            /// Returns the usual weight.
            #[must_use]
            pub const fn level(self) -> RemarkLevel {
                match self { $(Self::$variant => RemarkLevel::$level),+ }
            }

            /// Returns true if a remark is about single scans or about their composite.
            #[must_use]
            pub fn is_about_scans(self) -> bool {
                self.name().starts_with("surface.scans")
            }

            /// Returns true if a remark names an option, a key or a column without effect.
            #[must_use]
            pub fn is_on_idle_input(self) -> bool {
                let first = ["scene-note", "unused-column", "surface.scans.idle-option", "surface.scans.same-data", "surface.scans.scan.spike", "surface.scans.scan.steep", "surface.scans.scan.long"];
                first.contains(&self.name())
            }

            pub(crate) const fn words(self) -> &'static str {
                match self { $(Self::$variant => $words),+ }
            }

            pub(crate) const fn short_words(self) -> &'static str {
                match self { $(Self::$variant => concat!($($short)?)),+ }
            }
        }
    };
}

remark_codes! {
    // The spectrum of a surface.
    Reading "surface.reading" Note "{text}";
    Reconstruction "surface.reconstruction" Note "this spectrum is a reconstruction, not the published one";
    Holes "surface.holes" Caution
        "nothing was measured {holes}: the spectrum there is a straight line in logarithms from end to end";
    OfParameters "surface.of-parameters.given-roughness" Caution
        "this spectrum was made from an rms height Rq of {rms_height_m} and an rms slope Rdq of {rms_slope}, not measured: level from \
         {longest_m} (assumed) to the roll-off at {rolloff_m} ({rolloff}), then a Hurst exponent of {hurst_exponent} ({hurst}) down to \
         {shortest_m}, where it reaches that slope; shorter waves are missing. Its standard errors assume a Hurst exponent known to \
         {hurst_uncertainty} and a roll-off known to a factor of {rolloff_factor}";
    Superposition "surface.superposition" Note
        "both surfaces have a spectrum from {longest_m} to {shortest_m}, where the two add; elsewhere only one of them has";
    NothingShared "surface.superposition" Note
        "the two spectra share no wavelength, so that they add nowhere";

    // The spectra of scans.
    ScanReading "surface.scans.scan" Note "{files}: {text}";
    ScanOptionIgnored "surface.scans.idle-option" Note "{files}: {text}";
    Band "surface.scans.scan" Passed "{files}: used from {longest_m} down to {shortest_m} ({end})";
    TipUnknown "surface.scans.scan.tip-unknown" Caution
        "{files}: tip radius unknown, used down to {shortest_m}; {scan:tip_radius=@sharp_tip}, or none if no tip matters";
    TipIndicated "surface.scans.scan.tip-indication" Note
        "{files}: [the sharpest peaks have a radius of {sharpest_peak_radius_m}, which the tip does not exceed unless they are noise; ]to \
         be trusted: {trusted}";
    TipFromText "surface.scans.scan.tip-in-text" Note "{files}: tip radius {radius_m} from the metadata ('{text}')";
    NoiseFloor "surface.scans.scan.noise-floor" Caution
        "{files}: the spectrum is level at {c1d_m3} m³ at its short end: noise of the instrument, which sets in at {wavelength_m}; trust \
         only longer wavelengths";
    ParsevalHolds "surface.scans.scan" Passed "{files}: Parseval: relative error below {bound}";
    ParsevalFails "surface.scans.scan.parseval" Caution
        "{files}: Parseval: the spectrum holds {share%} of the variance of the heights";
    VarianceOfTrace "surface.scans.scan.parseval" Caution
        "{files}: the spectrum holds {share%} of the variance of the trace, the rest lies below the distance of its points";
    WideGap "surface.scans.scan.gaps" Caution
        "{files}: missing points over {over_median} times the usual spacing are bridged by a straight line";
    NarrowGaps "surface.scans.scan.gaps" Passed
        "{files}: no run of missing points is wider than {over_median} times the usual spacing";
    SlopesCompared "surface.scans.scan.slopes" Caution
        "{files}: rms slope {real} from neighbouring points, {spectral} from the spectrum ({difference})";
    CurvaturesCompared "surface.scans.scan.curvatures" Caution
        "{files}: rms curvature {real} 1/m from neighbouring points, {spectral} 1/m from the spectrum ({difference})";
    Spike "surface.scans.scan.spike" Caution
        "[{files}: ]a height of {height_m}[ in row {row}][ at point {point}] lies {times} times as far off as others do: if it is an error, write \
         nan in its place"
        short "{files}: one point lies {times} times as far off as others do";
    ScanSteep "surface.scans.scan.steep" Caution
        "[{files}: ]rms slope {slope}, which no surface has that an instrument follows: check the units of lengths and of heights, and the size"
        short "{files}: rms slope {slope}: are the units right?";
    ScanLong "surface.scans.scan.long" Caution
        "[{files}: ]{length_m} long, which few scans are: check the unit of lengths, and the size"
        short "{files}: {length_m} long: is the unit right?";
    SlopesAlike "surface.scans.scan.lines" Passed "{files}: rms slope {along} along the lines, {across} across them";
    SlopesDiffer "surface.scans.scan.lines" Caution
        "{files}: rms slope {along} along the lines, {across} across them; they differ by {bound}x or more: lines are offset against each \
         other, or the surface has a direction; the spectrum is that along the lines";
    NarrowLine "surface.scans.scan.line" Caution
        "{files}: waves of {wavelength_m} carry {share%} of the variance[, at {angle}° to the rows]: turned or milled? leaks and gaps \
         depend on their direction"
        short "{files}: waves of {wavelength_m} carry {share%} of the variance";
    TraceSkewed "surface.scans.scan.skewness" Note "{files}: heights are not Gaussian, Rsk {skewness}";
    ModelsGet "surface.scans.kept" Caution
        "in their bands models get {height%} of the rms height of the scans and {slope%} of their rms slope from neighbouring points[; waves \
         of two to four points decide: is {shortest_m} real?]";
    FundamentalAbsent "surface.scans.scan.absent" Passed "{files}: the mode of the full length is absent";
    FundamentalKept "surface.scans.scan.kept" Passed
        "{files}: the mode of the full length keeps {share%} of its power; bin {used}";
    FundamentalOfWindow "surface.scans.scan.made-by-window" Passed
        "{files}: the mode of the full length was made by the window alone; bin not used";
    SameData "surface.scans.same-data" Caution "{files} hold the same data; keep one of them";
    Overlap "surface.scans.overlap" Note
        "{first} over {second}: {ratio} in the [one bin they share, at {wavelength_m}][mean of {bins} shared bins from {longest_m} to \
         {shortest_m}]";
    OverlapDiffers "surface.scans.overlap" Caution
        "{first} over {second}: {ratio} in the [one bin they share, at {wavelength_m}][mean of {bins} shared bins from {longest_m} to \
         {shortest_m}]; they differ by more than {bound}x: check units, height scales and places; two faces? \
         give one as {--counterface_surface}";
    MixedUnits "surface.scans.overlap" Caution
        "{first} and {second}: heights differ {factor} times where they overlap; {units} mixed up?";
    OtherOverlaps "surface.scans.other-overlaps" Note
        "{pairs} more pairs of overlapping scans were compared; their spectra have ratios of {lowest} to {highest}";
    Directions "surface.scans.directions" Note
        "{second} over {first}: {ratios}[; {fast} is the fast axis of the scan]";
    DirectionsDiffer "surface.scans.directions" Caution
        "{second} over {first}: {ratios}[; {fast} is the fast axis of the scan]; a factor of {bound} or more: the surface has a direction, or \
         its lines are offset against each other";
    BiasRemoved "surface.scans.bias-removed" Note
        "the mean of the scans' logarithms is corrected for the bias of few lines and Fourier bins, by up to {factor} at {wavelength_m}; \
         average \"log\" turns this off";
    ScanHoles "surface.scans.holes" Caution
        "nothing was measured {holes}: the spectrum there is a straight line in logarithms from end to end";

    // Values that are physically implausible.
    UnevenSpacing "doubt.uneven-spacing" Note "points are {x_m} apart along x and {y_m} along y";
    SteepSurface "doubt.steep-surface" Caution
        "the rms slope of the surface is {rms_slope}, above 1: check the units of heights and lengths";
    FarTooSteepSurface "doubt.steep-surface" Caution
        "the rms slope of the surface is {rms_slope}, 1000 times too high: nm and µm mixed up, or positions in mm? Then write unit=mm,height-unit=um behind the file";
    SteepScale "doubt.steep-scale" Caution
        "the scale at {wavelength_m} is {aspect_ratio} times as high as it is long: check the units of heights and lengths";
    StrongerThanSolids "doubt.stronger-than-solids" Caution
        "the yield strength {yield_strength_pa} exceeds E/10 = {bound_pa}, about the most that a solid bears: check the prefixes of both, as MPa and GPa";
    SofterThanItsRatio "doubt.softer-than-its-ratio" Caution
        "E = {youngs_modulus_pa} is unusually soft for Poisson's ratio {poisson_ratio}; did you mean {probable_pa}?";
    BodyThatFlows "body-that-flows" Note "{flows}";
    NominalAboveHardness "doubt.nominal-above-hardness" Caution
        "the load {load} is {in_hardnesses} times the hardness H = {hardness_pa}: the body yields as a whole[ (and {others|more load})]";
    RealAboveHardness "doubt.real-above-hardness" Caution
        "the real pressure of {curve} at {load} is {in_hardnesses} H, above the hardness H = {hardness_pa}[ (and of {other_curves|more \
         curve})][: the contact yields, and more touches than {elastic}][; use {@model}][; add {--saturation=@saturation}]";
    RealAboveThirdModulus "doubt.real-above-third-modulus" Caution
        "the real pressure of {curve} at {load} is {pressure_pa}, above E*/3 = {bound_pa}: beyond linear elasticity[ (and of \
         {other_curves|more curve})]";

    // Models and their rows.
    AssumedStrength "assumed-strength" Note
        "yield strength not given: S0 = H/3 = {yield_strength_pa} is used";
    ModulusOfLayer "modulus-of-layer" Note
        "the layer counts by its modulus at each wavelength: boundary elements (bem) find 0.75 to 1.2 times the areas, beside those on \
         half-spaces, and 0.9 to 1.2 times the gaps"
        short "areas of a layer hold to 25 %";
    ThinLayer "thin-layer" Caution
        "the layer is thin: its modulus goes with the wavenumber to the power {exponent}, and boundary elements (bem) find up to 1.6 times \
         the areas at -0.5, 2.3 times at -1 (a bed of springs; 8 times under light loads), and 25 times at -3"
        short "areas of a layer this thin are 1.1 to 25 times too small";
    ToleranceTooFine "tolerance-too-fine" Note
        "{option} of {asked#} is finer than double precision reaches: {used#} is used";
    Sampling "sampling.sampled-scales" Note
        "{scales} scales from {longest_m} to {shortest_m}[, {per_decade} per decade]; the area depends on how densely scales are sampled \
         ({--scales_per_decade})"
        short "{scales} scales from {longest_m} to {shortest_m}[, {per_decade} per decade]";
    FirstRowIsEmpty "first-row-is-empty" Note
        "the longest wavelength has no asperities yet: its row is empty";
    NarrowSpectra "counts.curve-counts" Note
        "{narrow} of {all|row}: alpha = m0 m4/m2^2 is {alphas}, below the 1.5 that every surface reaches: no summits, no result";
    IncompleteStates "counts.curve-counts" Note
        "{states} of {all|state}: beyond complete contact of every asperity, area fraction 1, no separation";
    FlattenedStates "counts.curve-counts" Note
        "{states} of {all|state}: more load than all asperities carry once flattened: the area is that of all of them, the real one is \
         at least as large; no separation";
    FlattenedAsperities "counts.curve-counts" Note
        "up to {share%} of the touching asperities are flattened: their area and force are held";
    ClampedStates "counts.curve-counts" Note
        "{states} of {all|state}: more contact area than there is nominal area, held at an area fraction of 1";
    StatesOutOfRange "counts.curve-counts" Note
        "{states} of {all|state}: most of the load on asperities outside the fitted range of their law";
    LevelsOutOfRange "counts.curve-counts" Note
        "{levels} of {all|level}: B/B_c above {bound}, beyond the range of the elastic-plastic sinusoid";
    FlowingLoads "counts.curve-counts" Note
        "{loads|load}: the nominal pressure is not below the hardness; everything touches and flows, at every cutoff";
    SteepCutoffs "counts.curve-counts" Note
        "{steep} of {all|cutoff}, from {longest_steep_m} down: the rms gradient h' exceeds {bound} (up to {steepest}) and with it s = E* \
         h'/2 exceeds E*/10; the theory assumes small slopes";
    BeyondCompleteContact "rows.beyond-complete-contact" Note
        "{row}: {pressure_pa#} Pa is beyond complete contact of every asperity: area fraction 1, no separation; pressures below \
         {highest_pressure_pa#} Pa have one";
    BeyondFlattened "rows.beyond-flattened" Note
        "{row}: {pressure_pa#} Pa is more than all asperities carry once flattened, {highest_pressure_pa#} Pa: the area is that of all \
         of them, the real one is at least as large; no separation";
    RowsWithoutAsperities "rows.without-asperities" Note
        "{rows} of {all} rows have no asperities: their results are empty";
    BadRows "rows.bad" Error
        "{rows} of {all} rows have input that is missing or out of bounds: their results are NaN";
    AssumedStrengths "rows.assumed-strengths" Note
        "{rows} of {all} rows have a hardness and no yield strength: S0 = H/3 is used";
    RowsAboveHardness "doubt.real-above-hardness" Caution
        "{rows} of {all} rows of elastic models have a real pressure above the hardness: the contact yields, and more touches than they say";
    FlowingRows "rows.flowing-everywhere" Note
        "{rows} of {all} rows: the pressure is not below the hardness; everything touches and flows";
    RowsOutOfRange "rows.beyond-range" Note "{rows} of {all} rows lie beyond {range}";
    FittedRange "correction" Note
        "{correction} is fitted to boundary elements for alpha = m0 m4/m2^2 from {least} to {most}";
    OutsideFit "correction.outside-fit" Note
        "alpha is outside that range at {cutoffs} of {all} cutoffs between {first_m} and {last_m}: {first_alpha} to {last_alpha}";
    NoRollOff "no-roll-off" Note
        "the first decade of wavevectors makes {share_of_first_decade%} of the mean gap, and the spectrum has no roll-off there: gap and \
         stiffness depend on longer wavelengths, which are missing";
    FewTouchBelow "few-touch-below" Note
        "below {limit_pa} the mean gap exceeds {few_touch} rms heights: only a few asperities of a finite sample touch";
    WavesOfProfiles "waves-of-profiles" Note
        "gap and stiffness use the waves of profiles, which makes the stiffness of a surface with a roll-off 17 to 51 % lower than \
         boundary elements give; use {--band=2d} for the waves of the surface";
    LightLoads "light-loads" Note
        "below {up_to_pa} the logarithmic law u = u0 ln(p00/p), K = p/u0 is within {share%} of the pressure of the theory without the tail \
         of the heights";
    BeyondExponentialLaw "beyond-exponential-law" Caution
        "the exponential law is within {share%} up to {up_to_pa}, and {--pressure_range} goes to {to_pa}; use a table, or give a larger \
         {--error}";
    BeyondLightLoads "beyond-light-loads" Note
        "more than {area%} of the area touches: asperities push each other down, which this model ignores; boundary elements find gaps of \
         another size and 0.5 to 12 times its stiffness; use {--model=persson}";
    FewTouch "gaps.gap-counts" Note
        "at {loads} of {all} loads the mean gap exceeds {few_touch} rms heights: only a few asperities of a finite sample touch";
    NegativeGaps "gaps.gap-counts" Note
        "at {loads} of {all} loads the mean gap is negative: the model ignores that asperities push their neighbours down";
    MissingGaps "gaps.gap-counts" Note
        "at {loads} of {all} loads there is no mean gap: contact is complete, all of it flows or all spheres are flattened, or more than 3 % \
         flows on a layer or at a hardness that grows";
    NotGaussianMoments "not-gaussian" Note
        "nayak_alpha lies below 1.5 (down to {least_alpha#}) at [the cutoff {wavelength_m}][{cutoffs} cutoffs between {longest_m} and \
         {shortest_m}]: no Gaussian isotropic surface has such moments, for which the asperity parameters are derived";
    PurePowerLaw "pure-power-law" Note "no roll-off can be identified: the fit is a pure power law";
    HurstOutOfRange "hurst-out-of-range" Note
        "the Hurst exponent {hurst_exponent#} lies outside 0 to 1: the surface is not self-affine";

    // Boundary elements.
    RandomSurfaces "random-surfaces.made-surfaces" Note
        "{surfaces|surface} of {points} x {points} points over {side_m}, with waves from {longest_m} to {shortest_m}: {points_per_shortest} \
         points for the shortest, {lengths} lengths of the longest";
    RandomGradient "random-surfaces.made-surfaces" Note
        "each surface has the rms gradient of the band, h' = {gradient}, so that E* h' = {reduced_modulus_pa}";
    WavesLeftOut "random-surfaces.made-surfaces" Note
        "waves of the spectrum {where} are left out";
    SpectrumLevelled "spectrum.levelled" Note
        "the spectrum of profiles rises where that of no isotropic surface does; for the surface it was levelled there, which moves \
         {share%} of its roughness and keeps height and slope";
    SpectrumEnd "spectrum.end" Note
        "the end of the spectrum of profiles holds waves beyond it, known from its last slope alone: the rms gradient of the surface \
         is uncertain by {error%}";
    SteepWaves "random-surfaces.made-surfaces" Note
        "doubtful: these slopes take {pressure_over_modulus} E* to flatten, and a linear-elastic half-space needs small slopes (up to {bound} \
         E*)";
    FacingMaps "facing-maps" Note "{other} faces {own}: it is turned over (x to -x) and added[; {differ}]";
    FacingSizesApart "facing-maps" Caution
        "{larger} is {ratio} times as large as {smaller}: check unit and size of both";
    FacesFit "facing-maps" Caution
        "the faces fit into each other: the sum of their heights is {share} times as steep as if they did not, and spectra add as if they \
         did not; trust the pressed map";
    MissingPointsOpen "pressed" Note
        "missing points never touch: {outside} lie outside the specimen, {holes} in holes of it, which count as its area; nominal pressure and \
         area fractions are over the specimen, {share%} of {length_x_m} x {length_y_m}";
    StiffnessOfPunch "pressed" Note
        "the edges are free: stiffness_pa_per_m is that of the map and of the half-space around it, as of a punch as large as the map; \
         {--compliance=punch} takes the punch out, {--compliance=even} the mean displacement under even pressure";
    StiffnessWithoutPunch "pressed" Note
        "stiffness_pa_per_m is without the specimen's own compliance as a rigid punch, {compliance_m_per_pa} m/Pa";
    StiffnessWithoutEven "pressed" Note
        "stiffness_pa_per_m is without the specimen's own compliance under even pressure, {compliance_m_per_pa} m/Pa";
    NoStiffnessLeft "pressed" Note
        "at {loads} stiffness_pa_per_m is empty: the whole contact is no more compliant than the specimen's own compliance";
    Unloading "pressed" Caution
        "a load follows a larger one: each presses the surface as it was before it yielded, so this is no unloading; for that press \
         heights + min(gap, 0) of {--fields} without {--saturation}";
    CoarseForSpots "pressed" Note
        "at {loads} the grid is too coarse for the contact spots, and the area is not extrapolated to finer grids; use more points for the \
         shortest wavelength";
    RoundedResidual "pressed" Note "at {loads} rounding kept the residual above the tolerance";
    ClosedPaths "pressed" Note "contact closes the paths from edge to edge: {paths}";
    FlowPaths "pressed.flow" Note "paths of the flow: {paths}";
    FlowInChannel "pressed.flow" Note
        "the edges are free: fluid flows from edge to edge, and the other two edges are walls; {--flow_edges=reservoirs} opens the sides \
         to each other, {--flow_edges=periodic} takes the map to repeat itself";
    GapTakenPeriodic "flow.edges" Note
        "nothing says that the gap repeats itself: it is taken to, in both directions; {--edges=channel} lets fluid flow from edge to edge \
         between walls";
    GapInChannel "flow.edges" Note
        "the map that was pressed has free edges: fluid flows from edge to edge between walls; {--edges=periodic} takes the gap to repeat \
         itself";
    ClosedGaps "flow.closed" Note
        "the gap is closed at {closed} of {points|point}[, at {missing} of them because they are missing][, at {tiny} because it is below 1e-5 of the mean \
         gap]";
    Spots "pressed.spots" Note
        "{spots|spot} on {area%} of the area; the largest share of the current through one is {share%}";
    SpotsOutOfRange "pressed.spots" Note
        "{out} of {contacts|contact}: resistance_ohm is that from the stiffness, since the spots lie too close for discs";
    SpotsUnsolved "pressed.spots" Note "{reason}";
    CurrentSpreads "pressed.spots" Note
        "the edges are free: resistance_ohm has the spreading of the current from the map as a whole into both bodies; {--boundary=periodic} \
         leaves it out";
    GapsBelowZero "flow.negative" Caution
        "{negative} of {points} points are below 0 and count as contact: a gap is at least 0, so these may be heights";
    BallCoarseGrid "ball.coarse-grid" Note
        "Hertz's radius has {points_per_radius} points of the grid, and 8 are needed for an answer";
    BallNarrowMap "ball.narrow-map" Note
        "the map is {radii_across_map} of Hertz's radii wide; below 4 its edges carry load";
    BallLargeContact "ball.large-contact" Note
        "Hertz's radius is {radius_share} of the radius of the ball; from 0.1 on a ball is not a parabola";
    CylinderCoarseGrid "cylinder.coarse-grid" Note
        "Hertz's half-width has {points_per_radius} points of the grid, and 8 are needed for an answer";
    CylinderNarrowBox "cylinder.narrow-box" Note
        "the surface is {radii_across_map} of Hertz's half-widths wide; its images raise the pressure of a smooth cylinder by \
         {pressure_excess%}";
    CylinderLargeContact "cylinder.large-contact" Note
        "Hertz's half-width is {radius_share} of the radius of the cylinder; from 0.1 on a cylinder is not a parabola";
    RepeatedMap "repeated-map" Note
        "the map is taken to repeat itself along and across the cylinder; steps where its ends meet carry load";
    OnePlace "one-place" Note
        "one place decides little: its summits may carry half as much again as others; press several surfaces";
    Places "places" Note "the real area differs by {scatter%} between the places (standard deviation)";
    ProcessZoneCoarse "adhesion.coarse-grid" Note
        "the process zone E* rho^2/w has {process_zone_points} points of the grid; from 2 on areas are good to 1 %, below they are up to 10 % \
         too large: take a finer grid or a longer range";
    Metastable "adhesion.metastable" Note
        "a disturbance may end the contact under a negative pressure; pull the surfaces apart for the largest pull";
    Hysteresis "adhesion.hysteresis" Note
        "the area depends on the history: at {hysteresis_pressure_pa} it is {hysteresis_apart_area_fraction%} on approach and \
         {hysteresis_contact_area_fraction%} coming from full contact";
    PullOff "adhesion.pull-off" Note
        "pull-off at {pull_off_pressure_pa}, with {pull_off_area_fraction%} of the area in contact and a mean gap of {pull_off_mean_gap_m}";
    AdhesionIndicators "adhesion.indicators" Note
        "indicators of adhesion: [Fuller & Tabor {fuller_tabor} (above {not_sticky_above} not sticky), ]Pastewka & Robbins \
         {pastewka_robbins} (sticky below {sticky_below})";
    CoupledTractions "coupled-tractions" Note
        "pressing these bodies shears them as well (Dundurs' beta {mismatch}), which is left out; displacement and loss hold for equal bodies";
    Sliding "sliding" Note
        "{sliding} of {all|load}: the tangential stress reaches friction times pressure, and everything slides";

    // Options and keys without effect.
    NoSuchOption "scene-note" Note "{option} does not affect {@model}[, only {models}]; leave it out";
    NeverYields "scene-note" Note "{option} affects only models that yield[ ({models})], not {@model}; leave it out";
    CorrectionsAreElastic "scene-note" Note
        "{option} does not affect {@model}: the corrected forms are elastic; leave it out";
    OtherHardnessLaw "scene-note" Note
        "{option} does not affect {@model} with a {--hardness_law} other than nix-gao; leave it out";
    HardnessDoesNotGrow "scene-note" Note
        "{option} does not affect {@model} without {--hardness_law} or {--strain_gradient_length}: the hardness does not grow; leave it out";
    StrengthDoesNotGrow "scene-note" Note
        "{option} limits a strength that grows at small depths, and without {--strain_gradient_length} none does; leave it out, or give that \
         length";
    ElasticElements "scene-note" Note
        "{option} does not affect {@model}, whose hardness does not grow and whose waves go from {--longest} to {--shortest}; leave it out";
    OfHalfSpaces "scene-note" Note
        "{option} does not affect {contact}, which are computed for half-spaces alone; leave it out";
    RigidBase "scene-note" Note
        "{option} does not affect a rigid base: leave it out, or leave out {--layer_base=rigid}";
    OtherKindOfFile "scene-note" Note
        "{option} does not affect a {kind}; leave it out, or say what the file is with {--as}";
    OtherQuantity "scene-note" Note "{option} does not affect {--quantity=@quantity}; leave it out";
    OtherDialect "scene-note" Note "{option} does not affect {--dialect=@dialect}; leave it out";
    NoFreeEdges "scene-note" Note "{option} affects only maps with free edges, and this one repeats itself; leave it out";
    Replaced "scene-note" Note "{option} has no effect beside {--@other}; leave one of them out";
    FigureShowsSomethingElse "scene-note" Note "{option} has no effect on what this figure shows";
    OneSpectrum "scene-note" Note "{option} has no effect on the spectrum of one scan; leave it out";
    NoCurveUsesIt "scene-note" Note "{option} has no effect: no curve depends on it";
    OtherCommand "scene-note" Note "{option} does not affect `{command}`, which computes no table; leave it out";
    EveryFileHasItsOwn "scene-note" Note "{option} has no effect: every file has its own; leave one of them out";
    NoRowUsesIt "scene-note" Note "{option} has no effect: no row of the table depends on it; leave it out";
    UnusedColumn "unused-column" Note "no row of the table depends on {columns}: without effect";
    EveryCurveHasItsOwn "scene-note" Note "{option} has no effect: every curve that it applies to sets its own";
    OtherBodyYields "scene-note" Note "{option} only decides which body yields: it is the other one";
    OnlyOneBodyHasIt "scene-note" Note "{option} has no effect: the other body has none";
    NothingNeedsIt "scene-note" Note "{option} has no effect: no curve and no figure needs it";
    CutoffBelowData "scene-note" Note "{option} has no effect: the spectrum ends above it, at {shortest_m}";
    JudgeIsOff "scene-note" Note "{option} has no effect: the judge is off";
    AllModelsRun "scene-note" Note "{option} has no effect: all models run where no curve and no figure is listed";
    UncertaintyIsOff "scene-note" Note "{option} has no effect: the uncertainty analysis is off";
    OneInputScatters "scene-note" Note "{option} has no effect: one input scatters, and the interval is its share alone; leave it out";
    NoBodyYields "scene-note" Note "{option} has no effect: neither body has a strength or a hardness; give yield_strength or indentation_hardness";
    NothingScatters "scene-note" Note
        "{option} has no effect: nothing in this scene is uncertain (several scans, standard errors or +-)";

    // What to know before quoting an area.
    FluidParts "fluid-parts-bodies" Caution
        "The fluid drops by {fluid_pressure_pa}, and the bodies press with {pressure_pa} only: the fluid parts them."
        short "the fluid parts the bodies";
    TooFewScales "too-few-scales" Caution
        "The spectrum is too short to tell how much touches: it has {scales|scale}."
        short "the spectrum has only {scales|scale}";
    InstrumentsDisagree "instruments-disagree" Caution
        "{elided first} has {ratio} times the spectrum of {elided second} from {longest_m} to {shortest_m}, where both measure: check units, \
         height scales and places, or leave one out. Two faces? Give one as {--counterface_surface}."
        short "{elided first} and {elided second} do not show the same surface";
    HardnessDecides "hardness-decides" Caution
        "Whether the hardness grows at small scales moves the area by a factor {ratio}: measure it by indentation at the depth of the \
         roughness."
        short "hardness at small scales decides a factor {ratio}";
    NotJudged "not-judged" Caution
        "No model was compared with boundary elements."
        short "not compared with boundary elements";
    NoModelAgrees "no-model-agrees" Caution
        "None of the {models~model} that can be compared with these boundary elements agrees: quote the elements."
        short "no model agrees with boundary elements";
    TheModelDisagrees "no-model-agrees" Caution
        "The model does not agree with these boundary elements: quote the elements."
        short "no model agrees with boundary elements";
    TipMayShow "tip-unknown" Caution
        "{files}: the radius of the tip is unknown, and below about {may_show_below_m} the scan may show the tip."
        short "tip unknown, which may show below {may_show_below_m}";
    SofterWithoutHardness "no-hardness" Caution
        "Give {softer} a hardness or a yield strength: it is less stiff than {harder}, and is taken not to yield."
        short "{softer} taken not to yield";
    MadeOfNumbers "made-of-numbers" Caution
        "The spectrum of {body} was made from an rms height and an rms slope, not measured."
        short "spectrum of {body} made from a few numbers";
    NotMeasured "not-measured" Caution
        "Nothing was measured from {longest_m} to {shortest_m}: the spectrum there is a guess."
        short "nothing measured from {longest_m} to {shortest_m}";
    UpperBound "upper-bound" Caution
        "Upper bound: the spectrum ends at {shortest_m} and the area is still falling there."
        short "upper bound, the spectrum ends at {shortest_m}";
    GapNotSettled "gap-not-settled" Caution
        "The spectrum ends at {longest_m} before the mean gap has settled: [with {flatness} counted, ]longer waves decide gap, stiffness, heat \
         and leaks."
        short "gap not settled, the spectrum ends at {longest_m}";
    TakenAsFlat "taken-as-flat" Caution
        "Gap, stiffness, heat and leaks are those of flat parts: a few numbers say nothing of longer waves."
        short "parts taken as flat";
    SpreadsOverPart "spreads-over-part" Caution
        "With {flatness}, contact spreads over {low%} to {high%} of the nominal contact at {load}, under as much more pressure: the share \
         that touches stays that of flat faces.[ The pressure in its middle, {peak_pa}, is above the hardness: the faces themselves would flow.]"
        short "contact spreads over {low%} to {high%} of the faces at {load}";
    TooSteep "too-steep" Caution
        "Below {from_m} slopes are too steep for every method used here, boundary elements included."
        short "slopes too steep below {from_m}";
    GapOfYieldingContact "gap-of-yielding-contact" Caution
        "{share%} of the contact yields, but {what} assume it does not: order of magnitude only."
        short "{share%} of the contact yields";
    StickyByPastewka "sticky" Caution
        "The surfaces stick, and no area here counts it: far more may touch. Pastewka & Robbins' criterion is {left_side}, and surfaces \
         stick below {limit}."
        short "sticks, which areas leave out";
    StickyByFuller "sticky" Caution
        "Adhesion may change the area, and no area here counts it: Fuller & Tabor's parameter is {theta}, and surfaces did not stick above \
         {limit}."
        short "adhesion, which areas leave out";
    NotGaussianMap "not-gaussian" Caution
        "{map} touches {ratio} times as much as Gaussian surfaces with its spectrum[ at {load}], which is counted: its heights are not \
         Gaussian."
        short "heights of {map} are not Gaussian";
    SlopesByDirection "slopes-by-direction" Caution
        "{map} touches {ratio} times as much as Gaussian surfaces with its spectrum[ at {load}], which is counted: its slopes differ by \
         direction."
        short "slopes of {map} differ by direction";
    SkewedHeights "skewed-heights" Caution
        "{files}: heights are skewed, Rsk {skewness}, and every method here takes them as Gaussian: {touches} touches than is said."
        short "skewed heights, {touches} touches than is said";
    DirectionalWaves "directional-waves" Caution
        "{files}: waves of {wavelength_m} carry {share%} of the variance: turned or milled? Leaks and gaps depend on their direction, and \
         every method here takes the surface as isotropic."
        short "waves of {wavelength_m} carry {share%}, and leaks and gaps depend on their direction";
    LayUnknown "lay-unknown" Caution
        "Traces show no lay: a turned or ground face touches more than is said if traced across its lay, and less if along it."
        short "traces show no lay";

    // Why an interval is a guess.
    FewScans "few-scans" Caution
        "Treat the range as a guess: {scans~(instrument) scan} cannot show how much the surface varies."
        short "{scans~(instrument) scan} only";
    OneInstrument "one-instrument" Caution
        "{scans} scans count as those of one instrument: {instrument}; name their instruments if there are several.";
    DrawsWithoutArea "draws-without-area" Caution
        "Treat the range as a guess: {draws} of {of|draw} leave the range of a model and do not count.";
    FewDraws "few-draws" Caution "Treat the range as a guess: it rests on {draws|draw} only.";
    SpectrumWithoutErrors "spectrum-without-errors" Caution
        "Treat the range as a guess: {name} has no standard errors, so it holds the scatter of the other inputs only.";

    // Why a curve has its verdict.
    ComparedAreas "judge.compared" Note
        "{ratio} times the area of boundary elements[; agrees on {agreeing} of {windows} windows, worst from {longest_m} to {shortest_m}: \
         {worst_ratio} times]";
    AgreesByAccident "judge.agrees-by-accident" Note
        "{ratio} times the area of the map, by accident: on Gaussian surfaces, which it is a model of, it agrees on {agreeing} of {windows} \
         windows, worst from {longest_m} to {shortest_m}: {worst_ratio} times";
    AssumesNoYielding "judge.broken.yields" Note
        "assumes that nothing yields, but from {wavelength_m} on the real pressure, {pressure_pa}, exceeds the hardness, {hardness_pa}";
    UnfittedLaw "judge.broken.unfitted" Note
        "from {wavelength_m} on, {load_share%} of the load rests on asperities outside the fitted range of the law";
    OwnHardnessLaw "judge.strength-grows" Note
        "yields from {wavelength_m} on by a hardness law of its own, which boundary elements do not have";
    BetweenHardnesses "judge.between-hardnesses" Note
        "within the range from the load over the hardness at the shortest wavelength to boundary elements with the constant hardness";
    BeyondHardnesses "judge.beyond-hardnesses" Note
        "{ratio} times the nearer end of the range from the load over the hardness at the shortest wavelength to boundary elements with \
         the constant hardness";
    TooLight "judge.too-light" Note "too few grid points would touch";
    LoadNotChosen "judge.load-not-chosen" Note "the budget leaves this load out; raise {--judge.budget}";
    NoArea "judge.no-area" Note "the curve has no area here";
    NotSolved "judge.cancelled" Note "cancelled before it was solved";
    BeyondBudget "judge.beyond-budget" Note "even the coarsest grid exceeds {--judge.budget}";
    NoSurface "judge.no-surface" Note "no surface can be made of the spectrum";
}

//! Options and keys that people try and that do not exist, with the way out. Those with dashes are options alone.

const WAYS_OUT: [(&[&str], &str); 20] = [
    (
        &["--load"],
        "a load is a nominal pressure: write --pressure 10MPa; a force goes into [loads] of a scene, with its area",
    ),
    (&["--pressure"], "pressures go into the scene: write pressures = [\"10 MPa\"] in [loads]"),
    (
        &["e", "modulus", "e_modulus"],
        "write --youngs-modulus 210GPa, or youngs_modulus in [material] of a scene",
    ),
    (&["friction", "mu", "cof"], "write friction = 0.3 into [interface] of a scene"),
    (
        &["layer", "coating", "film", "thickness"],
        "a layer goes into [material.layer] of a scene, with thickness, youngs_modulus and poisson_ratio",
    ),
    (
        &["--model", "--models"],
        "all models that apply are run; for one alone, write [[curve]] with model = \"persson\" in a scene",
    ),
    (
        &["file", "files", "scan"],
        "write scans = [\"trace.txt\"] or psd = \"psd.csv\" into [surface] of a scene",
    ),
    (
        &["hardness"],
        "write --indentation-hardness, or indentation_hardness in [material]: a pressure, 300HV or 60HRC",
    ),
    (&["tip_radius", "tip"], "the tip is that of a scan: write FILE:tip-radius=2um"),
    (&["unit", "size"], "it is that of a scan: write FILE:unit=um,size=10um"),
    (
        &["cutoff", "lambda_c"],
        "a cut-off is --filter of `roughness`, which leaves out longer waves, and --cutoff of `moments`",
    ),
    (
        &["counterface", "against"],
        "write --on NAME for the material of the counterface, as --on \"NBR 70 Shore A\"",
    ),
    (
        &["pressure_drop", "viscosity", "leak"],
        "a leak is asked in a scene, whose [seal] takes pressure_drop, viscosity, breadth and length: `truearea scene gasket` writes one",
    ),
    (
        &["rq", "sq", "ra", "sa", "rms_height", "rms_slope", "rdq", "sdq", "roughness", "slope"],
        "roughness numbers go into a scene, as surface = { rms_height = \"0.8 um\", rms_slope = 0.1, mean_width = \"50 um\" }; \
         rms_height is Rq, about 1.25 Ra, so that Ra = 0.8 um makes \"1 um\"",
    ),
    (
        &["conductivity", "resistivity", "thermal_conductivity"],
        "it is that of a body: write thermal_conductivity or resistivity into [material] and [counterface] of a scene",
    ),
    (&["force", "nominal_area", "area"], "write force and nominal_area into [loads] of a scene"),
    (
        &["temperature"],
        "nothing depends on the temperature of the bodies: give their modulus, hardness and conductivities at that temperature",
    ),
    (
        &["unloading", "unload", "unload_to", "reload"],
        "unloading of what has yielded is not computed: press heights + min(gap, 0) of its fields without a saturation",
    ),
    (&["fields"], "pressures and gaps point by point are given for flats without adhesion"),
    (
        &["work_of_adhesion", "adhesion_range"],
        "adhesion is computed between flats: for a ball press a map of a parabola, z = -(x^2 + y^2)/(2 R), with adhesion and \
         periodic edges",
    ),
];

/// Returns what to do in place of an option or key that does not exist.
#[must_use]
pub fn way_out(name: &str) -> Option<&'static str> {
    let typed = name;
    let name = name.trim_start_matches('-').replace('-', "_").to_lowercase();
    WAYS_OUT
        .iter()
        .find(|(names, _)| names.contains(&typed) || names.contains(&name.as_str()))
        .map(|(_, instead)| *instead)
}

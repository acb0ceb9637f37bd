//! Options and keys that people try and that are not computed, with the way out.

const WAYS_OUT: [(&[&str], &str); 4] = [
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
    let name = name.trim_start_matches('-').replace('-', "_").to_lowercase();
    WAYS_OUT.iter().find(|(names, _)| names.contains(&name.as_str())).map(|(_, instead)| *instead)
}

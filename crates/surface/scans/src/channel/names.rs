//! Quantities by the names of channels.

use std::collections::HashMap;

use super::{Channel, Quantity};
use units::LengthUnit;

/// Name of a channel without one, where a channel is asked for.
pub(crate) const UNNAMED: &str = "unnamed";

impl Quantity {
    /// Classifies numbers by their unit, as the file writes it and as a length where it is one: heights unless their
    /// name is that of another signal.
    pub(crate) fn named(name: &str, unit: &str, length: Option<LengthUnit>) -> Self {
        match length {
            Some(length) if is_named_after_signal(name) => Self::OtherLength(length),
            Some(length) => Self::Heights(Some(length)),
            None => Self::Other(unit.to_owned()),
        }
    }
}

/// Returns true if a name is one of heights, by the words that makers of instruments use.
pub(crate) fn is_named_after_height(name: &str) -> bool {
    let name = name.to_lowercase().replace([' ', '_', '-'], "");
    const WORDS: [&str; 8] =
        ["height", "topograph", "zsens", "zaxis", "ztrace", "zretrace", "elevation", "relief"];
    WORDS.iter().any(|word| name.contains(word)) || name == "z"
}

/// Returns true if a name is that of a signal that may be given as a length but is not a height of the surface.
pub(crate) fn is_named_after_signal(name: &str) -> bool {
    let is_height = is_named_after_height(name);
    let name = name.to_lowercase().replace([' ', '_', '-'], "");
    const WORDS: [&str; 8] =
        ["amplitude", "deflection", "error", "vibration", "xaxis", "xsens", "yaxis", "ysens"];
    !is_height && WORDS.iter().any(|word| name.contains(word))
}

/// Numbers channels of one name by their place among them, `Height #2`. The first with heights, else the first of all,
/// keeps the name as it is.
pub(crate) fn numbered(mut channels: Vec<Channel<'_>>) -> Vec<Channel<'_>> {
    let mut of_name: HashMap<String, Vec<usize>> = HashMap::new();
    for (at, channel) in channels.iter().enumerate() {
        of_name.entry(channel.name.clone().unwrap_or_else(|| UNNAMED.to_owned())).or_default().push(at);
    }
    for (name, places) in of_name {
        let plain = places.iter().find(|&&at| channels[at].is_heights()).unwrap_or(&places[0]);
        let others = places.iter().enumerate().filter(|(_, at)| *at != plain);
        others.for_each(|(number, &at)| channels[at].name = Some(format!("{name} #{}", number + 1)));
    }
    channels
}

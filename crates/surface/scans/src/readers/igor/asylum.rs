//! Notes and names of channels as Asylum Research writes them.

/// The lines `key: value` of the note of a scan.
pub(super) struct Note<'n> {
    text: &'n str,
}

/// Quantities by the beginning of a channel's name; the header gives one unit for all channels.
const UNITS: [(&str, &str); 11] = [
    ("Height", "m"),
    ("ZSensor", "m"),
    ("Deflection", "m"),
    ("Amplitude", "m"),
    ("Phase", "deg"),
    ("Current", "A"),
    ("Frequency", "Hz"),
    ("Capacitance", "F"),
    ("Potential", "V"),
    ("Count", ""),
    ("QFactor", ""),
];

/// Signals of detectors.
const OTHER_UNIT: &str = "V";

impl<'n> Note<'n> {
    /// The note of a wave, where it is that of a scan of Asylum Research.
    pub(super) fn parse(text: &'n str) -> Option<Self> {
        let note = Self { text };
        ["ScanSize", "FastScanSize", "MicroscopeModel"]
            .iter()
            .any(|key| note.get(key).is_some())
            .then_some(note)
    }

    pub(super) fn get(&self, key: &str) -> Option<&'n str> {
        let mut entries = self.text.split(['\r', '\n']).filter_map(|line| line.split_once(':'));
        entries.find_map(|(name, value)| (name.trim() == key).then(|| value.trim()))
    }

    /// Returns the axis of the lines that the instrument scanned: its images have the fast axis along x, however the
    /// scan is turned.
    pub(super) fn has_fast_axis(&self) -> bool {
        self.get("FastScanSize").is_some()
    }

    /// Returns the comments of the user.
    pub(super) fn free_text(&self) -> String {
        let entries = ["ImageNote", "TipSerialNumber"].map(|key| Some((key, self.get(key)?)));
        let filled = entries.into_iter().flatten().filter(|(_, value)| !value.is_empty());
        filled.map(|(key, value)| format!("{key}: {value}\n")).collect()
    }

    /// The unit of a channel: that of the note, else that of what its name begins with.
    pub(super) fn unit(&self, channel: &str) -> &'n str {
        let name = base(channel);
        if let Some(unit) = self.get(&format!("{name}Unit")) {
            return unit;
        }
        // Second passes and maps of force curves measure what the first pass does.
        let name = ["DAC", "Nap", "Map"].iter().find_map(|prefix| name.strip_prefix(prefix)).unwrap_or(name);
        UNITS.iter().find(|(start, _)| name.starts_with(start)).map_or(OTHER_UNIT, |(_, unit)| unit)
    }
}

/// The name of a channel without the direction of the scan and the changes made after it: `Height` of
/// `HeightTraceMod0`.
fn base(channel: &str) -> &str {
    let name = channel.trim_end_matches(|letter: char| letter.is_ascii_digit());
    let name = name.strip_suffix("Mod").unwrap_or(channel);
    name.strip_suffix("Retrace").or_else(|| name.strip_suffix("Trace")).unwrap_or(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_those_of_the_note_or_of_the_name() {
        let note = Note::parse("ScanSize: 2e-5\rUserCalcUnit: °\rImageNote:\r").unwrap();
        for (channel, unit) in [
            ("HeightTrace", "m"),
            ("HeightRetraceMod0", "m"),
            ("ZSensorTrace", "m"),
            ("NapHeightTrace", "m"),
            ("Phase2Trace", "deg"),
            ("UserCalcRetrace", "°"),
            ("NapPotentialTrace", "V"),
            ("CountTrace", ""),
            ("UserIn3Trace", "V"),
        ] {
            assert_eq!(note.unit(channel), unit, "{channel}");
        }
        assert_eq!((note.free_text().as_str(), note.has_fast_axis()), ("", false));
        assert!(Note::parse("a wave of mine: x").is_none());
    }
}

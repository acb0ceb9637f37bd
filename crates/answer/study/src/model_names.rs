//! Names that people know models by, besides the one that they type.

use crate::models::ModelEntry;

/// Abbreviations and authors, without case, blanks and hyphens, and the model of each.
const ALIASES: [(&str, &str); 13] = [
    ("archard", "elastic"),
    ("archardstack", "elastic"),
    ("jacksonstreator", "elastic"),
    ("gw", "hertz"),
    ("gwhertz", "hertz"),
    ("greenwoodwilliamson", "hertz"),
    ("jacksongreen", "ep-sphere"),
    ("rostamijackson", "elastic-sine"),
    ("krithivasanjackson", "ep-sine"),
    ("bushgibsonthomas", "bgt"),
    ("perssonstheory", "persson"),
    ("perssontheory", "persson"),
    ("perssonep", "persson-plastic"),
];

impl ModelEntry {
    /// Returns true if people call the model so: by its name, its short or full name in print, an abbreviation or its
    /// authors. Case, blanks and punctuation do not count.
    #[must_use]
    pub fn answers_to(&self, name: &str) -> bool {
        let plain = |text: &str| -> String {
            text.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
        };
        let wanted = plain(name);
        [self.name, self.short_name, self.full_name].into_iter().any(|known| plain(known) == wanted)
            || ALIASES.iter().any(|&(alias, known)| alias == wanted && known == self.name)
    }
}

#[cfg(test)]
mod tests {
    use crate::models::MODELS;

    use super::*;

    #[test]
    fn every_name_belongs_to_one_model() {
        let answering = |name: &str| -> Vec<&str> {
            MODELS.iter().filter(|entry| entry.answers_to(name)).map(|entry| entry.name).collect()
        };
        for entry in MODELS {
            for name in [entry.name, entry.short_name, entry.full_name] {
                assert_eq!(answering(name), [entry.name], "{name}");
            }
        }
        for (alias, name) in ALIASES {
            assert_eq!(answering(alias), [name], "{alias}");
        }
        assert_eq!((answering("GW"), answering("EP sine")), (vec!["hertz"], vec!["ep-sine"]));
        assert_eq!(answering("Greenwood-Williamson (Hertz)"), ["hertz"]);
        assert!(answering("rigid").is_empty());
    }
}

//! Suggestions for unknown names.

/// Least similarity of a suggested name, from 0 to 1.
const ALIKE: f64 = 0.75;

/// Returns the known name most similar to the given one, if any is similar enough.
pub(super) fn meant<'n>(given: &str, known: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let given = given.to_lowercase();
    let likeness = |name: &'n str| (strsim::jaro_winkler(&given, &name.to_lowercase()), name);
    known
        .into_iter()
        .map(likeness)
        .filter(|(likeness, _)| *likeness >= ALIKE)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::meant;

    #[test]
    fn the_most_alike_is_meant_and_nothing_where_none_is_alike() {
        let keys = ["youngs_modulus", "poisson_ratio", "yield_strength"];
        assert_eq!(meant("poisson", keys), Some("poisson_ratio"));
        assert_eq!(meant("Youngs_Modulus", keys), Some("youngs_modulus"));
        assert_eq!(meant("colour", keys), None);
    }
}

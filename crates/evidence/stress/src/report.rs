//! Results of a run, as text and as tables.

use std::fmt::Write as _;
use std::io;

use crate::Tally;

/// Returns the text: families, promises with their worst cases, and the spread of quantities without a promise.
pub fn summary(tally: &Tally) -> String {
    let mut text = String::new();
    let _ = writeln!(text, "{:28} {:>11} {:>9}", "family", "states", "refused");
    for (family, states) in &tally.states {
        let refused = tally.refused.get(family).copied().unwrap_or(0);
        let _ = writeln!(text, "{family:28} {states:11} {refused:9}");
    }
    let _ = writeln!(
        text,
        "\n{:28} {:44} {:>11} {:>8} {:>10} {:>10} {:>10}",
        "family", "promise", "tested", "broken", "worst", "of allowed", "state"
    );
    for ((family, promise), record) in &tally.records {
        let worst = &record.worst;
        let _ = writeln!(
            text,
            "{family:28} {promise:44} {:11} {:8} {:10.2e} {:10.2e} {:10}",
            record.tested, record.broken, worst.value, worst.over_allowance, worst.index
        );
    }
    let _ = writeln!(
        text,
        "\n{:28} {:44} {:>11} {:>9} {:>9} {:>9} {:>9}",
        "family", "quantity", "noted", "median", "99 %", "99.9 %", "largest"
    );
    for ((family, quantity), spread) in &tally.spreads {
        let [median, most, nearly_all, largest] = [0.5, 0.99, 0.999, 1.0].map(|share| spread.quantile(share));
        let _ = writeln!(
            text,
            "{family:28} {quantity:44} {:11} {median:9.1e} {most:9.1e} {nearly_all:9.1e} {largest:9.1e}",
            spread.len()
        );
    }
    text
}

/// Writes a row per promise with its worst case, and a row per state that broke one, with its inputs as a literal.
///
/// # Errors
/// The error of writing.
pub fn write_csv(tally: &Tally, to: impl io::Write) -> csv::Result<()> {
    let mut table = csv::Writer::from_writer(to);
    table.write_record([
        "family",
        "promise",
        "tested",
        "broken",
        "what",
        "value",
        "over_allowance",
        "state",
        "reach",
        "case",
    ])?;
    for (&(family, promise), record) in &tally.records {
        let rows = record.examples.iter().map(|example| ("broken", example));
        for (what, state) in [("worst", &record.worst)].into_iter().chain(rows) {
            let [tested, broken, index] =
                [record.tested, record.broken, state.index].map(|count| count.to_string());
            let [value, over] = [state.value, state.over_allowance].map(|number| format!("{number:e}"));
            table.write_record([
                family,
                promise,
                &tested,
                &broken,
                what,
                &value,
                &over,
                &index,
                &format!("{:?}", state.reach),
                state.case.as_str(),
            ])?;
        }
    }
    table.flush()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::{Draw, Reach, Tally, Trial};

    #[test]
    fn a_broken_promise_is_a_row_with_its_inputs() {
        let mut tally = Tally::default();
        let mut trial = Trial::new(&mut tally, "family", 5, (&0.1, Reach::Usual), Draw::new(0, 0));
        trial.bound("small", 3.0, 2.0);
        trial.note("size", 3.0);
        let mut written = Vec::new();
        super::write_csv(&tally, &mut written).unwrap();
        let written = String::from_utf8(written).unwrap();
        assert!(
            written.lines().last().unwrap() == "family,small,1,1,broken,3e0,1.5e0,5,Usual,0.1",
            "{written}"
        );
        assert_eq!(super::summary(&tally).lines().filter(|line| line.starts_with("family ")).count(), 6);
    }
}

//! Tables of the points, and the format of their numbers.

use serde::de::DeserializeOwned;

use crate::kernels::KernelCost;
use crate::machine::Fact;
use crate::point::{GivenQuantity, Outcome, Point};
use crate::scaling::Scaling;
use crate::stack::StackCost;

/// Name of a law in names of files.
pub fn stem(law: &str, given: GivenQuantity) -> String {
    format!("{}-by-{}", law.replace(", ", "-").replace(' ', "-"), given.name())
}

/// Points of one law and question.
pub fn points_csv(points: &[&Point], facts: &[Fact]) -> String {
    let mut text = comments(facts);
    text += "# error: the larger of the relative errors of area and pressure, or of area and separation over sigma\n";
    text += "population,separation_over_sigma,engine,setting,seconds_per_state,error,answer\n";
    for point in points {
        let (error, answer) = match &point.outcome {
            Outcome::Right(error) => (scientific(*error), "right"),
            Outcome::Wrong(error) => (scientific(*error), "wrong"),
            Outcome::Failed(_) => (String::new(), "none"),
        };
        let seconds = if point.seconds > 0.0 { scientific(point.seconds) } else { String::new() };
        let Point { population, separation_over_sigma, .. } = point;
        let engine = point.engine.name().replace(',', "");
        text += &format!(
            "{population},{separation_over_sigma},{engine},{:e},{seconds},{error},{answer}\n",
            point.setting
        );
    }
    text
}

/// Costs of single asperities.
pub fn kernels_csv(costs: &[KernelCost], facts: &[Fact]) -> String {
    let mut text = comments(facts);
    text += "kernel,seconds,median_error,python_seconds,python_median_error,numpy_seconds,numpy_median_error,batch_seconds,batch_median_error\n";
    for cost in costs {
        let cells = [Some(cost.ours), cost.scalar, cost.array, cost.batch].map(|cost| match cost {
            Some(cost) => format!("{},{}", scientific(cost.seconds), scientific(cost.median_error)),
            None => ",".to_owned(),
        });
        text += &format!("\"{}\",{}\n", cost.kernel, cells.join(","));
    }
    text
}

/// Costs of a scale of the stack.
pub fn stack_csv(costs: &[StackCost], facts: &[Fact]) -> String {
    let mut text = comments(facts) + "law,seconds_per_scale_and_load,off_limit\n";
    for cost in costs {
        let off = cost.off_limit.map(scientific).unwrap_or_default();
        text += &format!("\"{}\",{},{off}\n", cost.law, scientific(cost.seconds_per_scale));
    }
    text
}

/// Scaling of the program.
pub fn scaling_csv(scaling: &Scaling, facts: &[Fact]) -> String {
    let mut text = comments(facts) + &format!("# start-up: {} s\n", scientific(scaling.start_up_s));
    text += "what,size,processor_seconds,peak_bytes\n";
    for growth in &scaling.growths {
        for run in &growth.runs {
            let peak = run.peak_bytes.map(|bytes| bytes.to_string()).unwrap_or_default();
            text += &format!("\"{}\",{},{},{peak}\n", growth.what, run.size, scientific(run.processor_s));
        }
    }
    text
}

/// Parses the rows of a table that a script has printed.
///
/// # Errors
/// A message if a column or a number is missing.
pub fn parse<T: DeserializeOwned>(printed: &str) -> Result<Vec<T>, String> {
    let rows = csv::Reader::from_reader(printed.as_bytes()).into_deserialize().collect();
    let rows: Result<Vec<T>, csv::Error> = rows;
    rows.map_err(|error| error.to_string())
}

/// Facts as comments of a table.
pub fn comments(facts: &[Fact]) -> String {
    facts.iter().map(|(name, value)| format!("# {name}: {value}\n")).collect()
}

/// Formats three digits: times and errors have no more.
pub fn scientific(value: f64) -> String {
    format!("{value:.2e}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::Engine;

    #[test]
    fn unanswered_questions_have_empty_cells() {
        let point = Point {
            population: "steel".to_owned(),
            law: "ep-sine, strain gradient".to_owned(),
            given: GivenQuantity::Pressure,
            separation_over_sigma: -3.0,
            engine: Engine::GridBatch,
            setting: 1000.0,
            seconds: 1.23456e-5,
            outcome: Outcome::Right(0.000123456),
        };
        let failed =
            Point { seconds: 0.0, outcome: Outcome::Failed("no bracket".to_owned()), ..point.clone() };
        let text = points_csv(&[&point, &failed], &[("date".to_owned(), "today".to_owned())]);
        assert!(text.starts_with("# date: today\n"));
        assert!(text.contains("steel,-3,grid batch,1e3,1.23e-5,1.23e-4,right\n"), "{text}");
        assert!(text.ends_with("steel,-3,grid batch,1e3,,,none\n"), "{text}");
        assert_eq!(stem(&point.law, point.given), "ep-sine-strain-gradient-by-pressure");
    }
}

//! Prints the cost of intervals and shares by plain sampling and by fitted polynomials, as a table for
//! `docs/guide/uncertainty.md`: `cargo run --release -p truearea-work-precision --features surrogate --bin surrogate`.

use std::process::ExitCode;

use tables::markdown::table;
use work_precision::page::error;
use work_precision::surrogate::{Method, MethodErrors, method_errors};

fn main() -> ExitCode {
    match method_errors() {
        Ok(rows) => {
            let row = |found: &MethodErrors| {
                let method = match found.method {
                    Method::Plain => "plain sampling".to_owned(),
                    Method::Polynomial(degree) => format!("polynomial of degree {degree}"),
                };
                vec![method, found.plans.to_string(), error(found.ends), error(found.shares)]
            };
            let rows: Vec<Vec<String>> = rows.iter().map(row).collect();
            print!(
                "{}",
                table(&["method", "plans", "error of the ends over the length", "error of shares"], &rows)
            );
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

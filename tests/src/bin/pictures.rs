//! Draws the pictures of `docs/` from the program's own laws: `cargo xtask docs`.

use std::process::ExitCode;

use tests::pictures::{pictures, rewrite, stale};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let check = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => false,
        ["--check"] => true,
        _ => {
            eprintln!("usage: cargo xtask docs [--check]");
            return ExitCode::from(2);
        }
    };
    let stale = stale();
    for name in &stale {
        println!("docs/pictures/{name}.svg is not what the program draws");
    }
    match (stale.is_empty(), check) {
        (true, _) => println!("{} pictures in docs/pictures, as the program draws them", pictures().len()),
        (false, true) => {
            println!("\ncargo xtask docs draws them anew");
            return ExitCode::FAILURE;
        }
        (false, false) => {
            if let Err(error) = rewrite() {
                eprintln!("error: drawing the pictures: {error}");
                return ExitCode::FAILURE;
            }
            println!("drawn anew; a file that is no picture of the program is for you to delete");
        }
    }
    ExitCode::SUCCESS
}

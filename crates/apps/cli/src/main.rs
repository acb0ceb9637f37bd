//! The `truearea` binary; everything it does is in the library.

fn main() -> std::process::ExitCode {
    cli::run(std::env::args_os())
}

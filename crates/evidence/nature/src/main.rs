//! Compares measured contacts with predictions: `cargo xtask nature`.

fn main() {}

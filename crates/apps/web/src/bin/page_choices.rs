//! Prints what the page offers to choose from, for `cargo xtask web`, which writes it beside the page.

fn main() {
    print!("{}", web::choices());
}

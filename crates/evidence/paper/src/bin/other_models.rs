//! Rewrites the table of other models on the paper's surface in `docs/guide/which-model.md`: a part of `cargo xtask trials models`.

use std::error::Error;
use std::path::Path;

use paper::{Evidence, other_models, other_models_table};
use scene::Template;
use tables::markdown::with_section;

fn main() -> Result<(), Box<dyn Error>> {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/guide/which-model.md");
    let evidence = [Template::UncdReconstructed, Template::UncdMeasured].map(Evidence::compute);
    let models = other_models(&evidence.into_iter().collect::<Result<Vec<_>, _>>()?)?;
    let text = with_section(&std::fs::read_to_string(&page)?, "uncd", &other_models_table(&models))?;
    tables::staging::write_file(&page, text.into_bytes())?;
    println!("the table of other models in docs/guide/which-model.md");
    Ok(())
}

//! Notebooks as pages: their text, their code, and what it printed and drew when they were last run.

use std::fmt::Write as _;
use std::path::Path;

use serde_json::Value;

/// Writes a page for every notebook of a folder into another one, with the pictures beside it. Returns their names.
pub(super) fn write(notebooks: &Path, folder: &Path) -> Result<Vec<String>, Box<dyn std::error::Error>> {
    std::fs::create_dir_all(folder)?;
    let mut names = Vec::new();
    for entry in std::fs::read_dir(notebooks)? {
        let path = entry?.path();
        if path.extension().is_none_or(|extension| extension != "ipynb") {
            continue;
        }
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let notebook = serde_json::from_str(&std::fs::read_to_string(&path)?)?;
        let page = page(&notebook, &name)?;
        std::fs::write(folder.join(format!("{name}.md")), page.markdown)?;
        for (at, png) in page.pictures.iter().enumerate() {
            std::fs::write(folder.join(picture_name(&name, at)), png)?;
        }
        names.push(name);
    }
    names.sort();
    Ok(names)
}

fn picture_name(notebook: &str, at: usize) -> String {
    format!("{notebook}-{}.png", at + 1)
}

/// Notebook as a page.
struct Page {
    markdown: String,
    /// PNG files, in their order.
    pictures: Vec<Vec<u8>>,
}

fn page(notebook: &Value, name: &str) -> Result<Page, Box<dyn std::error::Error>> {
    let mut text = String::new();
    let mut pictures = Vec::new();
    for cell in notebook["cells"].as_array().ok_or("a notebook without cells")? {
        let source = joined(&cell["source"]);
        if cell["cell_type"] == "markdown" {
            writeln!(text, "{}\n", source.replace(".ipynb)", ".md)"))?;
            continue;
        }
        writeln!(text, "```python\n{}\n```\n", source.trim_end())?;
        for output in cell["outputs"].as_array().into_iter().flatten() {
            let data = &output["data"];
            if let Some(png) = data["image/png"].as_str() {
                pictures.push(from_base64(png)?);
                writeln!(text, "![Output of the cell above]({})\n", picture_name(name, pictures.len() - 1))?;
                continue;
            }
            let printed = [&output["text"], &data["text/plain"]].map(joined).concat();
            if !printed.trim().is_empty() {
                writeln!(text, "```text\n{}\n```\n", printed.trim_end())?;
            }
        }
    }
    Ok(Page { markdown: text, pictures })
}

/// Text that a notebook holds as a string or as lines.
fn joined(value: &Value) -> String {
    match value {
        Value::Array(lines) => lines.iter().filter_map(Value::as_str).collect(),
        Value::String(text) => text.clone(),
        _ => String::new(),
    }
}

fn from_base64(text: &str) -> Result<Vec<u8>, base64::DecodeError> {
    use base64::Engine as _;
    base64::engine::general_purpose::STANDARD.decode(text.replace('\n', ""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_code_output_and_pictures_come_in_their_order() {
        let notebook = serde_json::json!({ "cells": [
            { "cell_type": "markdown", "source": ["# A title\n", "See [b](b.ipynb)."] },
            { "cell_type": "code", "source": "print(1)", "outputs": [{ "text": ["1\n"] }] },
            { "cell_type": "code", "source": "plot()", "outputs": [{ "data": { "image/png": "aGk=\n", "text/plain": "<Figure>" } }] },
        ] });
        let Page { markdown, pictures } = page(&notebook, "a").unwrap();
        assert_eq!(
            markdown,
            "# A title\nSee [b](b.md).\n\n```python\nprint(1)\n```\n\n```text\n1\n```\n\n\
             ```python\nplot()\n```\n\n![Output of the cell above](a-1.png)\n\n"
        );
        assert_eq!(pictures, [b"hi"]);
    }
}

//! A share in a cell of a table.

use maud::{Markup, html};

/// As dark as its share is large; a negative one is outlined instead.
pub(super) fn share_cell(percent: Option<i32>) -> Markup {
    match percent {
        None => html! { td.share {} },
        Some(percent) if percent < 0 => html! { td.share.against { "−" (-percent) } },
        Some(percent) => {
            let depth = f64::from(percent.min(100)) / 100.0;
            html! { td.share style={ "--share:" (format!("{depth:.2}")) } { (percent) } }
        }
    }
}

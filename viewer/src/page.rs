//! The page put together: one text in which no title, name or scene can end a script or begin an element.

use rayon::ThreadPoolBuilder;

use crate::budget::{Fitted, fitted};
use crate::head::{Head, Text};
use crate::show::Show;

const PAGE: &str = include_str!("../page/view.html");
const STYLE: &str = include_str!("../page/style.css");
/// What runs, in the order in which one file uses another.
const SCRIPTS: [&str; 10] = [
    include_str!("../page/data.js"),
    include_str!("../page/colours.js"),
    include_str!("../page/fields.js"),
    include_str!("../page/card.js"),
    include_str!("../page/shape.js"),
    include_str!("../page/camera.js"),
    include_str!("../page/curve.js"),
    include_str!("../page/panel.js"),
    include_str!("../page/main.js"),
    include_str!("../page/selftest.js"),
];
/// What the card runs, by name.
const SHADERS: [(&str, &str); 7] = [
    ("colour.glsl", include_str!("../page/colour.glsl")),
    ("faces.vert", include_str!("../page/faces.vert")),
    ("faces.frag", include_str!("../page/faces.frag")),
    ("discs.vert", include_str!("../page/discs.vert")),
    ("discs.frag", include_str!("../page/discs.frag")),
    ("lines.vert", include_str!("../page/lines.vert")),
    ("lines.frag", include_str!("../page/lines.frag")),
];

/// A page that could not be made.
#[derive(Debug, thiserror::Error)]
#[error("the page cannot be made: {0}")]
pub struct EncodeError(String);

/// A page, and what it has no room for.
#[derive(Clone, Debug)]
pub struct Written {
    /// The text.
    pub html: String,
    /// What was left out, in words; the page says it too.
    pub left_out: Vec<String>,
}

/// The page, of at most so many bytes of numbers as far as leaving out can bring it; the same text for any number of
/// threads.
///
/// # Errors
/// [`EncodeError`] where threads cannot be had.
pub fn page(show: Show, most: usize, threads: usize) -> Result<Written, EncodeError> {
    let refused = |error: &dyn std::fmt::Display| EncodeError(error.to_string());
    // Of its own: a run on one thread must not wake the pool of the whole process.
    let pool = ThreadPoolBuilder::new().num_threads(threads.max(1)).build().map_err(|e| refused(&e))?;
    let Fitted { show, packed, left_out } = pool.install(|| fitted(show, most));
    let mut text = Text::default();
    let head = Head::new(&show, &packed, &left_out, &mut text);
    let head = serde_json::to_string(&head).map_err(|e| refused(&e))?;
    let shaders: Vec<String> = SHADERS
        .iter()
        .map(|(name, text)| format!("<script type=\"x-shader\" id=\"{name}\">{text}</script>"))
        .collect();
    let parts = [
        ("TITLE", escaped(&show.title)),
        ("STYLE", STYLE.into()),
        ("SHADERS", shaders.join("\n")),
        ("HEAD", quoted(&head)),
        ("DATA", text.0),
        ("SCRIPT", SCRIPTS.join("\n")),
    ];
    let mut html =
        String::with_capacity(parts.iter().map(|(_, text)| text.len()).sum::<usize>() + PAGE.len());
    let mut rest = PAGE;
    // In their order in the page: what was put in is never searched.
    for (name, text) in &parts {
        let mark = format!("{{{{{name}}}}}");
        let (before, after) = rest.split_once(&mark).ok_or_else(|| refused(&format!("no {mark}")))?;
        html.push_str(before);
        html.push_str(text);
        rest = after;
    }
    html.push_str(rest);
    Ok(Written { html, left_out })
}

/// Words as they stand in an element.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// JSON within a script element: no tag and no comment begins in it.
fn quoted(json: &str) -> String {
    json.replace('<', "\\u003c")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Body;
    use mesh_io::Sheet;

    const EVIL: &str = "</script><img src=x onerror=\"alert(1)\"> ' \" & <!-- {{DATA}}";

    #[test]
    fn titles_and_names_end_no_script_and_begin_no_element() {
        let sheet = Sheet { points: vec![[0.0; 3]], cells: vec![vec![0]], ..Sheet::default() };
        let mut body = Body::new(EVIL, &sheet);
        body.sets.insert(EVIL.into(), vec![0]);
        let show = |text: &str, body: Body| Show {
            title: text.into(),
            facts: vec![text.into()],
            warnings: vec![text.into()],
            scene: text.into(),
            bodies: vec![body],
            ..Show::default()
        };
        let evil = page(show(EVIL, body), 1 << 20, 1).unwrap().html;
        let plain = page(show("plain", Body::new("plain", &sheet)), 1 << 20, 1).unwrap().html;
        for tag in ["<script", "</script", "<img", "<!--"] {
            assert_eq!(evil.matches(tag).count(), plain.matches(tag).count(), "{tag}");
        }
        assert!(evil.contains("<title>&lt;/script&gt;&lt;img"));
        // What was put in is not filled in again, and the words are there as they were.
        let head = evil.split("id=\"head\">").nth(1).and_then(|rest| rest.split("</script>").next()).unwrap();
        let head: serde_json::Value = serde_json::from_str(head).unwrap();
        assert_eq!(
            [
                &head["title"],
                &head["warnings"][0],
                &head["bodies"][0]["name"],
                &head["bodies"][0]["sets"][0][0]
            ],
            [EVIL; 4]
        );
    }

    #[test]
    fn own_scripts_end_no_element_and_every_place_is_filled() {
        assert!(
            SCRIPTS.iter().chain(SHADERS.iter().map(|(_, text)| text)).all(|text| !text.contains("</script"))
        );
        let html = page(Show::default(), 1 << 20, 1).unwrap().html;
        assert!(!html.contains("{{"), "a place is not filled");
    }

    #[test]
    fn threads_change_no_byte() {
        let sheet = |by: f64| Sheet {
            points: (0..50).map(|i| [f64::from(i), by, 0.0]).collect(),
            cells: (0..50).map(|i| vec![i]).collect(),
            ..Sheet::default()
        };
        let show = || {
            let mut body = Body::new("a", &sheet(0.0));
            (0..5).for_each(|k| body.add(&sheet(f64::from(k))).unwrap());
            Show { bodies: vec![body], frames: vec![Default::default(); 5], ..Show::default() }
        };
        assert_eq!(page(show(), 1 << 20, 1).unwrap().html, page(show(), 1 << 20, 4).unwrap().html);
    }
}

//! The report as a browser shows it: every drawing is there, nothing is wider than a screen of 1280 pixels.
//!
//! Without a browser on the path (`chromium`, `google-chrome`, `chrome`) only the text of the pages is looked at, and the
//! test says so; where CI is set it fails.

#[path = "../../coque/tests/common/browser.rs"]
mod browser;

use std::error::Error;
use std::fs;
use std::path::Path;

use validation::report::{Page, pages};
use validation::{Effort, Selection, Variant, cases, judge};

/// Cases with a picture, with curves and with tables, each of less than a second.
const CASES: [&str; 3] = ["cantilever-end-shear", "strip-bending", "hemisphere"];

/// Opens all sections and writes what is wrong into the title; the report itself runs no scripts.
const LOOK: &str = "<script>addEventListener('load', () => {
  document.querySelectorAll('details').forEach(d => d.open = true);
  const faults = [];
  if (document.documentElement.scrollWidth > innerWidth) faults.push('page ' + document.documentElement.scrollWidth);
  const scrolls = e => { for (; e && e !== document.body; e = e.parentElement)
    if (['auto', 'scroll'].includes(getComputedStyle(e).overflowX)) return true; return false; };
  document.querySelectorAll('body *').forEach(e => {
    if (e.getBoundingClientRect().right > innerWidth + 1 && !scrolls(e)) faults.push(e.tagName + ' overflows'); });
  document.querySelectorAll('svg').forEach(e => {
    const seen = e.getBoundingClientRect(), held = e.getBBox();
    const least = e.closest('.legend') ? 4 : 20;
    if (!(seen.width > least && seen.height > least && held.width > 0)) faults.push('empty drawing ' + e.id); });
  document.title = 'looked: ' + document.querySelectorAll('svg').length + ' drawings; ' + faults.join(', ') + ';';
});</script></body>";

fn report() -> Result<Vec<Page>, Box<dyn Error>> {
    let names = CASES.map(String::from).to_vec();
    let selection = Selection { set: Effort::Quick, hard: false, names, jobs: 2, pages: false };
    Ok(pages(&judge(cases::usual(), &selection, &|_| {})?, &selection)?)
}

/// All that stands between two texts.
fn between<'a>(text: &'a str, start: &'a str, end: char) -> impl Iterator<Item = &'a str> {
    text.split(start).skip(1).filter_map(move |rest| rest.split(end).next())
}

fn title(browser: &str, page: &Page, folder: &Path) -> Result<String, Box<dyn Error>> {
    let file = folder.join(page.file);
    fs::write(&file, page.html.replacen("</body>", LOOK, 1))?;
    let (dom, _) = browser::opened(browser, &["--disable-gpu", "--window-size=1280,900"], &file, "");
    let title = between(&dom, "<title>", '<').next().unwrap_or_default().to_owned();
    Ok(title)
}

#[test]
fn every_drawing_is_shown_and_nothing_is_wider_than_the_screen() -> Result<(), Box<dyn Error>> {
    let pages = report()?;
    let first = &pages[0].html;
    let lines = first.matches("class='small'").count();
    assert_eq!(lines, CASES.len(), "a case has no drawing in the list");
    for target in between(first, "href='#", '\'') {
        assert_eq!(first.matches(&format!("id='{target}'")).count(), 1, "{target}");
    }
    let Some(browser) = browser::browser("the pages were read, not seen") else { return Ok(()) };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("report");
    fs::create_dir_all(&folder)?;
    for page in &pages {
        let title = title(browser, page, &folder)?;
        let drawings = page.html.matches("<svg ").count();
        assert_eq!(title, format!("looked: {drawings} drawings; ;"), "{}", page.file);
    }
    Ok(())
}

/// Without the run of ours that their times are counted in, other programs would not be drawn.
#[test]
fn other_programs_are_counted_in_a_run_that_is_made() -> Result<(), Box<dyn Error>> {
    let mut found = Vec::new();
    for case in cases::usual() {
        let Some(peers) = (case.peers)()? else { continue };
        let here = |variant: &&Variant| variant.method == peers.method && variant.grid == peers.grid;
        assert!(case.variants.iter().any(|variant| here(&variant)), "{}: {}", case.name, peers.grid);
        assert!(!peers.answers.is_empty(), "{}", case.name);
        for peer in &peers.answers {
            assert!(peer.cost > 0.0 && peer.error.is_finite(), "{}: {peer:?}", case.name);
        }
        found.push(case.name);
    }
    for name in ["panel", "ring", "cantilever-end-shear", "scordelis-lo", "dam-break-front"] {
        assert!(found.contains(&name), "{name} is among {found:?}");
    }
    let reported = report()?.iter().map(|page| page.html.clone()).collect::<String>();
    for words in ["OpenSees ASDShellQ4", "none beats in both: ", "measured another day"] {
        assert!(reported.contains(words), "{words} is not in the report");
    }
    Ok(())
}

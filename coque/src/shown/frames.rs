//! From the folder of a run to its page: frames of all bodies, curve, summary, sets.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::{Curve, SCENE_COPY, Sheet, listed, read_text};

use super::folder::{frame_lists, read_curve, read_summary, title};
use super::page::RunPage;

/// Most numbers that are held in memory; beyond them frames are passed over, evenly.
const MOST_NUMBERS: usize = 200_000_000;

/// The page of a run: one HTML text that a browser shows without a server.
///
/// `most` bounds its bytes: beyond them it holds fewer frames, then fewer fields, and says so. With `reload` the page
/// loads itself again after so many seconds, as one of a run under way does.
///
/// # Errors
/// What of the folder cannot be read, by file; a page that cannot be encoded.
pub fn page_of(folder: &Path, most: usize, threads: usize, reload: Option<f64>) -> Result<String, String> {
    let summary = read_summary(folder);
    let scene = read_text(&folder.join(SCENE_COPY)).unwrap_or_default();
    // A run that has only begun has no curve yet, but its scene.
    let curve = read_curve(folder)
        .or_else(|error| if scene.is_empty() { Err(error) } else { Ok(Curve::default()) })?;
    let page = frames(folder)?;
    let name = title(folder, summary.as_ref());
    page.html((&scene, &name), curve, summary.as_ref(), most, threads, reload)
}

/// All bodies over their frames, ended or under way; without frames there are words and the curve.
fn frames(folder: &Path) -> Result<RunPage, String> {
    let read = |path: &Path| Sheet::read(path).map_err(|e| format!("{e}\n"));
    let mut all = Vec::new();
    for list in frame_lists(folder) {
        let frames = listed(&list).map_err(|e| format!("{e}\n"))?;
        let Some((_, first)) = frames.first() else { continue };
        let name = list.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let first = read(first)?;
        all.push(Series { name, points: first.points.len(), numbers: numbers(&first), frames });
    }
    let sizes: BTreeMap<String, usize> = all.iter().map(|s| (s.name.clone(), s.points)).collect();
    all.retain(|s| !is_another_form(&s.name, s.points, &sizes));
    // Bodies write their frames one after the other: the last frame of a run under way is there for some of them only.
    let count = all.iter().map(|s| s.frames.len()).min().unwrap_or_default();
    let numbers: usize = all.iter().map(|s| s.numbers).sum();
    let keep = (MOST_NUMBERS / numbers.max(1)).clamp(2, count.max(2));
    let kept: Vec<usize> = match count > keep {
        true => (0..keep).map(|i| i * (count - 1) / (keep - 1)).collect(),
        false => (0..count).collect(),
    };
    let mut page = RunPage::default();
    for number in kept {
        let along = all.first().map_or(0.0, |s| s.frames[number].0);
        page.begin(along);
        for Series { name, frames, .. } in &all {
            page.add(name, &read(&frames[number].1)?)?;
        }
    }
    for (body, own) in sets(folder) {
        own.into_iter().for_each(|(name, points)| page.name_set(&body, &name, points));
    }
    Ok(page)
}

/// Frames that a list names, and what is known of the first of them.
struct Series {
    name: String,
    /// Where each stands, and its file.
    frames: Vec<(f64, PathBuf)>,
    points: usize,
    numbers: usize,
}

/// Numbers of a frame.
fn numbers(sheet: &Sheet) -> usize {
    let points = sheet.points.len();
    let widths =
        |fields: &BTreeMap<String, crate::Array>| fields.values().map(|array| array.width).sum::<usize>();
    points * (3 + widths(&sheet.point_data) + widths(&sheet.cell_data))
}

/// Whether a list shows a body once more: with its thickness, so twice the points, or where its integrals are taken.
fn is_another_form(name: &str, points: usize, all: &BTreeMap<String, usize>) -> bool {
    let thick = name.strip_suffix("-solid").or((name == "solid").then_some("shell"));
    let twice = thick.and_then(|base| all.get(base)).is_some_and(|&base| points == 2 * base);
    twice || name.strip_suffix("-points").is_some_and(|base| all.contains_key(base))
}

/// Sets of particles by body, as the run wrote them beside its frames.
fn sets(folder: &Path) -> BTreeMap<String, BTreeMap<String, Vec<u32>>> {
    let text = read_text(&folder.join("fields").join(crate::SETS)).ok();
    text.and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_is_shown_once_whatever_else_is_written_of_it() {
        let all: BTreeMap<String, usize> =
            [("gate", 82), ("shell", 250), ("block", 189)].map(|(name, n)| (name.into(), n)).into();
        let shown = |name: &str, points: usize| !is_another_form(name, points, &all);
        assert!(!shown("gate-solid", 164) && !shown("solid", 500) && !shown("block-points", 1000));
        // Bodies that are only called so.
        assert!(
            shown("gate-solid", 400) && shown("solid", 400) && shown("rim-points", 1000) && shown("gate", 82)
        );
    }
}

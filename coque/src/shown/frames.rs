//! From the folder of a run to what its page shows: frames of all bodies, curve, words, sets.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::{Curve, SCENE_COPY, Sheet, listed, read_text};
use serde_json::Value;
use viewer::{Body, Column, Instant, Show};

use super::folder::{Along, frame_lists, read_curve, read_summary, short, title};

/// Most numbers that are held in memory; beyond them frames are passed over, evenly.
const MOST_NUMBERS: usize = 200_000_000;

/// What is looked at first, where it is there: what breaks, what flows, how much a material bears.
const WANTED: [&str; 5] = ["damage", "pressure", "von_mises", "von_mises_top", "von_mises_bottom"];

/// The page of a run: one HTML text that a browser shows without a server.
///
/// `most` bounds its bytes: beyond them it holds fewer frames, then fewer fields, and says so. With `reload` the page
/// loads itself again after so many seconds, as one of a run under way does.
///
/// # Errors
/// What of the folder cannot be read, by file; a page that cannot be encoded.
pub fn page_of(folder: &Path, most: usize, threads: usize, reload: Option<f64>) -> Result<String, String> {
    let shown = Show { reload, ..show(folder)? };
    Ok(viewer::page(shown, most, threads).map_err(|e| format!("{e}\n"))?.html)
}

/// Reads the folder of a run, ended or under way; without frames there are words and the curve.
pub fn show(folder: &Path) -> Result<Show, String> {
    let summary = read_summary(folder);
    let scene = read_text(&folder.join(SCENE_COPY)).unwrap_or_default();
    let keys: toml::Table = scene.parse().unwrap_or_default();
    // A run that has only begun has no curve yet, but its scene.
    let curve = read_curve(folder)
        .or_else(|error| if scene.is_empty() { Err(error) } else { Ok(Curve::default()) })?;
    let (bodies, places) = bodies(folder)?;
    let along = Along::of(&curve, &places);
    let words = |at: f64| along.words(at).unwrap_or_else(|| format!("at {}", short(at)));
    let frames =
        places.iter().map(|&at| Instant { along: at, label: words(at), row: along.row(at) }).collect();
    let sizeless = along.are_modes();
    // What was replaced stands in the summary alone.
    let own_title =
        keys.get("title").filter(|_| summary.is_none()).and_then(toml::Value::as_str).map(String::from);
    Ok(Show {
        title: own_title.unwrap_or_else(|| title(folder, summary.as_ref())),
        facts: facts(summary.as_ref()),
        warnings: warnings(summary.as_ref()),
        plot: plot(&keys),
        scene,
        frames,
        sizeless,
        bodies,
        wanted: WANTED.map(String::from).to_vec(),
        ..of_curve(curve)
    })
}

fn of_curve(curve: Curve) -> Show {
    let column = |column: crate::Column| Column { name: column.name, unit: column.unit };
    Show { columns: curve.columns.into_iter().map(column).collect(), rows: curve.rows, ..Show::default() }
}

/// What was run and how it ended, a few words each.
fn facts(summary: Option<&Value>) -> Vec<String> {
    let Some(summary) = summary else { return vec!["under way, or killed: there is no summary".into()] };
    let word = |key: &str| summary[key].as_str().map(String::from);
    let count = |key: &str, what: &str| Some(format!("{} {what}", summary[key].as_u64()?));
    let said = [
        word("kind"),
        word("method"),
        word("analysis"),
        count("particles", "particles"),
        count("steps", "steps"),
        summary["wall_seconds"].as_f64().map(|s| format!("{} s", short(s))),
        word("ended"),
    ];
    said.into_iter().flatten().collect()
}

fn warnings(summary: Option<&Value>) -> Vec<String> {
    let all = summary.and_then(|summary| summary["warnings"].as_array());
    all.into_iter().flatten().filter_map(|warning| Some(warning["message"].as_str()?.to_owned())).collect()
}

/// The columns that the scene plots.
fn plot(scene: &toml::Table) -> Option<[String; 2]> {
    let plot = scene.get("output")?.get("plot")?;
    let column = |key: &str| Some(plot.get(key)?.as_str()?.to_owned());
    Some([column("x")?, column("y")?])
}

/// All bodies over their frames, and where the frames stand.
fn bodies(folder: &Path) -> Result<(Vec<Body>, Vec<f64>), String> {
    let mut all = Vec::new();
    for list in frame_lists(folder) {
        let frames = listed(&list).map_err(|e| format!("{e}\n"))?;
        let Some((_, first)) = frames.first() else { continue };
        let name = list.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let first = Sheet::read(first).map_err(|e| format!("{e}\n"))?;
        all.push(Series { name, frames, first });
    }
    let sizes: BTreeMap<String, usize> = all.iter().map(|s| (s.name.clone(), s.first.points.len())).collect();
    all.retain(|s| !is_another_form(&s.name, s.first.points.len(), &sizes));
    // Bodies write their frames one after the other: the last frame of a run under way is there for some of them only.
    let count = all.iter().map(|s| s.frames.len()).min().unwrap_or_default();
    let numbers: usize = all.iter().map(|s| numbers(&s.first)).sum();
    let keep = (MOST_NUMBERS / numbers.max(1)).clamp(2, count.max(2));
    let kept: Vec<usize> = match count > keep {
        true => (0..keep).map(|i| i * (count - 1) / (keep - 1)).collect(),
        false => (0..count).collect(),
    };
    let mut sets = sets(folder);
    let mut bodies = Vec::new();
    for Series { name, frames, first } in &all {
        let mut body = Body::new(name, first);
        for &number in &kept {
            let sheet = Sheet::read(&frames[number].1).map_err(|e| format!("{e}\n"))?;
            body.add(&sheet).map_err(|e| format!("{e}\n"))?;
        }
        body.sets = sets.remove(name).unwrap_or_default();
        bodies.push(body);
    }
    let places = all.first().map_or(Vec::new(), |s| kept.iter().map(|&k| s.frames[k].0).collect());
    Ok((bodies, places))
}

/// Frames that a list names, and the first of them.
struct Series {
    name: String,
    /// Where each stands, and its file.
    frames: Vec<(f64, PathBuf)>,
    first: Sheet,
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

    #[test]
    fn a_summary_says_more_than_a_run_under_way() {
        let summary = serde_json::json!({ "kind": "shell", "particles": 250, "ended": "done", "wall_seconds": 2.0_f64 });
        assert_eq!(facts(Some(&summary)), ["shell", "250 particles", "2 s", "done"]);
        assert!(facts(None)[0].starts_with("under way"));
        let warned = serde_json::json!({ "warnings": [{ "kind": "slow-sound", "message": "slow" }] });
        assert_eq!(warnings(Some(&warned)), ["slow"]);
    }
}

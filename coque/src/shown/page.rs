//! The page of a run, put together from its frames one after the other, wherever they come from.

use serde_json::Value;
use viewer::{Body, Column, Instant, Show};

use super::folder::{Along, short};
use crate::{Curve, Sheet};

/// What is looked at first, where it is there: what heat does, what breaks, what flows, how much a material bears.
const WANTED: [&str; 6] =
    ["temperature", "damage", "pressure", "von_mises", "von_mises_top", "von_mises_bottom"];

/// The frames of a run on their way to a page: each is begun, then each body is added to it.
///
/// ```
/// use coque::{Curve, RunPage, Sheet};
///
/// let moved = |by: f64| Sheet {
///     points: vec![[by, 0.0, 0.0], [1.0 + by, 0.0, 0.0], [by, 1.0, 0.0]],
///     cells: vec![vec![0, 1, 2]],
///     ..Sheet::default()
/// };
/// let mut page = RunPage::default();
/// for time in [0.0, 0.5] {
///     page.begin(time);
///     page.add("plate", &moved(time))?;
/// }
/// let curve: Curve = "time [s]\n0.0\n0.5\n".parse()?;
/// assert!(page.html(("", "A plate"), curve, None, 30_000_000, 1, None)?.starts_with("<!DOCTYPE html>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct RunPage {
    bodies: Vec<Body>,
    places: Vec<f64>,
}

impl RunPage {
    /// Begins a frame; `along` is what a film of the frames runs along, ascending ([`crate::Frame::along`]).
    pub fn begin(&mut self, along: f64) {
        self.places.push(along);
    }

    /// Adds a body to the frame that was begun last.
    ///
    /// # Errors
    /// A body that has other points than in its first frame, and one that was not in every frame before.
    pub fn add(&mut self, name: &str, sheet: &Sheet) -> Result<(), String> {
        if self.places.len() == 1 {
            self.bodies.push(Body::new(name, sheet));
        }
        let body = self.bodies.iter_mut().find(|body| body.name == name);
        let body = body.ok_or_else(|| format!("the first frame has no body {name}\n"))?;
        body.add(sheet).map_err(|e| format!("{e}\n"))
    }

    /// Names a set of points of a body that is in the first frame.
    pub fn name_set(&mut self, body: &str, name: &str, points: Vec<u32>) {
        if let Some(body) = self.bodies.iter_mut().find(|known| known.name == body) {
            body.sets.insert(name.to_owned(), points);
        }
    }

    /// The page: one HTML text that a browser shows without a server; `scene` is the text of the scene with the title that stands where
    /// neither text nor summary (`summary.json`) has one. `most` bounds its bytes, as in [`crate::page_of`].
    ///
    /// # Errors
    /// A page that cannot be encoded.
    pub fn html(
        self,
        (scene, title): (&str, &str),
        curve: Curve,
        summary: Option<&Value>,
        most: usize,
        threads: usize,
        reload: Option<f64>,
    ) -> Result<String, String> {
        let keys: toml::Table = scene.parse().unwrap_or_default();
        let along = Along::of(&curve, &self.places).with_cases(summary);
        let words = |at: f64| along.words(at).unwrap_or_else(|| format!("at {}", short(at)));
        let instant = |&at: &f64| Instant { along: at, label: words(at), row: along.row(at) };
        let frames = self.places.iter().map(instant).collect();
        let sizeless = along.are_modes();
        // What was replaced stands in the summary alone.
        let own_title = keys.get("title").filter(|_| summary.is_none()).and_then(toml::Value::as_str);
        let show = Show {
            title: own_title.unwrap_or(title).into(),
            facts: facts(summary),
            warnings: warnings(summary),
            plot: plot(&keys),
            scene: scene.into(),
            frames,
            sizeless,
            bodies: self.bodies,
            wanted: WANTED.map(String::from).to_vec(),
            reload,
            ..of_curve(curve)
        };
        Ok(viewer::page(show, most, threads).map_err(|e| format!("{e}\n"))?.html)
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_summary_says_more_than_a_run_under_way() {
        let summary = serde_json::json!({ "kind": "shell", "particles": 250, "ended": "done", "wall_seconds": 2.0_f64 });
        assert_eq!(facts(Some(&summary)), ["shell", "250 particles", "2 s", "done"]);
        assert!(facts(None)[0].starts_with("under way"));
        let warned = serde_json::json!({ "warnings": [{ "kind": "slow-sound", "message": "slow" }] });
        assert_eq!(warnings(Some(&warned)), ["slow"]);
    }
}

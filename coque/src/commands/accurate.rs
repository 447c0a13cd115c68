//! `coque run --accuracy`: which lattice is run, at what price, and whether its bars ask for a finer one.

use std::ops::ControlFlow;
use std::path::Path;
use std::time::Duration;

use crate::accuracy::{Asked, ClimbError, Refined};
use crate::{Checked, Outcome, Silent, Verdict};

use super::accuracy::{percent, time};
use super::stderr::{Refused, say};

/// Lattices that a forecast rests on, and the time for them \[s\].
const LATTICES: usize = 6;
const WITHIN: f64 = 30.0;
/// Cells along an edge over those of before, where a bar is too wide: by no less, or the next run is hardly better, and no more, or it is too dear.
const FINER: [f64; 2] = [1.2, 2.5];
/// A bar over the error that a forecast has: twice over 1.25 times what the order gives.
const WIDER: f64 = 1.6;
/// Growth of time with the cells along an edge: those of a surface and its factor.
const GROWTH: f64 = 2.8;

/// The finer mesh of a run, in its folder.
const MESH: &str = "finer.inp";

/// A lattice to be run.
pub struct Wanted {
    /// What of the scene it replaces.
    pub lattice: Vec<(String, String)>,
    /// Whether one more may follow.
    pub again: bool,
}

/// The lattice that the scene's own method takes for an accuracy; its price is said.
///
/// # Errors
/// A scene that has no lattice to refine or measures nothing; a forecast that cannot be made in its time.
pub fn forecast(scene: &Checked, accuracy: f64, threads: usize) -> Result<Wanted, Refused> {
    if let Some(why) = scene.unforeseen() {
        say(&format!("{why}: its own first, then a finer one if its bars ask for it"));
        return Ok(Wanted { lattice: Vec::new(), again: true });
    }
    let within = Duration::from_secs_f64(WITHIN);
    let asked = Asked { accuracy: accuracy / WIDER, within, lattices: LATTICES, threads };
    let forecasts =
        scene.forecast(&asked, &mut |_, _| ControlFlow::Continue(())).map_err(|error| match error {
            ClimbError::Refused(error) => Refused::scene(&error),
            ClimbError::Silent(why) => format!("no accuracy can be reached: {why}\n").into(),
        })?;
    let needed = forecasts.first().and_then(|forecast| forecast.needed.clone());
    let needed = needed.ok_or_else(|| {
        format!(
            "no lattice for {} can be forecast; see what was run with `coque check --accuracy`\n",
            percent(accuracy)
        )
    })?;
    say(&format!(
        "{} takes {}: {:.0} particles, about {} and {:.0} MB, half as long again for the bars",
        percent(accuracy),
        needed.lattice,
        needed.particles,
        time(needed.seconds),
        1e-6 * needed.memory
    ));
    let refined = scene.refined(1.0 / needed.spacing).map_err(|error| Refused::scene(&error))?;
    Ok(Wanted { lattice: lattice(&refined), again: true })
}

fn lattice(refined: &Refined) -> Vec<(String, String)> {
    refined.overrides().unwrap_or_default()
}

/// A finer lattice where the bars of a run are wider than an accuracy; none where they are not, or where refinement does not help.
pub fn refine(
    scene: &Checked,
    outcome: &Outcome,
    measured: &[String],
    accuracy: f64,
    folder: &Path,
) -> Option<Wanted> {
    let errors = outcome.summary.errors.as_ref()?;
    let modes = scene.analysis.kind().gives_modes;
    let own = errors.columns.iter().filter(|found| modes || measured.contains(&found.column.name));
    let wide = own.flat_map(|found| {
        let greatest = found.bars.iter().fold(0.0, |most: f64, bar| most.max(bar.value.abs()));
        let counted = found.bars.iter().filter(|bar| bar.verdict != Verdict::Exact);
        counted.filter_map(move |bar| {
            Some((bar.bar? / greatest, bar.order.unwrap_or(1.0), found.column.name.clone()))
        })
    });
    let (width, order, column) = wide.max_by(|a, b| a.0.total_cmp(&b.0))?;
    if width <= accuracy {
        say(&format!("every bar is within {}", percent(accuracy)));
        return None;
    }
    let finer = libm::pow(width / accuracy, 1.0 / order).clamp(FINER[0], FINER[1]);
    let (next, spacing, words) = match finer_one(scene, finer, folder) {
        Ok(found) => found,
        Err(why) => {
            say(&format!(
                "the bar of {column} is {} of its greatest value; no finer one: {why}",
                percent(width)
            ));
            return None;
        }
    };
    let seconds = outcome.summary.record.wall_seconds * libm::pow(1.0 / spacing, GROWTH);
    say(&format!(
        "the bar of {column} is {} of its greatest value: once more on {words}, about {}",
        percent(width),
        time(seconds)
    ));
    Some(Wanted { lattice: next, again: false })
}

/// What of a scene is replaced by a finer lattice or mesh; its spacing over that of before; in words.
type Finer = (Vec<(String, String)>, f64, String);

/// A finer lattice or mesh, which goes into the folder of the run.
fn finer_one(scene: &Checked, finer: f64, folder: &Path) -> Result<Finer, String> {
    if scene.as_shell().is_some_and(|shell| shell.geometry.mesh().is_some()) {
        let arrays = scene.graded(None, 1, &mut Silent)?.arrays;
        let file = folder.join(MESH);
        mesh_io::write_whole(&file, |to| arrays.write_inp(to)).map_err(|error| error.to_string())?;
        let file = std::path::absolute(&file).map_err(|error| error.to_string())?;
        let scope = scene.first_body().map_err(|error| error.to_string())?.body_scope();
        let replaced = (scope.path("geometry.mesh.file"), format!("{:?}", file.display().to_string()));
        return Ok((vec![replaced], 0.5, format!("a mesh of {} nodes", arrays.points.len())));
    }
    let refined = match scene.unforeseen() {
        Some(_) => scene.alike(1.0 / finer, 1)?,
        None => scene.refined(finer).map_err(|error| error.to_string())?,
    };
    Ok((lattice(&refined), refined.spacing, refined.lattice.clone()))
}

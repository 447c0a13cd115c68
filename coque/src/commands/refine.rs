//! `coque refine`: a scene on a finer lattice or mesh, all over or where its strains ask for it.

use std::io::Write;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;

use super::accuracy::percent;
use super::run::read_scene;
use super::stderr::{Refused, say};
use super::stop::Stop;
use crate::accuracy::Graded;
use crate::{Checked, Progress, ProgressReport};

#[derive(Args)]
pub struct Refine {
    /// The scene, a TOML file.
    scene: PathBuf,
    /// Cut the cells in four that hold this share of the estimated error together, such as 50%: the scene is run for it. Left out, all are,
    /// and a lattice has half its spacing.
    #[arg(long, value_name = "SHARE", value_parser = marked)]
    by: Option<f64>,
    /// The scene that is written, a mesh beside it with the ending .inp [default: SCENE-finer.toml in the present folder].
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Threads of the run.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: u16,
}

pub const HELP: &str = "\
Writes the scene on half its spacing: each face of a mesh in four, lattices of all bodies with twice the cells. With --by
cells of a shell are cut only where the estimated error is. A run with [error] and [output.fields] shows the same estimate as
the field `error_indicator`. A lattice then becomes a mesh with the sets that the scene names, its new particles on its own
surface; those of a mesh follow the curve through its nodes. Sets take in the middles of their edges. Comments of the scene
are kept. Refuses meshes that are tied or have sections of their own; with --by what has no cells, lattices that are scattered,
disordered, graded, turned or placed.

Examples:
  coque refine scenes/scordelis-lo.toml --by 50%
  coque refine plate.toml --by 60% --out finer.toml && coque refine finer.toml --by 60% --out finest.toml
  coque refine bracket.toml                                    each face in four
  coque refine scenes/dam-break.toml                           half the spacing

Exit codes: 0 written, 2 refused or not written.";

/// A share from `50%` or `0.5`.
fn marked(text: &str) -> Result<f64, String> {
    let (number, unit) = text.strip_suffix('%').map_or((text, 1.0), |number| (number.trim_end(), 0.01));
    let share = number.parse().map(|number: f64| unit * number).ok();
    let share = share.filter(|share| 0.0 < *share && *share <= 1.0);
    share.ok_or_else(|| "give a share above 0 and up to 100%, such as 50% or 0.5".into())
}

/// Refines, and writes scene and mesh.
pub fn carry_out(refine: &Refine, stop: &Arc<Stop>) -> Result<(), Refused> {
    let (scene, text) = read_scene(&refine.scene, &[])?;
    let out = refine.out.clone().unwrap_or_else(|| {
        let stem = refine.scene.file_stem().unwrap_or("scene".as_ref()).to_string_lossy();
        PathBuf::from(format!("{stem}-finer.toml"))
    });
    let mesh = out.with_extension("inp");
    let lattice = refine.by.is_none() && scene.as_shell().is_none_or(|shell| shell.geometry.mesh().is_none());
    if out.exists() || !lattice && mesh.exists() {
        return Err(format!("{} or its mesh exists; give another name with --out\n", out.display()).into());
    }
    if lattice {
        return doubled(refine, &scene, &text, &out);
    }
    let name = mesh.file_name().unwrap_or_default().to_string_lossy().into_owned();
    stop.begin();
    let found = scene.graded(refine.by, refine.threads.into(), &mut Watch(stop.clone()));
    let Graded { arrays, nodes, marked, error } = found.map_err(|why| format!("{why}\n"))?;
    let written = scene.on_mesh(&text, &name).map_err(|why| format!("{why}\n"))?;
    let refused = |error: std::io::Error| format!("cannot write {}: {error}\n", out.display());
    mesh_io::write_whole(&mesh, |file| arrays.write_inp(file)).map_err(refused)?;
    write(&out, &written)?;
    if let Some(error) = error {
        say(&format!("estimated error of the strains, in the norm of the energy: {}", percent(error)));
    }
    say(&format!(
        "{} of {} cells in four: {nodes} particles before, {} now; {} and {}",
        marked[1],
        marked[0],
        arrays.points.len(),
        out.display(),
        mesh.display()
    ));
    Ok(())
}

/// Writes the scene on lattices of half the spacing.
fn doubled(refine: &Refine, scene: &Checked, text: &str, out: &Path) -> Result<(), Refused> {
    let finer = scene.alike(0.5, refine.threads.into()).map_err(|why| format!("{why}\n"))?;
    let written = finer.on_lattice(text).map_err(|why| format!("{why}\n"))?;
    write(out, &written)?;
    say(&format!("half the spacing: {}; {}", finer.lattice, out.display()));
    Ok(())
}

/// Writes a scene; the schema lies beside the one that it is made of.
fn write(out: &Path, text: &str) -> Result<(), Refused> {
    let lines = text.lines().filter(|line| !line.starts_with("#:schema"));
    let text: String = lines.map(|line| format!("{line}\n")).collect();
    let refused = |error: std::io::Error| format!("cannot write {}: {error}\n", out.display());
    Ok(mesh_io::write_whole(out, |file| file.write_all(text.as_bytes())).map_err(refused)?)
}

/// Ends the run when that is asked for.
struct Watch(Arc<Stop>);

impl Progress for Watch {
    fn update(&mut self, _: &ProgressReport) -> ControlFlow<()> {
        if self.0.asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

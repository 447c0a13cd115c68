//! `coque examples`: the scenes of the repository within the program, listed and written out.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::Scene;
use clap::Args;

use super::stderr::{Refused, print};

#[derive(Args)]
pub struct Examples {
    /// Which one is written into the present folder, with its mesh if it has one; without, all are listed.
    name: Option<String>,
}

pub const HELP: &str = "\
Examples:
  coque examples                   all of them: seconds that a run takes, name, what it is
  coque examples gate              writes gate.toml; then: coque run gate.toml --view
  coque examples | grep -i buckl";

/// A scene of the repository.
pub struct Example {
    pub name: &'static str,
    /// Seconds of a run on one core of an EPYC, about.
    seconds: f64,
    scene: &'static str,
}

impl Example {
    const fn new(name: &'static str, seconds: f64, scene: &'static str) -> Self {
        Self { name, seconds, scene }
    }
}

const EXAMPLES: [Example; 125] = [
    Example::new("arch-onto-flat", 0.2, include_str!("../../../scenes/arch-onto-flat.toml")),
    Example::new("baffle", 100.0, include_str!("../../../scenes/baffle.toml")),
    Example::new("ball-on-incline", 0.5, include_str!("../../../scenes/ball-on-incline.toml")),
    Example::new("ball-on-plate", 2.0, include_str!("../../../scenes/ball-on-plate.toml")),
    Example::new("balloon-inflating", 0.5, include_str!("../../../scenes/meshes/balloon-inflating.toml")),
    Example::new("balloon-pumped", 1.0, include_str!("../../../scenes/meshes/balloon-pumped.toml")),
    Example::new("bar-bonds-yielding", 0.5, include_str!("../../../scenes/bar-bonds-yielding.toml")),
    Example::new("block-on-flat", 0.1, include_str!("../../../scenes/block-on-flat.toml")),
    Example::new("block-on-incline", 0.1, include_str!("../../../scenes/block-on-incline.toml")),
    Example::new("box-in-waves", 15.0, include_str!("../../../scenes/box-in-waves.toml")),
    Example::new("cantilever-end-shear", 38.0, include_str!("../../../scenes/cantilever-end-shear.toml")),
    Example::new("cantilever-shaken", 1.0, include_str!("../../../scenes/cantilever-shaken.toml")),
    Example::new("cantilever-on-flat", 1.0, include_str!("../../../scenes/cantilever-on-flat.toml")),
    Example::new("cantilever-solid", 1.0, include_str!("../../../scenes/cantilever-solid.toml")),
    Example::new("capstan", 10.0, include_str!("../../../scenes/capstan.toml")),
    Example::new("clamped-cap", 2.0, include_str!("../../../scenes/clamped-cap.toml")),
    Example::new("column-between-tools", 0.1, include_str!("../../../scenes/column-between-tools.toml")),
    Example::new("channel-with-inflow", 30.0, include_str!("../../../scenes/channel-with-inflow.toml")),
    Example::new("column-buckling", 0.1, include_str!("../../../scenes/column-buckling.toml")),
    Example::new("column-yielding", 0.2, include_str!("../../../scenes/column-yielding.toml")),
    Example::new("cook-yielding", 1.0, include_str!("../../../scenes/meshes/cook-yielding.toml")),
    Example::new("crack-branching", 3.0, include_str!("../../../scenes/crack-branching.toml")),
    Example::new("cylinder-bursting", 6.0, include_str!("../../../scenes/cylinder-bursting.toml")),
    Example::new("cylinder-pressure", 0.2, include_str!("../../../scenes/cylinder-pressure.toml")),
    Example::new("cylinder-yielding", 4.0, include_str!("../../../scenes/cylinder-yielding.toml")),
    Example::new("dam-break", 3.0, include_str!("../../../scenes/dam-break.toml")),
    Example::new("disc-yielding", 0.5, include_str!("../../../scenes/meshes/disc-yielding.toml")),
    Example::new("drum-on-block", 4.0, include_str!("../../../scenes/drum-on-block.toml")),
    Example::new("drum-on-bonds", 2.0, include_str!("../../../scenes/drum-on-bonds.toml")),
    Example::new("flanged-bracket", 0.1, include_str!("../../../scenes/meshes/flanged-bracket.toml")),
    Example::new("flow-between-plates", 0.3, include_str!("../../../scenes/flow-between-plates.toml")),
    Example::new("open-channel", 35.0, include_str!("../../../scenes/open-channel.toml")),
    Example::new("floating-box", 2.0, include_str!("../../../scenes/floating-box.toml")),
    Example::new("floating-cylinder", 27.0, include_str!("../../../scenes/meshes/floating-cylinder.toml")),
    Example::new("wedge-entry", 15.0, include_str!("../../../scenes/meshes/wedge-entry.toml")),
    Example::new("fold-pressed", 3.0, include_str!("../../../scenes/fold-pressed.toml")),
    Example::new("fragments-on-shell", 4.0, include_str!("../../../scenes/fragments-on-shell.toml")),
    Example::new("framed-plate", 0.2, include_str!("../../../scenes/framed-plate.toml")),
    Example::new("gate", 7.0, include_str!("../../../scenes/gate.toml")),
    Example::new("gate-on-sill", 8.0, include_str!("../../../scenes/gate-on-sill.toml")),
    Example::new("gate-bonds", 28.0, include_str!("../../../scenes/gate-bonds.toml")),
    Example::new("glued-lap", 2.0, include_str!("../../../scenes/glued-lap.toml")),
    Example::new("heavy-end", 0.1, include_str!("../../../scenes/heavy-end.toml")),
    Example::new("hemisphere", 0.1, include_str!("../../../scenes/hemisphere.toml")),
    Example::new("hemisphere-on-flat", 3.0, include_str!("../../../scenes/hemisphere-on-flat.toml")),
    Example::new("hemisphere-yielding", 1.0, include_str!("../../../scenes/hemisphere-yielding.toml")),
    Example::new("hollow-ball", 0.5, include_str!("../../../scenes/meshes/hollow-ball.toml")),
    Example::new(
        "hollow-ball-galerkin",
        5.0,
        include_str!("../../../scenes/meshes/hollow-ball-galerkin.toml"),
    ),
    Example::new("hub-turned", 0.1, include_str!("../../../scenes/meshes/hub-turned.toml")),
    Example::new("incline", 2.0, include_str!("../../../scenes/incline.toml")),
    Example::new("joined-cantilevers", 0.1, include_str!("../../../scenes/joined-cantilevers.toml")),
    Example::new("kalthoff", 5.0, include_str!("../../../scenes/kalthoff.toml")),
    Example::new("mass-between-stops", 0.1, include_str!("../../../scenes/mass-between-stops.toml")),
    Example::new("mass-on-column", 0.1, include_str!("../../../scenes/mass-on-column.toml")),
    Example::new("open-cylinder", 3.0, include_str!("../../../scenes/open-cylinder.toml")),
    Example::new("open-hole", 0.1, include_str!("../../../scenes/meshes/open-hole.toml")),
    Example::new("paddle-on-hinge", 1.0, include_str!("../../../scenes/paddle-on-hinge.toml")),
    Example::new("panel", 14.0, include_str!("../../../scenes/panel.toml")),
    Example::new("panel-laminated", 22.0, include_str!("../../../scenes/panel-laminated.toml")),
    Example::new("panel-solid", 39.0, include_str!("../../../scenes/panel-solid.toml")),
    Example::new("patch-test", 0.1, include_str!("../../../scenes/patch-test.toml")),
    Example::new("pinched-cylinder", 0.1, include_str!("../../../scenes/pinched-cylinder.toml")),
    Example::new("pinched-cylinder-large", 5.0, include_str!("../../../scenes/pinched-cylinder-large.toml")),
    Example::new("plate", 0.1, include_str!("../../../scenes/plate.toml")),
    Example::new("plate-buckling", 0.2, include_str!("../../../scenes/plate-buckling.toml")),
    Example::new("plate-clamped", 0.1, include_str!("../../../scenes/plate-clamped.toml")),
    Example::new("plate-clamped-solid", 1.0, include_str!("../../../scenes/plate-clamped-solid.toml")),
    Example::new("plate-on-gas", 0.1, include_str!("../../../scenes/plate-on-gas.toml")),
    Example::new("plate-on-plate", 4.0, include_str!("../../../scenes/plate-on-plate.toml")),
    Example::new("plate-orthotropic", 6.0, include_str!("../../../scenes/plate-orthotropic.toml")),
    Example::new("plate-pd", 6.0, include_str!("../../../scenes/plate-pd.toml")),
    Example::new("plate-shortened", 2.0, include_str!("../../../scenes/plate-shortened.toml")),
    Example::new("plate-solid", 5.0, include_str!("../../../scenes/plate-solid.toml")),
    Example::new("plate-yielding", 1.0, include_str!("../../../scenes/plate-yielding.toml")),
    Example::new("propped-cantilever", 0.2, include_str!("../../../scenes/propped-cantilever.toml")),
    Example::new("pulled-strip", 0.1, include_str!("../../../scenes/pulled-strip.toml")),
    Example::new("heated-plate", 0.5, include_str!("../../../scenes/heated-plate.toml")),
    Example::new("plate-heated-aside", 0.5, include_str!("../../../scenes/plate-heated-aside.toml")),
    Example::new("cooled-fin", 0.1, include_str!("../../../scenes/cooled-fin.toml")),
    Example::new("plate-quenched", 0.5, include_str!("../../../scenes/plate-quenched.toml")),
    Example::new("bimetal-strip", 0.1, include_str!("../../../scenes/bimetal-strip.toml")),
    Example::new("relieved-strip", 0.1, include_str!("../../../scenes/relieved-strip.toml")),
    Example::new("ring", 3.0, include_str!("../../../scenes/ring.toml")),
    Example::new("ring-between-plates", 0.6, include_str!("../../../scenes/ring-between-plates.toml")),
    Example::new("ring-in-itself", 2.0, include_str!("../../../scenes/ring-in-itself.toml")),
    Example::new("ring-green-lagrange", 6.0, include_str!("../../../scenes/ring-green-lagrange.toml")),
    Example::new("ring-pressure", 0.1, include_str!("../../../scenes/ring-pressure.toml")),
    Example::new("roof-collapsing", 20.0, include_str!("../../../scenes/roof-collapsing.toml")),
    Example::new("sandwich-panel", 0.2, include_str!("../../../scenes/sandwich-panel.toml")),
    Example::new("scordelis-lo", 0.1, include_str!("../../../scenes/scordelis-lo.toml")),
    Example::new("shell-in-water", 24.0, include_str!("../../../scenes/shell-in-water.toml")),
    Example::new("shell-on-root", 2.0, include_str!("../../../scenes/shell-on-root.toml")),
    Example::new("slider-crank", 0.9, include_str!("../../../scenes/slider-crank.toml")),
    Example::new("spinning-block", 0.1, include_str!("../../../scenes/spinning-block.toml")),
    Example::new("stepped-plate", 0.1, include_str!("../../../scenes/stepped-plate.toml")),
    Example::new(
        "stiffened-panel-abaqus",
        0.1,
        include_str!("../../../scenes/meshes/stiffened-panel-abaqus.toml"),
    ),
    Example::new(
        "stiffened-panel-gmsh",
        0.1,
        include_str!("../../../scenes/meshes/stiffened-panel-gmsh.toml"),
    ),
    Example::new("strip-fibre-metal", 0.1, include_str!("../../../scenes/strip-fibre-metal.toml")),
    Example::new("strip-lifted", 1.0, include_str!("../../../scenes/strip-lifted.toml")),
    Example::new("strip-necking", 0.1, include_str!("../../../scenes/strip-necking.toml")),
    Example::new("strip-over-drum", 1.0, include_str!("../../../scenes/strip-over-drum.toml")),
    Example::new("strip-springback", 1.0, include_str!("../../../scenes/strip-springback.toml")),
    Example::new("t-frame", 0.2, include_str!("../../../scenes/meshes/t-frame.toml")),
    Example::new("tensioned-plate", 0.5, include_str!("../../../scenes/tensioned-plate.toml")),
    Example::new("thick-ring", 0.1, include_str!("../../../scenes/thick-ring.toml")),
    Example::new("thick-ring-solid", 0.2, include_str!("../../../scenes/thick-ring-solid.toml")),
    Example::new("thin-ring", 35.0, include_str!("../../../scenes/thin-ring.toml")),
    Example::new("tied-rib", 0.1, include_str!("../../../scenes/meshes/tied-rib.toml")),
    Example::new("stiffened-plate", 0.2, include_str!("../../../scenes/stiffened-plate.toml")),
    Example::new("strip-cycled", 0.3, include_str!("../../../scenes/strip-cycled.toml")),
    Example::new("ring-struck", 0.3, include_str!("../../../scenes/ring-struck.toml")),
    Example::new("tube-crushed", 3.0, include_str!("../../../scenes/tube-crushed.toml")),
    Example::new("tube-hot", 0.5, include_str!("../../../scenes/tube-hot.toml")),
    Example::new("slab-cracked-hot", 0.5, include_str!("../../../scenes/slab-cracked-hot.toml")),
    Example::new("strip-cooled-bonds", 0.5, include_str!("../../../scenes/strip-cooled-bonds.toml")),
    Example::new("tube-inflating", 0.1, include_str!("../../../scenes/tube-inflating.toml")),
    Example::new("twisted-beam", 0.1, include_str!("../../../scenes/twisted-beam.toml")),
    Example::new("twisted-strip", 0.5, include_str!("../../../scenes/twisted-strip.toml")),
    Example::new("two-cantilevers", 3.0, include_str!("../../../scenes/two-cantilevers.toml")),
    Example::new("two-span-cases", 0.3, include_str!("../../../scenes/two-span-cases.toml")),
    Example::new("deck-in-quake", 5.0, include_str!("../../../scenes/deck-in-quake.toml")),
    Example::new("deck-by-spectrum", 0.3, include_str!("../../../scenes/deck-by-spectrum.toml")),
    Example::new("panel-in-noise", 1.0, include_str!("../../../scenes/panel-in-noise.toml")),
    Example::new("plate-in-water-modes", 0.3, include_str!("../../../scenes/plate-in-water-modes.toml")),
    Example::new("wave-flume", 15.0, include_str!("../../../scenes/wave-flume.toml")),
];

/// What is written beside an example on a mesh: the name of a file, and what it holds.
const FILES: [(&str, &str, &str); 19] = [
    (
        "balloon-inflating",
        "balloon-inflating.inp",
        include_str!("../../../scenes/meshes/balloon-inflating.inp"),
    ),
    ("balloon-pumped", "balloon-inflating.inp", include_str!("../../../scenes/meshes/balloon-inflating.inp")),
    ("cook-yielding", "cook-yielding.inp", include_str!("../../../scenes/meshes/cook-yielding.inp")),
    ("disc-yielding", "disc-yielding.inp", include_str!("../../../scenes/meshes/disc-yielding.inp")),
    ("flanged-bracket", "flanged-bracket.geo", include_str!("../../../scenes/meshes/flanged-bracket.geo")),
    ("open-hole", "open-hole.inp", include_str!("../../../scenes/meshes/open-hole.inp")),
    ("flanged-bracket", "flanged-bracket.msh", include_str!("../../../scenes/meshes/flanged-bracket.msh")),
    ("hollow-ball", "hollow-ball.obj", include_str!("../../../scenes/meshes/hollow-ball.obj")),
    ("hollow-ball-galerkin", "hollow-ball.obj", include_str!("../../../scenes/meshes/hollow-ball.obj")),
    ("hollow-ball-galerkin", "hollow-ball.py", include_str!("../../../scenes/meshes/hollow-ball.py")),
    ("hollow-ball", "hollow-ball.py", include_str!("../../../scenes/meshes/hollow-ball.py")),
    ("hub-turned", "hub-turned.inp", include_str!("../../../scenes/meshes/hub-turned.inp")),
    (
        "stiffened-panel-abaqus",
        "stiffened-panel-abaqus.inp",
        include_str!("../../../scenes/meshes/stiffened-panel-abaqus.inp"),
    ),
    (
        "stiffened-panel-gmsh",
        "stiffened-panel-gmsh.geo",
        include_str!("../../../scenes/meshes/stiffened-panel-gmsh.geo"),
    ),
    (
        "stiffened-panel-gmsh",
        "stiffened-panel-gmsh.msh",
        include_str!("../../../scenes/meshes/stiffened-panel-gmsh.msh"),
    ),
    (
        "floating-cylinder",
        "floating-cylinder.obj",
        include_str!("../../../scenes/meshes/floating-cylinder.obj"),
    ),
    ("wedge-entry", "wedge-entry.obj", include_str!("../../../scenes/meshes/wedge-entry.obj")),
    ("t-frame", "t-frame.msh", include_str!("../../../scenes/meshes/t-frame.msh")),
    ("tied-rib", "tied-rib.msh", include_str!("../../../scenes/meshes/tied-rib.msh")),
];

/// Lists the examples, or writes one.
pub fn carry_out(examples: &Examples) -> Result<(), Refused> {
    let Some(name) = &examples.name else {
        return print(&listed());
    };
    write(find(name)?, &PathBuf::from(format!("{name}.toml")))
}

/// The example of a name.
pub fn find(name: &str) -> Result<&'static Example, Refused> {
    let found = EXAMPLES.iter().find(|example| example.name == name);
    found.ok_or_else(|| format!("there is no example `{name}`; these are:\n{}", listed()).into())
}

/// What to do where a file is not there that is called like an example.
pub fn suggestion(file: &Path) -> Option<String> {
    let stem = file.file_stem()?.to_str()?;
    let known = EXAMPLES.iter().any(|example| example.name == stem);
    (known && !file.exists()).then(|| format!("`coque examples {stem}` writes {stem}.toml"))
}

/// Writes an example into a file that is not there yet, and its mesh beside it.
pub fn write(example: &Example, file: &Path) -> Result<(), Refused> {
    let name = example.name;
    let shown = file.display().to_string();
    let mut text = example.scene.replace(&format!("scenes/meshes/{name}.toml"), &shown);
    text = text.replace(&format!("scenes/{name}.toml"), &shown);
    write_meshes(name, file)?;
    for (_, beside, _) in FILES.iter().filter(|(known, ..)| *known == name) {
        text = text.replace(&format!("scenes/meshes/{beside}"), beside);
    }
    // The schema lies beside the scenes of the repository, not here.
    let lines = text.lines().filter(|line| !line.starts_with("#:schema"));
    let text: String = lines.map(|line| format!("{line}\n")).collect();
    write_new(file, &text)?;
    print(&format!("{shown}: look at it, then\n  coque check {shown}\n  coque run {shown} --view\n"))
}

/// Writes the files of the mesh of an example beside a scene; those that are there already stay.
pub fn write_meshes(name: &str, scene: &Path) -> Result<(), Refused> {
    for (_, file, held) in FILES.iter().filter(|(known, ..)| *known == name) {
        let file = scene.with_file_name(file);
        if !fs::read_to_string(&file).is_ok_and(|text| text == *held) {
            write_new(&file, held)?;
        }
    }
    Ok(())
}

/// Writes a file that is not there yet, whole or not at all.
pub fn write_new(file: &Path, text: &str) -> Result<(), Refused> {
    let shown = file.display();
    let refuse = |error: io::Error| match error.kind() {
        io::ErrorKind::AlreadyExists => format!("{shown} is there already; name another file\n"),
        _ => format!("cannot write {shown}: {error}\n"),
    };
    let mut to = OpenOptions::new().write(true).create_new(true).open(file).map_err(refuse)?;
    if let Err(error) = to.write_all(text.as_bytes()).and_then(|()| to.sync_all()) {
        // Half a template is none.
        let _ = fs::remove_file(file);
        return Err(refuse(error).into());
    }
    Ok(())
}

/// Seconds, name and title of each example.
pub fn listed() -> String {
    let title = |text| Scene::parse(text, "example").map_or(String::new(), |scene| scene.title.clone());
    let row = |Example { name, seconds, scene }: &Example| {
        format!("  {:>6} s  {name:<24} {}\n", seconds, title(scene))
    };
    EXAMPLES.iter().map(row).collect()
}

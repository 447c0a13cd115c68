//! `coque new`, `list`, `schema`: what a scene may say, and one to start from.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::{CatalogueEntry, Scene, catalogue, reference_page, schema_text};
use clap::Args;

use super::stderr::{Refused, print};

#[derive(Args)]
pub struct New {
    /// What to start from; without it, the templates are listed.
    template: Option<String>,
    /// Where to write it [default: TEMPLATE.toml].
    file: Option<PathBuf>,
}

pub const NEW_HELP: &str = "\
Examples:
  coque new                        the templates, a line each
  coque new plate                  writes plate.toml
  coque new ring roll-up.toml      writes roll-up.toml; then: coque check roll-up.toml";

#[derive(Args)]
pub struct List {
    /// Only this kind, such as loads or analyses.
    kind: Option<String>,
}

pub const LIST_HELP: &str = "\
Examples:
  coque list                       everything a scene may name
  coque list loads                 only loads
  coque list | grep -i pressure";

#[derive(Args)]
pub struct Schema {
    /// The page of all keys instead, in Markdown, with the table of what goes with which analysis.
    #[arg(long)]
    page: bool,
}

pub const SCHEMA_HELP: &str = "\
Editors with a TOML plug-in (taplo, Even Better TOML) complete and explain the keys of a scene:
  coque schema > schema.json
and in the first line of a scene beside it:
  #:schema schema.json";

/// The scenes of the repository, each a template.
const TEMPLATES: [(&str, &str); 49] = [
    ("baffle", include_str!("../../../scenes/baffle.toml")),
    ("cantilever-end-shear", include_str!("../../../scenes/cantilever-end-shear.toml")),
    ("cantilever-solid", include_str!("../../../scenes/cantilever-solid.toml")),
    ("clamped-cap", include_str!("../../../scenes/clamped-cap.toml")),
    ("column-buckling", include_str!("../../../scenes/column-buckling.toml")),
    ("crack-branching", include_str!("../../../scenes/crack-branching.toml")),
    ("cylinder-pressure", include_str!("../../../scenes/cylinder-pressure.toml")),
    ("dam-break", include_str!("../../../scenes/dam-break.toml")),
    ("flanged-bracket", include_str!("../../../scenes/meshes/flanged-bracket.toml")),
    ("gate", include_str!("../../../scenes/gate.toml")),
    ("gate-bonds", include_str!("../../../scenes/gate-bonds.toml")),
    ("heavy-end", include_str!("../../../scenes/heavy-end.toml")),
    ("hemisphere", include_str!("../../../scenes/hemisphere.toml")),
    ("kalthoff", include_str!("../../../scenes/kalthoff.toml")),
    ("open-cylinder", include_str!("../../../scenes/open-cylinder.toml")),
    ("panel", include_str!("../../../scenes/panel.toml")),
    ("panel-laminated", include_str!("../../../scenes/panel-laminated.toml")),
    ("panel-solid", include_str!("../../../scenes/panel-solid.toml")),
    ("patch-test", include_str!("../../../scenes/patch-test.toml")),
    ("pinched-cylinder", include_str!("../../../scenes/pinched-cylinder.toml")),
    ("pinched-cylinder-large", include_str!("../../../scenes/pinched-cylinder-large.toml")),
    ("plate", include_str!("../../../scenes/plate.toml")),
    ("plate-buckling", include_str!("../../../scenes/plate-buckling.toml")),
    ("plate-clamped", include_str!("../../../scenes/plate-clamped.toml")),
    ("plate-clamped-solid", include_str!("../../../scenes/plate-clamped-solid.toml")),
    ("plate-orthotropic", include_str!("../../../scenes/plate-orthotropic.toml")),
    ("plate-pd", include_str!("../../../scenes/plate-pd.toml")),
    ("plate-shortened", include_str!("../../../scenes/plate-shortened.toml")),
    ("plate-solid", include_str!("../../../scenes/plate-solid.toml")),
    ("pulled-strip", include_str!("../../../scenes/pulled-strip.toml")),
    ("relieved-strip", include_str!("../../../scenes/relieved-strip.toml")),
    ("ring", include_str!("../../../scenes/ring.toml")),
    ("ring-between-plates", include_str!("../../../scenes/ring-between-plates.toml")),
    ("ring-green-lagrange", include_str!("../../../scenes/ring-green-lagrange.toml")),
    ("ring-pressure", include_str!("../../../scenes/ring-pressure.toml")),
    ("scordelis-lo", include_str!("../../../scenes/scordelis-lo.toml")),
    ("shell-in-water", include_str!("../../../scenes/shell-in-water.toml")),
    ("stepped-plate", include_str!("../../../scenes/stepped-plate.toml")),
    ("stiffened-panel-abaqus", include_str!("../../../scenes/meshes/stiffened-panel-abaqus.toml")),
    ("stiffened-panel-gmsh", include_str!("../../../scenes/meshes/stiffened-panel-gmsh.toml")),
    ("strip-over-drum", include_str!("../../../scenes/strip-over-drum.toml")),
    ("t-frame", include_str!("../../../scenes/meshes/t-frame.toml")),
    ("tensioned-plate", include_str!("../../../scenes/tensioned-plate.toml")),
    ("thick-ring", include_str!("../../../scenes/thick-ring.toml")),
    ("thick-ring-solid", include_str!("../../../scenes/thick-ring-solid.toml")),
    ("thin-ring", include_str!("../../../scenes/thin-ring.toml")),
    ("tied-rib", include_str!("../../../scenes/meshes/tied-rib.toml")),
    ("twisted-beam", include_str!("../../../scenes/twisted-beam.toml")),
    ("twisted-strip", include_str!("../../../scenes/twisted-strip.toml")),
];

/// What is written beside a template on a mesh: the ending of its name, and what it holds.
const FILES: [(&str, &str, &str); 7] = [
    ("flanged-bracket", "geo", include_str!("../../../scenes/meshes/flanged-bracket.geo")),
    ("flanged-bracket", "msh", include_str!("../../../scenes/meshes/flanged-bracket.msh")),
    ("stiffened-panel-abaqus", "inp", include_str!("../../../scenes/meshes/stiffened-panel-abaqus.inp")),
    ("stiffened-panel-gmsh", "geo", include_str!("../../../scenes/meshes/stiffened-panel-gmsh.geo")),
    ("stiffened-panel-gmsh", "msh", include_str!("../../../scenes/meshes/stiffened-panel-gmsh.msh")),
    ("t-frame", "msh", include_str!("../../../scenes/meshes/t-frame.msh")),
    ("tied-rib", "msh", include_str!("../../../scenes/meshes/tied-rib.msh")),
];

/// Writes a scene to start from, or lists what there is.
pub fn new(new: &New) -> Result<(), Refused> {
    let Some(name) = &new.template else {
        return print(&templates());
    };
    let Some((_, text)) = TEMPLATES.iter().find(|(known, _)| known == name) else {
        return Err(format!("there is no template `{name}`; these are:\n{}", templates()).into());
    };
    let file = new.file.clone().unwrap_or_else(|| format!("{name}.toml").into());
    let shown = file.display().to_string();
    let mut text = text.replace(&format!("scenes/meshes/{name}.toml"), &shown);
    text = text.replace(&format!("scenes/{name}.toml"), &shown);
    for (_, ending, held) in FILES.iter().filter(|(known, ..)| known == name) {
        let beside = format!("{name}.{ending}");
        text = text.replace(&format!("scenes/meshes/{beside}"), &beside);
        write_new(&file.with_file_name(beside), held)?;
    }
    // The schema lies beside the scenes of the repository, not here.
    let lines = text.lines().filter(|line| !line.starts_with("#:schema"));
    let text: String = lines.map(|line| format!("{line}\n")).collect();
    write_new(&file, &text)?;
    print(&format!("{shown}: look at it, then\n  coque check {shown}\n  coque run {shown}\n"))
}

/// Writes a file that is not there yet, whole or not at all.
fn write_new(file: &Path, text: &str) -> Result<(), Refused> {
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

/// Name and title of each template.
fn templates() -> String {
    let title = |text| Scene::parse(text, "template").map_or(String::new(), |scene| scene.title.clone());
    table(TEMPLATES.iter().map(|(name, text)| (name.to_string(), title(text))))
}

/// Prints what a scene may name.
pub fn list(list: &List) -> Result<(), Refused> {
    let mut shelves = catalogue();
    if let Some(kind) = &list.kind {
        let known: Vec<&str> = shelves.iter().map(|shelf| shelf.name).collect();
        if !known.contains(&kind.as_str()) {
            return Err(format!("there is no kind `{kind}`; known here: {}\n", known.join(", ")).into());
        }
        shelves.retain(|shelf| shelf.name == kind);
    }
    let text: Vec<String> = shelves.into_iter().map(shown).collect();
    print(&text.join("\n"))
}

fn shown(shelf: CatalogueEntry) -> String {
    format!("{} ({})\n{}", shelf.name, shelf.place, table(shelf.entries.into_iter()))
}

/// Words and lines in two columns.
fn table(entries: impl Iterator<Item = (String, String)>) -> String {
    entries.map(|(word, line)| format!("  {word:<24} {line}\n")).collect()
}

/// Prints the schema, or the page of all keys.
pub fn schema(schema: &Schema) -> Result<(), Refused> {
    print(&if schema.page { reference_page() } else { schema_text() })
}

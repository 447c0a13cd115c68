//! `coque new`, `list`, `schema`: what a scene may say, and one to start from.

use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::{CatalogueEntry, catalogue, reference_page, schema_text};
use clap::Args;

use super::DONE;
use super::ask::{agreed, ask};
use super::company::Company;
use super::examples::{self, write_new};
use super::run::{self, Run};
use super::starter::What;
use super::stderr::{Refused, print, say};
use super::stop::Stop;

#[derive(Args)]
pub struct New {
    /// The example to start from; without it, three questions lead to a scene, or the examples are listed where there is no
    /// terminal.
    template: Option<String>,
    /// Where to write it [default: TEMPLATE.toml].
    file: Option<PathBuf>,
}

pub const NEW_HELP: &str = "\
Examples:
  coque new                        asks what it is made of, what is asked, in which units; writes a scene with comments
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

/// Writes a scene to start from: an example, or what questions lead to; without a terminal the examples are listed.
pub fn new(new: &New, stop: &Arc<Stop>, company: &Company) -> Result<u8, Refused> {
    if let Some(name) = &new.template {
        let example = examples::find(name)?;
        let file = new.file.clone().unwrap_or_else(|| format!("{name}.toml").into());
        return examples::write(example, &file).map(|()| DONE);
    }
    if !(io::stdin().is_terminal() && io::stderr().is_terminal()) {
        return print(&examples::listed()).map(|()| DONE);
    }
    let (mut from, mut to) = (io::stdin().lock(), io::stderr());
    let unheard = |error: io::Error| Refused::from(format!("cannot ask: {error}\n"));
    let starter = ask(&mut from, &mut to).map_err(unheard)?;
    let file = format!("{}.toml", starter.name());
    if starter.what == What::Mesh {
        examples::write_meshes(BRACKET, Path::new(&file))?;
    }
    write_new(Path::new(&file), &starter.scene(&file))?;
    say(&format!("{file} is written; what it models, and what a run will cost: coque check {file}"));
    if agreed("Run it now and look at it in the browser?", &mut from, &mut to).map_err(unheard)? {
        return run::carry_out(&Run::shown(file.into()), stop, company);
    }
    Ok(DONE)
}

/// The example whose mesh stands in for one's own.
const BRACKET: &str = "flanged-bracket";

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

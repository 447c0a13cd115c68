//! Formats of surfaces: each file of this folder reads one, and takes what stands there as it is. Which gives what is reported
//! in the table of the crate.

mod abaqus;
mod csv;
mod gmsh;
mod keyword;
mod obj;
mod ply;
mod shell_sections;
mod stl;
mod vtu;
mod words;

use std::path::Path;

use super::{MeshError, Surface};
use crate::input::read_bytes;

/// Longest file that is read \[bytes\]: ten million nodes and their faces as text.
const LONGEST: u64 = 1 << 32;

/// A format that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Gmsh `.msh`, ASCII.
    Gmsh,
    /// Abaqus `.inp`.
    Abaqus,
    /// STL, ASCII or binary.
    Stl,
    /// Wavefront OBJ.
    Obj,
    /// PLY, ASCII or binary.
    Ply,
    /// VTK unstructured grid in XML.
    Vtu,
    /// Points in CSV.
    Csv,
}

/// What a file is read for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Wanted {
    /// Sheets of faces.
    Sheets,
    /// Sheets that are to be tied: nodes may stand on foreign edges.
    Tied,
    /// The surface of a body.
    Body,
}

impl Format {
    /// Every format.
    pub const ALL: [Format; 7] =
        [Self::Gmsh, Self::Abaqus, Self::Stl, Self::Obj, Self::Ply, Self::Vtu, Self::Csv];

    /// Ending of its files.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Gmsh => "msh",
            Self::Abaqus => "inp",
            Self::Stl => "stl",
            Self::Obj => "obj",
            Self::Ply => "ply",
            Self::Vtu => "vtu",
            Self::Csv => "csv",
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gmsh => "Gmsh",
            Self::Abaqus => "Abaqus input",
            Self::Stl => "STL",
            Self::Obj => "Wavefront OBJ",
            Self::Ply => "PLY",
            Self::Vtu => "VTK unstructured grid",
            Self::Csv => "points in CSV",
        }
    }

    /// The format of a file, by its ending.
    ///
    /// # Errors
    /// [`MeshError`] for an ending that is not in the list.
    pub fn of(file: &Path) -> Result<Self, MeshError> {
        let ending = file.extension().and_then(|e| e.to_str()).unwrap_or_default().to_lowercase();
        Self::ALL.into_iter().find(|format| format.ending() == ending).ok_or_else(|| {
            let known = Self::ALL.map(|format| format!(".{}", format.ending())).join(", ");
            let what = format!("the ending \"{ending}\" is none of {known}");
            let repair = "convert it: meshio convert FILE surface.vtu --ascii, or write .msh from Gmsh";
            MeshError::whole(what, repair).named(&file.display().to_string())
        })
    }
}

/// Reads a surface from a file.
///
/// # Errors
/// [`MeshError`] for a file that cannot be read, is not of its format, or holds no sound surface.
pub fn read(file: &Path) -> Result<Surface, MeshError> {
    read_as(file, Wanted::Sheets)
}

/// The same of sheets that are to be tied: nodes may stand on edges that they do not belong to, see [`Surface::hanging`].
///
/// # Errors
/// As [`read`].
pub fn read_to_be_tied(file: &Path) -> Result<Surface, MeshError> {
    read_as(file, Wanted::Tied)
}

/// The surface of a body: of a file of tetrahedra what bounds them.
///
/// # Errors
/// As [`read`].
pub fn read_body(file: &Path) -> Result<Surface, MeshError> {
    read_as(file, Wanted::Body)
}

fn read_as(file: &Path, wanted: Wanted) -> Result<Surface, MeshError> {
    let name = file.display().to_string();
    let format = Format::of(file)?;
    let bytes = read_bytes(file, LONGEST).map_err(|error| {
        // Of the system the kind alone: its words differ from one to the other.
        let what = match error.raw_os_error() {
            Some(_) => format!("cannot be read: {}", error.kind()),
            None => format!("cannot be read: {error}"),
        };
        MeshError::whole(what, "check the path and the permissions").named(&name)
    })?;
    parse_as(&name, format, &bytes, wanted)
}

/// Reads a surface from the content of a file; `name` is for messages.
///
/// # Errors
/// [`MeshError`] for content that is not of the format, or holds no sound surface.
pub fn parse(name: &str, format: Format, bytes: &[u8]) -> Result<Surface, MeshError> {
    parse_as(name, format, bytes, Wanted::Sheets)
}

/// The same of the surface of a body, see [`read_body`].
///
/// # Errors
/// As [`parse`].
pub fn parse_body(name: &str, format: Format, bytes: &[u8]) -> Result<Surface, MeshError> {
    parse_as(name, format, bytes, Wanted::Body)
}

fn parse_as(name: &str, format: Format, bytes: &[u8], wanted: Wanted) -> Result<Surface, MeshError> {
    // Names in files come in all encodings; numbers do not.
    let text = || String::from_utf8_lossy(bytes);
    let raw = match format {
        Format::Gmsh => gmsh::parse(&text(), wanted == Wanted::Body),
        Format::Abaqus => abaqus::parse(&text()),
        Format::Stl => stl::parse(bytes),
        Format::Obj => obj::parse(&text()),
        Format::Ply => ply::parse(bytes),
        Format::Vtu => vtu::parse(&text()),
        Format::Csv => csv::parse(&text()),
    };
    let may_hang = wanted == Wanted::Tied;
    let surface =
        raw.and_then(|raw| Surface::new(raw, Some(format), may_hang)).map_err(|error| error.named(name))?;
    Ok(Surface { file: name.into(), checksum: crc32fast::hash(bytes), ..surface })
}

//! VTU: an unstructured grid of triangles and quadrangles in one piece, ASCII or inline base64, uncompressed.

use roxmltree::{Document, Node};

use crate::xml;

use super::MeshError;
use super::raw::Raw;
use super::words::shortened;

/// Numbers of a data array.
enum Numbers {
    Whole(Vec<i64>),
    Real(Vec<f64>),
}

/// Reads a text.
pub(super) fn parse(text: &str) -> Result<Raw, MeshError> {
    let document = xml::parsed(text).map_err(|error| {
        MeshError::at(error.line, error.what, "the file is cut off or damaged: write it again")
    })?;
    let file = File::open(&document)?;
    file.three_components()?;
    let points = file.array(file.piece("Points")?, None)?;
    let cells = file.piece("Cells")?;
    let connectivity = file.whole(cells, "connectivity")?;
    let offsets = file.whole(cells, "offsets")?;
    let types = file.whole(cells, "types")?;
    let mut raw = Raw::default();
    let points = points.real();
    if !points.len().is_multiple_of(3) {
        let what = format!("{} coordinates are no multiple of three", points.len());
        return Err(MeshError::whole(what, "the file is damaged: write it again"));
    }
    for (label, x) in (0..).zip(points.chunks_exact(3)) {
        raw.node(0, label, [x[0], x[1], x[2]])?;
    }
    file.promised("NumberOfPoints", points.len() / 3, "points")?;
    file.promised("NumberOfCells", types.len(), "cells")?;
    if offsets.len() != types.len() {
        let what = format!("{} offsets but {} types of cells", offsets.len(), types.len());
        return Err(MeshError::whole(what, "the file is damaged: write it again"));
    }
    let (mut start, mut other) = (0, 0);
    for (label, (&end, kind)) in (0..).zip(offsets.iter().zip(types)) {
        let corners =
            usize::try_from(end).ok().and_then(|end| connectivity.get(start..end)).ok_or_else(|| {
                let what = format!("cell {label} ends at {end} of {} entries", connectivity.len());
                MeshError::whole(what, "the file is damaged: write it again")
            })?;
        start = end as usize;
        match (kind, corners.len()) {
            (5, 3) | (9, 4) => {
                let mut nodes = Vec::new();
                for &corner in corners {
                    // A negative number names no point either.
                    let corner = u64::try_from(corner).unwrap_or(u64::MAX);
                    nodes.push(raw.find(0, &format!("cell {label}"), corner)?);
                }
                raw.face(0, label, &nodes)?;
            }
            (1..=4, _) => other += 1,
            _ => {
                let what = format!("cell {label} is of type {kind} with {} points", corners.len());
                let repair = "keep triangles (5) and quadrangles (9) only, such as with Extract Surface";
                return Err(MeshError::whole(what, repair));
            }
        }
    }
    if other > 0 {
        raw.notes.push(format!("points and lines, left out: {other}"));
    }
    file.point_data(&mut raw)?;
    // The lines of a table of numbers say nothing.
    raw.faces.iter_mut().for_each(|face| face.line = 0);
    Ok(raw)
}

/// Line of an element; only where it is told, as counting lines takes as long as the file.
fn line(node: Node) -> usize {
    node.document().text_pos_at(node.range().start).row as usize
}

/// An open document with what its header says.
struct File<'a, 'i> {
    piece: Node<'a, 'i>,
    /// Bytes of the number in front of a base64 block.
    header: usize,
}

impl<'a, 'i> File<'a, 'i> {
    fn open(document: &'a Document<'i>) -> Result<Self, MeshError> {
        let root = document.root_element();
        let refuse = |what: String, repair: &str| Err(MeshError::at(line(root), what, repair));
        let kind = root.attribute("type").unwrap_or("without type");
        if !root.has_tag_name("VTKFile") || kind != "UnstructuredGrid" {
            let what = format!(
                "<{}> {}; VTKFile UnstructuredGrid is read",
                shortened(root.tag_name().name()),
                shortened(kind)
            );
            return refuse(what, "write a .vtu file");
        }
        if let Some(compressor) = root.attribute("compressor") {
            let repair = "write it uncompressed: in meshio compression=None, in ParaView compressor None";
            return refuse(format!("compressed by {}", shortened(compressor)), repair);
        }
        if root.attribute("byte_order").is_some_and(|order| order != "LittleEndian") {
            return refuse("big-endian numbers".into(), "write it as ASCII, or little-endian");
        }
        let header = match root.attribute("header_type") {
            Some("UInt64") => 8,
            Some("UInt32") | None => 4,
            Some(other) => {
                return refuse(format!("header_type {}", shortened(other)), "use UInt32 or UInt64");
            }
        };
        let pieces: Vec<Node<'a, 'i>> = document.descendants().filter(|n| n.has_tag_name("Piece")).collect();
        match pieces[..] {
            [piece] => Ok(Self { piece, header }),
            _ => refuse(format!("{} pieces; one is read", pieces.len()), "merge the blocks into one piece"),
        }
    }

    fn piece(&self, name: &str) -> Result<Node<'a, 'i>, MeshError> {
        let found = self.piece.children().find(|node| node.has_tag_name(name));
        let what = || format!("the piece has no <{name}>");
        found.ok_or_else(|| MeshError::at(line(self.piece), what(), "write the file again"))
    }

    /// Refuses a count of the heading that is not that of the data.
    fn promised(&self, name: &str, found: usize, what: &str) -> Result<(), MeshError> {
        let Some(count) = self.piece.attribute(name) else { return Ok(()) };
        if count.trim().parse() == Ok(found) {
            return Ok(());
        }
        let what = format!("{name} is {}, but {found} {what} are there", shortened(count));
        Err(MeshError::at(line(self.piece), what, "the file is cut off or damaged: write it again"))
    }

    /// Refuses points that are not in space.
    fn three_components(&self) -> Result<(), MeshError> {
        let points = self.piece("Points")?;
        let array = points.children().find(|node| node.has_tag_name("DataArray"));
        match array.and_then(|array| Some((array, array.attribute("NumberOfComponents")?))) {
            Some((array, count)) if count.trim() != "3" => {
                let what = format!("points have {} components; they must have 3", shortened(count));
                Err(MeshError::at(line(array), what, "write the file again, in space"))
            }
            _ => Ok(()),
        }
    }

    fn whole(&self, parent: Node<'a, 'i>, name: &str) -> Result<Vec<i64>, MeshError> {
        match self.array(parent, Some(name))? {
            Numbers::Whole(values) => Ok(values),
            Numbers::Real(_) => Err(MeshError::at(
                line(parent),
                format!("array {name} has reals; whole numbers are needed"),
                "write the file again",
            )),
        }
    }

    /// The array of a name, or the first one.
    fn array(&self, parent: Node<'a, 'i>, name: Option<&str>) -> Result<Numbers, MeshError> {
        let fits = |node: &Node<'a, 'i>| {
            node.has_tag_name("DataArray") && (name.is_none() || node.attribute("Name") == name)
        };
        let found = parent.children().find(fits).ok_or_else(|| {
            let what = format!("<{}> has no array {}", parent.tag_name().name(), name.unwrap_or_default());
            MeshError::at(line(parent), what, "write the file again")
        })?;
        self.numbers(found)
    }

    fn numbers(&self, array: Node<'a, 'i>) -> Result<Numbers, MeshError> {
        let line = || line(array);
        let kind = array.attribute("type").unwrap_or_default();
        let text = array.text().unwrap_or_default();
        let name = shortened(array.attribute("Name").unwrap_or("Points"));
        match array.attribute("format").unwrap_or("ascii") {
            "ascii" => ascii(kind, text).ok_or_else(|| {
                let what = format!("array {name} has a word that is no {} number", shortened(kind));
                MeshError::at(line(), what, "write the file again")
            }),
            "binary" => {
                let bytes = decode(text).filter(|bytes| bytes.len() >= self.header);
                let block = bytes.as_ref().map(|bytes| bytes.split_at(self.header));
                let block = block.filter(|(length, data)| unsigned(length) == data.len() as u64);
                block.and_then(|(_, data)| binary(kind, data)).ok_or_else(|| {
                    let what = format!("array {name} is not inline base64 of {} numbers", shortened(kind));
                    MeshError::at(
                        line(),
                        what,
                        "write the file again, as ASCII or uncompressed inline base64",
                    )
                })
            }
            other => {
                let what =
                    format!("array {name} is stored as {}; ascii and binary are read", shortened(other));
                Err(MeshError::at(
                    line(),
                    what,
                    "write the data inline, not appended: in ParaView data mode Binary",
                ))
            }
        }
    }

    /// Three reals called Normals are the normals; whole numbers that are all 0 or 1 mark a set.
    fn point_data(&self, raw: &mut Raw) -> Result<(), MeshError> {
        let Ok(data) = self.piece("PointData") else { return Ok(()) };
        for array in data.children().filter(|node| node.has_tag_name("DataArray")) {
            let name = array.attribute("Name").unwrap_or_default();
            let components = array.attribute("NumberOfComponents").unwrap_or("1");
            let whole = array.attribute("type").is_some_and(|kind| kind.contains("Int"));
            let normals = ["normals", "normal"].contains(&name.to_lowercase().as_str()) && components == "3";
            let mark = whole && components == "1" && !name.is_empty();
            if !(normals || mark) {
                continue;
            }
            let values = self.numbers(array)?;
            let count = raw.positions.len();
            match values {
                Numbers::Real(values) if normals && values.len() == 3 * count => {
                    let vectors = values.chunks_exact(3).map(|n| [n[0], n[1], n[2]].into());
                    raw.normals = (0..).zip(vectors).collect();
                }
                Numbers::Whole(marks) if marks.len() == count && marks.iter().all(|m| [0, 1].contains(m)) => {
                    let marked = (0..).zip(marks).filter(|(_, mark)| *mark == 1);
                    raw.add_to_set(name, &marked.map(|(node, _)| node).collect::<Vec<u32>>());
                }
                _ => {}
            }
        }
        Ok(())
    }
}

impl Numbers {
    fn real(self) -> Vec<f64> {
        match self {
            Self::Real(values) => values,
            Self::Whole(values) => values.into_iter().map(|value| value as f64).collect(),
        }
    }
}

fn ascii(kind: &str, text: &str) -> Option<Numbers> {
    let words = text.split_whitespace();
    if kind.starts_with("Float") {
        let finite = |word: &str| word.parse().ok().filter(|x: &f64| x.is_finite());
        words.map(finite).collect::<Option<_>>().map(Numbers::Real)
    } else {
        words.map(|word| word.parse().ok()).collect::<Option<_>>().map(Numbers::Whole)
    }
}

fn binary(kind: &str, data: &[u8]) -> Option<Numbers> {
    let finite = |x: f64| Some(x).filter(|x| x.is_finite());
    let size = match kind {
        "Int8" | "UInt8" => 1,
        "Int16" | "UInt16" => 2,
        "Int32" | "UInt32" | "Float32" => 4,
        "Int64" | "UInt64" | "Float64" => 8,
        _ => return None,
    };
    if !data.len().is_multiple_of(size) {
        return None;
    }
    let chunks = data.chunks_exact(size);
    match kind {
        "Float64" => chunks
            .map(|b| finite(f64::from_le_bytes(b.try_into().ok()?)))
            .collect::<Option<_>>()
            .map(Numbers::Real),
        "Float32" => {
            let value = |b: &[u8]| finite(f64::from(f32::from_le_bytes(b.try_into().ok()?)));
            chunks.map(value).collect::<Option<_>>().map(Numbers::Real)
        }
        _ => {
            let spare = 64 - 8 * size as u32;
            let value = |b: &[u8]| match kind.starts_with('U') {
                true => i64::try_from(unsigned(b)).ok(),
                // Shifted to the top and back: the sign goes with it.
                false => Some(((unsigned(b) << spare) as i64) >> spare),
            };
            chunks.map(value).collect::<Option<_>>().map(Numbers::Whole)
        }
    }
}

/// A whole number of up to eight bytes, least significant first.
fn unsigned(bytes: &[u8]) -> u64 {
    bytes.iter().rev().fold(0, |value, &b| (value << 8) | u64::from(b))
}

/// Bytes of a base64 text; blanks are passed over, and padding ends a block.
fn decode(text: &str) -> Option<Vec<u8>> {
    let (mut bytes, mut bits, mut held) = (Vec::new(), 0u32, 0);
    for c in text.bytes().filter(|c| !c.is_ascii_whitespace()) {
        let value = match c {
            b'A'..=b'Z' => c - b'A',
            b'a'..=b'z' => c - b'a' + 26,
            b'0'..=b'9' => c - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            b'=' => {
                // The header may be a block of its own, with its own padding.
                (bits, held) = (0, 0);
                continue;
            }
            _ => return None,
        };
        bits = (bits << 6) | u32::from(value);
        held += 6;
        if held >= 8 {
            held -= 8;
            bytes.push((bits >> held) as u8);
            bits &= (1 << held) - 1;
        }
    }
    Some(bytes)
}

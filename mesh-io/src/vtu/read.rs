//! VTU read: one piece, ASCII or inline base64, uncompressed; what surfaces and frames have in common.

use roxmltree::{Document, Node};

use super::xml::XmlError;
use crate::input::shortened;

/// Numbers of a data array.
#[derive(Clone, Debug)]
pub(crate) enum Numbers {
    /// Of a type of whole numbers.
    Whole(Vec<i64>),
    /// Of a type of reals.
    Real(Vec<f64>),
}

/// An open document with what its header says.
pub(crate) struct Grid<'a, 'i> {
    piece: Node<'a, 'i>,
    /// Bytes of the number in front of a base64 block.
    header: usize,
    /// Which reals are read.
    accepts: fn(f64) -> bool,
}

/// Points, and the cells between them.
pub(crate) struct Geometry {
    coordinates: Vec<f64>,
    connectivity: Vec<i64>,
    /// Where the points of each cell end; they ascend within the connectivity.
    ends: Vec<usize>,
    kinds: Vec<i64>,
}

impl Geometry {
    /// Positions \[L\].
    pub fn points(&self) -> &[[f64; 3]] {
        self.coordinates.as_chunks().0
    }

    /// The kind of each cell, as VTK numbers it, and its points, which may be none of the file.
    pub fn cells(&self) -> impl Iterator<Item = (i64, &[i64])> {
        let starts = std::iter::once(&0).chain(&self.ends);
        let ranges = starts.zip(&self.ends).map(|(&start, &end)| &self.connectivity[start..end]);
        self.kinds.iter().copied().zip(ranges)
    }
}

impl<'a, 'i> Grid<'a, 'i> {
    /// Opens a document; a real that is not accepted is refused wherever it stands.
    pub fn open(document: &'a Document<'i>, accepts: fn(f64) -> bool) -> Result<Self, XmlError> {
        let root = document.root_element();
        let refuse = |what: String, repair| Err(XmlError::at(root, what, repair));
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
            [piece] => Ok(Self { piece, header, accepts }),
            _ => refuse(format!("{} pieces; one is read", pieces.len()), "merge the blocks into one piece"),
        }
    }

    /// Points and cells, as many as the heading promises.
    pub fn geometry(&self) -> Result<Geometry, XmlError> {
        const DAMAGED: &str = "the file is damaged: write it again";
        self.three_components()?;
        let coordinates = self.array(self.piece("Points")?, None)?.real();
        let cells = self.piece("Cells")?;
        let connectivity = self.whole(cells, "connectivity")?;
        let offsets = self.whole(cells, "offsets")?;
        let kinds = self.whole(cells, "types")?;
        if !coordinates.len().is_multiple_of(3) {
            let what = format!("{} coordinates are no multiple of three", coordinates.len());
            return Err(XmlError::whole(what, DAMAGED));
        }
        self.promised("NumberOfPoints", coordinates.len() / 3, "points")?;
        self.promised("NumberOfCells", kinds.len(), "cells")?;
        if offsets.len() != kinds.len() {
            let what = format!("{} offsets but {} types of cells", offsets.len(), kinds.len());
            return Err(XmlError::whole(what, DAMAGED));
        }
        let mut start = 0;
        let end_of = |(label, &end): (usize, &i64)| {
            let found = usize::try_from(end).ok().filter(|end| (start..=connectivity.len()).contains(end));
            start = found.ok_or_else(|| {
                let what = format!("cell {label} ends at {end} of {} entries", connectivity.len());
                XmlError::whole(what, DAMAGED)
            })?;
            Ok(start)
        };
        let ends = offsets.iter().enumerate().map(end_of).collect::<Result<_, XmlError>>()?;
        Ok(Geometry { coordinates, connectivity, ends, kinds })
    }

    /// The arrays of a section, `PointData` or `CellData`; none where it is not there.
    pub fn arrays(&self, section: &str) -> impl Iterator<Item = Node<'a, 'i>> {
        let section = self.piece(section).ok();
        let nodes = section.into_iter().flat_map(|section| section.children());
        nodes.filter(|node| node.has_tag_name("DataArray"))
    }

    /// The arrays of the whole frame.
    pub fn arrays_of_frame(&self) -> impl Iterator<Item = Node<'a, 'i>> {
        let beside = self.piece.parent().into_iter().flat_map(|grid| grid.children());
        let section = beside.filter(|node| node.has_tag_name("FieldData"));
        section.flat_map(|section| section.children()).filter(|node| node.has_tag_name("DataArray"))
    }

    fn piece(&self, name: &str) -> Result<Node<'a, 'i>, XmlError> {
        let found = self.piece.children().find(|node| node.has_tag_name(name));
        let what = || format!("the piece has no <{name}>");
        found.ok_or_else(|| XmlError::at(self.piece, what(), "write the file again"))
    }

    /// Refuses a count of the heading that is not that of the data.
    fn promised(&self, name: &str, found: usize, what: &str) -> Result<(), XmlError> {
        let Some(count) = self.piece.attribute(name) else { return Ok(()) };
        if count.trim().parse() == Ok(found) {
            return Ok(());
        }
        let what = format!("{name} is {}, but {found} {what} are there", shortened(count));
        Err(XmlError::at(self.piece, what, "the file is cut off or damaged: write it again"))
    }

    /// Refuses points that are not in space.
    fn three_components(&self) -> Result<(), XmlError> {
        let points = self.piece("Points")?;
        let array = points.children().find(|node| node.has_tag_name("DataArray"));
        match array.and_then(|array| Some((array, array.attribute("NumberOfComponents")?))) {
            Some((array, count)) if count.trim() != "3" => {
                let what = format!("points have {} components; they must have 3", shortened(count));
                Err(XmlError::at(array, what, "write the file again, in space"))
            }
            _ => Ok(()),
        }
    }

    fn whole(&self, parent: Node<'a, 'i>, name: &str) -> Result<Vec<i64>, XmlError> {
        match self.array(parent, Some(name))? {
            Numbers::Whole(values) => Ok(values),
            Numbers::Real(_) => Err(XmlError::at(
                parent,
                format!("array {name} has reals; whole numbers are needed"),
                "write the file again",
            )),
        }
    }

    /// The array of a name, or the first one.
    fn array(&self, parent: Node<'a, 'i>, name: Option<&str>) -> Result<Numbers, XmlError> {
        let fits = |node: &Node<'a, 'i>| {
            node.has_tag_name("DataArray") && (name.is_none() || node.attribute("Name") == name)
        };
        let found = parent.children().find(fits).ok_or_else(|| {
            let what = format!("<{}> has no array {}", parent.tag_name().name(), name.unwrap_or_default());
            XmlError::at(parent, what, "write the file again")
        })?;
        self.numbers(found)
    }

    /// The numbers of an array.
    pub fn numbers(&self, array: Node<'a, 'i>) -> Result<Numbers, XmlError> {
        let kind = array.attribute("type").unwrap_or_default();
        let text = array.text().unwrap_or_default();
        let name = shortened(array.attribute("Name").unwrap_or("Points"));
        match array.attribute("format").unwrap_or("ascii") {
            "ascii" => self.ascii(kind, text).ok_or_else(|| {
                let what = format!("array {name} has a word that is no {} number", shortened(kind));
                XmlError::at(array, what, "write the file again")
            }),
            "binary" => {
                let bytes = decode(text).filter(|bytes| bytes.len() >= self.header);
                let block = bytes.as_ref().map(|bytes| bytes.split_at(self.header));
                let block = block.filter(|(length, data)| unsigned(length) == data.len() as u64);
                block.and_then(|(_, data)| self.binary(kind, data)).ok_or_else(|| {
                    let what = format!("array {name} is not inline base64 of {} numbers", shortened(kind));
                    XmlError::at(array, what, "write the file again, as ASCII or uncompressed inline base64")
                })
            }
            other => {
                let what =
                    format!("array {name} is stored as {}; ascii and binary are read", shortened(other));
                Err(XmlError::at(
                    array,
                    what,
                    "write the data inline, not appended: in ParaView data mode Binary",
                ))
            }
        }
    }

    fn ascii(&self, kind: &str, text: &str) -> Option<Numbers> {
        let words = text.split_whitespace();
        if kind.starts_with("Float") {
            let real = |word: &str| word.parse().ok().filter(|&x| (self.accepts)(x));
            words.map(real).collect::<Option<_>>().map(Numbers::Real)
        } else {
            words.map(|word| word.parse().ok()).collect::<Option<_>>().map(Numbers::Whole)
        }
    }

    fn binary(&self, kind: &str, data: &[u8]) -> Option<Numbers> {
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
        let accepted = |x: f64| Some(x).filter(|&x| (self.accepts)(x));
        let chunks = data.chunks_exact(size);
        match kind {
            "Float64" => chunks
                .map(|b| accepted(f64::from_le_bytes(b.try_into().ok()?)))
                .collect::<Option<_>>()
                .map(Numbers::Real),
            "Float32" => {
                let value = |b: &[u8]| accepted(f32::from_le_bytes(b.try_into().ok()?).into());
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
}

impl Numbers {
    /// As reals.
    pub fn real(self) -> Vec<f64> {
        match self {
            Self::Real(values) => values,
            Self::Whole(values) => values.into_iter().map(|value| value as f64).collect(),
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

//! PLY, ASCII and binary in either order of bytes: vertices with their normals, faces of three or four corners.

use sph_core::Vec3;

use super::words::Words;
use crate::input::shortened;
use crate::surface::MeshError;
use crate::surface::raw::Raw;

/// What to do about a broken header.
const WRITE_AGAIN: &str = "the file is damaged, or not PLY: write it again";

/// How a number is written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// A whole number of so many bytes, with a sign or not.
    Whole(usize, bool),
    /// Single or double precision, by bytes.
    Real(usize),
}

/// A property of an element: a number, or a list with the kind of its length.
struct Property<'a> {
    name: &'a str,
    length: Option<Kind>,
    kind: Kind,
}

/// Things of one kind, such as vertices.
struct Element<'a> {
    name: &'a str,
    count: u64,
    properties: Vec<Property<'a>>,
}

/// Numbers of the body of a file.
enum Numbers<'a> {
    Text(Words<'a>),
    /// What is left, and whether the high byte comes first.
    Bytes(&'a [u8], bool),
}

/// Reads the bytes of a file.
pub(super) fn parse(bytes: &[u8]) -> Result<Raw, MeshError> {
    let (header, body) = cut(bytes)?;
    let lines = header.lines().count();
    let (format, elements) = elements(&header)?;
    let text;
    let mut numbers = match format {
        "ascii" => {
            text = String::from_utf8_lossy(body);
            let mut words = Words::new(&text);
            words.line = lines + 1;
            Numbers::Text(words)
        }
        "binary_little_endian" => Numbers::Bytes(body, false),
        "binary_big_endian" => Numbers::Bytes(body, true),
        other => {
            let what = format!(
                "format \"{}\"; ascii, binary_little_endian and binary_big_endian are read",
                shortened(other)
            );
            return Err(MeshError::at(2, what, WRITE_AGAIN));
        }
    };
    let mut raw = Raw::default();
    for element in &elements {
        for number in 0..element.count {
            let row = element.row(number, &mut numbers)?;
            match element.name {
                "vertex" => vertex(&mut raw, element, &row, numbers.line())?,
                "face" => face(&mut raw, element, number, &row, numbers.line())?,
                _ => {}
            }
        }
    }
    Ok(raw)
}

/// The header as text, and what follows it.
fn cut(bytes: &[u8]) -> Result<(String, &[u8]), MeshError> {
    const END: &[u8] = b"end_header";
    let end = bytes.windows(END.len()).position(|word| word == END);
    let Some(end) = end.filter(|_| bytes.starts_with(b"ply")) else {
        return Err(MeshError::whole(
            "the file does not begin with a header from ply to end_header",
            WRITE_AGAIN,
        ));
    };
    let header = String::from_utf8_lossy(&bytes[..end + END.len()]).into_owned();
    let rest = &bytes[end + END.len()..];
    let begin = rest.iter().position(|&byte| byte == b'\n').map_or(rest.len(), |line| line + 1);
    Ok((header, &rest[begin..]))
}

/// The format and the elements that a header declares.
fn elements(header: &str) -> Result<(&str, Vec<Element<'_>>), MeshError> {
    let (mut format, mut elements) = ("", Vec::<Element<'_>>::new());
    for (line, text) in (1..).zip(header.lines()) {
        let words: Vec<&str> = text.split_whitespace().collect();
        let broken = || {
            let what = format!("\"{}\" is no line of a header", shortened(text.trim()));
            MeshError::at(line, what, WRITE_AGAIN)
        };
        match words[..] {
            [] | ["ply" | "comment" | "obj_info" | "end_header", ..] => {}
            ["format", name, ..] => format = name,
            ["element", name, count] => {
                let count = count.parse().map_err(|_| broken())?;
                elements.push(Element { name, count, properties: Vec::new() });
            }
            ["property", ref rest @ ..] => {
                let property =
                    match *rest {
                        ["list", length, of, name] => kind(length)
                            .zip(kind(of))
                            .map(|(length, kind)| Property { name, length: Some(length), kind }),
                        [of, name] => kind(of).map(|kind| Property { name, length: None, kind }),
                        _ => None,
                    };
                elements.last_mut().ok_or_else(broken)?.properties.push(property.ok_or_else(broken)?);
            }
            _ => return Err(broken()),
        }
    }
    // One of no numbers would be read without end.
    elements.retain(|element| !element.properties.is_empty());
    Ok((format, elements))
}

fn kind(word: &str) -> Option<Kind> {
    Some(match word {
        "char" | "int8" => Kind::Whole(1, true),
        "uchar" | "uint8" => Kind::Whole(1, false),
        "short" | "int16" => Kind::Whole(2, true),
        "ushort" | "uint16" => Kind::Whole(2, false),
        "int" | "int32" => Kind::Whole(4, true),
        "uint" | "uint32" => Kind::Whole(4, false),
        "float" | "float32" => Kind::Real(4),
        "double" | "float64" => Kind::Real(8),
        _ => return None,
    })
}

impl Element<'_> {
    /// The numbers of one thing, by property.
    fn row(&self, number: u64, numbers: &mut Numbers<'_>) -> Result<Vec<Vec<f64>>, MeshError> {
        let read = |property: &Property<'_>| {
            let what = || format!("{} of {} {number}", property.name, self.name);
            let count = match property.length {
                None => 1,
                Some(kind) => numbers.next(kind, &what)? as u64,
            };
            let mut list = Vec::new();
            for _ in 0..count {
                list.push(numbers.next(property.kind, &what)?);
            }
            Ok(list)
        };
        self.properties.iter().map(read).collect()
    }

    /// One number of each property of these names.
    fn vector(&self, row: &[Vec<f64>], names: [&str; 3]) -> Option<[f64; 3]> {
        let mut out = [0.0; 3];
        for (slot, name) in out.iter_mut().zip(names) {
            let place = self
                .properties
                .iter()
                .position(|property| property.name == name && property.length.is_none())?;
            *slot = *row.get(place)?.first()?;
        }
        Some(out)
    }
}

fn vertex(raw: &mut Raw, element: &Element<'_>, row: &[Vec<f64>], line: usize) -> Result<(), MeshError> {
    let Some(place) = element.vector(row, ["x", "y", "z"]) else {
        return Err(MeshError::at(line, "vertices have no properties x, y and z", WRITE_AGAIN));
    };
    let label = raw.positions.len() as u64;
    let node = raw.node(line, label, place)?;
    if let Some(normal) = element.vector(row, ["nx", "ny", "nz"]) {
        raw.normals.insert(node, Vec3::from(normal));
    }
    Ok(())
}

fn face(
    raw: &mut Raw,
    element: &Element<'_>,
    number: u64,
    row: &[Vec<f64>],
    line: usize,
) -> Result<(), MeshError> {
    let of_corners = |property: &Property<'_>| ["vertex_indices", "vertex_index"].contains(&property.name);
    let Some(corners) = element.properties.iter().position(of_corners).and_then(|place| row.get(place))
    else {
        return Err(MeshError::at(line, "faces have no list vertex_indices", WRITE_AGAIN));
    };
    let user = format!("face {number}");
    let mut nodes = Vec::with_capacity(4);
    for &corner in corners {
        // What is below zero is above every number.
        let label = if corner < 0.0 { u64::MAX } else { corner as u64 };
        nodes.push(raw.find(line, &user, label)?);
    }
    raw.face(line, number, &nodes)
}

impl Numbers<'_> {
    /// The line of the last word; zero in bytes.
    fn line(&self) -> usize {
        match self {
            Self::Text(words) => words.line,
            Self::Bytes(..) => 0,
        }
    }

    fn next(&mut self, kind: Kind, what: &dyn Fn() -> String) -> Result<f64, MeshError> {
        let (bytes, high_first) = match self {
            Self::Text(words) => return words.float(&what()),
            Self::Bytes(bytes, high_first) => (bytes, *high_first),
        };
        let (Kind::Whole(width, _) | Kind::Real(width)) = kind;
        let Some((own, rest)) = bytes.split_at_checked(width) else {
            let what = format!("the file ends where {} should stand", what());
            return Err(MeshError::whole(what, "the file is cut off: write it again"));
        };
        *bytes = rest;
        let mut low_first = [0; 8];
        low_first[..width].copy_from_slice(own);
        if high_first {
            low_first[..width].reverse();
        }
        let number = u64::from_le_bytes(low_first);
        let value = match kind {
            Kind::Real(4) => f64::from(f32::from_bits(number as u32)),
            Kind::Real(_) => f64::from_bits(number),
            Kind::Whole(_, false) => number as f64,
            Kind::Whole(width, true) => {
                let unused = 64 - 8 * width as u32;
                ((number << unused) as i64 >> unused) as f64
            }
        };
        if value.is_finite() {
            return Ok(value);
        }
        Err(MeshError::whole(format!("{} is {value}", what()), "the file is damaged: write it again"))
    }
}

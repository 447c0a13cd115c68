//! STL, ASCII and binary: loose triangles whose equal vertices are merged.

use std::collections::HashMap;

use sph_core::Vec3;

use super::words::Words;
use crate::input::shortened;
use crate::surface::MeshError;
use crate::surface::raw::{Raw, counted};

/// Vertices closer than this part of the extent are one: a few roundings of single precision.
const SAME: f64 = 1e-6;

/// Bytes before the triangles, and of one triangle.
const HEADER: usize = 84;
const RECORD: usize = 50;

/// A triangle as it stands in the file.
struct Loose {
    corners: [[f64; 3]; 3],
    line: usize,
    /// Number of its solid.
    solid: usize,
}

/// Reads the bytes of a file.
pub(super) fn parse(bytes: &[u8]) -> Result<Raw, MeshError> {
    let count = bytes.get(80..HEADER).and_then(|b| b.try_into().ok()).map(u32::from_le_bytes);
    let whole = count.map(|count| HEADER + count as usize * RECORD);
    let ascii = bytes.trim_ascii_start().starts_with(b"solid");
    match (count, whole) {
        // Some writers begin binary files with "solid": only the length tells.
        (Some(_), Some(whole)) if whole == bytes.len() => merged(&binary(bytes)?, &[]),
        _ if ascii => {
            let text = String::from_utf8_lossy(bytes);
            let (triangles, names) = ascii_triangles(&text)?;
            merged(&triangles, &names)
        }
        (Some(count), Some(whole)) => {
            let what = format!(
                "{count} triangles make {whole} bytes, the file has {}; nor does it begin with \"solid\"",
                bytes.len()
            );
            Err(MeshError::whole(what, "the file is cut off, or not STL: write it again"))
        }
        _ => {
            let what = "too short for binary STL, and it does not begin with \"solid\"";
            Err(MeshError::whole(what, "the file is cut off, or not STL: write it again"))
        }
    }
}

fn binary(bytes: &[u8]) -> Result<Vec<Loose>, MeshError> {
    let mut triangles = Vec::new();
    for (t, record) in bytes[HEADER..].chunks_exact(RECORD).enumerate() {
        // Normal, three vertices, attributes; the order of the vertices says what the normal does.
        let mut numbers = record[12..48].chunks_exact(4).map(|b| {
            let x = f32::from_le_bytes([b[0], b[1], b[2], b[3]]);
            if x.is_finite() {
                return Ok(f64::from(x));
            }
            let what = format!("triangle {} has a coordinate that is {x}", t + 1);
            Err(MeshError::whole(what, "the file is damaged: write it again"))
        });
        let mut corners = [[0.0; 3]; 3];
        for (slot, number) in corners.as_flattened_mut().iter_mut().zip(&mut numbers) {
            *slot = number?;
        }
        triangles.push(Loose { corners, line: 0, solid: 0 });
    }
    Ok(triangles)
}

fn ascii_triangles(text: &str) -> Result<(Vec<Loose>, Vec<String>), MeshError> {
    let mut words = Words::new(text);
    let (mut triangles, mut names) = (Vec::new(), Vec::new());
    while let Some(word) = words.next() {
        match word {
            "solid" => names.push(words.rest_of_line().to_string()),
            "endsolid" => {
                words.rest_of_line();
            }
            "facet" => {
                let line = words.line;
                let mut corners = [[0.0; 3]; 3];
                expect(&mut words, "normal")?;
                words.rest_of_line(); // some writers put "nan" there
                expect(&mut words, "outer")?;
                expect(&mut words, "loop")?;
                for corner in &mut corners {
                    expect(&mut words, "vertex")?;
                    *corner = words.vector("a coordinate of a vertex")?;
                }
                expect(&mut words, "endloop")?;
                expect(&mut words, "endfacet")?;
                triangles.push(Loose { corners, line, solid: names.len().saturating_sub(1) });
            }
            _ => {
                let what = format!("\"{}\" stands where facet or endsolid should", shortened(word));
                return Err(MeshError::at(
                    words.line,
                    what,
                    "facets have three vertices; write the file again",
                ));
            }
        }
    }
    Ok((triangles, names))
}

fn expect(words: &mut Words<'_>, expected: &str) -> Result<(), MeshError> {
    let word = words.word(expected)?;
    if word == expected {
        return Ok(());
    }
    let what = format!("\"{}\" stands where \"{expected}\" should", shortened(word));
    Err(MeshError::at(words.line, what, "facets have three vertices; write the file again"))
}

/// One node for all vertices that coincide; triangles that collapse in this are left out.
fn merged(triangles: &[Loose], names: &[String]) -> Result<Raw, MeshError> {
    let mut raw = Raw::default();
    let mut exact: HashMap<[u64; 3], u32> = HashMap::new();
    let mut corners: Vec<[u32; 3]> = Vec::new();
    for triangle in triangles {
        let mut nodes = [0; 3];
        for (node, x) in nodes.iter_mut().zip(triangle.corners) {
            // Adding zero makes −0 and 0 one.
            let key = x.map(|c| (c + 0.0).to_bits());
            *node = match exact.get(&key) {
                Some(&node) => node,
                None => {
                    let node = raw.push(triangle.line, x)?;
                    exact.insert(key, node);
                    node
                }
            };
        }
        corners.push(nodes);
    }
    let first = representatives(&raw.positions);
    let near = first.iter().zip(0..).filter(|(first, node)| **first != *node).count();
    let mut collapsed = 0;
    for ((number, triangle), nodes) in (1..).zip(triangles).zip(corners) {
        let [a, b, c] = nodes.map(|node| first[node as usize]);
        if a == b || b == c || c == a {
            collapsed += 1;
            continue;
        }
        raw.face(triangle.line, number, &[a, b, c])?;
        // A single solid is the whole surface, not a part of it.
        if let Some(name) = names.get(triangle.solid).filter(|name| names.len() > 1 && !name.is_empty()) {
            raw.add_faces_to_set(name, &[raw.faces.len() as u32 - 1]);
        }
    }
    let vertices = 3 * triangles.len();
    let nodes = first.iter().zip(0..).filter(|(first, node)| **first == *node).count();
    raw.notes.push(format!("{vertices} vertices merged into {}", counted(nodes, "node")));
    if near > 0 {
        raw.notes.push(format!("{near} of the merged places differed by less than {SAME:e} of the extent"));
    }
    if collapsed > 0 {
        raw.notes.push(format!("triangles that collapsed in this, left out: {collapsed}"));
    }
    Ok(raw)
}

/// For each position the first one that is nearer than the tolerance and stands for others, itself if there is none.
fn representatives(positions: &[Vec3]) -> Vec<u32> {
    let low = positions.iter().copied().reduce(|a, b| a.inf(&b)).unwrap_or_default();
    let high = positions.iter().copied().reduce(|a, b| a.sup(&b)).unwrap_or_default();
    // A surface without extent has one place; any box will do.
    let near = (SAME * (high - low).norm()).max(f64::MIN_POSITIVE);
    // Only representatives are kept in the boxes; they stand apart, so a box holds few of them.
    let mut boxes: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
    let mut first = Vec::new();
    for (node, x) in (0..).zip(positions) {
        // At most a million boxes lie along an edge of the extent.
        let [i, j, k] = [0, 1, 2].map(|c| ((x[c] - low[c]) / near).floor() as i64);
        let around =
            (-1..=1).flat_map(|a| (-1..=1).flat_map(move |b| (-1..=1).map(move |c| [i + a, j + b, k + c])));
        let found = around
            .filter_map(|place| boxes.get(&place))
            .flatten()
            .copied()
            .filter(|&other| (positions[other as usize] - x).norm() <= near)
            .min();
        if found.is_none() {
            boxes.entry([i, j, k]).or_default().push(node);
        }
        first.push(found.unwrap_or(node));
    }
    first
}

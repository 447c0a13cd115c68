//! Wavefront OBJ: vertices, faces of three or four corners, groups as sets, vertex normals.

use std::collections::BTreeMap;

use sph_core::Vec3;

use super::words::float;
use crate::input::shortened;
use crate::surface::MeshError;
use crate::surface::raw::Raw;

/// Cosine of the angle below which normals at one vertex count as one direction (about 0.1°).
const SAME: f64 = 1.0 - 1e-6;

/// Reads a text.
pub(super) fn parse(text: &str) -> Result<Raw, MeshError> {
    let mut raw = Raw::default();
    let mut normals: Vec<Vec3> = Vec::new();
    let mut groups: Vec<String> = Vec::new();
    let mut passed: BTreeMap<&str, usize> = BTreeMap::new();
    // Vertices to which two faces give different normals: a crease.
    let mut creased = false;
    let mut pending = String::new();
    for (line, text) in (1..).zip(text.lines()) {
        let text = text.split('#').next().unwrap_or_default();
        if let Some(part) = text.trim_end().strip_suffix('\\') {
            pending.push_str(part);
            pending.push(' ');
            continue;
        }
        let whole = std::mem::take(&mut pending) + text;
        let mut words = whole.split_whitespace();
        let Some(keyword) = words.next() else { continue };
        let rest: Vec<&str> = words.collect();
        match keyword {
            // Colours and weights may follow the three coordinates.
            "v" => {
                let position = vector(line, "a coordinate of a vertex", &rest)?;
                let label = raw.positions.len() as u64 + 1;
                raw.node(line, label, position)?;
            }
            "vn" => normals.push(vector(line, "a component of a normal", &rest)?.into()),
            "f" => {
                let label = raw.faces.len() as u64 + 1;
                let mut corners = Vec::new();
                for word in &rest {
                    let (node, normal) = corner(line, label, word, raw.positions.len(), normals.len())?;
                    if let Some(normal) = normal.map(|normal| normals[normal]) {
                        let known = *raw.normals.entry(node).or_insert(normal);
                        creased |= known.dot(&normal) < SAME * known.norm() * normal.norm();
                    }
                    corners.push(node);
                }
                raw.face(line, label, &corners)?;
                raw.make_room(line, groups.len() * corners.len())?;
                let face = raw.faces.len() as u32 - 1;
                for group in &groups {
                    raw.add_faces_to_set(group, &[face]);
                }
            }
            "g" | "o" => groups = rest.iter().map(|name| name.to_string()).collect(),
            "vt" | "vp" | "s" | "usemtl" | "mtllib" => {}
            "p" | "l" | "curv" | "curv2" | "surf" | "call" => {
                *passed.entry(known(keyword)).or_default() += 1;
            }
            _ => *passed.entry("unknown").or_default() += 1,
        }
    }
    if creased {
        raw.normals.clear();
        let note = "normals of the file left out: faces disagree about them at a vertex (a crease)";
        raw.notes.push(note.into());
    }
    for (keyword, count) in passed {
        raw.notes.push(format!("lines passed over ({keyword}): {count}"));
    }
    Ok(raw)
}

fn known(keyword: &str) -> &'static str {
    match keyword {
        "p" => "points",
        "l" => "lines",
        _ => "curved surfaces",
    }
}

fn vector(line: usize, what: &str, words: &[&str]) -> Result<[f64; 3], MeshError> {
    let &[x, y, z, ..] = words else {
        let what = format!("{} numbers stand where {what} needs three", words.len());
        return Err(MeshError::at(line, what, "write x y z"));
    };
    Ok([float(line, what, x)?, float(line, what, y)?, float(line, what, z)?])
}

/// Vertex and normal of a corner `v`, `v/vt`, `v//vn` or `v/vt/vn`; negative numbers count from the last.
fn corner(
    line: usize,
    face: u64,
    word: &str,
    vertices: usize,
    normals: usize,
) -> Result<(u32, Option<usize>), MeshError> {
    let refuse = |what: &str| {
        let what = format!("face {face}: corner \"{}\" {what}", shortened(word));
        MeshError::at(line, what, "corners are numbers of vertices above, from 1, or −1 for the last")
    };
    let index = |text: &str, count: usize| {
        let number: i64 = text.parse().map_err(|_| refuse("is not v, v/vt, v//vn or v/vt/vn"))?;
        let index = if number > 0 { number - 1 } else { number.saturating_add(count as i64) };
        let inside = number != 0 && (0..count as i64).contains(&index);
        if inside { Ok(index as usize) } else { Err(refuse(&format!("is none of the {count} above"))) }
    };
    let mut parts = word.split('/');
    let node = index(parts.next().unwrap_or_default(), vertices)?;
    let normal = parts.nth(1).filter(|text| !text.is_empty()).map(|text| index(text, normals)).transpose()?;
    Ok((node as u32, normal))
}

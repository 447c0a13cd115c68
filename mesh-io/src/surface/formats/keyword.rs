//! Keyword lines of Abaqus input: names, parameters, element types, generated ranges.

use std::collections::BTreeMap;

use super::words::count;
use crate::input::shortened;
use crate::surface::MeshError;

/// A keyword line: name and parameters in small letters, values as written.
pub(super) struct Keyword {
    pub line: usize,
    pub name: String,
    parameters: BTreeMap<String, String>,
}

impl Keyword {
    pub fn read(line: usize, text: &str) -> Self {
        let mut parts = text.trim_start_matches('*').split(',').map(str::trim);
        // Blanks within a name count once.
        let name = parts.next().unwrap_or_default().to_lowercase();
        let name = name.split_whitespace().collect::<Vec<_>>().join(" ");
        let parameters = parts.filter(|part| !part.is_empty()).map(|part| {
            let (key, value) = part.split_once('=').unwrap_or((part, ""));
            (key.trim().to_lowercase(), value.trim().trim_matches('"').to_string())
        });
        Self { line, name, parameters: parameters.collect() }
    }

    pub fn has(&self, key: &str) -> bool {
        self.parameters.contains_key(key)
    }

    pub fn get(&self, key: &str) -> Option<&str> {
        self.parameters.get(key).map(String::as_str)
    }

    pub fn needs(&self, key: &str) -> Result<&str, MeshError> {
        self.get(key).filter(|value| !value.is_empty()).ok_or_else(|| {
            let what = format!("*{} gives no {key}", self.name);
            MeshError::at(self.line, what, format!("write *{}, {key}=NAME", self.name))
        })
    }
}

/// Number of nodes of the element type that a keyword names.
pub(super) fn corners(keyword: &Keyword) -> Result<usize, MeshError> {
    let kind = keyword.needs("type")?;
    let refuse = |why: &str, repair: &str| {
        let what = format!("elements of type {}: {why}", shortened(kind));
        Err(MeshError::at(keyword.line, what, repair))
    };
    match kind.to_uppercase().as_str() {
        "S3" | "S3R" | "STRI3" => Ok(3),
        "S4" | "S4R" => Ok(4),
        "STRI65" | "S8R" | "S8R5" | "S9R5" => {
            refuse("their sides are curved", "mesh with linear elements, S3 and S4R")
        }
        _ => refuse(
            "S3, S3R, STRI3, S4 and S4R are read",
            "mesh the surface with S3 and S4R; from Gmsh and meshio bring .msh or .vtu",
        ),
    }
}

/// The numbers first, first + step … last.
pub(super) struct Generated {
    first: u64,
    last: u64,
    step: u64,
}

impl Generated {
    pub fn contain(&self, label: u64) -> bool {
        (self.first..=self.last).contains(&label) && (label - self.first).is_multiple_of(self.step)
    }
}

pub(super) fn generated(line: usize, user: &str, fields: &[&str]) -> Result<Generated, MeshError> {
    let number = |i: usize| match fields.get(i) {
        Some(word) => count(line, &format!("a number of {user}"), word),
        None => Ok(1),
    };
    let range = Generated { first: number(0)?, last: number(1)?, step: number(2)? };
    if fields.len() < 2 || range.step == 0 || range.last < range.first {
        let what = format!("{user} is generated from \"{}\"", shortened(&fields.join(", ")));
        return Err(MeshError::at(line, what, "write first, last, step with first ≤ last and step ≥ 1"));
    }
    Ok(range)
}

pub(super) fn unknown(line: usize, user: &str, name: &str) -> MeshError {
    let what = format!("{user} names \"{}\", which is neither a number nor a set above", shortened(name));
    MeshError::at(line, what, "declare the set before it is used")
}

//! What a reader finds in a file, before anything is checked: nodes, faces, sets.

use std::collections::{BTreeMap, HashMap};

use sph_core::{Cell, Vec3};

use super::MeshError;
use super::sections::{FileMaterial, FileSection};

/// Coordinates beyond this leave the range of `f64` in products.
const GREATEST: f64 = 1e30;

/// Entries that all sets together may have, in units of nodes and faces: short lines can ask for long sets.
const MOST_IN_SETS: usize = 100;

/// What every file may have in its sets, however small it is.
const ALWAYS_IN_SETS: usize = 10_000;

/// A face as the file has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Face {
    /// Nodes, by index.
    pub cell: Cell,
    /// Number in the file, by which messages name it.
    pub label: u64,
    /// Line of the file; zero where the format has no lines.
    pub line: usize,
}

/// The content of a file.
#[derive(Clone, Debug, Default)]
pub(super) struct Raw {
    /// Positions of the nodes `[L]`.
    pub positions: Vec<Vec3>,
    /// Numbers of the nodes in the file; empty where they have none.
    pub labels: Vec<u64>,
    index: HashMap<u64, u32>,
    /// Entries of all sets so far.
    entries: usize,
    pub faces: Vec<Face>,
    /// Nodes of every set, in any order, possibly more than once.
    pub sets: BTreeMap<String, Vec<u32>>,
    /// Faces of every set that the file gives as faces, by index, in any order, possibly more than once.
    pub face_sets: BTreeMap<String, Vec<u32>>,
    /// Sections of element sets, in the order of the file.
    pub sections: Vec<FileSection>,
    /// Materials by the name by which sections call them, in small letters.
    pub materials: BTreeMap<String, FileMaterial>,
    /// Normals of the nodes where the file gives them (any length).
    pub normals: HashMap<u32, Vec3>,
    /// Tributary areas of points `[L²]`.
    pub areas: Vec<f64>,
    /// Thicknesses of points `[L]`.
    pub thicknesses: Vec<f64>,
    /// What was left aside or changed, in words.
    pub notes: Vec<String>,
}

impl Raw {
    /// Adds a node without a number of its own.
    pub fn push(&mut self, line: usize, position: [f64; 3]) -> Result<u32, MeshError> {
        if let Some(x) = position.iter().find(|x| x.abs() > GREATEST) {
            let what = format!("coordinate {x:e} is beyond ±{GREATEST:e}");
            return Err(MeshError::at(line, what, "choose other units"));
        }
        let index = self.positions.len() as u32;
        self.positions.push(position.into());
        Ok(index)
    }

    /// Adds a node with its number.
    pub fn node(&mut self, line: usize, label: u64, position: [f64; 3]) -> Result<u32, MeshError> {
        let index = self.push(line, position)?;
        self.labels.push(label);
        if self.index.insert(label, index).is_some() {
            let what = format!("node {label} is given twice");
            return Err(MeshError::at(line, what, "number every node once"));
        }
        Ok(index)
    }

    /// Index of a node from its number.
    pub fn find(&self, line: usize, user: &str, label: u64) -> Result<u32, MeshError> {
        self.index.get(&label).copied().ok_or_else(|| {
            let what = format!("{user} names node {label}, which the file does not have");
            MeshError::at(line, what, "add the node before, or correct the number")
        })
    }

    /// Adds a face of three or four nodes.
    pub fn face(&mut self, line: usize, label: u64, corners: &[u32]) -> Result<(), MeshError> {
        let cell = match *corners {
            [a, b, c] => Cell::triangle([a, b, c]),
            [a, b, c, d] => Cell::quadrangle([a, b, c, d]),
            _ => {
                let what = format!("face {label} has {} corners; it must have 3 or 4", corners.len());
                return Err(MeshError::at(line, what, "cut polygons into triangles or quadrangles"));
            }
        };
        self.faces.push(Face { cell, label, line });
        Ok(())
    }

    /// Refuses sets that grow beyond all measure by `more` entries.
    pub fn make_room(&mut self, line: usize, more: usize) -> Result<(), MeshError> {
        self.entries = self.entries.saturating_add(more);
        let size = self.positions.len() + self.faces.len();
        if self.entries <= MOST_IN_SETS * size + ALWAYS_IN_SETS {
            return Ok(());
        }
        let what = format!("all sets together hold more than {MOST_IN_SETS} times the nodes and faces");
        Err(MeshError::at(line, what, "leave out sets that the scene does not use"))
    }

    /// Adds nodes to a set.
    pub fn add_to_set(&mut self, name: &str, nodes: &[u32]) {
        match self.sets.get_mut(name) {
            Some(set) => set.extend_from_slice(nodes),
            None => {
                self.sets.insert(name.into(), nodes.to_vec());
            }
        }
    }

    /// Adds faces to a set of faces, and their nodes to the set of nodes of that name.
    pub fn add_faces_to_set(&mut self, name: &str, faces: &[u32]) {
        for &face in faces {
            let cell = self.faces[face as usize].cell;
            self.add_to_set(name, cell.particles());
        }
        match self.face_sets.get_mut(name) {
            Some(set) => set.extend_from_slice(faces),
            None => {
                self.face_sets.insert(name.into(), faces.to_vec());
            }
        }
    }

    /// Line of the first face that uses a node; zero where no face does, or the format has no lines.
    pub fn line_at(&self, node: u32) -> usize {
        self.faces.iter().find(|face| face.cell.particles().contains(&node)).map_or(0, |face| face.line)
    }

    /// How messages call a node.
    pub fn name(&self, node: u32) -> String {
        node_name(&self.positions, &self.labels, node)
    }
}

/// A node by its number, if it has one, and its place.
pub(super) fn node_name(positions: &[Vec3], labels: &[u64], node: u32) -> String {
    let at = super::error::place(&positions[node as usize]);
    match labels.get(node as usize) {
        Some(label) => format!("node {label} at {at}"),
        None => format!("the node at {at}"),
    }
}

/// Things counted: `1 face`, `2 faces`.
pub(super) fn counted(n: usize, what: &str) -> String {
    if n == 1 { format!("1 {what}") } else { format!("{n} {what}s") }
}

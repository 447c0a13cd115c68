//! Gmsh `.msh`, ASCII, versions 2.2 and 4.1: nodes, elements, physical groups, a view of normals; of a body its tetrahedra.
//!
//! The layout is that of the section "MSH file format" of the Gmsh manual.

use std::collections::BTreeMap;

use super::words::Words;
use crate::input::shortened;
use crate::surface::MeshError;
use crate::surface::raw::Raw;
use crate::surface::tetrahedra::{Tetrahedron, bounded};

/// The type of a tetrahedron of four nodes.
const TETRAHEDRON: u64 = 4;

/// Physical groups of an entity, or the names of groups: by dimension and number.
type Key = (u64, i64);

/// What is gathered on the way.
#[derive(Default)]
struct Found {
    raw: Raw,
    /// Names of the physical groups.
    names: BTreeMap<Key, String>,
    /// Physical groups of the geometrical entities (4.1).
    groups: BTreeMap<Key, Vec<i64>>,
    /// Nodes of the physical groups; of groups of surfaces their faces.
    members: BTreeMap<Key, Vec<u32>>,
    /// Elements that belong to no physical group and are no face.
    loose: usize,
    /// Tetrahedra of a body; none where sheets are read.
    solids: Option<Vec<Tetrahedron>>,
}

/// Reads a text, of a `body` its tetrahedra too.
pub(super) fn parse(text: &str, body: bool) -> Result<Raw, MeshError> {
    let mut words = Words::new(text);
    let mut found = Found { solids: body.then(Vec::new), ..Found::default() };
    let new_layout = format(&mut words)?;
    while let Some(word) = words.next() {
        let Some(section) = word.strip_prefix('$') else {
            let what = format!("\"{}\" stands between two sections", shortened(word));
            return Err(MeshError::at(words.line, what, "sections begin with $Name and end with $EndName"));
        };
        let end = format!("$End{section}");
        match section {
            "PhysicalNames" => found.physical_names(&mut words)?,
            "Entities" if new_layout => found.entities(&mut words)?,
            "Nodes" if new_layout => found.blocks_of_nodes(&mut words)?,
            "Elements" if new_layout => found.blocks_of_elements(&mut words)?,
            "Nodes" => found.nodes(&mut words)?,
            "Elements" => found.elements(&mut words)?,
            "NodeData" => found.node_data(&mut words)?,
            "PartitionedEntities" => {
                let repair =
                    "write it in one piece: uncheck Mesh.PartitionSplitMeshFiles, or do not partition";
                return Err(MeshError::at(words.line, "the mesh is partitioned", repair));
            }
            _ => {
                words.skip_to(&end)?;
                continue;
            }
        }
        let line = words.line;
        let word = words.word(&end)?;
        if word != end {
            let what = format!("\"{}\" stands where {end} should", shortened(word));
            return Err(MeshError::at(line, what, format!("correct the counts in ${section}")));
        }
    }
    found.finish()
}

/// Reads the header; true for 4.1.
fn format(words: &mut Words<'_>) -> Result<bool, MeshError> {
    let repair = "write it with `gmsh FILE -2 -format msh41` (or msh22)";
    if words.next() != Some("$MeshFormat") {
        return Err(MeshError::at(words.line, "the file does not begin with $MeshFormat", repair));
    }
    let version = words.word("the version of the format")?;
    let binary = words.count("the file type")?;
    if !["2.2", "4.1"].contains(&version) {
        let what = format!("format {}; 2.2 and 4.1 are read", shortened(version));
        return Err(MeshError::at(words.line, what, repair));
    }
    if binary != 0 {
        let repair = "write it as text: leave out -bin, or set Mesh.Binary = 0";
        return Err(MeshError::at(words.line, "a binary file; ASCII is read", repair));
    }
    words.skip_to("$EndMeshFormat")?;
    Ok(version == "4.1")
}

/// The heading of a section of blocks (4.1).
struct Heading {
    blocks: u64,
    /// What all blocks hold together.
    total: u64,
    line: usize,
}

fn heading(words: &mut Words<'_>, section: &str) -> Result<Heading, MeshError> {
    let blocks = words.count("the number of blocks")?;
    let total = words.count(&format!("the number of all in {section}"))?;
    let line = words.line;
    for _ in 0..2 {
        words.count(&format!("a number of the heading of {section}"))?;
    }
    Ok(Heading { blocks, total, line })
}

impl Heading {
    fn promised(&self, found: u64, what: &str) -> Result<(), MeshError> {
        if found == self.total {
            return Ok(());
        }
        let what = format!("the heading tells of {} {what}, the blocks hold {found}", self.total);
        Err(MeshError::at(self.line, what, "the file is damaged: write it again"))
    }
}

impl Found {
    fn physical_names(&mut self, words: &mut Words<'_>) -> Result<(), MeshError> {
        for _ in 0..words.count("the number of physical names")? {
            let dimension = words.count("the dimension of a physical group")?;
            let tag = whole(words, "the number of a physical group")?;
            let name = words.rest_of_line().trim_matches('"');
            self.names.insert((dimension, tag), name.into());
        }
        Ok(())
    }

    fn entities(&mut self, words: &mut Words<'_>) -> Result<(), MeshError> {
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = words.count("a number of entities")?;
        }
        for (dimension, count) in counts.into_iter().enumerate() {
            for _ in 0..count {
                let tag = whole(words, "the number of an entity")?;
                // A point has its place, the others the box round them.
                for _ in 0..if dimension == 0 { 3 } else { 6 } {
                    words.float("a coordinate of an entity")?;
                }
                let mut groups = Vec::new();
                for _ in 0..words.count("the number of physical groups of an entity")? {
                    groups.push(whole(words, "a physical group of an entity")?);
                }
                if dimension > 0 {
                    for _ in 0..words.count("the number of bounding entities")? {
                        whole(words, "a bounding entity")?;
                    }
                }
                self.groups.insert((dimension as u64, tag), groups);
            }
        }
        Ok(())
    }

    fn nodes(&mut self, words: &mut Words<'_>) -> Result<(), MeshError> {
        for _ in 0..words.count("the number of nodes")? {
            let label = words.count("the number of a node")?;
            let position = words.vector(&format!("a coordinate of node {label}"))?;
            self.raw.node(words.line, label, position)?;
        }
        Ok(())
    }

    fn blocks_of_nodes(&mut self, words: &mut Words<'_>) -> Result<(), MeshError> {
        let heading = heading(words, "$Nodes")?;
        let before = self.raw.positions.len() as u64;
        let blocks = heading.blocks;
        for _ in 0..blocks {
            let dimension = words.count("the dimension of an entity")?;
            whole(words, "the number of an entity")?;
            let parameters = if words.count("the mark for parameters")? == 0 { 0 } else { dimension.min(3) };
            let mut labels = Vec::new();
            for _ in 0..words.count("the number of nodes in a block")? {
                labels.push(words.count("the number of a node")?);
            }
            for label in labels {
                let position = words.vector(&format!("a coordinate of node {label}"))?;
                for _ in 0..parameters {
                    words.float("a parameter of a node")?;
                }
                self.raw.node(words.line, label, position)?;
            }
        }
        heading.promised(self.raw.positions.len() as u64 - before, "nodes")
    }

    fn elements(&mut self, words: &mut Words<'_>) -> Result<(), MeshError> {
        let mut groups = Vec::new();
        for _ in 0..words.count("the number of elements")? {
            let label = words.count("the number of an element")?;
            let kind = words.count(&format!("the type of element {label}"))?;
            groups.clear();
            for i in 0..words.count(&format!("the number of tags of element {label}"))? {
                let tag = whole(words, &format!("a tag of element {label}"))?;
                // The first tag is the physical group, zero for none.
                groups.extend((i == 0 && tag != 0).then_some(tag));
            }
            self.element(words, label, kind, &groups)?;
        }
        Ok(())
    }

    fn blocks_of_elements(&mut self, words: &mut Words<'_>) -> Result<(), MeshError> {
        let heading = heading(words, "$Elements")?;
        let mut found = 0;
        for _ in 0..heading.blocks {
            let dimension = words.count("the dimension of an entity")?;
            let entity = whole(words, "the number of an entity")?;
            let kind = words.count("the type of a block of elements")?;
            let groups = self.groups.get(&(dimension, entity)).cloned().unwrap_or_default();
            for _ in 0..words.count("the number of elements in a block")? {
                let label = words.count("the number of an element")?;
                self.element(words, label, kind, &groups)?;
                found += 1;
            }
        }
        heading.promised(found, "elements")
    }

    fn element(
        &mut self,
        words: &mut Words<'_>,
        label: u64,
        kind: u64,
        groups: &[i64],
    ) -> Result<(), MeshError> {
        if let (TETRAHEDRON, Some(_)) = (kind, &self.solids) {
            return self.tetrahedron(words, label);
        }
        let (dimension, count) = shape(kind).map_err(|(what, repair)| {
            MeshError::at(words.line, format!("element {label} is {what}"), repair)
        })?;
        let user = format!("element {label}");
        let mut corners = [0; 4];
        for corner in &mut corners[..count] {
            let node = words.count(&format!("a node of {user}"))?;
            *corner = self.raw.find(words.line, &user, node)?;
        }
        let corners = &corners[..count];
        let face = [self.raw.faces.len() as u32];
        let mut members = corners;
        if dimension == 2 {
            self.raw.face(words.line, label, corners)?;
            members = &face;
        } else if groups.is_empty() {
            self.loose += 1;
        }
        self.raw.make_room(words.line, groups.len() * count)?;
        for group in groups {
            // A negative number says that the group turns the element round.
            let group = self.members.entry((dimension, group.saturating_abs())).or_default();
            group.extend_from_slice(members);
        }
        Ok(())
    }

    fn tetrahedron(&mut self, words: &mut Words<'_>, label: u64) -> Result<(), MeshError> {
        let user = format!("element {label}");
        let mut corners = [0; 4];
        for corner in &mut corners {
            let node = words.count(&format!("a node of {user}"))?;
            *corner = self.raw.find(words.line, &user, node)?;
        }
        let line = words.line;
        self.solids.iter_mut().for_each(|solids| solids.push(Tetrahedron { corners, label, line }));
        Ok(())
    }

    /// A view of three components called "normals" gives the normals; other views are passed over.
    fn node_data(&mut self, words: &mut Words<'_>) -> Result<(), MeshError> {
        let mut name = String::new();
        words.rest_of_line();
        for i in 0..words.count("the number of texts of a view")? {
            words.rest_of_line();
            let first = words.word("a text of a view")?;
            let text = format!("{first} {}", words.rest_of_line());
            if i == 0 {
                name = text.trim().trim_matches('"').to_lowercase();
            }
        }
        for _ in 0..words.count("the number of reals of a view")? {
            words.float("a real of a view")?;
        }
        let mut integers = [0; 3];
        for i in 0..words.count("the number of integers of a view")? {
            let value = words.count("an integer of a view")?;
            if let Some(slot) = integers.get_mut(i as usize) {
                *slot = value;
            }
        }
        let [_, components, rows] = integers;
        let normals = components == 3 && ["normals", "normal"].contains(&name.as_str());
        for _ in 0..rows {
            let label = words.count("the number of a node")?;
            let mut row = [0.0; 3];
            for i in 0..components {
                let value = words.float(&format!("a value of node {label}"))?;
                if let Some(slot) = row.get_mut(i as usize) {
                    *slot = value;
                }
            }
            if normals {
                let node = self.raw.find(words.line, "the view \"normals\"", label)?;
                self.raw.normals.insert(node, row.into());
            }
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Raw, MeshError> {
        if let Some(solids) = self.solids.filter(|solids| !solids.is_empty()) {
            let numbers = bounded(&mut self.raw, &solids)?;
            let of_surfaces = self.members.iter_mut().filter(|((dimension, _), _)| *dimension == 2);
            for (_, members) in of_surfaces {
                *members = members.iter().filter_map(|&face| numbers[face as usize]).collect();
            }
        }
        for ((dimension, tag), members) in self.members {
            let kind = ["point", "line", "surface"][dimension.min(2) as usize];
            let name = self.names.get(&(dimension, tag)).filter(|name| !name.is_empty());
            let own = format!("{kind}{tag}");
            let name = name.unwrap_or(&own);
            match dimension {
                2 => self.raw.add_faces_to_set(name, &members),
                _ => self.raw.add_to_set(name, &members),
            }
        }
        if self.loose > 0 {
            let note = format!("points and lines in no physical group, left out: {}", self.loose);
            self.raw.notes.push(note);
        }
        Ok(self.raw)
    }
}

/// A whole number of either sign.
fn whole(words: &mut Words<'_>, what: &str) -> Result<i64, MeshError> {
    let word = words.word(what)?;
    word.parse().map_err(|_| {
        let what = format!("{what} is \"{}\"; it must be a whole number", shortened(word));
        MeshError::at(words.line, what, "write a number such as 12")
    })
}

/// Dimension and number of nodes of an element type.
fn shape(kind: u64) -> Result<(u64, usize), (String, &'static str)> {
    match kind {
        15 => Ok((0, 1)),
        1 => Ok((1, 2)),
        2 => Ok((2, 3)),
        3 => Ok((2, 4)),
        4..=7 | 11..=14 | 17..=19 | 29..=33 => Err((
            format!("a solid (type {kind}); surfaces of triangles and quadrangles are read"),
            "put the surface alone into a physical group and mesh with -2",
        )),
        8..=10 | 16 | 20..=28 => Err((
            format!("of second or higher order (type {kind}); straight triangles and quadrangles are read"),
            "mesh with Mesh.ElementOrder = 1",
        )),
        _ => Err((
            format!("of type {kind}; triangles (2) and quadrangles (3) are read"),
            "mesh with Mesh.ElementOrder = 1 and -2",
        )),
    }
}

//! Abaqus `.inp`: nodes, triangles and quadrangles, node and element sets, sections with their materials; flat, or one part
//! with one instance.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::keyword::{Keyword, corners, generated, unknown};
use super::shell_sections::ShellSections;
use super::words::{count, float};
use crate::input::shortened;
use crate::surface::MeshError;
use crate::surface::raw::{Raw, counted};

/// Keywords that make or move nodes and elements in ways that are not read.
const GENERATORS: [&str; 9] =
    ["ngen", "nfill", "ncopy", "nmap", "elgen", "elcopy", "include", "system", "submodel"];

/// Keywords without meaning for a surface, not worth a note.
const SILENT: [&str; 9] = [
    "heading",
    "preprint",
    "end part",
    "assembly",
    "end assembly",
    "end instance",
    "restart",
    "output",
    "end step",
];

/// What is gathered on the way; sets are by their name in small letters.
#[derive(Default)]
struct Found {
    raw: Raw,
    /// Nodes of every element and its face, by its number.
    elements: HashMap<u64, ([u32; 4], u32)>,
    /// Node sets: name as first written, node indices.
    node_sets: BTreeMap<String, (String, Vec<u32>)>,
    /// Element sets: name as first written, element numbers.
    element_sets: BTreeMap<String, (String, Vec<u64>)>,
    /// Surfaces of whole faces, likewise.
    surfaces: BTreeMap<String, (String, Vec<u64>)>,
    sections: ShellSections,
    parts: usize,
    instances: usize,
    /// Inside *assembly but outside *instance: nodes and elements there are none of the surface.
    loose: bool,
    ignored: BTreeSet<String>,
    /// Numbers of the element whose data go on in the next line.
    open: Vec<u64>,
}

/// Reads a text.
pub(super) fn parse(text: &str) -> Result<Raw, MeshError> {
    let mut found = Found::default();
    let mut keyword: Option<Keyword> = None;
    let mut lines = text.lines().zip(1..).filter(|(text, _)| !text.starts_with("**"));
    while let Some((text, line)) = lines.next() {
        if !text.trim_start().starts_with('*') {
            if let Some(keyword) = keyword.as_ref().filter(|_| !text.trim().is_empty()) {
                found.data(keyword, line, text)?;
            }
            continue;
        }
        let mut whole = text.trim().to_string();
        // A keyword line that ends with a comma goes on in the next line.
        while whole.ends_with(',') {
            let Some((more, _)) = lines.next() else { break };
            whole.push_str(more.trim());
        }
        found.close(line)?;
        let next = Keyword::read(line, &whole);
        found.begin(&next)?;
        keyword = Some(next);
    }
    found.close(text.lines().count())?;
    Ok(found.finish())
}

impl Found {
    /// Checks a keyword before its data are read.
    fn begin(&mut self, keyword: &Keyword) -> Result<(), MeshError> {
        let refuse = |what: String, repair: &str| Err(MeshError::at(keyword.line, what, repair));
        match keyword.name.as_str() {
            "assembly" | "end instance" => self.loose = true,
            "end assembly" | "instance" => self.loose = false,
            _ => {}
        }
        if self.passes_over(keyword) {
            self.ignored.insert(format!("*{} of the assembly", keyword.name));
            return Ok(());
        }
        match keyword.name.as_str() {
            "node" if keyword.has("system") && keyword.get("system") != Some("R") => {
                refuse("*node, system=… gives coordinates that are not Cartesian".into(), "write x, y, z")
            }
            "node" | "nset" | "elset" if keyword.has("input") => {
                refuse(format!("*{} reads another file", keyword.name), "put everything into one file")
            }
            "element" => {
                if keyword.has("input") {
                    return refuse("*element reads another file".into(), "put everything into one file");
                }
                corners(keyword).map(|_| ())
            }
            "node" => Ok(()),
            "nset" => {
                let name = keyword.needs("nset")?;
                match keyword.get("elset") {
                    None => Ok(()),
                    Some(elements) => self.nodes_of_elements(keyword.line, name, elements),
                }
            }
            "elset" => keyword.needs("elset").map(|_| ()),
            "surface" => keyword.needs("name").map(|_| ()),
            "part" => {
                self.parts += 1;
                if self.parts > 1 {
                    return refuse(
                        "a second *part; one is read".into(),
                        "write the parts into files of their own",
                    );
                }
                Ok(())
            }
            "instance" => {
                self.instances += 1;
                if self.instances > 1 {
                    return refuse(
                        "a second *instance; one is read".into(),
                        "merge the instances into one part",
                    );
                }
                Ok(())
            }
            name if GENERATORS.contains(&name) => refuse(
                format!("*{name} makes nodes or elements in a way that is not read"),
                "write nodes and elements out: an input file written by Abaqus/CAE has them so",
            ),
            _ if self.sections.begin(keyword) => Ok(()),
            name => {
                if !SILENT.contains(&name) {
                    self.ignored.insert(format!("*{}", shortened(name)));
                }
                Ok(())
            }
        }
    }

    /// Whether a keyword speaks of nodes and elements of the assembly, such as reference points.
    fn passes_over(&self, keyword: &Keyword) -> bool {
        match keyword.name.as_str() {
            "node" | "element" => self.loose,
            "nset" | "elset" => self.loose && !keyword.has("instance"),
            _ => false,
        }
    }

    /// A node set that is given as the nodes of an element set.
    fn nodes_of_elements(&mut self, line: usize, name: &str, elements: &str) -> Result<(), MeshError> {
        let Some((_, labels)) = self.element_sets.get(&elements.to_lowercase()) else {
            return Err(unknown(line, &format!("the set {name}"), elements));
        };
        let found = labels.iter().filter_map(|label| self.elements.get(label)).flat_map(|(nodes, _)| nodes);
        let nodes: Vec<u32> = found.copied().filter(|&node| node != u32::MAX).collect();
        self.raw.make_room(line, nodes.len())?;
        self.nodes_of(name).extend(nodes);
        Ok(())
    }

    fn data(&mut self, keyword: &Keyword, line: usize, text: &str) -> Result<(), MeshError> {
        if self.passes_over(keyword) {
            return Ok(());
        }
        let mut fields: Vec<&str> = text.split(',').map(str::trim).collect();
        let goes_on = fields.last() == Some(&"");
        if goes_on {
            fields.pop();
        }
        match keyword.name.as_str() {
            "node" => self.node(keyword, line, &fields),
            "element" => self.element(keyword, line, &fields, goes_on),
            "nset" => self.node_set(keyword, line, &fields),
            "elset" => self.element_set(keyword, line, &fields),
            "surface" => self.surface(keyword, line, &fields),
            "instance" if fields.iter().any(|field| field.parse() != Ok(0.0)) => {
                let what = "the *instance is moved or turned";
                Err(MeshError::at(line, what, "move the part itself, or use `orientation` in the scene"))
            }
            _ => {
                self.sections.data(keyword, &fields);
                Ok(())
            }
        }
    }

    /// Number, three coordinates, and perhaps the three direction cosines of the normal.
    fn node(&mut self, keyword: &Keyword, line: usize, fields: &[&str]) -> Result<(), MeshError> {
        let label = count(line, "the number of a node", fields[0])?;
        let mut values = [0.0; 6];
        for (i, value) in values.iter_mut().enumerate() {
            // What is not given is zero.
            let word = fields.get(i + 1).copied().unwrap_or_default();
            if !word.is_empty() {
                *value =
                    float(line, &format!("a coordinate of node {label}"), &word.replace(['D', 'd'], "e"))?;
            }
        }
        let [x, y, z, n1, n2, n3] = values;
        let node = self.raw.node(line, label, [x, y, z])?;
        if [n1, n2, n3] != [0.0; 3] {
            self.raw.normals.insert(node, [n1, n2, n3].into());
        }
        if let Some(name) = keyword.get("nset") {
            self.nodes_of(name).push(node);
        }
        Ok(())
    }

    /// Number and nodes, perhaps over several lines that end with a comma.
    fn element(
        &mut self,
        keyword: &Keyword,
        line: usize,
        fields: &[&str],
        goes_on: bool,
    ) -> Result<(), MeshError> {
        for field in fields {
            self.open.push(count(line, "a number of an element", field)?);
        }
        let needed = corners(keyword)?;
        if self.open.len() <= needed {
            return if goes_on { Ok(()) } else { self.close(line) };
        }
        let (label, user) = (self.open[0], format!("element {}", self.open[0]));
        if self.open.len() > needed + 1 {
            let what = format!("{user} has {} nodes; its type has {needed}", self.open.len() - 1);
            return Err(MeshError::at(line, what, "correct the type, or begin a new line"));
        }
        let mut nodes = [u32::MAX; 4];
        for (node, &label) in nodes.iter_mut().zip(&self.open[1..]) {
            *node = self.raw.find(line, &user, label)?;
        }
        self.open.clear();
        let face = self.raw.faces.len() as u32;
        if self.elements.insert(label, (nodes, face)).is_some() {
            let what = format!("{user} is given twice");
            return Err(MeshError::at(line, what, "number every element once"));
        }
        self.raw.face(line, label, &nodes[..needed])?;
        if let Some(name) = keyword.get("elset") {
            self.elements_of(name).push(label);
        }
        Ok(())
    }

    /// Refuses an element whose nodes end too early.
    fn close(&self, line: usize) -> Result<(), MeshError> {
        match self.open[..] {
            [] => Ok(()),
            [label, ref nodes @ ..] => {
                let what = format!("element {label} has only {}", counted(nodes.len(), "node"));
                Err(MeshError::at(line, what, "add the others, or correct the type of the element"))
            }
        }
    }

    /// Node numbers or names of node sets; the nodes of an element set; first, last and step.
    fn node_set(&mut self, keyword: &Keyword, line: usize, fields: &[&str]) -> Result<(), MeshError> {
        let name = keyword.needs("nset")?;
        let user = format!("the set {name}");
        let mut nodes = Vec::new();
        if keyword.has("generate") {
            let labels = generated(line, &user, fields)?;
            // Gaps in the numbers are allowed; no range is longer than the list of nodes.
            let present = self.raw.labels.iter().zip(0..).filter(|(label, _)| labels.contain(**label));
            nodes.extend(present.map(|(_, node)| node));
        } else {
            for field in fields {
                match field.parse() {
                    Ok(label) => nodes.push(self.raw.find(line, &user, label)?),
                    Err(_) => match self.node_sets.get(&field.to_lowercase()) {
                        Some((_, members)) => {
                            self.raw.make_room(line, members.len())?;
                            nodes.extend_from_slice(members);
                        }
                        None => return Err(unknown(line, &user, field)),
                    },
                }
            }
        }
        self.raw.make_room(line, nodes.len())?;
        self.nodes_of(name).extend(nodes);
        Ok(())
    }

    fn element_set(&mut self, keyword: &Keyword, line: usize, fields: &[&str]) -> Result<(), MeshError> {
        let name = keyword.needs("elset")?;
        let user = format!("the set {name}");
        let mut labels = Vec::new();
        if keyword.has("generate") {
            let range = generated(line, &user, fields)?;
            labels.extend(self.raw.faces.iter().map(|face| face.label).filter(|&label| range.contain(label)));
        } else {
            for field in fields {
                match field.parse() {
                    Ok(label) if self.elements.contains_key(&label) => labels.push(label),
                    Ok(label) => {
                        let what = format!("{user} names element {label}, which the file does not have");
                        return Err(MeshError::at(
                            line,
                            what,
                            "add the element before, or correct the number",
                        ));
                    }
                    Err(_) => match self.element_sets.get(&field.to_lowercase()) {
                        Some((_, members)) => {
                            self.raw.make_room(line, members.len())?;
                            labels.extend_from_slice(members);
                        }
                        None => return Err(unknown(line, &user, field)),
                    },
                }
            }
        }
        self.raw.make_room(line, labels.len())?;
        self.elements_of(name).extend(labels);
        Ok(())
    }

    /// A number of an element or an element set, and a side of the shell; edges and other kinds of surfaces are passed over.
    fn surface(&mut self, keyword: &Keyword, line: usize, fields: &[&str]) -> Result<(), MeshError> {
        let whole = fields.get(1).is_none_or(|side| matches!(side.to_uppercase().as_str(), "SPOS" | "SNEG"));
        let of_faces = keyword.get("type").is_none_or(|kind| kind.eq_ignore_ascii_case("element"));
        // A set of an instance may be named with it.
        let set = fields[0].rsplit('.').next().unwrap_or_default().to_lowercase();
        let labels = match (fields[0].parse(), self.element_sets.get(&set)) {
            (Ok(label), _) if self.elements.contains_key(&label) => vec![label],
            (Err(_), Some((_, labels))) => labels.clone(),
            _ => Vec::new(),
        };
        let name = keyword.get("name").unwrap_or_default();
        if whole && of_faces && !labels.is_empty() {
            self.raw.make_room(line, labels.len())?;
            let surface = self.surfaces.entry(name.to_lowercase());
            surface.or_insert_with(|| (name.into(), Vec::new())).1.extend(labels);
        } else {
            self.ignored.insert("*surface that is not made of faces".into());
        }
        Ok(())
    }

    fn nodes_of(&mut self, name: &str) -> &mut Vec<u32> {
        let set = self.node_sets.entry(name.to_lowercase());
        &mut set.or_insert_with(|| (name.into(), Vec::new())).1
    }

    fn elements_of(&mut self, name: &str) -> &mut Vec<u64> {
        let set = self.element_sets.entry(name.to_lowercase());
        &mut set.or_insert_with(|| (name.into(), Vec::new())).1
    }

    fn finish(mut self) -> Raw {
        for (name, nodes) in self.node_sets.values() {
            self.raw.add_to_set(name, nodes);
        }
        // A set goes before a surface of its name.
        let (nodes, elements) = (&self.node_sets, &self.element_sets);
        self.surfaces.retain(|name, _| !nodes.contains_key(name) && !elements.contains_key(name));
        for (name, labels) in self.element_sets.values().chain(self.surfaces.values()) {
            let faces: Vec<u32> =
                labels.iter().filter_map(|label| Some(self.elements.get(label)?.1)).collect();
            self.raw.add_faces_to_set(name, &faces);
        }
        let (sections, materials, left) = self.sections.finish(|set| {
            let (_, labels) = self.element_sets.get(&set.to_lowercase())?;
            Some(labels.iter().filter_map(|label| Some(self.elements.get(label)?.1)).collect())
        });
        (self.raw.sections, self.raw.materials) = (sections, materials);
        self.ignored.extend(left);
        if !self.ignored.is_empty() {
            let list = Vec::from_iter(self.ignored).join(", ");
            self.raw.notes.push(format!("passed over: {list}"));
        }
        self.raw
    }
}

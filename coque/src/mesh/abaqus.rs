//! Abaqus `.inp`: nodes, triangles and quadrangles, node and element sets; flat, or one part with one instance.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::MeshError;
use super::raw::{Raw, counted};
use super::words::{count, float, shortened};

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

/// A keyword line: name and parameters in small letters, values as written.
struct Keyword {
    line: usize,
    name: String,
    parameters: BTreeMap<String, String>,
}

impl Keyword {
    fn read(line: usize, text: &str) -> Self {
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

    fn has(&self, key: &str) -> bool {
        self.parameters.contains_key(key)
    }

    fn get(&self, key: &str) -> Option<&str> {
        self.parameters.get(key).map(String::as_str)
    }

    fn needs(&self, key: &str) -> Result<&str, MeshError> {
        self.get(key).filter(|value| !value.is_empty()).ok_or_else(|| {
            let what = format!("*{} gives no {key}", self.name);
            MeshError::at(self.line, what, format!("write *{}, {key}=NAME", self.name))
        })
    }
}

/// What is gathered on the way; sets are by their name in small letters.
#[derive(Default)]
struct Found {
    raw: Raw,
    /// Nodes of every element, by its number.
    elements: HashMap<u64, [u32; 4]>,
    /// Node sets: name as first written, node indices.
    node_sets: BTreeMap<String, (String, Vec<u32>)>,
    /// Element sets: name as first written, element numbers.
    element_sets: BTreeMap<String, (String, Vec<u64>)>,
    parts: usize,
    instances: usize,
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
            "nset" => keyword.needs("nset").map(|_| ()),
            "elset" => keyword.needs("elset").map(|_| ()),
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
            name => {
                if !SILENT.contains(&name) {
                    self.ignored.insert(format!("*{}", shortened(name)));
                }
                Ok(())
            }
        }
    }

    fn data(&mut self, keyword: &Keyword, line: usize, text: &str) -> Result<(), MeshError> {
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
            "instance" if fields.iter().any(|field| field.parse() != Ok(0.0)) => {
                let what = "the *instance is moved or turned";
                Err(MeshError::at(line, what, "move the part itself, or use `orientation` in the scene"))
            }
            _ => Ok(()),
        }
    }

    /// Number, three coordinates, and perhaps the three direction cosines of the normal.
    fn node(&mut self, keyword: &Keyword, line: usize, fields: &[&str]) -> Result<(), MeshError> {
        let label = count(line, "the number of a node", fields[0])?;
        let mut values = [0.0; 6];
        for (i, value) in values.iter_mut().enumerate() {
            // What is not given is nought.
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
        if self.elements.insert(label, nodes).is_some() {
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
                        Some((_, members)) => nodes.extend_from_slice(members),
                        None => return Err(unknown(line, &user, field)),
                    },
                }
            }
        }
        let bound = self.raw.positions.len();
        let set = self.nodes_of(name);
        set.extend(nodes);
        // Sets named in sets could double without end.
        if set.len() > 2 * bound {
            set.sort_unstable();
            set.dedup();
        }
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
                        Some((_, members)) => labels.extend_from_slice(members),
                        None => return Err(unknown(line, &user, field)),
                    },
                }
            }
        }
        let bound = self.elements.len();
        let set = self.elements_of(name);
        set.extend(labels);
        if set.len() > 2 * bound {
            set.sort_unstable();
            set.dedup();
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
        for (name, labels) in self.element_sets.values() {
            for label in labels {
                let nodes = self.elements.get(label).into_iter().flatten();
                let nodes: Vec<u32> = nodes.copied().filter(|&node| node != u32::MAX).collect();
                self.raw.add_to_set(name, &nodes);
            }
        }
        if !self.ignored.is_empty() {
            let list = Vec::from_iter(self.ignored).join(", ");
            self.raw.notes.push(format!("passed over: {list}"));
        }
        self.raw
    }
}

/// Number of nodes of the element type that a keyword names.
fn corners(keyword: &Keyword) -> Result<usize, MeshError> {
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
        _ => refuse("S3, S3R, STRI3, S4 and S4R are read", "mesh the surface with S3 and S4R"),
    }
}

/// The numbers first, first + step … last.
struct Generated {
    first: u64,
    last: u64,
    step: u64,
}

impl Generated {
    fn contain(&self, label: u64) -> bool {
        (self.first..=self.last).contains(&label) && (label - self.first).is_multiple_of(self.step)
    }
}

fn generated(line: usize, user: &str, fields: &[&str]) -> Result<Generated, MeshError> {
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

fn unknown(line: usize, user: &str, name: &str) -> MeshError {
    let what = format!("{user} names \"{}\", which is neither a number nor a set above", shortened(name));
    MeshError::at(line, what, "declare the set before it is used")
}

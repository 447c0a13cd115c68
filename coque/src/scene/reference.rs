//! The page of all keys of a scene: from the schema, with a table of what goes with which analysis, found by the checks.

use serde_json::Value;

use super::compatibility::goes_with;
use super::schema::schema;
use super::shell::ShellScene;
use super::source::BODIES;

const HEAD: &str = "\
# All keys of a scene

Made by `coque schema --page` from what reads the scenes; a test keeps it. Lines: a key by its path (`[]` stands for the items of a
list, NAME for a name of your own), what its value is, its default (\"–\": may be left out), its dimension (L length, F force, T
time, in the units of the scene), what it says. `coque list` has the same words in short, `--set PATH=VALUE` replaces any of
these values for one run, and `--set 'loads[+]={ … }'` appends to a list.

A scene with a lone shell has the keys of the shell at its top (the short form). In the long form they stand below
`bodies.NAME.shell`; sets may then be named with their body, as in `on = \"NAME.u1\"`. Both forms give the same bits.
A scene with a fluid may have several bodies: the fluid, walls, and the shells and solids in it. Sets are then named with their
body; gravity on `all` acts on every one.
";

/// Columns of the tables.
const COLUMNS: &str = "\n| key | value | default | dimension | what it says |\n|---|---|---|---|---|\n";

/// The page, in Markdown.
pub fn reference_page() -> String {
    let schema = schema();
    let mut page = Page { schema: &schema, text: HEAD.into() };
    let shell = &schema["$defs"]["ShellScene"];
    let top = |key: &String| !ShellScene::WORDS.contains(&key.as_str());
    page.text.push_str("\n## At the top\n");
    page.text.push_str(COLUMNS);
    for (key, value) in properties(&schema).filter(|(key, _)| top(key)) {
        page.row(key, value, &schema);
    }
    for (key, value) in properties(&schema).filter(|(key, _)| top(key) && key.as_str() != BODIES) {
        page.section(key, value);
    }
    page.text.push_str("\n## A shell: at the top, or below `bodies.NAME.shell`\n");
    page.text.push_str(COLUMNS);
    for (key, value) in properties(shell) {
        page.row(key, value, shell);
    }
    for (key, value) in properties(shell) {
        page.section(key, value);
    }
    for (heading, kind) in [
        ("A solid, below `bodies.NAME.solid`", "SolidScene"),
        ("A fluid, below `bodies.NAME.fluid`", "FluidScene"),
        ("Walls of a fluid, below `bodies.NAME.walls`", "WallsScene"),
        ("A rigid body, below `bodies.NAME.rigid`", "RigidScene"),
    ] {
        let body = &schema["$defs"][kind];
        page.text.push_str(&format!("\n## {heading}\n"));
        page.text.push_str(COLUMNS);
        for (key, value) in properties(body) {
            page.row(key, value, body);
        }
        for (key, value) in properties(body) {
            page.section(key, value);
        }
    }
    page.text + &goes_with()
}

fn properties(table: &Value) -> impl Iterator<Item = (&String, &Value)> {
    table["properties"].as_object().into_iter().flatten()
}

struct Page<'a> {
    schema: &'a Value,
    text: String,
}

impl<'a> Page<'a> {
    /// Heading and table of what lies below a key; nothing for a single value.
    fn section(&mut self, key: &str, value: &'a Value) {
        let before = self.text.len();
        self.text.push_str(&format!("\n### `{key}`\n{COLUMNS}"));
        let begun = self.text.len();
        self.below(key, self.resolved(value));
        if self.text.len() == begun {
            self.text.truncate(before);
        }
    }

    /// Rows of all that lies below a key.
    fn below(&mut self, path: &str, of: &'a Value) {
        for (key, value) in properties(of) {
            let path = format!("{path}.{key}");
            self.row(&path, value, of);
            self.below(&path, self.resolved(value));
        }
        for choice in of["oneOf"].as_array().into_iter().flatten() {
            let said = choice["description"].as_str().unwrap_or_default();
            if let Some(word) = choice["const"].as_str().filter(|_| !said.is_empty()) {
                self.line(&format!("{path} = \"{word}\""), "", "", said);
            }
            for (word, value) in properties(choice) {
                let (path, value) = (format!("{path}.{word}"), self.resolved(value));
                let said =
                    if said.is_empty() { value["description"].as_str().unwrap_or_default() } else { said };
                self.line(&path, &self.kind(value), "", said);
                self.below(&path, value);
            }
        }
        if of["additionalProperties"].is_object() {
            self.below(&format!("{path}.NAME"), self.resolved(&of["additionalProperties"]));
        }
        if of["items"].is_object() {
            self.below(&format!("{path}[]"), self.resolved(&of["items"]));
        }
    }

    /// The row of one key of a table.
    fn row(&mut self, path: &str, value: &'a Value, table: &Value) {
        let key = path.rsplit('.').next().unwrap_or(path);
        let resolved = self.resolved(value);
        let said = [value, resolved].into_iter().find_map(|of| of["description"].as_str());
        let required = table["required"].as_array().is_some_and(|keys| keys.iter().any(|known| known == key));
        let default = match &value["default"] {
            _ if required => "required".to_string(),
            Value::Null => "–".into(),
            Value::Array(items) if items.is_empty() => "none".into(),
            Value::Object(keys) if keys.is_empty() => "none".into(),
            default => format!(
                "`{}`",
                default.to_string().replace("{\"", "{ ").replace("\":", " = ").replace('}', " }")
            ),
        };
        self.line(path, &self.kind(resolved), &default, said.unwrap_or_default());
    }

    fn line(&mut self, path: &str, kind: &str, default: &str, said: &str) {
        let dimension = dimension(said);
        let said = match dimension {
            Some(dimension) => said.replace(&format!(" [{dimension}]"), ""),
            None => said.into(),
        };
        let [kind, said] = [kind, &said].map(|text| text.replace('|', "\\|"));
        let dimension = dimension.unwrap_or_default();
        self.text.push_str(&format!("| `{path}` | {kind} | {default} | {dimension} | {said} |\n"));
    }

    /// What kind of value a schema asks for, in words.
    fn kind(&self, of: &Value) -> String {
        let quoted =
            |words: &[Value]| words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ");
        if let Some(words) = of["enum"].as_array() {
            return quoted(words);
        }
        if let Some(choices) = of["oneOf"].as_array().filter(|_| of.get("properties").is_none()) {
            let mut kinds: Vec<String> = Vec::new();
            for choice in choices {
                let kind = match choice.get("const") {
                    Some(word) => quoted(std::slice::from_ref(word)),
                    None => self.kind(self.resolved(choice)),
                };
                if !kinds.contains(&kind) {
                    kinds.push(kind);
                }
            }
            return kinds.join(", ");
        }
        let count = of["minItems"].as_u64().filter(|least| of["maxItems"].as_u64() == Some(*least));
        if let Some([Value::String(one), Value::String(_)]) = of["type"].as_array().map(Vec::as_slice) {
            let one = self.kind(&serde_json::json!({ "type": one }));
            return format!("{one}, or list of {}", self.kind(self.resolved(&of["items"])));
        }
        match of["type"].as_str().unwrap_or_default() {
            "object" => "table".into(),
            "array" => match (self.kind(self.resolved(&of["items"])).as_str(), count) {
                ("number", Some(count)) => format!("{count} numbers"),
                ("whole number", Some(count)) => format!("{count} whole numbers"),
                ("number", None) => "list of numbers".into(),
                ("table", _) => "list of tables".into(),
                (kind, _) => format!("list of {kind}"),
            },
            "string" => "text".into(),
            "integer" => "whole number".into(),
            "boolean" => "`true`, `false`".into(),
            kind => kind.into(),
        }
    }

    /// A schema, or the type that it refers to.
    fn resolved(&self, of: &'a Value) -> &'a Value {
        let name = of["$ref"].as_str().and_then(|path| path.strip_prefix("#/$defs/"));
        name.map_or(of, |name| &self.schema["$defs"][name])
    }
}

/// The dimension in brackets in a description, such as `F/L²`.
pub(super) fn dimension(said: &str) -> Option<&str> {
    let inside = said.split('[').skip(1).filter_map(|rest| rest.split_once(']').map(|(inside, _)| inside));
    inside
        .filter(|text| {
            ["rad", "degrees"].contains(text) || text.chars().all(|c| "LFTΘs1/–²³⁴⁵ ,()".contains(c))
        })
        .last()
}

//! The JSON schema of scenes, made from the types that read them: what editors complete and explain keys with.

use schemars::schema_for;
use serde_json::{Map, Value, json};

use super::loads::Load;
use super::problem::Scene;
use super::record::Record;
use super::rigid_joints::JointScene;
use super::shell::ShellScene;
use super::supports::Support;

/// The schema of a scene, as JSON.
///
/// Descriptions are the doc comments of the types. What a scene must give exactly one of, and names that other crates
/// know, are added; TOML has no null, so nothing may be null.
pub fn schema() -> Value {
    let mut schema = Value::from(schema_for!(Scene));
    records(&mut schema);
    plain(&mut schema);
    short_form(&mut schema);
    if let Some(types) = schema["$defs"].as_object_mut() {
        exactly_one(types, "Support", &Support::WORDS);
        exactly_one(types, "Load", &Load::WORDS);
        exactly_one(types, "Fracture", &["energy", "stretch"]);
        exactly_one(types, "Explicit", &["quasi-static", "transient"]);
        exactly_one(types, "ArcLength", &["until", "stop"]);
        exactly_one(types, "JointScene", &JointScene::WORDS);
        exactly_one(types, "LinkScene", &["stiffness", "table", "damping"]);
        several(types, "Support", "on");
        several(types, "Spring", "to");
        several(types, "Load", "on");
        several(types, "HeatScene", "on");
        several(types, "Probe", "on");
        let kernels = sph_core::kernels().map(|kernel| kernel.name());
        let curvatures = shell_kinematics::strain_measures().map(|measure| measure.name());
        for options in ["StressPoint", "Nodal", "StrongForm"] {
            names(types, options, "kernel", &kernels);
            names(types, options, "curvature", &curvatures);
        }
    }
    schema
}

/// The schema as it is printed and kept in `scenes/schema.json`: for editors, whose numbers may be expressions as well.
pub fn schema_text() -> String {
    let mut schema = schema();
    expressions(&mut schema);
    format!("{schema:#}\n")
}

/// Where a number is expected, a text that holds a parameter or an operator is taken as well.
fn expressions(value: &mut Value) {
    match value {
        Value::Object(map) => {
            if let Some(kind) =
                map.get("type").filter(|kind| *kind == "number" || *kind == "integer").cloned()
            {
                map.insert("type".into(), json!([kind, "string"]));
                map.insert("pattern".into(), json!("[$(+*/^-]|pi|[0-9] [a-zA-Z°]"));
            }
            map.values_mut().for_each(expressions);
        }
        Value::Array(items) => items.iter_mut().for_each(expressions),
        _ => {}
    }
}

/// Takes out null, formats of numbers and the marks of rustdoc.
fn plain(value: &mut Value) {
    match value {
        Value::Object(map) => {
            map.remove("format");
            if map.get("default") == Some(&Value::Null) {
                map.remove("default");
            }
            if let Some(Value::Array(types)) = map.get_mut("type") {
                types.retain(|kind| kind != "null");
                if let [only] = &types[..] {
                    let only = only.clone();
                    map.insert("type".into(), only);
                }
            }
            one_of_two(map);
            if let Some(Value::String(text)) = map.get_mut("description") {
                *text = text.replace("\\[", "[").replace("\\]", "]").replace('\n', " ");
            }
            map.values_mut().for_each(plain);
        }
        Value::Array(items) => items.iter_mut().for_each(plain),
        _ => {}
    }
}

/// Something or null becomes something.
fn one_of_two(map: &mut Map<String, Value>) {
    let Some(Value::Array(choices)) = map.get_mut("anyOf") else { return };
    choices.retain(|choice| choice["type"] != "null");
    if let [Value::Object(only)] = &choices[..] {
        let only = only.clone();
        map.remove("anyOf");
        only.into_iter().for_each(|(key, value)| {
            map.entry(key).or_insert(value);
        });
    }
}

/// Courses may stand in files, which are read before the scene.
fn records(schema: &mut Value) {
    let mut record = Value::from(schema_for!(Record));
    let Some(types) = schema["$defs"].as_object_mut() else { return };
    if let Some(own) = record.as_object_mut() {
        own.remove("$schema");
        if let Some(Value::Object(below)) = own.remove("$defs") {
            types.extend(below);
        }
    }
    types.insert("Record".into(), record);
    if let Some(choices) = types.get_mut("Amplitude").and_then(|of| of["oneOf"].as_array_mut()) {
        choices.push(json!({
            "description": "Numbers by time in a file.",
            "type": "object",
            "properties": { "record": { "$ref": "#/$defs/Record" } },
            "required": ["record"],
            "additionalProperties": false
        }));
    }
}

/// A lone shell may stand at the top, in place of `bodies`.
fn short_form(schema: &mut Value) {
    let shell = schema["$defs"]["ShellScene"].clone();
    if let (Some(top), Some(keys)) = (schema["properties"].as_object_mut(), shell["properties"].as_object()) {
        let own = keys.iter().filter(|(key, _)| ShellScene::WORDS.contains(&key.as_str()));
        top.extend(own.map(|(key, value)| (key.clone(), value.clone())));
    }
    schema["oneOf"] = json!([{ "required": shell["required"] }, { "required": ["bodies"] }]);
}

/// A table must give exactly one of these keys.
fn exactly_one(types: &mut Map<String, Value>, table: &str, words: &[&str]) {
    types[table]["oneOf"] = words.iter().map(|word| json!({ "required": [word] })).collect();
}

/// A key takes a text, or a list of texts.
fn several(types: &mut Map<String, Value>, table: &str, key: &str) {
    let key = &mut types[table]["properties"][key];
    key["type"] = json!(["string", "array"]);
    key["items"] = json!({ "type": "string" });
}

/// The words that a key may have.
fn names(types: &mut Map<String, Value>, table: &str, key: &str, words: &[&str]) {
    types[table]["properties"][key]["enum"] = json!(words);
}

//! Tables given as lists: the reader of TOML would take `force = [[0, 0, 1]]` for `force = { total = [0, 0, 1] }`.

use std::sync::LazyLock;

use serde_json::Value;
use toml::de::{DeTable, DeValue};

use super::absent::in_place_of_a_list;
use super::error::SceneError;
use super::schema::schema;
use super::source::Source;

static SCHEMA: LazyLock<Value> = LazyLock::new(schema);

/// Refuses the first list in a document where a scene has a table.
pub(crate) fn refuse_lists(table: &DeTable<'_>, source: &Source) -> Result<(), SceneError> {
    walk_table("", table, &alternatives(vec![&SCHEMA]), source)
}

fn walk_table(
    path: &str,
    table: &DeTable<'_>,
    of: &[&'static Value],
    source: &Source,
) -> Result<(), SceneError> {
    for (key, value) in table {
        let name: &str = key.get_ref();
        let below = of.iter().filter_map(|schema| {
            schema["properties"].get(name).or_else(|| schema.get("additionalProperties"))
        });
        let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
        visit(&path, value.get_ref(), &alternatives(below.collect()), source)?;
    }
    Ok(())
}

fn visit(path: &str, value: &DeValue<'_>, of: &[&'static Value], source: &Source) -> Result<(), SceneError> {
    match value {
        DeValue::Table(table) => walk_table(path, table, of, source),
        DeValue::Array(items) => {
            let is = |schema: &&Value, kind: &str| match &schema["type"] {
                Value::Array(kinds) => kinds.iter().any(|known| known == kind),
                known => known == kind,
            };
            let table = of.iter().any(|schema| is(schema, "object") || schema.get("properties").is_some());
            if table && !of.iter().any(|schema| is(schema, "array")) {
                return Err(SceneError::Type(source.fault(
                    path,
                    "a list",
                    "a table",
                    in_place_of_a_list(path),
                )));
            }
            let below = alternatives(of.iter().filter_map(|schema| schema.get("items")).collect());
            let mut items = items.iter().enumerate();
            items.try_for_each(|(i, item)| visit(&format!("{path}[{i}]"), item.get_ref(), &below, source))
        }
        _ => Ok(()),
    }
}

/// A schema with all that it refers to or leaves to choose from.
fn alternatives(mut open: Vec<&'static Value>) -> Vec<&'static Value> {
    let mut found = Vec::new();
    while let Some(schema) = open.pop() {
        found.push(schema);
        if let Some(name) = schema["$ref"].as_str().and_then(|path| path.strip_prefix("#/$defs/")) {
            open.push(&SCHEMA["$defs"][name]);
        }
        for choice in ["anyOf", "oneOf", "allOf"] {
            open.extend(schema[choice].as_array().into_iter().flatten());
        }
    }
    found
}

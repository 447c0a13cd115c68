//! Values of a document with what the schema says of their places; tables given as lists are refused: the reader of TOML would take
//! `force = [[0, 0, 1]]` for `force = { total = [0, 0, 1] }`.

use std::sync::LazyLock;

use serde_json::Value;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::absent::in_place_of_a_list;
use super::error::{SceneError, Verdict};
use super::schema::schema;
use super::source::Source;

static SCHEMA: LazyLock<Value> = LazyLock::new(schema);

/// All that the schema says of the place of a value.
#[derive(Clone, Copy)]
pub(super) struct Said<'a> {
    /// Of the value.
    pub of: &'a [&'static Value],
    /// Of its key: of an item that of its list.
    pub key: &'a [&'static Value],
}

/// What is done with a value at a path.
pub(super) type Visit<'a, 'i> = &'a mut dyn FnMut(&str, &Spanned<DeValue<'i>>, Said<'_>) -> Verdict;

/// Visits all values of a document, what lies in a list or a table after it.
pub(super) fn walk<'i>(table: &DeTable<'i>, visit: Visit<'_, 'i>) -> Verdict {
    walk_table("", table, &alternatives(vec![&SCHEMA]), visit)
}

fn walk_table<'i>(path: &str, table: &DeTable<'i>, of: &[&'static Value], visit: Visit<'_, 'i>) -> Verdict {
    for (key, value) in table {
        let name: &str = key.get_ref();
        let below = of.iter().filter_map(|schema| {
            schema["properties"].get(name).or_else(|| schema.get("additionalProperties"))
        });
        let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
        let of = alternatives(below.collect());
        walk_value(&path, value, Said { of: &of, key: &of }, visit)?;
    }
    Ok(())
}

fn walk_value<'i>(path: &str, value: &Spanned<DeValue<'i>>, said: Said<'_>, visit: Visit<'_, 'i>) -> Verdict {
    visit(path, value, said)?;
    match value.get_ref() {
        DeValue::Table(table) => walk_table(path, table, said.of, visit),
        DeValue::Array(items) => {
            let below = alternatives(said.of.iter().filter_map(|schema| schema.get("items")).collect());
            let below = Said { of: &below, key: said.key };
            let mut items = items.iter().enumerate();
            items.try_for_each(|(i, item)| walk_value(&format!("{path}[{i}]"), item, below, visit))
        }
        _ => Ok(()),
    }
}

/// Whether a schema admits a kind of value.
pub(super) fn admits(schema: &Value, kind: &str) -> bool {
    match &schema["type"] {
        Value::Array(kinds) => kinds.iter().any(|known| known == kind),
        known => known == kind,
    }
}

/// Refuses the first list in a document where a scene has a table.
pub(crate) fn refuse_lists(table: &DeTable<'_>, source: &Source) -> Verdict {
    walk(table, &mut |path, value, Said { of, .. }| {
        let table = of.iter().any(|schema| admits(schema, "object") || schema.get("properties").is_some());
        let list = matches!(value.get_ref(), DeValue::Array(_));
        if !list || !table || of.iter().any(|schema| admits(schema, "array")) {
            return Ok(());
        }
        Err(SceneError::Type(source.fault(path, "a list", "a table", in_place_of_a_list(path))))
    })
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

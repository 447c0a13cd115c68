//! The text of a scene on another lattice or mesh: values are replaced where they stand, and comments stay.

use toml_edit::{DocumentMut, Item, Key, TableLike, Value, value};

use super::refined::Refined;
use crate::scene::Checked;

impl Checked {
    /// Its text with a mesh in the place of its geometry.
    ///
    /// # Errors
    /// In words: a text that is not that of the scene.
    pub fn on_mesh(&self, text: &str, file: &str) -> Result<String, String> {
        let mut document = read(text)?;
        let mut path = vec!["geometry"];
        if let Some(name) = self.bodies.keys().next().filter(|_| document.contains_key("bodies")) {
            path = vec!["bodies", name, "shell", "geometry"];
        }
        let geometry = table(&mut document, &path).ok_or("the scene has no shell in its text")?;
        let word = geometry.iter().next().map(|(word, _)| word.to_owned());
        let word = word.ok_or("the scene has no geometry in its text")?;
        // The table itself is taken over, with its place and the comment above it.
        let key = geometry.key(&word).cloned();
        let mut mesh = geometry.remove(&word).unwrap_or_default();
        let keys = mesh.as_table_like_mut().ok_or("the geometry of the scene is no table")?;
        if word != "mesh" {
            keys.clear();
        }
        keys.insert("file", value(file));
        let mut renamed = Key::new("mesh");
        if let Some(key) = key {
            renamed = renamed.with_leaf_decor(key.leaf_decor().clone());
            renamed = renamed.with_dotted_decor(key.dotted_decor().clone());
        }
        geometry.entry_format(&renamed).or_insert(mesh);
        Ok(document.to_string())
    }
}

impl Refined {
    /// The text of the scene as it was given, on this lattice.
    ///
    /// # Errors
    /// In words: a mesh, which has no lattice; a text that is not that of the scene.
    pub fn on_lattice(&self, text: &str) -> Result<String, String> {
        let mut document = read(text)?;
        for (path, number) in self.overrides().ok_or("a mesh has no lattice")? {
            let keys: Vec<&str> = path.split('.').collect();
            let (last, above) = keys.split_last().ok_or("the lattice has no key")?;
            let table = table(&mut document, above);
            let table = table.ok_or_else(|| format!("the scene has no `{path}` in its text"))?;
            let mut number: Value = number.parse().map_err(unread)?;
            let item = table.entry(last).or_insert(Item::None);
            if let Some(before) = item.as_value() {
                *number.decor_mut() = before.decor().clone();
            }
            *item = Item::Value(number);
        }
        Ok(document.to_string())
    }
}

fn read(text: &str) -> Result<DocumentMut, String> {
    text.parse().map_err(unread)
}

fn unread(error: toml_edit::TomlError) -> String {
    format!("the scene does not read: {error}")
}

/// The table below some keys.
fn table<'a>(document: &'a mut DocumentMut, keys: &[&str]) -> Option<&'a mut dyn TableLike> {
    let mut item = document.as_item_mut();
    for key in keys {
        item = item.as_table_like_mut()?.get_mut(key)?;
    }
    item.as_table_like_mut()
}

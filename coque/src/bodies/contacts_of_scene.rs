//! The contacts of a scene: what they are called, and what it leaves without one.

use super::body::Body;
use super::contact_now::{ContactNow, With};
use super::unseen::Unseen;
use crate::scene::{BodyScene, Scene};

/// Contacts by name, and what nothing keeps apart.
#[derive(Debug, Default)]
pub(crate) struct ContactsOfScene {
    /// Each body with the names of its tools.
    bodies: Vec<(String, Vec<String>)>,
    /// What a body that is alone is.
    alone: &'static str,
    unseen: Option<Unseen>,
}

impl ContactsOfScene {
    /// Those of a scene and of the body that it makes.
    pub fn of(scene: &Scene, body: &dyn Body) -> Self {
        let tools = |name: &str| {
            let tools = scene.bodies.get(name).map_or(&[][..], BodyScene::tools);
            tools.iter().map(|tool| tool.name.clone()).collect()
        };
        // A body that is one has no names of its parts.
        let names: Vec<&str> = match body.bodies() {
            parts if parts.is_empty() => scene.bodies.keys().map(String::as_str).collect(),
            parts => parts,
        };
        let bodies = names.into_iter().map(|name| (name.to_string(), tools(name))).collect();
        let alone = match scene.bodies.values().next() {
            Some(BodyScene::Rigid(_)) => "rigid body",
            body => body.map_or("shell", BodyScene::word),
        };
        Self { bodies, alone, unseen: Unseen::of(scene, body) }
    }

    /// The same without a look at what nothing keeps apart.
    pub fn named_only(self) -> Self {
        Self { unseen: None, ..self }
    }

    /// What has come too near to what, at a moment in words; none where nothing has.
    pub fn unseen(&self, body: &dyn Body, when: &str) -> Option<String> {
        self.unseen.as_ref()?.look(body, when)
    }

    /// What a contact is called.
    pub fn name(&self, contact: &ContactNow) -> String {
        let body = |number: usize| self.bodies.get(number).map_or("", |(name, _)| name.as_str());
        let own = if self.bodies.len() > 1 {
            format!("`{}`", body(contact.body))
        } else {
            format!("the {}", self.alone)
        };
        match contact.with {
            With::Itself => format!("{own} with itself"),
            With::Body(other) => format!("{own} with `{}`", body(other)),
            With::Tool(number) => {
                let tools = self.bodies.get(contact.body).map(|(_, tools)| tools);
                let tool = tools.and_then(|tools| tools.get(number)).map_or("", String::as_str);
                format!("{own} with the tool `{tool}`")
            }
        }
    }
}

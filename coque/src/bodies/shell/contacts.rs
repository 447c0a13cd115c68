//! The contacts of a shell, with tools and with itself, and what they do now.

use sph_shell::Shell;

use crate::bodies::{ContactNow, With};

/// The contacts of a shell that is alone, for the forces last evaluated.
pub(super) fn contacts(shell: &Shell) -> Vec<ContactNow> {
    if !shell.may_touch() {
        return Vec::new();
    }
    let by_thickness = Some(shell.thickness_bounds_contact());
    let tools = shell.tool_stiffness().zip(shell.touches()).enumerate();
    let tool = |(number, (stiffness, touch)): (usize, (f64, &contact::Touch))| {
        let deep = touch.greatest_depth > ContactNow::DEEP;
        ContactNow {
            body: 0,
            with: With::Tool(number),
            stiffness,
            by_thickness,
            depth: touch.greatest_depth,
            area: touch.area,
            place: deep.then(|| shell.deepest_in_tool(number)).flatten(),
            rows: None,
        }
    };
    let mut all: Vec<ContactNow> = tools.map(tool).collect();
    if let (Some(stiffness), Some(touch)) = (shell.own_contact_stiffness(), shell.own_touch()) {
        let deep = touch.greatest_depth > ContactNow::DEEP;
        all.push(ContactNow {
            body: 0,
            with: With::Itself,
            stiffness,
            by_thickness,
            depth: touch.greatest_depth,
            area: touch.area,
            place: deep.then(|| Some(shell.deepest_in_itself()?.places[0])).flatten(),
            rows: None,
        });
    }
    all
}

//! Friction of a solid on a tool: anchors, what was lost at its places, both as a history that is kept and taken up.

use contact::{Friction, ToolContact};

use super::skin::Skin;

/// Numbers of an anchor.
const ANCHOR: usize = 7;

/// Friction on a tool with its history.
#[derive(Clone, Debug)]
pub(super) struct RoughTool {
    coefficient: f64,
    friction: Friction,
    /// Energy lost at each place until the last commit \[F L\].
    lost: Vec<f64>,
}

impl RoughTool {
    /// Friction of a coefficient μ \[–\] on a surface that so many places carry; none for zero.
    pub fn new(coefficient: f64, contact: &ToolContact, places: usize) -> Option<Self> {
        let friction = Friction::new(coefficient, contact.surface.vertices().len())?;
        (coefficient > 0.0).then(|| Self { coefficient, friction, lost: vec![0.0; places] })
    }

    /// Coefficient of friction \[–\].
    pub fn coefficient(&self) -> f64 {
        self.coefficient
    }

    /// What sticks and slips.
    pub fn friction(&self) -> &Friction {
        &self.friction
    }

    /// The same, for an evaluation of forces.
    pub fn friction_mut(&mut self) -> &mut Friction {
        &mut self.friction
    }

    /// Makes the anchors of the forces last evaluated those that count; what they lost goes to the places that carry the vertices.
    pub fn commit(&mut self, contact: &ToolContact, skin: &Skin) {
        let Self { friction, lost, .. } = self;
        friction.commit(|vertex, energy| {
            let vertex = &contact.surface.vertices()[vertex as usize];
            for &node in vertex.nodes() {
                skin.each((0, node), |place, weight| lost[place] += energy * vertex.share() * weight);
            }
        });
    }

    /// Energy lost at a place until the last commit \[F L\].
    pub fn lost_at(&self, place: usize) -> f64 {
        self.lost[place]
    }

    /// The committed history: losses of all places, then the anchors.
    pub fn numbers(&self) -> Vec<f64> {
        self.lost.iter().copied().chain(self.friction.numbers()).collect()
    }

    /// Takes up a history; false, and nothing changed, if it is that of another surface, or one of so many vertices.
    pub fn take_up(&mut self, history: &[f64], vertices: usize) -> bool {
        let Some((lost, anchors)) = history.split_at_checked(self.lost.len()) else { return false };
        let (rows, left) = anchors.as_chunks::<ANCHOR>();
        let known = |row: &[f64; ANCHOR]| (0.0..vertices as f64).contains(&row[0]);
        if !(left.is_empty() && rows.iter().all(known) && rows.is_sorted_by_key(|row| row[0])) {
            return false;
        }
        self.lost.copy_from_slice(lost);
        self.friction.take_up(rows);
        true
    }
}

//! How far a motion may go before what touches a tool is another: the first vertex that parts, comes to touch or slips.

use sph_core::Vec3;

use crate::friction::Friction;
use crate::pose::{Pose, ToolFrame};
use crate::surface::Vertex;
use crate::tool::Gap;
use crate::touch::ToolContact;

/// Nodes that move: where they are \[L\], and how far each goes in the whole motion \[L\].
pub struct Motion<A, R> {
    /// Places by number.
    pub at: A,
    /// Ways by number.
    pub way: R,
}

/// What becomes of a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// It touches, and parts.
    Opens,
    /// It is apart, and comes to touch.
    Closes,
    /// It sticks, and slips.
    Slips,
}

/// The first change of what touches on the way of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrontChange {
    /// The part of the motion after which it comes \[–\].
    pub share: f64,
    /// What changes.
    pub turn: Turn,
    /// Where \[L\].
    pub place: Vec3,
}

impl FrontChange {
    /// The change of a gap \[L\], negative where faces are in each other, that grows by so much over the whole motion \[L\]; none where it
    /// comes no nearer to zero.
    pub fn of_gap(gap: f64, growth: f64, place: Vec3) -> Option<Self> {
        let turn = if gap < 0.0 { Turn::Opens } else { Turn::Closes };
        let share = -gap / growth;
        (growth != 0.0 && share.is_finite() && (share > 0.0 || gap == 0.0 && growth < 0.0)).then_some(Self {
            share,
            turn,
            place,
        })
    }

    /// The sooner of two.
    pub fn sooner(self, other: Self) -> Self {
        if other.share < self.share { other } else { self }
    }
}

impl ToolContact {
    /// The first change of what touches along a motion, by the rates of gaps and forces at its beginning, with the tool in a pose and friction
    /// as for the forces last evaluated.
    pub fn first_change(
        &self,
        friction: Option<&Friction>,
        pose: &Pose,
        motion: &Motion<impl Fn(u32) -> Vec3, impl Fn(u32) -> Vec3>,
    ) -> Option<FrontChange> {
        let frame = ToolFrame::new(&self.tool, pose);
        let of = |(number, vertex): (u32, &Vertex)| {
            let (place, way) = (vertex.place(&motion.at), vertex.place(&motion.way));
            let Gap { distance, normal, .. } = self.tool.gap(&place, &pose.moved);
            let across = normal.dot(&way);
            let change = FrontChange::of_gap(distance - vertex.half, across, place);
            let held = friction.filter(|_| distance < vertex.half).and_then(|own| own.held(number));
            let Some((stretch, coefficient)) = held else { return change };
            let [_, slope, second] = self.law.at(1.0 - distance / vertex.half);
            // |s| − μ N/k, and how that grows.
            let stretch = frame.turned(&stretch);
            let (size, along) = (stretch.norm(), way - normal * across);
            let grows = if size > 0.0 { stretch.dot(&along) / size } else { along.norm() };
            let left = coefficient * vertex.half * slope - size;
            let growth = grows + coefficient * second * across;
            let slips = (growth > 0.0).then(|| {
                let share = left.max(0.0) / growth;
                FrontChange { share, turn: Turn::Slips, place }
            });
            change.into_iter().chain(slips).reduce(FrontChange::sooner)
        };
        (0..).zip(self.surface.vertices()).filter_map(of).reduce(FrontChange::sooner)
    }
}

#[cfg(test)]
mod tests {
    use super::{FrontChange, Turn};
    use sph_core::Vec3;

    #[test]
    fn a_gap_changes_where_it_comes_to_zero_and_nowhere_else() {
        let of = |gap, growth| FrontChange::of_gap(gap, growth, Vec3::zeros()).map(|c| (c.share, c.turn));
        assert_eq!(of(0.5, -2.0), Some((0.25, Turn::Closes)));
        assert_eq!(of(-0.5, 2.0), Some((0.25, Turn::Opens)));
        assert_eq!(of(0.0, -2.0), Some((0.0, Turn::Closes)));
        assert_eq!([of(0.5, 2.0), of(-0.5, -2.0), of(0.0, 2.0), of(0.5, 0.0)], [None; 4]);
        assert_eq!(of(f64::INFINITY, -1.0), None);
    }
}

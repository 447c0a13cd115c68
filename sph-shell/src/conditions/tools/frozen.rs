//! Tools in a state that stays: what touches there is a spring, and how far a motion may go before that is another.

use contact::{Friction, FrontChange, Motion};
use explicit_dynamics::Instant;

use super::{Tools, place};
use crate::conditions::body::{Block, place_block};
use crate::conditions::case::LoadCase;
use crate::packs::Row;

impl Tools {
    /// Hands the derivatives of their forces to `put` as [`Tools::stiffness`] does, all that grips them taken to stick: at its limit
    /// friction has no derivative, and what swings to and fro goes back as far as it slipped.
    pub fn stiffness_that_sticks(
        &self,
        at: Instant,
        under_way: LoadCase,
        state: &[Row],
        put: &mut dyn FnMut(u32, u32, &Block),
    ) {
        for tool in &self.tools {
            let pose = tool.pose(at, under_way, &self.origin);
            let sticks = tool.friction.as_ref().map(Friction::without_slip);
            let put = |a, b, change: &_| put(a, b, &place_block(0, 0, change));
            tool.contact.tangent(sticks.as_ref(), &pose, place(state), put);
        }
    }

    /// The first change of what touches along a motion from a state by so far, tools as for the forces last evaluated; places from zero.
    pub fn first_change(&self, state: &[Row], ways: &[Row]) -> Option<FrontChange> {
        let of = |tool: &super::Touched| {
            let motion = Motion { at: place(state), way: place(ways) };
            let found = tool.contact.first_change(tool.friction.as_ref(), &tool.stood, &motion)?;
            Some(FrontChange { place: found.place + self.origin, ..found })
        };
        self.tools.iter().filter_map(of).reduce(FrontChange::sooner)
    }
}

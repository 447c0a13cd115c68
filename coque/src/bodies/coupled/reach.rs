//! Structures that nothing holds and that may get to a wall, which they would not feel.

use sph_core::{CellList, Vec3};

use crate::bodies::fluid::walls::BuiltWalls;
use crate::scene::body_in_scene::{BodyInScene, gravity_on};
use crate::scene::{Analysis, BodyScene, FluidScene, SupportKind};
use crate::warning::{Warning, WarningKind};

/// What nothing holds, where it is.
pub(super) struct Loose<'a> {
    pub scene: &'a BodyInScene<'a>,
    /// Its particles in the plane of the fluid \[L\].
    pub places: &'a [Vec3],
    /// Mean distance of its particles \[L\].
    pub apart: f64,
}

impl Loose<'_> {
    /// Whether a support keeps it from going along a direction; from going anywhere without.
    pub fn held(&self, along: Option<&Vec3>) -> bool {
        const LEAST: f64 = 1e-6;
        let has = |direction: &Vec3| {
            along.is_none_or(|along| along.dot(&direction.normalize()).abs() > LEAST * along.norm())
        };
        let keeps = |kind: &SupportKind| {
            // A plane of symmetry leaves the others free.
            (along.is_some() || !matches!(kind, SupportKind::Symmetry(_))) && kind.keeps().iter().any(has)
        };
        self.scene.supports.iter().any(|support| support.kinds().iter().any(|(_, kind)| keeps(kind)))
    }

    /// Whether a load but gravity acts on it.
    fn driven(&self) -> bool {
        self.scene.loads.iter().any(|load| load.gravity.is_none())
    }

    /// Its density, where all of it is wet.
    fn density(&self) -> Option<f64> {
        match self.scene.body {
            BodyScene::Solid(solid) => Some(solid.material.density()),
            BodyScene::Shell(shell) if shell.wets_both() => shell.density(),
            BodyScene::Rigid(rigid) => rigid.mean_density(),
            _ => None,
        }
    }

    /// The warning of one that sinks or falls, and that a fall from rest takes to a wall within the run.
    pub fn may_reach(
        &self,
        wanted: &FluidScene,
        fluid: &[Vec3],
        walls: &[BuiltWalls<'_>],
    ) -> Option<Warning> {
        let gravity = gravity_on(self.scene.scene, self.scene.name);
        let down = gravity.try_normalize(0.0)?;
        if self.held(Some(&gravity)) || self.driven() {
            return None;
        }
        let lowest = self.places.iter().map(|x| x.dot(&down)).fold(f64::NEG_INFINITY, f64::max);
        let across = |x: &Vec3| x - down * x.dot(&down);
        let own: Vec<Vec3> = self.places.iter().map(across).collect();
        let reach = self.apart.max(wanted.geometry.spacing());
        let list = CellList::new(&own, reach);
        let mut found = Vec::new();
        // How far below it a place is that it would fall on.
        let mut below = |x: &Vec3| {
            let height = x.dot(&down) - lowest;
            if height <= 0.0 {
                return None;
            }
            list.within(&across(x), reach, &mut found);
            (!found.is_empty()).then_some(height)
        };
        let wall = |body: &BuiltWalls<'_>, below: &mut dyn FnMut(&Vec3) -> Option<f64>| {
            let points = body.rows.pieces.iter().flat_map(|piece| &piece.points);
            points.filter_map(below).min_by(f64::total_cmp)
        };
        let touched = |body: &BuiltWalls<'_>| {
            let contact = &self.scene.scene.contact;
            contact.iter().any(|own| own.other(body.view.name) == Some(self.scene.name))
        };
        let acting = walls.iter().filter(|body| !touched(body));
        let nearest = acting.filter_map(|body| Some((body.view.name, wall(body, &mut below)?)));
        let (wall, way) = nearest.min_by(|a, b| a.1.total_cmp(&b.1))?;
        // Faces lie half a spacing before the first row.
        let way = way - 0.5 * wanted.geometry.spacing();
        let time = match self.scene.analysis {
            Analysis::Explicit(explicit) => {
                explicit.transient.as_ref().map_or(0.0, |transient| transient.duration.get())
            }
            _ => 0.0,
        };
        let thrown = self.scene.body.velocity().is_some();
        if !thrown && way > 0.5 * gravity.norm() * time * time {
            return None;
        }
        let denser = self.density().filter(|density| *density > wanted.liquid().density.get());
        let why = match denser {
            Some(density) => format!("is denser than the fluid ({density} for {})", wanted.liquid().density),
            None if fluid.iter().all(|x| below(x).is_none()) => "has no fluid below it".into(),
            None => return None,
        };
        let name = self.scene.name;
        let message = format!(
            "{name}: nothing holds it along gravity, and it {why}: it may get to `{wall}`, {way:.4} below it, within the run. \
             Structures and walls feel each other where a [[contact]] names a body and walls that are a basin or a block, else it \
             would go on through the wall; name that, hold it, or end the run before (the summary then says whether it got there)"
        );
        Some(Warning::new(WarningKind::NoContact, message))
    }
}

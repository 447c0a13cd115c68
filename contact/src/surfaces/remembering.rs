//! What friction of surfaces remembers: anchors that are committed, what was lost at nodes, both as a history that is kept and taken up.

use sph_core::Vec3;

use super::reaching::nearest;
use super::{Node, SurfaceContact};
use crate::grips::{Grip, along_sides};

impl SurfaceContact {
    /// Makes the anchors of the forces last evaluated those that count.
    pub fn commit(&mut self) {
        let Self { meshes, passes, rubbing, .. } = self;
        let Some(rubbing) = rubbing else { return };
        let lost = &mut rubbing.lost;
        let mut share = |body: usize, vertex: u32, energy: f64| {
            let vertex = &meshes[body].surface().vertices()[vertex as usize];
            vertex.nodes().iter().for_each(|&a| lost[body][a as usize] += energy * vertex.share());
        };
        rubbing.grips.commit(|grip, energy| {
            let pass = &passes[grip.of.0 as usize];
            share(pass.of, grip.of.1, 0.5 * energy);
            let corners = meshes[pass.on].faces()[grip.face as usize];
            corners.iter().for_each(|&corner| share(pass.on, corner, energy / 6.0));
        });
    }

    /// Gives what is near and touches nothing an anchor at its foot, for what it touches in the next step where that is long: it has slipped from
    /// there when it comes to touch.
    pub fn hover(&mut self, at: impl Fn(Node) -> Vec3) {
        let Self { meshes, passes, rubbing, .. } = self;
        let Some(rubbing) = rubbing else { return };
        let kept = &mut rubbing.grips.kept;
        let gripping = kept.len();
        for (number, pass) in passes.iter().enumerate() {
            let (own, other) = (&meshes[pass.of], &meshes[pass.on]);
            let vertices = 0..other.surface().vertices().len() as u32;
            let places: Vec<Vec3> = vertices.map(|v| other.place(v, |a| at((pass.on, a)))).collect();
            for (vertex, faces) in pass.list.after(f64::INFINITY) {
                let of = (number as u32, vertex);
                if kept[..gripping].binary_search_by_key(&of, |grip| grip.of).is_ok() {
                    continue;
                }
                let point = own.place(vertex, |a| at((pass.of, a)));
                let near = faces.map(|face| (face, nearest(other, face, point, &places)));
                let Some((face, pair)) = near.min_by(|(_, a), (_, b)| a.distance.total_cmp(&b.distance))
                else {
                    continue;
                };
                let corners = other.faces()[face as usize].map(|corner| places[corner as usize]);
                let anchor = along_sides(corners, &(point - pair.normal * pair.distance - corners[0]));
                kept.push(Grip { of, face, anchor, stretch: [0.0; 2], lost: 0.0, holds: true });
            }
        }
        kept.sort_by_key(|grip| grip.of);
    }

    /// Energy that friction took on the way to the forces last evaluated, from what was committed \[F L\].
    pub fn lost(&self) -> f64 {
        self.rubbing.as_ref().map_or(0.0, |rubbing| rubbing.grips.lost())
    }

    /// Energy that friction has taken at a node until the last commit, one half on either side \[F L\].
    pub fn lost_at(&self, (body, a): Node) -> f64 {
        let lost = self.rubbing.as_ref().and_then(|rubbing| rubbing.lost[body].get(a as usize));
        lost.copied().unwrap_or_default()
    }

    /// The committed history: losses of all nodes, then anchors; nothing without friction.
    pub fn history(&self) -> Vec<f64> {
        let all = self.rubbing.iter();
        all.flat_map(|rubbing| rubbing.lost.iter().flatten().copied().chain(rubbing.grips.numbers()))
            .collect()
    }

    /// Takes up a history; false, and nothing changed, if it is that of others.
    pub fn take_up_history(&mut self, history: &[f64]) -> bool {
        let Self { meshes, passes, rubbing, .. } = self;
        let Some(rubbing) = rubbing else { return history.is_empty() };
        let count = rubbing.lost.iter().map(Vec::len).sum();
        let Some((lost, grips)) = history.split_at_checked(count) else { return false };
        let fits = |grip: &Grip| {
            passes.get(grip.of.0 as usize).is_some_and(|pass| {
                (grip.of.1 as usize) < meshes[pass.of].surface().vertices().len()
                    && (grip.face as usize) < meshes[pass.on].faces().len()
            })
        };
        if !rubbing.grips.take_up(grips, fits) {
            return false;
        }
        rubbing.lost.iter_mut().flatten().zip(lost).for_each(|(own, lost)| *own = *lost);
        true
    }
}

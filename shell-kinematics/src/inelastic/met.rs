//! What is met at the points of a section: by the law, by elasticity alone, or by a commit that writes what becomes of them.

use super::functions::three;
use super::layer::Layer;
use super::point::{OF_SLICE, Pace, Point};
use super::return_map::PointLaw;
use super::slices::Slice;
use crate::pack::{Number, Pack};

/// What is met at a point of a given strain, whose numbers lie at a place of a history.
pub(super) trait Met<P> {
    /// Its stress, in the coordinates of its ply's modes.
    fn stress(&mut self, layer: &Layer, slice: &Slice, place: usize, strain: &[P; 3]) -> [P; 3];
}

/// The law.
pub(super) struct Flowing<R> {
    pub read: R,
}

impl<P: Number, R: Fn(usize) -> P> Met<P> for Flowing<R> {
    #[inline(always)]
    fn stress(&mut self, layer: &Layer, _: &Slice, place: usize, strain: &[P; 3]) -> [P; 3] {
        match &layer.law {
            Some(law) if !law.loses_more() => law.plain_step(strain, &Layer::plain(&self.read, place)).stress,
            Some(law) => {
                let before = layer.committed(law, &self.read, place);
                law.step(strain, &before, layer.pace(law, &self.read, place)).stress
            }
            None => *strain,
        }
    }
}

/// Elasticity, all points as they were committed.
pub(super) struct Held<'a>(pub &'a [Pack]);

impl Met<Pack> for Held<'_> {
    fn stress(&mut self, layer: &Layer, _: &Slice, place: usize, strain: &[Pack; 3]) -> [Pack; 3] {
        if layer.law.is_none() {
            return *strain;
        }
        three(|i| strain[i] - self.0[place + i])
    }
}

/// The law, whose new numbers are written.
pub(super) struct Committing<'a, P, R, W> {
    /// Time of the step \[T\]; infinite at rest.
    pub duration: f64,
    pub read: R,
    pub write: &'a mut W,
    /// `Σ w ln λ₃`.
    pub log_thickness: P,
    /// `Σ w z² pγ/(1 + pγ)`, and `Σ w z²`.
    pub eased: P,
    pub whole: f64,
    /// What was dissipated beside `Σ w K(0) α`.
    pub lost: P,
}

impl<P: Number, R: Fn(usize) -> P, W: FnMut(usize, P)> Met<P> for Committing<'_, P, R, W> {
    #[inline(always)]
    fn stress(&mut self, layer: &Layer, slice: &Slice, place: usize, strain: &[P; 3]) -> [P; 3] {
        let share = slice.weight * slice.height * slice.height;
        self.whole += share;
        let Some(law) = &layer.law else {
            for i in 0..3 {
                self.log_thickness += strain[i] * layer.thinning[0][i] * slice.weight;
            }
            return *strain;
        };
        let point = if law.loses_more() {
            self.more(layer, law, slice, place, strain)
        } else {
            law.plain_step(strain, &Layer::plain(&self.read, place))
        };
        for i in 0..3 {
            (self.write)(place + i, point.plastic[i]);
            let thinner = point.stress[i] * layer.thinning[0][i] + point.plastic[i] * layer.thinning[1][i];
            self.log_thickness += thinner * slice.weight;
        }
        (self.write)(place + 3, point.alpha);
        let flow = point.gamma * law.mean_yielding();
        self.eased += flow / (flow + point.gamma.all(1.0)) * share;
        point.stress
    }
}

impl<P: Number, R: Fn(usize) -> P, W: FnMut(usize, P)> Committing<'_, P, R, W> {
    /// The step of a law with back stresses that recover or a rate, whose own numbers are written.
    #[inline(always)]
    fn more(
        &mut self,
        layer: &Layer,
        law: &PointLaw,
        slice: &Slice,
        place: usize,
        strain: &[P; 3],
    ) -> Point<P> {
        let before = layer.committed(law, &self.read, place);
        let in_time = law.is_rated() && self.duration < f64::INFINITY;
        let pace = if in_time { Pace::Lasting(self.duration) } else { Pace::Slow };
        let point = law.step(strain, &before, pace);
        let after = law.after(&point, &before);
        self.lost += law.lost(point.overstress, &before, &after) * slice.weight;
        for number in 0..law.backs.len() {
            for i in 0..3 {
                (self.write)(place + OF_SLICE + 3 * number + i, after.backs[number][i]);
            }
        }
        if law.is_rated() {
            (self.write)(place + layer.of_slice - 1, point.overstress);
        }
        point
    }
}

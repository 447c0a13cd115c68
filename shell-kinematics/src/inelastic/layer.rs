//! A ply of a section that yields: its law, if it yields itself, its points, and their strains.

use super::functions::three;
use super::modes::Modes;
use super::point::{Committed, MOST_BACK_STRESSES, OF_SLICE, Pace};
use super::return_map::PointLaw;
use super::slices::Slice;
use super::thickness::Lever;
use crate::pack::Number;
use crate::strains::Strains;

/// One ply with its points.
#[derive(Clone, Debug)]
pub(super) struct Layer {
    /// None where it is elastic.
    pub law: Option<PointLaw>,
    pub modes: Modes,
    pub slices: Vec<Slice>,
    /// The place of its first number in a history, if it has any.
    pub first: usize,
    /// How many numbers a slice has there.
    pub of_slice: usize,
    /// `∂ ln λ₃/∂x` and `∂ ln λ₃/∂e_p` of the ply alone.
    pub thinning: [[f64; 3]; 2],
}

/// Strains through the thickness of a ply, in the coordinates of its modes.
#[derive(Clone, Copy)]
pub(super) struct Across<P> {
    middle: [P; 3],
    slope: [P; 3],
}

impl<P: Number> Across<P> {
    #[inline(always)]
    pub fn at(&self, slice: &Slice) -> [P; 3] {
        three(|i| self.middle[i] + self.slope[i] * slice.height)
    }
}

impl Layer {
    #[inline(always)]
    pub fn across<P: Number>(&self, strains: &Strains<P>, lever: &Lever<P>) -> Across<P> {
        Across {
            middle: self.modes.of_strains(&strains.membrane),
            slope: self.modes.of_strains(&lever.slope(&strains.curvature)),
        }
    }

    /// How many numbers of a history it has.
    pub fn numbers(&self) -> usize {
        if self.law.is_some() { self.of_slice * self.slices.len() } else { 0 }
    }

    /// The pace of what is asked outside a commit, from the numbers of a point that yields.
    #[inline(always)]
    pub fn pace<P>(&self, law: &PointLaw, read: impl Fn(usize) -> P, place: usize) -> Pace<P> {
        if law.is_rated() { Pace::Held(read(place + self.of_slice - 1)) } else { Pace::Slow }
    }

    /// The numbers that every point that yields has, in a history: e_p and α.
    #[inline(always)]
    pub fn plain<P>(read: impl Fn(usize) -> P, place: usize) -> [P; OF_SLICE] {
        [read(place), read(place + 1), read(place + 2), read(place + 3)]
    }

    /// All numbers of a point that yields, in a history.
    #[inline(always)]
    pub fn committed<P: Number>(
        &self,
        law: &PointLaw,
        read: impl Fn(usize) -> P,
        place: usize,
    ) -> Committed<P> {
        let [p0, p1, p2, alpha] = Self::plain(&read, place);
        let mut backs = [[alpha.all(0.0); 3]; MOST_BACK_STRESSES];
        for (number, back) in backs.iter_mut().enumerate().take(law.backs.len()) {
            let first = place + OF_SLICE + 3 * number;
            *back = [read(first), read(first + 1), read(first + 2)];
        }
        Committed { plastic: [p0, p1, p2], alpha, backs }
    }

    /// Its points, each with the place of its numbers in a history, if it yields.
    #[inline(always)]
    pub fn points(&self) -> impl Iterator<Item = (&Slice, usize)> {
        self.slices.iter().enumerate().map(|(i, slice)| (slice, self.first + self.of_slice * i))
    }
}

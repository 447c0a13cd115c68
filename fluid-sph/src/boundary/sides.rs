//! On which side of a thin structure a particle of the fluid is.
//!
//! A kernel reaches through a body thinner than it is wide. The sign of the way from the nearest place of the middle surface
//! along the normal there tells the side. Particles on opposite sides do not see each other, and none sees the points of
//! the other face. Past a free edge both sides meet: particles there see all of the fluid, and of the points those of the
//! nearer face, for both would be a wall twice as dense.

use explicit_dynamics::{BoundaryState, Face, ThinLayout};
use sph_core::Vec3;

use crate::cells::Grid;
use crate::sorted::Sorted;

/// Places beside one on an edge, over the distance to the nearest: they tell which way is outwards.
const BESIDE: f64 = 2.5;

/// A thin structure, as the fluid sees it.
#[derive(Clone, Debug)]
pub(crate) struct Thin {
    /// The two bits of its faces.
    front: u32,
    back: u32,
    /// Distance from the middle surface up to which sides matter \[L\].
    reach: f64,
    dimensions: usize,
    /// Places of the middle surface and the normals there.
    middle: Vec<Vec3>,
    normals: Vec<Vec3>,
    /// By place on a free edge: places beside it; none elsewhere.
    beside: Vec<Vec<u32>>,
    grid: Grid,
    sorted: Sorted,
}

impl Thin {
    /// The structure of a number among the thin ones; `reach` beyond its thickness \[L\].
    pub fn new(
        number: usize,
        dimensions: usize,
        layout: &ThinLayout,
        state: &BoundaryState,
        reach: f64,
    ) -> Self {
        let mut thin = Self {
            front: 1 << (2 * number),
            back: 2 << (2 * number),
            reach: layout.thickness + reach,
            dimensions,
            middle: Vec::new(),
            normals: Vec::new(),
            beside: Vec::new(),
            grid: Grid::around(dimensions, std::iter::empty(), reach),
            sorted: Sorted::default(),
        };
        thin.place(state);
        let beside = |place: usize| if layout.edges[place] { thin.places_beside(place) } else { Vec::new() };
        thin.beside = (0..thin.middle.len()).map(beside).collect();
        thin
    }

    /// The places near one, those in its own place left out.
    fn places_beside(&self, place: usize) -> Vec<u32> {
        let distance = |other: &Vec3| (other - self.middle[place]).norm();
        let own = 1e-6 * self.reach;
        let nearest = self.middle.iter().map(distance).filter(|&r| r > own).fold(f64::INFINITY, f64::min);
        let near = |r: f64| r > own && r < BESIDE * nearest;
        (0..self.middle.len() as u32).filter(|&other| near(distance(&self.middle[other as usize]))).collect()
    }

    /// The bit of a face.
    pub fn bit(&self, face: Face) -> u32 {
        match face {
            Face::Front => self.front,
            Face::Back => self.back,
        }
    }

    /// Puts the middle surface into its present place.
    pub fn place(&mut self, state: &BoundaryState) {
        let plane =
            |v: &[f64; 3]| if self.dimensions == 2 { Vec3::new(v[0], v[1], 0.0) } else { Vec3::from(*v) };
        self.middle.clear();
        self.middle.extend(state.middle.iter().map(plane));
        self.normals.clear();
        self.normals.extend(state.normals.iter().map(plane));
        self.grid = Grid::around(self.dimensions, self.middle.iter().copied(), self.reach);
        let middle = &self.middle;
        self.sorted.sort(1, &self.grid, middle.len(), |i, _| Some(middle[i].into()));
    }

    /// The face that a place sees, and again if it does not see past an edge; neither where it is far away.
    pub fn sees(&self, at: [f64; 3]) -> [u32; 2] {
        let at = Vec3::from(at);
        let cell = self.grid.cell(&at.into());
        if cell as usize >= self.grid.len() {
            return [0; 2];
        }
        let mut nearest = (self.reach * self.reach, None);
        for &(from, to) in self.grid.beside(cell, &self.sorted.starts).filled() {
            for &place in &self.sorted.order[from as usize..to as usize] {
                let square = (at - self.middle[place as usize]).norm_squared();
                if square < nearest.0 {
                    nearest = (square, Some(place as usize));
                }
            }
        }
        let Some(place) = nearest.1 else { return [0; 2] };
        let away = at - self.middle[place];
        let face = if away.dot(&self.normals[place]) >= 0.0 { self.front } else { self.back };
        let inwards = |&other: &u32| self.middle[other as usize] - self.middle[place];
        let inwards: Vec3 = self.beside[place].iter().map(inwards).sum();
        let beyond = away.dot(&inwards) < 0.0;
        [face, if beyond { 0 } else { face }]
    }

    /// Numbers that change, for a state.
    pub fn state(&self) -> impl Iterator<Item = f64> {
        self.middle.iter().chain(&self.normals).flat_map(|v| [v.x, v.y, v.z])
    }

    /// How many numbers [`Thin::state`] has.
    pub fn state_len(&self) -> usize {
        6 * self.middle.len()
    }

    /// Puts numbers of [`Thin::state`] back.
    pub fn set_state(&mut self, numbers: &[f64]) {
        let (middle, normals) = numbers.split_at(numbers.len() / 2);
        let list = |numbers: &[f64]| numbers.chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect();
        self.place(&BoundaryState { points: Vec::new(), middle: list(middle), normals: list(normals) });
    }
}

//! What instruments would read: pressures at places and walls, levels, moments on structures, the free surface.

use sph_core::Vec3;

use crate::cells::{Grid, NOWHERE};
use crate::fluid::Fluid;
use crate::periods::Copies;
use crate::sorted::Sorted;

/// Part of space that particles near a place must fill for it to be wet.
const WET: f64 = 0.1;
/// Part that they fill at a surface.
const SURFACE: f64 = 0.5;
/// Divergence of positions, 2 or 3 inside, below which it tells a free surface \[lee2008\]: in a plane, in space.
const OPEN: [f64; 2] = [1.5, 2.4];

/// Between the heights at which a column is looked at, in spacings.
const STRIDE: f64 = 0.25;

/// The particles about a line along −g.
struct Column<'a> {
    fluid: &'a Fluid,
    up: Vec3,
    /// Where the line passes the height zero \[L\].
    foot: Vec3,
    particles: Vec<usize>,
    /// Between which heights places may be wet \[L\].
    bottom: f64,
    top: f64,
}

impl<'a> Column<'a> {
    fn new(fluid: &'a Fluid, point: Vec3) -> Self {
        let (point, up, h) = (fluid.plane(point), fluid.up(), fluid.momentum.kernel.h);
        let across = |at: &Vec3| {
            let way = fluid.shortest(at - point);
            (way - up * up.dot(&way)).norm_squared()
        };
        let positions = &fluid.shown().positions;
        let particles: Vec<usize> = fluid.here().filter(|&i| across(&positions[i]) < 4.0 * h * h).collect();
        let heights = particles.iter().map(|&i| up.dot(&positions[i]));
        let (bottom, top) =
            heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
        let foot = point - up * up.dot(&point);
        Self { fluid, up, foot, particles, bottom: bottom - 2.0 * h, top: top + 2.0 * h }
    }

    /// The part of space that particles fill at a height.
    fn filled(&self, height: f64) -> f64 {
        self.fluid.mean(self.foot + self.up * height, self.particles.iter().copied()).0
    }
}

impl Fluid {
    /// Pressure at a place \[F/L²\]: the mean of the fluid about it, carried there by gravity; none where it is dry.
    pub fn pressure_at(&self, point: Vec3) -> Option<f64> {
        let (filled, weight, pressure) = self.mean(self.plane(point), self.here());
        (filled >= WET).then(|| pressure / weight)
    }

    /// Pressures at the particles of a wall \[F/L²\], those of [`Fluid::pressure_at`]; zero where it is dry.
    pub fn wall_pressures(&self, wall: usize) -> Vec<f64> {
        self.means_at(self.wall_positions(wall))
    }

    /// Pressures at the points of a structure \[F/L²\], as [`Fluid::wall_pressures`].
    pub fn structure_pressures(&self, structure: usize) -> Vec<f64> {
        self.means_at(&self.boundary.points[self.boundary.structure(structure)])
    }

    /// Moment of the fluid on a structure about a point \[F L; F in a plane\], of the last evaluation: that of the forces on its
    /// points, of a shell of those on its faces.
    pub fn structure_moment(&self, structure: usize, about: Vec3) -> Vec3 {
        let range = self.boundary.structure(structure);
        let pairs = self.boundary.points[range.clone()].iter().zip(&self.boundary.forces[range]);
        pairs.map(|(point, force)| (point - about).cross(&Vec3::from(*force))).sum()
    }

    /// Height along −g (the second axis in a plane, the third in space, without gravity) of the highest wet place of the
    /// column through a point \[L\]: where particles fill half of space. The point's own height if the column is dry.
    pub fn level_at(&self, point: Vec3) -> f64 {
        let column = Column::new(self, point);
        let stride = STRIDE * self.spacing;
        let mut level = column.top;
        while level >= column.bottom {
            if column.filled(level) >= SURFACE {
                let (mut wet, mut dry) = (level, level + stride);
                for _ in 0..20 {
                    let middle = 0.5 * (wet + dry);
                    if column.filled(middle) >= SURFACE { wet = middle } else { dry = middle }
                }
                return wet;
            }
            level -= stride;
        }
        column.up.dot(&self.plane(point))
    }

    /// Length of the column through a point along −g, as [`Fluid::level_at`], in which particles fill half of space or
    /// more \[L\]: what a gauge of wire tells. Sheets that fly over the water count as thick as they are, air below them not.
    pub fn wet_length_at(&self, point: Vec3) -> f64 {
        let column = Column::new(self, point);
        let stride = STRIDE * self.spacing;
        let mut length = 0.0;
        let (mut level, mut below) = (column.bottom, column.filled(column.bottom) - SURFACE);
        while level < column.top {
            level += stride;
            let above = column.filled(level) - SURFACE;
            length += match (below >= 0.0, above >= 0.0) {
                (true, true) => stride,
                (true, false) => stride * below / (below - above),
                (false, true) => stride * above / (above - below),
                (false, false) => 0.0,
            };
            below = above;
        }
        length
    }

    /// By particle: whether it lies at a free surface, where the divergence of positions falls short of the dimensions.
    pub fn free_surface(&self) -> Vec<bool> {
        let kernel = self.momentum.kernel;
        let volume = |density: f64| self.mass / density;
        let positions = &self.shown().positions;
        let near = Nearby::new(self);
        let open = |a: usize| {
            let at = positions[a];
            let mut divergence = 0.0;
            near.each(at, |b| {
                let square = self.shortest(at - positions[b]).norm_squared();
                divergence -= volume(self.shown().densities[b]) * kernel.factor(square.sqrt()) * square;
            });
            near.each_boundary(at, |b| {
                let square = self.shortest(at - self.boundary.points[b]).norm_squared();
                divergence -= volume(self.liquid.density) * kernel.factor(square.sqrt()) * square;
            });
            divergence < OPEN[usize::from(self.dimensions == 3)]
        };
        (0..self.len()).map(|a| self.is_here(a) && open(a)).collect()
    }

    /// The direction in which levels are measured: along a flow that goes round nothing has a height.
    pub(crate) fn up(&self) -> Vec3 {
        let gravity = self.gravity_across();
        let strength = gravity.norm();
        match (strength > 0.0, self.dimensions) {
            (true, _) => -gravity / strength,
            (false, 2) => Vec3::y(),
            (false, _) => Vec3::z(),
        }
    }

    /// Numbers of the particles in the flow.
    fn here(&self) -> impl Iterator<Item = usize> {
        (0..self.len()).filter(|&i| self.is_here(i))
    }

    fn plane(&self, at: Vec3) -> Vec3 {
        if self.dimensions == 2 { Vec3::new(at.x, at.y, 0.0) } else { at }
    }

    /// What particles fill of a place, the sum of their weights, and that of weighted pressures.
    fn mean(&self, at: Vec3, particles: impl Iterator<Item = usize>) -> (f64, f64, f64) {
        let kernel = self.momentum.kernel;
        let (mut filled, mut weight, mut pressure) = (0.0, 0.0, 0.0);
        for i in particles {
            let way = self.shortest(at - self.shown().positions[i]);
            let square = way.norm_squared();
            if square < kernel.reach2 {
                let density = self.shown().densities[i];
                let own = kernel.value(square.sqrt());
                weight += own;
                filled += own * self.mass / density;
                pressure += own * (self.liquid.pressure(density) + density * self.gravity.dot(&way));
            }
        }
        (filled, weight, pressure)
    }

    fn means_at(&self, points: &[Vec3]) -> Vec<f64> {
        let near = Nearby::new(self);
        let pressure = |point: &Vec3| {
            let mut particles = Vec::new();
            near.each(self.within(*point), |i| particles.push(i));
            let (filled, weight, pressure) = self.mean(*point, particles.into_iter());
            if filled >= WET { pressure / weight } else { 0.0 }
        };
        points.iter().map(pressure).collect()
    }
}

/// The particles of a fluid by cells, found anew for whoever asks between two steps.
struct Nearby {
    grid: Grid,
    fluid: (Sorted, Copies),
    boundary: (Sorted, Copies),
}

impl Nearby {
    /// Of the present places.
    fn new(fluid: &Fluid) -> Self {
        let (positions, points) = (&fluid.shown().positions, &fluid.boundary.points);
        let width = 2.0 * fluid.momentum.kernel.h;
        let copied = |list: &[Vec3]| {
            let mut copies = Copies::default();
            if let Some(periods) = fluid.periods() {
                copies.find(periods, list.len(), width, |i| list[i]);
            }
            copies
        };
        let (own, of_points) = (copied(positions), copied(points));
        let place = |number: usize| own.place(number, |i| positions[i]);
        let grid = Grid::around(fluid.dimensions, (0..own.all(positions.len())).map(place), width);
        let openings = fluid.openings.as_deref();
        let [here, points_here] =
            [openings.map_or(&[][..], |own| &own.here), openings.map_or(&[][..], |own| &own.near)];
        let sorted = |list: &[Vec3], copies: Copies, present: &[bool]| {
            let mut sorted = Sorted::default();
            let is_present = |i: usize| present.get(i).is_none_or(|present| *present);
            let place = |number: usize, _: &[u32]| {
                is_present(copies.source(number)).then(|| copies.place(number, |i| list[i]).into())
            };
            sorted.sort(1, &grid, copies.all(list.len()), place);
            (sorted, copies)
        };
        let (fluid, boundary) =
            (sorted(positions, own.clone(), here), sorted(points, of_points, points_here));
        Self { grid, fluid, boundary }
    }

    /// Calls for each particle of the fluid that may be within reach of a place.
    fn each(&self, at: Vec3, call: impl FnMut(usize)) {
        self.of(&self.fluid, at, call);
    }

    /// Calls for each particle of a boundary that may be within reach of a place.
    fn each_boundary(&self, at: Vec3, call: impl FnMut(usize)) {
        self.of(&self.boundary, at, call);
    }

    fn of(&self, (set, copies): &(Sorted, Copies), at: Vec3, mut call: impl FnMut(usize)) {
        let cell = self.grid.cell(&at.into());
        if cell == NOWHERE {
            return;
        }
        for &(from, to) in self.grid.beside(cell, &set.starts).filled() {
            let order = &set.order[from as usize..to as usize];
            order.iter().for_each(|&number| call(copies.source(number as usize)));
        }
    }
}

//! Images of nodes in planes of symmetry: bonds reach across a plane as if the body went on there.
//!
//! A body unfolds along each axis into cells, its own the cell 0. An even cell c repeats the body, an odd one mirrors it:
//!
//! ```text
//! x' = x + cL        x' = 2x₀ + (c + 1) L − x        x₀, x₀ + L the two planes
//! ```
//!
//! with one plane the cells are 0 and −1, or 0 and 1. What a node j in cell c is to a node i, i in the cell −c, or c where it is
//! odd, is to j.
//!
//! Nodes on n planes are their own images there, and belong to the body with a part `s = 2⁻ⁿ`. All that the bonds of such a node
//! hold counts with s: stiffnesses and shares D of dilatations are taken s times as seen from it, its factor `(λ − μ) V` over s.
//! Then `(λ − μ) V θ` is that of the whole node, and its force and energy are s times those of the whole.

use std::borrow::Cow;
use std::collections::BTreeMap;

use sph_core::Vec3;

use crate::error::SolidError;
use crate::mirror::{Mirror, ON_PLANE};

/// A node on its way through a sweep: position \[L\], and `(λ − μ) V θ` \[F L\].
pub(crate) type Row = [f64; 4];

/// A cell of the unfolded body.
type Cell = [i32; 3];

/// The images of the nodes of a body, numbered behind them.
#[derive(Clone, Debug)]
pub(crate) struct Images {
    /// Nodes of the body.
    count: usize,
    /// For each node and axis: −1 on the lower plane, 1 on the upper, else 0.
    on: Vec<Cell>,
    images: Vec<Image>,
    numbers: BTreeMap<(u32, Cell), u32>,
}

/// An image: `x' = signs x + shifts`.
#[derive(Clone, Debug)]
struct Image {
    source: u32,
    cell: Cell,
    signs: [f64; 3],
    shifts: [f64; 3],
}

impl Images {
    /// The images within a distance of the body; nothing without planes.
    ///
    /// # Errors
    /// [`SolidError::Mirror`] for a plane that the body does not lie on one side of.
    pub fn new(
        positions: &[Vec3],
        mirrors: &[Mirror],
        spacing: f64,
        distance: f64,
    ) -> Result<Option<Self>, SolidError> {
        if mirrors.is_empty() {
            return Ok(None);
        }
        let planes = planes(positions, mirrors, spacing)?;
        let on = |x: &Vec3| {
            let near =
                |plane: Option<f64>, a: usize| plane.is_some_and(|p| (x[a] - p).abs() <= ON_PLANE * spacing);
            std::array::from_fn(|a| i32::from(near(planes[a][1], a)) - i32::from(near(planes[a][0], a)))
        };
        let mut out = Self {
            count: positions.len(),
            on: positions.iter().map(on).collect(),
            images: Vec::new(),
            numbers: BTreeMap::new(),
        };
        let cells = planes.map(|planes| reached(planes, distance));
        let bounds = extent(positions);
        for (source, x) in positions.iter().enumerate() {
            for i in cells[0].clone() {
                for j in cells[1].clone() {
                    for k in cells[2].clone() {
                        let cell = [i, j, k];
                        if cell == [0; 3] || out.own(source, cell) != cell {
                            continue;
                        }
                        let image = Image::new(source as u32, cell, &planes);
                        let near = |a: usize| {
                            let at = image.signs[a] * x[a] + image.shifts[a];
                            bounds[a][0] - at <= distance && at - bounds[a][1] <= distance
                        };
                        if (0..3).all(near) {
                            let number = (out.count + out.images.len()) as u32;
                            out.numbers.insert((source as u32, cell), number);
                            out.images.push(image);
                        }
                    }
                }
            }
        }
        Ok(Some(out))
    }

    /// Of cells that hold the same image of a node on planes, one.
    fn own(&self, node: usize, cell: Cell) -> Cell {
        std::array::from_fn(|a| if cell[a].rem_euclid(2) == 1 { cell[a] - self.on[node][a] } else { cell[a] })
    }

    /// Number of images.
    pub fn len(&self) -> usize {
        self.images.len()
    }

    fn image(&self, number: usize) -> Option<&Image> {
        self.images.get(number.checked_sub(self.count)?)
    }

    /// The node that a number means, or is an image of.
    #[inline]
    pub fn source(&self, number: usize) -> usize {
        self.image(number).map_or(number, |image| image.source as usize)
    }

    /// What an image makes of components along the axes: 1 or −1.
    #[inline]
    pub fn signs(&self, number: usize) -> [f64; 3] {
        self.image(number).map_or([1.0; 3], |image| image.signs)
    }

    /// Through which plane across an axis one sees an end: −1 the lower, 1 the upper, 0 none.
    pub fn side(&self, other: usize, axis: usize) -> i32 {
        self.image(other).map_or(0, |image| image.cell[axis].signum())
    }

    /// How often the body counts what crosses a plane at a node: twice on the plane, where half belongs to the image.
    pub fn counts(&self, node: usize, axis: usize) -> f64 {
        if self.on[node][axis] == 0 { 1.0 } else { 2.0 }
    }

    /// The part of a node that belongs to the body: one half for each plane that it lies on.
    pub fn share(&self, node: usize) -> f64 {
        self.on[node].iter().map(|&side| if side == 0 { 1.0 } else { 0.5 }).product()
    }

    /// What a node is to the one that it sees as `other`.
    pub fn seen_back(&self, node: usize, other: usize) -> usize {
        let cell = self.image(other).map_or([0; 3], |image| image.cell);
        self.find(node, cell.map(|c| if c % 2 == 0 { -c } else { c }))
    }

    /// The other ends, mirrored in the planes that a node lies on.
    pub fn beside(&self, node: usize, other: usize) -> impl Iterator<Item = usize> + '_ {
        let (source, cell) = (self.source(other), self.image(other).map_or([0; 3], |image| image.cell));
        (0..3).filter(move |&a| self.on[node][a] != 0).map(move |a| {
            let mut mirrored = cell;
            mirrored[a] = self.on[node][a] - cell[a];
            self.find(source, mirrored)
        })
    }

    /// The number of a node in a cell; its own where there is no image of it.
    fn find(&self, node: usize, cell: Cell) -> usize {
        self.numbers.get(&(node as u32, self.own(node, cell))).map_or(node, |&number| number as usize)
    }

    /// Rows with the positions of images behind them.
    pub fn place(&self, rows: &mut [Row]) {
        let (nodes, images) = rows.split_at_mut(self.count);
        for (row, image) in images.iter_mut().zip(&self.images) {
            *row = image.of(&nodes[image.source as usize], 1.0);
        }
    }

    /// The same of displacements, or directors.
    pub fn reflect(&self, rows: &mut [Row]) {
        let (nodes, images) = rows.split_at_mut(self.count);
        for (row, image) in images.iter_mut().zip(&self.images) {
            *row = image.of(&nodes[image.source as usize], 0.0);
        }
    }

    /// The last places of the rows of images, those of their nodes.
    pub fn carry(&self, rows: &mut [Row]) {
        let (nodes, images) = rows.split_at_mut(self.count);
        for (row, image) in images.iter_mut().zip(&self.images) {
            row[3] = nodes[image.source as usize][3];
        }
    }

    /// Places with those of images behind them, or without shift directions.
    pub fn extended(&self, vectors: &[Vec3], shift: bool) -> Vec<Vec3> {
        let shift = f64::from(u8::from(shift));
        let of = |image: &Image| {
            let x = vectors[image.source as usize];
            let [x, y, z, _] = image.of(&[x.x, x.y, x.z, 0.0], shift);
            Vec3::new(x, y, z)
        };
        vectors.iter().copied().chain(self.images.iter().map(of)).collect()
    }

    /// Rows of nodes alone, with those of images behind them.
    pub fn extended_rows<'a>(this: Option<&Self>, rows: &'a [Row]) -> Cow<'a, [Row]> {
        let Some(images) = this else { return Cow::Borrowed(rows) };
        let mut out = rows[..images.count].to_vec();
        out.resize(images.count + images.len(), [0.0; 4]);
        images.place(&mut out);
        images.carry(&mut out);
        Cow::Owned(out)
    }

    /// Volumes of whole nodes and of their images, from those of the parts in the body.
    pub fn whole(&self, volumes: &[f64]) -> Vec<f64> {
        let whole: Vec<f64> = (0..self.count).map(|node| volumes[node] / self.share(node)).collect();
        let images = self.images.iter().map(|image| whole[image.source as usize]);
        whole.iter().copied().chain(images).collect()
    }
}

impl Image {
    fn new(source: u32, cell: Cell, planes: &[Planes; 3]) -> Self {
        let shift = |a: usize| {
            let [low, high] = planes[a];
            let (low, c) = (low.unwrap_or_default(), cell[a]);
            match (c, high) {
                (0, _) => 0.0,
                (1, Some(high)) => 2.0 * high,
                (_, None) => 2.0 * low,
                (_, Some(high)) if c % 2 == 0 => f64::from(c) * (high - low),
                (_, Some(high)) => 2.0 * low + f64::from(c + 1) * (high - low),
            }
        };
        let sign = |a: usize| if cell[a].rem_euclid(2) == 1 { -1.0 } else { 1.0 };
        Self { source, cell, signs: std::array::from_fn(sign), shifts: std::array::from_fn(shift) }
    }

    fn of(&self, row: &Row, shift: f64) -> Row {
        let at = |a: usize| self.signs[a] * row[a] + shift * self.shifts[a];
        [at(0), at(1), at(2), row[3]]
    }
}

/// The lower and the upper plane across an axis.
type Planes = [Option<f64>; 2];

fn planes(positions: &[Vec3], mirrors: &[Mirror], spacing: f64) -> Result<[Planes; 3], SolidError> {
    let mut out = [[None; 2]; 3];
    let bounds = extent(positions);
    for &Mirror { axis, at } in mirrors {
        let [least, most] = bounds[axis];
        let side = usize::from(at > 0.5 * (least + most));
        let inside = if side == 0 { at - least } else { most - at };
        if inside > ON_PLANE * spacing || out[axis][side].is_some_and(|other| other != at) {
            return Err(SolidError::Mirror { axis, at });
        }
        out[axis][side] = Some(at);
    }
    Ok(out)
}

/// Least and greatest coordinate along each axis.
fn extent(positions: &[Vec3]) -> [[f64; 2]; 3] {
    std::array::from_fn(|a| {
        let along = || positions.iter().map(|x| x[a]);
        [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)]
    })
}

/// The cells along an axis that may hold images within a distance.
fn reached(planes: Planes, distance: f64) -> std::ops::RangeInclusive<i32> {
    match planes {
        [None, None] => 0..=0,
        [Some(_), None] => -1..=0,
        [None, Some(_)] => 0..=1,
        [Some(low), Some(high)] => {
            let most = libm::ceil(distance / (high - low)) as i32 + 1;
            -most..=most
        }
    }
}

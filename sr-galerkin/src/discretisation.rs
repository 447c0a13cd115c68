//! Shape functions at all points of the quadrature, stored flat by background cell.

use rayon::prelude::*;
use sph_core::{FacePoint, MovingLeastSquares, PointShape, Vec3, VolumePoint};

use crate::error::GalerkinError;
use crate::images::Images;
use crate::parts::{CutCells, Parts};

/// Lanes that the rows of a cell are padded to.
pub(crate) const LANES: usize = 4;
/// Most points of a cell.
pub(crate) const MOST_POINTS: usize = 64;

/// One background cell: the nodes that any of its points sees, and the gradients of their shape functions.
pub(crate) struct Cell {
    /// Nodes, ascending.
    pub nodes: Vec<u32>,
    /// Parts of `nodes` that are numbered one after the other: first and length; none of a cell that sees images.
    pub runs: Vec<(u32, u32)>,
    /// Number of nodes, up to a multiple of the lanes.
    pub width: usize,
    /// Gradients \[1/L\]: point, direction, node; zero for what a point does not see.
    pub gradients: Vec<f64>,
    /// Volumes of the points \[L³\].
    pub volumes: Vec<f64>,
    /// For every slice of points the nodes that it sees: first, a multiple of the lanes, and end, not beyond the width.
    pub slices: Vec<(u32, u32)>,
}

impl Cell {
    /// Gradients of all nodes at a point along a direction.
    #[inline(always)]
    pub fn gradient(&self, point: usize, direction: usize) -> &[f64] {
        &self.gradients[(3 * point + direction) * self.width..][..self.width]
    }

    /// The cell, and the integrals of its shape functions and of their squares \[L³\].
    fn new(
        points: &[VolumePoint],
        squares: &MovingLeastSquares,
        images: &Images,
        slice: usize,
    ) -> Result<(Self, Vec<[f64; 2]>), GalerkinError> {
        let shapes =
            points.iter().map(|point| squares.at(&point.place)).collect::<Result<Vec<PointShape>, _>>()?;
        let mut nodes: Vec<u32> = shapes.iter().flat_map(|shape| shape.nodes.iter().copied()).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let width = nodes.len().next_multiple_of(LANES);
        let mut gradients = vec![0.0; points.len() * 3 * width];
        let mut slices = vec![(u32::MAX, 0); points.len() / slice];
        let mut integrals = vec![[0.0; 2]; nodes.len()];
        for (number, shape) in shapes.iter().enumerate() {
            let (first, end) = &mut slices[number / slice];
            let mut at = 0;
            let volume = points[number].volume;
            for ((node, gradient), value) in shape.nodes.iter().zip(&shape.gradients).zip(&shape.values) {
                while nodes[at] != *node {
                    at += 1;
                }
                integrals[at][0] += volume * value;
                integrals[at][1] += volume * value * value;
                (0..3).for_each(|k| gradients[(3 * number + k) * width + at] = gradient[k]);
                *first = (*first).min((at / LANES * LANES) as u32);
                *end = (*end).max((at + 1).next_multiple_of(LANES) as u32);
            }
        }
        let volumes = points.iter().map(|point| point.volume).collect();
        let mirrored = nodes.last().is_some_and(|&node| images.is_image(node));
        let runs = if mirrored { Vec::new() } else { runs(&nodes) };
        if mirrored {
            slices.fill((0, width as u32)); // numbers of images tell no place: slices in between may see none of them
        }
        Ok((Self { runs, nodes, width, gradients, volumes, slices }, integrals))
    }
}

/// Points of the cells.
fn quadrature(parts: &Parts) -> Result<Vec<Vec<VolumePoint>>, GalerkinError> {
    let Some(CutCells { points, shares, .. }) = &parts.cut else {
        return Ok(parts.cells.volume_points(parts.rule)?);
    };
    let (cells, each) = (parts.cells.cells.len(), parts.rule.pow(3));
    let unfit = !(1..=4).contains(&parts.rule)
        || points.len() != cells
        || shares.len() != parts.nodes.len()
        || shares.iter().any(|share| share.is_nan() || *share <= 0.0)
        || points.iter().any(|own| {
            own.len() != each || own.iter().any(|point| point.volume.is_nan() || point.volume < 0.0)
        });
    if unfit { Err(GalerkinError::Points { cells, each }) } else { Ok(points.clone()) }
}

/// Parts of a rising list that rise by one.
pub(crate) fn runs(nodes: &[u32]) -> Vec<(u32, u32)> {
    let mut out: Vec<(u32, u32)> = Vec::new();
    for (at, node) in nodes.iter().enumerate() {
        match out.last_mut() {
            Some((_, length)) if nodes[at - 1] + 1 == *node => *length += 1,
            _ => out.push((at as u32, 1)),
        }
    }
    out
}

/// The space of displacements: what is computed once.
pub(crate) struct Discretisation {
    /// Nodes at rest \[L\].
    pub nodes: Vec<Vec3>,
    /// Their images behind planes of symmetry, whose numbers follow those of the nodes wherever shape functions are.
    pub images: Images,
    /// Cells with their points.
    pub cells: Vec<Cell>,
    /// Places of all points, cell by cell \[L\].
    pub places: Vec<Vec3>,
    /// Points of a cell.
    pub points: usize,
    /// Points of a slice of a cell.
    pub slice: usize,
    /// Shape functions at the nodes.
    pub nodal: Vec<PointShape>,
    /// Integrals of the shape functions and of their squares \[L³\], of images as well.
    pub integrals: Vec<[f64; 2]>,
    /// The greatest force that a uniform stress of one leaves on a node, over the square of a cell's edge \[–\]; zero of whole cells, where it is not asked for.
    pub uneven: f64,
}

impl Discretisation {
    pub fn new(parts: &Parts, images: Images, squares: &MovingLeastSquares) -> Result<Self, GalerkinError> {
        let quadrature = quadrature(parts)?;
        let slice = parts.rule * parts.rule;
        let built = quadrature
            .par_iter()
            .map(|points| Cell::new(points, squares, &images, slice))
            .collect::<Result<Vec<_>, GalerkinError>>()?;
        let nodal = parts.nodes.par_iter().map(|x| squares.at(x)).collect::<Result<Vec<_>, _>>()?;
        let mut integrals = vec![[0.0; 2]; parts.nodes.len() + images.places.len()];
        let mut cells = Vec::with_capacity(built.len());
        for (cell, own) in built {
            for (node, own) in cell.nodes.iter().zip(own) {
                (0..2).for_each(|k| integrals[*node as usize][k] += own[k]);
            }
            cells.push(cell);
        }
        let places = quadrature.iter().flatten().map(|point| point.place).collect();
        let points = parts.rule.pow(3);
        let nodes = parts.nodes.clone();
        let mut space = Self { nodes, images, cells, places, points, slice, nodal, integrals, uneven: 0.0 };
        if let Some(cut) = &parts.cut {
            let whole = space.cells.iter().map(|cell| cell.volumes.iter().sum::<f64>()).fold(0.0, f64::max);
            let edge = libm::cbrt(whole);
            space.uneven = space.unbalanced(&quadrature, &cut.surface, squares)? / (edge * edge);
        }
        Ok(space)
    }

    /// The greatest force that a uniform stress of one leaves on a node, `|∫∇φ dV − ∮φ n dA|` \[L²\]: zero by Gauss's theorem, but for the quadrature.
    fn unbalanced(
        &self,
        quadrature: &[Vec<VolumePoint>],
        surface: &[FacePoint],
        squares: &MovingLeastSquares,
    ) -> Result<f64, GalerkinError> {
        let mut sums = vec![Vec3::zeros(); self.integrals.len()];
        for (cell, points) in self.cells.iter().zip(quadrature) {
            for (number, point) in points.iter().enumerate() {
                for (at, &node) in cell.nodes.iter().enumerate() {
                    let of = |direction| point.volume * cell.gradient(number, direction)[at];
                    sums[node as usize] += Vec3::new(of(0), of(1), of(2));
                }
            }
        }
        for point in surface {
            let (shape, area) = (squares.at(&point.place)?, point.area());
            shape.nodes.iter().zip(&shape.values).for_each(|(&node, phi)| sums[node as usize] -= area * *phi);
        }
        Ok(sums.iter().map(Vec3::norm).fold(0.0, f64::max))
    }

    /// Numbers that a cell writes: three rows as wide as the widest.
    pub fn force_stride(&self) -> usize {
        3 * self.cells.iter().fold(1, |most, cell| most.max(cell.width))
    }
}

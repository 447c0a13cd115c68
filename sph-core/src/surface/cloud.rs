//! The reference cloud: particles on a surface with frames, areas, edges and cells. Immutable once built.

use nalgebra::Rotation3;

use crate::Vec3;
use crate::error::SpaceError;
use crate::neighbours::CellList;
use crate::surface::boundary::boundary;
use crate::surface::cell::Cell;
use crate::surface::frame::Frame;
use crate::surface::numbering::Lattice;
use crate::surface::sides::Sides;

/// Distance, in units of the spacing, below which two particles count as one: far below any sensible disorder,
/// far above rounding.
const COINCIDENT: f64 = 1e-6;

/// Distance, in units of the spacing, to the nearest other particle from which on a particle without cells is isolated:
/// farther than any support in use (order 3 reaches to about three).
const LONELY: f64 = 4.0;

/// Least angle of a cell, in degrees: a sharper corner narrows the stable step to a tenth and strains are sampled along one
/// line only.
const SHARPEST: f64 = 5.0;

/// Particles on a surface. All lists have one entry per particle, except `cells`.
#[derive(Clone, Debug, PartialEq)]
pub struct Cloud {
    /// Positions `[L]`.
    pub positions: Vec<Vec3>,
    /// Frames; `n` is the surface normal.
    pub frames: Vec<Frame>,
    /// Tributary areas `[L²]`.
    pub areas: Vec<f64>,
    /// Outward in-surface normal × tributary edge length `[L]`; zero inside, the sum of both edges at a corner.
    pub edge_normals: Vec<Vec3>,
    /// Tributary boundary length `[L]`; zero inside.
    pub edge_lengths: Vec<f64>,
    /// Quadrangles and triangles between the particles.
    pub cells: Vec<Cell>,
    /// Particles of different sheets that stand on one place and belong together, at junctions; each list ascending, none
    /// shares a particle with another.
    pub joined: Vec<Vec<u32>>,
    /// The four edges, if the cloud covers a patch.
    pub sides: Option<Sides>,
    /// The lattice behind the numbering, if there is one.
    pub lattice: Option<Lattice>,
}

impl Cloud {
    /// Number of particles.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there are no particles.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// Mean spacing `[L]`: the square root of the mean tributary area.
    pub fn spacing(&self) -> f64 {
        (self.areas.iter().sum::<f64>() / self.len() as f64).sqrt()
    }

    /// Cloud from positions `[L]` and cells, with areas `A_a = Σ_cells w_p/m` (m corners) and edges found from the
    /// cells. Normals are area-weighted means over the cells at a particle unless given (any length).
    ///
    /// Cells may form several sheets apart from each other: see [`Cloud::pieces`].
    pub fn from_cells(
        positions: Vec<Vec3>,
        normals: Option<Vec<Vec3>>,
        cells: Vec<Cell>,
    ) -> Result<Cloud, SpaceError> {
        Self::from_sheets(positions, normals, cells, Vec::new())
    }

    /// The same of sheets that meet along lines: each sheet has particles of its own there, and `joined` lists those that stand on
    /// one place. Areas, normals and edges are those of each sheet alone.
    pub fn from_sheets(
        positions: Vec<Vec3>,
        normals: Option<Vec<Vec3>>,
        cells: Vec<Cell>,
        joined: Vec<Vec<u32>>,
    ) -> Result<Cloud, SpaceError> {
        check_corners(&cells, positions.len())?;
        check_finite(&positions, "position")?;
        let mut areas = vec![0.0; positions.len()];
        let mut mean_normals = vec![Vec3::zeros(); positions.len()];
        for (c, cell) in cells.iter().enumerate() {
            let geometry = cell.geometry(&positions);
            check_area(c, cell, &positions, geometry.area)?;
            for &b in cell.particles() {
                areas[b as usize] += geometry.area / f64::from(cell.count);
                mean_normals[b as usize] += geometry.area * geometry.normal;
            }
        }
        if let Some(particle) = areas.iter().position(|&area| area == 0.0) {
            return Err(SpaceError::Isolated { particle, found: 0 });
        }
        let normals = normals.unwrap_or(mean_normals);
        check_length("normals", normals.len(), positions.len())?;
        let frames: Vec<Frame> = normals.into_iter().map(Frame::from_normal).collect();
        let units: Vec<Vec3> = frames.iter().map(|frame| frame.n).collect();
        check_finite(&units, "normal")?;
        let edges = boundary(&positions, &units, &cells)?;
        let cloud = Cloud {
            positions,
            frames,
            areas,
            edge_normals: edges.normals,
            edge_lengths: edges.lengths,
            cells,
            joined,
            sides: None,
            lattice: None,
        };
        cloud.check()?;
        Ok(cloud)
    }

    /// Refuses clouds that no operator can be built on: lists of different length, numbers that are not finite,
    /// particles on top of each other, cells with sharp corners or against the normals of their particles, and particles in
    /// no cell (or, where there are no cells, far from all others).
    ///
    /// The two lips of a slit may coincide, that is particles on the boundary that share no cell, and so may particles that are
    /// joined: cell stencils keep the lips and the sheets apart. Kernel and nodal stencils cannot, and refuse such clouds themselves.
    pub fn check(&self) -> Result<(), SpaceError> {
        check_length("frames", self.frames.len(), self.len())?;
        check_length("areas", self.areas.len(), self.len())?;
        check_length("edge normals", self.edge_normals.len(), self.len())?;
        check_length("edge lengths", self.edge_lengths.len(), self.len())?;
        check_finite(&self.positions, "position")?;
        for axes in [|frame: &Frame| frame.t1, |frame: &Frame| frame.t2, |frame: &Frame| frame.n] {
            check_finite(&self.frames.iter().map(axes).collect::<Vec<_>>(), "frame")?;
        }
        if let Some(particle) = self.areas.iter().position(|&area| !(area.is_finite() && area > 0.0)) {
            let (value, bound) = (self.areas[particle], "a positive number");
            return Err(SpaceError::BadNumber { particle, what: "area", value, bound });
        }
        check_corners(&self.cells, self.len())?;
        let used = self.cells_at_particles();
        let place = self.places_joined()?;
        self.check_apart(|a, b| {
            let shared = used[a].iter().any(|c| used[b].contains(c));
            let one_place = place.get(a).is_some_and(|&own| own > 0 && own == place[b]);
            !shared && (one_place || self.edge_lengths[a] > 0.0 && self.edge_lengths[b] > 0.0)
        })?;
        self.check_cells()?;
        let lonely = if self.cells.is_empty() {
            let spacing = self.spacing();
            let list = CellList::new(&self.positions, spacing);
            self.positions.iter().position(|x| list.nearest(x, 2) > LONELY * spacing)
        } else {
            used.iter().position(Vec::is_empty)
        };
        match lonely {
            Some(particle) => Err(SpaceError::Isolated { particle, found: 0 }),
            None => Ok(()),
        }
    }

    /// Refuses cells with a corner that is too sharp, or that faces against the normal of one of their particles.
    fn check_cells(&self) -> Result<(), SpaceError> {
        for (c, cell) in self.cells.iter().enumerate() {
            let corners = cell.particles();
            let normal = cell.geometry(&self.positions).normal;
            let m = corners.len();
            for (i, particle) in corners.iter().map(|&b| b as usize).enumerate() {
                let arm = |k: usize| self.positions[corners[k % m] as usize] - self.positions[particle];
                let degrees = arm(i + 1).angle(&arm(i + m - 1)).to_degrees();
                if degrees < SHARPEST {
                    return Err(SpaceError::Sliver { cell: c, particle, degrees, bound: SHARPEST });
                }
                let degrees = self.frames[particle].n.angle(&normal).to_degrees();
                if degrees >= 90.0 {
                    return Err(SpaceError::NormalAgainstCell { particle, cell: c, degrees });
                }
            }
        }
        Ok(())
    }

    /// For each particle the number of its joined list, one up, and zero for others; empty where nothing is joined.
    fn places_joined(&self) -> Result<Vec<u32>, SpaceError> {
        if self.joined.is_empty() {
            return Ok(Vec::new());
        }
        let mut place = vec![0; self.len()];
        let bound = COINCIDENT * self.spacing();
        for (number, group) in (1..).zip(&self.joined) {
            let first = group.first().map_or(0, |&a| a as usize);
            for &a in group {
                let second = a as usize;
                match place.get_mut(second) {
                    Some(own) if *own == 0 => *own = number,
                    _ => return Err(SpaceError::BadJoint { particle: second, particles: self.len() }),
                }
                let distance = (self.positions[second] - self.positions[first]).norm();
                if distance > bound {
                    return Err(SpaceError::JoinedApart { first, second, distance, bound });
                }
            }
        }
        Ok(place)
    }

    /// Refuses coincident particles, except pairs for which `allowed` is true.
    pub(crate) fn check_apart(&self, allowed: impl Fn(usize, usize) -> bool) -> Result<(), SpaceError> {
        let bound = COINCIDENT * self.spacing();
        let list = CellList::new(&self.positions, self.spacing());
        let mut near = Vec::new();
        for first in 0..self.len() {
            list.within(&self.positions[first], bound, &mut near);
            for second in near.iter().map(|&b| b as usize).filter(|&b| b > first) {
                if !allowed(first, second) {
                    let distance = (self.positions[second] - self.positions[first]).norm();
                    return Err(SpaceError::Coincident { first, second, distance, bound });
                }
            }
        }
        Ok(())
    }

    /// The particles of each part that hangs together through cells and joined particles, ascending; the parts in the order of
    /// their first particles. One part if there are no cells.
    ///
    /// Parts apart move apart: for a static answer each needs supports of its own.
    pub fn pieces(&self) -> Vec<Vec<u32>> {
        if self.cells.is_empty() {
            return vec![(0..self.len() as u32).collect()];
        }
        let used = self.cells_at_particles();
        let mut joined = vec![&[] as &[u32]; self.len()];
        for group in &self.joined {
            group.iter().for_each(|&a| joined[a as usize] = group);
        }
        let mut seen = vec![false; self.len()];
        let mut pieces = Vec::new();
        for start in 0..self.len() {
            if seen[start] {
                continue;
            }
            seen[start] = true;
            let (mut piece, mut stack) = (Vec::new(), vec![start as u32]);
            while let Some(a) = stack.pop() {
                piece.push(a);
                let across = used[a as usize].iter().flat_map(|&c| self.cells[c as usize].particles());
                for &b in across.chain(joined[a as usize]) {
                    if !seen[b as usize] {
                        seen[b as usize] = true;
                        stack.push(b);
                    }
                }
            }
            piece.sort_unstable();
            pieces.push(piece);
        }
        pieces
    }

    /// The cells at each particle, ascending.
    pub(crate) fn cells_at_particles(&self) -> Vec<Vec<u32>> {
        let mut used = vec![Vec::new(); self.len()];
        for (c, cell) in self.cells.iter().enumerate() {
            for &b in cell.particles() {
                used[b as usize].push(c as u32);
            }
        }
        used
    }

    /// The cloud rotated by `rotation` about the origin and then moved by `shift` `[L]`.
    pub fn transformed(&self, rotation: &Rotation3<f64>, shift: &Vec3) -> Cloud {
        Cloud {
            positions: self.positions.iter().map(|x| rotation * x + shift).collect(),
            frames: self.frames.iter().map(|frame| frame.rotated(rotation)).collect(),
            edge_normals: self.edge_normals.iter().map(|r| rotation * r).collect(),
            ..self.clone()
        }
    }
}

/// Refuses lists whose length is not that of the cloud.
pub(crate) fn check_length(what: &'static str, found: usize, expected: usize) -> Result<(), SpaceError> {
    if found == expected { Ok(()) } else { Err(SpaceError::Length { what, found, expected }) }
}

/// Refuses a cell without area, measured against its longest edge.
pub(crate) fn check_area(c: usize, cell: &Cell, positions: &[Vec3], area: f64) -> Result<(), SpaceError> {
    let longest = cell
        .edges()
        .map(|(a, b)| (positions[b as usize] - positions[a as usize]).norm_squared())
        .fold(0.0, f64::max);
    let bound = COINCIDENT * longest;
    if area > bound { Ok(()) } else { Err(SpaceError::DegenerateCell { cell: c, area, bound }) }
}

fn check_finite(vectors: &[Vec3], what: &'static str) -> Result<(), SpaceError> {
    for (particle, vector) in vectors.iter().enumerate() {
        if let Some(&value) = vector.iter().find(|x| !x.is_finite()) {
            return Err(SpaceError::BadNumber { particle, what, value, bound: "a finite number" });
        }
    }
    Ok(())
}

fn check_corners(cells: &[Cell], particles: usize) -> Result<(), SpaceError> {
    for (cell, corners) in cells.iter().enumerate() {
        let corners = corners.particles();
        for (i, &corner) in corners.iter().enumerate() {
            if corner as usize >= particles || corners[..i].contains(&corner) {
                return Err(SpaceError::BadCorner { cell, corner: corner as usize, particles });
            }
        }
    }
    Ok(())
}

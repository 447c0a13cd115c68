//! Still water as an ideal fluid without compression: what pressure faces that swing in it meet.
//!
//! ```text
//! ∇²p = 0      p = 0 on the free surface      ∂p/∂n = 0 on walls      ∂p/∂n = −ρ a_n on wet faces, n into the water
//! ```
//!
//! It is solved where the particles of the fluid stand at rest, each the middle of a cell of its lattice. Between neighbours flows
//! `(p_i − p_j) s^{d−2}/ρ`; the free surface is half a spacing off, `2 p_i s^{d−2}/ρ`; nothing flows to a wall, nor through a shell, which
//! parts neighbours on both sides of it (links.rs). A site of a wet face has a pressure p_f of its own, next to that of the water at a
//! point half a spacing before the face, a weighted mean of the cells about it (sites.rs):
//!
//! ```text
//! (A/ρδ) (p_f − Σ w_c p_c) = A a_n      δ the distance of those cells from the face
//! ```
//!
//! so that all that a face moves enters the water, and p_f is right to second order for faces along the lattice, wherever they lie between its rows; to
//! first order for those across it. L is the sum of squares of differences over ρ: symmetric, and positive where water has a free surface.
//! Uniform accelerations of a floor meet exactly the mass above it.

mod links;
mod sites;

use std::collections::BTreeMap;

use sph_core::{CellList, Vec3};

use self::links::{Link, links};
use self::sites::{Site, sites};

/// Distance below which a place is that of a particle already, in spacings.
const FILLED: f64 = 0.49;
/// Part of gravity across a face of the free surface from which it looks up.
const UP: f64 = 0.5;

/// Still water with what bounds it.
#[derive(Clone, Copy, Debug)]
pub struct StillParts<'a> {
    /// Two in the plane z = 0, or three.
    pub dimensions: usize,
    /// Distance between particles \[L\].
    pub spacing: f64,
    /// Density \[F T²/L⁴\].
    pub density: f64,
    /// How far a plane fluid reaches across its plane \[L\]; one in space.
    pub width: f64,
    /// Particles, on lattices along the axes \[L\].
    pub positions: &'a [Vec3],
    /// Particles of walls \[L\].
    pub walls: &'a [Vec3],
    /// Middle surfaces of shells.
    pub screens: &'a [Screen],
    /// Places of their wet faces.
    pub sites: &'a [WetSite],
}

/// A triangle of a middle surface; in a plane a line from the first corner to the second.
#[derive(Clone, Copy, Debug)]
pub struct Screen {
    /// Corners \[L\].
    pub corners: [Vec3; 3],
    /// Half of the thickness \[L\].
    pub half: f64,
}

/// A place of a wet face.
#[derive(Clone, Copy, Debug)]
pub struct WetSite {
    /// On the middle surface \[L\].
    pub place: Vec3,
    /// Unit normal towards the water.
    pub normal: Vec3,
    /// Distance of the face from the middle surface \[L\].
    pub half: f64,
    /// Area \[L²\].
    pub area: f64,
}

/// Why still water could not be made.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum StillError {
    /// No site has water before it.
    #[error(
        "no wet face has water half a spacing before it: modes would be those of the dry shell; let a block begin at a face, or take the fluid out"
    )]
    Dry,
    /// Water without a free surface at a wet face.
    #[error(
        "the water at [{:.4}, {:.4}, {:.4}] has no free surface: shut in and without compression it would hold the shell; leave a side of its walls open",
        at[0], at[1], at[2]
    )]
    ShutIn {
        /// Where \[L\].
        at: [f64; 3],
    },
    /// Blocks that meet between their rows.
    #[error(
        "two blocks meet at [{:.4}, {:.4}, {:.4}] between their rows of particles; let their origins differ by whole spacings",
        at[0], at[1], at[2]
    )]
    Shifted {
        /// Where \[L\].
        at: [f64; 3],
    },
    /// Water and a wall at one place.
    #[error(
        "a particle of the fluid stands at [{:.4}, {:.4}, {:.4}], inside of a wall; let the water begin at its face",
        at[0], at[1], at[2]
    )]
    InWall {
        /// Where \[L\].
        at: [f64; 3],
    },
    /// Water twice at one place.
    #[error(
        "two particles of the fluid stand at [{:.4}, {:.4}, {:.4}]: blocks overlap there; let them meet at their sides",
        at[0], at[1], at[2]
    )]
    Twice {
        /// Where \[L\].
        at: [f64; 3],
    },
    /// A particle inside of a shell.
    #[error(
        "a particle of the fluid stands at [{:.4}, {:.4}, {:.4}], inside of the shell; let the water begin at its face",
        at[0], at[1], at[2]
    )]
    Inside {
        /// Where \[L\].
        at: [f64; 3],
    },
}

/// The Laplacian of still water over its density, for pressures of cells and of wet sites.
#[derive(Clone, Debug)]
pub struct StillWater {
    /// Pressures: of cells, then of wet sites.
    pub nodes: usize,
    /// Cells among them.
    pub cells: usize,
    /// Entries of the Laplacian: lower triangle with the whole diagonal, each once.
    pub pattern: Vec<(usize, usize)>,
    /// Their values \[L⁵/(F T²)\].
    pub values: Vec<f64>,
    /// The node of each site; none where it is dry.
    pub sites: Vec<Option<usize>>,
    /// Faces of the free surface.
    surface: Vec<Open>,
    density: f64,
    spacing: f64,
}

/// A face of a cell on the free surface.
#[derive(Clone, Copy, Debug)]
struct Open {
    cell: usize,
    outward: Vec3,
    area: f64,
}

impl StillWater {
    /// Finds what is joined to what.
    ///
    /// # Errors
    /// [`StillError`].
    pub fn new(parts: &StillParts<'_>) -> Result<Self, StillError> {
        let StillParts { spacing, density, width, positions, .. } = *parts;
        let list = CellList::new(positions, spacing);
        let walls = CellList::new(parts.walls, spacing);
        refuse_filled_places(parts, &list, &walls)?;
        let links = links(parts, &list, &walls)?;
        let found = sites(parts, &list, &links)?;
        if found.iter().all(Option::is_none) {
            return Err(StillError::Dry);
        }
        let kept = kept(positions, &links, &found)?;
        let cells = kept.iter().flatten().count();
        let across = width * if parts.dimensions == 3 { spacing } else { 1.0 };
        let mut entries: BTreeMap<(usize, usize), f64> = BTreeMap::new();
        let mut add = |a: usize, b: usize, value: f64| {
            *entries.entry((a.max(b), a.min(b))).or_default() += value;
        };
        let mut surface = Vec::new();
        for (own, number) in links.iter().zip(&kept) {
            let Some(i) = *number else { continue };
            add(i, i, 0.0);
            for (side, link) in own.iter().enumerate().take(2 * parts.dimensions) {
                match *link {
                    Link::To(other) => {
                        let Some(j) = kept[other as usize] else { continue };
                        add(i, i, across / density);
                        if j < i {
                            add(i, j, -across / density);
                        }
                    }
                    Link::Open => {
                        add(i, i, 2.0 * across / density);
                        surface.push(Open { cell: i, outward: links::way(side), area: across * spacing });
                    }
                    Link::Closed => {}
                }
            }
        }
        let mut nodes = cells;
        let mut numbered = Vec::with_capacity(found.len());
        for (site, wet) in found.iter().zip(parts.sites) {
            let Some(Site { cells: beside, depth }) = site else {
                numbered.push(None);
                continue;
            };
            let conductance = wet.area / (depth * density);
            add(nodes, nodes, conductance);
            let beside: Vec<(usize, f64)> =
                beside.iter().filter_map(|&(cell, w)| Some((kept[cell as usize]?, w))).collect();
            for (k, &(a, of_a)) in beside.iter().enumerate() {
                add(nodes, a, -conductance * of_a);
                beside[..=k].iter().for_each(|&(b, of_b)| add(a, b, conductance * of_a * of_b));
            }
            numbered.push(Some(nodes));
            nodes += 1;
        }
        let (pattern, values) = entries.into_iter().unzip();
        Ok(Self { nodes, cells, pattern, values, sites: numbered, surface, density, spacing })
    }

    /// Faces of the free surface that do not look up, where no wall holds the water: with gravity it would not stay.
    pub fn hanging(&self, gravity: &Vec3) -> usize {
        let looks_up = |open: &Open| -gravity.dot(&open.outward) > UP * gravity.norm();
        if *gravity == Vec3::zeros() { 0 } else { self.surface.iter().filter(|open| !looks_up(open)).count() }
    }

    /// Twice the potential energy of the waves that a unit of a motion makes of the free surface, whose pressures for an acceleration of that
    /// unit are these: `ρ ∫ g·n ζ² dA` with `ζ = 2p/(ρs)` \[F L/L²\].
    pub fn surface_stiffness(&self, pressures: &[f64], gravity: &Vec3) -> f64 {
        let of = |open: &Open| {
            let lift = 2.0 * pressures[open.cell] / (self.density * self.spacing);
            self.density * (-gravity.dot(&open.outward)).max(0.0) * open.area * lift * lift
        };
        self.surface.iter().map(of).sum()
    }
}

/// Refuses water in a wall, and water twice at one place.
fn refuse_filled_places(parts: &StillParts<'_>, list: &CellList, walls: &CellList) -> Result<(), StillError> {
    let mut near = Vec::new();
    for place in parts.positions {
        walls.within(place, FILLED * parts.spacing, &mut near);
        if !near.is_empty() {
            return Err(StillError::InWall { at: (*place).into() });
        }
        list.within(place, FILLED * parts.spacing, &mut near);
        if near.len() > 1 {
            return Err(StillError::Twice { at: (*place).into() });
        }
    }
    Ok(())
}

/// The number of each cell among those that a wet face moves; none for water apart from it.
fn kept(
    positions: &[Vec3],
    links: &[[Link; 6]],
    found: &[Option<Site>],
) -> Result<Vec<Option<usize>>, StillError> {
    let mut reached = vec![false; links.len()];
    for first in found.iter().flatten().filter_map(|site| site.cells.first()).map(|&(cell, _)| cell) {
        if std::mem::replace(&mut reached[first as usize], true) {
            continue;
        }
        let (mut open, mut next) = (false, vec![first]);
        while let Some(cell) = next.pop() {
            for link in &links[cell as usize] {
                match *link {
                    Link::To(other) => {
                        if !std::mem::replace(&mut reached[other as usize], true) {
                            next.push(other);
                        }
                    }
                    Link::Open => open = true,
                    Link::Closed => {}
                }
            }
        }
        if !open {
            return Err(StillError::ShutIn { at: positions[first as usize].into() });
        }
    }
    let mut count = 0;
    let number = |reached: bool| {
        count += usize::from(reached);
        reached.then(|| count - 1)
    };
    Ok(reached.into_iter().map(number).collect())
}

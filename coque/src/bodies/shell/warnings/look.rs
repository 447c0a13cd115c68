//! What the rules look at: the shell at rest, measured once.

use std::borrow::Cow;

use nalgebra::Rotation3;
use sph_core::{Cloud, Vec3};
use sph_shell::{LoadShare, Shell};

use super::sheet::{Sheet, neighbours};
use crate::scene::body_in_scene::ShellInScene;

/// Turn between neighbouring points \[rad\] above which normals tell of a fold and not of a curvature.
const FOLDED: f64 = 0.5;

/// A shell at rest.
pub(crate) struct Look<'a> {
    pub(crate) shell: &'a Shell,
    /// The scene it was built from, if there is one.
    pub(crate) scene: Option<&'a ShellInScene<'a>>,
    /// How the scene is turned.
    pub(crate) turn: Rotation3<f64>,
    /// Cells and their turns; no cells where strains are sampled at points of a file.
    pub(crate) sheet: Sheet<'a>,
    /// The cell across each edge, as [`neighbours`] has it.
    pub(crate) across: Vec<[u32; 4]>,
    /// Where each load acts.
    pub(crate) loads: Vec<LoadShare>,
    /// Thickness t \[L\].
    pub(crate) thickness: f64,
    /// Mean spacing Δ \[L\].
    pub(crate) spacing: f64,
    /// Every sampling point, folds left out.
    pub(crate) curved: Vec<Curved>,
    /// Mean of |k| over the area \[1/L\].
    pub(crate) curvature: f64,
    /// Cells from end to end and extent \[L\] along each direction of the lattice, the shorter first, if there is one.
    pub(crate) lattice: Option<[(usize, f64); 2]>,
}

impl<'a> Look<'a> {
    pub(crate) fn at(shell: &'a Shell) -> Self {
        let cloud = &shell.reference().cloud;
        let curved = curvatures(shell);
        let area: f64 = curved.iter().map(|point| point.area).sum();
        let bent: f64 = curved.iter().map(|point| point.curvature * point.area).sum();
        let curvature = bent / area.max(f64::MIN_POSITIVE);
        let across = neighbours(&cloud.cells, cloud.len());
        let extents = cloud.lattice.map(|lattice| {
            let mut both = [0, 1].map(|along| {
                let middle = lattice.counts[1 - along] / 2;
                let line = if along == 0 { lattice.row(middle) } else { lattice.column(middle) };
                let place = |a: &u32| cloud.positions[*a as usize];
                let length = line.windows(2).map(|pair| (place(&pair[1]) - place(&pair[0])).norm()).sum();
                (lattice.counts[along] - 1, length)
            });
            both.sort_by(|a: &(usize, f64), b| a.1.total_cmp(&b.1));
            both
        });
        Self {
            shell,
            scene: None,
            turn: Rotation3::identity(),
            sheet: Sheet::at(&cloud.positions, &cloud.cells, &across),
            across,
            loads: shell.load_shares(),
            thickness: shell.thickness(),
            spacing: cloud.spacing(),
            curved,
            // Round-off of a flat body.
            curvature: if curvature * cloud.spacing() < 1e-9 { 0.0 } else { curvature },
            lattice: extents,
        }
    }

    /// The cloud with its places from zero, for rules that name one.
    pub(crate) fn cloud(&self) -> Cow<'a, Cloud> {
        let reference = self.shell.reference();
        if reference.origin == Vec3::zeros() {
            return Cow::Borrowed(&reference.cloud);
        }
        Cow::Owned(Cloud { positions: self.shell.rest_positions().to_vec(), ..reference.cloud.clone() })
    }

    /// Mean radius of curvature over thickness; infinite for flat bodies.
    pub(crate) fn slenderness(&self) -> f64 {
        1.0 / (self.curvature * self.thickness)
    }

    /// The unit direction from end to end of the middle line along the shorter direction of the lattice, if there is one.
    pub(crate) fn across_the_lattice(&self) -> Option<Vec3> {
        let cloud = &self.shell.reference().cloud;
        let lattice = cloud.lattice?;
        let [row, column] =
            [lattice.row(lattice.counts[1] / 2), lattice.column(lattice.counts[0] / 2)].map(|line| {
                let place = |a: &u32| cloud.positions[*a as usize];
                let length: f64 =
                    line.windows(2).map(|pair| (place(&pair[1]) - place(&pair[0])).norm()).sum();
                let ends = line.first().zip(line.last()).map(|(first, last)| place(last) - place(first));
                (length, ends)
            });
        let (_, ends) = if row.0 <= column.0 { row } else { column };
        ends?.try_normalize(0.0)
    }

    /// Width and length \[L\]: those of the lattice, else the longest side of the box round all particles, and the area over it.
    pub(crate) fn extents(&self) -> [f64; 2] {
        if let Some([narrow, long]) = self.lattice {
            return [narrow.1, long.1];
        }
        let cloud = &self.shell.reference().cloud;
        let corner =
            |pick: fn(f64, f64) -> f64| cloud.positions.iter().copied().reduce(|a, b| a.zip_map(&b, pick));
        let length = corner(f64::max).zip(corner(f64::min)).map_or(0.0, |(a, b)| (a - b).amax());
        let width = cloud.areas.iter().sum::<f64>() / length.max(f64::MIN_POSITIVE);
        [width.min(length), width.max(length)]
    }
}

/// Curvature at a sampling point.
pub(crate) struct Curved {
    /// The greater principal curvature |k| \[1/L\].
    pub(crate) curvature: f64,
    /// Extent of the cell along it; where points are no cells the root of the area \[L\].
    pub(crate) spacing: f64,
    /// Area \[L²\].
    pub(crate) area: f64,
    /// A particle of its stencil.
    pub(crate) particles: [u32; 4],
}

impl Curved {
    /// Cells to a bending length √(t/|k|).
    pub(crate) fn cells(&self, thickness: f64) -> f64 {
        (thickness / self.curvature).sqrt() / self.spacing
    }
}

/// `K_αβ = −(t_α·n,β)`, symmetric part, from the normals of the particles: its greater eigenvalue, and the area, of each point.
fn curvatures(shell: &Shell) -> Vec<Curved> {
    let (cloud, operator) = (&shell.reference().cloud, &shell.reference().operator);
    let mut found = Vec::with_capacity(operator.points.len());
    for (p, point) in operator.points.iter().enumerate() {
        let stencil = operator.stencil(p);
        let mut change = [Vec3::zeros(); 2];
        for (k, &b) in stencil.particles.iter().enumerate() {
            let n = cloud.frames[b as usize].n;
            change[0] += n * stencil.g1[k];
            change[1] += n * stencil.g2[k];
        }
        let [a, c] = [change[0].dot(&point.frame.t1), change[1].dot(&point.frame.t2)];
        let b = 0.5 * (change[0].dot(&point.frame.t2) + change[1].dot(&point.frame.t1));
        let most = 0.5 * (a + c).abs() + (0.25 * (a - c).powi(2) + b * b).sqrt();
        let size = point.weight.sqrt();
        if most * size >= FOLDED {
            continue;
        }
        // The axis of the greater curvature, a + c and a − c of one sign being taken along it.
        let half =
            0.5 * libm::atan2(2.0 * b, a - c) + if a + c < 0.0 { std::f64::consts::FRAC_PI_2 } else { 0.0 };
        let (sin, cos) = libm::sincos(half);
        let axis = point.frame.t1 * cos + point.frame.t2 * sin;
        // Of a parallelogram, whatever the axis: the root of the sum over its two sides.
        let along = |&b: &u32| axis.dot(&(cloud.positions[b as usize] - point.position)).powi(2);
        let cell = stencil.particles.len() <= 4;
        let spacing = if cell { stencil.particles.iter().map(along).sum::<f64>().sqrt() } else { size };
        let mut particles = [u32::MAX; 4];
        particles.iter_mut().zip(stencil.particles).for_each(|(place, &b)| *place = b);
        found.push(Curved { curvature: most, spacing, area: point.weight, particles });
    }
    found
}

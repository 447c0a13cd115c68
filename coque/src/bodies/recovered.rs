//! Stresses of a shell at its particles, from those of the cells round them: linear courses through patches of cells \[zienkiewicz1992\].
//!
//! Resultants are sampled at the middles of cells. A particle inside has the cells that meet at it as its patch; a linear polynomial in the plane
//! that touches the surface there, fitted to the patch by least squares over areas, is read at the particle. A particle on an edge takes the mean of
//! what the patches of its neighbours inside say of it, at best of those to which an edge of a cell leads. Where there are none, in strips one cell wide, the cells round its own ones are its patch. What a
//! patch does not determine, a slope across one row of cells, stays zero. Patches end where the section steps.
//!
//! Components of a cell are carried to the frame of the particle by the least rotation that takes its normal there.

use std::collections::BTreeSet;

use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use sph_core::{Cell, Frame, Vec3};
use sph_shell::{PointSection, Shell};

/// Part of the greatest moment of a patch below which it does not determine a slope.
const FLAT: f64 = 1e-6;

/// Part of areas that are alike that rounding makes of them.
const ROUNDING: f64 = 1e-6;
/// Part of a thickness, or of a stiffness, by which a section may differ from cell to cell and be one that goes on.
const STEP: f64 = 0.1;

/// What a cell gives to a particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Share {
    pub cell: u32,
    /// How many times it counts.
    pub weight: f64,
    /// Cosine and sine of the angle from the first axis of the cell, carried to the particle, to that of the particle.
    pub turn: [f64; 2],
}

impl Share {
    /// Components `11, 22, 12` of a cell along the axes of the particle, so many times as it counts.
    pub fn tensor(&self, [a, b, c]: [f64; 3]) -> [f64; 3] {
        let [cos, sin] = self.turn;
        let (cc, ss, cs) = (cos * cos, sin * sin, cos * sin);
        let turned =
            [cc * a + ss * b + 2.0 * cs * c, ss * a + cc * b - 2.0 * cs * c, cs * (b - a) + (cc - ss) * c];
        turned.map(|value| self.weight * value)
    }

    /// The same of components `1, 2`.
    pub fn vector(&self, [a, b]: [f64; 2]) -> [f64; 2] {
        let [cos, sin] = self.turn;
        [self.weight * (cos * a + sin * b), self.weight * (cos * b - sin * a)]
    }
}

/// For each of some particles of a shell with cells what these give to it.
pub(in crate::bodies) fn recovery(shell: &Shell, particles: impl Iterator<Item = u32>) -> Vec<Vec<Share>> {
    let patches = Patches::new(shell);
    particles.map(|a| patches.shares(a)).collect()
}

struct Patches<'a> {
    shell: &'a Shell,
    cells: &'a [Cell],
    /// Cells at each particle, of the section that most of its area has.
    around: Vec<Vec<u32>>,
    /// Whether a particle lies inside: its cells close a ring.
    inside: Vec<bool>,
}

impl<'a> Patches<'a> {
    fn new(shell: &'a Shell) -> Self {
        let cells = &shell.reference().cloud.cells[..];
        let points = &shell.reference().operator.points;
        let mut all = vec![Vec::new(); shell.len()];
        for (number, cell) in (0..).zip(cells) {
            cell.particles().iter().for_each(|&a| all[a as usize].push(number));
        }
        // Of sections that step those of the greatest area, of two alike the thinner: its stress is the greater.
        let of_one_section = |own: &Vec<u32>| {
            let alike = |c: u32| own.iter().copied().filter(move |&d| alike(shell, c, d));
            let area = |c: u32| alike(c).map(|d| points[d as usize].weight).sum::<f64>();
            let greatest = own.iter().map(|&c| area(c)).fold(0.0, f64::max);
            let thickness = |c: u32| shell.section_at(c as usize).thickness;
            let widest = own.iter().copied().filter(|&c| area(c) > (1.0 - ROUNDING) * greatest);
            let first = widest.min_by(|&c, &d| thickness(c).total_cmp(&thickness(d)));
            first.map_or_else(Vec::new, |first| alike(first).collect())
        };
        let around: Vec<Vec<u32>> = all.iter().map(of_one_section).collect();
        let closes = |(a, own): (u32, &Vec<u32>)| {
            let others: BTreeSet<u32> = own.iter().flat_map(|&c| beside(&cells[c as usize], a)).collect();
            own.len() > 2 && others.len() == own.len()
        };
        let inside = (0..).zip(&around).map(closes).collect();
        Self { shell, cells, around, inside }
    }

    fn shares(&self, a: u32) -> Vec<Share> {
        let own = &self.around[a as usize];
        if self.inside[a as usize] {
            return self.fitted(a, own, 1.0);
        }
        let hosts = |near: fn(&Cell, u32) -> Vec<u32>| -> BTreeSet<u32> {
            let near = own.iter().flat_map(|&c| near(&self.cells[c as usize], a));
            near.filter(|&b| self.inside[b as usize] && self.alike(a, b)).collect()
        };
        let mut inner = hosts(beside);
        if inner.is_empty() {
            inner = hosts(|cell, _| cell.particles().to_vec());
        }
        if inner.is_empty() {
            let corners = own.iter().flat_map(|&c| self.cells[c as usize].particles());
            let round: BTreeSet<u32> =
                corners.flat_map(|&b| self.around[b as usize].iter().copied()).collect();
            let of_own = |c: &u32| own.first().is_some_and(|&first| alike(self.shell, first, *c));
            return self.fitted(a, &round.into_iter().filter(of_own).collect::<Vec<u32>>(), 1.0);
        }
        let each = 1.0 / inner.len() as f64;
        inner.iter().flat_map(|&b| self.fitted(a, &self.around[b as usize], each)).collect()
    }

    /// Whether the patches of two particles have one section.
    fn alike(&self, a: u32, b: u32) -> bool {
        let [first, other] = [a, b].map(|a| self.around[a as usize].first());
        first.zip(other).is_some_and(|(&c, &d)| alike(self.shell, c, d))
    }

    /// Weights of the value at a particle of the linear course that fits best to some cells; the first column of the inverse of their moments.
    fn fitted(&self, a: u32, patch: &[u32], times: f64) -> Vec<Share> {
        let cloud = &self.shell.reference().cloud;
        let (at, frame) = (cloud.positions[a as usize], &cloud.frames[a as usize]);
        let points = &self.shell.reference().operator.points;
        let turned = patch.iter().filter_map(|&c| {
            let point = &points[c as usize];
            let apart = point.position - at;
            let place = Vec3::new(1.0, apart.dot(&frame.t1), apart.dot(&frame.t2));
            Some((c, place, point.weight, turn(&point.frame, frame)?))
        });
        let turned: Vec<_> = turned.collect();
        let area: f64 = turned.iter().map(|(_, _, weight, _)| weight).sum();
        let size = (area / turned.len().max(1) as f64).sqrt();
        let scaled = |place: &Vec3| Vector3::new(1.0, place.y / size, place.z / size);
        let moments: Matrix3<f64> = turned
            .iter()
            .map(|(_, place, weight, _)| scaled(place) * scaled(place).transpose() * (weight / area))
            .sum();
        let first = lowest_solution(&moments);
        let share = |&(cell, place, weight, turn): &(u32, Vec3, f64, [f64; 2])| Share {
            cell,
            weight: times * weight / area * first.dot(&scaled(&place)),
            turn,
        };
        turned.iter().map(share).collect()
    }
}

/// Whether the section goes on from one cell to another: the same one, or as thick, as high and as stiff but for a tenth, as in tapers.
fn alike(shell: &Shell, one: u32, other: u32) -> bool {
    let [one, other] = [one, other].map(|c| c as usize);
    if shell.section_number(one) == shell.section_number(other) {
        return true;
    }
    let near = |[a, b]: [f64; 2], size: f64| (a - b).abs() <= STEP * size;
    let [a, b] = [one, other].map(|c| shell.section_at(c));
    let stiff = [one, other].map(|c| shell.stretch_stiffness(c));
    let thick = a.thickness.max(b.thickness);
    near([a.thickness, b.thickness], thick)
        && near([a.height, b.height], thick)
        && near(stiff, stiff[0].max(stiff[1]))
}

/// Thickness, and height of its middle \[L, L\], where cells give these shares.
pub(in crate::bodies) fn section(shell: &Shell, shares: &[Share]) -> [f64; 2] {
    let of = |read: fn(&PointSection) -> f64| -> f64 {
        shares.iter().map(|share| share.weight * read(&shell.section_at(share.cell as usize))).sum()
    };
    if shares.is_empty() { [shell.thickness(), 0.0] } else { [of(|own| own.thickness), of(|own| own.height)] }
}

/// Corners of a cell to which an edge leads from one of them.
fn beside(cell: &Cell, a: u32) -> Vec<u32> {
    let corners = cell.particles();
    let count = corners.len();
    let Some(at) = corners.iter().position(|&b| b == a) else { return Vec::new() };
    vec![corners[(at + 1) % count], corners[(at + count - 1) % count]]
}

/// The solution of `M x = (1, 0, 0)`, the shortest where directions are not determined: courses are constant along these.
fn lowest_solution(moments: &Matrix3<f64>) -> Vector3<f64> {
    // About the middle of the patch the mean and the slopes part.
    let middle = Vector3::new(moments[(1, 0)], moments[(2, 0)], 0.0);
    let central = nalgebra::Matrix2::new(
        moments[(1, 1)] - middle.x * middle.x,
        moments[(1, 2)] - middle.x * middle.y,
        moments[(2, 1)] - middle.y * middle.x,
        moments[(2, 2)] - middle.y * middle.y,
    );
    let found = SymmetricEigen::new(central);
    let greatest = found.eigenvalues.max();
    let back = -nalgebra::Vector2::new(middle.x, middle.y);
    let slopes: nalgebra::Vector2<f64> = (0..2)
        .filter(|&k| found.eigenvalues[k] > FLAT * greatest)
        .map(|k| {
            let axis = found.eigenvectors.column(k).into_owned();
            axis * (axis.dot(&back) / found.eigenvalues[k])
        })
        .sum();
    Vector3::new(1.0 + slopes.dot(&back), slopes.x, slopes.y)
}

/// Cosine and sine of the angle between the first axes of a cell and of a particle, the cell's carried by the least rotation of its normal; none
/// where that goes by a right angle and more.
fn turn(cell: &Frame, particle: &Frame) -> Option<[f64; 2]> {
    let (from, to) = (cell.n, particle.n);
    let level = from.dot(&to);
    if level <= 0.0 {
        return None;
    }
    let spin = from.cross(&to);
    let once = spin.cross(&cell.t1);
    let carried = cell.t1 + once + spin.cross(&once) / (1.0 + level);
    let [x, y] = [carried.dot(&particle.t1), carried.dot(&particle.t2)];
    let length = libm::hypot(x, y);
    // The angle from the cell's axis to the particle's is the other way round.
    Some([x / length, -y / length])
}

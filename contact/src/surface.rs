//! A surface as contact sees it: vertices with areas and half thicknesses.

use sph_core::{Cell, Vec3};

/// A place of a surface that may touch: a particle, or the middle of a quadrilateral.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    nodes: [u32; 4],
    count: u8,
    /// Area A that it stands for \[L²\].
    pub area: f64,
    /// Half of the thickness there \[L\].
    pub half: f64,
}

impl Vertex {
    /// The particles whose mean it is: one, or four.
    #[inline]
    pub fn nodes(&self) -> &[u32] {
        &self.nodes[..usize::from(self.count)]
    }

    /// The same as four numbers, a particle four times.
    #[inline]
    pub(crate) fn corners(&self) -> [u32; 4] {
        self.nodes
    }

    /// Where it is.
    #[inline]
    pub fn place(&self, at: impl Fn(u32) -> Vec3) -> Vec3 {
        match self.nodes {
            [a, ..] if self.count == 1 => at(a),
            [a, b, c, d] => (at(a) + at(b) + at(c) + at(d)) / 4.0,
        }
    }

    /// What a force on it is on each of its particles, and how far it goes with one of them \[–\].
    #[inline]
    pub fn share(&self) -> f64 {
        if self.count == 1 { 1.0 } else { 0.25 }
    }
}

/// The vertices of a surface.
///
/// Every quadrilateral is four triangles about its middle, a triangle stays what it is; each hands a third of its area at rest to its
/// corners. So a sheet has two vertices a quadrilateral, and a mirror changes nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    vertices: Vec<Vertex>,
    /// How many of these are particles.
    particles: usize,
}

impl Surface {
    /// The surface of some cells over particles at rest \[L\], with the half thickness \[L\] at each particle.
    pub fn new(cells: &[Cell], rest: &[Vec3], half: impl Fn(u32) -> f64) -> Self {
        let (mut areas, mut middles) = (vec![0.0; rest.len()], Vec::new());
        for cell in cells {
            let at = |corner: usize| rest[cell.corners[corner] as usize];
            let third = |a: Vec3, b: Vec3, c: Vec3| (b - a).cross(&(c - a)).norm() / 6.0;
            if cell.count < 4 {
                let part = third(at(0), at(1), at(2));
                cell.corners[..3].iter().for_each(|&a| areas[a as usize] += part);
                continue;
            }
            let middle = (at(0) + at(1) + at(2) + at(3)) / 4.0;
            let mut own = 0.0;
            for corner in 0..4 {
                let next = (corner + 1) % 4;
                let part = third(middle, at(corner), at(next));
                own += part;
                for a in [corner, next] {
                    areas[cell.corners[a] as usize] += part;
                }
            }
            let half = cell.corners.iter().map(|&a| half(a)).sum::<f64>() / 4.0;
            middles.push(Vertex { nodes: cell.corners, count: 4, area: own, half });
        }
        let touching = areas.iter().enumerate().filter(|(_, area)| **area > 0.0);
        let particle =
            |(a, &area): (usize, &f64)| Vertex { nodes: [a as u32; 4], count: 1, area, half: half(a as u32) };
        let mut vertices: Vec<Vertex> = touching.map(particle).collect();
        let particles = vertices.len();
        vertices.extend(middles);
        Self { vertices, particles }
    }

    /// Particles without faces, ascending, with the area of each \[L²\], all with this half thickness \[L\].
    pub(crate) fn points(points: &[(u32, f64)], half: f64) -> Self {
        let vertex = |&(a, area): &(u32, f64)| Vertex { nodes: [a; 4], count: 1, area, half };
        Self { vertices: points.iter().map(vertex).collect(), particles: points.len() }
    }

    /// Puts the areas of particles \[L²\].
    pub(crate) fn put_areas(&mut self, area: impl Fn(u32) -> f64) {
        self.vertices[..self.particles].iter_mut().for_each(|vertex| vertex.area = area(vertex.nodes[0]));
    }

    /// All vertices: particles in their order, then middles in the order of the cells.
    #[inline]
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// The vertex of a particle; none if it has no area.
    pub(crate) fn of_particle(&self, particle: u32) -> Option<&Vertex> {
        self.number_of(particle).map(|number| &self.vertices[number as usize])
    }

    /// Its number.
    pub(crate) fn number_of(&self, particle: u32) -> Option<u32> {
        let particles = &self.vertices[..self.particles];
        particles.binary_search_by_key(&particle, |vertex| vertex.nodes[0]).ok().map(|number| number as u32)
    }

    /// Particles, then middles.
    pub(crate) fn kinds(&self) -> [&[Vertex]; 2] {
        let (particles, middles) = self.vertices.split_at(self.particles);
        [particles, middles]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sheet_hands_all_of_its_area_to_its_vertices() {
        // A unit square and a triangle of half that beside it.
        let rest =
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 0.0]].map(|[x, y]| Vec3::new(x, y, 0.0));
        let cells = [Cell { corners: [0, 1, 2, 3], count: 4 }, Cell { corners: [1, 4, 2, 2], count: 3 }];
        let surface = Surface::new(&cells, &rest, |_| 0.05);
        let areas: Vec<f64> = surface.vertices().iter().map(|vertex| vertex.area).collect();
        let sixth = 1.0 / 6.0;
        for (found, exact) in areas.iter().zip([sixth, 2.0 * sixth, 2.0 * sixth, sixth, sixth, 2.0 * sixth]) {
            assert!((found - exact).abs() < 1e-15, "{areas:?}");
        }
        assert_eq!(surface.of_particle(4), Some(&surface.vertices()[4]));
        assert_eq!(surface.of_particle(7), None);
        let middle = surface.vertices()[5];
        assert_eq!((middle.nodes(), middle.share()), (&[0, 1, 2, 3][..], 0.25));
        assert_eq!(middle.place(|a| rest[a as usize]), Vec3::new(0.5, 0.5, 0.0));
    }
}

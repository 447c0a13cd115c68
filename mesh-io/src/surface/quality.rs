//! Figures by which a mesh is judged: spacing, angles, aspects.

use std::collections::HashSet;
use std::f64::consts::PI;

use libm::atan2;
use sph_core::{Cell, Vec3};

use super::Surface;

/// A corner sharper than this makes a face a sliver.
const SLIVER: f64 = 15.0 * PI / 180.0;

/// Figures of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Area of all faces, or of all points `[L²]`.
    pub area: f64,
    /// Least, mean and greatest length of an edge `[L]`; zero for points.
    pub spacing: [f64; 3],
    /// Smallest and greatest corner angle of a face \[rad\].
    pub angles: [f64; 2],
    /// Greatest ratio of the longest to the shortest edge of a face.
    pub aspect: f64,
    /// Faces with a corner sharper than 15°.
    pub slivers: usize,
    /// Quadrangles with a corner of more than 180°.
    pub hollow: usize,
    /// Greatest angle between the two triangles of a quadrangle \[rad\], by the diagonal across which it is less.
    pub warp: f64,
}

/// Measures a surface.
pub fn quality(surface: &Surface) -> Quality {
    let mut found = Quality {
        area: surface.areas.iter().sum(),
        spacing: [f64::INFINITY, 0.0, 0.0],
        angles: [PI, 0.0],
        aspect: 1.0,
        slivers: 0,
        hollow: 0,
        warp: 0.0,
    };
    for face in &surface.faces {
        found.add(surface, face);
    }
    let sorted = |(a, b): (u32, u32)| (a.min(b), a.max(b));
    let edges: HashSet<(u32, u32)> = surface.faces.iter().flat_map(Cell::edges).map(sorted).collect();
    // Summed in an order of its own: a set has none.
    let mut lengths: Vec<f64> = edges
        .into_iter()
        .map(|(a, b)| (surface.positions[b as usize] - surface.positions[a as usize]).norm())
        .collect();
    lengths.sort_unstable_by(f64::total_cmp);
    found.spacing = match (lengths.first(), lengths.last()) {
        (Some(&least), Some(&greatest)) => {
            [least, lengths.iter().sum::<f64>() / lengths.len() as f64, greatest]
        }
        _ => [0.0; 3],
    };
    found
}

impl Quality {
    fn add(&mut self, surface: &Surface, face: &Cell) {
        let geometry = face.geometry(&surface.positions);
        let x: Vec<_> = face.particles().iter().map(|&node| surface.positions[node as usize]).collect();
        let n = x.len();
        let (mut sharpest, mut widest) = (PI, 0.0_f64);
        let (mut shortest, mut longest) = (f64::INFINITY, 0.0_f64);
        for i in 0..n {
            let (ahead, back) = (x[(i + 1) % n] - x[i], x[(i + n - 1) % n] - x[i]);
            let across = ahead.cross(&back);
            let angle = atan2(across.norm(), ahead.dot(&back));
            // Seen from the normal, a corner that turns the other way is beyond 180°.
            let angle = if across.dot(&geometry.normal) < 0.0 { 2.0 * PI - angle } else { angle };
            (sharpest, widest) = (sharpest.min(angle), widest.max(angle));
            (shortest, longest) = (shortest.min(ahead.norm()), longest.max(ahead.norm()));
        }
        if let [a, b, c, d] = x[..] {
            let fold = |a: Vec3, b: Vec3, c: Vec3, d: Vec3| {
                let (one, other) = ((b - a).cross(&(c - a)), (c - a).cross(&(d - a)));
                atan2(one.cross(&other).norm(), one.dot(&other))
            };
            // Whichever corner is the first; across the diagonal outside a flat hollow one, which is reported as that, the fold is 180°.
            self.warp = self.warp.max(fold(a, b, c, d).min(fold(b, c, d, a)));
        }
        self.area += geometry.area;
        self.angles = [self.angles[0].min(sharpest), self.angles[1].max(widest)];
        self.aspect = self.aspect.max(longest / shortest);
        self.slivers += usize::from(sharpest < SLIVER);
        self.hollow += usize::from(widest >= PI && n == 4);
    }
}

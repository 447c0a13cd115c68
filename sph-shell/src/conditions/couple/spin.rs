//! The turn of a surface about its normal at a particle, which a director does not have: as differences of the particles around it.
//!
//! In a set that is a line, neighbours along it tell how the line turns. Elsewhere the cells around the particle do, by the mean of their uniform gradients
//! weighted by area,
//!
//! ```text
//! A_c ∇u = ½ Σ_b u_b (x_{b+1} − x_{b−1}) × n        [flanagan1981]
//! ```

use std::collections::{BTreeMap, BTreeSet};

use sph_core::{Cloud, Vec3};

/// Derivatives at a particle, `x,α = Σ g_αb (x_b − x_a)`.
#[derive(Clone, Debug)]
pub(super) struct Spin {
    /// Particles around it, and their coefficients along two directions of the surface \[1/L\]; of a line along it, and zero.
    pub around: Vec<(u32, [f64; 2])>,
    /// Whether the turn is that of a line.
    pub of_line: bool,
}

/// Neighbours of each particle of a set along edges of cells, where it is a line: each has one or two of them, and no cell lies in the set whole.
fn along_line(cloud: &Cloud, particles: &[u32]) -> Option<BTreeMap<u32, BTreeSet<u32>>> {
    let set: BTreeSet<u32> = particles.iter().copied().collect();
    let mut next: BTreeMap<u32, BTreeSet<u32>> = set.iter().map(|&a| (a, BTreeSet::new())).collect();
    for cell in &cloud.cells {
        if cell.particles().iter().all(|b| set.contains(b)) {
            return None;
        }
        for (a, b) in cell.edges().filter(|(a, b)| set.contains(a) && set.contains(b)) {
            next.get_mut(&a)?.insert(b);
            next.get_mut(&b)?.insert(a);
        }
    }
    next.values().all(|own| (1..=2).contains(&own.len())).then_some(next)
}

/// By how far the line goes from its first neighbour to the second, or from the particle to its only one.
fn of_line(cloud: &Cloud, particle: u32, next: &BTreeSet<u32>) -> Spin {
    let place = |a: u32| cloud.positions[a as usize];
    let length: f64 = next.iter().map(|&b| (place(b) - place(particle)).norm()).sum();
    let around = next.iter().enumerate().map(|(k, &b)| (b, [if k == 0 { 1.0 } else { -1.0 } / length, 0.0]));
    Spin { around: around.collect(), of_line: true }
}

/// Of the cells around each of some particles; none of a particle without a cell.
fn of_cells(cloud: &Cloud, particles: &[u32]) -> Vec<Option<Spin>> {
    let mut gradients: BTreeMap<u32, (f64, BTreeMap<u32, Vec3>)> =
        particles.iter().map(|&a| (a, Default::default())).collect();
    for cell in &cloud.cells {
        let corners = cell.particles();
        let geometry = cell.geometry(&cloud.positions);
        for a in corners {
            let Some((area, sums)) = gradients.get_mut(a) else { continue };
            *area += geometry.area;
            for (k, &b) in corners.iter().enumerate() {
                let at = |step: usize| cloud.positions[corners[(k + step) % corners.len()] as usize];
                let opposite = at(1) - at(corners.len() - 1);
                *sums.entry(b).or_default() += opposite.cross(&geometry.normal) * 0.5;
            }
        }
    }
    let spin = |a: &u32| {
        let (area, sums) = gradients.get(a).filter(|(area, _)| *area > 0.0)?;
        let frame = &cloud.frames[*a as usize];
        let along = |sum: &Vec3| [frame.t1.dot(sum) / area, frame.t2.dot(sum) / area];
        let others = sums.iter().filter(|(b, _)| *b != a);
        Some(Spin { around: others.map(|(&b, sum)| (b, along(sum))).collect(), of_line: false })
    };
    particles.iter().map(spin).collect()
}

/// The spin of each particle of a set; none of a particle without a cell around it.
pub(super) fn spins(cloud: &Cloud, particles: &[u32]) -> Vec<Option<Spin>> {
    match along_line(cloud, particles) {
        Some(next) => particles.iter().map(|a| Some(of_line(cloud, *a, &next[a]))).collect(),
        None => of_cells(cloud, particles),
    }
}

//! Where the particles are, how fast, how dense.

use sph_core::Vec3;

/// By particle: places, velocities, densities.
#[derive(Clone, Debug, Default)]
pub(crate) struct State {
    pub positions: Vec<Vec3>,
    pub velocities: Vec<Vec3>,
    pub densities: Vec<f64>,
}

impl State {
    /// The place of a particle after a time \[T\] with its velocity and, where there is any, the drag of its slot.
    #[inline(always)]
    pub fn place(&self, i: usize, drags: &[[f64; 3]], slot: usize, ahead: f64) -> Vec3 {
        let drag = drags.get(slot).map_or_else(Vec3::zeros, |drag| Vec3::from(*drag));
        self.positions[i] + (self.velocities[i] + drag) * ahead
    }

    /// Those of some particles alone.
    pub fn of(&self, particles: &[u32]) -> Self {
        let some = |list: &[Vec3]| particles.iter().map(|&i| list[i as usize]).collect();
        Self {
            positions: some(&self.positions),
            velocities: some(&self.velocities),
            densities: particles.iter().map(|&i| self.densities[i as usize]).collect(),
        }
    }

    /// A particle as seven numbers.
    pub fn row(&self, i: usize) -> [f64; 7] {
        let (r, v) = (self.positions[i], self.velocities[i]);
        [r.x, r.y, r.z, v.x, v.y, v.z, self.densities[i]]
    }

    /// Puts a particle's seven numbers.
    pub fn put(&mut self, i: usize, [x, y, z, u, v, w, density]: [f64; 7]) {
        (self.positions[i], self.velocities[i]) = (Vec3::new(x, y, z), Vec3::new(u, v, w));
        self.densities[i] = density;
    }
}

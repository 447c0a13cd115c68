//! What drives a shell: loads, and nodes whose held displacement goes with the level.

use nalgebra::Vector3;

use super::Model;
use crate::fe_shell::element;

impl Model {
    /// Lets held directions of some nodes move by this displacement at level one \[L\].
    pub fn moving(mut self, nodes: &[usize], displacement: Vector3<f64>) -> Self {
        self.moved.extend(nodes.iter().map(|&node| (node, displacement)));
        self
    }

    /// The force that supports exert on some nodes together, loads left out \[F\].
    pub fn reaction(&self, nodes: &[usize]) -> Vector3<f64> {
        let mut sum = Vector3::zeros();
        for (corners, geometry) in &self.elements {
            if corners.iter().any(|node| nodes.contains(node)) {
                let forces = element::forces(geometry, &self.corners(corners), &self.section.stiffness);
                let held = (0..4).filter(|&corner| nodes.contains(&corners[corner]));
                sum +=
                    held.map(|corner| forces.fixed_rows::<3>(3 * corner).into_owned()).sum::<Vector3<f64>>();
            }
        }
        sum
    }

    /// Puts the held directions of moved nodes where a level has them.
    pub(super) fn put(&mut self, level: f64) {
        for (node, displacement) in &self.moved {
            let frame = &self.frames[*node];
            let missing = self.reference[*node] + displacement * level - self.positions[*node];
            for axis in &frame.axes[..frame.held] {
                self.positions[*node] += axis * axis.dot(&missing);
            }
        }
    }

    /// Loads at level one.
    ///
    /// A couple m about a fixed axis pulls the director with m × d; its tangent on the sphere is skew.
    pub(super) fn loads(&self, out: &mut [f64]) {
        out.fill(0.0);
        for (node, load) in self.loads.iter().enumerate() {
            let on_director = load.couple.cross(&self.directors[node].normal);
            self.add(node, &load.force, &on_director, out);
        }
    }
}

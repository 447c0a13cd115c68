//! How far apart the two ends of a link are, and along which line.

use sph_core::Vec3;

/// What is at the other end of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Far {
    /// Another place, by its number.
    Place(usize),
    /// A point of the ground \[L\].
    Ground(Vec3),
}

/// What of the motion of its ends draws a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Span {
    /// The motion of the far end against the near one along a unit vector, since rest.
    Along(Vec3),
    /// Their distance less this length \[L\].
    Length(f64),
}

/// Two ends and what draws the link between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// The near end, by its number.
    pub near: usize,
    /// The far end, another place.
    pub far: Far,
    /// What draws it.
    pub span: Span,
}

impl Reach {
    /// Elongation \[L\], the unit vector from the near end to the far one along which it pulls, and `(1 − n nᵀ)/ℓ` in the factor `1/ℓ` of a line
    /// that turns \[1/L\]. Two ends on one place have no line between them and pull along none.
    pub(crate) fn drawn(&self, places: &[[f64; 3]], rest: &[Vec3]) -> (f64, Vec3, f64) {
        let near = Vec3::from(places[self.near]);
        match self.span {
            Span::Along(n) => {
                let moved = match self.far {
                    Far::Place(b) => Vec3::from(places[b]) - rest[b],
                    Far::Ground(_) => Vec3::zeros(),
                };
                (n.dot(&(moved - (near - rest[self.near]))), n, 0.0)
            }
            Span::Length(length) => {
                let far = match self.far {
                    Far::Place(b) => places[b].into(),
                    Far::Ground(point) => point,
                };
                let apart = far - near;
                let distance = apart.norm();
                match distance > 0.0 {
                    true => (distance - length, apart / distance, 1.0 / distance),
                    false => (-length, Vec3::zeros(), 0.0),
                }
            }
        }
    }

    /// Rate at which places that move drive the ends apart along a unit vector.
    pub(crate) fn rate(&self, n: &Vec3, motion: &[[f64; 3]]) -> f64 {
        let far = match self.far {
            Far::Place(b) => motion[b].into(),
            Far::Ground(_) => Vec3::zeros(),
        };
        n.dot(&(far - Vec3::from(motion[self.near])))
    }

    /// Pulls the ends to each other: adds a force to the near one and takes it from the far one.
    pub(crate) fn pull(&self, force: &Vec3, forces: &mut [[f64; 3]]) {
        for k in 0..3 {
            forces[self.near][k] += force[k];
            if let Far::Place(b) = self.far {
                forces[b][k] -= force[k];
            }
        }
    }

    /// Adds a bound of the square of its highest frequency, or of its rate of decay, to the sums over rows of `M^{-½} K M^{-½}`.
    pub(crate) fn bound(&self, stiffness: f64, masses: &[f64], sums: &mut [f64]) {
        let a = self.near;
        sums[a] += stiffness / masses[a];
        if let Far::Place(b) = self.far {
            let across = stiffness / (masses[a] * masses[b]).sqrt();
            sums[a] += across;
            sums[b] += stiffness / masses[b] + across;
        }
    }
}

//! All supports of a shell, joined particle by particle.

use sph_core::Vec3;

use crate::conditions::supports::{Constraint, DirectorHold, Holds, Supported};
use crate::error::ShellError;
use crate::reference::Reference;

/// A director held in a plane may stand out of it by this much: rounding of positions and rotations, and no more.
const OUT_OF_PLANE: f64 = 1e-6;

/// What is held of each particle.
pub(crate) struct Constraints {
    /// Number of each particle's entry in `all`, one up; zero for a free particle.
    pub of_particle: Vec<u32>,
    pub all: Vec<Constraint>,
}

/// The plane of an axis and a director at rest; none where they are parallel.
fn leaning(axis: &Vec3, director: &Vec3) -> Option<DirectorHold> {
    let normal = axis.cross(director);
    (normal.norm() > OUT_OF_PLANE).then(|| DirectorHold::InPlane(normal.normalize()))
}

/// What supports, by their numbers, ask of the director of one particle.
type Asked = (usize, DirectorHold);

/// Whether a support of whole sections holds those of two sheets of a junction in different planes.
fn at_an_angle(holds: &[Holds], one: &Asked, two: &Asked) -> bool {
    let (DirectorHold::InPlane(m), DirectorHold::InPlane(n)) = (one.1, two.1) else {
        return false;
    };
    one.0 == two.0 && holds[one.0].section.is_some() && m.cross(&n).norm() > OUT_OF_PLANE
}

impl Constraints {
    /// Joins all supports of each particle.
    ///
    /// # Errors
    /// [`ShellError`] for empty and unknown sets, planes that directors stand out of, and supports that contradict each other.
    pub fn new(reference: &Reference, supports: &[Supported]) -> Result<Self, ShellError> {
        let cloud = &reference.cloud;
        let count = cloud.len();
        let holds: Vec<Holds> =
            supports.iter().map(|supported| supported.support.holds().about(&reference.origin)).collect();
        let mut asked: Vec<Vec<Asked>> = vec![Vec::new(); count];
        for (support, supported) in supports.iter().enumerate() {
            if supported.particles.is_empty() {
                return Err(ShellError::EmptySet("a support"));
            }
            for &particle in &supported.particles {
                let list = asked.get_mut(particle as usize).ok_or(ShellError::NoSuchParticle {
                    what: "a support",
                    particle,
                    count,
                })?;
                let mut director = holds[support].director;
                if let Some(axis) = holds[support].section {
                    director = leaning(&axis, &cloud.frames[particle as usize].n)
                        .ok_or(ShellError::SectionAlongAxis { support, particle })?;
                }
                if let DirectorHold::InPlane(normal) = director {
                    // The turn that is left free runs along ν × d.
                    let along = normal.dot(&cloud.frames[particle as usize].n);
                    if along.abs() > OUT_OF_PLANE {
                        return Err(ShellError::OutOfPlane { support, particle, along });
                    }
                }
                list.push((support, director));
            }
        }
        let mut tied = vec![false; if cloud.joined.is_empty() { 0 } else { count }];
        for group in &cloud.joined {
            // What one particle of a group is asked all are, each support once.
            let mut all: Vec<_> =
                group.iter().flat_map(|&a| std::mem::take(&mut asked[a as usize])).collect();
            all.sort_by_key(|(support, _)| *support);
            if let Some(pair) = all.windows(2).find(|pair| at_an_angle(&holds, &pair[0], &pair[1])) {
                return Err(ShellError::SectionAlongAxis { support: pair[0].0, particle: group[0] });
            }
            all.dedup_by_key(|(support, _)| *support);
            for &a in group {
                asked[a as usize].clone_from(&all);
                tied[a as usize] = true;
            }
        }
        let tied = |particle: usize| tied.get(particle).copied().unwrap_or_default();
        let mut of_particle = vec![0; count];
        let mut all = Vec::new();
        for (particle, list) in asked.iter().enumerate().filter(|(a, list)| !list.is_empty() || tied(*a)) {
            let rest = (cloud.positions[particle], cloud.frames[particle].n);
            let list: Vec<(usize, Holds)> = list
                .iter()
                .map(|&(support, director)| (support, Holds { director, ..holds[support].clone() }))
                .collect();
            let joined = Constraint::join(particle as u32, rest, &list)?;
            all.push(Constraint { tied: tied(particle), ..joined });
            of_particle[particle] = all.len() as u32;
        }
        Ok(Self { of_particle, all })
    }

    /// What is held of a particle.
    pub fn of(&self, particle: usize) -> Option<&Constraint> {
        let number = self.of_particle[particle] as usize;
        number.checked_sub(1).map(|i| &self.all[i])
    }

    /// Holds some particles so, whatever held them before.
    pub fn hold(&mut self, particles: &[u32], constraint: Constraint) {
        self.all.push(constraint);
        let number = self.all.len() as u32;
        particles.iter().for_each(|&a| self.of_particle[a as usize] = number);
    }
}

#[cfg(test)]
mod tests {
    use shell_kinematics::{Isotropic, IsotropicSection, Section};
    use sph_core::{Cylinder, EndWeights, Patch, Plate, lattice};

    use super::*;
    use crate::conditions::supports::Diaphragm;
    use crate::formulation::{Formulation, Reach};

    fn held(patch: &dyn Patch, axis: Vec3) -> Result<Vec<(Vec3, DirectorHold)>, ShellError> {
        let cloud = lattice(patch, [5, 3], EndWeights::Trapezoid).unwrap();
        let section = IsotropicSection::new(Isotropic::new(10.0, 0.3).unwrap(), 0.1).unwrap();
        let formulation = Formulation::StressPoint(Reach::Cell);
        let reference = Reference::new(cloud, &formulation, &section.scales(), 1.0, None).unwrap();
        let particles: Vec<u32> = (0..15).collect();
        let support = Box::new(Diaphragm { axis, section: true });
        let constraints = Constraints::new(&reference, &[Supported { particles, support }])?;
        let normals = reference.cloud.frames.iter().map(|frame| frame.n);
        Ok(normals.zip(constraints.all.iter().map(|one| one.director)).collect())
    }

    /// Of a cylinder each director stays in the plane of the axis and of itself; one along the axis is refused.
    #[test]
    fn a_whole_section_leans_along_the_axis_alone() {
        let cylinder = Cylinder { radius: 3.0, angles: [-0.5, 0.4], length: 2.5 };
        let all = held(&cylinder, Vec3::y() * 2.0).unwrap();
        assert_eq!(all.len(), 15);
        for (director, hold) in all {
            let DirectorHold::InPlane(normal) = hold else { panic!("{hold:?}") };
            let off = [normal.norm() - 1.0, normal.dot(&director), normal.dot(&Vec3::y())];
            assert!(off.iter().all(|off| off.abs() < 1e-14), "{off:?}");
        }
        let refused = held(&Plate { lengths: [2.0, 1.0] }, Vec3::z()).unwrap_err();
        assert!(matches!(refused, ShellError::SectionAlongAxis { support: 0, particle: 0 }), "{refused}");
    }
}

//! Which rigid motions the supports of a shell leave free.

use sph_core::{Cloud, Vec3};
use sph_shell::{BodySpring, DirectorHold, Holds, RigidSet, Spring, SpringBetween, Springs, Tie, TurnSpring};

use crate::bodies::rigid::{End, Hold, Link, free_of_pieces};

/// Rigid motions `u = τ + ω × (x − c)`, `δd = ω × d` that violate no support, in words; each sheet of the cloud may
/// move by itself, unless springs join it to others.
pub(crate) fn free_motions(
    cloud: &Cloud,
    supports: &[(Vec<u32>, Holds)],
    ties: &[Tie],
    rigid: &[RigidSet],
    springs: &Springs,
) -> Vec<String> {
    let pieces = tied(cloud.pieces(), cloud, ties, rigid);
    let sprung = sprung_holds(springs, cloud, rigid);
    let of_piece = |piece: &Vec<u32>| {
        let mut holds = holds_of(cloud, piece, supports);
        let own = |a: &u32| piece.binary_search(a).is_ok();
        let first = |body: &&RigidSet| body.particles.iter().any(own);
        holds.extend(rigid.iter().filter(first).flat_map(holds_of_body));
        holds.extend(sprung.iter().filter(|(a, _)| own(a)).map(|(_, hold)| *hold));
        holds
    };
    let holds: Vec<Vec<Hold>> = pieces.iter().map(of_piece).collect();
    let links = links(springs, cloud, rigid);
    let free = free_of_pieces(&cloud.positions, &pieces, &holds, &links);
    if pieces.len() == 1 {
        return free.into_iter().flatten().collect();
    }
    let named = |(piece, free): (&Vec<u32>, Vec<String>)| {
        let first = piece[0];
        free.into_iter().map(move |motion| format!("{motion} of the sheet with particle {first}"))
    };
    pieces.iter().zip(free).flat_map(named).collect()
}

/// What springs to the ground hold, particle by particle, and of bodies with a particle of theirs.
fn sprung_holds(springs: &Springs, cloud: &Cloud, rigid: &[RigidSet]) -> Vec<(u32, Hold)> {
    let mut all = Vec::new();
    for Spring { stiffness, direction } in &springs.ground {
        all.extend(stiffness.iter().map(|&(a, _)| (a, Hold::Displacement(a, direction.normalize()))));
    }
    for TurnSpring { stiffness, axis } in &springs.turning {
        let axis = axis.normalize();
        all.extend(stiffness.iter().map(|&(a, _)| {
            let d = cloud.frames[a as usize].n;
            (a, Hold::Turn(axis - d * d.dot(&axis)))
        }));
    }
    for spring in &springs.of_bodies {
        if let BodySpring::Turning { body, axis, .. } = spring {
            let first = rigid.get(*body).and_then(|set| set.particles.first());
            all.extend(first.map(|&a| (a, Hold::Turn(axis.normalize()))));
        }
    }
    all
}

/// What springs between sets join.
fn links(springs: &Springs, cloud: &Cloud, rigid: &[RigidSet]) -> Vec<Link> {
    let mut all = Vec::new();
    let place = |particle: u32| End { particle, at: cloud.positions[particle as usize] };
    for SpringBetween { stiffness, direction } in &springs.between {
        let link =
            |&(pair, _): &([u32; 2], f64)| Link { ends: pair.map(place), along: direction.normalize() };
        all.extend(stiffness.iter().map(link));
    }
    for spring in &springs.of_bodies {
        let BodySpring::Between { bodies, direction, .. } = spring else { continue };
        let end = |set: &RigidSet| Some(End { particle: *set.particles.first()?, at: set.at });
        let ends = bodies.map(|body| rigid.get(body).and_then(end));
        if let [Some(one), Some(two)] = ends {
            all.push(Link { ends: [one, two], along: direction.normalize() });
        }
    }
    all
}

/// Pieces that ties and rigid bodies make one.
fn tied(mut pieces: Vec<Vec<u32>>, cloud: &Cloud, ties: &[Tie], rigid: &[RigidSet]) -> Vec<Vec<u32>> {
    let of_tie = |Tie { edge, host }: &Tie| {
        let of_host = host.iter().flat_map(|&c| cloud.cells[c as usize].particles());
        edge.iter().chain(of_host).copied().collect::<Vec<u32>>()
    };
    let of_bodies = rigid.iter().map(|body| body.particles.clone());
    for particles in ties.iter().map(of_tie).chain(of_bodies) {
        let mut touched = vec![false; cloud.len()];
        particles.iter().filter(|a| (**a as usize) < cloud.len()).for_each(|&a| touched[a as usize] = true);
        let meets = |piece: &Vec<u32>| piece.iter().any(|&a| touched[a as usize]);
        let (together, apart): (Vec<_>, Vec<_>) = pieces.into_iter().partition(meets);
        let mut one: Vec<u32> = together.into_iter().flatten().collect();
        one.sort_unstable();
        pieces = apart;
        pieces.extend((!one.is_empty()).then_some(one));
        pieces.sort();
    }
    pieces
}

/// What the supports of a rigid body hold.
fn holds_of_body(body: &RigidSet) -> Vec<Hold> {
    let mut all = Vec::new();
    for holds in &body.holds {
        all.extend(holds.translations.iter().map(|e| Hold::DisplacementAt(body.at, *e)));
        match holds.director {
            DirectorHold::Free => {}
            DirectorHold::InPlane(n) => {
                let frame = sph_core::Frame::from_normal(n);
                all.extend([frame.t1, frame.t2].map(Hold::Turn));
            }
            DirectorHold::Fixed => all.extend([Vec3::x(), Vec3::y(), Vec3::z()].map(Hold::Turn)),
        }
    }
    all
}

/// What the supports of one sheet hold.
fn holds_of(cloud: &Cloud, piece: &[u32], supports: &[(Vec<u32>, Holds)]) -> Vec<Hold> {
    let mut all = Vec::new();
    for (particles, holds) in supports {
        for &a in particles.iter().filter(|a| piece.binary_search(a).is_ok()) {
            let frame = cloud.frames[a as usize];
            all.extend(holds.translations.iter().map(|e| Hold::Displacement(a, *e)));
            all.extend(holds.section.map(|axis| Hold::Turn(axis - frame.n * frame.n.dot(&axis))));
            match holds.director {
                DirectorHold::Free => {}
                DirectorHold::InPlane(n) => all.push(Hold::Turn(frame.n.cross(&n))),
                DirectorHold::Fixed => all.extend([Hold::Turn(frame.t1), Hold::Turn(frame.t2)]),
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use sph_core::{Cell, EndWeights, Plate, lattice};
    use sph_shell::{Clamped, Held, Hinged, Support, SymmetryPlane};

    fn free(supports: &[(Vec<u32>, Holds)]) -> Vec<String> {
        let cloud = lattice(&Plate { lengths: [2.0, 1.0] }, [5, 3], EndWeights::Trapezoid).unwrap();
        free_motions(&cloud, supports, &[], &[], &Springs::default())
    }

    #[test]
    fn nothing_held_leaves_six() {
        assert_eq!(free(&[]).len(), 6);
    }

    #[test]
    fn a_hinged_edge_turns_about_itself() {
        let hinge = (vec![0, 1, 2], Hinged.holds());
        assert_eq!(free(&[hinge]), ["rotation about the line through [0, 0.5, 0] along [0, 1, 0]"]);
    }

    #[test]
    fn one_clamped_particle_can_still_drill() {
        // The director holds two rotations; the third turns about it.
        assert_eq!(
            free(&[(vec![0], Clamped.holds())]),
            ["rotation about the line through [0, 0, 0] along [0, 0, 1]"]
        );
        assert!(free(&[(vec![0, 1, 2], Clamped.holds())]).is_empty());
    }

    #[test]
    fn two_mirror_planes_leave_their_common_line() {
        let x = (vec![0, 1, 2], SymmetryPlane { normal: Vec3::x() }.holds());
        let y = (vec![0, 3, 6, 9, 12], SymmetryPlane { normal: Vec3::y() }.holds());
        assert_eq!(free(&[x, y]), ["translation along z"]);
    }

    #[test]
    fn held_directions_count_one_by_one() {
        let held = |displacement, director| Held { displacement, director }.holds();
        let down = (vec![0, 2, 14], held(vec![Vec3::z()], None));
        assert_eq!(
            free(std::slice::from_ref(&down)),
            ["translation along x", "translation along y", "rotation about z"]
        );
        let wall = (vec![0, 2], held(vec![Vec3::x()], None));
        assert_eq!(free(&[down, wall]), ["translation along y"]);
        // A director in the plane normal to x does not turn about y.
        let turn = (vec![0], held(vec![Vec3::x(), Vec3::y(), Vec3::z()], Some(Vec3::x())));
        assert_eq!(free(&[turn]).len(), 2);
    }

    #[test]
    fn each_sheet_needs_supports_of_its_own() {
        let plate = lattice(&Plate { lengths: [2.0, 1.0] }, [5, 3], EndWeights::Trapezoid).unwrap();
        let mut positions = plate.positions.clone();
        positions.extend(plate.positions.iter().map(|x| x + Vec3::new(0.0, 0.0, 3.0)));
        let mut cells = plate.cells.clone();
        cells.extend(plate.cells.iter().map(|cell| Cell::quadrangle(cell.corners.map(|b| b + 15))));
        let cloud = Cloud::from_cells(positions, None, cells).unwrap();
        let clamp = |first| (vec![first, first + 1, first + 2], Clamped.holds());
        assert!(free_motions(&cloud, &[clamp(0), clamp(15)], &[], &[], &Springs::default()).is_empty());
        let free = free_motions(&cloud, &[clamp(0)], &[], &[], &Springs::default());
        assert_eq!(free.len(), 6);
        assert_eq!(free[0], "translation along x of the sheet with particle 15");
        // Springs along z between particles over each other leave what they do not see.
        let stiffness = [(0, 15), (2, 17), (12, 27)].map(|(a, b)| ([a, b], 1.0)).to_vec();
        let along = |directions: &[Vec3]| Springs {
            between: directions
                .iter()
                .map(|&direction| SpringBetween { stiffness: stiffness.clone(), direction })
                .collect(),
            ..Springs::default()
        };
        let free = free_motions(&cloud, &[clamp(0)], &[], &[], &along(&[Vec3::z()]));
        let what = ["translation along x", "translation along y", "rotation about z"];
        assert_eq!(free, what.map(|motion| format!("{motion} of the sheet with particle 15")));
        let all = along(&[Vec3::x(), Vec3::y(), Vec3::z()]);
        assert!(free_motions(&cloud, &[clamp(0)], &[], &[], &all).is_empty());
    }
}

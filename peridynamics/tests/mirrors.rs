//! A part between planes of symmetry is that part of the whole: forces, energy, tangent, marches, bonds that break.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod lattices;
mod plates;

use explicit_dynamics::{Dynamics, Instant, LinearisedDynamics, Step};
use implicit_statics::{Equilibrium, tangent_error};
use lattices::{ALL, Random, formulation, parts, poisson};
use peridynamics::{
    Correction, Crack, Criterion, Elastic, Fracture, Idealisation, Law, Mirror, Parts, Sheets, Solid,
    SolidError, Space, StaticSolid,
};
use sph_core::{Block, BlockLattice, NodePlaces, Vec3};

const DX: f64 = 0.01;
/// The corner of the part: no plane lies at zero.
const CORNER: [f64; 3] = [0.37, -0.21, 0.13];

/// A box of cells from a corner that is so many cells before that of the part.
fn lattice(dimensions: usize, cells: [usize; 3], before: [usize; 3], nodes: NodePlaces) -> Block {
    let along = |a: usize| if a < dimensions { cells[a] as f64 * DX } else { DX };
    let origin = Vec3::from_fn(|a, _| if a < dimensions { CORNER[a] - before[a] as f64 * DX } else { 0.0 });
    let lattice = BlockLattice {
        dimensions,
        lengths: [0, 1, 2].map(along),
        spacing: [DX; 3],
        origin,
        nodes,
        grading: [1.0; 3],
        disorder: 0.0,
        seed: 1,
    };
    lattice.block().unwrap()
}

/// A part of a body with its planes, and the whole.
struct Pair {
    part: Solid,
    whole: Solid,
    mirrors: Vec<Mirror>,
    /// Of each node of the whole, that of the part, and the signs of its components.
    folded: Vec<(usize, Vec3)>,
}

impl Pair {
    fn new(part: Parts, whole: Parts, mirrors: &[Mirror]) -> Self {
        let whole = Solid::new(whole).unwrap();
        let part = Solid::mirrored(part, mirrors).unwrap();
        let (places, of_part) = (&whole.block().positions, &part.block().positions);
        let bounds = |a: usize| {
            let along = || of_part.iter().map(|x| x[a]);
            [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)]
        };
        let bounds = [0, 1, 2].map(bounds);
        let fold = |x: &Vec3| {
            let (mut x, mut signs) = (*x, Vec3::repeat(1.0));
            for _ in 0..20 {
                for mirror in mirrors {
                    let (a, [least, most]) = (mirror.axis, bounds[mirror.axis]);
                    if x[a] < least - 1e-9 && mirror.at <= least + 1e-9
                        || x[a] > most + 1e-9 && mirror.at >= most - 1e-9
                    {
                        x[a] = 2.0 * mirror.at - x[a];
                        signs[a] = -signs[a];
                    }
                }
            }
            let node = of_part.iter().position(|y| (x - y).norm() < 1e-6 * DX).unwrap();
            (node, signs)
        };
        let folded = places.iter().map(fold).collect();
        Self { part, whole, mirrors: mirrors.to_vec(), folded }
    }

    /// Puts the whole where the part is.
    fn unfold(&mut self) {
        for (node, (source, signs)) in self.folded.iter().enumerate() {
            let u = self.part.displacement(*source).component_mul(signs);
            self.whole.put(node, self.whole.block().positions[node] + u);
            self.whole.set_velocity(node, self.part.velocity(*source).component_mul(signs));
            if let Some(d) = self.part.director(*source) {
                self.whole.set_director(node, d.component_mul(signs));
            }
        }
    }

    /// Displaces all nodes at random, those on planes along them.
    fn shake(&mut self) {
        let (mut random, dimensions) = (Random(7), self.part.block().dimensions);
        for node in 0..self.part.len() {
            let x = self.part.block().positions[node];
            let sheets = self.part.director(node);
            let mut u = random.vector(if sheets.is_some() { 3 } else { dimensions }) * (0.02 * DX);
            let mut turn = random.vector(3) * 0.02;
            for mirror in self.mirrors.iter().filter(|mirror| (x[mirror.axis] - mirror.at).abs() < 1e-9) {
                u[mirror.axis] = 0.0;
                turn[mirror.axis] = 0.0;
            }
            self.part.put(node, x + u);
            if let Some(d) = sheets {
                self.part.set_director(node, d + turn);
            }
        }
        self.unfold();
    }

    /// Nodes of the whole that the part has too, with their numbers in it.
    fn same(&self) -> Vec<(usize, usize)> {
        let place = |solid: &Solid, node: usize| solid.block().positions[node];
        let here = |&(node, source): &(usize, usize)| {
            (place(&self.whole, node) - place(&self.part, source)).norm() < 1e-6 * DX
        };
        self.folded.iter().enumerate().map(|(node, (source, _))| (node, *source)).filter(here).collect()
    }

    fn share(&self, node: usize) -> f64 {
        let x = self.part.block().positions[node];
        let on = self.mirrors.iter().filter(|mirror| (x[mirror.axis] - mirror.at).abs() < 1e-9).count();
        0.5_f64.powi(on as i32)
    }

    /// Greatest difference of the forces of the part from its shares of those of the whole, over the greatest.
    fn forces_apart(&mut self) -> f64 {
        self.part.evaluate_internal(true);
        self.whole.evaluate_internal(true);
        let (mut apart, mut most) = (0.0_f64, 0.0_f64);
        for (node, source) in self.same() {
            let share = self.share(source);
            let (of_part, of_whole) = (self.part.internal_force(source), self.whole.internal_force(node));
            apart = apart.max((of_part - of_whole * share).norm());
            most = most.max(of_whole.norm());
            if let (Some(own), Some(all)) =
                (self.part.internal_couple(source), self.whole.internal_couple(node))
            {
                apart = apart.max((own - all * share).norm() / DX);
            }
        }
        apart / most
    }
}

/// The tangent of the part against the difference of its forces.
fn tangent_apart(part: Solid) -> f64 {
    let mut system = StaticSolid::new(part);
    let mut random = Random(3);
    let direction: Vec<f64> = (0..system.unknowns()).map(|_| random.next()).collect();
    tangent_error(&mut system, 0.0, &direction, 1e-5 * DX)
}

/// Cells of the part, cells before it, and cells of the whole, along each axis, with the planes.
type Case = ([usize; 3], [usize; 3], [usize; 3], Vec<Mirror>);

fn plane(axis: usize, cells: usize) -> Mirror {
    Mirror { axis, at: CORNER[axis] + cells as f64 * DX }
}

fn cases(dimensions: usize) -> Vec<Case> {
    if dimensions == 3 {
        return vec![
            ([4, 3, 3], [4, 0, 0], [8, 3, 3], vec![plane(0, 0)]),
            ([4, 4, 3], [4, 0, 0], [8, 8, 3], vec![plane(0, 0), plane(1, 4)]),
        ];
    }
    vec![
        ([5, 4, 1], [5, 0, 0], [10, 4, 1], vec![plane(0, 0)]),
        ([5, 4, 1], [0, 4, 0], [10, 8, 1], vec![plane(0, 5), plane(1, 0)]),
        // Between two planes a body repeats: of five cells the middle one is that of infinitely many.
        ([2, 4, 1], [20, 0, 0], [42, 4, 1], vec![plane(0, 0), plane(0, 2)]),
    ]
}

fn material(poisson: f64) -> Elastic {
    Elastic { young: 2e11, poisson, density: 7800.0 }
}

fn pairs(nodes: NodePlaces, correction: Correction) -> Vec<(String, Pair)> {
    let mut out = Vec::new();
    for (space, law) in ALL {
        let dimensions = if space == Space::Solid { 3 } else { 2 };
        for (number, (cells, before, of_whole, mirrors)) in cases(dimensions).into_iter().enumerate() {
            let shape = peridynamics::Formulation { correction, horizon: 2.015, ..formulation(space, law) };
            let of = |cells, before| {
                parts(lattice(dimensions, cells, before, nodes), material(poisson(space, law)), shape)
            };
            let pair = Pair::new(of(cells, [0; 3]), of(of_whole, before), &mirrors);
            out.push((format!("{space:?} {law:?} {nodes:?} {correction:?} {number}"), pair));
        }
    }
    out
}

/// Plates of two sheets.
fn plates(correction: Correction) -> Vec<(String, Pair)> {
    let of = |cells, before, law| {
        let shape = peridynamics::Formulation { correction, ..plates::formulation(law) };
        let block = lattice(2, cells, before, NodePlaces::Edges);
        let formulation = Idealisation::Sheets(Sheets { thickness: DX, formulation: shape });
        let poisson = poisson(Space::PlaneStress, law);
        Parts { formulation, ..parts(block, material(poisson), shape) }
    };
    let mut out = Vec::new();
    for law in [Law::BondBased, Law::StateBased] {
        for (number, (cells, before, of_whole, mirrors)) in cases(2).into_iter().enumerate() {
            let pair = Pair::new(of(cells, [0; 3], law), of(of_whole, before, law), &mirrors);
            out.push((format!("sheets {law:?} {correction:?} {number}"), pair));
        }
    }
    out
}

fn all() -> Vec<(String, Pair)> {
    let mut out = plates(Correction::Even);
    out.extend(plates(Correction::Balanced));
    for nodes in [NodePlaces::Centres, NodePlaces::Edges] {
        for correction in [Correction::Even, Correction::EnergyFactor, Correction::None] {
            out.extend(pairs(nodes, correction));
        }
        if nodes == NodePlaces::Edges {
            out.extend(pairs(nodes, Correction::Balanced));
        }
    }
    // What goes through a section between two parallel planes no face fixes: balanced weights of a body with ends are others.
    out.retain(|(name, _)| !(name.contains("Balanced") && name.ends_with('2')));
    out
}

#[test]
fn a_part_has_the_forces_and_the_energy_of_the_whole() {
    for (name, mut pair) in all() {
        pair.shake();
        // Rounding of places of 40 spacings in strains of 2e-2.
        let apart = pair.forces_apart();
        assert!(apart < 1e-11, "{name}: {apart:.1e}");
        let parallel = name.ends_with('2');
        // What the planes bear balances the forces on the nodes.
        for axis in 0..2 {
            let mirrored = pair.mirrors.iter().any(|mirror| mirror.axis == axis);
            let nodes = 0..pair.part.len();
            let borne: f64 = nodes.clone().map(|node| pair.part.reaction(node)[axis]).sum();
            let size: f64 = nodes.map(|node| pair.part.internal_force(node)[axis].abs()).sum();
            assert!(!mirrored || borne.abs() < 1e-11 * size, "{name}: {borne:e} {size:e}");
        }
        let (part, whole) = (pair.part.internal_energy(), pair.whole.internal_energy());
        let times = 2_f64.powi(pair.mirrors.len() as i32);
        assert!(parallel || (times * part / whole - 1.0).abs() < 1e-12, "{name}: {part:e} {whole:e}");
        for (node, source) in pair.same() {
            let [own, all] = [pair.part.stress(source), pair.whole.stress(node)];
            let apart = (0..3).map(|a| (own[(a, a)] - all[(a, a)]).abs()).fold(0.0, f64::max);
            assert!(apart < 1e-11 * all.norm().max(1e9), "{name}: {own} {all}");
        }
    }
}

#[test]
fn the_tangent_of_a_part_is_the_difference_of_its_forces() {
    for (name, mut pair) in all() {
        pair.shake();
        // Central differences lose digits to rounding.
        let apart = tangent_apart(pair.part);
        assert!(apart < 1e-7, "{name}: {apart:.1e}");
    }
}

/// The product of the tangent by bonds, from which stable steps come, is symmetric and that of the whole.
#[test]
fn a_part_has_the_tangent_of_the_whole() {
    for (name, mut pair) in all() {
        pair.shake();
        let rows = pair.part.motion()[0].len();
        let mut random = Random(11);
        let mut vector = |_| (0..3 * rows).map(|_| random.next()).collect::<Vec<f64>>();
        let [a, b] = [0, 1].map(&mut vector);
        let mut product = |v: &[f64]| {
            let mut out = vec![0.0; 3 * rows];
            pair.part.apply(v, &mut out);
            out
        };
        let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
        let (of_a, of_b) = (product(&a), product(&b));
        let [left, right] = [dot(&a, &of_b), dot(&b, &of_a)];
        let size = dot(&of_a, &of_a).sqrt() * dot(&b, &b).sqrt();
        assert!((left - right).abs() < 1e-12 * size, "{name}: {left:e} {right:e}");
    }
}

/// A notched plate is torn open, its bonds breaking by stretch and by work: half of it goes as the whole.
#[test]
fn half_of_a_body_breaks_as_the_whole() {
    let cells = [10, 16, 1];
    for nodes in [NodePlaces::Centres, NodePlaces::Edges] {
        for (law, criterion) in [
            (Law::BondBased, Criterion::EnergyByStretch(3e3)),
            (Law::StateBased, Criterion::EnergyByStretch(3e3)),
            (Law::StateBased, Criterion::EnergyByWork(3e3)),
        ] {
            let middle = CORNER[1] + 8.25 * DX;
            let crack = |before: f64| {
                let end = |x: f64| Vec3::new(CORNER[0] + x * DX, middle, 0.0);
                Crack::Segment([end(-before), end(3.0)])
            };
            let of = |cells, before, crack| Parts {
                fracture: Some(Fracture { criterion, unbreakable: Vec::new() }),
                cracks: vec![crack],
                ..parts(
                    lattice(2, cells, before, nodes),
                    material(poisson(Space::PlaneStress, law)),
                    formulation(Space::PlaneStress, law),
                )
            };
            // The crack of the part ends on the plane; that of the whole goes on to its image.
            let part = of(cells, [0; 3], crack(0.0));
            let whole = of([20, 16, 1], [10, 0, 0], crack(3.0));
            let mut pair = Pair::new(part, whole, &[plane(0, 0)]);
            for node in 0..pair.part.len() {
                let x = pair.part.block().positions[node];
                pair.part.set_velocity(node, Vec3::y() * (400.0 * (x.y - middle)));
            }
            pair.unfold();
            let before = pair.part.broken()[0].len();
            let dt = pair.whole.stable_step(0.8).unwrap().dt;
            let own = pair.part.stable_step(0.8).unwrap().dt;
            assert!(own >= dt * (1.0 - 1e-6), "{own} {dt}");
            let mut dissipated = [0.0; 2];
            for step in 0..150 {
                let [from, to] = [0, 1].map(|k| Instant { time: f64::from(step + k) * dt, level: 1.0 });
                let step = Step { from, to, kick: if step == 0 { 0.5 * dt } else { dt }, damping: 0.0 };
                for (body, lost) in [&mut pair.part, &mut pair.whole].into_iter().zip(&mut dissipated) {
                    body.evaluate(from);
                    *lost += body.kick(&step).dissipated;
                    body.drift(&step);
                }
            }
            assert!(pair.part.broken()[0].len() > before + 40, "{}", pair.part.broken()[0].len() - before);
            let mut apart = 0.0_f64;
            for (node, (source, signs)) in pair.folded.iter().enumerate() {
                let [own, all] =
                    [pair.part.displacement(*source).component_mul(signs), pair.whole.displacement(node)];
                apart = apart.max((own - all).norm());
                assert!((pair.part.damage(*source) - pair.whole.damage(node)).abs() < 1e-12);
            }
            // What breaks is the same.
            assert!(apart < 1e-9 * DX, "{law:?} {nodes:?}: {:.1e}", apart / DX);
            assert!((2.0 * dissipated[0] / dissipated[1] - 1.0).abs() < 1e-9, "{dissipated:?}");
        }
    }
}

#[test]
fn planes_inside_a_body_are_refused() {
    let of = |mirror| {
        let block = lattice(2, [6, 4, 1], [0; 3], NodePlaces::Edges);
        let shape = formulation(Space::PlaneStress, Law::StateBased);
        Solid::mirrored(parts(block, material(0.3), shape), &[mirror]).map(|_| ())
    };
    assert_eq!(of(plane(0, 0)), Ok(()));
    let inside = plane(0, 2);
    assert_eq!(of(inside), Err(SolidError::Mirror { axis: 0, at: inside.at }));
    let across = Mirror { axis: 2, at: 0.0 };
    assert_eq!(of(across), Err(SolidError::Mirror { axis: 2, at: 0.0 }));
}

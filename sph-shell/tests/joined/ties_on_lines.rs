//! Edges tied along lines of their hosts, where several cells are equally near: rounding must choose none of them.

use crate::common::{
    RandomNumbers, Sheets, X, Y, Z, at, derivatives_agree, line, linear_energy, parts, supported,
};
use explicit_dynamics::Amplitude;
use implicit_statics::Equilibrium;
use nalgebra::{Matrix3, Rotation3};
use sph_core::{Cell, Cloud, Vec3};
use sph_shell::{AppliedLoad, Clamped, Force, Formulation, Load, Parts, Reach, Shell, StaticShell, Tie};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

/// A tied structure: which particles hang, on which cells, and where it is held and pulled.
struct Tied {
    cloud: Cloud,
    edge: Vec<u32>,
    host: Vec<u32>,
    foot: Vec<u32>,
    pulled: Vec<(u32, f64)>,
    pull: Vec3,
}

/// A plate, curved so that its cells are not in one plane, and a slanted rib over one of its lines.
fn rib_on_a_line() -> Tied {
    let flat = Sheets::default()
        .add(Vec3::zeros(), [X, Y], [6, 6])
        .add(Y * 0.5, [X, Z * 0.3 + Y * 0.1], [7, 3])
        .cloud();
    let mut positions = flat.positions;
    positions.iter_mut().for_each(|x| x.z += 0.1 * (x.x - 0.2).powi(2));
    let edge: Vec<u32> = (49..81).filter(|a| (a - 49) % 4 == 0).collect();
    let tip: Vec<u32> = (49..81).filter(|a| (a - 49) % 4 == 3).collect();
    let cloud = Cloud::from_sheets(positions, None, flat.cells, Vec::new()).unwrap();
    let foot = at(&cloud, |x| x.y < 1e-9);
    let pulled = tip.into_iter().map(|a| (a, 1.0)).collect();
    Tied { cloud, edge, host: (0..36).collect(), foot, pulled, pull: Y + X * 0.3 }
}

/// A square tube and a wall across it, in the plane of one of its rings of lines: the wall turns about the four folds of the tube.
fn wall_in_a_tube(joined: bool) -> Tied {
    let sheets = Sheets::default()
        .add(Vec3::zeros(), [X, Y * 3.0], [4, 6])
        .add(X, [Z, Y * 3.0], [4, 6])
        .add(X + Z, [-X, Y * 3.0], [4, 6])
        .add(Z, [-Z, Y * 3.0], [4, 6])
        .add(Y * 1.5, [X, Z], [3, 3]);
    let cloud = sheets.cloud();
    let wall = |a: u32| a as usize >= cloud.len() - 16;
    // Corners of the wall stand where those of the tube do: they hang like the others.
    let groups = cloud.joined.iter().map(|group| group.iter().copied().filter(|&a| !wall(a)).collect());
    let groups: Vec<Vec<u32>> = groups.filter(|group: &Vec<u32>| group.len() > 1).collect();
    let rim = |x: &Vec3| x.x.min(x.z) < 1e-9 || x.x.max(x.z) > 1.0 - 1e-9;
    let edge = at(&cloud, rim).into_iter().filter(|&a| wall(a)).collect();
    let foot = at(&cloud, |x| x.y < 1e-9);
    // The tube is sheared at its end, out of square.
    let pulled = line(&cloud, &at(&cloud, |x| x.y > 3.0 - 1e-9 && x.z > 1.0 - 1e-9));
    let joined = if joined { groups } else { Vec::new() };
    let cloud = Cloud::from_sheets(cloud.positions, None, cloud.cells, joined).unwrap();
    Tied { cloud, edge, host: (0..96).collect(), foot, pulled, pull: X + Z * 0.2 }
}

/// A sheet that ends on the fold of two others, and on the line where three meet.
fn on_a_fold(stem: bool) -> Tied {
    let mut sheets = Sheets::default().add(Vec3::zeros(), [X, Y], [3, 4]).add(X, [Z, Y], [3, 4]);
    let mut cells = 24;
    if stem {
        sheets = sheets.add(X, [X, Y], [3, 4]);
        cells += 12;
    }
    let cloud = sheets.add(X, [-Z + X * 0.5, Y], [3, 5]).cloud();
    let hung = |a: u32| a as usize >= cloud.len() - 24;
    let edge =
        at(&cloud, |x| (x.x - 1.0).abs() + x.z.abs() < 1e-9).into_iter().filter(|&a| hung(a)).collect();
    let groups = cloud.joined.iter().map(|group| group.iter().copied().filter(|&a| !hung(a)).collect());
    let joined: Vec<Vec<u32>> = groups.filter(|group: &Vec<u32>| group.len() > 1).collect();
    let foot = at(&cloud, |x| x.x < 1e-9);
    let pulled = at(&cloud, |x| x.z < -1.0 + 1e-9).into_iter().map(|a| (a, 1.0)).collect();
    let cloud = Cloud::from_sheets(cloud.positions, None, cloud.cells, joined).unwrap();
    Tied { cloud, edge, host: (0..cells).collect(), foot, pulled, pull: X + Y * 0.4 + Z * 0.2 }
}

impl Tied {
    fn shell(self) -> Shell {
        let Self { cloud, edge, host, foot, pulled, pull } = self;
        let load: Box<dyn Load> = Box::new(Force { shares: pulled, total: pull });
        let loads = vec![AppliedLoad { load, amplitude: Amplitude::Constant }];
        let supports = vec![supported(foot, Clamped)];
        let body = Shell::builder(Parts { supports, loads, ..parts(cloud, CELL, 0.03) });
        body.ties(vec![Tie { edge, host }]).build().unwrap()
    }

    /// The same elsewhere: turned or mirrored, then shifted; its particles and cells in another order.
    fn moved(self, turn: &Matrix3<f64>, shift: &Vec3, dice: &mut RandomNumbers) -> Self {
        let mut order = |count: usize| {
            let mut order: Vec<(f64, u32)> = (0..count as u32).map(|a| (dice.roll(), a)).collect();
            order.sort_by(|a, b| a.0.total_cmp(&b.0));
            order.into_iter().map(|(_, a)| a).collect::<Vec<_>>()
        };
        let inverse = |order: &[u32]| {
            let mut new = vec![0; order.len()];
            (0..).zip(order).for_each(|(i, &a)| new[a as usize] = i);
            new
        };
        let (particles, cells) = (order(self.cloud.len()), order(self.cloud.cells.len()));
        let (new, new_cell): (Vec<u32>, Vec<u32>) = (inverse(&particles), inverse(&cells));
        let renumbered = |list: Vec<u32>| list.into_iter().map(|a| new[a as usize]).collect::<Vec<_>>();
        let positions = particles.iter().map(|&a| turn * self.cloud.positions[a as usize] + shift).collect();
        let cell = |&c: &u32| {
            let corners = self.cloud.cells[c as usize].corners.map(|a| new[a as usize]);
            let [a, b, c, d] = corners;
            // What is mirrored keeps its normal outside.
            Cell::quadrangle(if turn.determinant() < 0.0 { [c, b, a, d] } else { [b, c, d, a] })
        };
        let all = cells.iter().map(cell).collect();
        let joined = self.cloud.joined.iter().map(|group| renumbered(group.clone())).collect();
        Self {
            cloud: Cloud::from_sheets(positions, None, all, joined).unwrap(),
            edge: renumbered(self.edge),
            host: self.host.into_iter().map(|c| new_cell[c as usize]).collect(),
            foot: renumbered(self.foot),
            pulled: self.pulled.into_iter().map(|(a, share)| (new[a as usize], share)).collect(),
            pull: turn * self.pull,
        }
    }
}

const NAMES: [&str; 5] =
    ["rib on a line", "wall in a tube", "wall in an open tube", "on a fold", "on a junction"];

fn tied(which: usize) -> Tied {
    match which {
        0 => rib_on_a_line(),
        1 | 2 => wall_in_a_tube(which == 1),
        _ => on_a_fold(which == 4),
    }
}

#[test]
fn neither_motions_nor_mirrors_nor_numbers_change_what_is_tied_along_lines() {
    let mut dice = RandomNumbers(5);
    for (which, name) in NAMES.iter().enumerate() {
        let exact = linear_energy(tied(which).shell());
        let mut worst = 0.0_f64;
        for i in 0..20 {
            let turn = Rotation3::new(dice.vector() * 3.0).into_inner();
            let mirror = if i % 2 == 0 {
                Matrix3::identity()
            } else {
                Matrix3::from_diagonal(&Vec3::new(1.0, 1.0, -1.0))
            };
            let moved = tied(which).moved(&(turn * mirror), &(dice.vector() * 5.0), &mut dice);
            worst = worst.max((linear_energy(moved.shell()) / exact - 1.0).abs());
        }
        println!("{name}: {exact:.6e}, changed by {worst:.1e}");
        // Rounding of places, 1e-15, over the thickness against the length, squared.
        assert!(worst < 1e-9, "{name}: {worst:.1e}");
    }
}

#[test]
fn forces_of_what_hangs_on_several_cells_derive_from_the_energy() {
    for (which, name) in NAMES.iter().enumerate() {
        let mut system = StaticShell::new(tied(which).shell());
        let mut dice = RandomNumbers(3);
        for _ in 0..3 {
            let increment: Vec<f64> = (0..system.unknowns()).map(|_| 0.02 * dice.roll()).collect();
            system.update(&increment);
        }
        derivatives_agree(&mut system, 0.0, name);
    }
}

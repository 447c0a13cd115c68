//! What has to hold between two contacts: turned, mirrored, in other units, refined.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use contact::{Law, Pose, Surface, ToolContact, ToolShape, Touch, Watch, stiffness};
use nalgebra::Rotation3;
use sph_core::{Cell, Vec3};

/// A lattice of cells over a square of side one at a height, bent a little.
fn lattice(cells: u32, height: f64) -> (Vec<Cell>, Vec<Vec3>) {
    let side = cells + 1;
    let place = |a: u32| {
        let [x, y] = [a % side, a / side].map(|i| f64::from(i) / f64::from(cells));
        Vec3::new(x, y, height + 0.01 * x * x - 0.005 * x * y)
    };
    let cell = |c: u32| {
        let a = c % cells + side * (c / cells);
        Cell { corners: [a, a + 1, a + 1 + side, a + side], count: 4 }
    };
    ((0..cells * cells).map(cell).collect(), (0..side * side).map(place).collect())
}

/// What a sheet .1 thick, whose every place and tool is mapped, and a tool do to each other, with the forces on particles.
fn touched(map: impl Fn(Vec3) -> Vec3, length: f64, force: f64, tool: ToolShape) -> (Touch, Vec<Vec3>) {
    let (cells, rest) = lattice(6, 0.0);
    let places: Vec<Vec3> = rest.into_iter().map(map).collect();
    let contact = ToolContact {
        tool: tool.checked().unwrap(),
        surface: Surface::new(&cells, &places, |_| 0.05 * length),
        law: Law::new(0.05).unwrap(),
        stiffness: stiffness(1e6 * force / (length * length), 0.1 * length, length / 6.0),
    };
    let mut rows = vec![Vec3::zeros(); places.len()];
    let touch = contact.forces(
        &mut Watch::new(&contact.surface),
        None,
        &Pose::default(),
        |a| places[a as usize],
        |a, f| rows[a as usize] += f,
    );
    (touch, rows)
}

fn drum(map: impl Fn(Vec3) -> Vec3, length: f64) -> ToolShape {
    let point = Vec3::new(0.4, 0.0, -2.03);
    let axis = map(point + Vec3::new(0.1, 1.0, 0.0)) - map(point);
    ToolShape::Cylinder { point: map(point), axis, radius: 2.0 * length }
}

/// Rounding alone tells them apart.
#[test]
fn turned_mirrored_and_in_other_units_the_answer_is_the_same() {
    let (plain, own) = touched(|x| x, 1.0, 1.0, drum(|x| x, 1.0));
    assert!(plain.area > 0.1 && plain.greatest_depth > 0.1, "{plain:?}");
    let turn = Rotation3::from_euler_angles(0.3, -1.1, 2.0);
    let turned = |x: Vec3| turn * x + Vec3::new(3.0, -2.0, 1.0);
    let mirrored = |x: Vec3| Vec3::new(-x.x, x.y, x.z);
    // Millimetres and kilonewtons.
    let scaled = |x: Vec3| x * 1e3;
    let (of_turned, forces) = touched(turned, 1.0, 1.0, drum(turned, 1.0));
    let close = |a: f64, b: f64| (a - b).abs() < 1e-9 * b.abs();
    assert!(close(of_turned.energy, plain.energy) && close(of_turned.greatest_depth, plain.greatest_depth));
    for (found, own) in forces.iter().zip(&own) {
        assert!((found - turn * own).norm() < 1e-9 * plain.force.norm());
    }
    let (of_mirrored, _) = touched(mirrored, 1.0, 1.0, drum(mirrored, 1.0));
    assert!(close(of_mirrored.energy, plain.energy) && close(of_mirrored.force.z, plain.force.z));
    assert!(close(of_mirrored.force.x, -plain.force.x));
    let (of_scaled, _) = touched(scaled, 1e3, 1e-3, drum(scaled, 1e3));
    assert!(close(of_scaled.energy, plain.energy) && close(of_scaled.force.z, 1e-3 * plain.force.z));
    assert!(close(of_scaled.area, 1e6 * plain.area));
}

/// A flat sheet on a plane bears κ u on its area whatever its cells.
#[test]
fn a_flat_sheet_is_borne_evenly_by_any_lattice() {
    for cells in [1, 3, 8] {
        let (list, mut rest) = lattice(cells, 0.0);
        rest.iter_mut().for_each(|x| x.z = 0.0);
        let contact = ToolContact {
            tool: ToolShape::Plane { point: Vec3::new(0.0, 0.0, -0.04), normal: Vec3::z() }
                .checked()
                .unwrap(),
            surface: Surface::new(&list, &rest, |_| 0.05),
            law: Law::new(0.0).unwrap(),
            stiffness: 7.0,
        };
        let touch = contact.forces(
            &mut Watch::new(&contact.surface),
            None,
            &Pose::default(),
            |a| rest[a as usize],
            |_, _| (),
        );
        assert!((touch.force - Vec3::z() * 0.07).norm() < 1e-15, "{touch:?}");
        assert!((touch.area - 1.0).abs() < 1e-14 && (touch.energy - 0.5 * 7.0 * 1e-4).abs() < 1e-16);
    }
}

//! Closed surfaces filled with nodes: volume, centroid and area are those of the surface, wherever it lies in the lattice.
#![allow(clippy::unwrap_used)] // set-up that fails is a test that fails

mod cells;
mod solids;

use approx::assert_relative_eq;
use solids::{Triangles, ball, cuboid, hollow, tetrahedron};
use sph_core::*;

/// Sums over thousands of pieces, each rounded to 10⁻¹⁶ of a cell: 3 times the greatest error found.
const ROUNDING: f64 = 3e-14;

fn filled(shape: &Triangles, spacing: f64) -> Filled {
    shape.closed().unwrap().filled(spacing).unwrap()
}

/// A sum of many numbers, by parts: one after the other ten thousand equal ones lose 10⁻¹³.
fn sum(numbers: impl Iterator<Item = f64>) -> f64 {
    let numbers: Vec<f64> = numbers.collect();
    numbers.chunks(64).map(|part| part.iter().sum::<f64>()).sum()
}

fn volume(filled: &Filled) -> f64 {
    sum(filled.block.volumes.iter().copied())
}

fn centroid(filled: &Filled) -> Vec3 {
    let moment =
        |k: usize| sum(filled.block.positions.iter().zip(&filled.block.volumes).map(|(x, v)| x[k] * v));
    Vec3::from_fn(|k, _| moment(k)) / volume(filled)
}

fn area(filled: &Filled) -> f64 {
    sum(filled.facets.iter().map(|facet| facet.area.norm()))
}

/// Shapes of all kinds, somewhere in space, turned and not.
fn all() -> Vec<Triangles> {
    let turned = |shape: Triangles| shape.turned(Vec3::new(0.3, -0.5, 0.9)).moved(Vec3::new(7.1, -0.3, 2.2));
    let mut all = vec![
        cuboid(Vec3::zeros(), Vec3::new(2.0, 1.0, 0.7)),
        ball(1.0, 4),
        hollow(1.0, 0.45, 3),
        tetrahedron(2.0),
    ];
    all.extend(all.clone().into_iter().map(turned));
    all
}

#[test]
fn volume_centroid_and_area_are_those_of_the_surface() {
    for shape in all() {
        let closed = shape.closed().unwrap();
        let (whole, middle) = closed.volume();
        for spacing in [0.3, 0.1, 0.0637] {
            let filled = closed.filled(spacing).unwrap();
            assert_relative_eq!(volume(&filled), whole, max_relative = ROUNDING);
            assert_relative_eq!(centroid(&filled), middle, epsilon = 10.0 * ROUNDING);
            assert_relative_eq!(area(&filled), shape.area(), max_relative = ROUNDING);
            // A closed surface has no resultant under an even pressure.
            let resultant: Vec3 = filled.facets.iter().map(|facet| facet.area).sum();
            assert!(resultant.norm() < ROUNDING * shape.area(), "{resultant:?}");
            let least = filled.block.volumes.iter().fold(f64::INFINITY, |least, &v| least.min(v));
            assert!(least >= 0.5 * spacing.powi(3));
        }
    }
}

#[test]
fn a_box_in_planes_of_the_lattice_is_the_block() {
    // Planes at tenths, which binary numbers do not meet: every face is a rounding off its plane.
    let (low, lengths) = (Vec3::new(0.3, -0.7, 1.1), [1.2, 0.6, 0.9]);
    let shape = cuboid(low, low + Vec3::from(lengths));
    let filled = filled(&shape.divided().divided(), 0.1);
    let lattice = BlockLattice { lengths, origin: low, ..filled.bounds.clone() };
    let block = lattice.block().unwrap();
    assert_eq!(filled.block.len(), block.len());
    let cell = 1e-3;
    for node in 0..block.len() {
        let apart = filled.block.positions[node] - block.positions[node];
        assert!(apart.norm() < 1e-14, "{apart:?}");
        assert!((filled.block.volumes[node] - block.volumes[node]).abs() < 1e-13 * cell);
    }
    for (own, other) in filled.block.faces.iter().zip(&block.faces) {
        assert_eq!(own.len(), other.len());
        for ((a, own), (b, other)) in own.iter().zip(other) {
            assert!(a == b && (own - other).abs() < 1e-13 * 0.01, "{own} {other}");
        }
    }
}

#[test]
fn planes_through_the_middle_of_cells_give_halves() {
    // 2.5 cells each way: the lattice has three, whose outer ones are three quarters, at edges 9/16, at corners 27/64 of a cell.
    let quarters = filled(&cuboid(Vec3::zeros(), Vec3::repeat(2.5)), 1.0);
    assert_eq!(quarters.block.len(), 27 - 8);
    // Corners are less than half: each goes to the three edges beside it.
    let edge = 9.0 / 16.0 + 2.0 * 27.0 / 64.0 / 3.0;
    let edges = quarters.block.volumes.iter().filter(|v| (*v - edge).abs() < 1e-14).count();
    assert_eq!(edges, 12);
    // Two cells along x and y, one and a half along z, whose lattice has two: the outer faces run through three quarters of them.
    let slab = filled(&cuboid(Vec3::zeros(), Vec3::new(2.0, 2.0, 1.5)), 1.0);
    assert!(slab.block.volumes.iter().all(|v| *v == 0.75));
    assert!(slab.block.positions.iter().all(|x| x.z == 0.375 || x.z == 1.125), "{:?}", slab.block.positions);
    // Three bodies, the outer ones flush with the box, the one in the middle half in either cell beside it.
    let mut row = cuboid(Vec3::zeros(), Vec3::repeat(1.0));
    row.add(cuboid(Vec3::new(1.5, 0.0, 0.0), Vec3::new(2.5, 1.0, 1.0)));
    row.add(cuboid(Vec3::new(3.0, 0.0, 0.0), Vec3::new(4.0, 1.0, 1.0)));
    let row = filled(&row, 1.0);
    for (node, (volume, x)) in [(1.0, 0.5), (0.5, 1.75), (0.5, 2.25), (1.0, 3.5)].into_iter().enumerate() {
        assert_relative_eq!(row.block.volumes[node], volume, max_relative = 1e-14);
        assert_relative_eq!(row.block.positions[node].x, x, max_relative = 1e-14);
    }
}

#[test]
fn cavities_are_empty_and_touching_faces_count_once() {
    let mut shell = cuboid(Vec3::zeros(), Vec3::repeat(3.0));
    shell.add(cuboid(Vec3::repeat(1.0), Vec3::repeat(2.0)).inside_out());
    let shell = filled(&shell, 1.0);
    assert_eq!(shell.block.volumes, [1.0; 26]);
    // The six nodes round the cavity bear one face of it each.
    let inner = by_node(shell.facets.iter().filter(|facet| facet.triangle >= 12));
    assert!(inner.len() == 6 && inner.iter().all(|(_, area, _)| *area == 1.0));
    // Two cubes whose faces lie on each other.
    let mut two = cuboid(Vec3::zeros(), Vec3::repeat(1.0));
    two.add(cuboid(Vec3::x(), Vec3::new(2.0, 1.0, 1.0)));
    let two = filled(&two, 0.5);
    assert_eq!(two.block.volumes, [0.125; 16]);
    assert_eq!(area(&two), 12.0);
}

/// A small box stands on a large one, its corners within a face of that, as they lie and turned, whichever is first; two bars in a line that
/// share a piece of their length do not cross and hold it twice.
#[test]
fn pieces_may_touch_and_not_lie_in_each_other() {
    let base = || cuboid(Vec3::new(0.3, -0.7, 1.1), Vec3::new(1.5, -0.1, 1.7));
    let block = || cuboid(Vec3::new(0.6, -0.5, 1.7), Vec3::new(1.1, -0.3, 2.3));
    let joined = |mut one: Triangles, other: Triangles| {
        one.add(other);
        one
    };
    for turn in [Vec3::zeros(), Vec3::new(0.3, -0.5, 0.9), Vec3::new(-1.1, 0.2, 0.4)] {
        for shape in [joined(base(), block()), joined(block(), base())] {
            let closed = shape.turned(turn).closed().unwrap();
            assert_relative_eq!(closed.volume().0, 0.432 + 0.06, max_relative = 1e-12);
        }
    }
    let bar = |from: f64| cuboid(Vec3::new(from, 0.0, 0.0), Vec3::new(from + 1.5, 0.3, 0.3));
    for turn in [Vec3::zeros(), Vec3::new(0.0, 0.0, 0.7)] {
        let fault = joined(bar(0.0), bar(1.1)).turned(turn).closed().unwrap_err();
        assert!(matches!(fault, SurfaceFault::Within { .. } | SurfaceFault::Crossing { .. }), "{fault}");
    }
}

#[test]
fn a_turned_mirrored_renumbered_and_divided_surface_gives_the_same() {
    let shape = hollow(1.0, 0.5, 4);
    let own = filled(&shape, 0.17);
    let same = |other: &Filled, places: &dyn Fn(&Vec3) -> Vec3, factor: f64| {
        assert_eq!(own.block.len(), other.block.len());
        for (x, v) in own.block.positions.iter().zip(&own.block.volumes) {
            let image = places(x);
            let apart = |y: &Vec3| (y - image).norm();
            let nearest = (0..other.block.len()).map(|b| (apart(&other.block.positions[b]), b));
            let (distance, b) = nearest.min_by(|one, two| one.0.total_cmp(&two.0)).unwrap();
            assert!(distance < 1e-12 * factor, "{distance:e}");
            assert_relative_eq!(other.block.volumes[b], v * factor.powi(3), max_relative = 1e-12);
        }
        assert_relative_eq!(area(other), area(&own) * factor * factor, max_relative = ROUNDING);
    };
    let mirrored = shape.clone().mapped(|x| Vec3::new(-x.x, x.y, x.z)).inside_out();
    same(&filled(&mirrored, 0.17), &|x| Vec3::new(-x.x, x.y, x.z), 1.0);
    let turned = shape.clone().mapped(|x| Vec3::new(x.y, x.z, x.x));
    same(&filled(&turned, 0.17), &|x| Vec3::new(x.y, x.z, x.x), 1.0);
    let longer = shape.clone().mapped(|x| x * 1000.0);
    same(&filled(&longer, 170.0), &|x| x * 1000.0, 1000.0);
    let far = Vec3::new(2.0, -3.0, 1.0);
    same(&filled(&shape.clone().moved(far), 0.17), &|x| x + far, 1.0);
    same(&filled(&shape.clone().renumbered(), 0.17), &|x| *x, 1.0);
    same(&filled(&shape.divided(), 0.17), &|x| *x, 1.0);
}

#[test]
fn half_a_body_has_the_nodes_of_the_half() {
    let whole = filled(&cuboid(Vec3::zeros(), Vec3::new(2.0, 1.3, 0.9)), 0.1);
    let half = filled(&cuboid(Vec3::zeros(), Vec3::new(1.0, 1.3, 0.9)), 0.1);
    assert_eq!(2 * half.block.len(), whole.block.len());
    // The first axis runs slowest: the half is the first half of the list.
    for node in 0..half.block.len() {
        assert!((half.block.positions[node] - whole.block.positions[node]).norm() < 1e-14);
        assert_relative_eq!(half.block.volumes[node], whole.block.volumes[node], max_relative = 1e-12);
    }
}

#[test]
fn forces_on_the_surface_keep_their_resultant_moment_and_work() {
    let shape = hollow(1.0, 0.5, 3).turned(Vec3::new(0.3, 0.2, -0.4)).moved(Vec3::new(3.0, 1.0, 2.0));
    let filled = filled(&shape, 0.13);
    let on = |facet: &Facet| facet.area.cross(&Vec3::new(0.3, 1.0, -0.2)) - facet.area * facet.place.x;
    let forces: Vec<(Facet, Vec3)> = filled.facets.iter().map(|facet| (*facet, on(facet))).collect();
    let spread = spread(&filled.block, &[], &forces).forces;
    // Of any linear field: work of the rows of the gradient, among them those of displacements and turns.
    for row in 0..3 {
        for column in 0..4 {
            let field = |x: &Vec3| if column < 3 { x[column] } else { 1.0 };
            let wanted = sum(forces.iter().map(|(facet, force)| force[row] * field(&facet.place)));
            let borne =
                sum(spread.iter().map(|(node, f)| f[row] * field(&filled.block.positions[*node as usize])));
            // Measured 4e-14 of the sum of the amounts.
            let size = sum(forces.iter().map(|(facet, force)| (force[row] * field(&facet.place)).abs()));
            assert!((borne - wanted).abs() < 1.5e-13 * size, "{row} {column}: {borne} {wanted}");
        }
    }
}

#[test]
fn forces_on_a_divided_surface_are_the_same() {
    let shape = hollow(1.0, 0.5, 2);
    let [own, other] = [shape.clone(), shape.divided().divided()].map(|shape| {
        let filled = filled(&shape, 0.21);
        let forces: Vec<(Facet, Vec3)> = filled.facets.iter().map(|facet| (*facet, facet.area)).collect();
        spread(&filled.block, &[], &forces).forces
    });
    assert_eq!(own.len(), other.len());
    for ((a, one), (b, two)) in own.iter().zip(&other) {
        assert!(a == b && (one - two).norm() < 1e-13, "{one:?} {two:?}");
    }
}

#[test]
fn half_a_body_bears_half_of_what_the_whole_does() {
    let (low, high) = (Vec3::new(-1.0, 0.0, 0.0), Vec3::new(1.0, 0.73, 0.61));
    let spacing = 0.1;
    let [whole, half] = [low, Vec3::zeros()].map(|low| filled(&cuboid(low, high), spacing));
    let force = |facet: &Facet| {
        Vec3::new(facet.area.norm() * facet.place.x.signum(), facet.area.norm(), facet.area.z)
    };
    let borne = |filled: &Filled, mirrors: &[(usize, f64)]| {
        // All but the cut, which the whole does not have.
        let outer = filled.facets.iter().filter(|facet| facet.place.x.abs() > 1e-9);
        let forces: Vec<(Facet, Vec3)> = outer.map(|facet| (*facet, force(facet))).collect();
        spread(&filled.block, mirrors, &forces)
    };
    let (whole_borne, on_half) = (borne(&whole, &[]).forces, borne(&half, &[(0, 0.0)]));
    let half_borne = on_half.forces;
    let first = (whole.block.len() - half.block.len()) as u32;
    for (node, own) in &half_borne {
        let other = whole_borne.iter().find(|(other, _)| *other == node + first).map(|(_, force)| *force);
        assert!((own - other.unwrap_or_default()).norm() < 1e-13, "{own:?} {other:?}");
    }
    // What the nodes of the other half bear goes through the plane.
    let along = |borne: &[(u32, Vec3)]| sum(borne.iter().map(|(_, force)| force.x));
    let whole_area = 2.0 * (0.73 * 0.61 / 2.0 + 0.73 + 0.61);
    let all = along(&half_borne) + on_half.through[0];
    assert!(
        (all - whole_area).abs() < 1e-12 && on_half.through[0].abs() > 1e-3,
        "{all} {:?}",
        on_half.through
    );
    // Without the images it would not be so.
    let alone = borne(&half, &[]).forces;
    assert!(alone.iter().zip(&half_borne).any(|(one, other)| (one.1 - other.1).norm() > 1e-6));
}

#[test]
fn surfaces_that_enclose_no_body_are_refused() {
    let cube = || cuboid(Vec3::zeros(), Vec3::repeat(1.0));
    let fault = |shape: Triangles| shape.closed().unwrap_err();
    let mut open = cube();
    open.triangles.pop();
    assert!(matches!(fault(open), SurfaceFault::Open { .. }));
    let mut turned = cube();
    turned.triangles[3].swap(0, 1);
    assert!(matches!(fault(turned), SurfaceFault::Shared { .. }));
    assert!(matches!(fault(cube().inside_out()), SurfaceFault::InsideOut { .. }));
    let mut solid_in_solid = cube();
    solid_in_solid.add(cuboid(Vec3::repeat(0.3), Vec3::repeat(0.6)));
    assert!(matches!(fault(solid_in_solid), SurfaceFault::Within { .. }));
    let mut crossing = cube();
    crossing.add(cuboid(Vec3::new(0.5, 0.3, 0.2), Vec3::new(1.7, 0.6, 0.8)));
    assert!(matches!(fault(crossing), SurfaceFault::Crossing { .. }));
    let mut twice = cube();
    twice.add(cube());
    let twice = twice.closed().and_then(|closed| closed.filled(0.25)).unwrap_err();
    assert!(matches!(twice, SurfaceFault::Overlap { .. } | SurfaceFault::Within { .. }), "{twice}");
    let thin = cuboid(Vec3::zeros(), Vec3::new(1.0, 1.0, 0.2)).closed().unwrap();
    assert!(matches!(thin.filled(0.5).unwrap_err(), SurfaceFault::Thin { .. }));
    for spacing in [0.0, -1.0, f64::NAN, 1e-9] {
        assert!(matches!(thin.filled(spacing).unwrap_err(), SurfaceFault::Cells { .. }), "{spacing}");
    }
}

/// A fin thinner than half a spacing is borne by nodes of the body that it stands on: what lies beyond the cells beside them is counted.
#[test]
fn fins_that_are_too_thin_for_nodes_are_counted() {
    let body = || cuboid(Vec3::zeros(), Vec3::repeat(4.0));
    assert_eq!(filled(&body(), 1.0).away, None);
    let mut finned = body();
    // Three tenths of a cell thick, one and two cells long: the second cell is away.
    finned.add(cuboid(Vec3::new(4.0, 1.0, 1.35), Vec3::new(5.0, 3.0, 1.65)));
    assert_eq!(filled(&finned, 1.0).away, None);
    let mut finned = body();
    finned.add(cuboid(Vec3::new(4.0, 1.0, 1.35), Vec3::new(6.0, 3.0, 1.65)));
    let (part, place) = filled(&finned, 1.0).away.unwrap();
    assert_relative_eq!(part, 0.6 / (64.0 + 1.2), max_relative = 1e-12);
    assert_eq!(place, Vec3::new(5.5, 1.5, 1.5));
}

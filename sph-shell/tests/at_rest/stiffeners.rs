//! Bars along lines of a shell: derivatives, zero modes, strips with an eccentric bar as beams, rings, frequencies, what is refused.

use std::f64::consts::TAU;

use crate::common::{
    self, DENSITY, YOUNG, at, beam_parts, curved, derivatives_agree, disordered_curved, flat, parts,
    scattered_curved, shake, spectrum, supported,
};
use implicit_statics::{Equilibrium, linear_response, natural_modes, unwatched};
use nalgebra::Matrix3;
use shell_kinematics::BarSection;
use sph_core::{Cloud, Cylinder, EndWeights, Side, Vec3, lattice};
use sph_shell::{
    Clamped, Formulation, Gravity, InSurface, Load, Pressure, Reach, RigidLoad, RigidSet, Shell, ShellError,
    StaticShell, Stiffener, StiffenerError, Supported, SymmetryPlane,
};

const CELLS: Formulation = Formulation::StressPoint(Reach::Cell);

/// A rectangle of the material of the tests, without Poisson's ratio.
fn bar(particles: Vec<u32>, [width, height]: [f64; 2], eccentricity: f64) -> Stiffener {
    let section = BarSection::rectangle([YOUNG, 0.5 * YOUNG], width, height);
    let mass = DENSITY * width * height;
    Stiffener { particles, section, height: eccentricity, mass, in_surface: None }
}

/// Bending in the surface of a rectangle.
fn in_surface([width, height]: [f64; 2]) -> Option<InSurface> {
    Some(InSurface { bending: YOUNG * height * width.powi(3) / 12.0, held: Vec::new() })
}

/// Two bars that cross, one above and one below, the second against bending in the surface too.
fn crossed(cloud: Cloud) -> Shell {
    crossed_by(cloud, in_surface([0.2, 0.15]))
}

/// The same, the second bar with what it is against bending in the surface.
fn crossed_by(cloud: Cloud, lateral: Option<InSurface>) -> Shell {
    let lattice = cloud.lattice.unwrap();
    let mut bars = vec![bar(lattice.column(3), [0.1, 0.3], 0.25), bar(lattice.row(2), [0.2, 0.15], -0.2)];
    bars[1].in_surface = lateral;
    Shell::builder(parts(cloud, CELLS, 0.2)).stiffeners(bars).build().unwrap()
}

/// A bar along an edge of particles that no lattice orders.
fn along_an_edge(cloud: Cloud) -> Shell {
    let edge = cloud.sides.as_ref().unwrap().edge(Side::U1).to_vec();
    let mut own = bar(edge, [0.1, 0.3], 0.3);
    own.in_surface = in_surface([0.1, 0.3]);
    Shell::builder(parts(cloud, CELLS, 0.2)).stiffeners(vec![own]).build().unwrap()
}

#[test]
fn forces_and_tangent_are_derivatives_of_the_energy() {
    let bodies = [
        crossed(curved([7, 6])),
        crossed_by(disordered_curved([7, 6]), None),
        along_an_edge(scattered_curved(0.45)),
    ];
    for mut body in bodies {
        shake(&mut body, 0.05, 17);
        derivatives_agree(&mut StaticShell::new(body), 0.0, "stiffened");
    }
}

/// Round-off leaves 1e-11 of the seventh eigenvalue.
#[test]
fn stiffened_free_shells_have_exactly_six_zero_modes() {
    for body in
        [crossed(flat([7, 7], [2.0, 2.0])), crossed(curved([7, 6])), along_an_edge(scattered_curved(0.45))]
    {
        let mut values = spectrum(body);
        values.sort_by(f64::total_cmp);
        println!("{:.1e} {:.1e} {:.1e}", values[0], values[5], values[6]);
        assert!(values[0] > -1e-9 * values[6] && values[5] < 1e-8 * values[6], "{:?}", &values[..8]);
    }
}

/// Turned as a whole by more than a radian the shell has no energy and no force but rounding.
#[test]
fn a_rigid_motion_stores_nothing() {
    let mut body = crossed(curved([7, 6]));
    let turn = nalgebra::Rotation3::new(Vec3::new(0.7, -1.9, 0.4));
    for a in 0..body.len() {
        let (x, d) = (body.position(a), body.director(a));
        body.set_state(a, turn * x + Vec3::new(3.0, 1.0, 2.0), turn * d);
    }
    assert!(common::energy(&mut body) < 1e-24 * YOUNG);
    let most = (0..body.len()).flat_map(|a| body.internal_force(a)).fold(0.0, |m: f64, f| m.max(f.abs()));
    assert!(most < 1e-11, "{most:e}");
}

const LENGTH: f64 = 10.0;
const THICK: f64 = 0.2;
const SIZE: [f64; 2] = [0.1, 0.5];
const HEIGHT: f64 = 0.35;

/// A strip 10 × 1 clamped at its left end, planes of symmetry along its sides, a bar along its middle line; its right end is one rigid body, so
/// that sections stay plane where a load is put in.
fn strip(height: f64, loads: Vec<Box<dyn Load>>) -> StaticShell {
    let cloud = flat([41, 3], [LENGTH, 1.0]);
    let sides = cloud.sides.clone().unwrap();
    let edge = |side: Side| sides.edge(side).to_vec();
    let inner = |side: Side| edge(side).into_iter().filter(|a| !edge(Side::U1).contains(a)).collect();
    let symmetry = || SymmetryPlane { normal: Vec3::y() };
    let supports: Vec<Supported> = vec![
        supported(edge(Side::U0), Clamped),
        supported(inner(Side::V0), symmetry()),
        supported(inner(Side::V1), symmetry()),
    ];
    let end = RigidSet {
        particles: edge(Side::U1),
        at: Vec3::new(LENGTH, 0.5, 0.0),
        mass: 0.0,
        inertia: Matrix3::zeros(),
        holds: Vec::new(),
    };
    let middle = at(&cloud, |x| (x.y - 0.5).abs() < 1e-9);
    let body = Shell::builder(beam_parts(cloud, THICK, supports, loads)).rigid(vec![end]);
    let mut blade = bar(middle, SIZE, height);
    blade.section.shear *= 100.0;
    StaticShell::new(body.stiffeners(vec![blade]).build().unwrap())
}

/// A force and a couple on its right end.
fn on_end(force: Vec3, couple: Vec3) -> Vec<Box<dyn Load>> {
    vec![Box::new(RigidLoad { set: 0, force, couple })]
}

/// Sums over the cross-section: area, its first moment about the particles, its second, of the strip one wide with the bar.
fn section(height: f64) -> [f64; 3] {
    let area = SIZE[0] * SIZE[1];
    let own = THICK.powi(3) / 12.0 + area * SIZE[1].powi(2) / 12.0;
    [THICK + area, area * height, own + area * height * height]
}

/// Mean displacement of the right end by the linear answer.
fn end(mut system: StaticShell) -> Vec3 {
    let response = linear_response(&mut system, 0.0).unwrap();
    system.update(&response.iter().map(|u| 1e-6 * u).collect::<Vec<_>>());
    let shell = system.shell();
    let cloud = &shell.reference().cloud;
    let all = at(cloud, |x| x.x > LENGTH - 1e-9);
    all.iter().map(|&a| shell.displacement(a as usize) * 1e6).sum::<Vec3>() / all.len() as f64
}

/// Pulled along its particles, and bent by a couple, the strip is a beam with a neutral axis: `u = N(1/EA + z²/EI)L`, `w = N z L²/2EI`, and
/// `w = M L²/2EI`: constant strains, which cells and bars have exactly.
#[test]
fn a_strip_with_an_eccentric_bar_is_a_beam_with_a_neutral_axis() {
    for height in [HEIGHT, -HEIGHT] {
        let [area, first, second] = section(height);
        let neutral = first / area;
        let bending = YOUNG * (second - first * first / area);
        let pulled = end(strip(height, on_end(Vec3::x(), Vec3::zeros())));
        let exact = LENGTH * (1.0 / (YOUNG * area) + neutral * neutral / bending);
        let deflection = neutral * LENGTH * LENGTH / (2.0 * bending);
        let bent = end(strip(height, on_end(Vec3::zeros(), Vec3::y())));
        let by_couple = -LENGTH * LENGTH / (2.0 * bending);
        let errors = [pulled.x / exact, pulled.z / deflection, bent.z / by_couple].map(|ratio| ratio - 1.0);
        println!("{height}: {errors:?}");
        assert!(errors.iter().all(|error| error.abs() < 1e-5), "{errors:?}");
    }
}

/// The end force of a cantilever, `PL³/3EI`, of which one point a cell misses 1/4n². The bar is stiff against shear: what sheet and bar each bear of that is no
/// matter of beams. In the plane the sheet hands over `dN/dx` by shear, in the mean over its width `q²c/3Gt` by length on each side, .07 %.
#[test]
fn a_cantilever_with_a_bar_bends_as_a_beam() {
    let [area, first, second] = section(HEIGHT);
    let bending = YOUNG * (second - first * first / area);
    let found = end(strip(HEIGHT, on_end(Vec3::z(), Vec3::zeros()))).z;
    let exact = LENGTH.powi(3) / (3.0 * bending);
    println!("{:.3e}", found / exact - 1.0);
    assert!((found / exact - 1.0).abs() < 2e-3, "{found} {exact}");
}

/// Without height masses are exact but for their lumping: the first frequency of a cantilever, `3.516² √(EI/μL⁴)`. With it, what is left out of
/// the inertia of the height.
#[test]
fn a_strip_with_a_bar_vibrates_as_a_beam() {
    for (height, bound) in [(0.0, 3e-3), (HEIGHT, 1e-2)] {
        let mut system = strip(height, Vec::new());
        let modes = natural_modes(&mut system, 0.0, 1, 0.0, &mut unwatched).unwrap();
        let [area, first, second] = section(height);
        let bending = YOUNG * (second - first * first / area);
        let exact = 3.516_015 * (bending / (DENSITY * area * LENGTH.powi(4))).sqrt();
        let found = modes.modes[0].eigenvalue.sqrt();
        println!("{height}: {:.3e}", found / exact - 1.0);
        assert!((found / exact - 1.0).abs() < bound, "{found} {exact}");
    }
}

/// A tube with a ring on each row, under pressure from within: `p R b = (E t b/R + Σ EA/(R + e)) u` with R and b those of its polygon.
#[test]
fn rings_widen_with_their_tube() {
    let (radius, length, eccentricity) = (1.0, 0.4, 0.08);
    let counts = [33, 5];
    let angles = [0.0, 0.25 * TAU];
    let cloud = lattice(&Cylinder { radius, angles, length }, counts, EndWeights::Trapezoid).unwrap();
    let rows = cloud.lattice.unwrap();
    let sides = cloud.sides.clone().unwrap();
    let edge = |side: Side| sides.edge(side).to_vec();
    let normal = |side: Side| {
        let a = edge(side)[1] as usize;
        let frame = &cloud.frames[a];
        cloud.edge_normals[a].normalize() - frame.n * frame.n.dot(&cloud.edge_normals[a].normalize())
    };
    let supports = [Side::U0, Side::U1, Side::V0, Side::V1]
        .map(|side| supported(edge(side), SymmetryPlane { normal: normal(side) }));
    let outwards = cloud.frames[0].n.dot(&cloud.positions[0]).signum();
    let rings = (0..5).map(|j| {
        let share = if j == 0 || j == 4 { 0.5 } else { 1.0 };
        let whole = bar(rows.row(j), [0.02, 0.1], eccentricity * outwards);
        Stiffener { section: whole.section.part(share), mass: whole.mass * share, ..whole }
    });
    let load: Box<dyn Load> = Box::new(Pressure { value: outwards, follower: false });
    let parts = beam_parts(cloud.clone(), 0.05, supports.into(), vec![load]);
    let body = Shell::builder(parts).stiffeners(rings.collect()).build().unwrap();
    let mut system = StaticShell::new(body);
    let response = linear_response(&mut system, 0.0).unwrap();
    system.update(&response.iter().map(|u| 1e-6 * u).collect::<Vec<_>>());
    let middle = rows.row(2)[16] as usize;
    let found = system.shell().displacement(middle).dot(&cloud.frames[middle].n) * outwards * 1e6;
    let stiffness = YOUNG * 0.05 * length / radius + 4.0 * YOUNG * 0.002 / (radius + eccentricity);
    let exact = length * radius / stiffness;
    println!("{:.3e}", found / exact - 1.0);
    assert!((found / exact - 1.0).abs() < 3e-3, "{found} {exact}");
}

/// What a stiffener weighs is what it has of mass; a shell without any keeps its own.
#[test]
fn stiffeners_weigh() {
    let down = Vec3::new(0.0, 0.0, -2.0);
    let system = strip(HEIGHT, vec![Box::new(Gravity { acceleration: down })]);
    let masses: f64 = system.shell().reference().masses.iter().sum();
    let exact = DENSITY * LENGTH * section(HEIGHT)[0];
    assert!((masses / exact - 1.0).abs() < 1e-13, "{masses} {exact}");
    let weight = system.shell().load_resultants(Vec3::zeros())[0].force;
    assert!((weight - down * exact).norm() < 1e-12 * exact, "{weight}");
}

#[test]
fn what_is_no_line_is_refused() {
    let cloud = || flat([5, 5], [1.0, 1.0]);
    let build = |particles: Vec<u32>, height: f64, cloud: Cloud| {
        let bars = vec![bar(particles, [0.1, 0.1], height)];
        Shell::builder(parts(cloud, CELLS, 0.1)).stiffeners(bars).build().err().unwrap()
    };
    let refused = |error: ShellError| match error {
        ShellError::Stiffener(cause) => {
            println!("{cause}");
            cause
        }
        other => panic!("{other}"),
    };
    assert!(matches!(refused(build(vec![0, 1, 8], 0.0, cloud())), StiffenerError::Alone { particle: 8, .. }));
    let cell = refused(build(vec![0, 1, 5, 6], 0.0, cloud()));
    assert!(matches!(cell, StiffenerError::CoversCell { cell: 0, .. }));
    let twice = common::tee(2, 1.0, 2);
    let joint = at(&twice, |x| x.x.abs() < 1e-9 && x.z.abs() < 1e-9);
    assert!(matches!(refused(build(joint, 0.0, twice)), StiffenerError::Twice { .. }));
    let tube = curved([7, 6]);
    let row = tube.lattice.unwrap().row(2);
    let inwards =
        -2.9 * tube.frames[0].n.dot(&Vec3::new(tube.positions[0].x, 0.0, tube.positions[0].z)).signum();
    let found = [inwards, -inwards].map(|height| {
        let bars = vec![bar(row.clone(), [0.1, 0.1], height)];
        Shell::builder(parts(tube.clone(), CELLS, 0.1)).stiffeners(bars).build().is_err()
    });
    assert!(found.contains(&true), "{found:?}");
    let number = Stiffener { mass: 0.0, ..bar(vec![0, 1, 2], [0.1, 0.1], 0.0) };
    let error = Shell::builder(parts(cloud(), CELLS, 0.1)).stiffeners(vec![number]).build().err().unwrap();
    assert!(matches!(refused(error), StiffenerError::Number { .. }));
    let wide = common::energy_formulations()[1].1;
    let bars = vec![bar(vec![0, 1, 2], [0.1, 0.1], 0.0)];
    let error = Shell::builder(parts(cloud(), wide, 0.1)).stiffeners(bars).build().err().unwrap();
    assert!(matches!(refused(error), StiffenerError::WideStencils));
}

//! Rigid sets held at a point beside their centre of mass: pendulums and slides in modes and in time, against closed forms.

use std::f64::consts::PI;

use crate::common::{DENSITY, RandomNumbers, X, Y, YOUNG, Z, beam_parts, flat, parts, spectrum, supported};
use explicit_dynamics::{Amplitude, Dynamics, Instant, Step, largest_eigenvalue};
use implicit_statics::{natural_modes, unwatched};
use nalgebra::{DMatrix, Matrix3, Matrix6, SymmetricEigen, Vector6};
use sph_core::{Cloud, Side, Vec3};
use sph_shell::{
    AppliedLoad, Clamped, DirectorHold, Formulation, Gravity, Holds, Parts, Reach, RigidSet, Shell, Spring,
    Springs, StaticShell,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);
const THICK: f64 = 0.1;

fn plate() -> Cloud {
    flat([5, 4], [1.0, 0.8])
}

/// All of a plate as one body with a mass and inertia of its own, held so at a point beside both.
fn whole(held: &[Vec3], director: DirectorHold) -> RigidSet {
    RigidSet {
        particles: (0..20).collect(),
        at: Vec3::new(0.9, 0.1, 0.3),
        mass: 0.05,
        inertia: Matrix3::new(0.02, 0.004, 0.0, 0.004, 0.05, -0.003, 0.0, -0.003, 0.03),
        holds: vec![Holds { translations: held.to_vec(), director, ..Holds::default() }],
    }
}

fn body(set: &RigidSet, gravity: Vec3, springs: Springs) -> Shell {
    let load =
        AppliedLoad { load: Box::new(Gravity { acceleration: gravity }), amplitude: Amplitude::Constant };
    let shell = Shell::builder(Parts { loads: vec![load], ..parts(plate(), CELL, THICK) });
    shell.rigid(vec![set.clone()]).springs(springs).build().unwrap()
}

/// Mass, centre and inertia about the centre of a plate `a × b × t` with what the set has of its own, whatever its cells.
fn bulk(set: &RigidSet) -> (f64, Vec3, Matrix3<f64>) {
    let of_arm = |a: Vec3| Matrix3::identity() * a.norm_squared() - a * a.transpose();
    let (a, b) = (1.0_f64, 0.8_f64);
    let (own, middle) = (DENSITY * THICK * a * b, Vec3::new(0.5 * a, 0.5 * b, 0.0));
    let mass = own + set.mass;
    let centre = (middle * own + set.at * set.mass) / mass;
    let [a, b, t] = [a, b, THICK].map(|side| side * side);
    let plate = Matrix3::from_diagonal(&Vec3::new(b + t, a + t, a + b)) * (own / 12.0);
    let moved = of_arm(middle - centre) * own + of_arm(set.at - centre) * set.mass;
    (mass, centre, plate + set.inertia + moved)
}

/// Springs at some particles along some directions: the same in the shell and as a matrix over `[v_c, ω]`.
fn springs(centre: &Vec3) -> (Vec<Spring>, Matrix6<f64>) {
    let mut dice = RandomNumbers(9);
    let mut matrix = Matrix6::zeros();
    let made = [0_u32, 4, 9, 15, 18, 13].map(|a| {
        let (direction, k) = (dice.vector().normalize(), 2.0 + dice.roll());
        let arm = plate().positions[a as usize] - centre;
        let moment = arm.cross(&direction);
        let row = Vector6::from_iterator(direction.iter().chain(moment.iter()).copied());
        matrix += row * row.transpose() * k;
        Spring { stiffness: vec![(a, k)], direction }
    });
    (made.into(), matrix)
}

/// Eigenvalues of the body by itself: mass and stiffness of `[v_c, ω]` on what its supports leave.
fn exact(set: &RigidSet, bulk: (f64, Vec3, Matrix3<f64>), stiffness: &Matrix6<f64>) -> Vec<f64> {
    let (mass, centre, tensor) = bulk;
    let arm = set.at - centre;
    let mut forbidden: Vec<Vector6<f64>> = Vec::new();
    let mut forbid = |e: Vec3, moment: Vec3| {
        forbidden.push(Vector6::from_iterator(e.iter().chain(moment.iter()).copied()));
    };
    set.holds[0].translations.iter().for_each(|n| forbid(*n, arm.cross(n)));
    match set.holds[0].director {
        DirectorHold::Free => {}
        DirectorHold::InPlane(n) => {
            let e = n.cross(&Vec3::new(0.3, 0.5, 0.8)).normalize();
            [e, n.cross(&e)].into_iter().for_each(|e| forbid(Vec3::zeros(), e));
        }
        DirectorHold::Fixed => [X, Y, Z].into_iter().for_each(|e| forbid(Vec3::zeros(), e)),
    }
    let square = forbidden.iter().fold(Matrix6::zeros(), |sum: Matrix6<f64>, v| sum + v * v.transpose());
    let eigen = SymmetricEigen::new(square);
    let free: Vec<usize> = (0..6).filter(|&i| eigen.eigenvalues[i] < 1e-9).collect();
    let basis = DMatrix::from_fn(6, free.len(), |i, j| eigen.eigenvectors[(i, free[j])]);
    let mut inertia = Matrix6::identity() * mass;
    inertia.fixed_view_mut::<3, 3>(3, 3).copy_from(&tensor);
    let reduced =
        |matrix: &Matrix6<f64>| basis.transpose() * DMatrix::from_fn(6, 6, |i, j| matrix[(i, j)]) * &basis;
    let root = SymmetricEigen::new(reduced(&inertia));
    let scale = &root.eigenvectors
        * DMatrix::from_diagonal(&root.eigenvalues.map(|v| 1.0 / v.sqrt()))
        * root.eigenvectors.transpose();
    let mut found: Vec<f64> =
        SymmetricEigen::new(&scale * reduced(stiffness) * &scale).eigenvalues.iter().copied().collect();
    found.sort_by(f64::total_cmp);
    found
}

/// Held along one, two or three directions, its rotations free, about one axis, or held: the frequencies of modes and the greatest
/// one of marches.
#[test]
fn a_body_on_springs_swings_about_what_holds_it() {
    let oblique = Vec3::new(0.6, 0.0, 0.8);
    let about = DirectorHold::InPlane(Vec3::new(0.0, 0.8, 0.6));
    for (held, director) in [
        (vec![Z], DirectorHold::Free),
        (vec![oblique, Y], DirectorHold::Free),
        (vec![X, Y, Z], DirectorHold::Free),
        (vec![oblique], about),
        (vec![X, Z], about),
        (vec![Y], DirectorHold::Fixed),
    ] {
        let set = whole(&held, director);
        let made = || {
            let (springs, matrix) = springs(&bulk(&set).1);
            (body(&set, Vec3::zeros(), springs.into()), matrix)
        };
        let (shell, matrix) = made();
        let wanted = exact(&set, bulk(&set), &matrix);
        let mut found = spectrum(shell);
        found.sort_by(f64::total_cmp);
        assert_eq!(found.len(), wanted.len());
        let error = found.iter().zip(&wanted).map(|(f, w)| (f / w - 1.0).abs()).fold(0.0, f64::max);
        let greatest = *wanted.last().unwrap();
        let in_time = (largest_eigenvalue(&mut made().0, 60).ritz / greatest - 1.0).abs();
        println!("{} held, {director:?}: {error:.1e} {in_time:.1e}", held.len());
        // Round-off; in time the tangent is a difference of forces.
        assert!(error < 2e-12 && in_time < 6e-9, "{error:.1e} {in_time:.1e}");
    }
}

/// A clamped strip with a heavy end, a point of which beyond its mass is held across: `w + e w' = 0` and
/// `EI (w'' + e w''') = ω² (J + M e²) w'` at its end.
#[test]
fn a_strip_whose_heavy_end_is_hinged_beside_its_mass_vibrates_as_the_beam() {
    let (length, beyond, inertia) = (10.0, 1.5, 0.3);
    let rigidity = YOUNG * THICK.powi(3) / 12.0;
    let line = DENSITY * THICK;
    let mass = 0.5 * line * length;
    let lack = |x: f64| {
        let beta = x / length;
        let square = beta.powi(4) / line * (inertia + mass * beyond * beyond);
        let (sin, cos, sinh, cosh) = (libm::sin(x), libm::cos(x), libm::sinh(x), libm::cosh(x));
        let row = |[w, w1, w2, w3]: [f64; 4]| {
            let turn = beta * w1;
            [w + beyond * turn, beta * beta * w2 + beyond * beta.powi(3) * w3 - square * turn]
        };
        let a = row([cosh - cos, sinh + sin, cosh + cos, sinh - sin]);
        let b = row([sinh - sin, cosh - cos, sinh + sin, cosh + cos]);
        a[0] * b[1] - a[1] * b[0]
    };
    let roots = roots(3, lack);
    let errors = [20, 40, 80].map(|cells| {
        let cloud = flat([cells + 1, 3], [length, 1.0]);
        let sides = cloud.sides.clone().unwrap();
        let clamp = supported(sides.edge(Side::U0).to_vec(), Clamped);
        let end = sides.edge(Side::U1).to_vec();
        let shell = Shell::builder(beam_parts(cloud, THICK, vec![clamp], vec![]));
        let shell =
            shell.masses(end.iter().zip([0.25, 0.5, 0.25]).map(|(&a, s)| (a, s * mass)).collect::<Vec<_>>());
        let set = RigidSet {
            particles: end,
            at: Vec3::new(length + beyond, 0.5, 0.0),
            inertia: Matrix3::identity() * inertia,
            holds: vec![Holds { translations: vec![Y, Z], ..Holds::default() }],
            ..RigidSet::default()
        };
        let shell = shell.rigid(vec![set]).build().unwrap();
        let mut system = StaticShell::new(shell);
        let found = natural_modes(&mut system, 0.0, 14, 0.0, &mut unwatched).unwrap().modes;
        let nearest = |x: &f64| {
            let square = (x / length).powi(4) * rigidity / line;
            let error = |value: f64| ((value / square).sqrt() - 1.0).abs();
            found.iter().map(|mode| error(mode.eigenvalue)).fold(f64::INFINITY, f64::min)
        };
        roots.iter().map(nearest).fold(0.0, f64::max)
    });
    println!("{roots:?}: {errors:?}");
    // Second order in the cell; shear and rotary inertia of the strip are about 5e-4.
    assert!(errors[2] < 1.6e-3 && errors[0] < 3e-2 && errors[0] > 3.0 * errors[1], "{errors:?}");
}

fn roots(count: usize, f: impl Fn(f64) -> f64) -> Vec<f64> {
    let (mut found, mut low) = (Vec::new(), 0.05);
    while found.len() < count {
        let high = low + 0.01;
        if f(low) * f(high) < 0.0 {
            let (mut a, mut b) = (low, high);
            for _ in 0..60 {
                let middle = 0.5 * (a + b);
                if f(a) * f(middle) <= 0.0 { b = middle } else { a = middle }
            }
            found.push(a);
        }
        low = high;
    }
    found
}

/// A march by equal steps.
struct Swing {
    shell: Shell,
    time: f64,
    dt: f64,
    /// Kinetic energy at the beginning of the last step.
    kinetic: f64,
    steps: u32,
}

impl Swing {
    fn new(shell: Shell, dt: f64) -> Self {
        Self { shell, time: 0.0, dt, kinetic: 0.0, steps: 0 }
    }

    fn step(&mut self) {
        let at = |time: f64| Instant { time, level: 1.0 };
        let kick = if self.steps == 0 { 0.5 * self.dt } else { self.dt };
        let step = Step { from: at(self.time), to: at(self.time + self.dt), kick, damping: 0.0 };
        let work = self.shell.advance(&step);
        self.kinetic = work.kinetic;
        self.time += self.dt;
        self.steps += 1;
    }
}

/// The rotation of a plate that is rigid, from its corners.
fn rotation(shell: &Shell) -> Matrix3<f64> {
    let e = (shell.position(16) - shell.position(0)).normalize();
    let d = shell.director(0);
    Matrix3::from_columns(&[e, d.cross(&e), d])
}

/// The spin from rates of the same.
fn spin(shell: &Shell) -> Vec3 {
    let e = shell.position(16) - shell.position(0);
    let (d, v, w) = (shell.director(0), shell.velocity(16) - shell.velocity(0), shell.director_rate(0));
    let c = d.cross(&e);
    (d * v.dot(&c) - e * w.dot(&c) + c * w.dot(&e)) / c.norm_squared()
}

/// Half a swing of a pendulum from 2.5 rad to the other side, `T/2 = π √(J_p/(m g l))/agm(1, cos 1.25)`, the hinge beside the centre, its
/// axis held by places or by its rotations.
#[test]
fn a_pendulum_swings_as_long_as_the_elliptic_integral_says() {
    let hinge = whole(&[X, Y, Z], DirectorHold::InPlane(Y));
    let g = 9.0;
    let (mass, centre, tensor) = bulk(&hinge);
    let arm = hinge.at - centre;
    let long = Vec3::new(arm.x, 0.0, arm.z);
    let inertia = tensor[(1, 1)] + mass * long.norm_squared();
    // Gravity 2.5 rad away from hanging down: along −(c − p) turned about y.
    let start = 2.5_f64;
    let down =
        nalgebra::Rotation3::from_axis_angle(&nalgebra::Vector3::y_axis(), start) * (-long.normalize());
    let (mut a, mut b) = (1.0, libm::cos(0.5 * start));
    for _ in 0..20 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    let half = PI * (inertia / (mass * g * long.norm())).sqrt() / a;
    for held in [vec![X, Y, Z], vec![X, Z]] {
        let mut errors = Vec::new();
        for count in [400, 800, 1600] {
            let dt = half / f64::from(count);
            let mut swing =
                Swing::new(body(&whole(&held, DirectorHold::InPlane(Y)), down * g, Springs::default()), dt);
            // The spin comes back to zero: between which two steps.
            let (mut before, mut found) = (0.0, 0.0);
            for number in 0..2 * count {
                swing.step();
                let now = swing.shell.director_rate(0).dot(&Y.cross(&swing.shell.director(0)));
                if number > count / 2 && now * before <= 0.0 {
                    // Rates lie half a step behind places.
                    found = (f64::from(number) + before / (before - now) - 0.5) * dt;
                    break;
                }
                before = now;
            }
            errors.push(found / half - 1.0);
        }
        println!("{} held: {errors:?}", held.len());
        assert!(errors[2].abs() < 1.5e-6 && errors[1].abs() > 3.5 * errors[2].abs(), "{errors:?}");
    }
}

/// A body thrown while one point of it slides on a plane, along a line, or hangs at a point: the place that is held stays, energy has
/// no error that grows, momentum along what is free and moment of momentum about the vertical are kept.
#[test]
fn a_sliding_top_keeps_its_point_its_energy_and_its_momentum() {
    for held in [vec![Z], vec![X, Z], vec![X, Y, Z]] {
        let set = whole(&held, DirectorHold::Free);
        let gravity = Vec3::new(0.0, 0.0, -5.0);
        let mut drifts = Vec::new();
        let mut kept = [0.0_f64; 3];
        for dt in [4e-3, 2e-3, 1e-3] {
            let mut shell = body(&set, gravity, Springs::default());
            let (mass, centre, tensor) = bulk(&set);
            let rest = rotation(&shell);
            let throw = Vec3::new(0.8, -1.1, 2.0);
            let slide: Vec3 = [X, Y].iter().filter(|e| !held.contains(e)).map(|e| e * 0.7).sum();
            for a in 0..shell.len() {
                let arm = shell.position(a) - set.at;
                shell.set_rate(a, slide + throw.cross(&arm), throw.cross(&shell.director(a)));
            }
            let state = |shell: &Shell| {
                let turn = rotation(shell) * rest.transpose();
                let c = shell.position(0) + turn * (centre - shell.reference().cloud.positions[0]);
                let w = spin(shell);
                let v = shell.velocity(0) + w.cross(&(c - shell.position(0)));
                let moment = turn * tensor * turn.transpose() * w + c.cross(&v) * mass;
                (c, c + turn * (set.at - centre), v * mass, moment)
            };
            let mut swing = Swing::new(shell, dt);
            swing.step();
            let first = state(&swing.shell);
            let (mut start, mut worst) = (None, 0.0_f64);
            let (mut before, mut rise) = (first.0, 0.0_f64);
            for _ in 1..(6.0 / dt) as u32 {
                swing.step();
                // The kinetic energy is that at the beginning of the step.
                let energy = swing.kinetic + mass * 5.0 * (before.z - centre.z);
                worst = worst.max((energy - *start.get_or_insert(energy)).abs());
                before = state(&swing.shell).0;
                rise = rise.max((before.z - first.0.z).abs());
                let now = state(&swing.shell);
                for n in &held {
                    kept[0] = kept[0].max((now.1 - set.at).dot(n).abs());
                }
                for e in [X, Y].iter().filter(|e| !held.contains(e)) {
                    kept[1] = kept[1].max((now.2 - first.2).dot(e).abs() / first.2.norm());
                }
                // About the vertical through what turns: the point, or any where it slides on the plane.
                if held.len() != 2 {
                    let about = if held.len() == 3 { set.at } else { Vec3::zeros() };
                    let of = |s: &(Vec3, Vec3, Vec3, Vec3)| (s.3 - about.cross(&s.2)).z;
                    kept[2] = kept[2].max((of(&now) - of(&first)).abs() / first.3.norm());
                }
            }
            assert!(rise > 0.1, "{rise}");
            drifts.push(worst / start.unwrap());
        }
        println!("{} held: energy {drifts:?}, point, momentum, moment {kept:?}", held.len());
        assert!(drifts[2] < 7e-6 && drifts[1] > 3.0 * drifts[2] && drifts[0] > 3.0 * drifts[1], "{drifts:?}");
        assert!(kept[0] < 1e-14 && kept[1] < 1e-12 && kept[2] < 1e-11, "{kept:?}");
    }
}

//! One point of a bar: derivatives, rigid motions, rings, cross-sections.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use nalgebra::{Rotation3, Vector3};
use shell_kinematics::{Bar, BarForces, BarPlacement, BarSection};

const SECTION: BarSection =
    BarSection { axial: 900.0, bending: 2.0, shear: 300.0, torsion: 1.3, gyration: 4e-3 };
const HEIGHT: f64 = 0.07;

fn v(x: f64, y: f64, z: f64) -> Vector3<f64> {
    Vector3::new(x, y, z)
}

/// Curved, twisted, its director aslant.
fn rest() -> BarPlacement {
    BarPlacement { x1: v(1.0, 0.0, 0.0), d: v(0.03, 0.02, 0.98), d1: v(0.4, -0.3, 0.05) }
}

fn moved() -> BarPlacement {
    BarPlacement { x1: v(0.9, 0.25, -0.2), d: v(0.2, -0.1, 0.93), d1: v(0.7, 0.2, -0.3) }
}

fn stepped(from: &BarPlacement, way: &BarForces, by: f64) -> BarPlacement {
    let part = |first: usize| Vector3::from_fn(|k, _| way[first + k] * by);
    BarPlacement { x1: from.x1 + part(0), d: from.d + part(3), d1: from.d1 + part(6) }
}

fn bar() -> Bar {
    Bar::new(SECTION, HEIGHT, &rest()).unwrap()
}

/// Central differences of a step of 1e-5 leave 1e-10 of a derivative to truncation and as much to rounding.
#[test]
fn forces_and_tangent_are_derivatives() {
    let (bar, here) = (bar(), moved());
    let (forces, tangent) = (bar.forces(&here), bar.tangent(&here, None));
    let h = 1e-5;
    for k in 0..9 {
        let mut way = BarForces::zeros();
        way[k] = 1.0;
        let [plus, minus] = [h, -h].map(|by| stepped(&here, &way, by));
        let slope = (bar.energy(&plus) - bar.energy(&minus)) / (2.0 * h);
        assert!((slope - forces[k]).abs() < 1e-8 * forces.norm(), "{k}: {slope} {}", forces[k]);
        let column = (bar.forces(&plus) - bar.forces(&minus)) / (2.0 * h);
        let error = (column - tangent.column(k)).norm();
        assert!(error < 1e-8 * tangent.norm(), "{k}: {error:e}");
    }
    assert!((tangent - tangent.transpose()).norm() < 1e-14 * tangent.norm());
}

/// With the stresses of another state the tangent is what the two parts of it say: that of the state, and the change that stresses make.
#[test]
fn stresses_of_another_state_stiffen_this_one() {
    let (bar, here, there) = (bar(), rest(), moved());
    let stressed = bar.tangent(&here, Some(&there));
    let free = bar.tangent(&here, None);
    let stress = bar.resultants(&bar.strains(&there));
    let h = 1e-5;
    for k in 0..9 {
        let mut way = BarForces::zeros();
        way[k] = 1.0;
        // Where the bar is at rest, σ·∂²ε is the second difference of σ·ε.
        let work = |by: f64| {
            let strains = bar.strains(&stepped(&here, &way, by));
            stress.iter().zip(strains).map(|(stress, strain)| stress * strain).sum::<f64>() * bar.length()
        };
        let found = (work(h) - 2.0 * work(0.0) + work(-h)) / (h * h);
        let more = stressed[(k, k)] - free[(k, k)];
        assert!((found - more).abs() < 1e-4 * free.norm(), "{k}: {found} {more}");
    }
}

#[test]
fn a_bar_that_turns_as_a_whole_is_free() {
    let bar = bar();
    assert_eq!(bar.strains(&rest()), [0.0; 4]);
    let turn = Rotation3::new(v(0.7, -1.9, 0.4));
    let BarPlacement { x1, d, d1 } = rest();
    let turned = BarPlacement { x1: turn * x1, d: turn * d, d1: turn * d1 };
    for strain in bar.strains(&turned) {
        assert!(strain.abs() < 4e-16, "{strain:e}");
    }
}

/// A segment of a ring of radius R over the angle ψ, between unit directors.
fn ring(radius: f64, angle: f64, length: f64) -> BarPlacement {
    let half = 0.5 * angle;
    BarPlacement {
        x1: v(2.0 * radius * libm::sin(half) / length, 0.0, 0.0),
        d: v(0.0, 0.0, libm::cos(half)),
        d1: v(2.0 * libm::sin(half) / length, 0.0, 0.0),
    }
}

/// Wider all over: the line at the height e by u/(R + e), without bending. Opened to another angle: by the arcs at that height, and bent by the
/// change of angle over its length. Chords of arcs are short by ψ²/24, of which the change is what is missed.
#[test]
fn rings_stretch_and_bend_at_the_height_of_the_bar() {
    let (radius, angle) = (1.0, 0.1);
    let length = 2.0 * radius * libm::sin(0.5 * angle);
    let bar = Bar::new(SECTION, HEIGHT, &ring(radius, angle, length)).unwrap();
    let wider = bar.strains(&ring(radius + 1e-6, angle, length));
    let exact = 1e-6 / (radius + HEIGHT);
    assert!((wider[0] / exact - 1.0).abs() < angle * angle / 24.0 * HEIGHT + 2e-6, "{wider:?}");
    // The director is the same and the line longer: freed of stretch, nothing bends.
    assert!(wider[1].abs() < 1e-14 && wider[2..] == [0.0; 2], "{wider:?}");
    let more = 1e-5;
    let bent = BarPlacement { x1: v(1.0, 0.0, 0.0), ..ring(radius, angle + more, length) };
    let bent = bar.strains(&bent);
    let arc = (radius + HEIGHT) * angle;
    assert!((bent[0] / (HEIGHT * more / arc) - 1.0).abs() < angle * angle / 12.0, "{bent:?}");
    assert!((bent[1] / (more / arc) - 1.0).abs() < angle * angle / 12.0, "{bent:?}");
}

/// A twisted bar: twist, and fibres that lengthen by half the square of it times that of their distance, those at the height e among them.
#[test]
fn a_twisted_bar_turns_and_its_fibres_lengthen() {
    let straight = BarPlacement { x1: v(1.0, 0.0, 0.0), d: v(0.0, 0.0, 1.0), d1: Vector3::zeros() };
    let bar = Bar::new(SECTION, HEIGHT, &straight).unwrap();
    let (angle, length): (f64, f64) = (0.02, 0.5);
    let half = 0.5 * angle;
    let d1 = v(0.0, 2.0 * libm::sin(half) / length, 0.0);
    let twisted = BarPlacement { d: v(0.0, 0.0, libm::cos(half)), d1, ..straight };
    let [axial, bending, shear, twist] = bar.strains(&twisted);
    let rate = angle / length;
    // By length of the line at the height e, which is longer by ½ e²τ².
    assert!((twist.abs() / rate - 1.0).abs() < (HEIGHT * rate).powi(2), "{twist}");
    let lengthened = 0.5 * rate * rate * (HEIGHT * HEIGHT + SECTION.gyration);
    assert!((axial / lengthened - 1.0).abs() < 1e-3, "{axial} {lengthened}");
    // Freed of the stretch of that line, whose tangent leans by e τ.
    assert!(bending.abs() < 1.1 * HEIGHT * rate * rate && shear.abs() < 1e-15, "{bending} {shear}");
}

/// St Venant's constants of rectangles \[timoshenko1951\]: 0.1406, 0.229, 0.291, 0.312, and a third of a thin one.
#[test]
fn rectangles_have_the_torsion_of_st_venant() {
    for (ratio, constant, error) in
        [(1.0, 0.140577, 1e-6), (2.0, 0.229, 5e-4), (5.0, 0.291, 5e-4), (10.0, 0.312, 5e-4)]
    {
        for (width, height) in [(0.1, 0.1 * ratio), (0.1 * ratio, 0.1)] {
            let section = BarSection::rectangle([5.0, 2.0], width, height);
            let found = section.torsion / (2.0 * 1e-4 * ratio);
            assert!((found - constant).abs() < error, "{ratio}: {found}");
            assert_eq!(section.bending, 5.0 * width * height * height * height / 12.0);
        }
    }
    let thin = BarSection::rectangle([5.0, 2.0], 1.0, 1e-3);
    assert!((thin.torsion / (2.0 * 1e-9 / 3.0) - 1.0).abs() < 7e-4);
}

#[test]
fn a_bar_beyond_the_centre_of_curvature_is_none() {
    let inward = |height: f64| Bar::new(SECTION, height, &ring(1.0, 0.1, 0.1)).is_some();
    assert!(inward(-0.8) && !inward(-0.95) && !inward(-1.5));
}

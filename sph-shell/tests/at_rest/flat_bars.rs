//! Bars that bend in the surface: beams on two supports, half of one, a cantilever with its sheet, what is no line.

use crate::common::{X, Y, YOUNG, Z, at, beam_parts, flat, supported};
use implicit_statics::{Equilibrium, linear_response};
use shell_kinematics::BarSection;
use sph_core::{Cloud, Side, Vec3};
use sph_shell::{
    Clamped, Force, Held, InSurface, Load, Shell, ShellError, StaticShell, Stiffener, StiffenerError,
    Supported,
};

const LENGTH: f64 = 10.0;
/// Width and height of the bar, and its EI in the surface.
const SIZE: [f64; 2] = [0.6, 0.3];
const BENDING: f64 = YOUNG * 0.3 * 0.216 / 12.0;

/// A bar along the middle of a strip one wide.
fn bar(cloud: &Cloud, held: Vec<u32>) -> Stiffener {
    let [width, height] = SIZE;
    Stiffener {
        particles: at(cloud, |x| (x.y - 0.5).abs() < 1e-9),
        section: BarSection::rectangle([YOUNG, 0.5 * YOUNG], width, height),
        height: 0.0,
        mass: width * height,
        in_surface: Some(InSurface { bending: BENDING, held }),
    }
}

fn held(displacement: Vec<Vec3>) -> Held {
    Held { displacement, director: None }
}

/// Displacement of a particle by the linear answer.
fn moved(body: Shell, particle: u32) -> Vec3 {
    let mut system = StaticShell::new(body);
    let response = linear_response(&mut system, 0.0).unwrap();
    system.update(&response.iter().map(|u| 1e-6 * u).collect::<Vec<_>>());
    system.shell().displacement(particle as usize) * 1e6
}

/// A bar with a skin as thin as foil on two supports, `5 q L⁴/384 EI` under a steady load in the surface: all of it, or half with a plane of symmetry in the middle,
/// where its direction is held.
fn on_two_supports(cells: usize, half: bool) -> f64 {
    let length = if half { 0.5 * LENGTH } else { LENGTH };
    let cloud = flat([cells + 1, 3], [length, 1.0]);
    let line = at(&cloud, |x| (x.y - 0.5).abs() < 1e-9);
    let (first, last) = (line[0], line[cells]);
    let edge = |side: Side| cloud.sides.as_ref().unwrap().edge(side).to_vec();
    let far = match half {
        true => supported(edge(Side::U1), held(vec![X])),
        false => supported(vec![last], held(vec![Y])),
    };
    // Nothing moves out of the plane.
    let all = || (0..cloud.len() as u32).collect();
    let upright = |normal| Held { displacement: Vec::new(), director: Some(normal) };
    let fixed = vec![
        supported(all(), held(vec![Z])),
        supported(all(), upright(X)),
        supported(all(), upright(Y)),
        supported(vec![first], held(if half { vec![Y] } else { vec![X, Y] })),
        far,
    ];
    let share = |a: &u32| (*a, if *a == first || *a == last { 0.5 } else { 1.0 });
    let shares: Vec<(u32, f64)> = line.iter().map(share).collect();
    let load: Box<dyn Load> = Box::new(Force { shares, total: Y * length });
    let own = bar(&cloud, if half { vec![last] } else { Vec::new() });
    let body = Shell::builder(beam_parts(cloud, 1e-6, fixed, vec![load])).stiffeners(vec![own]).build();
    let middle = if half { last } else { line[cells / 2] };
    moved(body.unwrap(), middle).y / (5.0 * LENGTH.powi(4) / (384.0 * BENDING))
}

/// Second differences are of the second order, and half a bar is half of the whole.
#[test]
fn a_bar_on_two_supports_is_a_beam_in_the_surface() {
    let [coarse, fine] = [10, 20].map(|cells| on_two_supports(cells, false) - 1.0);
    println!("{coarse:.2e} {fine:.2e}");
    assert!((coarse / fine / 4.0 - 1.0).abs() < 0.1 && fine.abs() < 6e-3, "{coarse} {fine}");
    let (whole, half) = (on_two_supports(20, false), on_two_supports(10, true));
    assert!((whole / half - 1.0).abs() < 1e-8, "{whole} {half}");
}

/// A strip one wide pushed sideways at its end, with the bar or without: `1/v` grows by `3 EI/L³`, but for what the strip shears. Without a hold at the clamp the bar takes its
/// moment from the strip beside it.
#[test]
fn a_flat_bar_stiffens_a_strip_in_its_plane() {
    let way = |bars: Option<bool>| {
        let cloud = flat([41, 9], [LENGTH, 1.0]);
        let edge = |side: Side| cloud.sides.as_ref().unwrap().edge(side).to_vec();
        let fixed: Vec<Supported> = vec![
            supported(edge(Side::U0), Clamped),
            supported((9..cloud.len() as u32).collect(), held(vec![Z])),
        ];
        let tip = at(&cloud, |x| x.x > LENGTH - 1e-9 && (x.y - 0.5).abs() < 1e-9)[0];
        let shares = edge(Side::U1).into_iter().map(|a| (a, 1.0)).collect();
        let load: Box<dyn Load> = Box::new(Force { shares, total: Y });
        let root = at(&cloud, |x| x.x < 1e-9 && (x.y - 0.5).abs() < 1e-9);
        let bars = bars.map(|is_held| bar(&cloud, if is_held { root } else { Vec::new() }));
        let body = Shell::builder(beam_parts(cloud, 0.2, fixed, vec![load]));
        moved(body.stiffeners(bars.into_iter().collect()).build().unwrap(), tip).y
    };
    let [plain, clamped, free] = [None, Some(true), Some(false)].map(way);
    let gain = |way: f64| (1.0 / way - 1.0 / plain) / (3.0 * BENDING / LENGTH.powi(3));
    println!(
        "gain of stiffness over that of the beam: held {:.4}, not held {:.4}",
        gain(clamped),
        gain(free)
    );
    // 1.0000; .8895 where the end is free to turn.
    assert!((gain(clamped) - 1.0).abs() < 2e-3, "{}", gain(clamped));
    assert!(gain(free) < 0.95 && gain(free) > 0.8, "{}", gain(free));
}

#[test]
fn what_has_no_one_turn_is_refused() {
    let cloud = flat([7, 7], [1.0, 1.0]);
    let lattice = cloud.lattice.unwrap();
    let built = |particles: Vec<u32>, held: Vec<u32>| {
        let own = Stiffener { particles, ..bar(&cloud, held) };
        let body = Shell::builder(beam_parts(cloud.clone(), 0.1, vec![], vec![])).stiffeners(vec![own]);
        match body.build().err() {
            Some(ShellError::Stiffener(cause)) => Some(cause),
            _ => None,
        }
    };
    let (row, column) = (lattice.row(3), lattice.column(3));
    assert!(built(row.clone(), vec![row[0]]).is_none());
    let cross = built([row.clone(), column].concat(), vec![]);
    assert!(matches!(cross, Some(StiffenerError::Forks { .. })), "{cross:?}");
    let corner = built([lattice.row(0), lattice.column(0)].concat(), vec![]);
    assert!(matches!(corner, Some(StiffenerError::Corner { .. })), "{corner:?}");
    let inside = built(row.clone(), vec![row[2]]);
    assert!(matches!(inside, Some(StiffenerError::NoEnd { .. })), "{inside:?}");
}

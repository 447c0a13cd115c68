//! thickness: plates, bent arcs, and hemispheres from L/t = 5 to 10⁴; deflections over exact ones, and stable steps.

use benchmarks_ref::fe_shell::cases::hemisphere_of_thickness;

use super::causes::{NODAL, UNEVEN};
use crate::cases::shell::plate;
use crate::judge::{Case, Headline, MET, Run, Runs, Variant};
use crate::methods::{CELL, ELEMENTS, NODAL_1, NODAL_2, NODAL_3, STATIC, WIDE_14};
use crate::metric_names::ERROR;
use crate::support::clouds::{Cloud, HEMISPHERE, Shape};
use crate::support::studies::{off, or_refused};
use crate::{JudgeError, Metric};

/// Quarter of a ring, clamped at the crown u0, pulled outward at u1 by a force in its plane; ν = 0, radius 10.
///
/// As a curved beam, φ counted from the loaded end: `M = F R sin φ`, `N = F sin φ`, `Q = F cos φ`, and, since the curvature
/// of the shell is free of stretch, energies that do not mix: by Castigliano the load's displacement is
/// `∫(M²/EI + N²/EA + Q²/κGA) R dφ / F = ¼π F R (R²/EI + 1/EA + 1/κGA) = ¼π F R/(E b t) (12 R²/t² + 1 + 12/5)`.
const ARC: &str = r#"
title = "Quarter ring bent in its plane"
units = { length = "-", force = "-", time = "-" }
material.elastic = { young = 1e6, poisson = 0.0, density = 1.0 }
section.homogeneous.thickness = 1.0
supports = [{ on = "u0", clamped = {} }]
loads = [{ on = "u1", force = { total = [1.0, 0.0, 0.0] } }]
analysis.linear = {}
curve = [{ name = "w", of = "displacement", on = "u1", direction = [1.0, 0.0, 0.0] }]
[geometry.cylinder]
radius = 10.0
angles = [0.0, 90.0]
length = 2.0
particles = [33, 5]
"#;
const BEAM: Shape = Shape {
    name: "arc",
    scene: ARC,
    geometry: "cylinder",
    keys: "radius = 10.0, angles = [0.0, 90.0], length = 2.0",
    counts: [33, 5],
    spacing: 0.49,
};
/// A part of a sphere of radius one, clamped at the top, under pressure: the membrane bears all of it. The energy, half the work of the
/// pressure, is compared with that of the lattice of as many particles: it finds a membrane that gives way.
const DOME: &str = r#"
title = "Dome under pressure"
units = { length = "-", force = "-", time = "-" }
material.elastic = { young = 1e6, poisson = 0.3, density = 1.0 }
section.homogeneous.thickness = 0.01
supports = [
    { on = "u0", clamped = {} },
    { on = "u1", symmetry = { normal = [0, 0, 1] } },
    { on = "v0", symmetry = { normal = [0, 1, 0] } },
    { on = "v1", symmetry = { normal = [1, 0, 0] } },
]
loads = [{ on = "all", pressure = { value = 1.0 } }]
analysis.linear = {}
curve = [{ name = "w", of = "displacement", on = "all", direction = [0.57735, 0.57735, 0.57735] }]
[geometry.sphere]
radius = 1.0
polar = [30.0, 90.0]
azimuth = [0.0, 90.0]
particles = [21, 21]
"#;
const SPHERE: Shape = Shape {
    name: "dome",
    scene: DOME,
    geometry: "sphere",
    keys: "radius = 1.0, polar = [30.0, 90.0], azimuth = [0.0, 90.0]",
    counts: [21, 21],
    spacing: 0.065,
};

const JITTER: Cloud = Cloud::Jitter(0.25, 1);
const ALL: [&str; 5] = [STATIC, WIDE_14, NODAL_1, NODAL_2, NODAL_3];

/// A thickness, as L/t of plates, R/t of arcs and hemispheres.
struct Slender {
    slenderness: f64,
    /// Central deflection of the clamped plate in q a⁴/D (`plate_static_square`); none where the file has none.
    plate: Option<f64>,
    /// Errors \[%\] by which [`ALL`] are known to miss what is asked of the plate, the arc, and the hemisphere.
    known: [[f64; 5]; 3],
    /// The same of the default method on the jittered arc and hemisphere.
    jittered: [f64; 2],
}

#[rustfmt::skip] // a paragraph a thickness
const THICKNESSES: [Slender; 7] = [
    Slender { slenderness: 5.0, plate: Some(0.00217216), known: [
        [MET, MET, 8.242, -2.285, MET],
        [MET; 5],
        [MET, MET, 4.314, MET, MET],
    ], jittered: [MET, MET] },
    Slender { slenderness: 10.0, plate: Some(0.00150463), known: [
        [MET, MET, 11.59, -3.334, MET],
        [MET; 5],
        [MET, MET, 3.505, MET, MET],
    ], jittered: [MET, MET] },
    Slender { slenderness: 20.0, plate: Some(0.00132726), known: [
        [MET, MET, 12.89, -4.015, -0.5597],
        [MET; 5],
        [MET, MET, 3.007, 1.125, -1.064],
    ], jittered: [MET, MET] },
    Slender { slenderness: 100.0, plate: Some(0.00126785), known: [
        [MET, MET, 13.62, -4.209, -0.6021],
        [MET, MET, MET, -2.125, -4.814],
        [MET, MET, 4.371, 1.337, -5.534],
    ], jittered: [MET, MET] },
    Slender { slenderness: 250.0, plate: None, known: [
        [MET; 5],
        [MET, MET, -0.5347, -5.99, -14.92],
        [MET, MET, 4.369, MET, -17.18],
    ], jittered: [MET, MET] },
    Slender { slenderness: 1000.0, plate: Some(0.00126534), known: [
        [MET, MET, 11.5, -6.183, -13.07],
        [MET, MET, -4.1, -16.08, -37.68],
        [MET, MET, -1.489, -9.261, -59.63],
    ], jittered: [MET, -5.908] },
    Slender { slenderness: 10000.0, plate: Some(0.00126534), known: [
        [MET, MET, -8.221, -42.64, -45.82],
        [MET, MET, -71.43, -31.93, -52.63],
        [MET, MET, -75.95, -80.13, -98.24],
    ], jittered: [-1.039, -57.66] },
];

/// R/t of domes, with the errors \[%\] by which they are known to miss what is asked, jittered by ¼ and .4, and scattered.
const DOMES: [(f64, [f64; 3]); 4] =
    [(100.0, [MET; 3]), (250.0, [MET; 3]), (1000.0, [MET; 3]), (10000.0, [2.45, 7.05, 2.49])];

const PLATES: (f64, &str) =
    (0.5, "required of this project: within half a percent, and flat in the thickness");
const SPHERES: (f64, &str) =
    (1.0, "required of this project: within 1 % at 21² a quarter, and flat in the thickness");
const JITTERED: &str = "at most twice the lattice's, half a percent for uneven spacings";
const DOMED: (f64, &str) =
    (1.5, "docs/uneven-cells.md: the membrane gives way by about a percent, whatever the thickness");

/// The scenes, their references, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "thickness",
        title: "Thin and thick",
        about: "Deflections over exact ones for L/t or R/t from 5 to 10⁴: clamped plate (Mindlin), quarter ring (curved \
                beam), hemisphere (the finite-element shell at the same thickness, 48 elements a side). Locking would let \
                the ratio fall with the thickness. Explicit runs of a few steps show the stable step.",
        citation: "Timoshenko and Woinowsky-Krieger 1959; Castigliano's theorem; this project's finite-element shell",
        variants: variants(),
        headline: Some(Headline::new(ERROR, 0.01)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for Slender { slenderness, plate, known, .. } in &THICKNESSES {
        let Some(exact) = *plate else { continue };
        let clamped = |method: &'static str| {
            plate::of_thickness(method, 21, 1.0 / slenderness)
                .named(format!("plate lattice L/t {slenderness}"))
        };
        variants.extend(ALL.into_iter().zip(known[0]).map(|(method, error)| {
            let found = clamped(method).off(move |run, _| Ok(off(run.last("w_centre")?.map(|w| w / exact))));
            found.asked(PLATES.0, PLATES.1).known(error, cause(method))
        }));
        let duration = 0.05 * slenderness.recip();
        variants.push(steps(clamped(CELL), duration, 0.05, 12.0_f64.sqrt() * slenderness));
    }
    for Slender { slenderness, known, jittered, .. } in &THICKNESSES {
        variants.extend(arcs(*slenderness, known[1], jittered[0]));
        variants.extend(hemispheres(*slenderness, known[2], jittered[1]));
    }
    let clouds = [JITTER, Cloud::Jitter(0.4, 1), Cloud::Scattered(1)];
    for (slenderness, known) in DOMES {
        let label = format!("R/t {slenderness}");
        let dome = |cloud| sized(SPHERE.on(STATIC, cloud), 1.0 / slenderness, &label);
        let lattice = dome(Cloud::Lattice);
        let reference = lattice.grid.clone();
        variants.push(lattice);
        for (cloud, error) in clouds.into_iter().zip(known) {
            let reference = reference.clone();
            let given_way =
                move |run: &Run, runs: &Runs| against(run, runs, (STATIC, &reference), "internal");
            variants.push(dome(cloud).off(given_way).asked(DOMED.0, DOMED.1).known(error, UNEVEN));
        }
    }
    let quick = |variant: Variant| {
        let own = [STATIC, CELL, ELEMENTS].contains(&variant.method.as_str());
        variant.quick_if(own)
    };
    variants.into_iter().map(or_refused).map(quick).collect()
}

/// The arc with all methods, jittered, and a few steps in time.
fn arcs(slenderness: f64, known: [f64; 5], jittered: f64) -> Vec<Variant> {
    let (thickness, label) = (10.0 / slenderness, format!("R/t {slenderness}"));
    let exact = 0.25 * std::f64::consts::PI * 10.0 / (1e6 * 2.0 * thickness)
        * (12.0 * slenderness.powi(2) + 1.0 + 2.4);
    let arc = |method, cloud| {
        let found = sized(BEAM.on(method, cloud), thickness, &label);
        found.off(move |run, _| Ok(off(run.last("w")?.map(|w| w / exact))))
    };
    let on_lattice = ALL.into_iter().zip(known).map(|(method, error)| {
        arc(method, Cloud::Lattice).asked(PLATES.0, PLATES.1).known(error, cause(method))
    });
    let lattice = format!("{} {label}", BEAM.label(Cloud::Lattice));
    let spacing = 10.0 * std::f64::consts::FRAC_PI_2 / 32.0;
    let marched = sized(BEAM.on(CELL, Cloud::Lattice), thickness, &label);
    on_lattice
        .chain([
            arc(STATIC, JITTER).asked_twice_that_of(lattice, JITTERED).known(jittered, UNEVEN),
            steps(marched, 5e-4, spacing, 1e3),
        ])
        .collect()
}

/// The hemisphere with all methods, jittered, a few steps in time, and finite elements, by which all are judged.
fn hemispheres(slenderness: f64, known: [f64; 5], jittered: f64) -> Vec<Variant> {
    let (thickness, label) = (10.0 / slenderness, format!("R/t {slenderness}"));
    let lattice = format!("{} {label}", HEMISPHERE.label(Cloud::Lattice));
    let by_elements = |variant: Variant| {
        let elements = lattice.clone();
        variant.off(move |run, runs| against(run, runs, (ELEMENTS, &elements), "outward"))
    };
    let sphere = |method, cloud| by_elements(sized(HEMISPHERE.on(method, cloud), thickness, &label));
    let on_lattice = ALL.into_iter().zip(known).map(|(method, error)| {
        sphere(method, Cloud::Lattice).asked(SPHERES.0, SPHERES.1).known(error, cause(method))
    });
    // The least spacing lies at the hole; c² = E/ρ(1 − ν²).
    let spacing = 10.0 * libm::sin(18.0_f64.to_radians()) * std::f64::consts::FRAC_PI_2 / 20.0;
    let marched = sized(HEMISPHERE.on(CELL, Cloud::Lattice), thickness, &label);
    let elements = Variant::elements(ELEMENTS, [49, 49], move || hemisphere_of_thickness(48, thickness));
    on_lattice
        .chain([
            sphere(STATIC, JITTER).asked_twice_that_of(lattice.clone(), JITTERED).known(jittered, UNEVEN),
            steps(marched, 5e-5, spacing, (6.825e7_f64 / 0.91).sqrt()),
            by_elements(elements.named(lattice.clone())).asked(SPHERES.0, SPHERES.1),
        ])
        .collect()
}

fn sized(variant: Variant, thickness: f64, label: &str) -> Variant {
    variant.set("section.homogeneous.thickness", format!("{thickness:?}")).on(label)
}

/// The last value of a column over that of another run \[%\].
fn against(
    run: &Run,
    runs: &Runs,
    (method, grid): (&str, &str),
    column: &str,
) -> Result<Option<f64>, JudgeError> {
    let exact = runs.get(method, grid)?.map(|other| other.last(column)).transpose()?.flatten();
    Ok(off(run.last(column)?.zip(exact).map(|(found, exact)| found / exact)))
}

/// A few steps in time, which show the stable step over the time that sound of some speed takes over the least spacing.
fn steps(variant: Variant, duration: f64, spacing: f64, speed: f64) -> Variant {
    let transient = format!("{{ transient = {{ duration = {duration:?}, record_every = {duration:?} }} }}");
    variant.set("analysis.explicit", transient).unsettled().judged(move |run, _| {
        let step = Some(run.outcome.stable_step * speed / spacing).filter(|_| run.done());
        let reason = "rotary inertia is scaled to the cell so that the step of the membrane stands; narrow strips lose a \
                      seventh at free edges, a step of bending would be t/Δ = .002 at 10⁴";
        Ok(vec![Metric::at_least("stable step · c/Δ", step, "-", 1.0).within(0.2, reason)])
    })
}

/// Why a method misses what is asked.
fn cause(method: &str) -> &'static str {
    if method == STATIC { UNEVEN } else { NODAL }
}

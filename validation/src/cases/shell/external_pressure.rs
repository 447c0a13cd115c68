//! external-pressure: rings and long cylinders under pressure that follows the surface, against closed forms.

use benchmarks_ref::external_pressure::{Tube, cylinder, least, ring};

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const RING: &str = include_str!("../../../../scenes/ring-pressure.toml");
const CYLINDER: &str = include_str!("../../../../scenes/cylinder-pressure.toml");
const NAME: &str = "critical pressure";
const OF_RINGS: &str =
    "three times the error of 61 particles, .05 %; without the stiffness of the load it is 33 %";
const OF_CYLINDERS: &str = "two to three times the .6 to 1.1 % measured; the formula leaves out what the diaphragms bend \
                            before buckling, most in the shortest, without the load's stiffness n²/(n² − 1) more";

/// As in the scene of the cylinder.
const TUBE: Tube = Tube { young: 210_000.0, poisson: 0.3, radius: 100.0, thickness: 1.0 };
/// Waves around, length over radius at which they are the least critical ones, particles along half of it.
const CYLINDERS: [(u32, f64, usize); 5] =
    [(2, 24.0, 97), (3, 9.0, 61), (4, 5.0, 41), (5, 3.0, 31), (6, 2.0, 25)];

/// The scenes, their references, and how far they may differ.
pub fn case() -> Case {
    Case {
        name: "external-pressure",
        title: "Ring and long cylinder under pressure from outside",
        about: "Follower pressure has a stiffness of its own: with it a ring ovals at 3 EI/R³, without it at 4, which is \
                the answer for dead pressure and stands beside. Found by linearised buckling and as the bifurcation of a \
                path; long cylinders by buckling, two to six waves around.",
        citation: "von Mises 1914; Timoshenko and Gere 1961, sections 7.4 and 11.5",
        variants: variants(),
        headline: Some(Headline::new(NAME, 0.01)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let of_ring = |name: &str| Variant::new(STATIC, RING, "cylinder", [61, 3]).on(name).quick();
    let path = "{ until = 3.5, radius = 0.5 }";
    let first = |run: &Run| Ok(run.column("level")?.first().copied());
    let on_path = |run: &Run| Ok(run.outcome.critical.first().map(|critical| critical.level));
    // EI/R³ is one in the units of the scene.
    let mut variants = vec![
        judged(of_ring("ring, follower"), first, ring(1.0, 1.0, 2), (0.15, OF_RINGS)),
        judged(
            of_ring("ring, follower, path").set("analysis.arc-length", path),
            on_path,
            ring(1.0, 1.0, 2),
            (0.15, OF_RINGS),
        ),
        judged(of_ring("ring, dead").set("loads.0.pressure.follower", false), first, 4.0, (0.15, OF_RINGS)),
    ];
    for (waves, times, along) in CYLINDERS {
        let length = times * TUBE.radius;
        debug_assert_eq!(least(&TUBE, length).1, waves);
        let angle = 180.0 / f64::from(waves);
        let (sin, cos) = libm::sincos(angle.to_radians());
        let variant = Variant::new(STATIC, CYLINDER, "cylinder", [17, along])
            .on(&format!("cylinder, {waves} waves"))
            .set("geometry.cylinder.angles", format!("[0.0, {angle}]"))
            .set("geometry.cylinder.length", 0.5 * times * TUBE.radius)
            .set("supports.1.symmetry.normal", format!("[{cos:.17}, 0.0, {:.17}]", -sin))
            .quick_if(waves == 4);
        variants.push(judged(variant, first, cylinder(&TUBE, length, waves), (2.0, OF_CYLINDERS)));
    }
    variants
}

/// Judges the critical pressure of a run against a closed form.
fn judged(
    variant: Variant,
    pressure: fn(&Run) -> Result<Option<f64>, JudgeError>,
    expected: f64,
    (tolerance, reason): (f64, &'static str),
) -> Variant {
    variant.judged(move |run, _| {
        let percent = pressure(run)?.map(|found| 100.0 * (found / expected - 1.0));
        Ok(vec![Metric::error(NAME, percent, "%").within(tolerance, reason)])
    })
}

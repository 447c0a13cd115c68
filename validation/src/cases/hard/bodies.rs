//! bodies: what is no shell, or hardly one: refused with a clear error, or treated as documented.

use implicit_statics::linear_response;
use sph_core::{Cell, Vec3};
use sph_shell::{Clamped, Force, StaticShell, Supported};

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::{CELL, NODAL_2, NODAL_3, WIDE_14, WIDE_30};
use crate::support::sheets::{POISSON, Sheet, THICKNESS, YOUNG, shell};
use crate::support::studies::finding;
use crate::{JudgeError, Metric};

const AS_DOCUMENTED: &str = "refused or treated as documented";
/// Particles a side of a sheet.
const SIDE: usize = 9;

/// A body and a method, with what is found: whether it is as documented.
type Body = (&'static str, &'static str, fn(&str) -> Result<bool, String>);

/// The bodies, and what has to come of each.
pub fn case() -> Case {
    Case {
        name: "bodies",
        title: "Bad bodies",
        about: "Isolated and duplicate particles, sheets apart, normals and cells turned round, a strip with one side, slivers, \
                three sheets on an edge, NaN, coincident lips, holes smaller than the support: each has to be refused with \
                particle or cell, value, bound and repair, or to be treated as documented. 1 is yes.",
        citation: "errors of sph-core and implicit-statics; a uniform stretch for the holes",
        variants: bodies().into_iter().map(variant).collect(),
        each,
        headline: Some(Headline::new(AS_DOCUMENTED, 0.01)),
        ..Case::default()
    }
}

fn variant((name, method, find): Body) -> Variant {
    let run = move || {
        let found = find(method)?;
        Ok(finding(SIDE * SIDE, 1.0 / (SIDE - 1) as f64, &[("as documented", f64::from(u8::from(found)))]))
    };
    Variant::study(method, name, run).quick()
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let value = run.column("as documented")?.last().copied();
    let reason = "each a clear error or a documented, tested treatment";
    Ok(vec![Metric::compared(AS_DOCUMENTED, value, "-", 1.0).within(0.0, reason)])
}

fn bodies() -> Vec<Body> {
    let mut bodies: Vec<Body> = vec![
        ("isolated particle", CELL, |_| {
            refused(|s| s.positions.push(Vec3::new(9.0, 9.0, 0.0)), "particle 81 is isolated")
        }),
        ("duplicate particle", CELL, |_| {
            refused(|s| s.positions[30] = s.positions[31] + Vec3::x() * 1e-9, "particles 30 and 31 coincide")
        }),
        ("NaN position", CELL, |_| refused(|s| s.positions[5].y = f64::NAN, "particle 5: position is NaN")),
        ("cell turned round", CELL, |_| {
            refused(|s| s.cells[12].corners.reverse(), "reverse the corner order")
        }),
        ("normal turned round", CELL, |_| normal_turned_round()),
        ("strip with one side", CELL, |_| moebius()),
        ("sliver", CELL, |_| {
            refused(|s| s.positions[10] = s.positions[9] + Vec3::new(0.0825, 0.00375, 0.0), "angle of")
        }),
        ("three sheets on an edge", CELL, |_| refused(third_sheet, "belongs to 3 cells")),
        ("one of two sheets without support", CELL, |_| apart(1)),
        ("two sheets apart, both supported", CELL, |_| apart(2)),
        ("coincident lips", CELL, |method| lips(method).map(|built| built.is_none())),
        ("coincident lips", WIDE_14, |method| {
            lips(method).map(|built| built.is_some_and(|error| error.contains("coincide")))
        }),
        ("coincident lips", NODAL_2, |method| {
            lips(method).map(|built| built.is_some_and(|error| error.contains("coincide")))
        }),
    ];
    let methods = [CELL, WIDE_14, WIDE_30, NODAL_2, NODAL_3];
    bodies.extend(methods.map(|method| -> Body { ("hole of one cell", method, hole) }));
    bodies
}

/// Whether a square sheet is refused in these words after a change.
fn refused(change: fn(&mut Sheet), words: &str) -> Result<bool, String> {
    let mut sheet = Sheet::square(SIDE, Vec3::zeros());
    change(&mut sheet);
    // The message names place, value or bound, and after the semicolon the repair.
    Ok(sheet
        .cloud()
        .is_err_and(|error| error.contains(words) && (error.contains("; ") || error.contains(", "))))
}

fn normal_turned_round() -> Result<bool, String> {
    let sheet = Sheet::square(SIDE, Vec3::zeros());
    let mut normals = vec![Vec3::z(); SIDE * SIDE];
    normals[40] = -Vec3::z();
    let cloud = sph_core::Cloud::from_cells(sheet.positions, Some(normals), sheet.cells);
    Ok(cloud
        .is_err_and(|error| error.to_string().contains("particle 40: its normal is 180° from that of cell")))
}

/// A third sheet on the edge between particles 40 and 41.
fn third_sheet(sheet: &mut Sheet) {
    let first = sheet.positions.len() as u32;
    for a in [40, 41] {
        sheet.positions.push(sheet.positions[a] + Vec3::new(0.0, 0.0, 0.1));
    }
    sheet.cells.push(Cell::quadrangle([40, 41, first + 1, first]));
}

/// A ribbon of forty cells closed after half a turn.
fn moebius() -> Result<bool, String> {
    let count = 40_u32;
    let place = |i: u32, side: f64| {
        let along = std::f64::consts::TAU * f64::from(i) / f64::from(count);
        let (sin, cos) = libm::sincos(0.5 * along);
        let radius = 3.0 + side * cos;
        Vec3::new(radius * libm::cos(along), radius * libm::sin(along), side * sin)
    };
    let positions = (0..count).flat_map(|i| [place(i, -0.5), place(i, 0.5)]).collect();
    let cells = (0..count).map(|i| {
        let a = 2 * i;
        // Where it closes the sides have changed places.
        let [c, d] = if i + 1 == count { [0, 1] } else { [a + 3, a + 2] };
        Cell::quadrangle([a, a + 1, c, d])
    });
    let sheet = Sheet { positions, cells: cells.collect() };
    Ok(sheet
        .cloud()
        .is_err_and(|error| error.contains("the sheet has one side only") && error.contains("cut it open")))
}

/// Two sheets five apart, one corner of the first loaded, so many of them clamped on one edge.
///
/// A sheet without support is named as moving freely in six ways; with supports the second one stays at rest.
fn apart(supported: usize) -> Result<bool, String> {
    let sheet = Sheet::square(SIDE, Vec3::zeros());
    let cloud = sheet.and(&Sheet::square(SIDE, Vec3::new(5.0, 0.0, 0.0))).cloud()?;
    let edge = |first: usize| (0..SIDE).map(|j| (first + j) as u32).collect();
    let supports = [0, SIDE * SIDE][..supported].iter();
    let supports = supports.map(|&first| Supported { particles: edge(first), support: Box::new(Clamped) });
    let force = Force { shares: vec![((SIDE * SIDE - 1) as u32, 1.0)], total: Vec3::z() };
    let body = shell(cloud, CELL, supports.collect(), vec![Box::new(force)])?;
    let mut system = StaticShell::new(body);
    match linear_response(&mut system, 0.0) {
        Ok(motion) => Ok(supported == 2 && motion.iter().all(|q| q.is_finite())),
        Err(error) => Ok(supported == 1
            && error.to_string().contains("6 free motions")
            && error.to_string().contains("support it")),
    }
}

/// Two squares whose edges coincide, as the lips of a slit; the error if a shell cannot be built on them.
fn lips(method: &str) -> Result<Option<String>, String> {
    let cloud = Sheet::square(SIDE, Vec3::zeros()).and(&Sheet::square(SIDE, Vec3::x())).cloud()?;
    Ok(shell(cloud, method, Vec::new(), Vec::new()).err())
}

/// A square without its middle cell, stretched alike in both directions: forces have to be the tractions of the edges,
/// those of the hole included, though a wide support reaches across it.
///
/// With the stretch λ, `N = Et/(1−ν) ½(λ²−1)` and the force on a particle is `λ N` times its edge normal.
fn hole(method: &str) -> Result<bool, String> {
    let mut sheet = Sheet::square(SIDE, Vec3::zeros());
    sheet.cells.remove(27);
    let cloud = sheet.cloud()?;
    let (normals, spacing) = (cloud.edge_normals.clone(), cloud.spacing());
    let mut body = shell(cloud, method, Vec::new(), Vec::new())?;
    let stretch = 1.001;
    for (a, x) in sheet.positions.iter().enumerate() {
        body.set_state(a, x * stretch, Vec3::z());
    }
    body.evaluate_internal(false);
    let force = YOUNG * THICKNESS / (1.0 - POISSON) * 0.5 * (stretch * stretch - 1.0) * stretch;
    let residual = (0..body.len()).map(|a| {
        let [x, y, z, ..] = body.internal_force(a);
        (Vec3::new(x, y, z) - normals[a] * force).norm() / (force * spacing)
    });
    // Divergence consistency is solved to 1e-9 of the spacing.
    Ok(residual.fold(0.0, f64::max) < 1e-7)
}

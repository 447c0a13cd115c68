//! Prints the linear figures of the finite-element shell against their references, over resolutions.

use benchmarks_ref::fe_shell::cases::*;
use nalgebra::Vector3;

fn show(name: &str, solved: Result<Solved, CaseError>, reference: &[f64]) {
    match solved {
        Ok(solved) => {
            let row = &solved.rows[0];
            let errors: Vec<String> = row
                .iter()
                .zip(reference)
                .map(|(v, r)| format!("{v:.6e} ({:+.2} %)", 100.0 * (v / r - 1.0)))
                .collect();
            println!(
                "{name:34} {:6} unknowns {:.3} s  {}",
                solved.unknowns,
                solved.seconds,
                errors.join("  ")
            );
        }
        Err(error) => println!("{name}: {error}"),
    }
}

fn main() {
    for n in [8, 16, 24] {
        println!("n = {n}");
        show("Scordelis-Lo", scordelis_lo(n), &[0.3024]);
        show("pinched cylinder", pinched_cylinder(n, 1.0), &[1.8248e-5]);
        show("pinched cylinder, graded 1.3", pinched_cylinder(n, 1.3), &[1.8248e-5]);
        show("hemisphere with hole", hemisphere_with_hole(n), &[0.0940, 0.0940]);
        for (thickness, force, references) in
            [(0.32, 1.0, [0.005424, 0.001754]), (0.0032, 1.0e-6, [0.005256, 0.001294])]
        {
            for (direction, reference) in [Vector3::z(), Vector3::y()].into_iter().zip(references) {
                let beam = TwistedBeam { thickness, direction, force };
                let name = format!("twisted beam {thickness} {}", if direction.z > 0.0 { "z" } else { "y" });
                show(&format!("{name} {n}x4"), twisted_beam(n, 4, &beam), &[reference]);
                show(&format!("{name} {n}x{n}"), twisted_beam(n, n, &beam), &[reference]);
            }
        }
    }
    for (edges, references) in [
        (
            PlateEdges::SimplySupported,
            [0.00406237, 0.00406237, 0.00406446, 0.00411498, 0.00427284, 0.00490431],
        ),
        (PlateEdges::Clamped, [0.00126534, 0.00126534, 0.00126785, 0.00132726, 0.00150463, 0.00217216]),
    ] {
        for (slenderness, reference) in [0.0001, 0.001, 0.01, 0.05, 0.1, 0.2].into_iter().zip(references) {
            show(&format!("{edges:?} {slenderness}"), plate_deflection(20, slenderness, edges), &[reference]);
        }
    }
    for (edges, slenderness, reference) in [
        (PlateEdges::SimplySupported, 0.001, [19.7391, 49.3475, 49.3476, 78.9557, 98.6942, 98.6943]),
        (PlateEdges::SimplySupported, 0.2, [17.4486, 38.1522, 38.1522, 55.1501, 65.1453, 65.1453]),
        (PlateEdges::Clamped, 0.001, [35.9847, 73.3922, 73.3923, 108.213, 131.576, 132.2]),
        (PlateEdges::Clamped, 0.1, [32.5243, 62.0386, 62.0386, 86.949, 102.434, 103.412]),
        (PlateEdges::Cantilever, 0.01, [3.47007, 8.48307, 21.2631, 27.149, 30.8572, 53.9553]),
        (PlateEdges::Cantilever, 0.2, [3.33932, 7.34791, 17.5725, 22.4683, 23.8883, 38.3428]),
        (PlateEdges::Free, 0.01, [13.4199, 19.5883, 24.2574, 34.6744, 34.6744, 61.0148]),
        (PlateEdges::Free, 0.2, [11.7011, 17.4002, 21.1936, 27.5735, 27.5735, 45.1045]),
    ] {
        for n in [20, 40] {
            show(
                &format!("{edges:?} {slenderness} n={n}"),
                plate_frequencies(n, slenderness, edges),
                &reference,
            );
        }
    }
}

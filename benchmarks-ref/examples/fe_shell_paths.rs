//! Prints the large-displacement figures of the finite-element shell.

use benchmarks_ref::fe_shell::cases::*;

fn show(name: &str, solved: Result<Solved, CaseError>, every: usize) {
    match solved {
        Ok(solved) => {
            println!(
                "{name}: {} nodes, {} unknowns, {} rows, {} iterations, {:.2} s; {:?}",
                solved.nodes,
                solved.unknowns,
                solved.rows.len(),
                solved.iterations,
                solved.seconds,
                solved.columns
            );
            for row in solved.rows.iter().step_by(every).chain(solved.rows.last()) {
                println!("   {}", row.iter().map(|v| format!("{v:12.5}")).collect::<Vec<_>>().join(" "));
            }
        }
        Err(error) => println!("{name}: {error}"),
    }
}

fn main() {
    let which: Vec<String> = std::env::args().skip(1).collect();
    let wanted = |name: &str| which.is_empty() || which.iter().any(|w| w == name);
    if wanted("ring") {
        show("ring", end_moment(&Strip::RING, [49, 4], 20), 5);
        show("thin ring", end_moment(&Strip::THIN_RING, [50, 1], 40), 10);
        show("end shear", end_shear(&Strip::END_SHEAR, [16, 1], 20), 5);
        show("end shear", end_shear(&Strip::END_SHEAR, [50, 4], 20), 5);
    }
    if wanted("panel") {
        for n in [8, 16] {
            show("panel 12.7", panel(n, 12.7, PanelSection::Isotropic, 30.0, 60), 6);
        }
        show("panel 6.35", panel_path(16, 6.35, PanelSection::Isotropic, 1000.0), 5);
    }
    if wanted("hemisphere") {
        show("hemisphere", hemisphere_with_hole_large(16, 20), 4);
    }
    if wanted("open") {
        show("open", open_cylinder([16, 24], 2.78, 80), 8);
    }
    if wanted("pinched") {
        show("pinched", pinched_cylinder_large([24, 24], 40.0, 40), 4);
    }
}

//! The range of the model: cells turned inside out, crushed or torn are named.

use crate::common::{energy_formulations, flat, free_shell};
use explicit_dynamics::{Bounds, Dynamics};
use implicit_statics::{Equilibrium, OutOfBounds};
use sph_shell::{Formulation, Reach, StaticShell};

const COUNTS: [usize; 2] = [9, 5];
const LENGTHS: [f64; 2] = [4.0, 2.0];

/// The plate with every particle at `x` moved to `to(x)`, directors left alone.
fn moved(formulation: Formulation, to: impl Fn([f64; 3]) -> [f64; 3]) -> Result<(), OutOfBounds> {
    let mut system = StaticShell::new(free_shell(flat(COUNTS, LENGTHS), formulation, 0.2));
    let mut state = system.save();
    for row in state.chunks_exact_mut(6) {
        let x = to([row[0], row[1], row[2]]);
        row[..3].copy_from_slice(&x);
    }
    system.restore(&state);
    let still = system.within_bounds();
    // Time looks at the same.
    assert_eq!(system.shell().within_bounds(Bounds::Configuration).is_ok(), still.is_ok());
    still
}

#[test]
fn mirrored_crushed_and_torn_plates_are_refused_by_every_formulation() {
    for (name, formulation) in energy_formulations() {
        let along = |stretch: f64| moved(formulation, |[x, y, z]| [stretch * x, y, z]);
        for sound in [0.11, 0.5, 1.0, 9.9] {
            assert_eq!(along(sound), Ok(()), "{name}: {sound}");
        }
        for (stretch, what, value) in
            [(-2.28, "area", -2.28), (0.09, "least", 0.09), (10.1, "greatest", 10.1)]
        {
            let found = along(stretch).expect_err(name);
            assert!(found.what.contains(what), "{name}: {found}");
            assert!((found.value - value).abs() < 1e-9, "{name}: {found}");
        }
        assert!(along(f64::NAN).is_err(), "{name}");
        // A turn by 180° about the normal mirrors nothing.
        assert_eq!(moved(formulation, |[x, y, z]| [-x, -y, z]), Ok(()), "{name}");
    }
}

#[test]
fn the_one_cell_that_is_turned_inside_out_is_named() {
    // The second line of particles is pushed through the first: only the cells between them turn over.
    let found = moved(Formulation::StressPoint(Reach::Cell), |[x, y, z]| {
        let through = (x - 0.5).abs() < 1e-9 && (y - 1.0).abs() < 0.6;
        [if through { -0.2 } else { x }, y, z]
    });
    let found = found.expect_err("a cell inside out");
    assert!(found.place.starts_with("cell ") && found.place.contains("at (0.25"), "{found}");
    assert!((found.value + 0.4).abs() < 1e-9, "{found}");
}

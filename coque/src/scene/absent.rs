//! Words that scenes do not know and users of other programs write: what coque does not do yet, and what it calls otherwise.
//!
//! One table. A feature that arrives takes its row out, which the test below asks for.

/// What is said of such a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Absent {
    /// Nothing here does it.
    NotYet {
        /// What is missing.
        feature: &'static str,
        /// What comes nearest, with its key.
        nearest: &'static str,
    },
    /// It is there by another name or in another place.
    Instead(&'static str),
}

use Absent::{Instead, NotYet};

/// A row: words, or beginnings of at least four letters; the tables where they mean this, none for all; what is said.
type Row = (&'static [&'static str], &'static [&'static str], Absent);

const ROWS: &[Row] = &[
    (
        &["plasticity", "elastoplastic", "yield", "hardening", "von_mises"],
        &["material", "elastic", "orthotropic"],
        Instead(
            "a shell that yields has [material.plastic], with `hardening = { linear = { yield-stress = 248.0 } }`, and so has a Galerkin solid; bonds do not yield",
        ),
    ),
    (
        &["johnson_cook", "cowper_symonds", "strain_rate"],
        &["material", "elastic", "orthotropic", "plastic"],
        Instead(
            "a shell in real time has `rate = { cowper-symonds = { reference = 40.0, exponent = 5.0 } }`, or `johnson-cook`, in [material.plastic]",
        ),
    ),
    (
        &["armstrong_frederick", "chaboche", "backstress", "kinematic_hardening"],
        &["material", "elastic", "orthotropic", "plastic"],
        Instead(
            "[material.plastic] has `kinematic`, linear, and of a shell `back-stresses = [{ modulus = 20000.0, recovery = 100.0 }]`, which recover",
        ),
    ),
    (
        &["creep"],
        &["material", "elastic", "orthotropic", "plastic"],
        NotYet {
            feature: "flow that depends on time at rest",
            nearest: "`rate` in [material.plastic] of a shell in real time",
        },
    ),
    (
        &["hyperelastic", "neo_hooke", "mooney", "ogden", "svk", "saint_venant"],
        &["material", "elastic"],
        Instead(
            "a shell of rubber has [material.rubber], with `law = { neo-hooke = { c1 = 0.5 } }`; solids have none",
        ),
    ),
    (
        &["viscoelastic", "prony", "maxwell", "kelvin"],
        &["material", "elastic"],
        NotYet {
            feature: "viscoelasticity",
            nearest: "damping in proportion to mass, `analysis.explicit.transient.damping`",
        },
    ),
    (
        &["thermal", "temperature", "convection", "conduction"],
        &[],
        Instead(
            "a shell or a solid is warmed by `temperature` of [[loads]] and conducts heat by [[heat]] with [analysis.heat], its material has `expansion`, `conductivity` and, for courses in time, `specific_heat`",
        ),
    ),
    (
        &["friction", "self_contact"],
        &[],
        NotYet {
            feature: "contact of solids with themselves, friction between solids at rest",
            nearest: "[[contact]] between two bodies or of a shell with itself, with `friction`; rigid [[tools]] that a body touches, with `friction` (coque new strip-over-drum, capstan); contact of a solid of bonds with its fragments and with planes, [bodies.NAME.solid.contact]; what stays \
                      joined is tied by [[ties]] or made rigid by [[rigid]]",
        },
    ),
    (
        &["failure", "tsai_wu", "tsai_hill", "hashin", "puck", "allowable"],
        &["material", "elastic", "orthotropic", "layered", "plies"],
        Instead(
            "a material of a shell has `strength`, and columns `of = \"reserve-factor\"`, `criterion = \"tsai-wu\"`, \"hashin\" or \"von-mises\", say how near it is to it; nothing weakens",
        ),
    ),
    (
        &["fracture", "crack", "cohesive", "delamination", "failure", "erosion", "damage"],
        &["", "shell", "elastic", "orthotropic", "material", "section", "homogeneous", "layered"],
        NotYet {
            feature: "fracture of shells",
            nearest: "a solid of bonds, [bodies.NAME.solid] with its `fracture` (coque new crack-branching)",
        },
    ),
    (
        &["thickness_change", "thinning", "thickness_stretch"],
        &["section", "homogeneous", "layered", "formulation"],
        NotYet {
            feature: "change of thickness",
            nearest: "a solid without elements, `formulation.galerkin` (coque new panel-solid)",
        },
    ),
    (
        &["beam", "truss", "rod", "bar", "cable", "frame"],
        &["geometry", "section", "", "bodies"],
        NotYet {
            feature: "beams and bars by themselves",
            nearest: "bars along lines of a shell, [[stiffeners]]; strips of shell joined by a mesh of several sheets or by [[ties]]; cables without a mass of their own, [[links]] with bears = \"tension\", and springs, `spring = { … }`",
        },
    ),
    (
        &["implicit", "newmark", "hht", "generalized_alpha", "generalised_alpha"],
        &["analysis"],
        NotYet {
            feature: "implicit steps in time",
            nearest: "[analysis.explicit.transient] in time, [analysis.static] at rest",
        },
    ),
    (
        &["spectrum", "random", "psd"],
        &["analysis"],
        Instead(
            "greatest answers to a spectrum are [analysis.response-spectrum], noise is [analysis.random-vibration]",
        ),
    ),
    (
        &["rayleigh", "stiffness_damping", "modal_damping", "structural_damping", "beta"],
        &["transient", "explicit", "quasi-static", "analysis", "elastic"],
        NotYet {
            feature: "damping in proportion to stiffness or by mode",
            nearest: "damping in proportion to mass, `analysis.explicit.transient.damping`",
        },
    ),
    (
        &["acceleration", "base_motion", "base_acceleration", "ground_motion"],
        &["supports", ""],
        Instead(
            "all that holds the bodies is accelerated by `analysis.explicit.transient.base = { acceleration = [9.81, 0, 0], amplitude = { record = … } }`; one set \
             alone moves by `moved` with an amplitude of the displacement",
        ),
    ),
    (
        &["mpc", "equation", "rbe3", "constraint"],
        &["", "supports", "shell"],
        NotYet {
            feature: "linear equations between degrees of freedom",
            nearest: "[[rigid]], [[ties]], or `spring = { …, to = \"set\" }`",
        },
    ),
    (
        &["rotated", "rotation", "orientation", "heel", "tilt", "angle"],
        &["box"],
        NotYet {
            feature: "boxes that stand askew",
            nearest: "of a set several boxes or `nearest`; of a rigid body a closed surface from a file, `geometry.mesh`, or a couple that heels it and is taken away, [[loads]] with `couple` and an `amplitude`",
        },
    ),
    (
        &["inflow", "inlet", "outflow", "outlet"],
        &[],
        Instead(
            "water comes in and goes out by `openings` of the fluid, as in openings = [{ at = [0, 0, 0], into = [1, 0, 0], velocity = 0.5 }] (coque examples \
             channel-with-inflow)",
        ),
    ),
    (
        &["surface_tension", "turbulence", "gas", "air", "second_fluid"],
        &["fluid", "liquid", "material", "weakly-compressible", "bodies"],
        NotYet {
            feature: "gases, surface tension and turbulence",
            nearest: "one liquid with a viscosity, `material.liquid.kinematic_viscosity`",
        },
    ),
    (
        &["fixed", "fix", "encastre", "built_in"],
        &["supports"],
        Instead("a clamped edge is `clamped = {}`; `hinged = {}` leaves its directors free"),
    ),
    (
        &["simply_supported", "simple", "pinned", "pin", "roller"],
        &["supports"],
        Instead(
            "an edge that may turn is `hinged = {}`; one that may slide as well names what it holds, `held = { displacement = \
             [[0, 0, 1]] }`",
        ),
    ),
    (
        &["ux", "uy", "uz", "displacement", "disp", "dof", "dofs"],
        &["supports"],
        Instead(
            "directions that do not move are `held = { displacement = [[0, 0, 1]] }`, a motion is `moved = { direction = [0, 0, \
             1], by = 0.1 }`",
        ),
    ),
    (
        &["velocity"],
        &["supports", "loads"],
        Instead(
            "a motion at a given speed is `moved = { direction = …, by = … }` with `amplitude = { table = [[0, 0], [1, 1]] }`; \
             what a body sets out with is its own `velocity = { linear = [0, 0, 1] }`",
        ),
    ),
    (
        &["initial_velocity", "initial_conditions"],
        &[],
        Instead("a body sets out with `velocity = { linear = [0, 0, 1] }` of its own, in transient runs"),
    ),
    (&["moment", "torque"], &["loads"], Instead("a moment is `couple = { moment = …, axis = [0, 1, 0] }`")),
    (
        &["point_load", "nodal_force", "concentrated", "total"],
        &["loads"],
        Instead(
            "a force on a set, or on a point by a set `{ nearest = [x, y, z] }`, is `force = { total = [0, 0, -1] }`",
        ),
    ),
    (
        &["body_force", "acceleration", "weight"],
        &["loads"],
        Instead("a force on all mass is `gravity`, an acceleration"),
    ),
    (
        &["e", "youngs_modulus", "modulus", "elastic_modulus"],
        &["elastic"],
        Instead("Young's modulus is `young`"),
    ),
    (&["nu", "v"], &["elastic"], Instead("Poisson's ratio is `poisson`")),
    (&["rho"], &["elastic", "orthotropic", "liquid"], Instead("mass by volume is `density`")),
    (
        &["frequency_response", "steady_state", "frf"],
        &["analysis"],
        Instead("steady vibration is [analysis.harmonic]"),
    ),
    (
        &["eigen", "frequency", "frequencies", "vibration", "natural_frequencies"],
        &["analysis"],
        Instead("modes of vibration are [analysis.modal]"),
    ),
    (&["riks", "arclength"], &["analysis"], Instead("paths through limit points are [analysis.arc-length]")),
    (
        &["nonlinear", "newton"],
        &["analysis"],
        Instead("equilibria at load levels by Newton's method are [analysis.static]"),
    ),
    (
        &["dynamic", "transient", "quasi"],
        &["analysis"],
        Instead(
            "motion in time is [analysis.explicit.transient], slow loading [analysis.explicit.quasi-static]",
        ),
    ),
    (
        &["boundary_conditions", "boundary", "bcs", "bc"],
        &[""],
        Instead("what holds or moves a set is a [[supports]]"),
    ),
    (
        &["rbe2", "rigid_body", "rigid_bodies"],
        &["", "supports"],
        Instead("a set that moves as one body is a [[rigid]]"),
    ),
    (
        &["mesh", "nodes", "elements"],
        &[""],
        Instead("a surface from a file is [geometry.mesh] with `file = \"…\"`"),
    ),
    (&["point_mass", "mass"], &["", "loads"], Instead("masses on sets are [[masses]]")),
];

/// What is said of a word that the table at `path` does not know; nothing where it knows one like it.
pub(super) fn absent(word: &str, path: &str, known: &[&str]) -> Option<Absent> {
    let word = plain(word);
    let place = path.rsplit('.').next().unwrap_or(path);
    let place = place.split('[').next().unwrap_or(place);
    let begins = |stem: &str| word == stem || (stem.len() >= 4 && word.starts_with(stem));
    let (stem, said) = ROWS.iter().find_map(|(words, places, said)| {
        let here = places.is_empty() || places.contains(&place);
        let stem = words.iter().find(|stem| here && begins(stem))?;
        Some((stem, *said))
    })?;
    (!known.iter().any(|known| plain(known) == *stem)).then_some(said)
}

/// A word as the table spells it.
fn plain(word: &str) -> String {
    word.to_lowercase().replace('-', "_")
}

/// What to write where a list stands in place of the table `path`.
pub(super) fn in_place_of_a_list(path: &str) -> &'static str {
    let place = path.rsplit('.').next().unwrap_or(path);
    match place {
        "section" => {
            "one section is [section.homogeneous]; those of parts stand in [[parts]], each with its `on`"
        }
        "material" => {
            "one material is [material.elastic]; those of parts stand in [[parts]], each with its `on`"
        }
        "velocity" => "write `velocity = { linear = [0, 0, 1] }`",
        _ => "write a table with its keys, as in { key = value }",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_feature_is_no_misspelt_word() {
        let feature = |word: &str, path: &str, known: &[&str]| match absent(word, path, known) {
            Some(NotYet { feature, .. }) => feature,
            other => panic!("{word}: {other:?}"),
        };
        assert_eq!(feature("creep", "material.elastic", &["young"]), "flow that depends on time at rest");
        assert!(matches!(
            absent("Plasticity", "bodies.strip.shell.material", &["elastic"]),
            Some(Instead(_))
        ));
        assert!(matches!(absent("yield-stress", "material.elastic", &["young"]), Some(Instead(_))));
        assert!(matches!(absent("johnson-cook", "material.plastic", &["rate"]), Some(Instead(_))));
        assert!(matches!(absent("failure", "material.orthotropic", &["strength"]), Some(Instead(_))));
        assert_eq!(feature("failure", "section", &["layered"]), "fracture of shells");
        assert_eq!(feature("implicit", "analysis", &["explicit"]), "implicit steps in time");
        assert!(matches!(absent("fixed", "supports[2]", &["clamped"]), Some(Instead(_))));
    }

    #[test]
    fn what_a_table_knows_is_misspelt_not_missing() {
        assert_eq!(absent("contacts", "bodies.bar.solid", &["contact", "cracks"]), None);
        assert_eq!(absent("yuong", "material.elastic", &["young"]), None);
        assert_eq!(absent("velocity", "", &["velocity"]), None);
    }

    /// Where a table of the words stands in a scene of the repository.
    fn stands(place: &str) -> Option<(&'static str, &'static str)> {
        Some(match place {
            "" => ("ring.toml", ""),
            "material" => ("ring.toml", "material."),
            "elastic" => ("ring.toml", "material.elastic."),
            "section" => ("ring.toml", "section."),
            "geometry" => ("ring.toml", "geometry."),
            "analysis" => ("ring.toml", "analysis."),
            "supports" => ("ring.toml", "supports[0]."),
            "loads" => ("ring.toml", "loads[0]."),
            "quasi-static" => ("ring.toml", "analysis.explicit.quasi-static."),
            "box" => ("floating-box.toml", "bodies.float.rigid.geometry.box."),
            "fluid" => ("dam-break.toml", "bodies.water.fluid."),
            "liquid" => ("dam-break.toml", "bodies.water.fluid.material.liquid."),
            _ => return None,
        })
    }

    /// What a scene answers to each word of the table: a feature that is there by now, or a word it knows, fails here.
    #[test]
    fn every_row_is_answered() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
        for (words, places, said) in ROWS {
            let places = if places.is_empty() { &[""] } else { *places };
            let (file, table) = places.iter().find_map(|place| stands(place)).unwrap();
            let text = std::fs::read_to_string(folder.join(file)).unwrap();
            for word in *words {
                let replaced = [(format!("{table}{word}"), "{}".to_string())];
                let error = crate::Scene::with_overrides(&text, file, &replaced).unwrap_err();
                let fault = error.fault();
                match said {
                    NotYet { feature, .. } => {
                        assert_eq!((error.code(), &*fault.value), ("scene::not-yet", *feature))
                    }
                    Instead(repair) => assert_eq!(fault.repair, *repair, "{table}{word}"),
                }
            }
        }
    }
}

//! A commented scene from three answers: what it is made of, what is asked, in which units.

mod shells;
mod texts;

/// What is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    Plate,
    Panel,
    Cylinder,
    Mesh,
    Bonds,
    Fluid,
    Galerkin,
}

/// What is asked of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    Equilibrium,
    LimitLoad,
    Modes,
    Buckling,
    Motion,
}

/// Unit of length; forces are in newtons, times in seconds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Length {
    Metre,
    Centimetre,
    Millimetre,
}

/// A choice that a person names by its word.
pub trait Choice: Copy + 'static {
    /// The word, and what it means.
    fn words(self) -> (&'static str, &'static str);
}

impl What {
    pub const ALL: [Self; 7] =
        [Self::Plate, Self::Panel, Self::Cylinder, Self::Mesh, Self::Bonds, Self::Fluid, Self::Galerkin];

    /// What can be asked; the first is the usual question.
    pub fn asked(self) -> &'static [Asked] {
        use Asked::{Buckling, Equilibrium, LimitLoad, Modes, Motion};
        match self {
            Self::Plate => &[Equilibrium, Modes, Buckling, Motion],
            Self::Panel => &[LimitLoad, Equilibrium, Modes, Motion],
            Self::Cylinder => &[Buckling, Equilibrium, Modes, Motion],
            Self::Mesh => &[Equilibrium, Modes, Motion],
            Self::Bonds => &[Motion, Equilibrium, Modes],
            Self::Fluid => &[Motion],
            Self::Galerkin => &[Equilibrium, Modes],
        }
    }
}

impl Choice for What {
    fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Plate => ("plate", "a thin flat shell"),
            Self::Panel => ("panel", "a thin shallow curved shell"),
            Self::Cylinder => ("cylinder", "a thin tube"),
            Self::Mesh => ("mesh", "a thin shell from a file of Gmsh, Abaqus, STL, OBJ, VTU"),
            Self::Bonds => ("bonds", "a solid of bonds, which can break"),
            Self::Fluid => ("fluid", "water in a tank"),
            Self::Galerkin => ("galerkin", "a thick solid that does not break"),
        }
    }
}

impl Choice for Asked {
    fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Equilibrium => ("equilibrium", "how far it gives under its load"),
            Self::LimitLoad => ("limit", "the load at which it snaps through, and what comes after"),
            Self::Modes => ("modes", "its frequencies and modes"),
            Self::Buckling => ("buckling", "the loads at which it buckles, linearised"),
            Self::Motion => ("motion", "how it moves in time"),
        }
    }
}

impl Length {
    pub const ALL: [Self; 3] = [Self::Metre, Self::Millimetre, Self::Centimetre];

    /// Units of length in a metre.
    fn in_a_metre(self) -> f64 {
        match self {
            Self::Metre => 1.0,
            Self::Centimetre => 100.0,
            Self::Millimetre => 1000.0,
        }
    }
}

impl Choice for Length {
    fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Metre => ("m", "metre, newton, second, so kilogrammes"),
            Self::Centimetre => ("cm", "centimetre, newton, second, so hundreds of kilogrammes"),
            Self::Millimetre => ("mm", "millimetre, newton, second, so tonnes"),
        }
    }
}

/// A scene to be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Starter {
    pub what: What,
    pub asked: Asked,
    pub length: Length,
}

impl Starter {
    /// Its name, as of a file without an ending.
    pub fn name(self) -> String {
        format!("{}-{}", self.what.words().0, self.asked.words().0)
    }

    /// The scene, as text that goes into a file of this name.
    pub fn scene(self, file: &str) -> String {
        let Self { what, asked, length } = self;
        let unit = length.words().0;
        let mass = match length {
            Length::Metre => "",
            Length::Centimetre => "   # mass in 100 kg",
            Length::Millimetre => "   # mass in tonnes",
        };
        let title = texts::title(what, asked);
        let head = format!(
            "# {title}. All of it is there to be changed; `coque list` says what else a scene may name.\n#\n\
             #   coque check {file}           what it models, what a run will cost\n\
             #   coque run {file} --view      runs it and shows it in the browser\n\n\
             title = \"{title}\"\nunits = {{ length = \"{unit}\", force = \"N\", time = \"s\" }}{mass}\n"
        );
        let parts = [texts::body(what, asked), texts::conditions(what, asked), texts::analysis(what, asked)];
        let text = parts.map(|part| in_units(part, length.in_a_metre())).join("\n");
        format!(
            "{head}\n{text}\n[output]\nfields = {{ stresses = true }}   # frames, for the browser and ParaView\n"
        )
    }
}

/// Quantities with their power of the length: `L(1.0)` a length in metres, or what is one by a time or its square, `P(1.0)` a
/// pressure in N/m², `D(1.0)` a density in kg/m³, `G(1.0)` an energy by area in N/m.
const QUANTITIES: [(&str, i32); 4] = [("L(", 1), ("P(", -2), ("D(", -4), ("G(", -1)];

/// A text with its quantities in units of so many in a metre.
fn in_units(text: &str, in_a_metre: f64) -> String {
    let mut done = text.to_owned();
    for (mark, power) in QUANTITIES {
        let mut parts = done.split(mark);
        let mut next = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let (number, rest) = part.split_once(')').unwrap_or((part, ""));
            let number: f64 = number.parse().unwrap_or(f64::NAN);
            next += &written(number * in_a_metre.powi(power));
            next += rest;
        }
        done = next;
    }
    done
}

/// A number as a person writes it.
fn written(x: f64) -> String {
    let rounded: f64 = format!("{x:.9e}").parse().unwrap_or(x);
    match rounded.abs() {
        0.0 => "0.0".into(),
        size if (1e-3..1e6).contains(&size) => format!("{rounded:?}"),
        _ => format!("{rounded:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Scene, Silent};

    fn starters() -> impl Iterator<Item = Starter> {
        let of = |what: What| {
            let with = move |asked: &Asked| Length::ALL.map(|length| Starter { what, asked: *asked, length });
            what.asked().iter().flat_map(with)
        };
        What::ALL.into_iter().flat_map(of)
    }

    #[test]
    fn every_combination_is_a_scene_without_a_warning() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/meshes/");
        for starter in starters() {
            let text = starter.scene("new.toml");
            let scene = Scene::parse(&text, &format!("{folder}new.toml"));
            let scene = scene.unwrap_or_else(|error| panic!("{starter:?}: {error}\n{text}"));
            let model = scene.build(1).unwrap_or_else(|error| panic!("{starter:?}: {error}\n{text}"));
            let said: Vec<_> = model.warnings().iter().map(|warning| &warning.message).collect();
            assert!(said.is_empty(), "{starter:?}: {said:?}");
        }
    }

    #[test]
    fn units_change_no_answer() {
        let deflection = |length: Length| {
            let starter = Starter { what: What::Plate, asked: Asked::Equilibrium, length };
            let set = [("analysis.static.levels".into(), "1".into())];
            let scene = Scene::with_overrides(&starter.scene("plate.toml"), "plate.toml", &set).unwrap();
            let outcome = scene.build(1).unwrap().run(&mut Silent);
            outcome.curve.column("w").unwrap().pop().unwrap() / length.in_a_metre()
        };
        let [metres, millimetres, centimetres] = Length::ALL.map(deflection);
        // A clamped square plate under this pressure, small deflections: .00126 p a⁴/D, D = E t³/12(1 − ν²).
        let plate = 0.00126 * 2000.0 / (2.1e11 * 1e-6 / (12.0 * 0.91));
        assert!((metres / plate - 1.0).abs() < 0.01, "{metres} over {plate}");
        // The same equations in other units, solved to 1e-9.
        assert!((millimetres / metres - 1.0).abs() < 1e-8 && (centimetres / metres - 1.0).abs() < 1e-8);
    }

    #[test]
    fn numbers_are_written_short() {
        let said = [0.01, 2.1e11, 7.85e-9, 1000.0, 0.1 + 0.2, 0.0].map(written);
        assert_eq!(said, ["0.01", "2.1e11", "7.85e-9", "1000.0", "0.3", "0.0"]);
        assert_eq!(in_units("a = L(0.5), P(2.1e11) D(7850)", 1000.0), "a = 500.0, 210000.0 7.85e-9");
    }
}

//! gate-alone: the elastic gate without water, by a shell and by bonds: how stiff and how heavy it is.

use benchmarks_ref::fluid_structure_forms::GATE;
use benchmarks_ref::reference;

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::{PAIRWISE, STATE, STATIC};
use crate::support::studies::off;
use crate::{JudgeError, Metric};

const SHELL: &str = include_str!("gate-alone.toml");
const BONDS: &str = include_str!("gate-of-bonds.toml");
const PRESSURE: f64 = 10.0;
/// Layers of nodes that are held beyond the clamp.
const HELD: f64 = 3.0;

const NAME: &str = "tip";
const FREQUENCY: &str = "frequency";
const SHEARED: &str = "tip, with shear";

/// The scenes, their closed forms, and how far they may differ.
pub fn case() -> Case {
    Case {
        name: "gate-alone",
        title: "Elastic gate without water: stiffness and frequency",
        about: "Deflection of the end under uniform pressure over q L⁴/8D, and first frequency over that of a slender \
                cantilever in plane strain; three percent is asked of a gate before water is let at it. A strip of shell \
                meets it with any spacing. Bonds bend too easily where they are few across: beside them bonds whose modulus \
                is raised by what the table of strips says is lost in bending.",
        citation: "cantilever, closed form; gate of Antoci, Gallati and Sibilla 2007; strips: Silling and Askari 2005, summed",
        variants: variants(),
        headline: Some(Headline::new(NAME, 0.05)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let mut variants = Vec::new();
    for n in [11, 21, 41] {
        let tip = Variant::new(STATIC, SHELL, "plate", [n, 3]).on("pressed").usual_if(n == 21);
        variants.push(tip.quick().judged(|run, _| pressed_shell(run)));
        let swung =
            Variant::new(STATIC, SHELL, "plate", [n, 3]).on("swinging").set("analysis.modal.modes", 1);
        variants.push(swung.quick().judged(|run, _| {
            let reason =
                "three percent; shear and the turning of the sections are left out of the closed form: .4 %";
            Ok(vec![Metric::error(FREQUENCY, swinging(run)?, "%").within(3.0, reason)])
        }));
    }
    for kind in [Kind::Even, Kind::Factor, Kind::Pairwise, Kind::Raised] {
        for layers in [5, 10] {
            let tip = gate_of_bonds(kind, layers, "pressed");
            variants.push(tip.judged(move |run, _| Ok(bonds(NAME, tip_off(run)?, kind, layers))));
            let swung = gate_of_bonds(kind, layers, "swinging").set("analysis.modal.modes", 1);
            variants.push(swung.judged(move |run, _| Ok(bonds(FREQUENCY, swinging(run)?, kind, layers))));
        }
    }
    variants
}

/// What carries the gate of bonds, and how its weights are corrected.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Bonds that feel the dilatation, weights exact for uniform strains.
    Even,
    /// The same with one factor a bond.
    Factor,
    /// Bonds alone with one factor a bond; the modulus is that of the same bending stiffness at ν = 1/4.
    Pairwise,
    /// The same with the modulus raised by what strips of so many layers lose.
    Raised,
}

impl Kind {
    fn method(self) -> &'static str {
        if matches!(self, Self::Even | Self::Factor) { STATE } else { PAIRWISE }
    }

    fn words(self) -> &'static str {
        match self {
            Self::Even => "",
            Self::Factor | Self::Pairwise => ", energy factor",
            Self::Raised => ", energy factor, modulus raised",
        }
    }
}

fn gate_of_bonds(kind: Kind, layers: usize, what: &str) -> Variant {
    let spacing = GATE.thickness / layers as f64;
    let beyond = HELD * spacing;
    let body = "bodies.gate.solid";
    let variant = Variant::scene(kind.method(), BONDS, format!("{layers} layers{}, {what}", kind.words()))
        .set(&format!("{body}.geometry.block.spacing"), spacing)
        .set(
            &format!("{body}.geometry.block.lengths"),
            format!("[{}, {}]", GATE.length + beyond, GATE.thickness),
        )
        .set(&format!("{body}.geometry.block.origin"), format!("[{}, {}]", -beyond, -0.5 * GATE.thickness))
        .set("sets.clamp.layer.depth", beyond)
        .quick();
    match kind {
        Kind::Even => variant,
        Kind::Factor => variant.set(&format!("{body}.formulation.state-based.correction"), "energy-factor"),
        Kind::Pairwise | Kind::Raised => {
            // The same bending stiffness E/(1 − ν²) at ν = 1/4.
            let kept = GATE.young * (1.0 - 0.0625) / (1.0 - GATE.poisson * GATE.poisson);
            let lost = if kind == Kind::Raised { bending_ratio(layers) } else { 1.0 };
            variant
                .set(
                    &format!("{body}.formulation"),
                    "{ bond-based = { plane = \"strain\", correction = \"energy-factor\" } }",
                )
                .set(&format!("{body}.material.elastic.poisson"), 0.25)
                .set(&format!("{body}.material.elastic.young"), kept / lost)
        }
    }
}

/// Bending stiffness of a strip of so many layers over what it should be, partial volumes and one factor a bond; one
/// where the table has no such strip.
fn bending_ratio(layers: usize) -> f64 {
    let find = || {
        let table = reference("pd_strip_bending").ok()?;
        let row = table.rows.iter().position(|row| {
            let text = |column: usize, word: &str| row[column].as_str() == Some(word);
            let is = |column: usize, value: f64| row[column].as_f64() == Some(value);
            text(0, "energy-based") && text(1, "pv") && is(2, 3.015) && is(3, layers as f64)
        })?;
        table.number(row, "bending_ratio").ok()
    };
    find().unwrap_or(1.0)
}

/// How far the tip is off the closed form without shear \[%\].
fn tip_off(run: &Run) -> Result<Option<f64>, JudgeError> {
    Ok(off(run.last("tip")?.map(|tip| tip / GATE.cantilever_tip(PRESSURE))))
}

fn pressed_shell(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let whole = GATE.cantilever_tip(PRESSURE) + GATE.cantilever_shear(PRESSURE);
    let sheared = off(run.last("tip")?.map(|tip| tip / whole));
    Ok(vec![
        Metric::error(NAME, tip_off(run)?, "%").within(3.0, "three percent; what shear adds is .53 % of it"),
        Metric::error(SHEARED, sheared, "%").within(
            1e-6,
            "the strip is exact at its particles under uniform pressure: round-off, 5e-10 % measured",
        ),
    ])
}

/// How far the first frequency is off that of a slender cantilever \[%\].
fn swinging(run: &Run) -> Result<Option<f64>, JudgeError> {
    let found = run.column("frequency")?.first().copied();
    Ok(off(found.map(|frequency| frequency / GATE.cantilever_frequency())))
}

/// What few layers make of the gate \[%\]: tip and frequency, more being positive.
const KNOWN: [(Kind, usize, [f64; 2]); 6] = [
    (Kind::Even, 5, [21.15, -9.59]),
    (Kind::Even, 10, [7.92, -4.01]),
    (Kind::Factor, 5, [4.15, -2.49]),
    (Kind::Factor, 10, [-4.12, 1.83]),
    (Kind::Pairwise, 5, [13.89, -6.77]),
    (Kind::Pairwise, 10, [1.31, -0.94]),
];

/// Three percent of gates whose modulus is raised; of others that they stay what they are.
fn bonds(name: &'static str, off: Option<f64>, kind: Kind, layers: usize) -> Vec<Metric> {
    let found = Metric::error(name, off, "%");
    let Some((_, _, known)) = KNOWN.iter().find(|row| (row.0, row.1) == (kind, layers)) else {
        let reason = "three percent; about 2 % is left: the clamp stands up to half a spacing behind the face, 2.6 % at \
                      five layers and 1.3 % at ten, and shear .5 %";
        return vec![found.within(3.0, reason)];
    };
    let known = if name == NAME { known[0] } else { known[1] };
    let notice = "a tenth of itself: a figure to notice a change by";
    vec![
        found.shown(
            "strips of few layers bend too easily or too little, as the exact sums of the table of strips do",
        ),
        Metric::compared(format!("{name}, as known"), off, "%", known).within(0.1 * known.abs(), notice),
    ]
}

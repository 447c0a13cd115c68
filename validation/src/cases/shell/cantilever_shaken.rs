//! cantilever-shaken: the transfer function of a cantilever over its first three modes of bending, its clamp shaken and its end pushed.
//!
//! ```text
//!  ▐━━━━━━━━━━━━   z(t) = Re[z exp(iωt)]      K (1 + iη)
//!  ↕            ↕ w
//! ```

use benchmarks_ref::shaken_beam::ShakenBeam;
use implicit_statics::Complex;

use crate::judge::{Case, Headline, Measured, Run, Runs, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/cantilever-shaken.toml");
const WORST: &str = "worst of all frequencies";
/// Frequencies beside one, over it, whose amplitudes are a measure of it: at some the end all but stands still.
const BESIDE: [f64; 2] = [0.95, 1.05];
const PEAK: &str = "worst of three peaks";

/// As in the scene; ν = 0, 5/6 of the shear stiffness.
pub(super) const BEAM: ShakenBeam = ShakenBeam {
    young: 210e9,
    shear: 210e9 / 2.0 * 5.0 / 6.0,
    density: 7850.0,
    length: 0.5,
    width: 0.05,
    thickness: 0.005,
    loss: 0.04,
};

/// Errors \[%\].
#[rustfmt::skip] // a paragraph a method
const ALL: Measured = Measured(&[
    (STATIC, &[("81×5 in modes", 2.41), ("201×5 in modes", 0.362), ("201×5 pushed", 0.363), ("81×5 directly", 0.648)]),
]);
#[rustfmt::skip]
const PEAKS: Measured = Measured(&[
    (STATIC, &[("81×5 in modes", 0.435), ("201×5 in modes", 0.066), ("201×5 pushed", 0.058), ("81×5 directly", 1.08)]),
]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    let fine = |name: &str| {
        Variant::scene(STATIC, SCENE, "201×5").set("geometry.plate.particles", "[201, 5]").on(name)
    };
    let pushed = "{ frequencies = { from = 5.0, to = 500.0, points = 401, spacing = \"logarithmic\" }, modes = 12, damping.structural = 0.04 }";
    let directly = "{ frequencies = { from = 5.0, to = 500.0, points = 41, spacing = \"logarithmic\" }, damping.structural = 0.04, \
                    base.acceleration = [0.0, 0.0, 1.0] }";
    let shaken = |run: &Run, _: &Runs| judged(run, |omega| BEAM.relative(omega));
    Case {
        name: "cantilever-shaken",
        title: "A cantilever that is shaken",
        about: "Amplitude and phase of the end of a strip from 5 to 500 Hz, over three modes of bending: where its clamp is shaken, with respect to the \
                clamp, and where a force pushes the end; in twelve modes and one shape more, and by a factor at each frequency. Beside the worst frequency the three \
                peaks.",
        citation: "[timoshenko1921], with complex moduli: the transfer functions of a clamped beam in closed form",
        variants: vec![
            Variant::scene(STATIC, SCENE, "81×5").on("in modes").judged(shaken),
            fine("in modes").judged(shaken),
            fine("pushed")
                .set("analysis", format!("{{ harmonic = {pushed} }}"))
                .set("loads", "[{ on = \"u1\", force = { total = [0.0, 0.0, 1.0] } }]")
                .judged(|run: &Run, _: &Runs| judged(run, |omega| BEAM.receptance(omega))),
            Variant::scene(STATIC, SCENE, "81×5")
                .on("directly")
                .set("analysis", format!("{{ harmonic = {directly} }}"))
                .judged(shaken),
        ],
        headline: Some(Headline::new(WORST, 0.5)),
        ..Case::default()
    }
}

fn judged(run: &Run, of: impl Fn(f64) -> Complex) -> Result<Vec<Metric>, JudgeError> {
    let [omega, tip, phase] = ["circular_frequency", "tip", "tip_phase"].map(|name| run.column(name));
    let (omega, tip, phase) = (omega?, tip?, phase?);
    let (mut worst, mut peaks) = (0.0_f64, 0.0_f64);
    for (i, &omega) in omega.iter().enumerate() {
        let exact = of(omega);
        let (sin, cos) = libm::sincos(phase[i]);
        let found = Complex::new(tip[i] * cos, tip[i] * sin);
        let size = BESIDE.iter().fold(exact.amplitude(), |most, by| most.max(of(by * omega).amplitude()));
        worst = worst.max((found + exact * -1.0).amplitude() / size);
        if i > 0 && i + 1 < tip.len() && tip[i] > tip[i - 1] && tip[i] > tip[i + 1] {
            peaks = peaks.max((tip[i] / exact.amplitude() - 1.0).abs());
        }
    }
    let percent = |value: f64| run.done().then_some(100.0 * value);
    let reason = "three times the errors of the lattice: a frequency that is off by a part ε is off by ε over half of the loss factor at the flank of its peak";
    Ok(vec![
        Metric::error(WORST, percent(worst), "%").near(ALL.of(run)?, reason),
        Metric::error(PEAK, percent(peaks), "%").near(PEAKS.of(run)?, reason),
    ])
}

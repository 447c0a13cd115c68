//! What a section goes through: dissipation, cycles, commits of the same strains, thinning, the share that flows.

use std::sync::Arc;

use shell_kinematics::{Hardening, HistoryPack, Memory, Pack, Plastic, PlasticSection, Section, Strains};

use crate::common::*;

/// No lane of ten thousand random walks ever gives dissipated work back.
#[test]
fn dissipation_never_falls() {
    let mut random = Random(29);
    for round in 0..2500 {
        let (_, hardening) = hardenings().swap_remove(round % 6);
        let modulus = if round % 2 == 0 { 0.0 } else { 1000.0 };
        let material = Plastic::new(elastic(), hardening).kinematic(modulus).unwrap();
        let mut specimen = Specimen::new(PlasticSection::new(material, THICKNESS, 4).unwrap());
        let mut now = Strains::default();
        let mut before = Pack::ZERO;
        for _ in 0..8 {
            let size = random.size(1e-4, 1e-2);
            now = plus(&now, &random.strains(size, size), 1.0);
            specimen.commit(&now);
            let dissipated = specimen.section.tallies(&specimen.history).dissipated();
            for (now, before) in dissipated.lanes().into_iter().zip(before.lanes()) {
                assert!(now >= before, "{now} {before}");
            }
            before = dissipated;
        }
        assert!(most(before) > 0.0);
    }
}

/// Elastic energy, what hardening stores and what is dissipated are all of the work.
#[test]
fn the_work_is_stored_or_dissipated() {
    let mut specimen = Specimen::new(section(Hardening::voce(YIELD, 200.0, 12.0).unwrap(), 6));
    let now = membrane([0.01, 0.002, 0.004]);
    let work = specimen.section.energy_from(&now, &specimen.history);
    specimen.commit(&now);
    let tallies = specimen.section.tallies(&specimen.history);
    let force = specimen.resultants(&now).membrane.map(|n| first(n) / THICKNESS);
    let [s, t, u] = force;
    let elastic =
        0.5 * THICKNESS / YOUNG * (s * s + t * t - 2.0 * POISSON * s * t + 2.0 * (1.0 + POISSON) * u * u);
    let sum = elastic + first(tallies.hardened()) + first(tallies.dissipated());
    assert!((sum / first(work) - 1.0).abs() < 1e-13, "{sum} {}", first(work));
    let alpha = first(tallies.plastic_strain());
    let voce = 200.0 * (alpha - (1.0 - libm::exp(-12.0 * alpha)) / 12.0) * THICKNESS;
    assert!((first(tallies.hardened()) / voce - 1.0).abs() < 1e-12);
    assert!((first(tallies.dissipated()) / (YIELD * alpha * THICKNESS) - 1.0).abs() < 1e-13);
}

/// Bent between ± ten yield curvatures, a strip with linear kinematic hardening comes back to the same moments from the second cycle on.
#[test]
fn a_cycle_of_kinematic_hardening_closes() {
    let mut specimen = strip(10, 0.0, 0.05);
    let [moment, curvature] = first_yield();
    let mut now = Strains::default();
    let mut moments = Vec::new();
    for cycle in 0..4 {
        for step in 0..80 {
            let way = match step {
                0..20 => f64::from(step),
                20..60 => 40.0 - f64::from(step),
                _ => f64::from(step) - 80.0,
            };
            now.curvature[0] = Pack::splat(way / 2.0 * curvature);
            specimen.commit(&now);
            if cycle > 1 {
                moments.push(first(specimen.resultants(&now).moment[0]) / moment);
            }
        }
    }
    let (one, two) = moments.split_at(80);
    let worst = one.iter().zip(two).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    println!("{worst:.1e}, moment at the turn {:.4}", one[20]);
    // Found to the last bit.
    assert!(worst < 1e-12, "{worst:.1e}");
}

/// Committed again at the same strains, a history without bending is the same but for rounding; one with bending moves by the change of F, less each time.
#[test]
fn a_second_commit_changes_little() {
    for (_, hardening) in hardenings() {
        let mut random = Random(31);
        for _ in 0..20 {
            let mut specimen = Specimen::new(section(hardening.clone(), 6));
            let now = random.strains(0.01, 0.0);
            specimen.commit(&now);
            let once = specimen.history.clone();
            specimen.commit(&now);
            // χ is that of the last step, in which nothing flowed but by rounding.
            let kept = specimen.section.tallies(&specimen.history).kept_share();
            assert!(most(kept - Pack::splat(1.0)) < 1e-12);
            let shared = once.len() - 1;
            let scale = YOUNG.sqrt();
            for (a, b) in once[..shared].iter().zip(&specimen.history[..shared]) {
                assert!(most(*a - *b) < 1e-14 * scale);
            }
            let bent = random.strains(0.01, 0.02);
            let mut moved = Vec::new();
            for _ in 0..3 {
                let before = specimen.section.tallies(&specimen.history).thickness();
                specimen.commit(&bent);
                moved.push(most(specimen.section.tallies(&specimen.history).thickness() - before));
            }
            assert!(moved[2] < 0.1 * moved[1] + 1e-12, "{moved:?}");
        }
    }
}

/// Stretched to λ, a bent sheet has the lever arm λ₃ and the curvature per present length: the strain at a height is `h + zλ₃U⁻¹K`.
#[test]
fn a_stretched_sheet_bends_about_its_present_thickness() {
    let mut specimen = Specimen::new(linear(0.0, 6));
    let stretched = membrane([0.2, 0.1, 0.06]);
    specimen.commit(&stretched);
    let lambda = first(specimen.section.tallies(&specimen.history).thickness());
    // Elastic from here: unloaded a little, then a curvature; M = Fᵀ (t³/12) C F K by hand.
    let eased = plus(&stretched, &membrane([1e-4, 1e-4, 0.0]), -1.0);
    let k = [3e-4, -1e-4, 2e-4];
    let with = plus(&eased, &bent(k), 1.0);
    let (with, without) = (specimen.resultants(&with).moment, specimen.resultants(&eased).moment);
    let found: [f64; 3] = std::array::from_fn(|i| first(with[i] - without[i]));
    let h = nalgebra::Matrix2::new(0.2, 0.03, 0.03, 0.1);
    let eigen = h.symmetric_eigen();
    let inverse = eigen.eigenvectors
        * nalgebra::Matrix2::from_diagonal(&eigen.eigenvalues.map(|v: f64| libm::exp(-v)))
        * eigen.eigenvectors.transpose();
    let tensor = nalgebra::Matrix2::new(k[0], 0.5 * k[2], 0.5 * k[2], k[1]);
    let sym = |m: nalgebra::Matrix2<f64>| (m + m.transpose()) * 0.5;
    let strain = sym(inverse * tensor) * lambda;
    let c = YOUNG / (1.0 - POISSON * POISSON) * THICKNESS.powi(3) / 12.0;
    let trace = strain.trace();
    let stress = (strain * (1.0 - POISSON) + nalgebra::Matrix2::identity() * (POISSON * trace)) * c;
    let back = sym(inverse * stress) * lambda;
    for (found, exact) in found.into_iter().zip([back[(0, 0)], back[(1, 1)], back[(0, 1)]]) {
        assert!((found - exact).abs() < 1e-12 * c * 1e-4, "{found} {exact}");
    }
    // −ν/E (σ11 + σ22) − tr εp, by the forces: incompressible flow, so that h less the elastic strain is what thins.
    let force = specimen.resultants(&stretched).membrane.map(|n| first(n) / THICKNESS);
    let elastic = (1.0 - POISSON) / YOUNG * (force[0] + force[1]);
    let log = -POISSON / YOUNG * (force[0] + force[1]) - (0.3 - elastic);
    assert!((libm::log(lambda) - log).abs() < 1e-14);
}

/// χ by hand, from what each slice flowed: γ = 3Δα/2K, p = (E/3(1−ν) + 4G)/3, and the mean by z². One at rest and unloaded, .02 at least.
#[test]
fn the_kept_share_is_the_mean_of_what_slices_keep() {
    let mut specimen = Specimen::new(linear(2000.0, 6));
    let share = |s: &Specimen| first(s.section.tallies(&s.history).kept_share());
    let yielded = |s: &Specimen| first(s.section.tallies(&s.history).yielded_share());
    assert_eq!((share(&specimen), yielded(&specimen)), (1.0, 0.0));
    let p = (YOUNG / (3.0 * (1.0 - POISSON)) + 2.0 * YOUNG / (1.0 + POISSON)) / 3.0;
    // Heights (t/2)(5, 3, 1)/√35: the outer yields first, at a strain of σ_y(1−ν²)/E/√(1−ν+ν²) and more.
    let outer = 0.5 * THICKNESS * 5.0 / 35.0_f64.sqrt();
    let strain = YIELD * (1.0 - POISSON * POISSON) / YOUNG / (1.0 - POISSON + POISSON * POISSON).sqrt();
    let mut before = [0.0; 6];
    for (factor, flowed) in [(1.1, 1.0 / 3.0), (1.5, 1.0 / 3.0), (3.0, 2.0 / 3.0)] {
        specimen.commit(&bent([factor * strain / outer, 0.0, 0.0]));
        let mut kept = 0.0;
        for (slice, before) in before.iter_mut().enumerate() {
            let alpha = first(specimen.history[4 * slice + 3]);
            let gamma = 1.5 * (alpha - *before) / (YIELD + 2000.0 * alpha);
            let z = (2 * slice) as f64 - 5.0;
            kept += z * z / 70.0 / (1.0 + p * gamma);
            *before = alpha;
        }
        assert!((share(&specimen) - kept).abs() < 1e-9 && kept < 0.95, "{} {kept}", share(&specimen));
        assert!((yielded(&specimen) - flowed).abs() < 1e-14);
    }
    specimen.commit(&bent([300.0 * strain / outer, 0.0, 0.0]));
    assert!((share(&specimen) - 0.02).abs() < 1e-15 && (yielded(&specimen) - 1.0).abs() < 1e-14);
    specimen.commit(&bent([299.5 * strain / outer, 0.0, 0.0]));
    assert_eq!((share(&specimen), specimen.section.history_len()), (1.0, 32));
}

/// Two sheets that flow alike but for a shear force: a step leaves 1/(1 + 2Gγ) of it, whatever the size of the step, and nothing of a
/// difference square to the yield surface.
#[test]
fn a_stress_beside_the_surface_decays_with_the_flow() {
    let mut worst = 0.0_f64;
    for step in [1e-5, 1e-4, 1e-3] {
        let [mut one, mut other] = [0, 1].map(|_| Specimen::new(linear(0.0, 2)));
        let sheared = |e: f64| membrane([e, -0.5 * e, 1e-8]);
        let straight = |e: f64| membrane([e, -0.5 * e, 0.0]);
        one.commit(&straight(0.01));
        other.commit(&sheared(0.01));
        let shear = |s: &Specimen, e: f64| first(s.resultants(&sheared(e)).membrane[2]);
        let along = |s: &Specimen, at: &Strains| first(s.resultants(at).membrane[0]);
        let (before, alpha) = (shear(&other, 0.01), first(other.history[3]));
        other.commit(&sheared(0.01 + step));
        one.commit(&straight(0.01 + step));
        let gamma = 1.5 * (first(other.history[3]) - alpha) / YIELD;
        let kept = 1.0 / (1.0 + YOUNG / (1.0 + POISSON) * gamma);
        worst = worst.max((shear(&other, 0.01 + step) / before / kept - 1.0).abs());
        let apart = along(&one, &straight(0.01 + step)) - along(&other, &sheared(0.01 + step));
        assert!(apart.abs() < 1e-10 * YIELD, "{apart:.1e}");
    }
    println!("{worst:.1e}");
    // 1.1e-15: rounding.
    assert!(worst < 5e-15, "{worst:.1e}");
}

/// What strains meet once they are committed is reported by the commit, and is what an evaluation finds, but for rounding and what the third step of
/// the return map leaves.
#[test]
fn a_commit_reports_what_its_strains_meet() {
    let mut worst = 0.0_f64;
    for (name, hardening) in hardenings() {
        let mut random = Random(83);
        let section: Arc<dyn Section> = Arc::new(section(hardening, 6));
        for _ in 0..50 {
            let mut pack = HistoryPack::new(section.clone());
            for _ in 0..3 {
                let now = random.strains(0.01, 0.02);
                pack.commit(&now);
                let reported = forces(&pack.resultants(&now));
                let numbers: Vec<f64> = pack.numbers().collect();
                let mut apart = HistoryPack::new(section.clone());
                apart.take_up(&numbers);
                // Strains that differ from the committed ones by rounding meet the law itself.
                let near = plus(&now, &now, 1e-15);
                for (i, (a, b)) in reported.into_iter().zip(forces(&apart.resultants(&near))).enumerate() {
                    let off = most(a - b) / sizes()[i];
                    worst = worst.max(off);
                    assert!(off < 1e-9, "{name}: {off:.1e}");
                }
            }
        }
    }
    println!("{worst:.1e}");
}

/// A history taken up from its numbers goes on to the same bits; evaluations and a second commit leave it alone.
#[test]
fn a_history_taken_up_goes_on_to_the_same_bits() {
    let material = Plastic::new(elastic(), Hardening::voce(YIELD, 200.0, 12.0).unwrap());
    let section: Arc<dyn Section> = Arc::new(PlasticSection::new(material, THICKNESS, 6).unwrap());
    let bits = |pack: &HistoryPack| pack.numbers().map(f64::to_bits).collect::<Vec<_>>();
    let mut random = Random(59);
    let mut one = HistoryPack::new(section.clone());
    assert!(bits(&one).iter().all(|number| *number == 0));
    for _ in 0..5 {
        one.commit(&random.strains(0.01, 0.02));
    }
    let mut other = HistoryPack::new(section);
    other.take_up(&one.numbers().collect::<Vec<_>>());
    for _ in 0..5 {
        let now = random.strains(0.01, 0.02);
        let before = bits(&one);
        let (force, tangent) = (one.resultants(&now), one.tangent(&now));
        assert!(bits(&one) == before);
        assert!(forces(&force) == forces(&other.resultants(&now)) && tangent == other.tangent(&now));
        one.commit(&now);
        other.commit(&now);
        let once = bits(&one);
        one.commit(&now);
        assert!(once != before && bits(&one) == once && bits(&other) == once);
    }
}

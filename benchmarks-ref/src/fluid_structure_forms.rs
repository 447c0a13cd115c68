//! Structures in fluids: closed forms that the coupling is measured by before there is any, and after.

use libm::{cosh, sinh, tanh};

use crate::vibration::cantilever_frequency;

/// A strip in plane strain: what a gate, a plate across a channel or a bar between two walls is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    /// Length L \[L\].
    pub length: f64,
    /// Thickness t \[L\].
    pub thickness: f64,
    /// Young's modulus E \[F/L²\].
    pub young: f64,
    /// Poisson's ratio ν.
    pub poisson: f64,
    /// Density ρ \[M/L³\].
    pub density: f64,
}

/// The rubber gate of \[antoci2007\], in metres, newtons and seconds.
pub const GATE: Strip = Strip { length: 0.079, thickness: 0.005, young: 12e6, poisson: 0.4, density: 1100.0 };

/// The aluminium strip under 2 m of water, in metres, newtons and seconds.
pub const WATER_STRIP: Strip =
    Strip { length: 1.0, thickness: 0.05, young: 67.5e9, poisson: 0.34, density: 2700.0 };

/// The strip of the collapsible channel, in metres and newtons; at rest its density does not count.
pub const CHANNEL_STRIP: Strip =
    Strip { length: 10.0, thickness: 0.05, young: 455e6, poisson: 0.3, density: 1.0 };

impl Strip {
    /// Bending stiffness of a unit width, `D = E t³/(12 (1 − ν²))` \[F L\].
    pub fn bending_stiffness(&self) -> f64 {
        self.young * self.thickness.powi(3) / (12.0 * (1.0 - self.poisson * self.poisson))
    }

    /// Deflection of the free end of a cantilever under uniform pressure q, `q L⁴/(8 D)` \[L\]: small, without shear.
    pub fn cantilever_tip(&self, pressure: f64) -> f64 {
        pressure * self.length.powi(4) / (8.0 * self.bending_stiffness())
    }

    /// What shear adds to that, `q L²/(2 κ G t)` \[L\] with κ = 5/6: the thickness over the length, squared.
    pub fn cantilever_shear(&self, pressure: f64) -> f64 {
        pressure * self.length * self.length / (2.0 * self.shear_stiffness())
    }

    /// First frequency of a cantilever, `(β₁L)² √(D/(ρ t))/(2π L²)` \[1/T\]: without shear and rotary inertia.
    pub fn cantilever_frequency(&self) -> f64 {
        let mass = self.density * self.thickness;
        cantilever_frequency(self.bending_stiffness(), mass, self.length) / std::f64::consts::TAU
    }

    /// Deflection in the middle of a strip with clamped ends under uniform pressure q, `q L⁴/(384 D)` \[L\]: small.
    pub fn clamped_middle(&self, pressure: f64) -> f64 {
        pressure * self.length.powi(4) / (384.0 * self.bending_stiffness())
    }

    /// What shear adds to that, `q L²/(8 κ G t)` \[L\] with κ = 5/6: `9.6/(1 − ν) · (t/L)²` of it.
    pub fn clamped_shear(&self, pressure: f64) -> f64 {
        pressure * self.length * self.length / (8.0 * self.shear_stiffness())
    }

    /// Shear stiffness of a unit width, `κ G t` \[F/L\] with κ = 5/6.
    fn shear_stiffness(&self) -> f64 {
        5.0 / 6.0 * self.young / (2.0 * (1.0 + self.poisson)) * self.thickness
    }

    /// The strip with clamped ends that do not come nearer, under uniform pressure \[F/L²\], deflected by its
    /// thickness or more.
    ///
    /// ```text
    /// D w⁗ − N w″ = q      N = E t/(1 − ν²) · (1/L) ∫ ½ w′² dx      (von Kármán)
    /// with c = L/2, λ² = N/D, x from the middle:
    /// w = q(c² − x²)/(2N) − qc/(Nλ) (cosh λc − cosh λx)/sinh λc
    /// ∫₀ᶜ w′² dx = (q/N)² [ c²(coth λc/(2λ) − c/(2 sinh² λc)) − 2c(c coth λc/λ − 1/λ²) + c³/3 ]
    /// ```
    ///
    /// The tension N is found by halving between λc = 1/10, below which it does not count, and N = E t.
    pub fn clamped_under(&self, pressure: f64) -> TautStrip {
        let (stiffness, half) = (self.bending_stiffness(), 0.5 * self.length);
        let stretch = self.young * self.thickness / (1.0 - self.poisson * self.poisson);
        let excess = |tension: f64| {
            let rate = (tension / stiffness).sqrt();
            let coth = 1.0 / tanh(rate * half);
            let squares = half * half * (coth / (2.0 * rate) - half / (2.0 * sinh(rate * half).powi(2)));
            let mixed = 2.0 * half * (half * coth / rate - 1.0 / (rate * rate));
            let slope = (pressure / tension).powi(2) * (squares - mixed + half.powi(3) / 3.0);
            stretch * slope / self.length - tension
        };
        let (mut low, mut high) = (0.01 * stiffness / (half * half), self.young * self.thickness);
        for _ in 0..200 {
            let middle = (low * high).sqrt();
            if excess(middle) > 0.0 { low = middle } else { high = middle }
        }
        TautStrip { half, pressure, tension: low, rate: (low / stiffness).sqrt() }
    }
}

/// A strip with clamped ends under pressure and the tension that it makes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TautStrip {
    half: f64,
    pressure: f64,
    /// Tension N of a unit width \[F/L\].
    pub tension: f64,
    rate: f64,
}

impl TautStrip {
    /// Deflection \[L\] at a part x/L of the span, with the pressure.
    pub fn deflection(&self, part: f64) -> f64 {
        let Self { half, pressure, tension, rate } = *self;
        let x = (2.0 * part - 1.0) * half;
        let bent = (cosh(rate * half) - cosh(rate * x)) / sinh(rate * half);
        pressure * (half * half - x * x) / (2.0 * tension) - pressure * half / (tension * rate) * bent
    }
}

/// Thrust \[F/L\] of water of depth H at rest on its lowest part of height L, `ρ g (H L − L²/2)`.
pub fn hydrostatic_thrust(density: f64, gravity: f64, depth: f64, height: f64) -> f64 {
    density * gravity * (depth * height - 0.5 * height * height)
}

/// A thin ring in plane strain with fluid outside it as far as a rigid wall, nothing inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WetRing {
    /// Radius a of its middle \[L\].
    pub radius: f64,
    /// Thickness h \[L\].
    pub thickness: f64,
    /// Young's modulus \[F/L²\].
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Density ρ_s \[M/L³\].
    pub density: f64,
    /// Radius b of the rigid wall \[L\].
    pub wall: f64,
}

/// The ring of the catalogue's exact frequencies, in metres, newtons and seconds.
pub const RING: WetRing =
    WetRing { radius: 1.0, thickness: 0.1, young: 1e6, poisson: 0.3, density: 1000.0, wall: 1.5 };

impl WetRing {
    /// Circular frequency \[1/T\] of n waves without fluid.
    ///
    /// ```text
    /// ω² = E h³/(12(1−ν²)) · n²(n²−1)² / (ρ_s h a⁴ (n²+1))
    /// ```
    pub fn dry(&self, waves: u32) -> f64 {
        let n = f64::from(waves).powi(2);
        let bending = self.young * self.thickness.powi(3) / (12.0 * (1.0 - self.poisson * self.poisson));
        let mass = self.density * self.thickness * self.radius.powi(4);
        (bending * n * (n - 1.0).powi(2) / (mass * (n + 1.0))).sqrt()
    }

    /// Mass \[M/L²\] that fluid of a density \[M/L³\] adds to the radial motion of n waves at the radius R \[L\]
    /// where it acts.
    ///
    /// ```text
    /// m = ρ_f R/n · (b²ⁿ + R²ⁿ)/(b²ⁿ − R²ⁿ)        the potential φ ~ (rⁿ + b²ⁿ r⁻ⁿ) cos nθ, at rest at b
    /// [brennen1982]
    /// ```
    pub fn added_mass(&self, waves: u32, density: f64, radius: f64) -> f64 {
        let (wall, ring) = (self.wall.powi(2 * waves as i32), radius.powi(2 * waves as i32));
        density * radius / f64::from(waves) * (wall + ring) / (wall - ring)
    }

    /// Circular frequency \[1/T\] of n waves in fluid that acts at the radius R \[L\].
    ///
    /// ```text
    /// ω_wet = ω_dry / √(1 + n²/(n²+1) · m R/(ρ_s h a))
    /// ```
    ///
    /// R is the outer surface of a thick ring, its middle for a shell whose fluid acts there. Of the motion of n
    /// waves without stretch, `v = −u/n` around, the radial part n²/(n²+1) moves fluid.
    pub fn wet(&self, waves: u32, density: f64, radius: f64) -> f64 {
        let n = f64::from(waves).powi(2);
        let mass = self.density * self.thickness * self.radius;
        let added = n / (n + 1.0) * self.added_mass(waves, density, radius) * radius / mass;
        self.dry(waves) / (1.0 + added).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{fluid_structure, reference};
    use approx::assert_relative_eq;

    #[test]
    fn the_ring_meets_the_table_dry_and_wet() {
        let table = reference("fsi_ring_added_mass_exact").unwrap();
        for row in 0..table.rows.len() {
            let density = table.number(row, "rho_f").unwrap();
            let (thin, exact) = (
                table.number(row, "omega thin ring").unwrap(),
                table.number(row, "omega continuum").unwrap(),
            );
            let wet = RING.wet(2, density, 1.05);
            assert_relative_eq!(wet, thin, max_relative = 1e-12);
            // The thin ring leaves out shear and the thickness: 0.5 % of the frequency.
            assert_relative_eq!(wet, exact, max_relative = 6e-3);
            let ratio = table.number(row, "wet/dry thin ring").unwrap_or(1.0);
            assert_relative_eq!(wet / RING.dry(2), ratio, max_relative = 1e-12);
        }
        // Where the fluid acts on the middle of the ring there is more of it, and it moves more.
        assert!(RING.wet(2, 1400.0, 1.0) > RING.wet(2, 1400.0, 1.05));
    }

    /// Kinetic energy of the fluid by differences of its potential: that of the added mass.
    #[test]
    fn the_added_mass_is_the_energy_of_the_fluid() {
        let (n, radius, density) = (3_i32, 1.02_f64, 7.0);
        let (a, b) = (radius, RING.wall);
        // φ' = cos nθ at the ring and 0 at the wall.
        let scale = 1.0 / (f64::from(n) * (a.powi(n - 1) - b.powi(2 * n) * a.powi(-n - 1)));
        let slope = |r: f64| scale * f64::from(n) * (r.powi(n - 1) - b.powi(2 * n) * r.powi(-n - 1));
        let round = |r: f64| scale * f64::from(n) * (r.powi(n - 1) + b.powi(2 * n) * r.powi(-n - 1));
        let steps = 20_000;
        let dr = (b - a) / f64::from(steps);
        let energy: f64 = (0..steps)
            .map(|i| {
                let r = a + (f64::from(i) + 0.5) * dr;
                // cos² and sin² are π over the circle.
                0.5 * density * std::f64::consts::PI * (slope(r).powi(2) + round(r).powi(2)) * r * dr
            })
            .sum();
        let mass = RING.added_mass(n as u32, density, radius);
        assert_relative_eq!(energy, 0.5 * mass * std::f64::consts::PI * a, max_relative = 1e-7);
    }

    #[test]
    fn the_strip_under_water_is_that_of_the_table() {
        let table = reference("hydrostatic_plate").unwrap();
        let water = 1000.0 * 9.81 * 2.0;
        let weight = WATER_STRIP.density * 9.81 * WATER_STRIP.thickness;
        let with = WATER_STRIP.clamped_middle(water + weight);
        assert_relative_eq!(with, table.number(0, "value").unwrap(), max_relative = 1e-8);
        assert_relative_eq!(
            WATER_STRIP.clamped_middle(water),
            table.number(1, "value").unwrap(),
            max_relative = 1e-8
        );
        // The beam with shear: its clamped ends turn no section, so that shear is that of the load alone.
        let part = 9.6 / (1.0 - WATER_STRIP.poisson) * WATER_STRIP.thickness.powi(2);
        assert_relative_eq!(
            WATER_STRIP.clamped_shear(water) / WATER_STRIP.clamped_middle(water),
            part,
            max_relative = 1e-12
        );
        let other = Strip { poisson: 0.3, ..WATER_STRIP };
        let levels = fluid_structure::water_on_strip().unwrap();
        assert_relative_eq!(-other.clamped_middle(water + weight), levels[0].1, max_relative = 1e-8);
    }

    #[test]
    fn the_taut_strip_meets_the_converged_elements() {
        let strip = CHANNEL_STRIP.clamped_under(200.0);
        let table = fluid_structure::clamped_strip().unwrap();
        for (&part, &deflection) in table.x().iter().zip(table.y()) {
            // The elements know large rotations: 0.07 %.
            assert_relative_eq!(strip.deflection(part), -deflection, max_relative = 1e-3);
        }
        assert_relative_eq!(strip.deflection(0.5), 0.143722, max_relative = 1e-5);
        assert_relative_eq!(strip.deflection(0.25), 0.096522, max_relative = 1e-5);
        // It balances: D w⁗ − N w″ = q by differences, and the ends are held.
        let h = 0.02;
        let w = |i: f64| strip.deflection(0.4 + i * h);
        let step = CHANNEL_STRIP.length * h;
        let fourth = (w(2.0) - 4.0 * w(1.0) + 6.0 * w(0.0) - 4.0 * w(-1.0) + w(-2.0)) / step.powi(4);
        let second = (w(1.0) - 2.0 * w(0.0) + w(-1.0)) / step.powi(2);
        let held = CHANNEL_STRIP.bending_stiffness() * fourth - strip.tension * second;
        assert_relative_eq!(held, 200.0, max_relative = 2e-3);
        assert!(strip.deflection(0.0).abs() < 1e-12 && strip.deflection(1e-4) < 1e-5);
    }

    #[test]
    fn a_light_pressure_bends_the_taut_strip_as_a_stiff_one() {
        // λc = 1/10 lowers the deflection by (λc)²/42 about.
        let strip = CHANNEL_STRIP.clamped_under(1e-3);
        assert_relative_eq!(strip.deflection(0.5), CHANNEL_STRIP.clamped_middle(1e-3), max_relative = 1e-3);
    }

    #[test]
    fn the_gate_swings_at_about_15_hertz() {
        assert_relative_eq!(GATE.cantilever_frequency(), 14.8, max_relative = 5e-3);
        assert_relative_eq!(
            GATE.cantilever_tip(10.0),
            10.0 * 0.079_f64.powi(4) / (8.0 * GATE.bending_stiffness())
        );
        assert_relative_eq!(hydrostatic_thrust(1000.0, 9.81, 0.14, 0.079), 77.9, max_relative = 1e-3);
        assert_relative_eq!(
            GATE.cantilever_shear(10.0) / GATE.cantilever_tip(10.0),
            5.34e-3,
            max_relative = 1e-3
        );
        let data = reference("antoci_gate_experiment_dx_a").unwrap();
        let value = |part: &serde_json::Value, key: &str| part[key]["value"].as_f64().unwrap();
        assert_eq!(value(&data.material, "gate_young_modulus"), GATE.young);
        assert_eq!(value(&data.material, "gate_poisson_ratio"), GATE.poisson);
        assert_eq!(value(&data.material, "gate_density"), GATE.density);
        assert_eq!(value(&data.geometry, "gate_length_L"), GATE.length);
        assert_eq!(value(&data.geometry, "gate_thickness_S"), GATE.thickness);
    }
}

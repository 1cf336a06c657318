//! Gao and AT with options drawn at random, integrated once (a sweep, azimuth within height within
//! angle) and tabulated (a compiled scene): against `reference/lateral_cases.csv`, far below
//! all heights `reference/lateral_depths.csv`, and each other.

use asperity::{
    AngleDensity, Case, Contact, Displacement, Evaluation, ForceComponent, Interface,
    LateralOptions, Model, Quantity, Request, Scene, Stick, Surface, Sweep, Tolerance,
};

use crate::{is_long, one_of, scenes};

/// The inputs of a row or of a draw.
struct Asked {
    scene: Scene,
    model: Model,
    quantity: Quantity,
    separation: f64,
}

impl Asked {
    fn once(&self, tolerance: Tolerance) -> Evaluation {
        let sweep = Sweep::new(&self.model, &[self.quantity], tolerance);
        sweep.evaluate(&Case::new(self.scene.clone(), self.separation)).unwrap()[0]
    }

    fn tabulated(&self, tolerance: Tolerance) -> Evaluation {
        let request = Request::new([self.quantity]).within(tolerance);
        let contact: Box<dyn Contact> = self.model.compile(&self.scene, &request).unwrap();
        contact.evaluate(self.quantity, self.separation).unwrap()
    }
}

fn scene(numbers: [f64; 9]) -> Scene {
    let [modulus, shear, ratio, hardness, factor, radius, density, height_std, area] = numbers;
    let mut interface = Interface::new(modulus, ratio, hardness);
    interface.equivalent_shear_modulus = Some(shear);
    interface.pressure_factor = Some(factor);
    Scene::new(interface, Surface::new(radius, density, height_std), area)
}

/// The rounding of the heights above a separation: far below 0, s + t is known no better than s.
fn rounding(separation: f64) -> f64 {
    1e-15 * separation.min(0.0).abs()
}

fn harmonic(a20: f64) -> AngleDensity {
    AngleDensity::Harmonic { a20, a21: 0.0, b21: 0.0 }
}

#[test]
fn rows_of_the_reference_are_met_within_their_bounds() {
    let mut count = 0;
    let files = [
        include_str!("../reference/lateral_cases.csv"),
        include_str!("../reference/lateral_depths.csv"),
    ];
    for line in one_of(3, files.iter().flat_map(|file| file.lines().skip(1))) {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |k: usize| fields[k].parse::<f64>().unwrap();
        let displacement = match fields[11].split_once(' ') {
            Some((zeta, xi)) => {
                Displacement::Given { zeta: zeta.parse().unwrap(), xi: xi.parse().unwrap() }
            }
            None => Displacement::Vertical,
        };
        let (force, quantity) = match fields[10] {
            "vertical-force" => (ForceComponent::Vertical, Quantity::Force),
            plain => (ForceComponent::Size, plain.parse().unwrap()),
        };
        let stick = if fields[12] == "clamped" { Stick::Clamped } else { Stick::Unlimited };
        let options =
            LateralOptions { angle_density: harmonic(number(13)), displacement, stick, force };
        let asked = Asked {
            scene: scene(std::array::from_fn(number)),
            model: scenes::lateral(fields[9], options),
            quantity,
            separation: number(14),
        };
        let (scaled, size, agreement) = (number(15), number(16), number(17));
        for tolerance in [1e-6, 1e-10, 1e-12] {
            let within = Tolerance::new(tolerance).unwrap();
            for found in [asked.once(within), asked.tabulated(within)] {
                let error = (found.scaled - scaled).abs() / size;
                // The two partitions of the reference may have a common error.
                let allowed = found.error * found.size / size + 10.0 * agreement + 1e-13;
                let most = 1.001 * tolerance + rounding(asked.separation);
                assert!(found.error < most, "{line}: {:e} at {tolerance:e}", found.error);
                assert!(error <= allowed, "{line}: {error:e} for {allowed:e} at {tolerance:e}");
            }
        }
        count += 1;
    }
    assert!(count >= if is_long() { 16 } else { 5 }, "{count} rows");
}

#[test]
fn integrated_once_and_tabulated_agree_within_their_bounds() {
    // Multiples of irrational numbers fill [0, 1) evenly, and repeat for every run.
    let share = |k: u32, step: f64| (f64::from(k) * step).fract();
    for k in one_of(5, 1..=24) {
        let size = |u: f64| match u {
            u if u < 0.1 => 0.0,
            u if u < 0.2 => 1e-6,
            u => 10f64.powf(5.0 * (u - 0.6)),
        };
        let given =
            Displacement::Given { zeta: size(share(k, 0.414_214)), xi: size(share(k, 0.732_051)) };
        let options = LateralOptions {
            angle_density: harmonic([-0.5, -1.0, 2.0, 0.7][k as usize % 4]),
            displacement: if k % 2 == 0 { given } else { Displacement::Vertical },
            stick: if k % 3 == 0 { Stick::Unlimited } else { Stick::Clamped },
            force: if k % 5 == 0 { ForceComponent::Vertical } else { ForceComponent::Size },
        };
        let hardness = 116e9 * 10f64.powf(-2.5 + 1.7 * share(k, 0.236_068));
        let critical = 1e-6 * 10f64.powf(-2.5 + 4.0 * share(k, 0.645_751));
        let strain = std::f64::consts::PI * 0.58 * hardness / (2.0 * 116e9);
        let radius = critical / (strain * strain);
        let shear = 29e9 * 10f64.powf(-2.0 + 3.0 * share(k, 0.162_278));
        let density = 0.04 / (radius * 1e-6);
        let asked = Asked {
            scene: scene([116e9, shear, 0.31, hardness, 0.58, radius, density, 1e-6, 3e-5]),
            model: scenes::lateral(
                ["gao", "at", "at-additive", "at-overlap"][k as usize / 3 % 4],
                options,
            ),
            // Far below, slopes are refused.
            quantity: match k % 3 {
                2 if k % 4 != 3 => Quantity::Tangent,
                1 => Quantity::Stiffness,
                _ => Quantity::Force,
            },
            // Also where all asperities touch.
            separation: match k % 4 {
                3 => -10f64.powf(0.9 + 4.1 * share(k, 0.605_551)),
                _ => -3.0 + 9.0 * share(k, 0.605_551),
            },
        };
        for tolerance in [1e-8, 1e-11] {
            let within = Tolerance::new(tolerance).unwrap();
            let (once, tabulated) = (asked.once(within), asked.tabulated(within));
            let error = (once.scaled - tabulated.scaled).abs() / tabulated.size;
            let bounds = once.error + tabulated.error;
            assert!(error <= bounds, "{k}: {error:e} for {bounds:e} at {tolerance:e}, {options:?}");
            let most = 1.001 * tolerance + rounding(asked.separation);
            assert!(once.error < most, "{k}: {:e} at {tolerance:e}", once.error);
        }
    }
}

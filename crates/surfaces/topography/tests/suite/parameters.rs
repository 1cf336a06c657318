//! Parameters and spectra beside those of surfalize and SurfaceTopography, computed by
//! `tests/reference/surface_parameters.py`.

use std::f64::consts::TAU;

use asperity_topography::Topography;

const REFERENCE: &str = include_str!("../../../../../tests/reference/surface_parameters.csv");
const ROWS: usize = 128;
const COLUMNS: usize = 160;

fn made(height: impl Fn(f64, f64) -> f64) -> Topography {
    let point = |k: usize| 1e-6 * height((k % COLUMNS) as f64, (k / COLUMNS) as f64);
    let heights = (0..ROWS * COLUMNS).map(point).collect();
    Topography::new(heights, COLUMNS, [0.5e-6, 0.4e-6]).unwrap()
}

fn open(stretch: f64) -> Topography {
    made(|x, y| {
        let wave = |k: f64| {
            let along = stretch * x * (2.4 * k).cos() + y * (2.4 * k).sin();
            0.3 * (0.035 * (k + 6.0) * along + 7.1 * k * k).cos() / (1.0 + 0.1 * k)
        };
        (1..40).map(|k| wave(f64::from(k))).sum()
    })
}

fn periodic() -> Topography {
    let surface = made(|x, y| {
        let wave = |k: u32| {
            let [i, j] = [f64::from(7 * k % 23), f64::from(11 * k % 37)];
            let turn = TAU * (i * y / ROWS as f64 + j * x / COLUMNS as f64);
            (turn + 7.1 * f64::from(k * k)).cos() / (i + j + 1.0).powf(1.5)
        };
        (1..60).map(wave).sum()
    });
    surface.with_periodic(true)
}

/// Rows of the reference: name, place and value in SI units.
fn rows(case: &str, power: i32) -> Vec<(String, f64, f64)> {
    let cells = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
    let rows = REFERENCE.lines().map(cells).filter(|row| row[0] == case);
    let number = |text: &str| text.parse::<f64>().unwrap_or(f64::NAN);
    rows.map(|row| (row[1].clone(), 1e6 * number(&row[2]), number(&row[3]) * 1e-6_f64.powi(power)))
        .collect()
}

#[test]
fn parameters_are_those_of_surfalize() {
    for (case, stretch) in [("broad", 1.0), ("lay", 0.3)] {
        let surface = open(stretch);
        let parameters = surface.parameters().unwrap();
        let (decay, peaks) = (surface.decay().unwrap(), surface.peaks().unwrap());
        let [sk, spk, svk, smr1, smr2, vmp, vmc, vvc, vvv] =
            surface.material_ratio().unwrap().functional();
        let mut seen = 0;
        for (name, _, value) in rows(case, 0) {
            // Sal and Str interpolate otherwise; the shortest length is of four points.
            let (found, unit, within) = match &*name {
                "Sq" => (parameters.sq, 1e-6, 1e-12),
                "Sa" => (parameters.sa, 1e-6, 1e-12),
                "Sz" => (parameters.sz, 1e-6, 1e-12),
                "Sp" => (parameters.sp, 1e-6, 1e-12),
                "Sv" => (parameters.sv, 1e-6, 1e-12),
                "Ssk" => (parameters.ssk, 1.0, 1e-11),
                "Sku" => (parameters.sku, 1.0, 1e-12),
                "Sdq" => (parameters.sdq, 1.0, 1e-12),
                "Sdr" => (parameters.sdr.unwrap(), 1.0, 1e-12),
                "Sal" => (decay.sal, 1e-6, 0.02),
                "Str" => (decay.str.unwrap(), 1.0, 0.02),
                // Here n points cover n pixels, there n - 1.
                "Spd" => (peaks.spd, 1e12 * (159.0 * 127.0) / (160.0 * 128.0), 1e-12),
                "Spc" => (peaks.spc.unwrap(), 1e6, 1e-11),
                "Sk" => (sk, 1e-6, 1e-11),
                "Smr1" => (smr1, 1.0, 1e-11),
                "Smr2" => (smr2, 1.0, 1e-11),
                "pk" => (spk, 1e-6, 1e-11),
                "vk" => (svk, 1e-6, 1e-11),
                "vmp" => (vmp, 1e-6, 1e-11),
                "vmc" => (vmc, 1e-6, 1e-11),
                "vvc" => (vvc, 1e-6, 1e-11),
                "vvv" => (vvv, 1e-6, 1e-11),
                // Areas under a line, up to the nearest class: one of 20,480.
                "Spk" => (spk, 1e-6, 4e-3),
                "Svk" => (svk, 1e-6, 4e-3),
                "Svmp" => (vmp, 1e-6, 4e-3),
                "Svmc" => (vmc, 1e-6, 4e-3),
                "Svvc" => (vvc, 1e-6, 4e-3),
                "Svvv" => (vvv, 1e-6, 4e-3),
                other => panic!("{other}"),
            };
            let right = value * unit;
            assert!((found / right - 1.0).abs() < within, "{case} {name}: {found:e} {right:e}");
            seen += 1;
        }
        assert_eq!(seen, 28);
    }
}

#[test]
fn functional_parameters_of_a_profile_are_those_of_surfalize() {
    let row = open(1.0).heights()[..COLUMNS].to_vec();
    let found = Topography::new(row, COLUMNS, [0.5e-6; 2]).unwrap().functional().unwrap();
    let of = |name: &str| found.iter().find(|row| row.name == name).unwrap().value.unwrap();
    let rows = rows("profile", 0);
    assert_eq!(rows.len(), 5);
    for (name, _, value) in rows {
        let unit = if ["rk", "rz"].contains(&&*name) { 1e-6 } else { 1.0 };
        assert!((of(&name) / (value * unit) - 1.0).abs() < 1e-11, "{name}: {found:?}");
    }
    let names: Vec<_> = found.iter().map(|row| row.name).collect();
    assert_eq!(names, ["rk", "rpk", "rvk", "rmr1", "rmr2", "rz", "rsm", "rdq"]);
}

#[test]
fn spectra_are_those_of_surface_topography() {
    let spectra = periodic().spectra().unwrap();
    let radial = spectra.radial.unwrap();
    for (name, spectrum, power) in [("along_rows", &spectra.along_rows, 3), ("radial", &radial, 4)]
    {
        let rows = rows("periodic", power);
        let rows: Vec<_> = rows.iter().filter(|row| row.0 == name).collect();
        assert!(rows.len() >= 8, "{name}");
        for (_, at, right) in rows {
            let mut each = spectrum.wave_number.iter().zip(&spectrum.density);
            let near = each.find(|(q, _)| (*q / at - 1.0).abs() < 1e-3);
            let (_, found) = near.unwrap_or_else(|| panic!("{name} {at:e} {spectrum:?}"));
            assert!((found / right - 1.0).abs() < 1e-9, "{name} {at:e}: {found:e} {right:e}");
        }
    }
}

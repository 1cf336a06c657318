//! The numbers of `asperity surface`.

use asperity_topography::{Glance, Statistics};
use serde::Serialize;

use crate::output::table::{Cell, Table};

/// All numbers of a scan; of two scans their statistics alone.
#[derive(Serialize)]
pub struct Report<'a> {
    #[serde(flatten)]
    pub statistics: &'a Statistics,
    #[serde(flatten)]
    pub glance: Option<Glance>,
}

const HURST: &str = "Hurst exponent fitted to the radial spectrum";

type Row<'a> = (&'a str, Option<f64>, &'a str, &'a str);

/// What decides trust, parameters of ISO 25178-2, moments and asperities, in this order.
pub fn table(statistics: &Statistics, glance: Option<&Glance>) -> Table {
    let outliers = &statistics.outliers;
    let of_all: [Row; 4] = [
        ("missing_share", Some(statistics.missing_share), "", "share of missing points"),
        ("outliers", Some(outliers.count as f64), "", "points far outside their neighbours"),
        ("outlier_largest", Some(outliers.largest), "m", "the furthest, above (+) or below (-)"),
        ("outlier_m4_share", Some(outliers.m4_share), "", "share of m4 due to outliers"),
    ];
    let shape: [Row; 2] = [
        ("ssk", Some(statistics.ssk), "", "skewness of the heights"),
        ("sku", Some(statistics.sku), "", "kurtosis of the heights, 3 for a Gaussian surface"),
    ];
    let sq: Row = ("sq", Some(statistics.sq), "m", "standard deviation of the heights");
    let moments: [Row; 9] = [
        ("m0", Some(statistics.m0), "m2", "profile moment <z^2>"),
        ("m2", Some(statistics.m2), "", "profile moment <z'^2>"),
        ("m4", Some(statistics.m4), "1/m2", "profile moment <z''^2>"),
        ("alpha", Some(statistics.alpha), "", "bandwidth m0 m4/m2^2"),
        ("asperity_density", statistics.asperity_density, "1/m2", "eta"),
        ("asperity_radius", statistics.asperity_radius, "m", "R"),
        ("asperity_height_std", statistics.asperity_height_std, "m", "sigma_z"),
        ("beta", statistics.beta, "", "eta R sq"),
        ("beta_z", statistics.beta_z, "", "eta R sigma_z"),
    ];
    let mut rows = of_all.to_vec();
    rows.extend(glance.map(trust).into_iter().flatten());
    rows.extend(shape);
    rows.extend(glance.map(filter));
    rows.push(sq);
    rows.extend(glance.map(parameters).into_iter().flatten());
    rows.extend(moments);
    let row = |(name, value, unit, meaning): Row| {
        vec![name.into(), Cell::Number(value), unit.into(), meaning.into()]
    };
    let rows = rows.into_iter().map(row).collect();
    Table { rows, ..Table::new(&["name", "value", "unit", "meaning"]) }
}

fn trust(glance: &Glance) -> [Row<'_>; 9] {
    [
        ("tilt_x", Some(glance.tilt_x), "", "slope along rows of the plane removed"),
        ("tilt_y", Some(glance.tilt_y), "", "slope along columns of the plane removed"),
        ("form_height", Some(glance.form_height), "m", "height of the form removed, with its tilt"),
        ("slope_ratio", glance.slope_ratio, "", "rms slope across the lay over that along it"),
        ("lay_direction", glance.lay_direction, "deg", "lay, from rows (x) towards columns (y)"),
        ("long_wavelength", glance.long_wavelength, "m", "half of Sq^2 is in longer waves"),
        ("long_waves", glance.long_waves, "", "of them on the shorter side: 10 or more are wanted"),
        ("m2_over_half", glance.m2_over_half, "", "m2 over that of every second point"),
        ("m4_over_half", glance.m4_over_half, "", "likewise m4: 1 if resolved, 16 for noise"),
    ]
}

fn filter(glance: &Glance) -> Row<'_> {
    ("filter", None, "", &glance.filter)
}

fn parameters(glance: &Glance) -> [Row<'_>; 13] {
    [
        ("sa", Some(glance.sa), "m", "mean distance from the mean"),
        ("sz", Some(glance.sz), "m", "from the lowest to the highest point"),
        ("sp", Some(glance.sp), "m", "highest point above the mean"),
        ("sv", Some(glance.sv), "m", "lowest point below the mean"),
        ("sdq", Some(glance.sdq), "", "rms gradient"),
        ("sdr", glance.sdr, "", "developed area over the nominal one, less 1"),
        ("sal", glance.sal, "m", "shortest length of decay of the autocorrelation to 0.2"),
        ("str", glance.str, "", "shortest over longest: 1 for an isotropic surface"),
        ("spd", glance.spd, "1/m2", "density of peaks; hills below 5 % of sz pruned"),
        ("spc", glance.spc, "1/m", "mean curvature of these peaks"),
        ("hurst", glance.hurst, "", glance.hurst_missing.as_deref().unwrap_or(HURST)),
        ("roll_off", glance.roll_off, "m", "wavelength above which the spectrum is flat"),
        ("cut_off", glance.cut_off, "m", "wavelength below which it leaves the power law"),
    ]
}

//! Numbers of hardness tests as contact hardnesses.

/// Rockwell C and Vickers hardness of steel. \[recalled\]
const ROCKWELL_C: [[f64; 2]; 6] =
    [[20.0, 238.0], [30.0, 302.0], [40.0, 392.0], [50.0, 513.0], [58.0, 653.0], [65.0, 832.0]];
/// Brinell over Vickers hardness of steel. \[recalled\]
const BRINELL: f64 = 0.95;
/// The Rockwell C hardnesses that are converted.
pub const ROCKWELL_C_LIMITS: [f64; 2] = [ROCKWELL_C[0][0], ROCKWELL_C[ROCKWELL_C.len() - 1][0]];
/// The Brinell hardnesses that are converted: beyond, the ball flattens. \[recalled\]
pub const BRINELL_LIMITS: [f64; 2] = [0.0, 450.0];

/// The contact hardness \[Pa\] of a Vickers hardness, the mean pressure on the projected area:
/// 9.807 HV/sin 68° MPa, as the number is the load in kgf over the area in mm² of the facets of a
/// pyramid of 136°. \[derived\]
///
/// ```
/// let hardness = asperity_core::hardness_of_vickers(200.0);
/// assert!((hardness / 2.115e9 - 1.0).abs() < 1e-3);
/// ```
#[must_use]
pub fn hardness_of_vickers(vickers: f64) -> f64 {
    // 1 kgf/mm² in Pa.
    9.806_65e6 * vickers / 68f64.to_radians().sin()
}

/// The Vickers hardness of a steel with this Rockwell C hardness, 20 to 65, by the usual table of
/// conversions, geometrically between 238 HV (20 HRC), 302 (30), 392 (40), 513 (50), 653 (58) and
/// 832 (65); `None` beyond. Tables of different standards differ by some per cent. \[recalled\]
#[must_use]
pub fn vickers_of_rockwell_c(rockwell: f64) -> Option<f64> {
    let part = ROCKWELL_C.windows(2).find(|pair| (pair[0][0]..=pair[1][0]).contains(&rockwell))?;
    let [[from, low], [to, high]] = [part[0], part[1]];
    Some(low * (high / low).powf((rockwell - from) / (to - from)))
}

/// The Vickers hardness of a steel with this Brinell hardness (ball of hard metal), up to 450:
/// HBW/0.95; `None` beyond, where the ball flattens. \[recalled\]
#[must_use]
pub fn vickers_of_brinell(brinell: f64) -> Option<f64> {
    let [least, most] = BRINELL_LIMITS;
    (brinell > least && brinell <= most).then(|| brinell / BRINELL)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hardness_tests_of_steel_are_converted_within_their_tables() {
        // ASTM E140: 45 HRC is 446 HV, 60 HRC 697 HV. [recalled]
        for (rockwell, vickers, within) in
            [(20.0, 238.0, 1e-12), (58.0, 653.0, 1e-12), (45.0, 446.0, 0.01), (60.0, 697.0, 0.01)]
        {
            let found = vickers_of_rockwell_c(rockwell).unwrap();
            assert!((found / vickers - 1.0).abs() < within, "{rockwell} HRC: {found}");
        }
        assert!((vickers_of_brinell(190.0).unwrap() - 200.0).abs() < 1e-9);
        let beyond = [19.9, 65.1, f64::NAN].map(vickers_of_rockwell_c);
        assert_eq!(beyond, [None; 3]);
        assert_eq!([0.0, -3.0, 451.0, f64::NAN].map(vickers_of_brinell), [None; 4]);
    }
}

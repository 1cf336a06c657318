//! The table of inputs: every key that may be written about a scene, once. Reading, writing, units,
//! suggestions, the comments of the template, the keys of fits and sweeps and the page's form
//! follow from it.

use asperity::{Body, Interface, Surface, Units, units};

use crate::curvature::Curvature;
use crate::seal::{Gas, Seal};

/// A key of a scene file.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct Key {
    /// Its name.
    pub name: &'static str,
    /// Its section: `body`, `interface`, `surface`, `options`, or empty for the top of the file.
    pub section: &'static str,
    /// What it describes.
    pub subject: Subject,
    /// The SI unit of its number; empty for pure numbers and for texts.
    pub unit: &'static str,
    /// Its comment in the template: the unit, then what the key means, what needs it, or its
    /// values.
    pub meaning: &'static str,
    /// Its name in a form with the symbol, and a value as it may be typed or the values to choose
    /// from, separated by `|`; empty for keys that a form does not have.
    pub form: [&'static str; 2],
}

/// What a key of a scene describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subject {
    /// The contact as a whole.
    Scene,
    /// One body.
    Body,
    /// The two bodies together.
    Interface,
    /// One rough surface, by numbers.
    Roughness,
    /// One rough surface, by a measured file.
    Scan,
    /// The surface that both rough surfaces make.
    Surface,
    /// The bodies, where they are curved.
    Curvature,
    /// What fills the gap between the surfaces.
    Gap,
    /// The seal whose faces the scan stands for.
    Seal,
    /// Variants of the models.
    Options,
}

/// A key whose number is a field of a struct of the library: functions that read and set it.
#[derive(Debug, Clone, Copy)]
pub struct Field<T: 'static> {
    /// The key.
    pub name: &'static str,
    /// The number, if it is given.
    pub get: fn(&T) -> Option<f64>,
    /// Replaces the number.
    pub set: fn(&mut T, f64),
}

macro_rules! key {
    ($section:literal $subject:ident $name:ident $unit:literal $meaning:literal
        $(form $label:literal $typed:literal)?) => {
        Key {
            name: stringify!($name),
            section: $section,
            subject: Subject::$subject,
            unit: $unit,
            meaning: concat!($unit, $meaning),
            form: [concat!($($label)?), concat!($($typed)?)],
        }
    };
}

/// Sections with their keys, each with its unit, what follows the unit in the template, and its
/// name and a value in a form. Those of `numbers` are fields of a struct
/// of the library; sweeps and Python list them in this order.
macro_rules! keys {
    ($($section:literal $subject:ident
        $(numbers $list:ident in $struct:ident { $($field:ident($($column:tt)+))+ })?
        { $($name:ident($($value:tt)+))* })+) => {
        /// Every key of a scene file.
        pub const KEYS: &[Key] = &[$(
            $($(key!($section $subject $field $($column)+),)+)?
            $(key!($section $subject $name $($value)+),)*
        )+];
        $($(
            /// The numbers of this struct.
            pub const $list: &[Field<$struct>] = &[$(Field {
                name: stringify!($field),
                get: |of| Option::from(of.$field),
                set: |of, value| of.$field = value.into(),
            }),+];
        )?)+
    };
}

keys! {
    "" Scene {
        nominal_area("m^2" ", the apparent area of contact" form "Nominal area" "1 cm2")
        rigid_counterface("" "with one [[body]] only: the counterface is rigid")
        work_of_adhesion("J/m^2" ", of the two bodies together; only dmt and jkr need it")
        accept("" "codes of warnings and notes to silence, as messages show them")
        body("" "two of them, here of steel; one with rigid_counterface = true")
        interface("" "of the two bodies together")
        surface("" "the rough surface, in exactly one of the ways below")
        curvature("" "")
        gap("" "")
        seal("" "")
        options("" "")
    }
    "body" Body numbers BODY in Body {
        youngs_modulus("Pa" "" form "Young's modulus E" "210 GPa")
        poissons_ratio("" "above -1, at most 0.5" form "Poisson's ratio ν" "0.3")
        hardness("Pa" "; within 3.3 to 7.8 times the yield strength if missing; elastic models need neither"
            form "Hardness H" "2 GPa")
        yield_strength("Pa" "; beside the hardness for laws that take it, which else take H/2.8, or instead of it"
            form "Yield strength" "700 MPa")
        thermal_conductivity("W/(m K)" ", of both bodies; only thermal-conductance needs it"
            form "Thermal conductivity" "50 W/(m K)")
        electrical_resistivity("ohm m" ", of both bodies; only electrical-conductance needs it"
            form "Electrical resistivity" "1.7e-7 ohm m")
        tangent_modulus("Pa" ", of both bodies, which must be alike; only ghaednia needs it")
    } {
        material("" "E, nu, hardness and what is known, instead of them: `asperity list materials`")
    }
    "interface" Interface numbers INTERFACE in Interface {
        equivalent_modulus("Pa" ", 1/E = (1-nu1^2)/E1 + (1-nu2^2)/E2"
            form "Equivalent modulus" "115 GPa")
        poissons_ratio("" "of the softer body" form "Poisson's ratio ν" "0.3")
        hardness("Pa" ", of the softer body" form "Hardness H" "2 GPa")
        yield_strength("Pa" ", of the softer body; beside the hardness for laws that take it, which else take H/2.8, or instead of it")
        equivalent_shear_modulus("Pa"
            ", 1/G = (2-nu1)/G1 + (2-nu2)/G2; for gao, at, tangential-stiffness")
        pressure_factor("" "0.454 + 0.41 nu if missing")
        thermal_conductivity("W/(m K)" ", 2/k = 1/k1 + 1/k2")
        electrical_resistivity("ohm m" ", 2 rho = rho1 + rho2")
        work_of_adhesion("J/m^2" ", gamma1 + gamma2 - gamma12; only dmt and jkr need it")
        tangent_modulus("Pa" ", of two bodies with the same E and nu; only ghaednia needs it")
    } {}
    "surface" Roughness numbers SURFACE in Surface {
        asperity_radius("m" "" form "Asperity radius R" "0.2 mm")
        asperity_density("1/m^2" "" form "Asperity density η" "200 1/mm2")
        asperity_height_std("m" ", of the asperities, not of the surface ..."
            form "Height std σ_z" "1 um")
    } {
        surface_height_std("m" ", ... or of the surface: Sq of an isotropic Gaussian surface")
        mean_slope("" "without a unit: mean |slope| of profiles; replaces asperity_radius, with surface_height_std")
        plasticity_index("" "2 E/(pi S H) sqrt(height_std/radius)" form "Plasticity index ψ" "2")
        roughness_parameter("" "density times radius times height_std" form "η R σ_z" "0.04")
        m0("m^2" "" form "m0, mean of z²" "1e-12 m^2")
        m2("" "without a unit" form "m2, mean of z′²" "1e-4")
        m4("1/m^2" "" form "m4, mean of z″²" "5e4 1/m^2")
        sq("m" ", standard deviation of the surface heights" form "Sq" "1.1 um")
        spd("1/m^2" ", density of peaks" form "Spd" "200 1/mm2")
        spc("1/m" ", mean curvature of peaks" form "Spc" "5 1/mm")
        ra("m" ", as on a drawing, with a finish: answers are ranges" form "Roughness Ra" "0.8 um")
        rq("m" ", instead of ra" form "or Rq" "1 um")
        rz("m" ", instead of ra, or with rsm" form "or Rz" "5 um")
        finish("" "or blasted, turned, milled, lapped, polished, honed, unknown"
            form "Finish" "blasted|ground|turned|milled|lapped|polished|honed|unknown")
        rsm("m" ", mean width of profile elements: with rz instead of a finish"
            form "RSm, with Rz" "120 um")
        rdq("" "without a unit: rms slope of a profile across the lay; replaces the range of slopes"
            form "Rdq, if measured" "0.1")
        bandwidth("" "m0 m4/m2^2, if known; replaces its range" form "Bandwidth α, if known" "10")
        lambda_c("m" ", cut-off of the profile; that of ISO 4288 if missing")
        lambda_s("m" ", short cut-off of the profile; that of ISO 3274 if missing")
    }
    "surface" Scan {
        file("" "text, NumPy .npy, X3P, SUR, Gwyddion .gwy or SDF" form "File" "scan.x3p")
        unit("" "of the heights (and of pixel_size), if the file has none"
            form "Unit of the heights" "um")
        pixel_size("" "or [1.5, 2.0], in that unit or as \"10 nm\", if the file has none"
            form "Pixel size" "1.5 um")
        channel("" "name or number of a surface in a file of several (.gwy, .sur, text)"
            form "Channel" "2")
        units("" "of lengths and heights of a text, or of x, y and heights, if it states none"
            form "Units" "[\"um\", \"nm\"]")
        columns("" "of a text: \"x,y,z\", \"-,z,-\", the number of the column of heights, \"matrix\" or \"axes\""
            form "Columns" "x,y,z")
        skip_lines("" "lines at the beginning of a text that are not read"
            form "Lines to skip" "2")
        missing("" "the number that marks missing points; nan if none does"
            form "Missing points are" "-9999")
        factor("" "from the numbers in the file to heights in their unit" form "Factor" "0.5")
        delimiter("" "of the fields of a text, one character" form "Delimiter" ";")
        estimator("" "or \"summits\"" form "Estimator" "moments|summits")
        level("" "form removed first: \"plane\", \"quadratic\", \"mean\" (default of periodic scans) or \"none\""
            form "Form removed" "plane|quadratic|mean|none")
        filter("m" ", long-wavelength cut-off of a Gaussian filter" form "Long cut-off" "0.8 mm")
        smooth("m" ", short-wavelength cut-off of a Gaussian filter" form "Short cut-off" "2 um")
        periodic("" "true if the surface is repeated beyond its edges, with its steps"
            form "Periodic" "true|false")
        fill_missing("" "true: up to 0.05 of the points are filled from their surroundings"
            form "Fill missing points" "true|false")
        despike("" "true: outliers are replaced as missing points are filled"
            form "Replace outliers" "true|false")
        max_missing("" "the largest share of missing points" form "Missing points, at most" "0.1")
        aligned("" "true: heights of two scans add, point by point; \"mirrored\": rows of the second reversed")
    }
    "surface" Surface {
        counterface("" "or { file = \"b.sur\", filter = 8e-4 }")
        heights("" "" form "Heights" "gaussian")
        peklenik_number("" "lay: correlation length along x, of sliding, over that across; for factors of flow")
        separation_from("" "or \"surface-mean\"")
        mean_plane_offset("m" ", of the mean of the asperity heights above that of the surface, if known")
    }
    "curvature" Curvature numbers CURVATURE in Curvature {
        radius("m" ", of a ball on a flat; of two balls 1/R = 1/R1 + 1/R2" form "Radius" "10 mm")
        radius_x("m" ", relative radius along x; with length, of a line contact" form "Radius along x" "0.46 m")
        radius_y("m" ", relative radius along y" form "Radius along y" "0.3 m")
        body1_radius_x("m" ", instead of relative radii: of each body, below 0 where it is hollow")
        body1_radius_y("m" ", left out where it is flat")
        body2_radius_x("m" "")
        body2_radius_y("m" "")
        length("m" ", of a line contact" form "Length" "20 mm")
        reference_length("m" ", in the deflection of a line contact: its approach depends on it" form "Reference length" "0.1 m")
    } {}
    "gap" Gap numbers GAP in Gas {
        gas_conductivity("W/(m K)" ", of the gas in the gap; air has 0.026")
        gas_parameter("m" ", temperature-jump distance: about 0.37 um for air at 1 bar, 0 for a liquid")
    } {}
    "seal" Seal numbers SEAL in Seal {
        width("m" ", across the flow; of a ring along it" form "Width" "100 mm")
        length("m" ", along the flow" form "Length" "2 mm")
        perimeter("m" ", of a ring, instead of length")
        upstream_pressure("Pa" ", absolute" form "Pressure upstream" "10 bar")
        downstream_pressure("Pa" ", absolute; 0 is a vacuum" form "Pressure downstream" "1 bar")
        viscosity("Pa s" ", of a liquid, or instead of that of the gas"
            form "Viscosity of a liquid" "1 mPa s")
        density("kg/m^3" ", of a liquid, for its mass flow")
        molar_mass("kg/mol" ", of a gas that is not in the list, with its viscosity")
        temperature("K" ", of the gas; 293.15 if missing")
    } {
        gas("" "air, nitrogen, hydrogen, helium, argon or methane"
            form "Gas" "air|nitrogen|hydrogen|helium|argon|methane")
    }
    "options" Options {
        angle_density("" "of gao and at; or \"upright\"")
        displacement("" "\"none\", { zeta = 0.1, xi = 0.1 }")
        stick("" "\"unlimited\"")
        force("" "\"vertical\"")
        af_flow_pressure("" "\"H\"")
        friction_cut_off("" "of a film: the least gap that carries friction, over sigma")
        boundary("" "of bem: \"periodic\", \"periodic-part\" or \"free\"")
        elastic("" "of bem: true ignores the hardness")
        hurst_exponent("" "of a power-law spectrum for the gaps of persson: without a scan, or instead of it")
    }
}

impl<T> Field<T> {
    /// The one of a key, if there is one.
    pub(crate) fn of(fields: &'static [Self], key: &str) -> Option<&'static Self> {
        fields.iter().find(|field| field.name == key)
    }

    /// The number of a key.
    pub(crate) fn value(fields: &'static [Self], key: &str, of: &T) -> Option<f64> {
        (Self::of(fields, key)?.get)(of)
    }

    /// Replaces the number of a key.
    pub(crate) fn put(fields: &'static [Self], key: &str, of: &mut T, value: f64) {
        Self::of(fields, key).into_iter().for_each(|field| (field.set)(of, value));
    }
}

/// The section of the second of two rough surfaces.
pub(crate) const COUNTERFACE: &str = "surface.counterface";
/// The numbers of a body that a material gives.
pub(crate) const MECHANICAL: [&str; 4] =
    ["youngs_modulus", "poissons_ratio", "hardness", "yield_strength"];
/// What names of numbers of one body, or of the second surface, begin with, by their sections.
pub(crate) const PREFIXES: [(&str, &str); 3] =
    [("body[1]", "body1_"), ("body[2]", "body2_"), (COUNTERFACE, "counterface_")];

/// The key in scene files of a number of a scene: `hardness` of `body1_hardness`.
#[must_use]
pub fn key_of_input(name: &str) -> &str {
    PREFIXES.iter().find_map(|(_, start)| name.strip_prefix(start)).unwrap_or(name)
}

impl Key {
    /// The key of this name in a section, or else the first of this name.
    #[must_use]
    pub fn find(section: &str, name: &str) -> Option<&'static Self> {
        let named = || KEYS.iter().filter(|key| key.name == name);
        named().find(|key| key.section == section).or_else(|| named().next())
    }

    /// Whether the number at a path may be known within a range.
    pub(crate) fn may_have_range(path: &str) -> bool {
        let (section, name) = section_and_name(path);
        let is_listed = |key: &Self| matches!(key.subject, Subject::Scan | Subject::Options);
        name == "skewness" || Self::find(section, name).is_some_and(|key| !is_listed(key))
    }

    /// The units of its number.
    pub(crate) fn units(&self) -> Option<&'static Units> {
        units().iter().find(|units| units.si == self.unit)
    }

    /// The meaning of the key at the end of a path; empty for unknown keys.
    pub(crate) fn meaning(path: &str) -> &'static str {
        let (section, name) = section_and_name(path);
        Self::find(section, name).map_or("", |key| key.meaning)
    }

    /// Where it is written.
    pub(crate) fn home(&self) -> String {
        match self.section {
            "" => "the top of the file, above every [section]".into(),
            "body" => "[[body]]".into(),
            section => format!("[{section}]"),
        }
    }
}

/// The names of the keys of a section; those of the second surface describe one surface.
pub(crate) fn keys_of(section: &str) -> Vec<&'static str> {
    let of_pair = |key: &Key| match key.subject {
        Subject::Surface => !["peklenik_number", "mean_plane_offset"].contains(&key.name),
        _ => key.name == "aligned",
    };
    let is_here = |key: &&Key| match section {
        COUNTERFACE => key.section == "surface" && !of_pair(key),
        section => key.section == section,
    };
    KEYS.iter().filter(is_here).map(|key| key.name).collect()
}

/// A key behind its section.
pub(crate) fn joined(section: &str, key: &str) -> String {
    let dot = if section.is_empty() || key.is_empty() { "" } else { "." };
    format!("{section}{dot}{key}")
}

/// The section of a path and its last key, without numbers of bodies.
pub(crate) fn section_and_name(path: &str) -> (&str, &str) {
    let (section, name) = path.rsplit_once('.').unwrap_or(("", path));
    let bare = |name: &'_ str| name.find('[').unwrap_or(name.len());
    (&section[..bare(section)], &name[..bare(name)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::template;

    #[test]
    fn the_template_has_every_key_and_says_what_the_table_says() {
        for key in KEYS {
            let is_here = |line: &str| {
                let line = line.trim_start_matches(['#', ' ', '[']);
                line.starts_with(key.name) && line.ends_with(key.meaning)
            };
            assert!(template().lines().any(is_here), "{} {}", key.section, key.name);
        }
    }

    #[test]
    fn every_field_of_a_struct_of_the_library_is_a_key() {
        let declared = |section: &str, fields: serde_json::Value, but: &[&str]| {
            let mut known = keys_of(section);
            known.retain(|name| !but.contains(name));
            let mut fields: Vec<&String> = fields.as_object().unwrap().keys().collect();
            known.sort_unstable();
            fields.sort_unstable();
            assert_eq!(known, fields, "{section}");
        };
        let body = serde_json::to_value(Body::elastic(1e9, 0.3)).unwrap();
        declared("body", body, &["material"]);
        declared("interface", serde_json::to_value(Interface::new(1e9, 0.3, 1e9)).unwrap(), &[]);
        let options = crate::ModelOptions {
            hurst_exponent: Some(0.8),
            friction_cut_off: Some(0.01),
            boundary: Some(asperity_bem::Continuation::Free),
            ..Default::default()
        };
        declared("options", serde_json::to_value(options).unwrap(), &[]);
    }

    #[test]
    fn units_and_other_names_are_known() {
        for key in KEYS.iter().filter(|key| !key.unit.is_empty()) {
            assert!(key.units().is_some(), "{}", key.unit);
        }
        assert_eq!(section_and_name("body[2].hardness"), ("body", "hardness"));
        assert_eq!((section_and_name("body[2]"), section_and_name("")), (("", "body"), ("", "")));
        assert!(keys_of(COUNTERFACE).contains(&"pixel_size"));
        assert!(!keys_of(COUNTERFACE).contains(&"heights"));
    }
}

//! Numbers of a scene by their keys: to read and to replace.

use std::iter::once;

use asperity::{
    Body, ContactError, HeightDistribution, Interface, WeibullHeights, nearest_hint, nearest_name,
};

use crate::keys::{BODY, Field, INTERFACE, KEYS, Key, SURFACE};
use crate::{SceneError, SceneFile, interface_of};

/// A number of a scene that can be read and replaced.
#[derive(Debug, Clone, Copy)]
pub struct SceneInput(Input);

#[derive(Debug, Clone, Copy)]
enum Input {
    Interface(Field<Interface>),
    /// A number of one body, by its index.
    Body(usize, Field<Body>),
    /// A number of every body.
    Bodies(Field<Body>),
    /// A number of the first surface, by its key.
    Surface(&'static str),
    NominalArea,
    MeanPlaneOffset,
    Skewness,
}

/// The numbers of an interface that do not follow from its bodies.
const OF_PAIR: [&str; 2] = ["work_of_adhesion", "pressure_factor"];

/// The key in scene files of an input: `hardness` of `body1_hardness`.
#[must_use]
pub fn key_of_input(name: &str) -> &str {
    ["body1_", "body2_"].iter().find_map(|body| name.strip_prefix(body)).unwrap_or(name)
}

impl SceneFile {
    /// Every number of this scene that can be replaced, by its name: the keys of its file, of two
    /// bodies for both of them and as `body1_hardness` and so on for one; and numbers that any
    /// surface and interface have: the asperities of the surface, of two surfaces those of the
    /// first, with `plasticity_index` and `roughness_parameter`, and the equivalent moduli.
    #[must_use]
    pub fn all_inputs(&self) -> Vec<(String, SceneInput)> {
        let written = self.written.iter().take(1).flat_map(|first| first.keys.iter().copied());
        let mut of_surface: Vec<&'static str> = vec![];
        // None where numbers of a surface follow from ranges, or from the scans of two surfaces.
        if self.first_written().is_some() {
            let of_any = SURFACE.iter().map(|field| field.name);
            let of_any = of_any.chain(["plasticity_index", "roughness_parameter"]);
            for key in written.chain(of_any) {
                if !of_surface.contains(&key) {
                    of_surface.push(key);
                }
            }
        }
        let of_body = |body: usize| {
            let name = move |key: &str| format!("body{}_{key}", body + 1);
            BODY.iter().map(move |field| (name(field.name), Input::Body(body, *field)))
        };
        let of_bodies = BODY.iter().filter(|_| !self.bodies.is_empty());
        let of_bodies: Vec<_> = of_bodies.map(|of| (of.name, Input::Bodies(*of))).collect();
        let is_own =
            |field: &&Field<Interface>| of_bodies.iter().all(|(name, _)| *name != field.name);
        let of_interface = INTERFACE.iter().filter(is_own);
        let skewed = matches!(self.scene.heights, HeightDistribution::Weibull(_));
        let offset = self.mean_plane_offsets()[0].filter(|_| self.table.is_none());
        let of_surface = of_surface.into_iter().map(|key| (key, Input::Surface(key)));
        of_interface
            .map(|field| (field.name, Input::Interface(*field)))
            .chain(of_bodies.iter().copied())
            .chain(of_surface)
            .chain(once(("nominal_area", Input::NominalArea)))
            .chain(offset.map(|_| ("mean_plane_offset", Input::MeanPlaneOffset)))
            .chain(skewed.then_some(("skewness", Input::Skewness)))
            .map(|(name, input)| (name.to_string(), input))
            .chain((0..self.bodies.len()).flat_map(of_body))
            .map(|(name, input)| (name, SceneInput(input)))
            .collect()
    }

    /// The inputs of these names.
    ///
    /// # Errors
    /// [`SceneError::Input`] for another name, for a number of both bodies beside that of one, for
    /// an equivalent modulus beside the numbers of bodies from which it follows, and for numbers
    /// that describe the surface in two ways.
    pub fn inputs<'n>(
        &self,
        names: impl IntoIterator<Item = &'n str>,
    ) -> Result<Vec<SceneInput>, SceneError> {
        let known = self.all_inputs();
        let input = |name: &'n str| {
            let found = known.iter().find(|(other, _)| other == name);
            found.map(|(_, input)| (name, input.0)).ok_or_else(|| self.unknown(name, &known))
        };
        let found = names.into_iter().map(input).collect::<Result<Vec<_>, _>>()?;
        let refused = |name: &str, reason| Err(SceneError::Input { name: name.into(), reason });
        for (name, input) in &found {
            let beside = |input: &Input| found.iter().find(|(_, other)| input.excludes(other));
            let Some((other, cause)) = beside(input) else { continue };
            let reason = match cause {
                Input::Body(_, Field { name: key, .. }) if key == name => format!(
                    "is that of all bodies and is given beside {other}: give {name} alone, or body1_{name} and body2_{name}"
                ),
                _ => format!("is given beside {other}, which determines it: leave {name} out"),
            };
            return refused(name, reason);
        }
        let of_surface = found.iter().filter(|(_, input)| matches!(input, Input::Surface(_)));
        let of_surface: Vec<&str> = of_surface.map(|(name, _)| *name).collect();
        if let Some(first) = self.first_written().filter(|f| f.way_with(&of_surface).is_none()) {
            let is_other = |name: &&&str| !first.keys.contains(*name);
            let other = of_surface.iter().find(is_other).copied().unwrap_or_default();
            let all = first.keys.join(", ");
            let rest = of_surface.iter().filter(|name| **name != other);
            let rest = rest.copied().collect::<Vec<_>>().join(" and ");
            let reason = format!(
                "is given beside {rest}, which describes the surface in another way: give numbers of one way; the surface is given by {all}"
            );
            return refused(other, reason);
        }
        Ok(found.into_iter().map(|(_, input)| SceneInput(input)).collect())
    }

    /// The error about a name that is no input of this scene.
    fn unknown(&self, name: &str, known: &[(String, SceneInput)]) -> SceneError {
        let names: Vec<&str> = known.iter().map(|(name, _)| &**name).collect();
        // Of another way to describe the surface, or of bodies that the scene does not have.
        let is_key = KEYS.iter().any(|key| key.name == key_of_input(name)) || name == "skewness";
        let of_body = names.iter().copied().find(|known| key_of_input(known) == name);
        let is_absent = is_key && of_body.is_none();
        let reason = is_absent.then(|| format!("; {name} needs a scene that is given by it"));
        let synonym = Key::synonym(name).filter(|(key, _)| names.contains(key));
        // What tells the input from the name that was meant.
        let difference = synonym.and_then(|(key, differs)| {
            let differs = differs.strip_prefix("it ")?;
            Some(format!("; {key} {}", differs.trim_end_matches("; ")))
        });
        let synonym = synonym.map(|(key, _)| key);
        let near = synonym.or(of_body).or_else(|| nearest_name(name, names.iter().copied()));
        let near = nearest_hint(near);
        let (known, reason) = (names.join(", "), difference.or(reason).unwrap_or_default());
        let reason =
            format!("is not an input of this scene{near}: one of {known} was required{reason}");
        SceneError::Input { name: name.into(), reason }
    }

    /// The value of an input; `None` for a number that the scene does not give, and for one in
    /// which its bodies differ.
    #[must_use]
    pub fn value_of(&self, input: SceneInput) -> Option<f64> {
        let scene = &self.scene;
        match input.0 {
            Input::Interface(Field { get, .. }) => get(&scene.interface),
            Input::Body(place, Field { get, .. }) => self.bodies.get(place).and_then(get),
            Input::Bodies(Field { get, .. }) => {
                let value = self.bodies.first().and_then(get);
                let bits = |value: Option<f64>| value.map(f64::to_bits);
                let is_same = |body: &Body| bits(get(body)) == bits(value);
                value.filter(|_| self.bodies.iter().all(is_same))
            }
            Input::Surface(key) => self.first_written()?.number(key, &scene.interface),
            Input::NominalArea => Some(scene.nominal_area),
            Input::MeanPlaneOffset => self.mean_plane_offsets()[0],
            Input::Skewness => match &scene.heights {
                HeightDistribution::Weibull(heights) => Some(heights.skewness()),
                _ => None,
            },
        }
    }

    /// The scene with other numbers, as its file with these numbers in the place of those written;
    /// their order does not matter. Asperities of a surface that is written or measured otherwise
    /// describe it from then on, together with the other asperities that it has, and the equivalent
    /// moduli the interface of bodies.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn with_inputs(
        &self,
        numbers: impl IntoIterator<Item = (SceneInput, f64)>,
    ) -> Result<Self, ContactError> {
        let mut file = self.clone();
        // Findings about the file are those of its own numbers.
        (file.warnings, file.stated, file.converted) = Default::default();
        let (mut of_interface, mut of_surface, mut offset) = (vec![], vec![], None);
        for (SceneInput(input), value) in numbers {
            match input {
                Input::Body(place, Field { set, .. }) => {
                    file.bodies.get_mut(place).into_iter().for_each(|body| set(body, value));
                }
                Input::Bodies(Field { set, .. }) => {
                    file.bodies.iter_mut().for_each(|body| set(body, value));
                }
                Input::Interface(Field { set, .. }) => of_interface.push((set, value)),
                Input::Surface(key) => of_surface.push((key, value)),
                Input::NominalArea => file.scene.nominal_area = value,
                Input::MeanPlaneOffset => offset = Some(value),
                Input::Skewness => {
                    let heights = WeibullHeights::new(value)?;
                    file.scene.heights = HeightDistribution::Weibull(heights);
                }
            }
        }
        if file.bodies != self.bodies {
            file.scene.interface = file.with_pair(interface_of(&file.bodies)?);
        }
        let of_bodies = file.scene.interface;
        of_interface.into_iter().for_each(|(set, value)| set(&mut file.scene.interface, value));
        if file.with_pair(of_bodies) != file.scene.interface {
            file.bodies.clear();
        }
        file = file.with_surface(&of_surface, offset)?;
        file.scene.asperity()?;
        Ok(file)
    }
}

impl Input {
    /// Whether a number has no meaning beside another one.
    fn excludes(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Bodies(all), Self::Body(_, one)) => all.name == one.name,
            (Self::Interface(own), Self::Body(_, body) | Self::Bodies(body)) => {
                let is_elastic = ["youngs_modulus", "poissons_ratio"].contains(&body.name);
                is_elastic && !OF_PAIR.contains(&own.name)
            }
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use crate::{SceneError, parse, template};

    #[test]
    fn skewness_and_offset_are_inputs_where_the_scene_gives_them() {
        let text = template()
            .replace("heights = \"gaussian\"", "heights = { skewness = -0.5 }")
            .replace("# mean_plane_offset", "mean_plane_offset");
        let file = parse(&text, Path::new(".")).unwrap();
        let inputs = file.inputs(["skewness", "mean_plane_offset"]).unwrap();
        let set = file.with_inputs(inputs.iter().copied().zip([0.25, 2e-6])).unwrap();
        let found: Vec<_> = inputs.iter().map(|input| set.value_of(*input)).collect();
        assert_eq!(found, [Some(0.25), Some(2e-6)]);
        assert!(file.with_inputs([(inputs[0], 7.0)]).is_err());
        let plain = parse(template(), Path::new(".")).unwrap();
        assert!(plain.inputs(["skewness"]).is_err());
    }

    #[test]
    fn unknown_names_and_numbers_that_follow_from_others_are_refused() {
        let file = parse(template(), Path::new(".")).unwrap();
        for (names, refused) in [
            (&["hardnes"][..], "hardnes"),
            (&["electrical_conductivity"], "electrical_conductivity"),
            (&["m0"], "m0"),
            (&["plasticity_index", "asperity_radius"], "plasticity_index"),
            (&["equivalent_modulus", "body1_youngs_modulus"], "equivalent_modulus"),
            (&["body1_hardness", "hardness"], "hardness"),
        ] {
            let error = file.inputs(names.iter().copied()).unwrap_err();
            assert!(matches!(&error, SceneError::Input { name, .. } if name == refused), "{error}");
        }
        assert!(file.inputs(["body1_youngs_modulus", "hardness"]).is_ok());
    }
}

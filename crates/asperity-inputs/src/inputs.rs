//! Numbers of a scene by their keys: to read and to replace.

use std::borrow::Cow;
use std::iter::once;

use asperity::{
    Body, ContactError, HeightDistribution, Interface, Scene, Surface, WeibullHeights,
    nearest_hint, nearest_name,
};

use crate::keys::{BODY, Field, INTERFACE, KEYS, Key, SURFACE};
use crate::{SceneError, SceneFile, interface_of};

/// A number of a scene that can be read and replaced.
#[derive(Debug, Clone, Copy)]
pub struct SceneInput(Input);

#[derive(Debug, Clone, Copy)]
enum Input {
    Interface(Field<Interface>),
    Surface(Field<Surface>),
    /// A number of one body, by its index.
    Body(usize, Field<Body>),
    /// A number of every body.
    Bodies(Field<Body>),
    /// One of the numbers from which the asperities follow.
    Roughness(usize),
    NominalArea,
    /// Radius and density follow from this and the next.
    PlasticityIndex,
    RoughnessParameter,
    MeanPlaneOffset,
    Skewness,
}

/// The number of this key that is the same in all bodies.
const YOUNGS_MODULUS: &str = "youngs_modulus";

/// The key in scene files of an input: `hardness` of `body1_hardness`.
#[must_use]
pub fn key_of_input(name: &str) -> &str {
    ["body1_", "body2_"].iter().find_map(|body| name.strip_prefix(body)).unwrap_or(name)
}

impl SceneFile {
    /// Every number of this scene that can be replaced, by its name: the keys of the interface,
    /// the surface and the nominal area, with bodies also `body1_hardness` and so on, and
    /// `plasticity_index` and `roughness_parameter`, from which radius and density follow.
    #[must_use]
    pub fn all_inputs(&self) -> Vec<(String, SceneInput)> {
        let keys = self.roughness.iter().flat_map(|roughness| roughness.way.keys().iter().zip(0..));
        let described = keys.map(|(name, place)| (*name, Input::Roughness(place)));
        let of_body = |body: usize| {
            let name = move |key: &str| format!("body{}_{key}", body + 1);
            BODY.iter().map(move |field| (name(field.name), Input::Body(body, *field)))
        };
        let modulus = |body: &Body| body.youngs_modulus.to_bits();
        let alike = self.bodies.windows(2).all(|two| modulus(&two[0]) == modulus(&two[1]));
        let of_all = BODY.iter().filter(|field| field.name == YOUNGS_MODULUS);
        let of_all = of_all.filter(|_| alike && !self.bodies.is_empty());
        let skewed = matches!(self.scene.heights, HeightDistribution::Weibull(_));
        let offset = self.mean_plane_offsets()[0].filter(|_| self.table.is_none());
        // Numbers of a surface that is known within ranges follow from these.
        let is_open = !self.spreads().is_empty();
        let of_surface = |input: &(&str, Input)| {
            let of_surface = matches!(
                input.1,
                Input::Surface(_) | Input::PlasticityIndex | Input::RoughnessParameter
            );
            !(of_surface && is_open)
        };
        // Radius and density beside the standard deviation of the surface heights come first.
        described
            .chain(INTERFACE.iter().map(|field| (field.name, Input::Interface(*field))))
            .chain(SURFACE.iter().map(|field| (field.name, Input::Surface(*field))))
            .chain(once(("nominal_area", Input::NominalArea)))
            .chain([
                ("plasticity_index", Input::PlasticityIndex),
                ("roughness_parameter", Input::RoughnessParameter),
            ])
            .chain(offset.map(|_| ("mean_plane_offset", Input::MeanPlaneOffset)))
            .chain(skewed.then_some(("skewness", Input::Skewness)))
            .chain(of_all.map(|field| (field.name, Input::Bodies(*field))))
            .filter(of_surface)
            .map(|(name, input)| (name.to_string(), input))
            .chain((0..self.bodies.len()).flat_map(of_body))
            .map(|(name, input)| (name, SceneInput(input)))
            .collect()
    }

    /// The inputs of these names.
    ///
    /// # Errors
    /// [`SceneError::Input`] for another name, and for a number beside another from which it
    /// follows.
    pub fn inputs<'n>(
        &self,
        names: impl IntoIterator<Item = &'n str>,
    ) -> Result<Vec<SceneInput>, SceneError> {
        let known = self.all_inputs();
        let input = |name: &'n str| {
            let found = known.iter().find(|(other, _)| other == name);
            found.map(|(_, input)| (name, *input)).ok_or_else(|| self.unknown(name, &known))
        };
        let found = names.into_iter().map(input).collect::<Result<Vec<_>, _>>()?;
        for (name, follows) in &found {
            let cause = found.iter().find(|(_, cause)| cause.0.determines(name, &follows.0));
            if let Some((cause, _)) = cause {
                return Err(determined(name, cause, &known));
            }
        }
        Ok(found.into_iter().map(|(_, input)| input).collect())
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

    /// The value of an input; `None` for a number that the scene does not give.
    #[must_use]
    pub fn value_of(&self, input: SceneInput) -> Option<f64> {
        let scene = &self.scene;
        match input.0 {
            Input::Interface(Field { get, .. }) => get(&scene.interface),
            Input::Surface(Field { get, .. }) => get(&scene.surface),
            Input::Body(place, Field { get, .. }) => self.bodies.get(place).and_then(get),
            Input::Bodies(Field { get, .. }) => self.bodies.first().and_then(get),
            Input::Roughness(place) => self.roughness?.numbers.get(place).copied(),
            Input::NominalArea => Some(scene.nominal_area),
            Input::PlasticityIndex => scene.plasticity_index().ok(),
            Input::RoughnessParameter => Some(scene.surface.roughness_parameter()),
            Input::MeanPlaneOffset => self.mean_plane_offsets()[0],
            Input::Skewness => match &scene.heights {
                HeightDistribution::Weibull(heights) => Some(heights.skewness()),
                _ => None,
            },
        }
    }

    /// The scene with other numbers.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn with_inputs(
        &self,
        numbers: impl IntoIterator<Item = (SceneInput, f64)>,
    ) -> Result<Self, ContactError> {
        let (mut bodies, mut roughness) = (self.bodies.clone(), self.roughness);
        let numbers: Vec<(SceneInput, f64)> = numbers.into_iter().collect();
        for (SceneInput(input), value) in &numbers {
            match input {
                Input::Body(place, Field { set, .. }) => {
                    bodies.get_mut(*place).into_iter().for_each(|body| set(body, *value));
                }
                Input::Bodies(Field { set, .. }) => {
                    bodies.iter_mut().for_each(|body| set(body, *value))
                }
                Input::Roughness(place) => {
                    let numbers = roughness.iter_mut().flat_map(|roughness| &mut roughness.numbers);
                    numbers.skip(*place).take(1).for_each(|number| *number = *value);
                }
                _ => {}
            }
        }
        let mut made = Cow::Borrowed(self);
        let Scene { surface, nominal_area, .. } = self.scene;
        if bodies != self.bodies {
            let interface = self.with_pair(interface_of(&bodies)?);
            let other = self.with_numbers(interface, surface, nominal_area)?;
            made = Cow::Owned(Self { bodies, ..other });
        }
        if let Some(other) = roughness.filter(|_| roughness != self.roughness) {
            let follows_from = other.way.keys();
            let interface = made.scene.interface;
            let of_surface = made.with_numbers(interface, other.surface()?, nominal_area)?;
            made = Cow::Owned(Self { roughness, follows_from, ..of_surface });
        }
        let file = &*made;
        let mut scene = file.scene.clone();
        let (mut index, mut parameter, mut offset, mut skewness) = (None, None, None, None);
        for (SceneInput(input), value) in numbers {
            match input {
                Input::Body(..) | Input::Bodies(_) | Input::Roughness(_) => {}
                Input::Interface(Field { set, .. }) => set(&mut scene.interface, value),
                Input::Surface(Field { set, .. }) => set(&mut scene.surface, value),
                Input::NominalArea => scene.nominal_area = value,
                Input::PlasticityIndex => index = Some(value),
                Input::RoughnessParameter => parameter = Some(value),
                Input::MeanPlaneOffset => offset = Some(value),
                Input::Skewness => skewness = Some(value),
            }
        }
        if index.is_some() || parameter.is_some() {
            let index = index.map_or_else(|| file.scene.plasticity_index(), Ok)?;
            let parameter = parameter.unwrap_or_else(|| file.scene.surface.roughness_parameter());
            let height_std = scene.surface.asperity_height_std;
            scene.surface =
                Surface::from_plasticity_index(index, parameter, height_std, &scene.interface)?;
        }
        let mut made = file.with_numbers(scene.interface, scene.surface, scene.nominal_area)?;
        if let Some(skewness) = skewness {
            made.scene.heights = HeightDistribution::Weibull(WeibullHeights::new(skewness)?);
        }
        if offset.is_some() {
            made.set_mean_plane_offsets([offset, made.mean_plane_offsets()[1]]);
            made.scene.asperity()?;
        }
        Ok(made)
    }
}

/// The error about a number that another one replaces; a number of the interface that bodies have
/// as well is given there.
fn determined(name: &str, by: &str, known: &[(String, SceneInput)]) -> SceneError {
    let own = format!("body1_{name}");
    let has_own = known.iter().any(|(known, _)| *known == own) && !by.ends_with(name);
    let instead = if has_own { format!(", or give {own}") } else { String::new() };
    let reason = format!("is given beside {by}, which determines it: leave {name} out{instead}");
    SceneError::Input { name: name.into(), reason }
}

impl Input {
    /// Whether a number follows from this one, so that both together have no meaning.
    fn determines(&self, name: &str, other: &Self) -> bool {
        let of_pair = || matches!(name, "work_of_adhesion" | "pressure_factor");
        match (self, other) {
            (Self::PlasticityIndex | Self::RoughnessParameter, Self::Surface(_)) => {
                name != "asperity_height_std"
            }
            (Self::PlasticityIndex | Self::RoughnessParameter, Self::Roughness(_))
            | (Self::Roughness(_), Self::Surface(_)) => true,
            (Self::Body(..) | Self::Bodies(_), Self::Interface(_)) => !of_pair(),
            (Self::Bodies(_), Self::Body(..)) => name.ends_with(YOUNGS_MODULUS),
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use crate::{parse, template};

    #[test]
    fn every_number_that_a_scene_gives_is_read_and_set_by_its_key() {
        let file = parse(template(), Path::new(".")).unwrap();
        for (name, input) in file.all_inputs() {
            let Some(value) = file.value_of(input) else { continue };
            let set = file.with_inputs([(input, 0.9 * value)]).unwrap();
            // Of bodies, the equivalent numbers follow.
            let again = set.inputs([&*name]).unwrap()[0];
            let found = set.value_of(again);
            let found = found.unwrap_or_else(|| panic!("{name} is set"));
            assert!((found / (0.9 * value) - 1.0).abs() < 1e-12, "{name}: {found} of {value}");
        }
        let shear = file.inputs(["thermal_conductivity"]).unwrap()[0];
        assert_eq!(file.value_of(shear), None);
    }

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
        let refused = plain.inputs(["skewness"]).unwrap_err().to_string();
        assert!(refused.ends_with("; skewness needs a scene that is given by it"), "{refused}");
    }

    #[test]
    fn unknown_names_and_numbers_that_follow_from_others_are_refused() {
        let file = parse(template(), Path::new(".")).unwrap();
        let refused = |names: &[&str]| file.inputs(names.iter().copied()).unwrap_err().to_string();
        let near = refused(&["hardnes"]);
        assert!(near.starts_with(
            "hardnes is not an input of this scene (the nearest is \"hardness\"): one of"
        ));
        let inverse = refused(&["electrical_conductivity"]);
        assert!(inverse.contains("(the nearest is \"electrical_resistivity\")"), "{inverse}");
        assert!(inverse.ends_with("; electrical_resistivity is 1/conductivity, in ohm m"));
        assert!(refused(&["m0"]).ends_with("; m0 needs a scene that is given by it"));
        let wanted = "asperity_radius is given beside plasticity_index, which determines it: leave asperity_radius out";
        assert_eq!(refused(&["plasticity_index", "asperity_radius"]), wanted);
        let wanted = "hardness is given beside body1_youngs_modulus, which determines it: leave hardness out, or give body1_hardness";
        assert_eq!(refused(&["hardness", "body1_youngs_modulus"]), wanted);
        let wanted =
            "hardness is given beside body1_hardness, which determines it: leave hardness out";
        assert_eq!(refused(&["body1_hardness", "hardness"]), wanted);
    }
}

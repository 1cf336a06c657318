//! Numbers of a scene by their keys: to read and to replace.

use asperity::{
    Body, ContactError, HeightDistribution, Interface, WeibullHeights, nearest_hint, nearest_name,
};

use crate::curvature::Curvature;
use crate::error::SceneError;
use crate::finish::{Drawing, FINISH};
use crate::input::{Input, NUMBERS, SceneInput};
use crate::keys::{
    BODY, CURVATURE, Field, INTERFACE, Key, MECHANICAL, OF_PAIR, SECOND, key_of_input,
};
use crate::roughness::{Roughness, Way};
use crate::scene_file::SceneFile;
use crate::spec::{Bodies, Description, SceneSpec, SurfaceSpec};
use crate::unknown::Unknown;

impl SceneFile {
    /// Every number of this scene that can be replaced, by its name: the keys of its file, of two
    /// bodies for both of them and as `body1_hardness` and so on for one, of two surfaces for the
    /// first and as `counterface_m0` and so on for the second; and numbers that any surface and
    /// interface have: the asperities, with `plasticity_index` and `roughness_parameter`, and the
    /// equivalent moduli.
    #[must_use]
    pub fn all_inputs(&self) -> Vec<(String, SceneInput)> {
        let has_bodies = !self.bodies().is_empty();
        let is_own = |field: &&Field<Interface>| {
            !has_bodies || BODY.iter().all(|of_body| of_body.name != field.name)
        };
        let of_surface = |second: bool| {
            self.keys_of_surface(second).into_iter().map(move |key| Input::Surface(second, key))
        };
        let of_body = |body: usize| BODY.iter().map(move |field| Input::Body(body, *field));
        let is_skewed = matches!(self.scene.heights, HeightDistribution::Weibull(_));
        let numbers = NUMBERS.into_iter().filter(|(name, ..)| self.has(name));
        INTERFACE
            .iter()
            .filter(is_own)
            .map(|field| Input::Interface(*field))
            .chain(BODY.iter().filter(|_| has_bodies).map(|field| Input::Bodies(*field)))
            .chain(of_surface(false))
            .chain(self.fields_of_curvature().map(|field| Input::Curvature(*field)))
            .chain(numbers.map(Input::Scene))
            .chain(is_skewed.then_some(Input::Skewness))
            .chain((0..self.bodies().len()).flat_map(of_body))
            .chain(of_surface(true))
            .map(|input| (input.name(), SceneInput(input)))
            .collect()
    }

    /// The keys of `[curvature]` that are given, or may be beside these.
    fn fields_of_curvature(&self) -> impl Iterator<Item = &'static Field<Curvature>> {
        CURVATURE.iter().filter(|field| {
            self.spec.curvature.is_some_and(|mut bodies| {
                let value = (field.get)(&bodies).unwrap_or(1.0);
                (field.set)(&mut bodies, value);
                bodies.shape().is_ok()
            })
        })
    }

    /// Whether one of [`NUMBERS`] has a meaning in this scene.
    fn has(&self, name: &str) -> bool {
        let measured = self.measured.as_ref().map(|measured| &measured.statistics);
        let is_measured = || measured.is_some_and(|found| found.mean_plane_offset.is_some());
        match key_of_input(name) {
            _ if name.starts_with(SECOND) && self.spec.counterface.is_none() => false,
            "mean_plane_offset" => self.table().is_none() && !is_measured(),
            "nominal_area" => self.spec.curvature.is_none(),
            "gas_conductivity" | "gas_parameter" => self.spec.gas.is_some(),
            _ => true,
        }
    }

    /// The surface by three numbers: as written, or of a single surface by its asperities.
    fn roughness_of(&self, second: bool) -> Option<Roughness> {
        let one = self.spec.one(second)?;
        let is_alone = !second && (self.spec.counterface.is_none() || self.spec.pressed.is_some());
        let own = || Roughness::asperities(&self.scene.surface);
        one.roughness().or_else(|| is_alone.then(own))
    }

    /// The keys of numbers by which a surface is described or can be.
    fn keys_of_surface(&self, second: bool) -> Vec<&'static str> {
        let drawing = self.spec.one(second).and_then(SurfaceSpec::drawing);
        let mut keys = drawing.map_or(vec![], Drawing::open_keys);
        if let Some(written) = self.roughness_of(second) {
            let [asperities, index] = [Way::Asperities, Way::PlasticityIndex].map(Way::keys);
            for key in written.way.keys().iter().chain(asperities).chain(index) {
                if !keys.contains(key) {
                    keys.push(key);
                }
            }
        }
        keys
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
            found.map(|(_, input)| (name, input.0)).ok_or_else(|| Self::unknown(name, &known))
        };
        let found = names.into_iter().map(input).collect::<Result<Vec<_>, _>>()?;
        let refused = |name: &str, reason| Err(SceneError::Input { name: name.into(), reason });
        for (name, input) in &found {
            let beside = found.iter().find(|(_, other)| input.excludes(other));
            let Some((other, cause)) = beside else { continue };
            let reason = match cause {
                Input::Body(_, Field { name: key, .. }) if key == name => format!(
                    "is that of all bodies and is given beside {other}: give {name} alone, or body1_{name} and body2_{name}"
                ),
                _ => format!("is given beside {other}, which determines it: leave {name} out"),
            };
            return refused(name, reason);
        }
        for second in [false, true] {
            let of_surface = found.iter().filter_map(|(_, input)| match input {
                Input::Surface(of, key) if *of == second => Some(*key),
                _ => None,
            });
            let of_surface: Vec<&str> = of_surface.collect();
            let drawing = self.spec.one(second).and_then(SurfaceSpec::drawing);
            if drawing.is_some() && of_surface.iter().all(|key| FINISH.contains(key)) {
                continue;
            }
            let Some(first) = self.roughness_of(second) else { continue };
            if first.way_with(&of_surface).is_some() {
                continue;
            }
            let is_other = |name: &&&str| !first.way.keys().contains(*name);
            let other = of_surface.iter().find(is_other).copied().unwrap_or_default();
            let all = first.way.keys().join(", ");
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
    fn unknown(name: &str, known: &[(String, SceneInput)]) -> SceneError {
        let names: Vec<&str> = known.iter().map(|(name, _)| &**name).collect();
        let synonym = Key::synonym(name).map(|(key, _)| key).filter(|key| names.contains(key));
        let of_body = names.iter().copied().find(|known| key_of_input(known) == name);
        let near = synonym.or(of_body).or_else(|| nearest_name(name, names.iter().copied()));
        let (near, known) = (nearest_hint(near), names.join(", "));
        let reason = format!("is not an input of this scene{near}: one of {known} was required");
        SceneError::Input { name: name.into(), reason }
    }

    /// The value of an input; `None` for a number that the scene does not give, and for one in
    /// which its bodies differ.
    #[must_use]
    pub fn value_of(&self, input: SceneInput) -> Option<f64> {
        match input.0 {
            Input::Interface(Field { get, .. }) => get(&self.scene.interface),
            Input::Body(place, Field { get, .. }) => self.bodies().get(place).and_then(get),
            Input::Bodies(Field { get, .. }) => {
                let value = self.bodies().first().and_then(get);
                let bits = |value: Option<f64>| value.map(f64::to_bits);
                let is_same = |body: &Body| bits(get(body)) == bits(value);
                value.filter(|_| self.bodies().iter().all(is_same))
            }
            Input::Surface(second, key) => {
                let drawn = self.spec.one(second)?.drawing().and_then(|drawing| drawing.get(key));
                drawn.or_else(|| self.roughness_of(second)?.number(key, &self.scene.interface))
            }
            Input::Curvature(Field { get, .. }) => get(self.spec.curvature.as_ref()?),
            Input::Scene((_, get, _)) => get(&self.spec),
            Input::Skewness => match &self.scene.heights {
                HeightDistribution::Weibull(heights) => Some(heights.skewness()),
                _ => None,
            },
        }
    }

    /// The scene with other numbers, as its file with these numbers in the place of those written;
    /// their order does not matter. Asperities of a surface that is written or measured otherwise
    /// describe it from then on, together with the other asperities that it has, the equivalent
    /// moduli the interface of bodies, and numbers of a body replace its material.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn with_inputs(
        &self,
        numbers: impl IntoIterator<Item = (SceneInput, f64)>,
    ) -> Result<Self, ContactError> {
        let mut spec = self.spec.clone();
        let (mut of_interface, mut of_surface) = (vec![], [vec![], vec![]]);
        let mut set: Vec<Input> = vec![];
        for (SceneInput(input), value) in numbers {
            set.push(input);
            match input {
                Input::Body(place, field) => spec.bodies.set(&field, value, |k| k == place),
                Input::Bodies(field) => spec.bodies.set(&field, value, |_| true),
                Input::Interface(field) => of_interface.push((field, value)),
                Input::Surface(second, key) => of_surface[usize::from(second)].push((key, value)),
                Input::Curvature(field) => {
                    spec.curvature.iter_mut().for_each(|bodies| (field.set)(bodies, value));
                }
                Input::Scene((_, _, set)) => set(&mut spec, value),
                Input::Skewness => {
                    let heights = WeibullHeights::new(value)?;
                    spec.heights = HeightDistribution::Weibull(heights).into();
                }
            }
        }
        spec.bodies.set_together(&of_interface)?;
        for (second, given) in [false, true].into_iter().zip(&of_surface) {
            if !given.is_empty() {
                self.describe(&mut spec, second, given)?;
            }
        }
        let mut made = Self::of_spec(spec)?;
        // A number that was set, or is not that of the scene any more, has no range.
        let bits = |value: f64| value.to_bits();
        let keeps = |(input, one): &(SceneInput, Unknown)| {
            let is_set = set.iter().any(|set| set.sets(&input.0));
            !is_set && made.value_of(*input).map(bits) == Some(bits(one.middle()))
        };
        made.ranges = self.ranges.iter().filter(|one| keeps(one)).cloned().collect();
        Ok(made)
    }

    /// Sets numbers that describe a surface.
    fn describe(
        &self,
        spec: &mut SceneSpec,
        second: bool,
        given: &[(&'static str, f64)],
    ) -> Result<(), ContactError> {
        let is_drawn = given.iter().all(|(key, _)| FINISH.contains(key));
        let one = spec.surface_mut(second);
        if let Some(SurfaceSpec { by: Description::Drawing(drawing), .. }) = one
            && is_drawn
        {
            given.iter().for_each(|(key, value)| drawing.set(key, *value));
            return Ok(());
        }
        let Some(before) = self.roughness_of(second) else { return Ok(()) };
        let edited = before.with(given, || spec.bodies.middle())?;
        let is_written = spec.surface_mut(second).is_some_and(|one| one.roughness().is_some());
        // A scan stays where its numbers do.
        if !is_written && edited == before {
            return Ok(());
        }
        if !is_written {
            // What was measured is valid for its own surface only.
            (spec.pressed, spec.counterface, spec.heights.is_measured) = (None, None, false);
            spec.surface.mean_plane_offset = None;
        }
        if let Some(one) = spec.surface_mut(second) {
            one.by = Description::Numbers(edited);
        }
        Ok(())
    }
}

impl Bodies {
    /// Sets a number of some bodies, by their index.
    fn set(&mut self, field: &Field<Body>, value: f64, is_of: impl Fn(usize) -> bool) {
        let Self::Each { bodies, materials, .. } = self else { return };
        for (k, body) in bodies.iter_mut().enumerate().filter(|(k, _)| is_of(*k)) {
            (field.set)(body, value);
            if let Some(material) =
                materials.get_mut(k).filter(|_| MECHANICAL.contains(&field.name))
            {
                *material = None;
            }
        }
    }

    /// Sets numbers of both bodies together: those that follow from the bodies replace these.
    fn set_together(&mut self, given: &[(Field<Interface>, f64)]) -> Result<(), ContactError> {
        if let Self::Each { work_of_adhesion, .. } = self {
            let of_pair = given.iter().find(|(field, _)| field.name == OF_PAIR[0]);
            *work_of_adhesion = of_pair.map(|(_, value)| *value).or(*work_of_adhesion);
        }
        if given.is_empty() {
            return Ok(());
        }
        let before = self.interface()?;
        let mut interface = before;
        given.iter().for_each(|(field, value)| (field.set)(&mut interface, *value));
        if interface != before {
            *self = Self::Interface(interface);
        }
        Ok(())
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

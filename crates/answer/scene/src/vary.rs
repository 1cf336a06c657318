//! Numbers of a scene by their keys: to read and to replace.

use asperity::{
    Body, ContactError, HeightDistribution, WeibullHeights, nearest_hint, nearest_name,
};

use crate::error::SceneError;
use crate::input::{EACH, OF_BOTH, OWN, SCENE, SceneInput};
use crate::keys::{
    BODY, COUNTERFACE, CURVATURE, Field, GAP, INTERFACE, MECHANICAL, SEAL, key_of_input,
};
use crate::scene_file::SceneFile;
use crate::spec::{Bodies, Description, SAME, SceneSpec, SurfaceSpec};
use crate::unknown::Unknown;

fn named<T>(
    section: &'static str,
    fields: &'static [Field<T>],
) -> impl Iterator<Item = SceneInput> {
    fields.iter().map(move |field| SceneInput { section, key: field.name })
}

impl SceneFile {
    /// Every number of this scene that can be replaced, by its name: the keys that its file has or
    /// can have beside the others, of two bodies for both of them and as `body1_hardness` and so on
    /// for one, of two surfaces for the first (both where they are written as the same) and as
    /// `counterface_m0` and so on for the second.
    #[must_use]
    pub fn all_inputs(&self) -> Vec<(String, SceneInput)> {
        let SceneSpec { curvature, gas, .. } = &self.spec;
        let bodies = self.bodies().len();
        let mut all: Vec<SceneInput> = named("interface", INTERFACE).collect();
        if bodies > 0 {
            all = named("", OF_BOTH).chain(named("body", BODY)).collect();
        }
        for (section, one) in self.spec.surfaces() {
            all.extend(one.open_keys().into_iter().map(|key| SceneInput { section, key }));
            let follows = |one: &SceneInput| one.key == "mean_plane_offset" && self.has_offset();
            all.extend(named(section, OWN).filter(|one| !follows(one)));
        }
        all.extend(named("", SCENE).filter(|_| curvature.is_none()));
        all.extend(named("gap", GAP).filter(|_| gas.is_some()));
        let skewness = SceneInput { section: "surface.heights", key: "skewness" };
        let given = named("curvature", CURVATURE).chain(named("seal", SEAL)).chain([skewness]);
        all.extend(given.filter(|one| self.value_of(*one).is_some()));
        all.extend(EACH.into_iter().take(bodies).flat_map(|section| named(section, BODY)));
        all.into_iter().map(|input| (input.name(), input)).collect()
    }

    /// Whether the offset of the mean plane follows from measured heights.
    fn has_offset(&self) -> bool {
        let measured = self.measured.as_ref().map(|measured| &measured.statistics);
        self.table().is_some() || measured.is_some_and(|found| found.mean_plane_offset.is_some())
    }

    /// The inputs of these names.
    ///
    /// # Errors
    /// [`SceneError::Input`] for another name, and for a number of both bodies beside that of one.
    pub fn inputs<'n>(
        &self,
        names: impl IntoIterator<Item = &'n str>,
    ) -> Result<Vec<SceneInput>, SceneError> {
        let known = self.all_inputs();
        let input = |name: &'n str| {
            let found = known.iter().find(|(other, _)| other == name);
            found.map(|(_, input)| *input).ok_or_else(|| Self::unknown(name, &known))
        };
        let found = names.into_iter().map(input).collect::<Result<Vec<_>, _>>()?;
        for one in &found {
            let is_set = |other: &&SceneInput| one != *other && one.sets(**other);
            let Some(other) = found.iter().find(is_set) else { continue };
            let (name, other) = (one.name(), other.name());
            let reason =
                format!("is given beside {other}, which determines it: give one of the two");
            return Err(SceneError::Input { name, reason });
        }
        Ok(found)
    }

    /// The error about a name that is no input of this scene.
    fn unknown(name: &str, known: &[(String, SceneInput)]) -> SceneError {
        let names: Vec<&str> = known.iter().map(|(name, _)| &**name).collect();
        let of_body = names.iter().copied().find(|known| key_of_input(known) == name);
        let near = of_body.or_else(|| nearest_name(name, names.iter().copied()));
        let (near, known) = (nearest_hint(near), names.join(", "));
        let reason = format!("is not an input of this scene{near}: one of {known} was required");
        SceneError::Input { name: name.into(), reason }
    }

    /// The value of an input; `None` for a number that the scene does not give, and for one in
    /// which its bodies differ.
    #[must_use]
    pub fn value_of(&self, SceneInput { section, key }: SceneInput) -> Option<f64> {
        let spec = &self.spec;
        match section {
            "" => Field::value(SCENE, key, spec).or_else(|| Field::value(OF_BOTH, key, spec)),
            "interface" => Field::value(INTERFACE, key, &self.scene.interface),
            "curvature" => Field::value(CURVATURE, key, spec.curvature.as_ref()?),
            "gap" => Field::value(GAP, key, spec.gas.as_ref()?),
            "seal" => Field::value(SEAL, key, spec.seal.as_ref()?),
            "surface.heights" => match &self.scene.heights {
                HeightDistribution::Weibull(heights) => Some(heights.skewness()),
                _ => None,
            },
            "surface" | COUNTERFACE => {
                let one = spec.one(section)?;
                let written = || one.numbers().into_iter().find(|(name, _)| *name == key);
                Field::value(OWN, key, one).or_else(|| written().map(|(_, value)| value))
            }
            bodies => {
                let is_of = |(_, each): &(&Body, &str)| bodies == "body" || bodies == *each;
                let mut of = self.bodies().iter().zip(EACH).filter(is_of);
                let mut values = of.by_ref().map(|(body, _)| Field::value(BODY, key, body));
                let first = values.next()??;
                values.all(|one| one.map(f64::to_bits) == Some(first.to_bits())).then_some(first)
            }
        }
    }

    /// The scene with other numbers, as its file with these numbers in the place of those written;
    /// their order does not matter. Numbers of a body replace its material.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn with_inputs(
        &self,
        numbers: impl IntoIterator<Item = (SceneInput, f64)>,
    ) -> Result<Self, ContactError> {
        let mut spec = self.spec.clone();
        let area = |spec: &SceneSpec| spec.seal.and_then(|seal| seal.area());
        let follows = area(&spec) == Some(spec.nominal_area);
        let numbers: Vec<(SceneInput, f64)> = numbers.into_iter().collect();
        let set: Vec<SceneInput> = numbers.iter().map(|(input, _)| *input).collect();
        let is_second = |one: &SceneInput| one.section == COUNTERFACE;
        let is_same = spec.is_same() && !set.iter().any(is_second);
        for (input, value) in numbers {
            let SceneInput { section, key } = input;
            match section {
                "" => {
                    Field::put(SCENE, key, &mut spec, value);
                    Field::put(OF_BOTH, key, &mut spec, value);
                }
                "interface" => {
                    if let Bodies::Interface(interface) = &mut spec.bodies {
                        Field::put(INTERFACE, key, interface, value);
                    }
                }
                "curvature" => {
                    Field::put(CURVATURE, key, spec.curvature.get_or_insert_default(), value);
                }
                "gap" => spec.gas.iter_mut().for_each(|gas| Field::put(GAP, key, gas, value)),
                "seal" => Field::put(SEAL, key, spec.seal.get_or_insert_default(), value),
                "surface.heights" => {
                    let heights = WeibullHeights::new(value)?;
                    spec.heights = HeightDistribution::Weibull(heights).into();
                }
                "surface" | COUNTERFACE => {
                    let second = is_same.then_some(COUNTERFACE);
                    for section in [Some(section), second].into_iter().flatten() {
                        spec.surface_mut(section).into_iter().for_each(|one| one.set(key, value));
                    }
                }
                bodies => spec.bodies.set(bodies, key, value),
            }
        }
        if spec.counterface_word == Some(SAME) && !spec.is_same() {
            spec.counterface_word = None;
        }
        let is_given = set.iter().any(|one| Field::of(SCENE, one.key).is_some());
        spec.nominal_area =
            area(&spec).filter(|_| follows && !is_given).unwrap_or(spec.nominal_area);
        let mut made = Self::of_spec(spec)?;
        // A number that was set, or is not that of the scene any more, has no range.
        let bits = |value: f64| value.to_bits();
        let keeps = |(input, one): &(SceneInput, Unknown)| {
            let is_set = set.iter().any(|set| set.sets(*input));
            !is_set && made.value_of(*input).map(bits) == Some(bits(one.middle()))
        };
        made.ranges = self.ranges.iter().filter(|one| keeps(one)).cloned().collect();
        made.warnings = self.warnings.clone();
        Ok(made)
    }
}

impl Bodies {
    /// Sets a number of one of the bodies, or of both.
    fn set(&mut self, section: &str, key: &str, value: f64) {
        let Self::Each { bodies, materials, .. } = self else { return };
        let each = bodies.iter_mut().zip(materials).zip(EACH);
        for ((body, material), _) in each.filter(|(_, one)| section == "body" || section == *one) {
            Field::put(BODY, key, body, value);
            *material = material.filter(|_| !MECHANICAL.contains(&key));
        }
    }
}

impl SurfaceSpec {
    /// The keys of the numbers by which it is described or can be beside the others.
    fn open_keys(&self) -> Vec<&'static str> {
        match &self.by {
            Description::Numbers(roughness) => roughness.way.keys().to_vec(),
            Description::Drawing(drawing) => drawing.open_keys(),
            Description::Scan(_) => vec![],
        }
    }

    /// Sets a number of one of these keys, or one beside them.
    fn set(&mut self, key: &'static str, value: f64) {
        Field::put(OWN, key, self, value);
        match &mut self.by {
            _ if Field::of(OWN, key).is_some() => {}
            Description::Numbers(roughness) => roughness.set(key, value),
            Description::Drawing(drawing) => drawing.set(key, value),
            Description::Scan(_) => {}
        }
    }
}

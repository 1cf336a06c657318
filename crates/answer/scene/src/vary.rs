//! Numbers of a scene by their keys: to read and to replace.

use asperity::{
    Body, ContactError, HeightDistribution, Interface, WeibullHeights, nearest_hint, nearest_name,
};

use crate::error::SceneError;
use crate::finish::{Drawing, FINISH};
use crate::input::{EACH, OWN, SCENE, SceneInput};
use crate::keys::{
    BODY, COUNTERFACE, CURVATURE, Field, GAP, INTERFACE, MECHANICAL, OF_PAIR, SEAL, key_of_input,
};
use crate::roughness::{Roughness, Way};
use crate::scene_file::SceneFile;
use crate::spec::{Bodies, Description, SceneSpec, SurfaceSpec};
use crate::unknown::Unknown;

fn named<T>(
    section: &'static str,
    fields: &'static [Field<T>],
) -> impl Iterator<Item = SceneInput> {
    fields.iter().map(move |field| SceneInput { section, key: field.name })
}

impl SceneFile {
    /// Every number of this scene that can be replaced, by its name: the keys of its file, of two
    /// bodies for both of them and as `body1_hardness` and so on for one, of two surfaces for the
    /// first and as `counterface_m0` and so on for the second; and numbers that any surface and
    /// interface have: the asperities, with `plasticity_index` and `roughness_parameter`, and the
    /// equivalent moduli.
    #[must_use]
    pub fn all_inputs(&self) -> Vec<(String, SceneInput)> {
        let SceneSpec { curvature, gas, .. } = &self.spec;
        let bodies = self.bodies().len();
        let is_of_pair = |one: &SceneInput| bodies == 0 || Field::of(BODY, one.key).is_none();
        let together = if bodies == 0 { "interface" } else { "" };
        let mut all: Vec<SceneInput> = named(together, INTERFACE).filter(is_of_pair).collect();
        all.extend(named("body", BODY).filter(|_| bodies > 0));
        for (section, _) in self.spec.surfaces() {
            let keys = self.keys_of_surface(section).into_iter();
            all.extend(keys.map(|key| SceneInput { section, key }));
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

    /// The surface by three numbers: as written, or of a single surface by its asperities.
    fn roughness_of(&self, section: &str) -> Option<Roughness> {
        let one = self.spec.one(section)?;
        let is_first = section != COUNTERFACE;
        let is_alone = is_first && (self.spec.counterface.is_none() || self.spec.pressed.is_some());
        let own = || Roughness::asperities(&self.scene.surface);
        one.roughness().or_else(|| is_alone.then(own))
    }

    /// The keys of numbers by which a surface is described or can be.
    fn keys_of_surface(&self, section: &str) -> Vec<&'static str> {
        let drawing = self.spec.one(section).and_then(SurfaceSpec::drawing);
        let mut keys = drawing.map_or(vec![], Drawing::open_keys);
        if let Some(written) = self.roughness_of(section) {
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
            found.map(|(_, input)| *input).ok_or_else(|| Self::unknown(name, &known))
        };
        let found = names.into_iter().map(input).collect::<Result<Vec<_>, _>>()?;
        for one in &found {
            let Some(other) = found.iter().find(|other| one.excludes(**other)) else { continue };
            let (name, other) = (one.name(), other.name());
            let reason =
                format!("is given beside {other}, which determines it: give one of the two");
            return Err(SceneError::Input { name, reason });
        }
        for (section, one) in self.spec.surfaces() {
            let is_of =
                |one: &&SceneInput| one.section == section && Field::of(OWN, one.key).is_none();
            let keys: Vec<&str> = found.iter().filter(is_of).map(|one| one.key).collect();
            let is_drawn = one.drawing().is_some();
            let Some(first) = self.roughness_of(section) else { continue };
            if is_drawn && keys.iter().all(|key| FINISH.contains(key))
                || first.way_with(&keys).is_some()
            {
                continue;
            }
            let is_other = |key: &&&str| !first.way.keys().contains(*key);
            let other = keys.iter().find(is_other).copied().unwrap_or_default();
            let own = first.way.keys().join(", ");
            let reason = format!(
                "describes the surface in another way: give numbers of one way; the surface is given by {own}"
            );
            return Err(SceneError::Input { name: other.into(), reason });
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
            "" | "interface" => Field::value(SCENE, key, spec)
                .or_else(|| Field::value(INTERFACE, key, &self.scene.interface)),
            "curvature" => Field::value(CURVATURE, key, spec.curvature.as_ref()?),
            "gap" => Field::value(GAP, key, spec.gas.as_ref()?),
            "seal" => Field::value(SEAL, key, spec.seal.as_ref()?),
            "surface.heights" => match &self.scene.heights {
                HeightDistribution::Weibull(heights) => Some(heights.skewness()),
                _ => None,
            },
            "surface" | COUNTERFACE => {
                let one = spec.one(section)?;
                let drawn = || one.drawing()?.get(key);
                let by_numbers = || self.roughness_of(section)?.number(key, &self.scene.interface);
                Field::value(OWN, key, one).or_else(drawn).or_else(by_numbers)
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
        let area = |spec: &SceneSpec| spec.seal.and_then(|seal| seal.area());
        let follows = area(&spec) == Some(spec.nominal_area);
        let mut of_interface = vec![];
        let mut of_surfaces = [("surface", vec![]), (COUNTERFACE, vec![])];
        let mut set: Vec<SceneInput> = vec![];
        for (input, value) in numbers {
            set.push(input);
            let SceneInput { section, key } = input;
            match section {
                "" | "interface" => match Field::of(SCENE, key) {
                    Some(field) => (field.set)(&mut spec, value),
                    None => of_interface.push((key, value)),
                },
                "curvature" => {
                    Field::put(CURVATURE, key, spec.curvature.get_or_insert_default(), value);
                }
                "gap" => spec.gas.iter_mut().for_each(|gas| Field::put(GAP, key, gas, value)),
                "seal" => Field::put(SEAL, key, spec.seal.get_or_insert_default(), value),
                "surface.heights" => {
                    let heights = WeibullHeights::new(value)?;
                    spec.heights = HeightDistribution::Weibull(heights).into();
                }
                "surface" | COUNTERFACE => match spec.surface_mut(section) {
                    Some(one) if Field::of(OWN, key).is_some() => Field::put(OWN, key, one, value),
                    _ => of_surfaces[usize::from(section == COUNTERFACE)].1.push((key, value)),
                },
                bodies => spec.bodies.set(bodies, key, value),
            }
        }
        let is_given = set.iter().any(|one| Field::of(SCENE, one.key).is_some());
        spec.nominal_area =
            area(&spec).filter(|_| follows && !is_given).unwrap_or(spec.nominal_area);
        spec.bodies.set_together(&of_interface)?;
        for (section, given) in of_surfaces.iter().filter(|(_, given)| !given.is_empty()) {
            self.describe(&mut spec, section, given)?;
        }
        let mut made = Self::of_spec(spec)?;
        // A number that was set, or is not that of the scene any more, has no range.
        let bits = |value: f64| value.to_bits();
        let keeps = |(input, one): &(SceneInput, Unknown)| {
            let is_set = set.iter().any(|set| set.sets(*input));
            !is_set && made.value_of(*input).map(bits) == Some(bits(one.middle()))
        };
        made.ranges = self.ranges.iter().filter(|one| keeps(one)).cloned().collect();
        Ok(made)
    }

    /// Sets numbers that describe a surface.
    fn describe(
        &self,
        spec: &mut SceneSpec,
        section: &str,
        given: &[(&'static str, f64)],
    ) -> Result<(), ContactError> {
        let is_drawn = given.iter().all(|(key, _)| FINISH.contains(key));
        let one = spec.surface_mut(section);
        if let Some(SurfaceSpec { by: Description::Drawing(drawing), .. }) = one
            && is_drawn
        {
            given.iter().for_each(|(key, value)| drawing.set(key, *value));
            return Ok(());
        }
        let Some(before) = self.roughness_of(section) else { return Ok(()) };
        let edited = before.with(given, || spec.bodies.middle())?;
        let is_written = spec.surface_mut(section).is_some_and(|one| one.roughness().is_some());
        // A scan stays where its numbers do.
        if !is_written && edited == before {
            return Ok(());
        }
        if !is_written {
            // What was measured is valid for its own surface only.
            (spec.pressed, spec.counterface, spec.heights.is_measured) = (None, None, false);
            spec.surface.mean_plane_offset = None;
        }
        if let Some(one) = spec.surface_mut(section) {
            one.by = Description::Numbers(edited);
        }
        Ok(())
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

    /// Sets numbers of both bodies together: those that follow from the bodies replace these.
    fn set_together(&mut self, given: &[(&str, f64)]) -> Result<(), ContactError> {
        if let Self::Each { work_of_adhesion, .. } = self {
            let of_pair = given.iter().find(|(key, _)| *key == OF_PAIR[0]);
            *work_of_adhesion = of_pair.map(|(_, value)| *value).or(*work_of_adhesion);
        }
        if given.is_empty() {
            return Ok(());
        }
        let before = self.interface()?;
        let mut interface: Interface = before;
        given.iter().for_each(|(key, value)| Field::put(INTERFACE, key, &mut interface, *value));
        if interface != before {
            *self = Self::Interface(interface);
        }
        Ok(())
    }
}

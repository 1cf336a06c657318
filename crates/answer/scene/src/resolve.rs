//! The scene that was written: what both bodies and both surfaces have together.

use std::borrow::Cow;
use std::sync::Arc;

use asperity::joints::conductance::gap_conductance;
use asperity::{ContactError, Interface, Pair, ProfileMoments, Scene, Surface, positive};
use asperity_topography::Statistics;

use crate::finish::Drawing;
use crate::keys::{COUNTERFACE, SEAL};
use crate::measured::Measured;
use crate::seal::Gas;
use crate::spec::{Bodies, SceneSpec, SurfaceSpec};

/// A number of a section that is out of range.
#[derive(Debug)]
pub(crate) struct Fault {
    pub(crate) section: Cow<'static, str>,
    pub(crate) source: ContactError,
}

fn at(section: &'static str) -> impl Fn(ContactError) -> Fault {
    move |source| Fault { section: section.into(), source }
}

/// The bandwidth α of the surface that stands in where a scan has no asperities.
const BANDWIDTH: f64 = 3.0;

/// One surface by itself.
struct One<'s> {
    /// 0 where the sum of aligned scans is measured instead.
    moments: ProfileMoments,
    /// Its asperities; none of a scan without any.
    asperities: Option<Surface>,
    /// The standard deviation of its heights \[m\], if it was given or measured.
    height_std: Option<f64>,
    measured: Option<&'s Arc<Measured>>,
}

impl<'s> One<'s> {
    fn new(spec: &'s SurfaceSpec, interface: &Interface) -> Result<Self, ContactError> {
        let of_drawing = spec.drawing().map(Drawing::roughness).transpose()?;
        if let Some(roughness) = spec.roughness().or(of_drawing) {
            let surface = roughness.surface(interface)?;
            let moments = roughness.moments(&surface);
            let height_std = roughness.way.is_of_surface().then(|| moments.m0.sqrt());
            return Ok(Self { moments, asperities: Some(surface), height_std, measured: None });
        }
        let measured = spec.measured();
        // Of aligned scans the sum is measured.
        let none = ProfileMoments { m0: 0.0, m2: 0.0, m4: 0.0 };
        let (moments, asperities) = measured.map_or((none, None), |measured| {
            (measured.statistics.moments.profile, measured.statistics.surface().ok())
        });
        let height_std = Some(moments.m0.sqrt());
        Ok(Self { moments, asperities, height_std, measured })
    }
}

impl SurfaceSpec {
    /// The moments of its profiles; none of aligned scans, and of numbers out of range.
    pub(crate) fn moments(&self, interface: &Interface) -> Option<ProfileMoments> {
        let moments = One::new(self, interface).ok()?.moments;
        Some(moments).filter(|of| of.m0 > 0.0)
    }
}

/// The statistics of what was measured: of the only scan, of aligned scans, or of two surfaces of
/// which one was.
fn measured(
    spec: &SceneSpec,
    one: &One<'_>,
    two: Option<&One<'_>>,
) -> Result<Option<Arc<Measured>>, ContactError> {
    if let Some(pressed) = &spec.pressed {
        return Ok(pressed.measured.clone());
    }
    let Some(two) = two else { return Ok(one.measured.cloned()) };
    // Moments of numbers beside a scan are isotropic and Gaussian.
    let (scan, other, pixel) = match (one.measured, two.measured) {
        (Some(first), Some(second)) => {
            (first, Cow::Borrowed(&second.statistics), second.pixel_size)
        }
        (Some(scan), None) => (scan, Cow::Owned(Statistics::gaussian(two.moments)), 0.0),
        (None, Some(scan)) => (scan, Cow::Owned(Statistics::gaussian(one.moments)), 0.0),
        (None, None) => return Ok(None),
    };
    let statistics = Statistics::combined(&scan.statistics, &other);
    let statistics = statistics.map_err(|error| ContactError::Refused {
        model: "surface".into(),
        reason: error.to_string(),
    })?;
    let pixel_size = scan.pixel_size.max(pixel);
    Ok(Some(Arc::new(Measured { statistics, pixel_size })))
}

/// A Gaussian surface with the rms height and slope of a scan without asperities.
fn alike(measured: &Statistics) -> Result<Surface, ContactError> {
    let ProfileMoments { m0, m2, .. } = measured.moments.profile;
    Surface::from_moments(&ProfileMoments { m0, m2, m4: BANDWIDTH * m2 * m2 / m0 })
}

/// The interface of the bodies; an error names the body.
fn interface(bodies: &Bodies) -> Result<Interface, Fault> {
    let found = bodies.middle().map_err(|source| {
        let mut each = bodies.list().iter().zip(1..);
        let first = each.find_map(|(body, k)| Some((k, Interface::against_rigid(body).err()?)));
        match first {
            Some((k, source)) => Fault { section: format!("body[{k}]").into(), source },
            None => at("body")(source),
        }
    })?;
    let is_each = matches!(bodies, Bodies::Each { .. });
    if !is_each || found.work_of_adhesion.is_some() {
        found.check().map_err(at(if is_each { "" } else { "interface" }))?;
    }
    Ok(found)
}

/// The scene of what was written, and the statistics of its scans.
pub(crate) fn resolve(spec: &SceneSpec) -> Result<(Scene, Option<Arc<Measured>>), Fault> {
    let interface = interface(&spec.bodies)?;
    positive("nominal_area", spec.nominal_area).map_err(at(""))?;
    for (section, one) in spec.surfaces() {
        let lay = one.peklenik_number.map(|number| positive("peklenik_number", number));
        lay.transpose().map_err(at(section))?;
    }
    spec.curvature.map(|bodies| bodies.shape()).transpose().map_err(at("curvature"))?;
    if let Some(Gas { gas_conductivity, gas_parameter }) = spec.gas {
        let checked = positive("gas_conductivity", gas_conductivity);
        let checked = checked.and_then(|gas| gap_conductance(gas, 1.0, gas_parameter));
        checked.map_err(at("gap"))?;
    }
    if let Some(seal) = &spec.seal {
        for field in SEAL.iter().filter(|field| field.name != "downstream_pressure") {
            positive(field.name, (field.get)(seal).unwrap_or(1.0)).map_err(at("seal"))?;
        }
        seal.resolved().map_err(at("seal"))?;
    }
    let of_surface = at("surface");
    let one = One::new(&spec.surface, &interface).map_err(&of_surface)?;
    let two = spec.counterface.as_ref().map(|two| One::new(two, &interface));
    let two = two.transpose().map_err(at(COUNTERFACE))?;
    let measured = measured(spec, &one, two.as_ref()).map_err(&of_surface)?;
    let statistics = measured.as_ref().map(|measured| &measured.statistics);
    let (surface, height_std) = match (statistics, &two, one.asperities) {
        (Some(found), ..) => {
            let surface = found.surface().or_else(|_| alike(found)).map_err(&of_surface)?;
            surface.check().map_err(&of_surface)?;
            (surface, Some(found.sq))
        }
        (None, None, Some(only)) => (only, one.height_std),
        (None, two, _) => {
            let moments = two.as_ref().map_or(one.moments, |two| one.moments.plus(&two.moments));
            (Surface::from_moments(&moments).map_err(&of_surface)?, Some(moments.m0.sqrt()))
        }
    };
    let mut scene = Scene::new(interface, surface, spec.nominal_area);
    scene.surface_height_std = height_std;
    scene.heights = spec.heights.distribution.clone();
    let independent = two.as_ref().filter(|_| spec.pressed.is_none());
    let each = independent.and_then(|two| one.asperities.zip(two.asperities));
    scene.pair = each.map(|(one, two)| Pair::new(one, two));
    let of_heights = spec.heights.table.as_ref().map(|table| table.mean());
    match of_heights.or(statistics.and_then(|found| found.mean_plane_offset)) {
        Some(measured) => scene.mean_plane_offset = Some(measured),
        None => set_mean_plane_offsets(&mut scene, spec),
    }
    scene.asperity().map_err(|source| {
        let is_of_plane = scene.mean_plane_offset.is_some_and(|offset| !offset.is_finite());
        at(if is_of_plane { "surface" } else { spec.bodies.section() })(source)
    })?;
    Ok((scene, measured))
}

/// Sets the heights of the means of the asperities above the mean planes \[m\] of both surfaces,
/// where they are given. The surface that is equivalent to both has the Gaussian offset of its own,
/// changed by the ratio of the sum of both offsets to that of Gaussian surfaces.
fn set_mean_plane_offsets(scene: &mut Scene, spec: &SceneSpec) {
    let second = spec.counterface.as_ref().and_then(|two| two.mean_plane_offset);
    let given = [spec.surface.mean_plane_offset, second];
    let Some(pair) = &mut scene.pair else {
        scene.mean_plane_offset = given[0];
        return;
    };
    if given == [None; 2] {
        return;
    }
    let gaussian = pair.mean_plane_offset();
    for (one, given) in pair.surfaces.iter_mut().zip(given) {
        one.mean_plane_offset = given;
    }
    let ratio = pair.mean_plane_offset() / gaussian;
    scene.mean_plane_offset = Some(scene.surface.mean_plane_offset() * ratio);
}

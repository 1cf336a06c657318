//! The scenes of `reference/models_scenes.csv`, and ways to make others.

use asperity::{
    AminiTehrani, AtReading, Citation, Contact, Gao, Interface, LateralOptions, Model, Provenance,
    Quantity, Request, Scene, Surface, Tolerance,
};

/// Models of the tests have a source in name alone.
macro_rules! described {
    ($($model:ty),*) => {
        $(impl asperity::Described for $model {
            fn citation(&self) -> &asperity::Citation {
                &$crate::scenes::NOBODY
            }
        })*
    };
}

pub(crate) use described;

pub const NOBODY: Citation = Citation {
    id: "mine",
    name: "mine",
    authors: "nobody",
    year: 2026,
    title: "a test",
    provenance: Provenance::Derived,
    published: &[],
};

/// The scene with this name.
pub fn named(name: &str) -> Scene {
    let table = include_str!("../reference/models_scenes.csv");
    let row = table.lines().find(|line| line.starts_with(&format!("{name},"))).unwrap();
    let mut numbers = row.split(',').skip(1).map(|field| field.parse::<f64>().unwrap());
    let mut next = || numbers.next().unwrap();
    let mut interface = Interface::new(next(), 0.0, 0.0);
    interface.equivalent_shear_modulus = Some(next());
    interface.poissons_ratio = next();
    interface.hardness = Some(next());
    interface.pressure_factor = Some(next());
    let surface = Surface::new(next(), next(), next());
    Scene::new(interface, surface, next())
}

/// The AT paper's materials and asperity radius with the roughness of this plasticity index: one
/// asperity for all indices, so that compiled laws can be moved between them.
pub fn with_index(plasticity_index: f64) -> Scene {
    let mut scene = named("at-paper");
    let critical = scene.asperity().unwrap().critical_interference().unwrap();
    scene.surface.asperity_height_std = plasticity_index * plasticity_index * critical;
    scene
}

/// A model with these options of the lateral models.
pub fn lateral(id: &str, options: LateralOptions) -> Model {
    let at = |reading| Model::new(AminiTehrani { reading, options });
    match id {
        "gao" => Model::new(Gao { options }),
        "at" => at(AtReading::Printed),
        "at-additive" => at(AtReading::Additive),
        "at-overlap" => at(AtReading::Overlap),
        _ => panic!("{id} has no lateral options"),
    }
}

/// The models of upright asperities, GW first.
pub fn upright() -> Vec<Model> {
    Model::of_asperities().into_iter().filter(|model| !model.validity().angles).collect()
}

/// The model of this id.
pub fn model(id: &str) -> Model {
    id.parse().unwrap()
}

/// A model on a scene, to this relative tolerance.
pub fn compiled(
    model: &Model,
    scene: &Scene,
    asked: &[Quantity],
    tolerance: f64,
) -> Box<dyn Contact> {
    let request = Request::new(asked.iter().copied()).within(Tolerance::new(tolerance).unwrap());
    model.compile(scene, &request).unwrap()
}

/// A value of a compiled scene, in SI units.
pub fn value(compiled: &impl AsRef<dyn Contact>, quantity: Quantity, separation: f64) -> f64 {
    let compiled = compiled.as_ref();
    compiled.evaluate(quantity, separation).unwrap().value()
}

/// The sheet's unit of a quantity: η A_n times F_c, π R w_c or F_c/w_c.
pub fn unit(scene: &Scene, quantity: Quantity) -> f64 {
    let asperity = scene.asperity().unwrap();
    let (w, f) = (asperity.critical_interference().unwrap(), asperity.critical_force().unwrap());
    scene.asperities()
        * match quantity {
            Quantity::Force => f,
            Quantity::Area => std::f64::consts::PI * asperity.radius * w,
            _ => f / w,
        }
}

/// Panics unless `found` is within the relative `tolerance` of `wanted`.
#[track_caller]
pub fn close(found: f64, wanted: f64, tolerance: f64, what: &str) {
    let error = (found / wanted - 1.0).abs();
    assert!(error <= tolerance, "{what}: {found:e}, not {wanted:e}: error {error:.1e}");
}

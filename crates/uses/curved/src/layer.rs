//! The rough layer between the bodies: pressure and other numbers per nominal area, at separations.

use asperity_core::{
    At, Contact, ContactError, ContactModel, Datum, Quantity, Request, Scene, SeparationUnit,
    Tolerance,
};

/// Pressures below this share of the equivalent modulus are taken as 0.
const LEAST: f64 = 1e-60;

/// A model of rough flat surfaces, per nominal area.
#[derive(Debug)]
pub(crate) struct Layer {
    contact: Box<dyn Contact>,
    /// Standard deviation of the asperity heights \[m\].
    pub(crate) sigma: f64,
    pub(crate) modulus: f64,
    /// Separation \[σ_z\] beyond which the pressure is 0.
    far: f64,
}

impl Layer {
    /// Compiles a model for force, tangent and the asked quantities.
    ///
    /// # Errors
    /// The errors of the model, and [`ContactError::Unsupported`] for one whose pressure does not
    /// follow from the separation alone.
    pub(crate) fn new(
        model: &dyn ContactModel,
        scene: &Scene,
        asked: &[Quantity],
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        let refused = |what: &str| {
            let what = format!("a contact of curved bodies: {what}");
            Err(ContactError::Unsupported { model: model.id().into(), what })
        };
        let validity = model.validity();
        if validity.adhesive {
            return refused("its surfaces adhere, and several states carry a load");
        }
        let quantities = [Quantity::Force, Quantity::Tangent].into_iter().chain(asked.to_vec());
        let contact = model.compile(scene, &Request::new(quantities).within(tolerance))?;
        let sigma = contact.scene().surface.asperity_height_std;
        let modulus = scene.interface.equivalent_modulus;
        let least = LEAST * modulus * scene.nominal_area;
        let sigmas = SeparationUnit::Sigma;
        let far = match contact.separation_in(sigmas, Datum::AsperityMean, At::Load(least)) {
            Err(ContactError::OutOfRange { .. }) => {
                return refused("its pressure is not known where the bodies are far apart");
            }
            found => found?,
        };
        Ok(Self { contact, sigma, modulus, far })
    }

    /// Fills the values of quantities per nominal area at separations \[m\].
    pub(crate) fn fill<const N: usize>(
        &self,
        quantities: [Quantity; N],
        separations: &[f64],
        mut columns: [&mut [f64]; N],
    ) -> Result<(), ContactError> {
        columns.iter_mut().for_each(|column| column.fill(0.0));
        let places: Vec<usize> =
            (0..separations.len()).filter(|k| separations[*k] < self.far * self.sigma).collect();
        let near: Vec<f64> = places.iter().map(|k| separations[*k] / self.sigma).collect();
        let mut values = [(); N].map(|()| vec![0.0; near.len()]);
        let mut into = values.each_mut().map(|column| &mut column[..]);
        self.contact.fill(&quantities, &near, &mut into)?;
        let area = self.contact.scene().nominal_area;
        for (column, values) in columns.iter_mut().zip(&values) {
            places.iter().zip(values).for_each(|(k, value)| column[*k] = value / area);
        }
        Ok(())
    }

    /// A quantity per nominal area at one separation \[m\].
    pub(crate) fn at(&self, quantity: Quantity, separation: f64) -> Result<f64, ContactError> {
        let mut value = [0.0];
        self.fill([quantity], &[separation], [&mut value])?;
        Ok(value[0])
    }

    /// The separation \[m\] at a pressure \[Pa\].
    pub(crate) fn separation(&self, pressure: f64) -> Result<f64, ContactError> {
        let load = pressure * self.contact.scene().nominal_area;
        let at = At::Load(load);
        self.contact.separation_in(SeparationUnit::Metres, Datum::AsperityMean, at)
    }
}

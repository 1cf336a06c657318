//! A model on a scene, ready to be read: quantities, and what follows from them.

use std::sync::Arc;

use crate::counting::Counting;
use crate::{
    Compiled, ContactError, ContactModel, Evaluation, Model, Output, Quantity, Request, Scene,
    Warning,
};

/// A value with a bound on its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutputValue {
    /// In SI units; `None` where a ratio has no value because nothing touches.
    pub value: Option<f64>,
    /// Bound on the error: relative, but absolute for logarithms and shares.
    pub error: f64,
}

/// One output at many separations.
#[derive(Debug, Clone, PartialEq)]
pub struct OutputColumn {
    /// Which.
    pub output: Output,
    /// One for each separation.
    pub values: Vec<OutputValue>,
    /// What deserves a word; the values stand.
    pub warnings: Vec<Warning>,
}

/// A model compiled for a scene and a list of outputs: only what they need is ever computed.
///
/// ```
/// use asperity::{Interface, Output, Readout, Request, Scene, Surface};
///
/// let scene = Scene::new(Interface::new(116e9, 0.31, 1.12e9), Surface::new(3.6e-4, 1.1e8, 1e-6), 3e-5);
/// let outputs = [Output::Pressure, Output::Contacts];
/// let readout = Readout::new(&"ke".parse()?, &scene, &Request::new([]), &outputs)?;
/// let contacts = readout.value(Output::Contacts, 0.0)?;
/// // Half of the asperities of a Gaussian surface are above the mean of their heights.
/// assert!(contacts.value.is_some_and(|n| (n / 1650.0 - 1.0).abs() < 1e-12));
/// # Ok::<(), asperity::ContactError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Readout {
    compiled: Arc<Compiled>,
    contacts: Option<Arc<Compiled>>,
    nominal_area: f64,
    tolerance: f64,
}

impl Readout {
    /// Compiles what these outputs need, to the request's tolerance; its quantities come on top.
    ///
    /// # Errors
    /// [`ContactError`] naming the input that is out of range or missing.
    pub fn new(
        model: &Model,
        scene: &Scene,
        request: &Request,
        outputs: &[Output],
    ) -> Result<Self, ContactError> {
        let mut needed = request.clone();
        for &quantity in outputs.iter().flat_map(|output| output.needs()) {
            if !needed.quantities.contains(&quantity) {
                needed.quantities.push(quantity);
            }
        }
        let contacts = if outputs.contains(&Output::Contacts) {
            let counted = Request { quantities: vec![Quantity::Force], ..request.clone() };
            Some(Arc::new(Counting.compile(scene, &counted)?))
        } else {
            None
        };
        Ok(Self {
            compiled: Arc::new(model.compile(scene, &needed)?),
            contacts,
            nominal_area: scene.nominal_area,
            tolerance: request.tolerance.relative(),
        })
    }

    /// The compiled scene behind it.
    #[must_use]
    pub fn compiled(&self) -> &Compiled {
        &self.compiled
    }

    /// An output at a separation d/σ_z.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`] for what was not asked of [`new`](Self::new), and those of
    /// [`Compiled::evaluate`].
    pub fn value(&self, output: Output, separation: f64) -> Result<OutputValue, ContactError> {
        Ok(self.found(output, separation)?.value)
    }

    /// An output at many separations, with what deserves a word. `done` is called after each.
    ///
    /// # Errors
    /// Those of [`value`](Self::value).
    pub fn column(
        &self,
        output: Output,
        separations: &[f64],
        mut done: impl FnMut(),
    ) -> Result<OutputColumn, ContactError> {
        let found: Vec<Found> = separations
            .iter()
            .map(|&separation| {
                done();
                self.found(output, separation)
            })
            .collect::<Result<_, _>>()?;
        let warnings = self.warnings(output, separations, &found)?;
        Ok(OutputColumn { output, values: found.iter().map(|f| f.value).collect(), warnings })
    }

    fn found(&self, output: Output, separation: f64) -> Result<Found, ContactError> {
        let evaluate = |quantity| self.compiled.evaluate(quantity, separation);
        Ok(match output {
            Output::Force => Found::plain(&evaluate(Quantity::Force)?, 1.0),
            Output::Area => Found::plain(&evaluate(Quantity::Area)?, 1.0),
            Output::Stiffness => Found::plain(&evaluate(Quantity::Stiffness)?, 1.0),
            Output::Tangent => Found::plain(&evaluate(Quantity::Tangent)?, 1.0),
            Output::Pressure => Found::plain(&evaluate(Quantity::Force)?, self.nominal_area),
            Output::AreaFraction => Found::plain(&evaluate(Quantity::Area)?, self.nominal_area),
            Output::Contacts => {
                let not_asked = ContactError::NotRequested { quantity: Quantity::Force };
                let counting = self.contacts.as_ref().ok_or(not_asked)?;
                Found::plain(&counting.evaluate(Quantity::Force, separation)?, 1.0)
            }
            Output::LnForce => Found::logarithm(&evaluate(Quantity::Force)?),
            Output::LnArea => Found::logarithm(&evaluate(Quantity::Area)?),
            Output::MeanPressure => {
                Found::ratio(&evaluate(Quantity::Force)?, &evaluate(Quantity::Area)?)
            }
            Output::ElasticShare | Output::ElasticPlasticShare | Output::PlasticShare => {
                self.share(output, separation)?
            }
        })
    }

    fn share(&self, output: Output, separation: f64) -> Result<Found, ContactError> {
        let force = self.compiled.evaluate(Quantity::Force, separation)?;
        let mut found =
            Found { value: OutputValue { value: None, error: 0.0 }, ..Found::of(&force) };
        if found.touches {
            let shares = self.compiled.shares(Quantity::Force, separation)?;
            let of_regime = shares.iter().filter(|share| Some(share.regime) == output.regime());
            let (share, size) = of_regime
                .fold((0.0, 0.0), |(sum, size), part| (sum + part.share, size + part.share.abs()));
            // Each part is as good as the tolerance, and so is what it is divided by.
            let error = size * (self.tolerance + force.relative_error());
            found.value = OutputValue { value: Some(share), error };
        }
        Ok(found)
    }

    fn warnings(
        &self,
        output: Output,
        separations: &[f64],
        found: &[Found],
    ) -> Result<Vec<Warning>, ContactError> {
        let model = || self.compiled.model().to_string();
        let odd = |is_odd: fn(&Found) -> bool| -> Option<(usize, f64)> {
            let mut odd = found.iter().zip(separations).filter(|(found, _)| is_odd(found));
            let (_, separation) = odd.next()?;
            Some((odd.count() + 1, *separation))
        };
        let mut warnings = self.compiled.warnings().to_vec();
        if let Some((count, separation)) = odd(|f| f.value.value.is_none()) {
            warnings.push(Warning::NoContact { model: model(), count, separation });
        }
        if matches!(output, Output::Area | Output::AreaFraction) {
            let nominal = if output == Output::Area { self.nominal_area } else { 1.0 };
            let fraction = |f: &Found| f.value.value.unwrap_or(0.0) / nominal;
            let mut above = found.iter().zip(separations).filter(|(f, _)| fraction(f) > 1.0);
            if let Some((first, &separation)) = above.next() {
                let (model, count, fraction) = (model(), above.count() + 1, fraction(first));
                warnings.push(Warning::AreaAboveNominal { model, count, separation, fraction });
            }
        }
        // Logarithms and shares hide the sign: it is that of the quantity behind them.
        if let Some((count, separation)) = odd(|f| f.negative) {
            for &quantity in output.needs() {
                let value = self.compiled.evaluate(quantity, separation)?.value();
                if value < 0.0 {
                    let model = model();
                    warnings.push(Warning::Negative { model, quantity, count, separation, value });
                }
            }
        }
        if let Some((count, separation)) = odd(|f| f.underflows) {
            for &quantity in output.needs() {
                let ln_value = self.compiled.evaluate(quantity, separation)?.ln_value();
                let model = model();
                warnings.push(Warning::Underflow { model, quantity, count, separation, ln_value });
            }
        }
        Ok(warnings)
    }
}

/// A value, and what is odd about it.
#[derive(Debug, Clone, Copy)]
struct Found {
    value: OutputValue,
    touches: bool,
    negative: bool,
    underflows: bool,
}

impl Found {
    fn of(evaluation: &Evaluation) -> Self {
        Self {
            value: OutputValue {
                value: Some(evaluation.value()),
                error: evaluation.relative_error(),
            },
            touches: evaluation.size != 0.0,
            negative: evaluation.scaled < 0.0,
            underflows: false,
        }
    }

    fn plain(evaluation: &Evaluation, scale: f64) -> Self {
        let mut found = Self::of(evaluation);
        let value = evaluation.value() / scale;
        found.value.value = Some(value);
        found.underflows = value == 0.0 && evaluation.scaled != 0.0;
        found
    }

    fn logarithm(evaluation: &Evaluation) -> Self {
        let mut found = Self::of(evaluation);
        found.value.value = Some(evaluation.ln_value());
        found
    }

    /// Of the scaled values, so that it has a value where both underflow.
    fn ratio(above: &Evaluation, below: &Evaluation) -> Self {
        let ratio = above.scaled / below.scaled * (above.ln_scale - below.ln_scale).exp();
        Self {
            value: OutputValue {
                value: ratio.is_finite().then_some(ratio),
                error: above.relative_error() + below.relative_error(),
            },
            touches: above.size != 0.0,
            negative: above.scaled < 0.0 || below.scaled < 0.0,
            underflows: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{HeightDistribution, Interface, Surface};

    fn scene() -> Scene {
        let mut interface = Interface::new(116e9, 0.31, 1.12e9);
        interface.equivalent_shear_modulus = Some(41e9);
        Scene::new(interface, Surface::new(3.59e-4, 1.11e8, 1e-6), 3e-5)
    }

    fn readout(id: &str, scene: &Scene) -> Readout {
        Readout::new(&id.parse().unwrap(), scene, &Request::new([]), &Output::ALL).unwrap()
    }

    fn near(a: f64, b: f64) -> bool {
        (a / b - 1.0).abs() < 1e-9
    }

    #[test]
    fn what_follows_from_force_and_area_does() {
        let readout = readout("ke", &scene());
        for s in [-2.0, 0.0, 1.5, 30.0, 37.0] {
            let value = |output| readout.value(output, s).unwrap().value.unwrap();
            let (force, area) = (value(Output::Force), value(Output::Area));
            assert!(near(value(Output::Pressure), force / 3e-5));
            assert!(near(value(Output::AreaFraction), area / 3e-5));
            assert!(near(value(Output::MeanPressure), force / area));
            assert!(near(value(Output::LnForce), force.ln()));
            let shares = value(Output::ElasticShare)
                + value(Output::ElasticPlasticShare)
                + value(Output::PlasticShare);
            assert!(near(shares, 1.0));
        }
    }

    #[test]
    fn contacts_are_the_asperities_above_the_separation() {
        // P(z > s) of the standard normal distribution, from tables.
        let readout = readout("gw", &scene());
        for (s, share) in [(0.0, 0.5), (1.0, 0.158_655_253_931_457_05), (-1e3, 1.0)] {
            let contacts = readout.value(Output::Contacts, s).unwrap().value.unwrap();
            assert!(near(contacts, share * scene().asperities()), "{s}: {contacts}");
        }
        let exponential = Scene { heights: HeightDistribution::Exponential, ..scene() };
        let readout = self::readout("gw", &exponential);
        let contacts = readout.value(Output::Contacts, 2.0).unwrap().value.unwrap();
        assert!(near(contacts, (-2f64).exp() * scene().asperities()));
    }

    #[test]
    fn far_tails_keep_ratios_and_logarithms_and_are_warned_of() {
        let readout = readout("ke", &scene());
        let pressure = readout.value(Output::MeanPressure, 400.0).unwrap().value.unwrap();
        assert!(pressure > 1e6 && pressure < 1.12e9, "{pressure}");
        let column = readout.column(Output::Force, &[1.0, 400.0], || ()).unwrap();
        let text = column.warnings.iter().map(ToString::to_string).collect::<String>();
        assert!(text.contains("too small for a double at 1 of the separations, first at 400"));
        assert!(readout.column(Output::LnForce, &[400.0], || ()).unwrap().warnings.is_empty());
    }

    #[test]
    fn more_contact_than_there_is_room_for_is_warned_of() {
        let readout = readout("gw", &scene());
        for output in [Output::Area, Output::AreaFraction] {
            let warnings = readout.column(output, &[-40.0, 0.0], || ()).unwrap().warnings;
            assert!(
                matches!(warnings[..], [Warning::AreaAboveNominal { count: 1, fraction, .. }] if fraction > 1.0)
            );
        }
    }

    #[test]
    fn negative_forces_are_warned_of_wherever_they_hide() {
        let interface = scene().interface;
        let surface = Surface::from_plasticity_index(2.0, 0.04, 1e-6, &interface).unwrap();
        let readout = readout("at", &Scene { surface, ..scene() });
        for output in [Output::Force, Output::LnForce, Output::Pressure, Output::PlasticShare] {
            let warnings = readout.column(output, &[1.0], || ()).unwrap().warnings;
            let negative = |w: &Warning| matches!(w, Warning::Negative { .. });
            assert!(warnings.iter().any(negative), "{output}: {warnings:?}");
        }
    }

    #[test]
    fn nothing_that_was_not_asked_is_answered() {
        let model: Model = "gw".parse().unwrap();
        let readout = Readout::new(&model, &scene(), &Request::new([]), &[Output::Area]).unwrap();
        assert!(readout.value(Output::Force, 1.0).is_err());
        assert!(readout.value(Output::Contacts, 1.0).is_err());
        assert!(readout.value(Output::AreaFraction, 1.0).is_ok());
    }
}

//! `asperity conductance`: models and correlations of thermal contact conductance.

use std::path::PathBuf;

use anyhow::{Result, bail};
use asperity::joints::conductance::{Correlation, GapRoughness};
use asperity::{At, Interface, Quantity, nearest_hint, nearest_name};
use asperity_answer::{Conductance as Question, Gas, Sheet, with_ranges};
use asperity_inputs::{SceneFile, likely_angle};
use clap::{ArgGroup, Args};

use crate::input::args::{DrawnArgs, loads, model_id};
use crate::input::lists::{Numbers, all};
use crate::input::numbers::{length, load, of_unit, positive, pressure, slope};
use crate::output;
use crate::output::plot::Plot;
use crate::scene::LoadedScene;

/// Thermal contact conductance per area, from models and from published correlations
#[derive(Debug, Args)]
#[command(
    group(ArgGroup::new("given").required(true)),
    after_help = include_str!("../help/conductance.txt")
)]
pub struct Conductance {
    /// Scene file; `asperity init` writes an example
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Models by id and correlations, cmy or mikic [default: ke (gw without a hardness), cmy and
    /// mikic]
    #[arg(long = "model", value_name = "M", value_delimiter = ',', value_parser = formula)]
    models: Vec<String>,
    /// Loads in N, or with a unit, for example 2kN
    #[arg(long, value_name = "A:B:N[:log]|v,v", value_parser = all(load), group = "given")]
    load: Option<Numbers>,
    /// Loads as pressures on the nominal area, in Pa, or with a unit, for example 5MPa
    #[arg(long, value_name = "A:B:N[:log]|v,v", value_parser = all(pressure), group = "given")]
    pressure: Option<Numbers>,
    /// Thermal conductivity of the interface, 2 k1 k2/(k1 + k2), or those of its two bodies, in
    /// W/(m K), instead of the scene's
    #[arg(long, value_name = "K|K1,K2", value_parser = interface_conductivity)]
    conductivity: Option<f64>,
    /// Thermal conductivity of a gas in the gap, in W/(m K)
    #[arg(long, value_name = "K", value_parser = conductivity)]
    gas: Option<f64>,
    /// Temperature-jump distance of the gas, in m, or with a unit: about 0.37um for air at 1 bar
    #[arg(long, value_name = "M", value_parser = length, requires = "gas")]
    gas_parameter: Option<f64>,
    /// For the correlations: sigma, the standard deviation of the heights of both surfaces
    /// together, in m, or with a unit
    #[arg(long, value_name = "S", value_parser = length, requires = "mean_slope")]
    sigma: Option<f64>,
    /// For the correlations: the mean absolute slope of both surfaces together
    #[arg(long, value_name = "M", value_parser = gentle_slope, requires = "sigma")]
    mean_slope: Option<f64>,
    #[command(flatten)]
    output: DrawnArgs,
}

impl Conductance {
    pub fn run(self) -> Result<()> {
        if self.gas.is_some() && self.gas_parameter.is_none() {
            let text = "--gas-parameter is missing and taken as 0, as for a liquid; air at 1 bar between metals has about 0.37um";
            output::note("gas-parameter", text);
        }
        let scene = self.open()?;
        let question = Question {
            file: &scene.file,
            name: &scene.name,
            ids: &self.models,
            roughness: self.roughness(),
            gas: self.gas(),
        };
        let places: Vec<At> = loads(&self.load, &self.pressure).collect();
        let fill = |file: &SceneFile, sheet: &mut Sheet| {
            Question { file, ..question }.answer(&places, sheet)
        };
        let (sheet, ()) = scene.answer(|sheet| with_ranges(&scene.file, sheet, fill))?;
        let contacts = Quantity::ThermalConductancePerArea.column();
        let columns = [&*contacts, &format!("total_{contacts}")];
        self.output
            .write(&sheet, || Plot::new(&["model", "holds"], "pressure_Pa", &columns).svg(&sheet))
    }

    /// The scene, with the conductivity given.
    fn open(&self) -> Result<LoadedScene> {
        let is_model = |id: &&String| Correlation::ALL.iter().all(|known| *id != known.id());
        let ids: Vec<String> = self.models.iter().filter(is_model).cloned().collect();
        let mut scene = LoadedScene::load(&self.scene, &ids)?;
        let interface = &mut scene.file.scene.interface;
        let Some(given) = self.conductivity else {
            if interface.thermal_conductivity.is_none() {
                output::show(
                    &scene.file.conduction_findings(&[Quantity::ThermalConductancePerArea]),
                );
                let how = "set it in the scene, or use --conductivity";
                bail!("{}: thermal_conductivity is missing: {how}", scene.name)
            }
            return Ok(scene);
        };
        interface.thermal_conductivity = Some(given);
        scene.file.bodies.iter_mut().for_each(|body| body.thermal_conductivity = Some(given));
        let found = scene.file.scene.interface.findings().into_iter();
        scene.report(found.filter(|found| found.field == "thermal_conductivity").collect());
        Ok(scene)
    }

    fn gas(&self) -> Option<Gas> {
        let jump = self.gas_parameter.unwrap_or(0.0);
        self.gas.map(|conductivity| Gas { conductivity, jump })
    }

    /// The roughness given for the correlations.
    fn roughness(&self) -> Option<GapRoughness> {
        let given = self.sigma.zip(self.mean_slope);
        given.map(|(height_std, mean_slope)| GapRoughness { height_std, mean_slope })
    }
}

/// A conductivity \[W/(m K)\].
fn conductivity(text: &str) -> Result<f64, String> {
    of_unit(text, "W/(m K)").and_then(positive)
}

/// The conductivity of an interface \[W/(m K)\], or of its two bodies.
fn interface_conductivity(text: &str) -> Result<f64, String> {
    match Numbers::read(text, conductivity)?.0[..] {
        [one] => Ok(one),
        [first, second] => Ok(Interface::mean_conductivity(first, second)),
        ref all => Err(format!("{} values; write K of the interface, or K1,K2", all.len())),
    }
}

/// A slope below 45 degrees.
fn gentle_slope(text: &str) -> Result<f64, String> {
    let given = slope(text)?;
    likely_angle("mean_slope", given).map_or(Ok(given), |found| Err(found.to_string()))
}

/// The id of a model or of a correlation.
fn formula(name: &str) -> Result<String, String> {
    let known = Correlation::ALL.map(|correlation| correlation.id());
    match known.into_iter().find(|id| name.trim().eq_ignore_ascii_case(id)) {
        Some(id) => Ok(id.into()),
        None => model_id(name).map_err(|error| {
            let near = nearest_hint(nearest_name(name, known).map(String::from));
            format!("{error}; the correlations are {}{near}", known.join(", "))
        }),
    }
}

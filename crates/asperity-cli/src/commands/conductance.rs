//! `asperity conductance`: models and correlations of thermal contact conductance.

use std::path::PathBuf;

use anyhow::{Result, bail};
use asperity::joints::conductance::{Correlation, GapRoughness, gap_conductance};
use asperity::{At, ContactModel, Datum, Request, SeparationUnit, shortest_digits};
use asperity_scene::likely_angle;
use clap::{ArgGroup, Args};

use super::conductance_picture::{CONDUCTANCE, column, picture};
use super::conductivity::{
    Conductivity, conductivity, interface_conductivity, missing_conductivity,
};
use crate::input::args::{DrawnArgs, model_id};
use crate::input::lists::{Numbers, all};
use crate::input::numbers::{length, load, pressure, slope};
use crate::output::number::rounded;
use crate::output::table::{Cell, Table};
use crate::output::{once, print_message, summary};
use crate::scene::LoadedScene;

/// Thermal contact conductance per area, from models and from published correlations
#[derive(Debug, Args)]
#[command(
    group(ArgGroup::new("given").required(true)),
    after_help = "Columns: model, load_N, pressure_Pa, relative_pressure,
thermal_conductance_per_area_W_per_m2_per_K, holds and, with --gas, the conductance of
the gas in the gap, at the model's separation from the mean plane, and their sum, the
total_thermal_conductance_per_area_W_per_m2_per_K.
cmy: Cooper, Mikic & Yovanovich 1969, 1.25 k (m/sigma) (p/H)^0.95, for plastic contacts
(plasticity_index above about 1); mikic: Mikic 1974, 1.55 k (m/sigma) (sqrt(2) p/(E m))^0.94,
for elastic contacts. sigma and m, the standard deviation of the heights and the mean absolute
slope, are those of --sigma and --mean-slope, of the scan or, without both, of a Gaussian surface
with the scene's asperities. holds: yes where the contacts are of that kind (if a hardness is given) and the
power law is within 2.1 % of the theory that it was fitted to (p/H of 1e-6 to 0.023,
sqrt(2) p/(E m) of 1e-5 to 0.012).
With --model, the models and correlations of the list only.
Values of models and correlations are for contacts in vacuum; the models neglect their
thermal interaction.

Examples:
  asperity conductance scene.toml --conductivity 50 --pressure 1e5:1e7:5:log
  asperity conductance scene.toml --conductivity 50 --load 1kN --model ke,gw,jg --format csv
  asperity conductance scene.toml --conductivity 50 --pressure 1MPa --gas 0.026 --gas-parameter 0.37um
  asperity conductance scene.toml --conductivity 50 --pressure 1e5:1e7:20:log --output h.csv --plot h.svg
  asperity conductance scene.toml --conductivity 50 --pressure 1MPa --sigma 1.4um --mean-slope 0.14"
)]
pub struct Conductance {
    /// Scene file; `asperity init` writes an example
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Models by id and correlations, cmy or mikic [default: ke (gw without a hardness), cmy and
    /// mikic]
    #[arg(long = "model", value_name = "M", value_delimiter = ',', value_parser = formula)]
    models: Vec<Formula>,
    /// Loads in N, or with a unit, for example 2kN
    #[arg(long, value_name = "A:B:N[:log]|v,v", value_parser = all(load), group = "given")]
    load: Option<Numbers>,
    /// Loads as pressures on the nominal area, in Pa, or with a unit, for example 5MPa
    #[arg(long, value_name = "A:B:N[:log]|v,v", value_parser = all(pressure), group = "given")]
    pressure: Option<Numbers>,
    /// Thermal conductivity of the interface, 2 k1 k2/(k1 + k2), or those of its two bodies, in
    /// W/(m K), instead of the scene's
    #[arg(long, value_name = "K|K1,K2", value_parser = interface_conductivity)]
    conductivity: Option<Conductivity>,
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
    #[arg(long, value_name = "M", value_parser = slope, requires = "sigma")]
    mean_slope: Option<f64>,
    #[command(flatten)]
    output: DrawnArgs,
}

impl Conductance {
    pub fn run(self) -> Result<()> {
        self.output.check("conductance");
        let asked = |formula: &Formula| match formula {
            Formula::Model(id) => Some(id.clone()),
            Formula::Correlation(_) => None,
        };
        let ids: Vec<String> = self.models.iter().filter_map(asked).collect();
        let mut scene = LoadedScene::load_for(&self.scene, &ids)?;
        match self.conductivity {
            Some(given) => {
                given.note();
                scene.file.scene.interface.thermal_conductivity = Some(given.value());
            }
            None if scene.file.scene.interface.thermal_conductivity.is_none() => {
                bail!("{}: {}", scene.name, missing_conductivity(&scene.file))
            }
            None => {}
        }
        let contact = &scene.file.scene;
        let given = self.sigma.zip(self.mean_slope);
        let given = given.map(|(height_std, mean_slope)| GapRoughness { height_std, mean_slope });
        let roughness = given.unwrap_or_else(|| scene.file.gap_roughness());
        let flat = |list: &Option<Numbers>| list.iter().flat_map(|l| l.0.clone()).collect();
        let (loads, pressures): (Vec<f64>, Vec<f64>) = (flat(&self.load), flat(&self.pressure));
        let places = loads.into_iter().map(At::Load).chain(pressures.into_iter().map(At::Pressure));
        let places: Vec<At> = places.collect();
        let head = ["model", "load_N", "pressure_Pa", "relative_pressure"];
        let mut table = Table::new(&head);
        table.head.extend([CONDUCTANCE.column(), "holds".into()]);
        if self.gas.is_some() {
            table.head.extend([column("gas"), column("total")]);
        }
        let row = |id: &str, at: &At, relative: Option<f64>, found: Option<f64>, holds: &str| {
            let numbers = [at.load(contact), at.pressure(contact), relative, found];
            let mut row = vec![Cell::from(id)];
            row.extend(numbers.map(Cell::Number));
            row.push(holds.into());
            row
        };

        self.check_gas();
        self.check_roughness();

        let wanted = |correlation: &Correlation| {
            ids.is_empty() && self.models.is_empty()
                || self.models.contains(&Formula::Correlation(correlation.id()))
        };
        let alone = self.models.len() == 1;
        let models = match (&ids[..], &self.models[..]) {
            ([], []) => vec![scene.reference(None)?],
            ([], _) => vec![],
            (asked, _) => {
                let mut models = vec![];
                for id in &once(asked) {
                    match scene.model(id) {
                        Err(reason) if !alone => left_out(id, &scene, &reason),
                        model => models.push(model?),
                    }
                }
                models
            }
        };
        let mut answered = vec![];
        for named @ (id, model) in &models {
            let request = Request::new([CONDUCTANCE]).at(places.iter().copied());
            let rows = || -> Result<Vec<Vec<Cell>>> {
                let compiled = model.compile(contact, &request)?;
                let row = |at: &At| {
                    let contacts = compiled.evaluate(CONDUCTANCE, *at)?.value();
                    let mut row = row(id, at, None, Some(contacts), "");
                    if let Some(gas) = self.gas {
                        let (unit, plane) = (SeparationUnit::Metres, Datum::SurfaceMean);
                        let gap = compiled.separation(*at)?.measured_in(unit, plane, contact)?;
                        let jump = self.gas_parameter.unwrap_or(0.0);
                        let found = gap_conductance(gas, gap.value.max(0.0), jump)?;
                        row.extend([found, contacts + found].map(|h| Cell::Number(Some(h))));
                    }
                    Ok(row)
                };
                places.iter().map(row).collect()
            };
            match rows() {
                Ok(rows) => {
                    table.rows.extend(rows);
                    answered.push(named);
                }
                Err(reason) if !alone => left_out(id, &scene, &reason),
                Err(reason) => return Err(reason.context(format!("{}: {id}", scene.name))),
            }
        }
        scene.report_answers(&answered, &places);

        'each: for correlation in Correlation::ALL.into_iter().filter(wanted) {
            let (id, range, mut outside) = (correlation.id(), correlation.range(), None);
            for at in &places {
                let pressure = at.pressure(contact).unwrap_or(f64::NAN);
                let found = match correlation.at(contact, &roughness, pressure) {
                    Ok(found) => found,
                    Err(reason) => {
                        print_message("note", &format!("left out: {id}: {reason}"));
                        continue 'each;
                    }
                };
                if !(range[0]..=range[1]).contains(&found.relative_pressure) {
                    outside = outside.or(Some((found.relative_pressure, *at)));
                }
                let (relative, holds) = (found.relative_pressure, found.holds);
                let holds = if holds { "yes" } else { "no" };
                let mut row = row(id, at, Some(relative), Some(found.conductance), holds);
                row.extend(self.gas.iter().flat_map(|_| [None, None].map(Cell::Number)));
                table.rows.push(row);
            }
            if let Some((relative, at)) = outside {
                let ([from, to], relative) = (range, rounded(relative));
                let what = correlation.relative_pressure();
                let text = format!(
                    "{id}: {what} is {relative} at {at}, outside the range of the correlation, {from:e} to {to}"
                );
                print_message("warning", &text);
            }
            if let Some(reason) = correlation.reason_against(contact) {
                print_message("warning", &format!("{id}: {reason}"));
            }
        }
        if table.rows.is_empty() {
            bail!("{}: no model of the list has a conductance", scene.name);
        }
        let used = Correlation::ALL.into_iter().filter(wanted).map(Correlation::id);
        let used: Vec<&str> =
            used.filter(|id| table.rows.iter().any(|r| r[0] == (*id).into())).collect();
        if used.is_empty() {
            return self.output.write(&table, || picture(&table, contact));
        }
        let used = used.join(", ");
        if self.gas.is_some() {
            let text =
                format!("{used}: correlations have no separation, so that gas and total are blank");
            print_message("note", &text);
        }
        let [sigma, slope] = [roughness.height_std, roughness.mean_slope].map(rounded);
        let of = match (given, &scene.file.measured) {
            (Some(_), _) => "as given",
            (_, Some(_)) => "of the scan",
            _ => "of a Gaussian surface with these asperities; a measured surface may differ",
        };
        print_message(
            "note",
            &format!("{used}: sigma is {sigma} m and the mean slope m {slope}, {of}"),
        );
        self.output.write(&table, || picture(&table, contact))
    }
}

/// Names a model without a conductance in this scene, and the reason.
fn left_out(id: &str, scene: &LoadedScene, reason: &anyhow::Error) {
    let reason = summary(reason);
    let reason = reason.strip_prefix(&format!("{}: ", scene.name)).unwrap_or(&reason);
    print_message("warning", &format!("left out: {id}: {reason}"));
}

/// A larger conductivity \[W/(m K)\] of a gas or a paste in the gap is unlikely.
const MOST_GAS: f64 = 10.0;
/// A larger standard deviation of the heights \[m\] is unlikely.
const ROUGHEST: f64 = 1e-3;

/// A longer temperature-jump distance \[m\] is unlikely: that of air at 1 Pa is about 7 mm.
const LONGEST_JUMP: f64 = 1e-2;

impl Conductance {
    /// Warns of unlikely numbers of the correlations.
    fn check_roughness(&self) {
        if let Some(sigma) = self.sigma.filter(|sigma| *sigma > ROUGHEST) {
            let given = shortest_digits(sigma);
            let text = format!("--sigma is {given} m; {given} looks like um, written {given}um");
            print_message("warning", &text);
        }
        if let Some(found) = self.mean_slope.and_then(|slope| likely_angle("--mean-slope", slope)) {
            print_message("warning", &found.to_string());
        }
    }

    /// Warns of an unlikely conductivity, and of a missing or unlikely temperature-jump distance.
    fn check_gas(&self) {
        if let Some(gas) = self.gas.filter(|gas| *gas > MOST_GAS) {
            let [given, meant] = [gas, 1e-3 * gas].map(rounded);
            let text = format!(
                "--gas is {given} W/(m K); {given} looks like mW/(m K); {given} mW/(m K) is {meant} W/(m K)"
            );
            print_message("warning", &text);
        }
        match (self.gas, self.gas_parameter) {
            (Some(_), None) => {
                let text = "--gas-parameter is missing and taken as 0, as for a liquid; air at 1 bar between metals has about 0.37um";
                print_message("note", text);
            }
            (_, Some(given)) if given > LONGEST_JUMP => {
                let text = format!(
                    "--gas-parameter is {given} m; {given} looks like um, about 0.37um for air at 1 bar"
                );
                print_message("warning", &text);
            }
            _ => {}
        }
    }
}

/// A model, by its id, or a correlation.
#[derive(Debug, Clone, PartialEq)]
enum Formula {
    Model(String),
    Correlation(&'static str),
}

fn formula(name: &str) -> Result<Formula, String> {
    let known = Correlation::ALL.map(|correlation| correlation.id());
    match known.into_iter().find(|id| name.trim().eq_ignore_ascii_case(id)) {
        Some(id) => Ok(Formula::Correlation(id)),
        None => model_id(name).map(Formula::Model),
    }
}

//! Arguments that several commands share: parsing and defaults only.

use std::io::IsTerminal;
use std::path::PathBuf;

use anyhow::Result;
use asperity::bem::{Bem, Continuation};
use asperity::{At, Described, Model, Quantity, Request, Separation, SeparationUnit, Tolerance};
use asperity_answer::{ALL_MODELS, Sheet};
use asperity_scene::SceneFile;
use clap::builder::{PathBufValueParser, PossibleValuesParser, TypedValueParser};
use clap::{ArgAction, Args};

use crate::input::distances::{Distances, metre, warn_unit};
use crate::input::lists::{Numbers, all};
use crate::input::numbers::{load_or_tension, number, pressure_or_tension};
use crate::input::refuse;
use crate::output::table::{self, Format};
use crate::output::{self, once};

/// Models of a scene, quantities, and separations or loads.
#[derive(Debug, Args)]
pub struct ModelArgs {
    /// Scene files; `asperity init` writes an example
    #[arg(value_name = "SCENE", required = true)]
    pub scenes: Vec<PathBuf>,
    /// Models by id, as listed by `asperity list models` [default: best and the valid
    /// model nearest to it; `all` for all models of asperities that the scene allows]
    #[arg(long = "model", value_name = "M", value_delimiter = ',', value_parser = listed_model_id)]
    pub models: Vec<String>,
    /// Separations: N values from A to B in equal steps (or equal ratios with :log), or a list; in
    /// units of asperity_height_std (sigma), or with a unit, for example 2um
    #[arg(long = "separation", value_name = "A:B:N[:log]|v,v", conflicts_with = "given")]
    #[arg(action = ArgAction::Append)]
    separations: Vec<Distances>,
    /// Films between the mean planes of the surfaces: separations with the columns film_m and
    /// lambda; in m, or with a unit, for example 0.1um:3um:50
    #[arg(long = "film", value_name = "A:B:N[:log]|v,v", value_parser = all(metre))]
    #[arg(action = ArgAction::Append, conflicts_with = "given")]
    films: Vec<Numbers>,
    /// The same as ratios lambda of the film to the standard deviation of the surface heights
    #[arg(long = "lambda", value_name = "A:B:N[:log]|v,v")]
    #[arg(action = ArgAction::Append, conflicts_with_all = ["given", "films"])]
    ratios: Vec<Numbers>,
    /// Approaches of curved bodies: in m, or with a unit, for example 5um; the scene has
    /// [curvature]
    #[arg(long = "approach", value_name = "A:B:N[:log]|v,v", value_parser = all(metre))]
    #[arg(action = ArgAction::Append, conflicts_with_all = ["given", "separations", "films", "ratios"])]
    approaches: Vec<Numbers>,
    /// Loads, as a range or a list: in N, or with a unit, for example 2kN; negative for tension
    /// (dmt, jkr)
    #[arg(long = "load", value_name = "A:B:N[:log]|v,v", value_parser = all(load_or_tension))]
    #[arg(action = ArgAction::Append, group = "given")]
    loads: Vec<Numbers>,
    /// Loads as pressures on the nominal area, as a range or a list: in Pa, or with a unit, for
    /// example 5MPa
    #[arg(long = "pressure", value_name = "A:B:N[:log]|v,v", value_parser = all(pressure_or_tension))]
    #[arg(action = ArgAction::Append, group = "given")]
    pressures: Vec<Numbers>,
    /// Quantities, as listed by `asperity list quantities` [default: force, area and tangent; of
    /// curved bodies those of their patch]
    #[arg(long = "quantity", value_name = "Q", value_delimiter = ',')]
    quantities: Vec<Quantity>,
    /// Relative tolerance of every value, from 1e-15 to 0.1; of curved bodies from 1e-8, and
    /// 1e-6 in place of the default
    #[arg(long, value_name = "T", value_parser = tolerance, default_value = "1e-10")]
    pub tolerance: Tolerance,
}

/// Where numbers that are known within ranges are taken.
#[derive(Debug, Clone, Args)]
pub struct EndArgs {
    /// Take every number that is known within a range at this end of it
    #[arg(long, value_name = "END", default_value = "middle")]
    #[arg(value_parser = PossibleValuesParser::new(["lower", "middle", "upper"]))]
    pub at: String,
}

/// The values of `--boundary`.
pub fn continuation() -> impl TypedValueParser<Value = Continuation> {
    let names = PossibleValuesParser::new(Continuation::ALL.map(Continuation::name));
    names.try_map(|name| Continuation::from_name(&name).ok_or("another name was required"))
}

/// Format and destination of a result.
#[derive(Debug, Args)]
pub struct OutputArgs {
    /// Format of the result
    #[arg(long, value_name = "FORM", default_value = "auto")]
    pub format: Format,
    /// Write to this file, which is overwritten, instead of standard output
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Format and destination of a result and of its plot.
#[derive(Debug, Args)]
pub struct DrawnArgs {
    #[command(flatten)]
    pub output: OutputArgs,
    /// Also plot the result, one panel for each quantity
    #[arg(long, value_name = "FILE.svg", value_parser = svg_file())]
    pub plot: Option<PathBuf>,
}

impl ModelArgs {
    /// The request, by default with `usual` quantities and these separations.
    pub fn request(&self, scene: &SceneFile, separations: &[f64], usual: &[Quantity]) -> Request {
        for list in &self.separations {
            let height_std = scene.scene.surface.asperity_height_std;
            warn_unit("separation", &list.value, list.unit, height_std);
        }
        let at = self.at(scene, separations);
        for list in &self.films {
            let height_std = scene.scene.surface.asperity_height_std;
            warn_unit("film", &list.0, SeparationUnit::Metres, height_std);
        }
        let quantities = match (&self.quantities[..], &at[..], usual) {
            // At a load, the force is given.
            ([], [At::Load(_) | At::Pressure(_), ..], [Quantity::Force, others @ ..]) => others,
            ([], ..) => usual,
            (given, ..) => given,
        };
        Request::new(once(quantities)).at(at).within(self.tolerance)
    }

    /// Whether neither separations nor loads are given.
    pub fn is_nowhere(&self) -> bool {
        let plain = self.separations.is_empty() && self.approaches.is_empty() && !self.is_of_film();
        plain && self.loads.is_empty() && self.pressures.is_empty()
    }

    /// Ends with a message where the places are not those of curved bodies, or of flat ones.
    pub fn check_places(&self, is_curved: bool) {
        let is_of_flat = self.loads.is_empty() && self.approaches.is_empty();
        let text = "the scene has [curvature]: give --load or --approach";
        refuse([(is_curved && is_of_flat, text)]);
        check_approaches(is_curved, &self.approaches);
    }

    /// Whether films are given.
    pub fn is_of_film(&self) -> bool {
        !(self.films.is_empty() && self.ratios.is_empty())
    }

    /// The separations or loads; `otherwise` is in units of sigma.
    fn at(&self, scene: &SceneFile, otherwise: &[f64]) -> Vec<At> {
        let separation = |value, unit| At::from(scene.separation(value, unit));
        let separations = self
            .separations
            .iter()
            .flat_map(|list| list.value.iter().map(|value| separation(*value, list.unit)));
        let films = self.films.iter().flat_map(|list| &list.0);
        let films = films.map(|film| Separation::metres(*film).from_surface_mean());
        let ratios = self.ratios.iter().flat_map(|list| &list.0).copied();
        let films = films.chain(ratios.map(Separation::film_ratio)).map(At::from);
        let approaches = approaches(&self.approaches);
        let given =
            separations.chain(films).chain(approaches).chain(loads(&self.loads, &self.pressures));
        let given: Vec<At> = given.collect();
        if given.is_empty() {
            otherwise.iter().map(|s| separation(*s, SeparationUnit::Sigma)).collect()
        } else {
            given
        }
    }
}

/// The places of approaches of curved bodies.
pub fn approaches(given: &[Numbers]) -> impl Iterator<Item = At> {
    let given = given.iter().flat_map(|list| &list.0);
    given.map(|approach| At::from(Separation::metres(-approach)))
}

/// Ends with a message where approaches are given and the bodies are flat.
pub fn check_approaches(is_curved: bool, given: &[Numbers]) {
    let text = "--approach is of curved bodies, and the scene has no [curvature]: give --load or --pressure";
    refuse([(!is_curved && !given.is_empty(), text)]);
}

/// The places of loads and of pressures.
pub fn loads<'n>(
    loads: impl IntoIterator<Item = &'n Numbers>,
    pressures: impl IntoIterator<Item = &'n Numbers>,
) -> impl Iterator<Item = At> {
    let loads = loads.into_iter().flat_map(|list| &list.0).copied().map(At::Load);
    let pressures = pressures.into_iter().flat_map(|list| &list.0).copied().map(At::Pressure);
    loads.chain(pressures)
}

impl OutputArgs {
    /// The format that the ending of the file names, csv or json, or else the chosen one.
    pub fn format(&self) -> Format {
        let named = self.output.as_ref().and_then(|path| path.extension()?.to_str());
        match named.map(str::to_lowercase).as_deref() {
            Some("json") => Format::Json,
            Some("csv") => Format::Csv,
            _ if self.format == Format::Auto => {
                let is_shown = self.output.is_none() && std::io::stdout().is_terminal();
                if is_shown { Format::Table } else { Format::Csv }
            }
            _ => self.format,
        }
    }

    pub fn write(&self, sheet: &Sheet) -> Result<()> {
        output::write(self.output.as_deref(), |out| table::write(sheet, self.format(), out))
    }

    pub fn write_text(&self, text: &str) -> Result<()> {
        output::write_text(self.output.as_deref(), text)
    }
}

impl DrawnArgs {
    /// Writes the sheet, and its plot where one is requested.
    pub fn write(&self, sheet: &Sheet, picture: impl FnOnce() -> Result<String>) -> Result<()> {
        self.write_beside(self.picture(picture)?, || self.output.write(sheet))
    }

    /// The plot where one is requested.
    pub fn picture(&self, draw: impl FnOnce() -> Result<String>) -> Result<Option<String>> {
        self.plot.as_ref().map(|_| draw()).transpose()
    }

    /// Writes the result and its plot; where the file of the result fails, no plot stays.
    pub fn write_beside(
        &self,
        picture: Option<String>,
        result: impl FnOnce() -> Result<()>,
    ) -> Result<()> {
        let draw = || match self.plot.as_ref().zip(picture) {
            Some((plot, picture)) => output::write_text(Some(plot), &picture),
            None => Ok(()),
        };
        match output::is_standard(self.output.output.as_deref()) {
            true => draw().and_then(|()| result()),
            false => result().and_then(|()| draw()),
        }
    }
}

/// The id of a model of this project.
pub fn model_id(name: &str) -> Result<String, String> {
    // bem is not in the registry, because it needs the scan of a scene.
    if name.trim().eq_ignore_ascii_case(Bem::ID) {
        return Ok(Bem::ID.into());
    }
    name.parse::<Model>().map(|model| model.id().to_string()).map_err(|e| e.to_string())
}

/// The id of a model in a list, which may be [`ALL_MODELS`].
pub fn listed_model_id(name: &str) -> Result<String, String> {
    match name.trim().eq_ignore_ascii_case(ALL_MODELS) {
        true => Ok(ALL_MODELS.into()),
        false => model_id(name),
    }
}

/// The name of a file that ends so, or `-` for standard output; `what` is written so.
pub fn file_ending(
    ends: &'static [&'static str],
    what: &'static str,
) -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(move |name: PathBuf| {
        let is_one = name
            .extension()
            .is_some_and(|end| ends.iter().any(|one| end.eq_ignore_ascii_case(one)));
        let dotted = ends.iter().map(|end| format!(".{end}")).collect::<Vec<_>>().join(" or ");
        match is_one || output::is_standard(Some(&name)) {
            true => Ok(name),
            false => Err(format!("{what}; choose a name that ends in {dotted}")),
        }
    })
}

/// The name of a plot.
pub fn svg_file() -> impl TypedValueParser<Value = PathBuf> {
    let what = "plots are written as svg; `inkscape plot.svg -o plot.pdf` makes pdf of one, or png";
    file_ending(&["svg"], what)
}

/// A relative tolerance.
fn tolerance(text: &str) -> Result<Tolerance, String> {
    Tolerance::new(number(text)?).map_err(|e| e.to_string())
}

//! Requests of a few rows, answered with no rules and no tables.

use crate::engine::case_integrals::CaseIntegrals;
use crate::engine::channel::Laws;
use crate::law::contact_radii;
use crate::response::{Cell, respond};
use crate::{
    AsperityModel, At, ContactError, HeightDistribution, Quantity, Request, Response, Scene,
};

/// Rows for which nothing is worth preparing: a rule costs some ten of them.
const FEW: usize = 4;
/// Series in the separation, for other heights, begin anew at every break of the density; each
/// costs as much as some thirty rows.
const FEW_BETWEEN_BREAKS: usize = 32;

/// Answers a request of a few rows, if it is one, with no rules and no tables.
pub(crate) fn few(
    model: &dyn AsperityModel,
    scene: &Scene,
    request: &Request,
) -> Result<Option<Response>, ContactError> {
    let few = match &scene.heights {
        HeightDistribution::Weibull(_) => 2 * FEW_BETWEEN_BREAKS,
        HeightDistribution::Other(other) => {
            FEW_BETWEEN_BREAKS * (2 + other.heights().breaks().len())
        }
        _ => FEW,
    };
    if request.at.len() > few || request.shares {
        return Ok(None);
    }
    let (asperity, tolerance) = (scene.asperity()?, request.tolerance);
    contact_radii::check(&request.quantities, &scene.interface)?;
    let by_load = request.at.iter().any(|at| !matches!(at, At::Separation(_)));
    let laws = Laws::new(model, asperity, &request.quantities, by_load, tolerance)?;
    // What cannot be done on this scene is not done row by row.
    CaseIntegrals::alone(scene, &laws, tolerance)?;
    let signed = laws.laws.iter().any(|(_, law)| law.is_signed());
    let one = |quantity: Quantity, at: At| {
        let mut case = CaseIntegrals::alone(scene, &laws, tolerance)?;
        case.reading(at)?.of(quantity, &mut case)
    };
    let row = |at: &At| -> Vec<Cell> {
        let answers = CaseIntegrals::alone(scene, &laws, tolerance).and_then(|mut case| {
            let reading = case.reading(*at)?;
            let of = |q: &Quantity| reading.of(*q, &mut case).map_err(Box::new);
            Ok(request.quantities.iter().map(of).collect())
        });
        let refused = |error: ContactError| {
            let error = Box::new(error);
            request.quantities.iter().map(|_| Err(error.clone())).collect()
        };
        answers.unwrap_or_else(refused)
    };
    let cells = |places: &[At]| {
        let mut columns = vec![vec![]; request.quantities.len()];
        let rows = |places: &[At]| places.iter().map(row).collect::<Vec<_>>();
        let found = match places.len() {
            n if n > FEW => crate::engine::parallel::map_runs(places, FEW, rows),
            // Handing them out costs more.
            _ => rows(places),
        };
        for cells in found {
            columns.iter_mut().zip(cells).for_each(|(column, cell)| column.push(cell));
        }
        columns
    };
    let behind = |q, at| if signed { Some(one(q, at).ok()?.value()) } else { None };
    let none = |_, _| Ok(vec![]);
    let named = (model.name(), scene, laws.adhesive);
    Ok(Some(respond(named, request, cells, none, behind)))
}

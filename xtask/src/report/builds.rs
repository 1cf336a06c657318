//! What it costs to build a law and to compile a scene.

use std::hint::black_box;

use anyhow::Result;
use asperity::{ContactError, Law, Model, Quantity, Request, Tolerance};

use super::scope::{SEPARATIONS, scenes};
use super::timing::Effort;

/// Time \[ns\] to build the law behind a quantity, its tables included: they are filled where they
/// are first sampled, so the time of sampling a law that is there is taken off.
///
/// # Errors
/// When the model refuses the asperity.
pub fn law(
    model: &Model,
    quantity: Quantity,
    tolerance: f64,
    effort: Effort,
) -> Result<(f64, Option<f64>)> {
    let scenes = scenes()?;
    let request = Request::new([quantity]).within(Tolerance::new(tolerance)?);
    let compiled = model.compile(&scenes[0], &request)?;
    let there = compiled.law(quantity)?;
    sample(there)?;
    let sampling = effort.median_ns(|| {
        let _ = black_box(sample(black_box(there)));
    });
    let both = effort.median_ns(|| {
        let compiled = black_box(model).compile(&scenes[0], &request);
        let _ = black_box(compiled.and_then(|compiled| Ok(sample(compiled.law(quantity)?))));
    });
    Ok(((both - sampling).max(0.0), None))
}

/// Samples a law where the speed table's points reach: x = 1e-4 to 1e4.
fn sample(law: &Law) -> Result<f64, ContactError> {
    let mut total = 0.0;
    for k in 0..=80 {
        let x = 10f64.powf(f64::from(k) * 0.1 - 4.0);
        total += law.value(x * law.interference_unit).unwrap_or(f64::NAN);
    }
    Ok(total)
}

/// Time \[ns\] to make a scene ready at all separations of the speed table, with its law built, and
/// how often the law is sampled for it.
///
/// # Errors
/// When the model refuses the scene.
pub fn scene(
    model: &Model,
    quantity: Quantity,
    tolerance: f64,
    effort: Effort,
) -> Result<(f64, Option<f64>)> {
    let scenes = scenes()?;
    let request = Request::new([quantity]).within(Tolerance::new(tolerance)?).at(SEPARATIONS);
    let base = model.compile(&scenes[0], &request)?;
    let mut samples = 0;
    for scene in &scenes {
        // Also fills the tables of the law.
        let plan = base.on(scene)?.plan(&request)?;
        samples += plan.steps.iter().map(|step| step.samples).sum::<usize>();
    }
    let count = scenes.len() as f64;
    let time = effort.median_ns(|| {
        for scene in &scenes {
            let _ = black_box(base.on(black_box(scene)).and_then(|ready| {
                SEPARATIONS.iter().try_for_each(|s| ready.evaluate(quantity, *s).map(|_| ()))
            }));
        }
    });
    Ok((time / count, Some(samples as f64 / count)))
}

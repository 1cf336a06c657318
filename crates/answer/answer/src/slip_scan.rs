//! Partial slip of a scan, by boundary elements.

use asperity::bem::{ContactSlip, LoadCase};
use asperity::joints::coefficient_of_friction;
use asperity::{At, Body, Datum, Scene, Separation, SeparationUnit, short};

use crate::sliding::Sliding;
use crate::subject::{Outcome, Subject};
use crate::{Sheet, Watch};

/// Largest Dundurs' β of bodies that count as alike: pressure and shear then act on each other by
/// less than a per cent.
const ALIKE: f64 = 0.01;

/// The slip of a scan at one load, over its nominal area.
pub(crate) struct ScanSlip<'w> {
    slip: ContactSlip,
    area: f64,
    watch: &'w dyn Watch,
}

/// What a place asks of boundary elements.
///
/// # Errors
/// A separation without a mean plane, a place without a pressure.
pub(crate) fn load_case(scene: &Scene, at: At) -> Outcome<LoadCase> {
    Ok(match at {
        At::Separation(place) => LoadCase::MeanGap(
            place.measured_in(SeparationUnit::Metres, Datum::SurfaceMean, scene)?.value,
        ),
        _ => LoadCase::MeanPressure(at.pressure(scene).ok_or("a load or a pressure")?),
    })
}

impl<'w> ScanSlip<'w> {
    /// Presses the scan, with its load \[N\], pressure \[Pa\] and separation.
    ///
    /// # Errors
    /// Adhesion, unlike bodies, yielding at this load, and the errors of boundary elements.
    pub(crate) fn at(
        subject: &Subject<'_>,
        preload: At,
        friction: f64,
        sheet: &mut Sheet,
        watch: &'w dyn Watch,
    ) -> Outcome<(Self, [f64; 2], Separation)> {
        let scene = &subject.file.scene;
        let friction = coefficient_of_friction(friction)?;
        if scene.interface.work_of_adhesion.is_some_and(|work| work > 0.0) {
            return Err("slip of a scan has no adhesion; leave out work_of_adhesion".into());
        }
        if let [one, other] = subject.file.bodies() {
            check_alike(one, other)?;
        }
        let shear = scene.asperity()?.shear_modulus("partial slip by bem")?;
        let bem = subject.file.bem()?;
        sheet.findings.extend(bem.note());
        let elements = bem.elements(&scene.interface)?;
        let step = |_: &_| watch.step(&format!("{}: the normal load", subject.id()));
        let solution = elements.solve_all(&[load_case(scene, preload)?], step).remove(0)?;
        sheet.report(subject.file, solution.notes.iter().cloned().collect());
        let ratio = 4.0 * shear / scene.interface.equivalent_modulus;
        let (pressure, area) = (solution.mean_pressure, scene.nominal_area);
        let place = Separation::metres(solution.mean_gap).from_surface_mean();
        let slip = ContactSlip::new(elements, &solution, friction, ratio)?;
        Ok((Self { slip, area, watch }, [pressure * area, pressure], place))
    }
}

/// Refuses bodies whose surfaces move sideways under pressure by different amounts.
fn check_alike(one: &Body, other: &Body) -> Outcome {
    let shear = |body: &Body| body.youngs_modulus / (2.0 * (1.0 + body.poissons_ratio));
    let [a, b] = [one, other].map(|body| {
        [1.0 - 2.0 * body.poissons_ratio, 1.0 - body.poissons_ratio].map(|c| c / shear(body))
    });
    let beta = 0.5 * (a[0] - b[0]) / (a[1] + b[1]);
    if beta.abs() <= ALIKE {
        return Ok(());
    }
    let beta = short(beta.abs());
    Err(format!("slip of a scan is for bodies of like materials, with which pressure causes no shear: Dundurs' beta is {beta}, and at most {ALIKE} was required").into())
}

impl Sliding for ScanSlip<'_> {
    fn force(&self, shift: f64) -> Outcome<f64> {
        Ok(self.slip.traction(shift)? * self.area)
    }

    fn loss(&self, amplitude: f64) -> Outcome<f64> {
        Ok(self.slip.loss(amplitude)? * self.area)
    }

    fn limit(&self) -> Outcome<f64> {
        Ok(self.slip.limit() * self.area)
    }

    fn shift_at(&self, share: f64) -> Outcome<f64> {
        Ok(self.slip.shift_at(share * self.slip.limit())?)
    }

    fn amplitude_at(&self, force: f64) -> Outcome<f64> {
        Ok(self.slip.shift_at(force / self.area)?)
    }

    fn prepare(&self, shifts: &[f64]) -> Outcome {
        for (k, shift) in shifts.iter().enumerate() {
            let doing = format!("bem: shift {} of {}", k + 1, shifts.len());
            self.slip.solve(*shift, |_| self.watch.step(&doing))?;
        }
        Ok(())
    }

    fn states(&self, amplitude: f64) -> Outcome<Vec<f64>> {
        let (tractions, sticks) = self.slip.tractions(amplitude)?;
        let state = |(traction, sticks): (&f64, &bool)| match (traction, sticks) {
            (_, true) => 2.0,
            (traction, false) if *traction > 0.0 => 1.0,
            _ => 0.0,
        };
        Ok(tractions.iter().zip(&sticks).map(state).collect())
    }
}

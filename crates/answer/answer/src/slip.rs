//! Partial slip of a joint: a first shift and a steady cycle, or cycles at several preloads.

use std::mem::discriminant;

use asperity::bem::{Bem, BemError};
use asperity::joints::{PartialSlip, Unloading, UnloadingLaw};
use asperity::{At, Code, ContactError, SeparationUnit, linspace, shortest_digits};

use crate::blanks::Blanks;
use crate::number::{rounded, within};
use crate::sliding::Sliding;
use crate::slip_scan::ScanSlip;
use crate::subject::{Outcome, Subject};
use crate::{AnswerError, Sheet, Watch};

/// Share of μ F that defines the start of gross slip.
const SLIDING: f64 = 0.99;

/// A joint that slips, by a model of asperities or by boundary elements on a scan.
#[derive(Debug, Clone, Copy)]
pub struct Slip<'a> {
    /// The model on its scene.
    pub subject: Subject<'a>,
    /// Unloading law of the asperities; a scan has its own.
    pub law: UnloadingLaw,
    /// Coefficient of friction, above 0.
    pub friction: f64,
}

/// The amplitude of a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Amplitude {
    /// A shift \[m\].
    Shift(f64),
    /// A tangential force \[N\].
    Force(f64),
}

impl Slip<'_> {
    /// Fills a sheet with the loop of one cycle at one preload with this number of shifts, or with
    /// a row for each of several cycles, all by shift or all by force. Returns the pixels of a scan
    /// that stick (2) and slip (1) at the amplitude of one cycle, row after row.
    ///
    /// # Errors
    /// The errors of [`PartialSlip`] if no cycle has a result.
    pub fn answer(
        &self,
        preloads: &[At],
        amplitudes: &[Amplitude],
        points: usize,
        sheet: &mut Sheet,
        watch: &dyn Watch,
    ) -> Result<Vec<f64>, AnswerError> {
        self.subject.fill(sheet, |sheet| match (preloads, amplitudes) {
            ([preload], [amplitude]) => self.cycle(*preload, *amplitude, points, sheet, watch),
            _ => self.cycles(preloads, amplitudes, sheet, watch).map(|()| vec![]),
        })
    }

    /// The slip at a preload, with its load \[N\], pressure \[Pa\] and separation over σ_z.
    fn at<'w>(
        &self,
        preload: At,
        sheet: &mut Sheet,
        watch: &'w dyn Watch,
    ) -> Outcome<(Box<dyn Sliding + 'w>, [f64; 3])> {
        let Subject { file, model, tolerance, .. } = self.subject;
        if self.subject.id() == Bem::ID {
            let found = ScanSlip::at(&self.subject, preload, self.friction, sheet, watch)?;
            let (slip, [load, pressure], place) = found;
            let separation = self.subject.place(place, SeparationUnit::Sigma)?;
            return Ok((Box::new(slip), [load, pressure, separation]));
        }
        let joint = Unloading::new(model, &file.scene, preload, self.law, tolerance)?;
        let load = joint.force(0.0)?.value();
        let separation = self.subject.place(joint.closest(), SeparationUnit::Sigma)?;
        let numbers = [load, load / file.scene.nominal_area, separation];
        let slip = PartialSlip::new(&joint, self.friction)?;
        Ok((Box::new(slip), numbers.map(|x| self.digits(x))))
    }

    fn digits(&self, x: f64) -> f64 {
        within(x, self.subject.tolerance)
    }

    /// The first shift and a steady cycle at one preload.
    fn cycle(
        &self,
        preload: At,
        amplitude: Amplitude,
        points: usize,
        sheet: &mut Sheet,
        watch: &dyn Watch,
    ) -> Outcome<Vec<f64>> {
        let heads = ["model", "shift_m", "force_N", "back_N", "forth_N", "loss_J", "loss_factor"];
        sheet.under(&[&heads]);
        let id = self.subject.id();
        let (slip, _) = self.at(preload, sheet, watch)?;
        let amplitude = shift_of(&*slip, amplitude)?;
        // All rows need these shifts alone.
        slip.prepare(&linspace(0.0, amplitude, points))?;
        // First, so that the error for a tiny amplitude names the amplitude.
        let loss = rounded(slip.loss(amplitude)?);
        let factor = rounded(slip.loss_factor(amplitude)?);
        for shift in linspace(-amplitude, amplitude, points) {
            let path = |forth| slip.loop_force(shift, amplitude, forth).map(Some);
            let (back, forth) = (path(false)?, path(true)?);
            let [force, loss, factor] = match shift {
                shift if shift < 0.0 => [None; 3],
                0.0 => [Some(0.0); 3],
                shift => {
                    let loss = [slip.loss(shift).ok(), slip.loss_factor(shift).ok()];
                    [Some(slip.force(shift)?), loss[0], loss[1]]
                }
            };
            let numbers = [Some(shift), force, back, forth, loss, factor];
            sheet.add(&[id], numbers.map(|x| x.map(|x| self.digits(x))));
        }
        let text =
            format!("{id}: a cycle of this amplitude dissipates {loss} J (loss factor {factor})");
        sheet.result(text);
        let [limit, sliding] = [slip.limit()?, slip.shift_at(SLIDING)?].map(rounded);
        let percent = 100.0 * SLIDING;
        let text = format!(
            "{id}: gross slip begins at a shift of {sliding} m, where {percent} % of mu F = {limit} N is reached"
        );
        sheet.result(text);
        let states = slip.states(amplitude)?;
        if !states.is_empty() {
            let count = |least: f64| states.iter().filter(|state| **state >= least).count() as f64;
            let percent = rounded(100.0 * count(2.0) / count(1.0));
            let text = format!("{id}: at this amplitude {percent} % of the contact sticks");
            sheet.result(text);
        }
        Ok(states)
    }

    /// A row for each cycle; blank where there is none.
    fn cycles(
        &self,
        preloads: &[At],
        amplitudes: &[Amplitude],
        sheet: &mut Sheet,
        watch: &dyn Watch,
    ) -> Outcome {
        let heads = ["model", "load_N", "pressure_Pa", "separation_over_sigma"];
        let by_shift = matches!(amplitudes, [Amplitude::Shift(_), ..]);
        sheet.under(&[&heads, if by_shift { &FORCES } else { &SHIFTS }]);
        let (id, scene) = (self.subject.id(), &self.subject.file.scene);
        let (mut blanks, mut answered) = (Blanks::default(), false);
        for &at in preloads {
            let known = self.at(at, sheet, watch);
            let given = [at.load(scene), at.pressure(scene), None];
            let place = known.as_ref().map_or(given, |(_, numbers)| numbers.map(Some));
            for &amplitude in amplitudes {
                let cycle = known.as_ref().map_err(ToString::to_string);
                let cycle = cycle.map_err(AnswerError::from);
                let cycle = match cycle.and_then(|(slip, _)| self.under(&**slip, amplitude)) {
                    Ok(cycle) => {
                        answered = true;
                        cycle.map(Some)
                    }
                    Err(error) => {
                        blanks.count("cycle", discriminant(&error), error.to_string());
                        let force = match amplitude {
                            Amplitude::Shift(_) => None,
                            Amplitude::Force(force) => Some(force),
                        };
                        [force, None, None, None, None]
                    }
                };
                sheet.add(&[id], place.into_iter().chain(cycle));
            }
        }
        let reasons = blanks.texts(sheet.rows.len());
        if !answered {
            return Err(reasons.collect::<Vec<_>>().join("; ").into());
        }
        reasons.for_each(|reason| sheet.warn(Code::NoValue, format!("{id}: {reason}")));
        Ok(())
    }

    /// The numbers of a cycle, in the order of [`FORCES`] or [`SHIFTS`].
    fn under(&self, slip: &dyn Sliding, amplitude: Amplitude) -> Outcome<[f64; 5]> {
        let shift = shift_of(slip, amplitude)?;
        let force = match amplitude {
            Amplitude::Shift(_) => slip.force(shift)?,
            Amplitude::Force(force) => force,
        };
        let numbers = [force / shift, slip.loss(shift)?, slip.loss_factor(shift)?];
        let [stiffness, loss, factor] = numbers.map(|x| self.digits(x));
        Ok(match amplitude {
            Amplitude::Shift(_) => {
                let [force, sliding] = [force, slip.shift_at(SLIDING)?].map(|x| self.digits(x));
                [force, stiffness, loss, factor, sliding]
            }
            Amplitude::Force(_) => [force, self.digits(shift), stiffness, loss, factor],
        })
    }
}

/// Columns of cycles of one shift.
const FORCES: [&str; 5] =
    ["force_N", "secant_stiffness_N_per_m", "loss_J", "loss_factor", "sliding_m"];
/// Columns of cycles of tangential forces.
const SHIFTS: [&str; 5] =
    ["tangential_force_N", "amplitude_m", "secant_stiffness_N_per_m", "loss_J", "loss_factor"];

/// The amplitude of shift of a cycle.
fn shift_of(slip: &dyn Sliding, amplitude: Amplitude) -> Outcome<f64> {
    let force = match amplitude {
        Amplitude::Shift(shift) => return Ok(shift),
        Amplitude::Force(force) => force,
    };
    slip.amplitude_at(force).or_else(|error| {
        let slides = matches!(
            error,
            AnswerError::Contact(ContactError::OutOfRange { field: "tangential_force", .. })
                | AnswerError::Bem(BemError::OutOfRange { field: "traction", .. })
        );
        if !slides {
            return Err(error);
        }
        let (force, limit) = (shortest_digits(force), rounded(slip.limit()?));
        Err(format!("a tangential force of {force} N reaches mu F = {limit} N: the joint slides")
            .into())
    })
}

//! The mean pressures at which contacts of a scan, and of surfaces like it, close their last path.

use asperity::bem::{Bem, Continuation, Direction, Progress, Sealing, Solution};
use asperity::{ATOMIC_DISTANCE, Code, short};
use asperity_scene::SceneFile;

use crate::{AnswerError, Cell, Sheet, Watch};

/// What is said of the samples: its column, and its value in each.
type Number = (&'static str, fn(&Sealing) -> f64);
const NUMBERS: [Number; 2] =
    [("sealing_pressure_Pa", |found| found.pressure), ("area_fraction", |found| found.area)];

/// Fills a sheet with a row for each direction of flow through the scan of a scene: the lowest, the
/// middle and the highest sealing pressure of samples, which are the scan and surfaces of its
/// spectrum and heights with other phases. Returns the heaviest contact of the scan with an open
/// path. Where the work is stopped, the samples are those done by then, and rows need two.
///
/// # Errors
/// A scan that is no part of a larger surface, and a sample that is not solved.
pub fn sealing(
    (file, bem): (&SceneFile, &Bem),
    samples: usize,
    sheet: &mut Sheet,
    watch: &dyn Watch,
) -> Result<Option<Solution>, AnswerError> {
    let heads = NUMBERS.iter().flat_map(|(head, _)| {
        ["lowest", "middle", "highest"].map(|which| format!("{which}_{head}"))
    });
    sheet.heads = ["flow_along", "samples"].map(String::from).into_iter().chain(heads).collect();
    sheet.heads.push("tightest_gap_m".into());
    if bem.continuation() == Continuation::Free {
        return Err("a sealing pressure is that of samples of a larger surface: set boundary to \"periodic-part\" or \"periodic\"".into());
    }
    let seal = file.spec.seal.map(|seal| seal.resolved()).transpose()?;
    let molecule = seal.map_or(ATOMIC_DISTANCE, |seal| seal.molecule);
    let (mut found, mut heaviest) = (vec![], None);
    for sample in 0..samples {
        let bem = if sample == 0 { bem.clone() } else { bem.another(sample as u64) };
        let elements = bem.elements(&file.scene.interface)?;
        let progress = |of: &Progress| {
            let (sample, load) = (sample + 1, of.done + 1);
            watch.step(&format!("bem: sample {sample} of {samples}, load {load}"))
        };
        match elements.sealing(molecule, progress) {
            Ok((sealed, last)) => {
                // Several samples are what few patches need; of like notes the first sample's.
                for note in last.iter().flat_map(|last| last.notes.clone()) {
                    let is_known = sheet.findings.iter().any(|known| known.code == note.code);
                    if note.code != Code::FewPatches && !is_known {
                        sheet.findings.push(note);
                    }
                }
                found.push(sealed);
                heaviest = heaviest.or(last.filter(|_| sample == 0));
            }
            Err(_) if watch.is_stopped() => break,
            Err(error) => {
                return Err(format!("sample {} of {samples}: {error}", sample + 1).into());
            }
        }
    }
    if found.len() < 2 {
        return Ok(heaviest);
    }
    sheet.result(format!(
        "sealing pressures of {} samples, within 1 % each: the scan, and surfaces with its spectrum and nearly its distribution of heights; gaps below {} nm count as closed",
        found.len(),
        short(1e9 * molecule)
    ));
    for (k, along) in Direction::ALL.into_iter().enumerate() {
        let all: Vec<Option<Sealing>> = found.iter().map(|sealed| sealed[k]).collect();
        let (count, never) = (all.len(), all.iter().filter(|one| one.is_none()).count());
        if never > 0 {
            sheet.result(format!("along {along} no path is open in {never} of {count} samples, even at the lightest load: their sealing pressures are blank, below all others"));
        }
        let mut row = vec![Cell::from(&*along.to_string()), (count as f64).into()];
        for (_, number) in NUMBERS {
            let mut of: Vec<_> = all.iter().map(|one| one.as_ref().map(number)).collect();
            of.sort_by(|a, b| a.unwrap_or(0.0).total_cmp(&b.unwrap_or(0.0)));
            let middle = of[(count - 1) / 2].zip(of[count / 2]).map(|(a, b)| 0.5 * (a + b));
            row.extend([of[0], middle, of[count - 1]].map(Cell::from));
        }
        let tightest = all.iter().flatten().map(|one| one.tightest_gap).min_by(f64::total_cmp);
        row.push(tightest.into());
        sheet.rows.push(row);
    }
    Ok(heaviest)
}

//! Scenes and numbers, broadcast: row k is a number on a scene.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use asperity::{At, Case, ContactError, Datum, Findings, Scene, SeparationUnit, Severity};
use asperity_inputs::SceneInput;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;

use crate::convert::axis::Axis;
use crate::scene::SceneFile;
use crate::scene::inputs::inputs;

/// The `Rows` of the package.
#[derive(FromPyObject)]
pub(crate) struct Rows<'py> {
    /// The scenes; a single one if columns of numbers vary it.
    files: Vec<Py<SceneFile>>,
    columns: BTreeMap<String, PyReadonlyArray1<'py, f64>>,
    /// The index of each row's scene.
    index: PyReadonlyArray1<'py, i64>,
    /// The meaning of the numbers.
    axis: Axis,
    numbers: PyReadonlyArray1<'py, f64>,
}

/// The same for threads without the interpreter.
pub(crate) struct View<'r> {
    pub(crate) files: Vec<Arc<asperity_inputs::SceneFile>>,
    columns: Vec<(SceneInput, &'r [f64])>,
    /// Empty if all rows are on the first scene.
    index: &'r [i64],
    axis: Axis,
    numbers: &'r [f64],
}

impl Rows<'_> {
    pub(crate) fn view(&self) -> PyResult<View<'_>> {
        let slices = self.columns.values().map(|column| Ok(column.as_slice()?));
        let slices = slices.collect::<PyResult<Vec<_>>>()?;
        let columns = match self.files.first() {
            Some(file) => {
                let inputs = inputs(&file.get().0, self.columns.keys())?;
                inputs.into_iter().zip(slices).collect()
            }
            None => vec![],
        };
        Ok(View {
            files: self.files.iter().map(|file| file.get().0.clone()).collect(),
            columns,
            index: self.index.as_slice()?,
            axis: self.axis,
            numbers: self.numbers.as_slice()?,
        })
    }
}

impl<'r> View<'r> {
    /// Numbers on one scene.
    pub(crate) fn of_one(
        file: &Arc<asperity_inputs::SceneFile>,
        axis: Axis,
        numbers: &'r [f64],
    ) -> Self {
        Self { files: vec![file.clone()], columns: vec![], index: &[], axis, numbers }
    }

    pub(crate) fn len(&self) -> usize {
        self.numbers.len()
    }

    /// The index of a row's scene.
    pub(crate) fn place(&self, row: usize) -> usize {
        self.index.get(row).map_or(0, |place| *place as usize)
    }

    /// The scene of a row, or the scene that columns of numbers vary.
    fn file(&self, row: usize) -> &asperity_inputs::SceneFile {
        &self.files[if self.columns.is_empty() { self.place(row) } else { 0 }]
    }

    /// The number of scenes.
    pub(crate) fn scenes(&self) -> usize {
        self.columns.first().map_or(self.files.len(), |(_, column)| column.len())
    }

    /// Findings of the scene of this index; none if the scene is refused.
    pub(crate) fn findings(&self, scene: usize) -> Findings {
        if self.columns.is_empty() {
            return self.files[scene].findings();
        }
        let numbers = self.columns.iter().map(|(input, column)| (*input, column[scene]));
        self.files[0].with_inputs(numbers).map_or(Findings::default(), |file| file.findings())
    }

    /// Warnings and errors that the first scene does not list as accepted, one for each cause.
    pub(crate) fn accepted(&self, found: Findings) -> Findings {
        // Without rows there may be no scene.
        let found = self.files.first().map_or(found.clone(), |file| file.accepted(found));
        found.at_least(Severity::Warning)
    }

    /// The rows of the smallest and the largest number.
    pub(crate) fn ends(&self) -> impl Iterator<Item = usize> {
        let finite = || (0..self.len()).filter(|row| self.numbers[*row].is_finite());
        let by = |a: &usize, b: &usize| self.numbers[*a].total_cmp(&self.numbers[*b]);
        [finite().min_by(by), finite().max_by(by)].into_iter().flatten()
    }

    /// The single scene of all rows, with its options; none if there are several.
    pub(crate) fn one_file(&self) -> Option<&asperity_inputs::SceneFile> {
        self.one_scene().map(|_| &*self.files[0])
    }

    /// The single scene of all rows; none if there are several.
    pub(crate) fn one_scene(&self) -> Option<&Scene> {
        match &self.files[..] {
            [file] if self.columns.is_empty() => Some(&file.scene),
            _ => None,
        }
    }

    pub(crate) fn are_separations(&self) -> bool {
        matches!(self.axis, Axis::Separation(_))
    }

    /// The plane that a row's separations are measured from.
    pub(crate) fn datum(&self, row: usize) -> Datum {
        self.file(row).separation_from
    }

    /// The separations of these rows on a scene as multiples of σ_z from the mean of the asperity
    /// heights; none for loads, or without a mean plane.
    pub(crate) fn sigmas(&self, rows: Range<usize>, scene: &Scene) -> Option<Cow<'_, [f64]>> {
        let (sigma, mean) = (SeparationUnit::Sigma, Datum::AsperityMean);
        let one = self.files.len() == 1 && self.files[0].separation_from == mean;
        if one && self.axis == Axis::Separation(sigma) {
            return self.numbers.get(rows).map(Cow::Borrowed);
        }
        let place = |row| match self.at(row) {
            At::Separation(place) => Some(place.measured_in(sigma, mean, scene).ok()?.value),
            _ => None,
        };
        rows.map(place).collect::<Option<Vec<f64>>>().map(Cow::Owned)
    }

    pub(crate) fn at(&self, row: usize) -> At {
        self.axis.at(self.numbers[row], self.datum(row))
    }

    pub(crate) fn scene(&self, row: usize) -> Result<Scene, ContactError> {
        Ok(match self.columns.is_empty() {
            true => self.file(row).scene.clone(),
            false => self.file_of(row)?.into_owned().scene,
        })
    }

    /// The scene of a row with what it was made from.
    pub(crate) fn file_of(
        &self,
        row: usize,
    ) -> Result<Cow<'_, asperity_inputs::SceneFile>, ContactError> {
        if self.columns.is_empty() {
            return Ok(Cow::Borrowed(self.file(row)));
        }
        let numbers = self.columns.iter().map(|(input, column)| (*input, column[self.place(row)]));
        self.file(row).with_inputs(numbers).map(Cow::Owned)
    }

    pub(crate) fn case(&self, row: usize) -> Result<Case, ContactError> {
        Ok(Case::new(self.scene(row)?, self.at(row)))
    }

    /// A warning if the separation of largest magnitude has probably another unit.
    pub(crate) fn mistaken_unit(&self) -> Option<String> {
        let largest = largest_magnitude(self.numbers);
        if let Some(scene) = self.one_scene() {
            // Most arrays need no search for the row.
            let height_std = scene.surface.asperity_height_std;
            self.axis.mistaken_unit("separation", largest, height_std)?;
        }
        let row = self.numbers.iter().position(|x| x.abs().to_bits() == largest.to_bits())?;
        self.axis.mistaken_unit(
            "separation",
            self.numbers[row],
            self.scene(row).ok()?.surface.asperity_height_std,
        )
    }
}

/// The largest magnitude of finite numbers; 0 without any.
fn largest_magnitude(numbers: &[f64]) -> f64 {
    let magnitude = |x: f64| if x.abs() < f64::INFINITY { x.abs() } else { 0.0 };
    // Side by side: a single maximum would wait for the one before.
    let mut largest = [0.0; 16];
    let (chunks, rest) = numbers.as_chunks::<16>();
    for chunk in chunks {
        for (largest, x) in largest.iter_mut().zip(chunk) {
            let size = magnitude(*x);
            *largest = if size > *largest { size } else { *largest };
        }
    }
    let rest = rest.iter().map(|x| magnitude(*x));
    rest.chain(largest).fold(0.0, f64::max)
}

//! Scenes and numbers, broadcast: row k is a number on a scene.

use std::collections::BTreeMap;
use std::sync::Arc;

use asperity::{At, Case, ContactError, Datum, Diagnostics, Severity};
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;

use crate::convert::axis::Axis;
use crate::scene::SceneFile;
use crate::scene::inputs::{Input, inputs, with_numbers};

/// The `Rows` of the package.
#[derive(FromPyObject)]
pub(crate) struct Rows<'py> {
    /// The scenes; one, if columns of numbers make the others from it.
    files: Vec<Py<SceneFile>>,
    columns: BTreeMap<String, PyReadonlyArray1<'py, f64>>,
    /// Which scene each row is on.
    index: PyReadonlyArray1<'py, i64>,
    /// What the numbers stand for.
    axis: Axis,
    numbers: PyReadonlyArray1<'py, f64>,
}

/// The same for threads without the interpreter.
pub(crate) struct View<'r> {
    pub(crate) files: Vec<Arc<asperity_scene::SceneFile>>,
    columns: Vec<(Input, &'r [f64])>,
    /// Empty where all are on the first.
    index: &'r [i64],
    axis: Axis,
    numbers: &'r [f64],
}

impl Rows<'_> {
    pub(crate) fn view(&self) -> PyResult<View<'_>> {
        let slices = self.columns.values().map(|column| Ok(column.as_slice()?));
        let slices = slices.collect::<PyResult<Vec<_>>>()?;
        Ok(View {
            files: self.files.iter().map(|file| file.get().0.clone()).collect(),
            columns: inputs(self.columns.keys())?.into_iter().zip(slices).collect(),
            index: self.index.as_slice()?,
            axis: self.axis,
            numbers: self.numbers.as_slice()?,
        })
    }
}

impl<'r> View<'r> {
    /// Numbers on one scene.
    pub(crate) fn of_one(
        file: &Arc<asperity_scene::SceneFile>,
        axis: Axis,
        numbers: &'r [f64],
    ) -> Self {
        Self { files: vec![file.clone()], columns: vec![], index: &[], axis, numbers }
    }

    pub(crate) fn len(&self) -> usize {
        self.numbers.len()
    }

    /// The number of a row's scene.
    pub(crate) fn place(&self, row: usize) -> usize {
        self.index.get(row).map_or(0, |place| *place as usize)
    }

    /// The scene of a row, or the one that it differs from in some numbers.
    fn file(&self, row: usize) -> &asperity_scene::SceneFile {
        &self.files[if self.columns.is_empty() { self.place(row) } else { 0 }]
    }

    /// How many scenes there are.
    pub(crate) fn scenes(&self) -> usize {
        self.columns.first().map_or(self.files.len(), |(_, column)| column.len())
    }

    /// Findings of the scene of this index; none where it is refused.
    pub(crate) fn findings(&self, scene: usize) -> Diagnostics {
        if self.columns.is_empty() {
            return self.files[scene].findings();
        }
        let numbers = self.columns.iter().map(|(input, column)| (*input, column[scene]));
        with_numbers(&self.files[0], numbers).map_or(Diagnostics::default(), |file| file.findings())
    }

    /// Warnings and errors that the first scene does not accept, one for each cause.
    pub(crate) fn accepted(&self, found: Diagnostics) -> Diagnostics {
        self.files[0].accepted(found).at_least(Severity::Warning)
    }

    /// The rows of the smallest and the largest number.
    pub(crate) fn ends(&self) -> impl Iterator<Item = usize> {
        let finite = || (0..self.len()).filter(|row| self.numbers[*row].is_finite());
        let by = |a: &usize, b: &usize| self.numbers[*a].total_cmp(&self.numbers[*b]);
        [finite().min_by(by), finite().max_by(by)].into_iter().flatten()
    }

    /// The only scene there is, with its options.
    pub(crate) fn one_file(&self) -> Option<&asperity_scene::SceneFile> {
        self.one_scene().map(|_| &*self.files[0])
    }

    /// The only scene there is.
    pub(crate) fn one_scene(&self) -> Option<&asperity::Scene> {
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

    pub(crate) fn at(&self, row: usize) -> At {
        self.axis.at(self.numbers[row], self.datum(row))
    }

    pub(crate) fn scene(&self, row: usize) -> Result<asperity::Scene, ContactError> {
        if self.columns.is_empty() {
            return Ok(self.file(row).scene.clone());
        }
        let numbers = self.columns.iter().map(|(input, column)| (*input, column[self.place(row)]));
        Ok(with_numbers(self.file(row), numbers)?.scene)
    }

    pub(crate) fn case(&self, row: usize) -> Result<Case, ContactError> {
        Ok(Case::new(self.scene(row)?, self.at(row)))
    }

    /// What the number that is farthest from 0 was probably meant to be, if that makes no sense.
    pub(crate) fn slip(&self) -> Option<String> {
        let far = |a: &usize, b: &usize| self.numbers[*a].abs().total_cmp(&self.numbers[*b].abs());
        let row = (0..self.len()).filter(|row| self.numbers[*row].is_finite()).max_by(far)?;
        self.axis.slip(
            "separation",
            self.numbers[row],
            self.scene(row).ok()?.surface.asperity_height_std,
        )
    }
}

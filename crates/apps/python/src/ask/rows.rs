//! Rows: numbers on scenes, broadcast by the package's `Rows`.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use asperity::{At, Case, ContactError, Datum, Finding, Findings, Scene, SeparationUnit, Severity};
use asperity_scene::SceneInput;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;

use crate::convert::axis::Axis;
use crate::convert::numbers::largest_magnitude;
use crate::scene::SceneFile;
use crate::scene::arguments::inputs;

/// The `Rows` of the package, for threads without the interpreter.
pub(crate) struct Rows {
    /// The scenes; a single one if columns of numbers vary it.
    pub(crate) files: Vec<Arc<asperity_scene::SceneFile>>,
    columns: Vec<(SceneInput, Vec<f64>)>,
    /// The index of each row's scene; empty for a single scene.
    index: Vec<i64>,
    axis: Axis,
    numbers: Vec<f64>,
}

impl<'py> FromPyObject<'_, 'py> for Rows {
    type Error = PyErr;

    fn extract(rows: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        type Numbers<'py, T> = PyReadonlyArray1<'py, T>;
        let files: Vec<Py<SceneFile>> = rows.getattr("files")?.extract()?;
        let files: Vec<_> = files.iter().map(|file| file.get().0.clone()).collect();
        let columns: BTreeMap<String, Numbers<'py, f64>> = rows.getattr("columns")?.extract()?;
        let inputs = files.first().map(|file| inputs(file, columns.keys())).transpose()?;
        let values = columns.values().map(|column| Ok(column.as_slice()?.to_vec()));
        let values = values.collect::<PyResult<Vec<_>>>()?;
        let index: Numbers<'py, i64> = rows.getattr("index")?.extract()?;
        let numbers: Numbers<'py, f64> = rows.getattr("numbers")?.extract()?;
        Ok(Self {
            files,
            columns: inputs.unwrap_or_default().into_iter().zip(values).collect(),
            index: index.as_slice()?.to_vec(),
            axis: rows.getattr("axis")?.extract()?,
            numbers: numbers.as_slice()?.to_vec(),
        })
    }
}

impl Rows {
    pub(crate) fn len(&self) -> usize {
        self.numbers.len()
    }

    /// The index of a row's scene.
    pub(crate) fn place(&self, row: usize) -> usize {
        self.index.get(row).map_or(0, |place| *place as usize)
    }

    /// Whether bodies of a scene are curved.
    pub(crate) fn are_curved(&self) -> bool {
        self.files.iter().any(|file| file.shape().is_some())
    }

    /// Refuses places that a scene does not have.
    pub(crate) fn check_axis(&self) -> PyResult<()> {
        self.files.iter().try_for_each(|file| self.axis.check(file))
    }

    /// The number of scenes.
    pub(crate) fn scenes(&self) -> usize {
        self.columns.first().map_or(self.files.len(), |(_, column)| column.len())
    }

    /// The scene of this index with what it was made from.
    pub(crate) fn scene_file(
        &self,
        scene: usize,
    ) -> Result<Cow<'_, asperity_scene::SceneFile>, ContactError> {
        if self.columns.is_empty() {
            return Ok(Cow::Borrowed(&self.files[scene]));
        }
        let numbers = self.columns.iter().map(|(input, column)| (*input, column[scene]));
        self.files[0].with_inputs(numbers).map(Cow::Owned)
    }

    /// The scene of a row with what it was made from.
    pub(crate) fn file_of(
        &self,
        row: usize,
    ) -> Result<Cow<'_, asperity_scene::SceneFile>, ContactError> {
        self.scene_file(self.place(row))
    }

    pub(crate) fn scene(&self, row: usize) -> Result<Scene, ContactError> {
        Ok(match self.file_of(row)? {
            Cow::Borrowed(file) => file.scene.clone(),
            Cow::Owned(file) => file.scene,
        })
    }

    /// Rows with their cases and the results of `evaluate`; no case if its scene is refused.
    pub(crate) fn evaluate<T>(
        &self,
        range: Range<usize>,
        evaluate: impl FnOnce(&[Case]) -> Vec<Result<T, ContactError>>,
    ) -> impl Iterator<Item = (usize, Option<Case>, Result<T, ContactError>)> {
        let mut cases = vec![];
        let mut place = |row| match self.scene(row) {
            Ok(scene) => {
                cases.push(Case::new(scene, self.at(row)));
                None
            }
            Err(error) => Some(error),
        };
        let refused: Vec<_> = range.clone().map(&mut place).collect();
        let mut found = evaluate(&cases).into_iter().zip(cases);
        range.zip(refused).filter_map(move |(row, refused)| match refused {
            Some(error) => Some((row, None, Err(error))),
            None => found.next().map(|(found, case)| (row, Some(case), found)),
        })
    }

    pub(crate) fn at(&self, row: usize) -> At {
        self.axis.at(self.numbers[row], self.datum(row))
    }

    /// The plane that a row's separations are measured from.
    pub(crate) fn datum(&self, row: usize) -> Datum {
        // Columns of numbers vary a single scene.
        self.files[if self.columns.is_empty() { self.place(row) } else { 0 }].spec.separation_from
    }

    /// The single scene of all rows, with its options; none if there are several.
    pub(crate) fn one_file(&self) -> Option<&asperity_scene::SceneFile> {
        match &self.files[..] {
            [file] if self.columns.is_empty() => Some(file),
            _ => None,
        }
    }

    /// The single scene of all rows; none if there are several.
    pub(crate) fn one_scene(&self) -> Option<&Scene> {
        self.one_file().map(|file| &file.scene)
    }

    /// Warnings that the first scene does not list as accepted, one for each cause.
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

    /// The separations of these rows on a scene as multiples of σ_z from the mean of the asperity
    /// heights; none for loads, or without a mean plane.
    pub(crate) fn sigmas(&self, rows: Range<usize>, scene: &Scene) -> Option<Cow<'_, [f64]>> {
        sigmas(&self.numbers[rows], self.axis, self.files.first()?.spec.separation_from, scene)
    }

    /// A warning if the separation of largest magnitude has probably another unit.
    pub(crate) fn mistaken_unit(&self) -> Option<Finding> {
        let largest = largest_magnitude(&self.numbers).to_bits();
        let row = self.numbers.iter().position(|x| x.abs().to_bits() == largest)?;
        let height_std = self.scene(row).ok()?.surface.asperity_height_std;
        self.axis.mistaken_unit("separation", &self.numbers[row..=row], height_std)
    }
}

/// Separations as multiples of σ_z from the mean of the asperity heights; none for loads, or
/// without a mean plane.
pub(crate) fn sigmas<'n>(
    numbers: &'n [f64],
    axis: Axis,
    from: Datum,
    scene: &Scene,
) -> Option<Cow<'n, [f64]>> {
    let (sigma, mean) = (SeparationUnit::Sigma, Datum::AsperityMean);
    if axis == Axis::Separation(sigma) && from == mean {
        return Some(Cow::Borrowed(numbers));
    }
    let place = |number: &f64| match axis.at(*number, from) {
        At::Separation(place) => Some(place.measured_in(sigma, mean, scene).ok()?.value),
        _ => None,
    };
    numbers.iter().map(place).collect::<Option<Vec<f64>>>().map(Cow::Owned)
}

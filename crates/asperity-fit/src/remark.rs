//! Remarks on the parameters of a fit.

/// A sentence, and the places of the parameters that it is about.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Remark {
    pub(crate) parameters: Vec<usize>,
    pub(crate) sentence: String,
}

/// Whether one of the remarks is about the parameter at this place.
pub(crate) fn concerns(remarks: &[Remark], place: usize) -> bool {
    remarks.iter().any(|remark| remark.parameters.contains(&place))
}

/// The sentences alone.
pub(crate) fn sentences(remarks: Vec<Remark>) -> Vec<String> {
    remarks.into_iter().map(|remark| remark.sentence).collect()
}

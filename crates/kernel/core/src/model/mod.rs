//! What a model is to those who write one, and to those who use one.

pub(crate) mod contact;
pub(crate) mod contact_model;
pub(crate) mod described;
pub(crate) mod variant;

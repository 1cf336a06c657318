//! The only place that lists all models.

use std::fmt;
use std::ops::Deref;
use std::str::FromStr;
use std::sync::Arc;

use strsim::osa_distance;

use crate::{
    AbdoFarhang, AminiTehrani, ChangEtsionBogy, ContactError, ContactModel, EtsionKligermanKadin,
    Gao, GeometricHardness, GreenwoodWilliamson, JacksonGreen, KogutEtsion, Reading,
    ZhaoMaiettaChang,
};

/// Any contact model, by value: cheap to clone, shared between threads, read from its name.
///
/// ```
/// use asperity::{ContactModel, Model};
///
/// let model: Model = "ke".parse()?;
/// assert_eq!(model.name(), "KE");
/// let mistyped = "zcm".parse::<Model>().unwrap_err().to_string();
/// assert!(mistyped.contains("did you mean \"zmc\"?"));
/// # Ok::<(), asperity::ContactError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Model(Arc<dyn ContactModel>);

impl Model {
    /// Wraps a model, of this project or your own.
    #[must_use]
    pub fn new(model: impl ContactModel + 'static) -> Self {
        Self(Arc::new(model))
    }

    /// Every model of this project with its default options, simplest first.
    #[must_use]
    pub fn all() -> Vec<Self> {
        let reading = |reading| AminiTehrani { reading, ..AminiTehrani::default() };
        let cosine = JacksonGreen { hardness: GeometricHardness::Cosine };
        vec![
            Self::new(GreenwoodWilliamson),
            Self::new(ChangEtsionBogy),
            Self::new(ZhaoMaiettaChang),
            Self::new(KogutEtsion),
            Self::new(EtsionKligermanKadin),
            Self::new(JacksonGreen::default()),
            Self::new(cosine),
            Self::new(AbdoFarhang::default()),
            Self::new(Gao::default()),
            Self::new(reading(Reading::Printed)),
            Self::new(reading(Reading::Additive)),
            Self::new(reading(Reading::Overlap)),
        ]
    }
}

impl Deref for Model {
    type Target = dyn ContactModel;

    fn deref(&self) -> &Self::Target {
        &*self.0
    }
}

impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}

impl FromStr for Model {
    type Err = ContactError;

    /// Reads a model's id, in any case.
    fn from_str(name: &str) -> Result<Self, ContactError> {
        let models = Self::all();
        let wanted = name.trim().to_lowercase();
        if let Some(model) = models.iter().find(|m| m.id() == wanted) {
            return Ok(model.clone());
        }
        let distance = |m: &Self| osa_distance(&wanted, m.id());
        let near = models.iter().min_by_key(|m| distance(m)).filter(|m| distance(m) <= 2);
        Err(ContactError::UnknownModel {
            name: name.into(),
            near: near.map(|m| m.id().into()),
            known: models.iter().map(|m| m.id()).collect::<Vec<_>>().join(", "),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_id_reads_back_and_is_unique() {
        let ids: Vec<String> = Model::all().iter().map(ToString::to_string).collect();
        for id in &ids {
            assert_eq!(id.to_uppercase().parse::<Model>().unwrap().id(), id);
        }
        let mut unique = ids.clone();
        unique.sort();
        unique.dedup();
        assert_eq!(unique.len(), ids.len());
    }

    #[test]
    fn far_names_get_the_list_and_no_guess() {
        let message = "persson".parse::<Model>().unwrap_err().to_string();
        assert!(!message.contains("mean") && message.contains("gw, ceb, zmc"), "{message}");
        let message = "etsoin".parse::<Model>().unwrap_err().to_string();
        assert!(message.contains("did you mean \"etsion\"?"), "{message}");
    }
}

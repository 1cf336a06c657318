//! A rough contact that has been closed, and opens again.

use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

use asperity_core::{
    At, ContactError, ContactModel, Datum, Evaluation, Quantity, Request, Scene, Separation,
    SeparationUnit, Source, Tolerance,
};

use crate::one::{Asked, Loading, Retreated};

/// How an asperity comes back; equations and sources stand at the head of this crate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
#[non_exhaustive]
pub enum UnloadingLaw {
    /// As a Hertzian contact of the force and area at the closest approach.
    #[default]
    Hertz,
    /// Brake 2015: as a sphere of another radius; the area jumps where unloading begins.
    Brake,
    /// Etsion, Kligerman & Kadin 2005: fitted to finite elements; force and stiffness alone.
    Etsion,
}

impl UnloadingLaw {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Hertz, Self::Brake, Self::Etsion];
}

impl fmt::Display for UnloadingLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Hertz => "hertz",
            Self::Brake => "brake",
            Self::Etsion => "etsion",
        })
    }
}

impl FromStr for UnloadingLaw {
    type Err = String;

    /// Reads the names that [`Display`](fmt::Display) writes, in any case.
    fn from_str(name: &str) -> Result<Self, String> {
        let wanted = name.trim().to_lowercase();
        let found = Self::ALL.into_iter().find(|law| law.to_string() == wanted);
        found.ok_or_else(|| format!("{name:?} is none of hertz, brake, etsion"))
    }
}

/// A contact that has come to its closest approach, and now goes back.
#[derive(Debug, Clone)]
pub struct Unloading {
    source: Source,
    name: String,
    scene: Scene,
    closest: Separation,
    loading: Arc<Loading>,
    tolerance: Tolerance,
}

impl Unloading {
    /// A model's contact on a scene, closed for the first time as far as `closest` says: of a
    /// load, the largest separation that carries it.
    ///
    /// # Errors
    /// [`ContactError::Unsupported`] for models that have no law of an asperity, or one spread over
    /// angles; those of the model, and of finding a load.
    pub fn new(
        model: &(impl ContactModel + ?Sized),
        scene: &Scene,
        closest: At,
        law: UnloadingLaw,
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        let unsupported = |what: &str| ContactError::Unsupported {
            model: model.name().into(),
            what: what.into(),
        };
        if model.claims().angles {
            return Err(unsupported("unloading: its contacts lie at all angles"));
        }
        if model.claims().adhesive {
            return Err(unsupported(
                "unloading: adhesion has a branch of its own (jkr-separation)",
            ));
        }
        let one = model
            .asperity_model()
            .ok_or_else(|| unsupported("unloading: it has no law of an asperity"))?;
        let asperity = scene.asperity()?;
        let law_of = |quantity| {
            let found = one.law(&asperity, quantity, tolerance)?;
            found.ok_or_else(|| ContactError::NoLaw { model: model.name().into(), quantity })
        };
        let (force, area) = (law_of(Quantity::Force)?, law_of(Quantity::Area)?);
        let asked = Request::new([Quantity::Force]).within(tolerance).at([closest]);
        let closest = model.compile(scene, &asked)?.separation(closest)?;
        let yields = asperity.hardness.is_some() && !force.kinks().is_empty();
        let critical = if yields { asperity.critical_interference()? } else { f64::INFINITY };
        let loading = Loading { force, area, asperity, unloading: law, critical };
        Ok(Self {
            source: *model.source(),
            name: model.name().into(),
            scene: scene.clone(),
            closest,
            loading: Arc::new(loading),
            tolerance,
        })
    }

    /// The closest approach.
    #[must_use]
    pub fn closest(&self) -> Separation {
        self.closest
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// How the asperities come back.
    #[must_use]
    pub fn law(&self) -> UnloadingLaw {
        self.loading.unloading
    }

    /// The force \[N\] after going back by `retreat` \[m\], at least 0.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`], [`ContactError::Integral`].
    pub fn force(&self, retreat: f64) -> Result<Evaluation, ContactError> {
        self.of(Asked::Force, retreat)
    }

    /// The real contact area \[m²\] after going back by `retreat` \[m\].
    ///
    /// # Errors
    /// Those of [`force`](Self::force), and [`ContactError::Unsupported`] for Etsion's law.
    pub fn area(&self, retreat: f64) -> Result<Evaluation, ContactError> {
        if self.law() == UnloadingLaw::Etsion {
            let what = "an area in unloading by etsion: its fit of the area is left out".into();
            return Err(ContactError::Unsupported { model: self.name.clone(), what });
        }
        self.of(Asked::Area, retreat)
    }

    /// -dF/du \[N/m\] after going back by `retreat` \[m\]: at 0, by Hertz' law, the sum of 2 E a.
    ///
    /// # Errors
    /// Those of [`force`](Self::force).
    pub fn stiffness(&self, retreat: f64) -> Result<Evaluation, ContactError> {
        self.of(Asked::Stiffness, retreat)
    }

    /// What of the force \[N\] at the closest approach a retreat \[m\] releases: to the digit for
    /// small ones too.
    ///
    /// # Errors
    /// Those of [`force`](Self::force).
    pub fn released(&self, retreat: f64) -> Result<Evaluation, ContactError> {
        self.of(Asked::Released, retreat)
    }

    pub(crate) fn of(&self, asked: Asked, retreat: f64) -> Result<Evaluation, ContactError> {
        if !(retreat >= 0.0 && retreat.is_finite()) {
            let required = "a finite number, at least 0,";
            return Err(ContactError::OutOfRange { field: "retreat", value: retreat, required });
        }
        if retreat == 0.0 && matches!(asked, Asked::Released | Asked::Loss) {
            return Ok(Evaluation::new(0.0, 0.0));
        }
        let who = (&self.source, &*self.name);
        let model = Retreated::new(who, &self.loading, asked, retreat)?;
        let first = model.first / self.scene.surface.asperity_height_std;
        let (sigmas, mean) = (SeparationUnit::Sigma, Datum::AsperityMean);
        let closest = self.closest.measured_in(sigmas, mean, &self.scene)?.value;
        let request = Request::new([Quantity::Force]).within(self.tolerance);
        let answer = model.solve(&self.scene, &request.at([closest + first]))?;
        let row = answer.columns.into_iter().flat_map(|column| column.rows).next();
        row.unwrap_or_else(|| {
            Err(Box::new(ContactError::NotRequested { quantity: Quantity::Force }))
        })
        .map_err(|error| *error)
    }

    pub(crate) fn name(&self) -> &str {
        &self.name
    }
}

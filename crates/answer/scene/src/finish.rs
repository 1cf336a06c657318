//! Surfaces as drawings give them: a roughness and a finish, from which height, slope and bandwidth
//! follow within ranges.

use std::f64::consts::FRAC_2_PI;

use asperity::{Code, ContactError, Finding, ProfileMoments, nearest_name, positive, short};

use crate::document::Document;
use crate::error::SceneError;
use crate::finishes::{Range, UNKNOWN, finishes};
use crate::ranges::{Corner, Face, MIDDLE, NAMES, Unknown};
use crate::text_file::shorten;

/// The keys of a surface by its finish.
pub(crate) const FINISH: &[&str] = &[
    "ra",
    "rq",
    "rz",
    "finish",
    "rsm",
    "rdq",
    "feed",
    "nose_radius",
    "bandwidth",
    "lambda_c",
    "lambda_s",
    "mean_slope",
];

/// Ra of the cusps of a turned surface is feed²/(18 √3 nose_radius), of parabolas. \[derived\]
const CUSP: f64 = 31.18;
/// A longer cut-off \[m\] is a length in mm: ten times the longest of ISO 4288, 8 mm.
const LONGEST: f64 = 0.08;
/// The power of Rq in the usual slope.
const POWER: f64 = 0.402;

/// A surface as a drawing gives it: its roughness and its finish, in SI units.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    /// The numbers in the order of [`FINISH`].
    numbers: [Option<f64>; FINISH.len()],
    finish: Option<&'static str>,
    /// Where the unknowns are taken; without it they have ranges.
    pub(crate) at: Option<Corner>,
}

/// What a drawing says of its surface.
struct Parts {
    /// Ra \[m\]: estimated, as of Gaussian heights, where it is not given.
    ra: f64,
    height: Unknown,
    /// The mean slope across the lay at the middle of Rq.
    across: Unknown,
    /// The power of Rq by which the slope varies.
    slope_power: f64,
    bandwidth: Unknown,
}

type Found<T> = Result<T, ContactError>;

fn missing<T>(field: &'static str, reason: String) -> Found<T> {
    Err(ContactError::Missing { field, reason })
}

impl Drawing {
    /// The drawing that the keys of a section describe.
    ///
    /// # Errors
    /// [`SceneError`] for a finish that is not in the table, and for keys that exclude each other.
    pub(crate) fn read(document: &Document<'_>, section: &str) -> Result<Self, SceneError> {
        let at = |key: &str| format!("{section}.{key}");
        let word: Option<String> = document.get(&at("finish"))?;
        let finish = word.map(|word| named(document, &at("finish"), &word)).transpose()?;
        let mut drawing = Self { finish, ..Self::default() };
        for (key, number) in
            FINISH.iter().zip(&mut drawing.numbers).filter(|(key, _)| **key != "finish")
        {
            *number = document.number(&at(key))?;
        }
        match drawing.conflict() {
            Some((one, other, needed)) => Err(document.conflict(&at(one), &at(other), needed)),
            None => Ok(drawing),
        }
    }

    /// The number of a key as it was written.
    pub(crate) fn get(&self, key: &str) -> Option<f64> {
        FINISH.iter().zip(self.numbers).find(|(name, _)| **name == key)?.1
    }

    pub(crate) fn set(&mut self, key: &str, value: f64) {
        let mut all = FINISH.iter().zip(&mut self.numbers);
        all.by_ref()
            .filter(|(name, _)| **name == key)
            .for_each(|(_, number)| *number = Some(value));
    }

    /// The numbers that were written.
    pub(crate) fn by_key(&self) -> impl Iterator<Item = (&'static str, f64)> {
        FINISH.iter().zip(self.numbers).filter_map(|(key, number)| Some((*key, number?)))
    }

    /// The keys of numbers that it has or can have beside the others.
    pub(crate) fn open_keys(&self) -> Vec<&'static str> {
        let fits = |key: &&str| {
            let mut edited = self.clone();
            edited.set(key, 1.0);
            *key != "finish" && edited.conflict().is_none()
        };
        FINISH.iter().copied().filter(fits).collect()
    }

    pub(crate) fn finish(&self) -> Option<&'static str> {
        self.finish
    }

    /// Two keys that exclude each other, with what is needed.
    pub(crate) fn conflict(&self) -> Option<(&'static str, &'static str, &'static str)> {
        let given = |key: &&str| self.get(key).is_some();
        if given(&"rdq") && given(&"mean_slope") {
            return Some(("rdq", "mean_slope", "one of the two"));
        }
        let of_tool = ["feed", "nose_radius"].into_iter().find(given);
        let needed = "finish = \"turned\", whose cusps have a feed and a nose_radius,";
        let key = of_tool.filter(|_| self.finish != Some("turned"))?;
        Some((key, "finish", needed))
    }

    /// The surface with its unknowns.
    ///
    /// # Errors
    /// [`ContactError`] naming the number that is missing or out of range.
    pub(crate) fn face(&self) -> Found<Face> {
        let Parts { height, across, slope_power, bandwidth, .. } = self.parts()?;
        Ok(Face { unknowns: [height, self.areal(across)?, bandwidth], slope_power })
    }

    /// The moments of the surface where its unknowns are taken, by default in the middle.
    pub(crate) fn moments(&self) -> Found<ProfileMoments> {
        Ok(self.face()?.moments(self.at.unwrap_or(MIDDLE)))
    }

    fn parts(&self) -> Found<Parts> {
        if let Some((one, other, needed)) = self.conflict() {
            let reason = format!("excludes {other}: {needed} was required");
            return Err(ContactError::Refused { model: one.into(), reason });
        }
        let (height, ra) = self.height()?;
        let wavelengths = self.wavelengths(ra)?;
        let (across, slope_power) = self.slope_across(&height, wavelengths)?;
        Ok(Parts { ra, height, across, slope_power, bandwidth: self.bandwidth(wavelengths)? })
    }

    /// The number of a key, if it is given; an error if it is not positive.
    fn number(&self, key: &'static str) -> Found<Option<f64>> {
        self.get(key).map(|value| positive(key, value)).transpose()
    }

    /// The cut-offs of the profile \[m\], λ_s and λ_c: refuses those that no profile has, and
    /// an Rq below Ra.
    fn wavelengths(&self, ra: f64) -> Found<[f64; 2]> {
        let usual = Range::wavelengths(ra);
        let mut found = [0.0; 2];
        for (k, key) in ["lambda_s", "lambda_c"].into_iter().enumerate() {
            found[k] = match self.number(key)?.or(usual.map(|usual| usual[k])) {
                Some(length) => length,
                None => return missing(key, "a cut-off of the profile".into()),
            };
        }
        let [short_cut, cut] = found;
        let below = self.number("rq")?.zip(self.number("ra")?).filter(|(rq, ra)| rq < ra);
        let (field, value, required) = match below {
            Some((rq, _)) => ("rq", rq, "a value of at least ra"),
            None if cut > LONGEST => {
                ("lambda_c", cut, "a length in m up to 0.08, for example \"0.8 mm\",")
            }
            None if cut <= short_cut => ("lambda_c", cut, "a cut-off longer than lambda_s"),
            None => return Ok(found),
        };
        Err(ContactError::OutOfRange { field, value, required })
    }

    /// The range of a number for this finish.
    fn range(&self, what: &str) -> Found<&'static Range> {
        match Range::of_finish(what, self.finish.unwrap_or(UNKNOWN)) {
            Some(range) => Ok(range),
            None => missing("finish", format!("a finish with a known {what}")),
        }
    }

    /// The range of a number for these cut-offs, or an error that asks for `key` instead.
    fn at_ratio(
        what: &str,
        key: &'static str,
        [short_cut, cut]: [f64; 2],
    ) -> Found<&'static Range> {
        match Range::at_ratio(what, cut / short_cut) {
            Some(range) => Ok(range),
            None => missing(
                key,
                format!(
                    "lambda_c/lambda_s is {}, and scans give a range from 10 to 320 only",
                    short(cut / short_cut)
                ),
            ),
        }
    }

    /// Rq, and Ra \[m\]: estimated, as of Gaussian heights, where it is not given.
    fn height(&self) -> Found<(Unknown, f64)> {
        let (ra, rq, rz) = (self.number("ra")?, self.number("rq")?, self.number("rz")?);
        if let Some(rq) = rq {
            return Ok((Unknown::given(NAMES[0], rq, "rq"), ra.unwrap_or(FRAC_2_PI.sqrt() * rq)));
        }
        let made = |range: &'static Range, ends: [f64; 2], text: &str| {
            let Range { lower, upper, source, .. } = range;
            let source = format!("{text} {lower} to {upper}: {source}");
            Unknown::new(NAMES[0], ends, &range.status, source, "rq")
        };
        match (ra, rz) {
            (Some(ra), _) => {
                let range = self.range("rq_over_ra")?;
                Ok((made(range, [ra * range.lower, ra * range.upper], "ra times"), ra))
            }
            (None, Some(rz)) => {
                let range = self.range("rz_over_rq")?;
                let height = made(range, [rz / range.upper, rz / range.lower], "rz over");
                let ra = FRAC_2_PI.sqrt() * height.range[1];
                Ok((height, ra))
            }
            (None, None) => {
                missing("ra", "a finish needs the height of the roughness: ra, rq or rz".into())
            }
        }
    }

    /// The mean slope across the lay at the middle of Rq, and the power of Rq by which it varies.
    fn slope_across(&self, height: &Unknown, wavelengths: [f64; 2]) -> Found<(Unknown, f64)> {
        let (rdq, mean) = (self.number("rdq")?, self.number("mean_slope")?);
        // The mean of |x| of a normal x is √(2/π) standard deviations.
        let of_rdq = rdq.map(|rdq| (FRAC_2_PI.sqrt() * rdq, "rdq"));
        if let Some((slope, key)) = of_rdq.or(mean.map(|mean| (mean, "mean_slope"))) {
            return Ok((Unknown::given(NAMES[1], slope, key), 0.0));
        }
        let (rz, rsm) = (self.number("rz")?, self.number("rsm")?);
        if rsm.is_some() && rz.is_none() {
            return missing("rz", "rsm gives the slope with rz only".into());
        }
        let (range, slope, power, text, narrowed) = match rz.zip(rsm) {
            Some((rz, rsm)) => {
                let range = Self::at_ratio("slope_over_rz_rsm", "rdq", wavelengths)?;
                (range, 2.0 * rz / rsm, 0.0, "times 2 rz/rsm", "rdq or a scan")
            }
            None if self.finish.is_none() => {
                return missing(
                    "finish",
                    format!(
                        "a height leaves the slope open: {}; or rdq, mean_slope, or rz with rsm",
                        one_finish()
                    ),
                );
            }
            None => {
                let slope = usual_slope(height.range[1]);
                let text = "times 0.125 Rq^0.402 (um)";
                (self.range("slope")?, slope, POWER, text, "rdq, rz with rsm, or a scan")
            }
        };
        let Range { lower, upper, source, .. } = range;
        let mut source = format!("{lower} to {upper} {text}: {source}");
        let mut ends = [lower * slope, upper * slope];
        if let Some((feed, radius)) = self.tool()? {
            let cusps = feed / (4.0 * radius);
            ends = ends.map(|end| end.max(cusps));
            source += &format!("; at least feed/(4 nose_radius) = {}", short(cusps));
        }
        Ok((Unknown::new(NAMES[1], ends, &range.status, source, narrowed), power))
    }

    /// Feed and nose radius of a turned surface.
    fn tool(&self) -> Found<Option<(f64, f64)>> {
        let (feed, radius) = (self.number("feed")?, self.number("nose_radius")?);
        match (feed, radius) {
            (Some(feed), Some(radius)) => Ok(Some((feed, radius))),
            (None, None) => Ok(None),
            (Some(_), None) => missing("nose_radius", "feed and nose_radius go together".into()),
            (None, Some(_)) => missing("feed", "feed and nose_radius go together".into()),
        }
    }

    /// The slope of the isotropic surface with the same rms gradient as one with this slope across
    /// the lay of the finish; without a finish the surface is isotropic, as one by other numbers.
    fn areal(&self, across: Unknown) -> Found<Unknown> {
        let lay = self.range("along_over_across")?;
        let Some(finish) = self.finish.filter(|_| lay.lower < 1.0) else { return Ok(across) };
        let areal = |slope: f64, ratio: f64| slope * (0.5 * (1.0 + ratio * ratio)).sqrt();
        let ends = [areal(across.range[0], lay.lower), areal(across.range[2], lay.upper)];
        let status = if across.status == "assumed" { "assumed" } else { &lay.status };
        let source = format!(
            "{}; slope along over across the lay of {finish} surfaces {} to {}: {}",
            across.source, lay.lower, lay.upper, lay.source
        );
        Ok(Unknown::new(NAMES[1], ends, status, source, across.narrowed))
    }

    /// The bandwidth, given or by the ratio of the cut-offs.
    fn bandwidth(&self, wavelengths: [f64; 2]) -> Found<Unknown> {
        if let Some(bandwidth) = self.number("bandwidth")? {
            return Ok(Unknown::given(NAMES[2], bandwidth, "bandwidth"));
        }
        let range = Self::at_ratio("bandwidth", "bandwidth", wavelengths)?;
        let [short_cut, cut] = wavelengths.map(|length| short(1e6 * length));
        let source = format!("lambda_c {cut} um, lambda_s {short_cut} um: {}", range.source);
        let ends = [range.lower, range.upper];
        Ok(Unknown::new(NAMES[2], ends, &range.status, source, "bandwidth or a scan"))
    }

    /// The warnings of numbers that contradict each other.
    ///
    /// # Errors
    /// Those of [`face`](Self::face).
    pub(crate) fn warnings(&self, place: impl Fn(&str) -> String) -> Found<Vec<Finding>> {
        let Parts { ra, height, across, .. } = self.parts()?;
        let mut found = vec![];
        let mut warn = |key: &'static str, value: f64, fact: String, advice: &str| {
            let warning = Finding::warning(Code::RoughnessNumbers, key, value);
            found.push(warning.fact(fact).advice(advice.to_string()).from_origin(place(key)));
        };
        // Where Rq is not given, some value of its range is to go with Rz.
        let [least, _, most] = height.range;
        let of_ra = self.number("ra")?.map(|ra| [ra; 2]);
        for (key, other, of, what, known) in [
            ("rq", "ra", of_ra, "rq_over_ra", " (a sine has 1.11)"),
            ("rz", "the Rq of the surface", Some([least, most]), "rz_over_rq", ""),
        ] {
            let Some((value, [least, most])) = self.number(key)?.zip(of) else { continue };
            let Range { lower, upper, .. } = self.range(what)?;
            if value > upper * most || value < lower * least {
                let ratio = short(value / (least * most).sqrt());
                let fact = format!(
                    "{key} is {ratio} times {other}, and such surfaces have {lower} to {upper}{known}"
                );
                warn(key, value, fact, "check both, or remove what was not measured");
            }
        }
        let (slope, usual) = (across.range[1], usual_slope(height.range[1]));
        let odd = Range::of_finish("slope", UNKNOWN).filter(|range| !range.contains(slope / usual));
        if let Some(Range { lower, upper, .. }) = odd.filter(|_| self.finish != Some("polished")) {
            let [least, most] = [lower, upper].map(|ratio| short(ratio * usual));
            let fact = format!(
                "the mean slope is {}, and machined surfaces of this roughness have {least} to {most}",
                short(slope)
            );
            warn(self.slope_key(), slope, fact, "check the units of roughness and slope");
        }
        if let Some((feed, radius)) = self.tool()? {
            let cusps = feed * feed / (CUSP * radius);
            if ra < 0.9 * cusps {
                let fact = format!(
                    "the cusps of feed and nose_radius have an Ra of {} um, more than the {} um of the surface",
                    short(1e6 * cusps),
                    short(1e6 * ra)
                );
                warn("feed", feed, fact, "check feed, nose_radius and the roughness");
            }
        }
        Ok(found)
    }

    /// The key that gives the slope.
    fn slope_key(&self) -> &'static str {
        let given = ["rdq", "mean_slope", "rsm"].into_iter().find(|key| self.get(key).is_some());
        given.unwrap_or("finish")
    }
}

/// The mean slope 0.125 Rq^0.402 (Rq in um) of a surface with this Rq \[m\], in units of which the
/// table has the slopes of finishes: a fit to machined surfaces. \[seen in public codes\]
fn usual_slope(rq: f64) -> f64 {
    0.125 * (1e6 * rq).powf(POWER)
}

/// The finishes, as a requirement.
fn one_finish() -> String {
    let names: Vec<String> = finishes().map(|name| format!("{name:?}")).collect();
    format!("finish = one of {}", names.join(", "))
}

/// The finish of the table with this name.
fn named(document: &Document<'_>, at: &str, word: &str) -> Result<&'static str, SceneError> {
    let wanted = word.trim().to_lowercase();
    finishes().find(|name| *name == wanted).ok_or_else(|| SceneError::Value {
        at: document.place(at),
        found: format!("{:?}", shorten(word)),
        near: nearest_name(&wanted, finishes()).map(Into::into),
        needed: format!("{} (\"unknown\" for a finish without data)", one_finish()),
    })
}

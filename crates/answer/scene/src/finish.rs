//! Surfaces as drawings give them: a roughness and a finish, from which height, slope and bandwidth
//! follow within ranges.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_2_PI;

use asperity::{
    Code, ContactError, Finding, nearest_name, outside, positive, require, short, unusual,
};

use crate::document::Document;
use crate::error::SceneError;
use crate::finishes::{Range, finishes};
use crate::roughness::Roughness;
use crate::text_file::shorten;
use crate::unknown::Unknown;

/// The keys of a surface by its finish.
pub(crate) const FINISH: &[&str] =
    &["ra", "rq", "rz", "finish", "rsm", "rdq", "bandwidth", "lambda_c", "lambda_s", "mean_slope"];

/// The key of the mean slope.
const SLOPE: &str = "mean_slope";

/// A surface as a drawing gives it: its roughness and its finish, in SI units.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    numbers: BTreeMap<&'static str, f64>,
    pub(crate) finish: Option<&'static str>,
}

type Found<T> = Result<T, ContactError>;

fn missing<T>(field: &'static str, reason: impl Into<String>) -> Found<T> {
    Err(ContactError::Missing { field, reason: reason.into() })
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
        for key in FINISH.iter().filter(|key| **key != "finish") {
            drawing.numbers.extend(document.get(&at(key))?.map(|number| (*key, number)));
        }
        match drawing.conflict() {
            Some((one, other, needed)) => Err(document.conflict(&at(one), &at(other), needed)),
            None => Ok(drawing),
        }
    }

    /// The number of a key as it was written.
    pub(crate) fn get(&self, key: &str) -> Option<f64> {
        self.numbers.get(key).copied()
    }

    pub(crate) fn set(&mut self, key: &'static str, value: f64) {
        self.numbers.insert(key, value);
    }

    /// The numbers that were written.
    pub(crate) fn by_key(&self) -> impl Iterator<Item = (&'static str, f64)> {
        self.numbers.iter().map(|(key, number)| (*key, *number))
    }

    /// The keys of numbers that it has or can have beside the others.
    pub(crate) fn open_keys(&self) -> Vec<&'static str> {
        let fits = |key: &&'static str| {
            let mut edited = self.clone();
            edited.set(key, 1.0);
            *key != "finish" && edited.conflict().is_none()
        };
        FINISH.iter().copied().filter(fits).collect()
    }

    /// Two keys that exclude each other, with what is needed.
    fn conflict(&self) -> Option<(&'static str, &'static str, &'static str)> {
        let given = |key: &&str| self.get(key).is_some();
        if given(&"rdq") && given(&"mean_slope") {
            return Some(("rdq", "mean_slope", "one of the two"));
        }
        // With a width of its elements it gives the slope.
        let is_height = given(&"rz") && !given(&"rsm");
        let other = ["ra", "rq"].into_iter().find(given).filter(|_| is_height)?;
        Some(("rz", other, "one of the two, or rsm beside rz"))
    }

    /// The three numbers of the surface: Rq, the mean slope of the isotropic surface with the same
    /// rms gradient, and the bandwidth, each with its range; that of a given number is a point.
    ///
    /// # Errors
    /// [`ContactError`] naming the number that is missing or out of range.
    pub(crate) fn unknowns(&self) -> Found<[Unknown; 3]> {
        if let Some((one, other, needed)) = self.conflict() {
            let reason = format!("excludes {other}: {needed} was required");
            return Err(ContactError::Refused { model: one.into(), reason });
        }
        let height = self.height()?;
        let cut_offs = self.cut_offs(&height)?;
        let slope = self.areal(self.slope_across(&height, cut_offs)?)?;
        Ok([height, slope, self.bandwidth(cut_offs)?])
    }

    /// The drawing of a surface with this Rq \[m\], from which its slope follows.
    pub(crate) fn with_rq(&self, rq: f64) -> Found<Self> {
        let [short_cut, cut] = self.cut_offs(&self.height()?)?;
        let mut known = self.clone();
        known.numbers.extend([("rq", rq), ("lambda_s", short_cut), ("lambda_c", cut)]);
        // It gave the height alone.
        known.numbers.retain(|key, _| *key != "rz" || self.get("rsm").is_some());
        Ok(known)
    }

    /// Whether one of its numbers has a range.
    pub(crate) fn is_open(&self) -> bool {
        self.unknowns().is_ok_and(|all| all.iter().any(Unknown::is_open))
    }

    /// The surface in the middle of its ranges.
    pub(crate) fn roughness(&self) -> Found<Roughness> {
        Ok(Roughness::of_profile(self.unknowns()?.map(|one| one.middle())))
    }

    /// The finding of an unusual number: of a roughness by the range of its finish.
    pub(crate) fn unusual(&self, key: &'static str, value: f64) -> Option<Finding> {
        let ra = self.height().and_then(|height| self.ra(&height)).ok();
        let (Ok(Range { lower, upper, source, .. }), Some(ra), "ra" | "rq" | "rz") =
            (self.range("ra"), ra, key)
        else {
            return unusual(key, value);
        };
        let found = outside(key, value, [*lower, *upper].map(|usual| usual * value / ra))?;
        let advice = format!("{source}; check the number, its unit and the finish");
        Some(found.advice(advice))
    }

    /// A finding of a finish whose heights have a skewness, beside Gaussian heights.
    pub(crate) fn skewed(&self) -> Option<Finding> {
        let (finish, of) = (self.finish?, self.range("skewness").ok()?);
        let [lower, upper] = [of.lower, of.upper].map(short);
        let fact = format!(
            "{finish} surfaces have a skewness of {lower} to {upper} ({}), but the heights of the scene are Gaussian",
            of.source
        );
        // As low as heights can be described.
        let least = short(of.lower.max(-1.0));
        let give = format!("give a range, heights = {{ skewness = [{least}, {upper}] }}");
        let advice = match of.upper > 0.0 {
            true => give,
            false => format!("{give}: -0.5 makes a joint 1.4 times as stiff, -0.9 twice"),
        };
        let found = Finding::warning(Code::NotGaussian, "finish", 0.5 * (of.lower + of.upper));
        Some(found.fact(fact).advice(advice))
    }

    /// The number of a key, if it is given; an error if it is not positive.
    fn number(&self, key: &'static str) -> Found<Option<f64>> {
        self.get(key).map(|value| positive(key, value)).transpose()
    }

    /// Ra \[m\]: estimated, as of Gaussian heights, where it is not given.
    fn ra(&self, height: &Unknown) -> Found<f64> {
        Ok(self.number("ra")?.unwrap_or_else(|| FRAC_2_PI.sqrt() * height.middle()))
    }

    /// The cut-offs of the profile \[m\], λ_s and λ_c: refuses those that no profile has, and
    /// an Rq or Rz below Ra.
    fn cut_offs(&self, height: &Unknown) -> Found<[f64; 2]> {
        let Some([usual_short, usual]) = Range::cut_offs(self.ra(height)?) else {
            return missing("lambda_c", "a cut-off of the profile");
        };
        let short_cut = self.number("lambda_s")?.unwrap_or(usual_short);
        let cut = self.number("lambda_c")?.unwrap_or(usual);
        let ra = self.number("ra")?;
        for field in ["rq", "rz"] {
            let Some(value) = self.number(field)? else { continue };
            require(ra.is_none_or(|ra| value >= ra), field, value, "a value of at least ra")?;
        }
        require(cut > short_cut, "lambda_c", cut, "a cut-off longer than lambda_s")?;
        Ok([short_cut, cut])
    }

    /// The range of a number for this finish.
    fn range(&self, what: &str) -> Found<&'static Range> {
        Range::of_finish(what, self.finish)
    }

    /// Rq.
    fn height(&self) -> Found<Unknown> {
        if let Some(rq) = self.number("rq")? {
            return Ok(Unknown::given("rq", rq, "rq"));
        }
        let (range, of, text) = match (self.number("ra")?, self.number("rz")?) {
            (Some(ra), _) => {
                let range = self.range("rq_over_ra")?;
                (range, [range.lower, range.upper].map(|ratio| ra * ratio), "ra times")
            }
            (None, Some(rz)) => {
                let range = self.range("rz_over_rq")?;
                (range, [range.lower, range.upper].map(|ratio| rz / ratio), "rz over")
            }
            (None, None) => {
                return missing("ra", "a finish needs the height of the roughness: ra, rq or rz");
            }
        };
        let text = format!("{text} {} to {}", range.lower, range.upper);
        Ok(range.unknown("rq", of, &text, "a measured Rq"))
    }

    /// The mean slope across the lay.
    fn slope_across(&self, height: &Unknown, cut_offs: [f64; 2]) -> Found<Unknown> {
        let (rdq, mean) = (self.number("rdq")?, self.number("mean_slope")?);
        // The mean of |x| of a normal x is √(2/π) standard deviations.
        let of_rdq = rdq.map(|rdq| (FRAC_2_PI.sqrt() * rdq, "rdq"));
        if let Some((slope, key)) = of_rdq.or(mean.map(|mean| (mean, SLOPE))) {
            return Ok(Unknown::given(SLOPE, slope, key));
        }
        let (rz, rsm) = (self.number("rz")?, self.number("rsm")?);
        let slope = match (rz, rsm) {
            (Some(rz), Some(rsm)) => {
                let range = Range::at_ratio("slope_over_rz_rsm", "rdq", cut_offs)?;
                let ends = [range.lower, range.upper].map(|ratio| ratio * 2.0 * rz / rsm);
                let text = format!("2 rz/rsm times {} to {}", range.lower, range.upper);
                range.unknown(SLOPE, ends, &text, "rdq or a scan")
            }
            (None, Some(_)) => return missing("rz", "rsm gives the slope with rz only"),
            _ if self.finish.is_none() => {
                let finishes = one_finish();
                let or = "or rdq, mean_slope, or rz with rsm";
                return missing(
                    "finish",
                    format!("a height leaves the slope open: {finishes}; {or}"),
                );
            }
            _ => {
                let (range, ends) = Range::slopes(self.finish, cut_offs[0])?;
                let [lower, upper] = ends.map(short);
                let text = format!("0.125 Rq^0.402 (um) times {lower} to {upper}");
                let ends = ends.map(|ratio| ratio * usual_slope(height.middle()));
                range.unknown(SLOPE, ends, &text, "rdq, rz with rsm, or a scan")
            }
        };
        Ok(slope)
    }

    /// The slope of the isotropic surface with the same rms gradient as one with this slope across
    /// the lay of the finish; without a finish the surface is isotropic, as one by other numbers.
    fn areal(&self, mut across: Unknown) -> Found<Unknown> {
        let lay = self.range("along_over_across")?;
        let Some(finish) = self.finish.filter(|_| lay.lower < 1.0) else { return Ok(across) };
        let Range { lower, upper, status, source, .. } = lay;
        for (end, ratio) in across.ends.iter_mut().zip([lower, upper]) {
            *end *= (0.5 * (1.0 + ratio * ratio)).sqrt();
        }
        if across.status != "assumed" {
            across.status = status;
        }
        across.source += &format!(
            "; slope along over across the lay of {finish} surfaces {lower} to {upper}: {source}"
        );
        Ok(across)
    }

    /// The bandwidth, given or by the ratio of the cut-offs.
    fn bandwidth(&self, cut_offs: [f64; 2]) -> Found<Unknown> {
        if let Some(bandwidth) = self.number("bandwidth")? {
            return Ok(Unknown::given("bandwidth", bandwidth, "bandwidth"));
        }
        let [short_cut, cut] = cut_offs.map(|length| short(1e6 * length));
        let text = format!("lambda_c {cut} um, lambda_s {short_cut} um");
        let range = Range::at_ratio("bandwidth", "bandwidth", cut_offs)?;
        let ends = [range.lower, range.upper];
        Ok(range.unknown("bandwidth", ends, &text, "bandwidth or a scan"))
    }
}

/// The mean slope 0.125 Rq^0.402 (Rq in um) of a surface with this Rq \[m\], in units of which the
/// table has the slopes of finishes: a fit to machined surfaces. \[seen in public codes\]
fn usual_slope(rq: f64) -> f64 {
    0.125 * (1e6 * rq).powf(0.402)
}

/// The finishes, as a requirement.
fn one_finish() -> String {
    let names: Vec<String> = finishes().map(|name| format!("{name:?}")).collect();
    format!("finish = one of {}", names.join(", "))
}

/// The finish of the table with this name.
fn named(document: &Document<'_>, at: &str, word: &str) -> Result<&'static str, SceneError> {
    let wanted = word.trim().to_lowercase();
    finishes().find(|name| *name == wanted).ok_or_else(|| {
        let needed = format!("{} (\"unknown\" for a finish without data)", one_finish());
        let found = format!("{:?}", shorten(word));
        SceneError::of_names(document.place(at), &found, nearest_name(&wanted, finishes()), &needed)
    })
}

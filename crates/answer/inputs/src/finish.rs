//! Surfaces as drawings give them: a roughness and a finish, from which height, slope and bandwidth
//! follow within ranges.

use std::f64::consts::FRAC_2_PI;

use asperity::{Code, Finding, nearest_name, short};

use crate::SceneError;
use crate::document::Document;
use crate::finishes::{Range, UNKNOWN, finishes};
use crate::likely::{in_other_unit, other_unit};
use crate::text_file::shorten;
use crate::unknowns::{Face, NAMES, Unknown};

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

/// The numbers that a section takes from a drawing.
struct Drawing<'d> {
    document: &'d Document<'d>,
    section: &'static str,
    finish: Option<&'static str>,
    /// The cut-offs of the profile \[m\]: λ_s and λ_c.
    wavelengths: [f64; 2],
}

type Read<T> = Result<T, SceneError>;

/// The surface that the keys of a section describe, the warning of a number that is probably in
/// another unit, and those of numbers that contradict each other.
///
/// # Errors
/// [`SceneError`] for a finish that is not in the table, a number that is out of range, and a
/// missing height or slope.
pub(crate) fn face(
    document: &Document<'_>,
    section: &'static str,
) -> Read<(Face, Option<Finding>, Vec<Finding>)> {
    let at = format!("{section}.finish");
    let word: Option<String> = document.get(&at)?;
    let finish = word.map(|word| named(document, &at, &word)).transpose()?;
    let mut drawing = Drawing { document, section, finish, wavelengths: [0.0; 2] };
    let (height, ra) = drawing.height()?;
    let usual = Range::wavelengths(ra);
    for (k, key) in ["lambda_s", "lambda_c"].into_iter().enumerate() {
        let usual = usual.map(|usual| usual[k]);
        drawing.wavelengths[k] = match drawing.number(key)?.or(usual) {
            Some(length) => length,
            None => return drawing.missing(key, "a cut-off of the profile".into()),
        };
    }
    drawing.check()?;
    let (across, slope_power) = drawing.slope_across(&height)?;
    let bandwidth = drawing.bandwidth()?;
    let (odd, notes) = (drawing.odd()?, drawing.warnings(ra, &height, &across)?);
    let slope = drawing.areal(across)?;
    Ok((Face { section, unknowns: [height, slope, bandwidth], slope_power }, odd, notes))
}

impl Drawing<'_> {
    fn at(&self, key: &str) -> String {
        format!("{}.{key}", self.section)
    }

    /// The number of a key, if it is given; an error if it is not positive.
    fn number(&self, key: &'static str) -> Read<Option<f64>> {
        self.document.positive(self.section, key)
    }

    fn missing<T>(&self, key: &str, needed: String) -> Read<T> {
        Err(self.document.missing(&self.at(key), needed))
    }

    /// Refuses cut-offs that no profile has, and an Rq below Ra.
    fn check(&self) -> Read<()> {
        let [short_cut, cut] = self.wavelengths;
        let below = self.number("rq")?.zip(self.number("ra")?).filter(|(rq, ra)| rq < ra);
        let (key, value, hint) = match below {
            Some((rq, _)) => ("rq", rq, "is below ra, which no surface has: check both"),
            None if cut > LONGEST => ("lambda_c", cut, "is in m: write \"0.8 mm\", for example"),
            None if cut <= short_cut => {
                ("lambda_c", cut, "is the long cut-off of the profile, and lambda_s is no shorter")
            }
            None => return Ok(()),
        };
        let at = self.document.place(&self.at(key));
        Err(SceneError::Notation { at, found: short(value), hint: hint.into() })
    }

    /// The range of a number for this finish.
    fn range(&self, what: &str) -> Read<&'static Range> {
        match Range::of_finish(what, self.finish.unwrap_or(UNKNOWN)) {
            Some(range) => Ok(range),
            None => self.missing("finish", format!("a finish with a known {what}")),
        }
    }

    /// The range of a number for these cut-offs, or an error that asks for `key` instead.
    fn at_ratio(&self, what: &str, key: &str) -> Read<&'static Range> {
        let [short_cut, cut] = self.wavelengths;
        match Range::at_ratio(what, cut / short_cut) {
            Some(range) => Ok(range),
            None => self.missing(
                key,
                format!(
                    "lambda_c/lambda_s is {}, and scans give a range from 10 to 320 only",
                    short(cut / short_cut)
                ),
            ),
        }
    }

    /// Rq, and Ra \[m\]: estimated, as of Gaussian heights, where it is not given.
    fn height(&self) -> Read<(Unknown, f64)> {
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
            (None, None) => self
                .missing("ra", "a finish needs the height of the roughness: ra, rq or rz".into()),
        }
    }

    /// The mean slope across the lay at the middle of Rq, and the power of Rq by which it varies.
    fn slope_across(&self, height: &Unknown) -> Read<(Unknown, f64)> {
        let (rdq, mean) = (self.number("rdq")?, self.number("mean_slope")?);
        if rdq.is_some() && mean.is_some() {
            let [rdq, mean] = ["rdq", "mean_slope"].map(|key| self.at(key));
            return Err(self.document.conflict(&rdq, &mean, "one of the two"));
        }
        // The mean of |x| of a normal x is √(2/π) standard deviations.
        let of_rdq = rdq.map(|rdq| (FRAC_2_PI.sqrt() * rdq, "rdq"));
        if let Some((slope, key)) = of_rdq.or(mean.map(|mean| (mean, "mean_slope"))) {
            return Ok((Unknown::given(NAMES[1], slope, key), 0.0));
        }
        let (rz, rsm) = (self.number("rz")?, self.number("rsm")?);
        if rsm.is_some() && rz.is_none() {
            return self.missing("rz", "rsm gives the slope with rz only".into());
        }
        let (range, slope, power, text, narrowed) = match rz.zip(rsm) {
            Some((rz, rsm)) => {
                let range = self.at_ratio("slope_over_rz_rsm", "rdq")?;
                (range, 2.0 * rz / rsm, 0.0, "times 2 rz/rsm", "rdq or a scan")
            }
            None if self.finish.is_none() => {
                return self.missing(
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
    fn tool(&self) -> Read<Option<(f64, f64)>> {
        let (feed, radius) = (self.number("feed")?, self.number("nose_radius")?);
        let given = feed.map(|_| "feed").or(radius.map(|_| "nose_radius"));
        match (given, feed.zip(radius)) {
            (Some(key), _) if self.finish != Some("turned") => {
                let needed = "finish = \"turned\", whose cusps have a feed and a nose_radius,";
                Err(self.document.conflict(&self.at(key), &self.at("finish"), needed))
            }
            (Some(_), None) => {
                let key = if feed.is_some() { "nose_radius" } else { "feed" };
                self.missing(key, "feed and nose_radius go together".into())
            }
            (_, tool) => Ok(tool),
        }
    }

    /// The slope of the isotropic surface with the same rms gradient as one with this slope across
    /// the lay of the finish; without a finish the surface is isotropic, as one by other numbers.
    fn areal(&self, across: Unknown) -> Read<Unknown> {
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
    fn bandwidth(&self) -> Read<Unknown> {
        if let Some(bandwidth) = self.number("bandwidth")? {
            return Ok(Unknown::given(NAMES[2], bandwidth, "bandwidth"));
        }
        let range = self.at_ratio("bandwidth", "bandwidth")?;
        let [short_cut, cut] = self.wavelengths.map(|length| short(1e6 * length));
        let source = format!("lambda_c {cut} um, lambda_s {short_cut} um: {}", range.source);
        let ends = [range.lower, range.upper];
        Ok(Unknown::new(NAMES[2], ends, &range.status, source, "bandwidth or a scan"))
    }

    /// The warning of a height that only another unit makes usual.
    fn odd(&self) -> Read<Option<Finding>> {
        let mut given = vec![];
        for key in ["ra", "rq", "rz"] {
            given.extend(self.number(key)?.map(|value| (key, value)));
        }
        let odd = other_unit(self.document, self.section, given);
        Ok(odd.map(|odd| in_other_unit(self.document, self.section, odd)))
    }

    /// The warnings of numbers that contradict each other.
    fn warnings(&self, ra: f64, height: &Unknown, across: &Unknown) -> Read<Vec<Finding>> {
        let mut found = vec![];
        let mut warn = |key: &'static str, value: f64, fact: String, advice: &str| {
            let place = self.document.place(&self.at(key)).to_string();
            let warning = Finding::warning(Code::RoughnessNumbers, key, value);
            found.push(warning.fact(fact).advice(advice.to_string()).from_origin(place));
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
        let given =
            ["rdq", "mean_slope", "rsm"].into_iter().find(|key| self.document.has(&self.at(key)));
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
fn named(document: &Document<'_>, at: &str, word: &str) -> Read<&'static str> {
    let wanted = word.trim().to_lowercase();
    finishes().find(|name| *name == wanted).ok_or_else(|| SceneError::Value {
        at: document.place(at),
        found: format!("{:?}", shorten(word)),
        near: nearest_name(&wanted, finishes()).map(Into::into),
        needed: format!("{} (\"unknown\" for a finish without data)", one_finish()),
    })
}

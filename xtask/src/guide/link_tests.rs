//! Checks the links of html files: none dangles, none leads outside but to a DOI.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use anyhow::Result;

use super::site::{DOI, normal};
use crate::folder::read;

/// The violations among the links of these files, each with its page. `elsewhere` are files that
/// are not checked to exist, such as the explorer where the guide alone was written.
///
/// # Errors
/// A page that cannot be read.
pub(crate) fn violations(pages: &[PathBuf], elsewhere: &[PathBuf]) -> Result<Vec<String>> {
    let (mut ids, mut found) = (HashMap::new(), vec![]);
    for page in pages {
        let html = read(page)?;
        for address in attributes(&html, &["href", "src"]) {
            if let Some(reason) = violation(page, &address, elsewhere, &mut ids)? {
                found.push(format!("{}: {address}: {reason}", page.display()));
            }
        }
    }
    Ok(found)
}

fn violation(
    page: &Path,
    address: &str,
    elsewhere: &[PathBuf],
    ids: &mut HashMap<PathBuf, Vec<String>>,
) -> Result<Option<&'static str>> {
    if address.starts_with(DOI) || address.starts_with("data:") {
        return Ok(None);
    }
    if address.contains(':') || address.starts_with('/') {
        return Ok(Some("leads outside"));
    }
    let (path, anchor) = address.split_once('#').unwrap_or((address, ""));
    let path = path.split('?').next().unwrap_or_default();
    let folder = page.with_file_name("");
    let target = if path.is_empty() { page.to_owned() } else { normal(&folder.join(path)) };
    if elsewhere.contains(&target) {
        return Ok(None);
    }
    if !target.is_file() {
        return Ok(Some("no such file"));
    }
    // What opens a state of the explorer is no place in its page.
    let is_page = target.extension().is_some_and(|extension| extension == "html");
    if anchor.is_empty() || anchor.starts_with("s=") || !is_page {
        return Ok(None);
    }
    if !ids.contains_key(&target) {
        ids.insert(target.clone(), attributes(&read(&target)?, &["id"]));
    }
    Ok((!ids[&target].iter().any(|id| id == anchor)).then_some("no such heading"))
}

/// The values of attributes of these names within tags.
fn attributes(html: &str, names: &[&str]) -> Vec<String> {
    let mut found = vec![];
    for tag in html.split('<').skip(1) {
        let tag = tag.split('>').next().unwrap_or_default().replace('\n', " ");
        for name in names {
            let start = format!(" {name}=\"");
            let values = tag.split(&start).skip(1).filter_map(|rest| rest.split('"').next());
            found.extend(values.map(|value| value.replace("&amp;", "&")));
        }
    }
    found
}

#[test]
fn each_kind_of_broken_link_is_found_and_no_other() {
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("a.html");
    let other = "<a href=\"b.html#here\">b</a> <a href=\"https://doi.org/10.1/x\">d</a>\
        <a href=\"#top\" id=\"top\">t</a> <a href=\"../index.html\">e</a> href=\"text\"";
    let wrong = "<a href=\"b.html#there\">b</a> <img src=\"c.svg\"> <a href=\"//x.org\">x</a>\
        <a href=\"https://x.org\">y</a> <a href=\"#nowhere\">z</a>";
    std::fs::write(&page, format!("{other}{wrong}")).unwrap();
    std::fs::write(folder.path().join("b.html"), "<p id=\"here\">").unwrap();
    let explorer = normal(&folder.path().join("../index.html"));
    let found = violations(&[page], &[explorer]).unwrap();
    let reasons: Vec<&str> =
        found.iter().map(|text| text.split_once(".html: ").unwrap().1).collect();
    assert_eq!(
        reasons,
        [
            "b.html#there: no such heading",
            "c.svg: no such file",
            "//x.org: leads outside",
            "https://x.org: leads outside",
            "#nowhere: no such heading",
        ]
    );
}

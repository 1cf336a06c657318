//! No content of a file causes a panic or takes long.

use std::path::Path;
use std::time::{Duration, Instant};

use asperity_scene::{parse, template};
use proptest::prelude::*;

fn refused(text: &str) -> String {
    parse(text, Path::new(".")).unwrap_err().to_string()
}

#[test]
fn known_attacks_give_an_error_within_seconds() {
    let deep = 30_000;
    let attacks = [
        ("nested lists", format!("x = {}", "[".repeat(deep))),
        ("closed nested lists", format!("x = {}{}", "[".repeat(deep), "]".repeat(deep))),
        ("nested tables", format!("x = {}", "{a=".repeat(deep))),
        ("a long dotted key", format!("{}a = 1", "a.".repeat(deep))),
        ("a long header", format!("[{}a]", "a.".repeat(deep))),
        ("many bodies", "[[body]]\n".repeat(deep)),
        ("many keys", (0..deep).map(|k| format!("k{k} = 1\n")).collect()),
        ("a long number", format!("nominal_area = {}", "9".repeat(30 * deep))),
        ("a long name", format!("[options]\nstick = \"{}\"", "x".repeat(deep))),
        ("a long option", format!("[options]\nforce = {{ {} = \"\" }}", "x".repeat(deep))),
        ("a long key", format!("{} = 1", "x".repeat(deep))),
        ("zero bytes", "\0".repeat(1000)),
        ("half a string", "heights = \"abc".into()),
        ("a byte order mark", "\u{feff}".into()),
    ];
    for (name, text) in attacks {
        let start = Instant::now();
        let message = refused(&text);
        assert!(start.elapsed() < Duration::from_secs(5), "{name}: {:?}", start.elapsed());
        assert!(message.len() < 1000, "{name}: {} characters", message.len());
    }
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused(text in "\\PC{0,200}") {
        let _ = parse(&text, Path::new("."));
    }

    #[test]
    fn tokens_in_any_order_are_read_or_refused(
        tokens in prop::collection::vec(prop::sample::select(vec![
            "nominal_area", "=", "1", "\n", "[", "]", "[[", "]]", "{", "}", ",", "\"", "heights",
            "body", "surface", "interface", "options", "file", "1e-6", "m0", "true", ".", "#", "'",
            "separation_from", "displacement", "zeta", "-1", "nan", "angle_density", "a20", "\"\"\"",
        ]), 0..60),
    ) {
        let _ = parse(&tokens.join(" "), Path::new("."));
        let _ = parse(&tokens.concat(), Path::new("."));
    }

    #[test]
    fn a_damaged_template_is_read_or_refused_with_a_line(at in 0usize..4000, cut in 0usize..40, put in "\\PC{0,3}") {
        let mut text: Vec<char> = template().chars().collect();
        let at = at.min(text.len());
        let end = (at + cut).min(text.len());
        text.splice(at..end, put.chars());
        if let Err(error) = parse(&text.iter().collect::<String>(), Path::new(".")) {
            prop_assert!(error.to_string().contains("line "), "{error}");
        }
    }
}

#[test]
fn sizes_off_by_a_million_have_one_finding_each() {
    const JOINT: &str = include_str!("../../examples/bolted-joint.toml");
    let surface = "asperity_height_std = 2e-6";
    for (field, text) in [
        (
            "gap.gas_conductivity",
            "[gap]\ngas_conductivity = 26000\ngas_parameter = 3.7e-7\n".into(),
        ),
        ("gap.gas_parameter", "[gap]\ngas_conductivity = 0.026\ngas_parameter = 0.37\n".into()),
        ("mean_plane_offset", format!("{surface}\nmean_plane_offset = 2.5")),
    ] {
        let text = match field.starts_with("gap") {
            true => format!("{JOINT}\n{text}"),
            false => JOINT.replace(surface, &text),
        };
        let file = asperity_scene::parse(&text, std::path::Path::new(".")).unwrap();
        let found: Vec<_> = file.findings().into_iter().collect();
        assert!(found.len() == 1 && found[0].is_implausible(), "{field}: {found:?}");
        assert_eq!(found[0].field, field);
    }
}

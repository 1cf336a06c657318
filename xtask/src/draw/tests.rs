//! Tests of whole figures, by their SVG text.

use anyhow::Result;

use super::*;

const CSV: &str = "curve,x,y\na,0,1\na,1,10\na,2,100\nb,0,3\nb,1,-5\nb,2,30\n";

fn figure(keys: &[&str], log: bool) -> Figure {
    let y = Axis::new("y", "force (N)");
    let mut panel = Panel::new(Axis::new("x", "separation (m)"), if log { y.log() } else { y });
    panel.curves =
        keys.iter().enumerate().map(|(i, key)| CurveStyle::numbered(i, key, key)).collect();
    Figure { panels: vec![panel], ..Figure::default() }
}

fn message(figure: &Figure, csv: &str) -> String {
    draw(figure, csv).err().map(|error| format!("{error:#}")).unwrap_or_default()
}

/// All numbers in the `points` of the polylines of a colour.
fn polylines(svg: &str, colour: &str) -> Vec<Vec<(i32, i32)>> {
    let point = |pair: &str| {
        let (x, y) = pair.split_once(',')?;
        Some((x.parse().ok()?, y.parse().ok()?))
    };
    svg.lines()
        .filter(|line| line.starts_with("<polyline") && line.contains(colour))
        .filter_map(|line| line.split_once("points=\"")?.1.split('"').next())
        .map(|points| points.split_whitespace().filter_map(point).collect())
        .collect()
}

#[test]
fn the_same_input_gives_the_same_bytes() -> Result<()> {
    let figure = figure(&["a", "b"], true);
    let svg = draw(&figure, CSV)?;
    assert!(svg == draw(&figure, CSV)?);
    assert!(svg.contains("width=\"800\" height=\"600\" viewBox=\"0 0 2400 1800\""));
    assert_eq!(svg.matches("<svg").count(), 1);
    assert!(svg.ends_with("</svg>\n") && !svg.contains("NaN"));
    Ok(())
}

#[test]
fn no_curve_is_drawn_outside_or_along_the_frame() -> Result<()> {
    let mut figure = figure(&["a", "b"], true);
    figure.panels[0].y.range = Some((2.0, 50.0));
    figure.panels[0].legend = Legend::Hidden;
    let svg = draw(&figure, CSV)?;
    let frame = polylines(&svg, "stroke=\"#000000\" stroke-width=\"16\"").concat();
    let top = frame.iter().map(|point| point.1).min().unwrap_or(0);
    let foot = frame.iter().map(|point| point.1).max().unwrap_or(0);
    assert!(foot > top + 1000);
    for colour in ["#000000\" stroke-width=\"24\"", "#E69F00\" stroke-width=\"24\""] {
        let lines = polylines(&svg, colour);
        assert!(!lines.is_empty());
        for line in lines {
            assert!(line.iter().all(|point| (top..=foot).contains(&point.1)), "{line:?}");
            let along =
                |pair: &[(i32, i32)]| pair[0].1 == pair[1].1 && [top, foot].contains(&pair[0].1);
            assert!(!line.windows(2).any(along), "{line:?}");
        }
    }
    Ok(())
}

#[test]
fn an_empty_csv_names_the_missing_column() {
    assert!(message(&figure(&["a"], false), "").contains("column `x`"));
    assert!(message(&figure(&["a"], false), "curve,x,z\na,1,2\n").contains("column `y`"));
}

#[test]
fn an_unknown_curve_and_an_undrawn_one_are_named() -> Result<()> {
    assert!(message(&figure(&["a", "b", "nobody"], false), CSV).contains("`nobody`"));
    let mut partial = figure(&["a"], false);
    assert!(message(&partial, CSV).contains("`b`"));
    partial.allow_undrawn = true;
    draw(&partial, CSV)?;
    Ok(())
}

#[test]
fn a_curve_with_nothing_inside_is_named() {
    let csv = "curve,x,y\na,0,1\na,1,10\nb,0,-1\nb,1,-2\n";
    assert!(message(&figure(&["a", "b"], true), csv).contains("curve `b`"));
}

#[test]
fn the_legend_shows_dashes_and_markers() -> Result<()> {
    let mut figure = figure(&["a", "b"], false);
    let with = draw(&figure, CSV)?;
    figure.panels[0].legend = Legend::Hidden;
    let without = draw(&figure, CSV)?;
    let count = |svg: &str, what: &str| svg.lines().filter(|line| line.contains(what)).count();
    let orange = "stroke=\"#E69F00\" stroke-width=\"24\"";
    assert!(count(&with, orange) >= count(&without, orange) + 2, "dashes in the key");
    assert_eq!(count(&with, "<circle"), count(&without, "<circle") + 2, "marker and its rim");
    let open = "stroke=\"#E69F00\" stroke-width=\"20\"";
    assert_eq!(count(&with, open), count(&without, open) + 1, "open marker");
    Ok(())
}

#[test]
fn a_gap_is_a_break_that_can_be_joined_by_dots() -> Result<()> {
    let csv = "curve,x,y\na,0,1\na,1,1\n\na,1,5\na,2,5\n";
    let mut figure = figure(&["a"], false);
    figure.panels[0].legend = Legend::Hidden;
    let ink = "stroke=\"#000000\" stroke-width=\"24\"";
    let plain = draw(&figure, csv)?;
    assert_eq!(polylines(&plain, ink).len(), 2);
    figure.panels[0].curves[0].join_gaps = true;
    let dots = "stroke=\"#404040\"";
    assert!(polylines(&plain, dots).is_empty());
    assert!(polylines(&draw(&figure, csv)?, dots).len() > 10);
    Ok(())
}

#[test]
fn three_panels_are_labelled_and_text_is_escaped() -> Result<()> {
    let mut figure = figure(&["a", "b"], false);
    figure.title = "a < b & c".to_owned();
    figure.panels = vec![figure.panels[0].clone(); 3];
    figure.shared_legend = true;
    for arrangement in [Arrangement::Stacked, Arrangement::SideBySide] {
        figure.arrangement = arrangement;
        let svg = draw(&figure, CSV)?;
        for label in [">(a)<", ">(b)<", ">(c)<", "a &lt; b &amp; c"] {
            assert!(svg.contains(label), "{label}");
        }
    }
    figure.panels.push(figure.panels[0].clone());
    assert!(draw(&figure, CSV).is_err());
    Ok(())
}

#[test]
fn a_legend_without_room_inside_goes_to_the_right() -> Result<()> {
    let mut csv = String::from("curve,x,y\n");
    for i in 0..=400 {
        let x = f64::from(i) * 0.01;
        csv.push_str(&format!("a,{x},{}\n", (x * 60.0).sin()));
    }
    let mut figure = figure(&["a"], false);
    figure.panels[0].y.range = Some((-1.0, 1.0));
    let automatic = draw(&figure, &csv)?;
    figure.panels[0].legend = Legend::Right;
    assert!(automatic == draw(&figure, &csv)?);
    Ok(())
}

#[test]
fn direct_names_stand_beside_their_points_inside_the_frame() -> Result<()> {
    let mut figure = figure(&["a", "b"], false);
    figure.panels[0].legend = Legend::Direct;
    figure.panels[0].curves[1].label = "second name".to_owned();
    let svg = draw(&figure, CSV)?;
    assert_eq!(svg.matches("second name").count(), 1);
    figure.panels[0].curves[1].label = String::new();
    assert!(!draw(&figure, CSV)?.contains("second name"));
    Ok(())
}

//! What `fit` refuses, and how it says so.

use crate::bench::{Bench, cells, column};
use crate::fit::{stiffness_rows, write_rows};

pub const AREAS: &str = "load_N,area_m2\n10,5e-9\n100,5e-8\n";

/// Runs `fit`, which must end with an error that contains the text and print no result.
pub fn refused(bench: &Bench, arguments: &str, wanted: &str) {
    let run = bench.run(&format!("fit scene.toml {arguments}"));
    assert_eq!(run.code, Some(1), "{arguments}: {}", run.messages);
    assert!(run.messages.contains(wanted), "{arguments}: {}", run.messages);
    assert!(run.out.is_empty(), "{}", run.out);
}

/// The error of a `fit` that ends with one and prints no result, under the words of its mistake.
pub fn refusal(bench: &Bench, mistake: &str, arguments: &str) -> String {
    let run = bench.run(&format!("fit scene.toml {arguments}"));
    assert!(run.out.is_empty(), "{}", run.out);
    let error = run.messages.lines().find(|line| line.starts_with("error")).unwrap();
    let code = if error.starts_with("error: --") { 2 } else { 1 };
    assert_eq!(run.code, Some(code), "{arguments}: {}", run.messages);
    format!("{mistake:?}\n    {error}\n")
}

#[test]
fn bad_data_are_refused_with_their_row_and_column() {
    let bench = Bench::new();
    let mut all = String::new();
    for text in [
        "load_N,aera_m2\n1,1\n",
        "Load_N,area_m2\n1,1\n",
        "load [N],area_m2\n1,1\n",
        "load,area_m2\n1,1\n",
        "load_kN,area_m2\n1,1e-9\n",
        "load_N,area_m2\n1,5,3e-8\n",
        "area_m2\n1e-9\n",
        "load_N\n1\n",
        "load_N,area_m2\n1,\n",
        "load_N,area_m2\n-1,1e-9\n",
        "load_N,area_m2\n1,1e-9\n2,0\n",
        "load_N,area_m2,area_m2_std\n1,1e-9,0\n",
        "load_N,area_m2,area_m2_std\n1,1e-9,1e-10\n2,2e-9,\n",
        "load_N,area_m2,tangent_N_per_m_std\n1,1e-9,1\n",
        "load_N,area_m2,area_m2\n1,1e-9,1e-9\n",
        "load_N,area_m2\n1,big\n",
        "1,1e-9\n2,2e-9\n",
        "load_N,area_m2\n1\n",
        "load_N,area_m2\n1,nan\n",
        "load_N,area_m2\ninf,1\n",
        "load_N,area_fraction\n1,2.5\n",
        "load_N,stiffness_per_area_N_per_m3\n1,1e12\n",
        "load_N,area_m2\n1,1e400\n",
        "load_N,area_m2\n,1\n",
        "load_N,force_N\n1,1\n",
        "model,load_N,area_m2\nke,1,1e-9\ngw,1,1e-9\n",
        "",
    ] {
        bench.write("data.csv", text);
        all += &refusal(&bench, text, "data.csv --free hardness");
    }
    insta::assert_snapshot!(all);
}

#[test]
fn bad_parameters_are_refused_by_name() {
    let bench = Bench::new();
    bench.write("data.csv", AREAS);
    let mut all = String::new();
    for free in [
        "hardnes",
        "hardness,hardness",
        "hardness=1:4",
        "asperity_density=100:300",
        "hardness=4GPa:1GPa",
        "thermal_conductivity",
        "separation_offset",
        "series_compliance",
        "plasticity_index,asperity_radius",
        "asperity_radius,asperity_density,asperity_height_std",
        "hardness --model bem",
        "m0",
    ] {
        all += &refusal(&bench, free, &format!("data.csv --free {free}"));
    }
    insta::assert_snapshot!(all);
    refused(&bench, "none.csv --free hardness", "none.csv");
    std::fs::write(bench.path("table.xlsx"), b"PK\x03\x04\x14\x00\x06\x00").unwrap();
    refused(&bench, "table.xlsx --free hardness", "table.xlsx");
    let run = bench.run("check table.xlsx");
    assert!(run.code == Some(1), "{}", run.messages);
    for usage in [
        "data.csv",
        "data.csv --free hardness=1N:2N",
        "data.csv --free hardness=1GPa",
        "data.csv --free hardness=0.1:5GPa",
        "data.csv --free hardness=1GPa:5e9",
        "data.csv --free =1:2",
        "--free hardness",
        "--free hardness --target area=1e-9",
        "--free hardness --target aera=1e-9 --load 1",
        "--free hardness --target area=1e-9 --separation 2",
        "data.csv --free hardness --target area=1e-9 --load 1",
        "data.csv --free hardness --load 1",
        "data.csv --free hardness --plot fit.png",
    ] {
        let run = bench.run(&format!("fit scene.toml {usage}"));
        assert_eq!(run.code, Some(2), "{usage}: {}", run.messages);
    }
}

#[test]
fn a_model_without_the_quantity_is_left_out_among_others() {
    let bench = Bench::new();
    bench.write("data.csv", "load_N,unloading_stiffness_N_per_m\n10,5e7\n100,5e8\n");
    let fit = "fit scene.toml data.csv --free asperity_height_std --format csv --model";
    let run = bench.run(&format!("{fit} gao,ke"));
    assert_eq!((run.code, cells(&run.out, "model")), (Some(0), vec!["ke"]), "{}", run.messages);
    assert!(run.messages.contains("[left-out]"));
    let run = bench.run(&format!("{fit} gao"));
    assert!(run.code == Some(1));
}

#[test]
fn loads_and_pressures_of_one_row_must_agree() {
    let bench = Bench::new();
    bench.write("data.csv", "load_N,pressure_Pa,area_m2\n10,1e5,5e-9\n100,1e5,5e-8\n");
    let wanted = "data.csv";
    refused(&bench, "data.csv --free asperity_height_std", wanted);
}

#[test]
fn elastic_models_warn_of_yielding_as_in_curves() {
    let bench = Bench::new();
    write_rows(&bench, stiffness_rows(&bench));
    let run = bench.run("fit scene.toml data.csv --free asperity_height_std --model gw");
    assert!(run.code == Some(0) && run.messages.contains("[yields]"), "{}", run.messages);
}

#[test]
fn bounds_with_a_unit_are_in_no_other() {
    let bench = Bench::new();
    write_rows(&bench, stiffness_rows(&bench));
    let fit = "fit scene.toml data.csv --format csv --free asperity_height_std=200um:2mm";
    let run = bench.run(fit);
    assert!(!run.messages.contains("look like"), "{}", run.messages);
    assert!(!column(&run.out, "value").is_empty(), "{}", run.messages);
}

#[test]
fn data_that_a_model_does_not_have_are_named_by_their_file() {
    let bench = Bench::new();
    bench.write("data.csv", "load_N,thermal_conductance_W_per_K\n10,5\n100,50\n");
    let wanted = "data.csv";
    refused(&bench, "data.csv --free asperity_height_std", wanted);
}

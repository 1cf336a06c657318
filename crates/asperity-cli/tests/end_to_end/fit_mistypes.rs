//! Names of columns and numbers as others write them.

use crate::bench::Bench;
use crate::fit_refusals::{AREAS, refused};

#[test]
fn usual_names_of_columns_and_numbers_lead_to_ours() {
    let bench = Bench::new();
    for (head, wanted) in [
        ("F [kN],area_m2", "column \"F [kN]\" is in kN: name it load_N and multiply its values by"),
        ("p_MPa,area_m2", "column \"p_MPa\" is in MPa: name it pressure_Pa and multiply its"),
        ("load_N,gap_um", "column \"gap_um\" is in um: name it separation_m and multiply its"),
        ("load_N,contact_area_m2", "\"contact_area_m2\" is not known (the nearest is \"area_m2\")"),
        (
            "load_N,area_percent",
            "column \"area_percent\" is in %: name it area_fraction and multiply its values by 0.01",
        ),
        ("F/N,area_m2", "column \"F/N\" is not known (the nearest is \"load_N\")"),
        (
            "pressure [N/cm2],area_m2",
            "is in N/cm2: name it pressure_Pa and multiply its values by 10000",
        ),
        ("load_N,d [\u{b5}m]", "is in um: name it separation_m and multiply its values by 1e-6"),
        (
            "load_N,stiffness (N/um)",
            "stiffness (N/um): the name does not say which stiffness was measured: name the column unloading_stiffness_N_per_m (small vibrations, ultrasound, start of unloading), tangent_N_per_m (first loading) or tangential_stiffness_N_per_m (shear), and multiply its values by 1e6",
        ),
        ("load_N,contact_stiffness", "does not say which stiffness was measured: name the column"),
        ("load_N,kn [GN/m]", "(shear), and multiply its values by 1e9"),
        ("load_N,tangent_N/m", "\"tangent_N/m\" is not known (the nearest is \"tangent_N_per_m\")"),
        ("load_N,tangent_N/um", "is in N/um: name it tangent_N_per_m and multiply its values by"),
        ("load_N,area_m\u{b2}", "is not known (the nearest is \"area_m2\")"),
        (
            "load_N,displacement_um",
            "displacement_um: a displacement grows where the separation falls: name the column separation_m, change the sign",
        ),
        (
            "force_N,area_m2",
            "a column load_N, pressure_Pa or separation_m was required; name force_N load_N if",
        ),
    ] {
        bench.write("data.csv", &format!("{head}\n10,5e-9\n100,5e-8\n"));
        refused(&bench, "data.csv --free hardness", wanted);
    }
    bench.write("data.csv", "load_N,area_m2,area_std\n10,5e-9,1e-9\n100,5e-8,1e-8\n");
    let std = "column \"area_std\" is not known (the nearest is \"area_m2_std\")";
    refused(&bench, "data.csv --free hardness", std);
    bench.write("data.csv", "load_N,area_m2,comment\n10,5e-9,first\n");
    let comment =
        "data.csv:2: comment = \"first\" is no number, and no fit reads this column; remove it";
    refused(&bench, "data.csv --free hardness", comment);
    bench.write("data.csv", AREAS);
    for (symbol, key) in
        [("H", "hardness"), ("E", "youngs_modulus"), ("sigma", "asperity_height_std")]
    {
        let wanted = format!("{symbol} is not an input of this scene (the nearest is \"{key}\")");
        refused(&bench, &format!("data.csv --free {symbol}"), &wanted);
    }
    let inverse = "(the nearest is \"electrical_resistivity\"): one of ";
    refused(&bench, "data.csv --free electrical_conductivity", inverse);
    let note = bench.run("fit scene.toml data.csv --free poissons_ratio").messages;
    assert!(
        note.contains(" to 0.5, a factor 30 either way, at most to its limit of 0.5"),
        "{note}"
    );
    for (given, written) in [
        ("data.csv --free asperity_height_std=0,1um:5um", "asperity_height_std=0.1um:5um"),
        ("--free hardness --target area_fraction=0,1% --load 1", "area_fraction=0.1%"),
    ] {
        let run = bench.run(&format!("fit scene.toml {given}"));
        let wanted = format!("decimal points, commas separate items; write {written}");
        assert!(run.code == Some(2) && run.messages.contains(&wanted), "{}", run.messages);
    }
    let run = bench.run("fit scene.toml data.csv --free hardness=2GPa");
    let one = "\"2GPa\" is one value: write hardness=low:high for bounds, or hardness alone";
    assert!(run.code == Some(2) && run.messages.contains(one), "{}", run.messages);
}

#[test]
fn data_and_scene_in_each_others_place_are_named() {
    let bench = Bench::new();
    bench.write("data.csv", AREAS);
    let run = bench.run("fit data.csv scene.toml --free hardness");
    let wanted = "the file looks like measurements, not like a scene in TOML";
    assert!(run.code == Some(1) && run.messages.contains(wanted), "{}", run.messages);
    assert!(run.messages.ends_with("; give the scene first, then the measurements\n"));
    let wanted =
        "scene.toml: CSV: the file looks like a scene, not like measurements; give the scene";
    refused(&bench, "scene.toml --free hardness", wanted);
}

#[test]
fn a_scene_with_an_error_is_not_fitted() {
    let bench = Bench::new();
    bench.write("data.csv", AREAS);
    let scene = std::fs::read_to_string(bench.path("scene.toml")).unwrap();
    let wrong = scene.replace("asperity_height_std = 1e-6", "asperity_height_std = 1.0");
    assert_ne!(wrong, scene);
    bench.write("scene.toml", &wrong);
    let wanted = "error: scene.toml: fits need a scene without errors; correct it first";
    refused(&bench, "data.csv --free hardness", wanted);
}

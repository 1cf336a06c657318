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
        ("load_N,area_percent", "\"area_percent\" is not known (the nearest is \"area_fraction\")"),
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
    let comment = "data.csv:2: comment is \"first\": a number, or a table without this column (no fit reads it) was required";
    refused(&bench, "data.csv --free hardness", comment);
    bench.write("data.csv", AREAS);
    for (symbol, key) in
        [("H", "hardness"), ("E", "youngs_modulus"), ("sigma", "asperity_height_std")]
    {
        let wanted = format!("{symbol} is not an input of this scene (the nearest is \"{key}\")");
        refused(&bench, &format!("data.csv --free {symbol}"), &wanted);
    }
    let run = bench.run("fit scene.toml data.csv --free hardness=2GPa");
    let one = "\"2GPa\" is one value: write hardness=low:high for bounds, or hardness alone";
    assert!(run.code == Some(2) && run.messages.contains(one), "{}", run.messages);
}

//! Every row of a table of reference solutions beside this solver.
//!
//! ```sh
//! cargo run --release -p asperity-bem --example against_reference -- bem.csv syn_a8=syn_a8_512.npy m3_lp8=m3_lp8_256.npy
//! ```

use std::collections::HashMap;
use std::error::Error;
use std::fs;
use std::time::Instant;

use asperity_bem::{BoundaryElements, Given, HeightMap};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let table = fs::read_to_string(arguments.next().ok_or("a table was required")?)?;
    let mut maps = HashMap::new();
    for argument in arguments {
        let (id, path) = argument.split_once('=').ok_or("ID=FILE.npy was required")?;
        let file = npyz::NpyFile::new(std::io::BufReader::new(fs::File::open(path)?))?;
        let shape = [file.shape()[0] as usize, file.shape()[1] as usize];
        let heights: Vec<f64> = file.into_vec()?;
        let map = HeightMap::new(heights, shape, [1.0 / shape[0] as f64, 1.0 / shape[1] as f64])?;
        maps.insert(id.to_owned(), map);
    }
    let mut lines = table.lines();
    let head: Vec<&str> = lines.next().ok_or("an empty table")?.split(',').collect();
    println!("surface psi p/Eg | pixels area plastic gap open | iterations patches | ms");
    for line in lines {
        let row: HashMap<&str, &str> = head.iter().copied().zip(line.split(',')).collect();
        let number = |key: &str| row[key].parse::<f64>();
        let Some(map) = maps.get(row["surface_id"]) else { continue };
        let mut solver = BoundaryElements::new(map.clone(), 1.0)?;
        if let Ok(hardness) = number("H_over_E") {
            solver = solver.hardness(hardness)?;
        }
        let start = Instant::now();
        let solution = solver.solve(Given::MeanPressure(number("p_over_E")?))?;
        let ms = start.elapsed().as_secs_f64() * 1e3;
        let count = map.heights().len() as f64;
        println!(
            "{} {:7} {:>2} {:>6} | {:3} {:+.1e} {:+.1e} {:+.1e} {:+.1e} | {:3} {:>4} {:3} {:>3} | {ms:.0}",
            &row["code"][..5],
            row["surface_id"],
            row["psi"],
            row["p_over_Eg"],
            ((solution.pixel_area - number("area_pix")?) * count).round(),
            solution.area / number("area_corr")? - 1.0,
            solution.plastic_area / number("plastic_area")? - 1.0,
            solution.mean_gap / number("mean_gap")? - 1.0,
            solution.mean_open_gap / number("mean_gap_pos")? - 1.0,
            solution.iterations,
            row["iterations"],
            solution.patches.len(),
            row["patches"],
        );
    }
    Ok(())
}

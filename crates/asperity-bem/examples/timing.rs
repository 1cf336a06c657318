//! Seconds and iterations of contacts that are each started cold, and seconds of the flow through
//! each gap along x and y.
//!
//! ```sh
//! cargo run --release -p asperity-bem --example timing -- heights.npy 1e-3 1e-2 [hardness=0.5] [free]
//! ```
//!
//! Heights, 64-bit numbers by rows, in units of the side of the square; mean pressures and hardness
//! in equivalent moduli.

use std::error::Error;
use std::time::Instant;

use asperity_bem::{Boundary, BoundaryElements, Direction, HeightMap, LoadCase};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().ok_or("heights.npy and pressures were required")?;
    let bytes = std::fs::read(path)?;
    // Version 1, behind a head of this length.
    let head = bytes.get(8).map_or(0, |length| 10 + usize::from(*length));
    let numbers = bytes.get(head..).unwrap_or_default().chunks_exact(8);
    let heights: Vec<f64> = numbers
        .map(|bytes| Ok(f64::from_le_bytes(bytes.try_into()?)))
        .collect::<Result<_, Box<dyn Error>>>()?;
    let side = heights.len().isqrt();
    let map = HeightMap::new(heights, [side, side], [1.0 / side as f64; 2])?;
    let mut solver = BoundaryElements::new(map, 1.0)?;
    let mut pressures = Vec::new();
    for argument in arguments {
        if argument == "free" {
            solver = solver.boundary(Boundary::Free);
        } else if let Some(hardness) = argument.strip_prefix("hardness=") {
            solver = solver.hardness(hardness.parse()?)?;
        } else {
            pressures.push(argument.parse::<f64>()?);
        }
    }
    for pressure in pressures {
        let start = Instant::now();
        let solution = solver.solve(LoadCase::MeanPressure(pressure))?;
        let seconds = start.elapsed().as_secs_f64();
        let start = Instant::now();
        for direction in Direction::ALL {
            solver.hydraulic_gap(&solution, direction)?;
        }
        let flows = start.elapsed().as_secs_f64();
        let (iterations, area) = (solution.iterations, solution.pixel_area);
        println!("{pressure:e} {seconds:.4} {iterations} {area} {flows:.4}");
    }
    Ok(())
}

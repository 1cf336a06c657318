//! Seconds and iterations of contacts that are each started cold, and seconds of the flow through
//! each gap along x and y: medians of some runs.
//!
//! ```sh
//! cargo run --release -p asperity-bem --example timing -- heights.npy 1e-3 1e-2 [hardness=0.5] [free] [runs=7]
//! ```
//!
//! Heights, 64-bit numbers by rows, in units of the side of the square, or a number of pixels per
//! side for a random surface of rms gradient 0.1; mean pressures and hardness in equivalent moduli.

use std::error::Error;
use std::time::Instant;

use asperity_bem::{Boundary, BoundaryElements, HeightMap, LoadCase, RandomSurface};
use asperity_core::Quantity;

const BOTH: [Quantity; 2] = [Quantity::HydraulicGapX, Quantity::HydraulicGapY];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let surface = arguments.next().ok_or("heights.npy or pixels, and pressures were required")?;
    let map = match surface.parse() {
        Ok(side) => random(side)?,
        Err(_) => read(&surface)?,
    };
    let mut solver = BoundaryElements::new(map, 1.0)?;
    let (mut pressures, mut runs) = (Vec::new(), 1);
    for argument in arguments {
        if argument == "free" {
            solver = solver.boundary(Boundary::Free);
        } else if let Some(hardness) = argument.strip_prefix("hardness=") {
            solver = solver.hardness(hardness.parse()?)?;
        } else if let Some(number) = argument.strip_prefix("runs=") {
            runs = number.parse::<usize>()?.max(1);
        } else {
            pressures.push(argument.parse::<f64>()?);
        }
    }
    println!("pressure  contact s  iterations  area  both flows s  flows/contact");
    for pressure in pressures {
        let (mut contacts, mut flows) = (vec![], vec![]);
        let mut solution = solver.solve(LoadCase::MeanPressure(pressure))?;
        for _ in 0..runs {
            let start = Instant::now();
            solution = solver.solve(LoadCase::MeanPressure(pressure))?;
            contacts.push(start.elapsed().as_secs_f64());
            let start = Instant::now();
            for (_, gap) in solver.summary(&solution, &BOTH).gaps {
                gap?;
            }
            flows.push(start.elapsed().as_secs_f64());
        }
        let [contact, flow] = [contacts, flows].map(median);
        let (iterations, area) = (solution.iterations, solution.pixel_area);
        println!("{pressure:e} {contact:.4} {iterations} {area} {flow:.4} {:.2}", flow / contact);
    }
    Ok(())
}

fn random(side: usize) -> Result<HeightMap, Box<dyn Error>> {
    let surface = RandomSurface::new(2.0, side as f64 / 32.0, side as f64 / 8.0)?;
    Ok(surface.gradient(0.1)?.side(1.0)?.seed(1).heights(side)?)
}

fn read(path: &str) -> Result<HeightMap, Box<dyn Error>> {
    let bytes = std::fs::read(path)?;
    // Version 1, behind a head of this length.
    let head = bytes.get(8).map_or(0, |length| 10 + usize::from(*length));
    let numbers = bytes.get(head..).unwrap_or_default().chunks_exact(8);
    let heights: Vec<f64> = numbers
        .map(|bytes| Ok(f64::from_le_bytes(bytes.try_into()?)))
        .collect::<Result<_, Box<dyn Error>>>()?;
    let side = heights.len().isqrt();
    Ok(HeightMap::new(heights, [side, side], [1.0 / side as f64; 2])?)
}

fn median(mut seconds: Vec<f64>) -> f64 {
    seconds.sort_by(f64::total_cmp);
    seconds[seconds.len() / 2]
}

//! A desk on standard input, as fast as this machine allows: the page's messages line by line, or
//! `press` and a mean pressure \[Pa\]; each answer follows the seconds that it took.

use std::io::{BufRead, Write};
use std::time::Instant;

use asperity_web::Desk;

fn main() -> std::io::Result<()> {
    let mut desk = Desk::default();
    let mut out = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines() {
        let line = line?;
        let start = Instant::now();
        let answer = match line.strip_prefix("press ").map(str::parse) {
            None => desk.call(&line),
            Some(Ok(pressure)) => desk.press(&[pressure], false, |_| {}),
            Some(Err(error)) => return Err(std::io::Error::other(error)),
        };
        let seconds = start.elapsed().as_secs_f64();
        writeln!(out, "{{\"seconds\":{seconds},\"answer\":{answer}}}")?;
    }
    Ok(())
}

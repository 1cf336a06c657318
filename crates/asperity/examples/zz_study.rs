use asperity::*;
use std::time::Instant;
fn scene(name: &str) -> Scene {
    let table = include_str!("../../../tests/reference/models_scenes.csv");
    let row = table.lines().find(|line| line.starts_with(&format!("{name},"))).unwrap();
    let n: Vec<f64> = row.split(',').skip(1).map(|f| f.parse::<f64>().unwrap()).collect();
    let mut i = Interface::new(n[0], n[2], n[3]); i.equivalent_shear_modulus = Some(n[1]); i.pressure_factor = Some(n[4]);
    Scene::new(i, Surface::new(n[5], n[6], n[7]), n[8])
}
fn main() {
    let table = include_str!("../../../tests/reference/models.csv");
    for tol in [1e-12, 1e-8, 1e-4] {
    for id in ["ke", "jg", "gao", "at", "at-additive", "at-overlap"] {
        let model: Model = id.parse().unwrap();
        for q in [Quantity::Force, Quantity::Area, Quantity::Stiffness] {
            let mut worst = 0.0f64; let mut ms = vec![];
            for case in ["at-paper", "mild", "severe"] {
                let sc = scene(case);
                let req = Request::new([q]).within(Tolerance::new(tol).unwrap());
                let t = Instant::now();
                let c = model.compile(&sc, &req).unwrap();
                for s in linspace(-2.0, 6.0, 9) { c.evaluate(q, s).unwrap(); }
                ms.push(t.elapsed().as_secs_f64() * 1e3);
                for line in table.lines().skip(1) {
                    let f: Vec<&str> = line.split(',').collect();
                    if f[0] != case || f[1] != id || f[3] != q.to_string() { continue }
                    let v: f64 = f[4].parse().unwrap();
                    let e = c.evaluate(q, f[2].parse().unwrap()).unwrap();
                    let err = (e.value() - v).abs() / (v.abs() * e.size / e.scaled.abs());
                    worst = worst.max(err);
                }
            }
            println!("tol {tol:e} {id} {q}: worst {worst:.1e}; build ms {:.1} {:.1} {:.1}", ms[0], ms[1], ms[2]);
        }
    }}
}

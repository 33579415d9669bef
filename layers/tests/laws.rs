//! The laws of `conformance` put to the layers that ship.
use recede_layers::*;

#[test]
fn table() {
    let mut n = 0;
    let t = std::time::Instant::now();
    for plane in [Plane::Strain, Plane::Stress] {
        let mut list: Vec<Box<dyn Layer>> = vec![];
        for nu in [-0.9, -0.5, 0.0, 0.25, 0.45, 0.5] {
            list.push(Box::new(Homogeneous::new(2.0, 3.0, nu).unwrap()));
            list.push(Box::new(HalfPlane::new(3.0, nu).unwrap()));
            for b in [1e-300, 1e-12, 1e-6, 1e-3, 0.5, 1.0, 4.0, 8.0, 30.0] {
                for s in [1.0, -1.0] {
                    list.push(Box::new(Exponential::new(2.0, 3.0, nu, 0.5 * s * b).unwrap()));
                }
            }
        }
        for layer in &list {
            n += 1;
            if let Err(v) = conformance::examine(&**layer, plane) {
                println!("{:?}", layer.notation().parameters);
                for v in v { println!("    {v}"); }
            }
        }
    }
    println!("{n} {:?}", t.elapsed());
}

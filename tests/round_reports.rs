//! Axisymmetric problems: what is read and written of them.
use recede::selftest::Check;
use recede::{Geometry, Model, Options, Scene};

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} {expected}");
}

#[test]
fn rows_of_sweeps_are_single_solutions() {
    let scene = Scene::read("examples/axisymmetric/sphere_on_layer.ron").unwrap();
    let axes = ["punch.radius=[3,5]", "force=[10,20]"].map(|axis| axis.parse().unwrap()).to_vec();
    let sweep = recede::Sweep::new(scene, axes).unwrap().with_approach().with_extremes();
    let columns = recede::report::SweepCsv::new(&sweep).header().unwrap();
    assert!(columns.contains(",approach,") && columns.contains("_von_mises"), "{columns}");
    for row in sweep.rows() {
        let scene = sweep.scene_at(row.index).unwrap();
        let model = Model::new(scene.stack().unwrap()).unwrap();
        let alone = model.press(&scene.punch, scene.force).unwrap();
        let solution = row.result.unwrap();
        close(solution.contacts()[0].reach(), alone.contacts()[0].reach(), 1e-10);
        let approach = model.approach(&scene.punch, &alone).unwrap().value;
        close(row.approach.unwrap().unwrap().value, approach, 1e-9);
        let [found, expected] = [row.extremes.unwrap().unwrap(), model.field(&alone).unwrap().extremes().unwrap()];
        close(found.layers[0].von_mises.unwrap().value, expected.layers[0].von_mises.unwrap().value, 1e-8);
    }
}

#[test]
fn maps_are_symmetric_about_the_axis() {
    let scene = Scene::read("examples/axisymmetric/sphere_on_layer.ron").unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.punch, scene.force).unwrap();
    let field = model.field(&solution).unwrap();
    let (xs, depths) = ([-2.0, -0.7, 0.0, 0.7, 2.0], [0.0, 0.5, 1.0]);
    let grids = field.by_layer(&xs, &depths).unwrap();
    for grid in &grids {
        for row in grid.rows() {
            for (left, right) in row.iter().zip(row.iter().rev()) {
                assert_eq!((left.x, left.sigma_xx, left.sigma_yy), (-right.x, right.sigma_xx, right.sigma_yy));
                assert_eq!((left.sigma_zz, left.v), (right.sigma_zz, right.v));
                assert_eq!((left.sigma_xy, left.u), (-right.sigma_xy, -right.u));
            }
        }
    }
    let map = |quantity| recede::plot::map(&scene, &solution, &field, &grids, quantity).unwrap().svg();
    let [along, about] = [recede::FieldQuantity::SigmaXx, recede::FieldQuantity::SigmaZz].map(map);
    assert!(along.starts_with("<svg") && along != about);
}

/// Displacements of faces have the names and signs of fields.
#[test]
fn profiles_are_in_cylindrical_coordinates() {
    let scene = Scene::read("examples/axisymmetric/sphere_on_layer.ron").unwrap();
    let model = Model::new(scene.stack().unwrap()).unwrap();
    let solution = model.press(&scene.punch, scene.force).unwrap();
    let profile = model.profile(&scene.punch, &solution, &[0.0]).unwrap();
    let mut text = Vec::new();
    recede::report::write_profile(&profile, &mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    let [header, numbers] = [0, 1].map(|line| text.lines().nth(line).unwrap().split(',').collect::<Vec<_>>());
    let column = header.iter().position(|name| *name == "layer_1_top_u_z").unwrap();
    let sunk = model.approach(&scene.punch, &solution).unwrap().value;
    close(numbers[column].parse().unwrap(), sunk, 1e-8);
}

#[test]
fn scenes_are_read_and_written() {
    let entries = std::fs::read_dir("examples/axisymmetric").unwrap();
    let mut scenes = 0;
    for path in entries.map(|entry| entry.unwrap().path()).filter(|path| path.extension().is_some_and(|e| e == "ron")) {
        let scene = Scene::read(&path).unwrap();
        assert_eq!(scene.geometry, Geometry::Axisymmetric);
        let again = Scene::from_ron(&scene.to_ron()).unwrap();
        assert_eq!((again.punch.clone(), again.force), (scene.punch.clone(), scene.force), "{}", path.display());
        let outcome = Check::run(&scene, &Options::default(), true).outcome;
        assert!(outcome.solution().is_some(), "{}: {}", path.display(), outcome.reason());
        let json = Scene::from_json(&scene.to_json()).unwrap();
        assert_eq!(json.punch, scene.punch);
        scenes += 1;
    }
    assert!(scenes >= 2);
}

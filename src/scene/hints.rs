//! What to write in place of words that are not those of a scene.

/// Words that mean something of a scene under another name, with the names that it may have there.
const OTHER_NAMES: &[(&[&str], &[&str])] = &[
    (&["E", "Young", "youngs_modulus", "young_modulus", "elastic_modulus", "modulus", "stiffness"], &["young"]),
    (&["nu", "ν", "v", "poisson_ratio", "poissons_ratio"], &["poisson"]),
    (&["G", "mu", "μ", "shear"], &["shear_modulus"]),
    (&["h", "t", "d", "height", "depth"], &["thickness"]),
    (&["R", "r", "curvature"], &["radius"]),
    (&["diameter"], &["radius"]),
    (&["P", "F", "Q", "load"], &["force"]),
    (&["a", "b", "c", "width", "half_length"], &["half_width"]),
    (&["a", "contact_length", "contact_width"], &["half_length"]),
    (&["indentation", "approach", "displacement", "delta"], &["depth"]),
    (&["pressure", "traction"], &["load"]),
    (&["angle", "tangent"], &["slope"]),
    (&["indenter", "roller", "wheel", "tool"], &["punch"]),
    (&["layers", "items"], &["stack"]),
    (&["k", "kn", "normal_stiffness"], &["stiffness", "normal"]),
    (&["kt", "shear_stiffness", "tangential_stiffness"], &["shear_stiffness", "tangential"]),
    (&["m", "n", "power"], &["exponent"]),
    (&["Elastic", "Isotropic", "Layer", "Strip", "Film", "Coating"], &["Homogeneous"]),
    (&["FGM", "FunctionallyGraded", "Gradient"], &["Exponential", "Graded"]),
    (&["Ply", "Laminate", "Composite", "Anisotropic"], &["Orthotropic"]),
    (&["HalfSpace", "Foundation", "Substrate", "Ground", "Soil", "Base"], &["HalfPlane"]),
    (&["Tied", "Glued", "Welded", "Perfect", "Fixed", "Stick", "Continuous"], &["Bonded"]),
    (&["Frictionless", "Contact", "Unilateral", "Loose", "Resting", "Open", "Unbonded"], &["Receding"]),
    (&["Slip", "Smooth", "Slide"], &["Sliding"]),
    (&["Springs", "Elastic", "Interlayer"], &["Spring", "Winkler"]),
    (&["Fixed", "Wall", "Floor"], &["Rigid"]),
    (&["Roller", "Wheel", "Circle"], &["Cylinder", "ElasticCylinder"]),
    (&["Cylinder", "Ball", "Hemisphere", "Circle"], &["Sphere"]),
    (&["ElasticCylinder", "ElasticBall"], &["ElasticSphere"]),
    (&["Wedge", "Cone"], &["Cone", "Wedge"]),
    (&["Line", "Concentrated"], &["Point"]),
    (&["Annulus", "Annular"], &["Ring"]),
    (&["Ring"], &["Several"]),
    (&["half_width", "halfwidth"], &["radius"]),
    (&["radius"], &["half_width"]),
    (&["Knife", "Vee"], &["Wedge"]),
    (&["Block", "Plate", "Stamp", "Rectangle"], &["Flat"]),
    (&["Point", "Concentrated"], &["Line"]),
    (&["Constant", "Rectangular", "Block"], &["Uniform"]),
    (&["Hertz", "Hertzian"], &["Elliptic"]),
    (&["Strain", "strain", "plane_strain"], &["PlaneStrain"]),
    (&["Stress", "stress", "plane_stress"], &["PlaneStress"]),
    (&["Round", "Axial", "Rotational", "Circular"], &["Axisymmetric"]),
];

/// What a scene cannot say, with what there is in its place.
const NOT_SUPPORTED: &[(&[&str], &str)] = &[
    (
        &["friction", "friction_coefficient", "coefficient_of_friction", "cof", "Friction", "Coulomb", "Stiction"],
        "friction is not supported: contacts are without it, `Bonded` does not slide at all",
    ),
    (
        &["Sphere", "Ball", "Hemisphere", "ElasticSphere"],
        "for a sphere write `geometry: Axisymmetric`; in a plane problem all that presses is as long as the stack out of the plane",
    ),
    (
        &["Ellipsoid", "Torus", "Several"],
        "this is not supported: punches are the same along a line or about an axis, and what presses about an axis is one disc or one ring",
    ),
    (&["plane"], "write `geometry: PlaneStrain`, or `geometry: PlaneStress` for `plane: Stress`"),
    (
        &["adhesion", "work_of_adhesion", "surface_energy", "Adhesive"],
        "adhesion is not supported: what is not bonded does not stick",
    ),
    (&["density", "gravity", "own_weight", "weight"], "own weight is not supported: layers have none"),
    (
        &["gap", "clearance", "initial_gap"],
        "initial gaps are not supported: layers rest on each other before they are loaded",
    ),
    (
        &["tilt", "moment", "angle", "offset"],
        "punches that tilt or lie off the middle are not supported: they are symmetric about the middle, x = 0",
    ),
    (&["plastic", "yield", "yield_stress", "hardness"], "plasticity is not supported: materials are linear elastic"),
    (&["viscosity", "relaxation", "creep", "damping"], "time is not supported: materials are linear elastic"),
    (&["temperature", "thermal_expansion"], "temperature is not supported"),
];

/// Units that are written behind numbers.
const UNITS: &[&str] = &[
    "m", "cm", "mm", "um", "µm", "μm", "nm", "in", "ft", "Pa", "hPa", "kPa", "MPa", "GPa", "bar", "psi", "ksi", "N",
    "mN", "kN", "MN", "lbf",
];

/// What to do about a name that is none of those allowed: another name for the same, that it is not supported, or the
/// nearest of the allowed names.
pub(super) fn instead_of(found: &str, allowed: &[&str]) -> Option<String> {
    // of one letter, case tells: E is not e, R is not r
    let same = |word: &&str| *word == found || found.chars().count() > 1 && word.eq_ignore_ascii_case(found);
    let names: Vec<&str> = OTHER_NAMES
        .iter()
        .filter(|(words, _)| words.iter().any(same))
        .flat_map(|(_, names)| names.iter().copied())
        .filter(|name| allowed.contains(name))
        .collect();
    if !names.is_empty() {
        let how = match &found.to_lowercase()[..] {
            "diameter" | "width" => ", which is half of it",
            "angle" => ", which is its tangent",
            _ => "",
        };
        let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        return Some(format!("write {}{how}", names.join(" or ")));
    }
    let not_supported = NOT_SUPPORTED.iter().find(|(words, _)| words.iter().any(same));
    not_supported.map(|(_, why)| (*why).to_owned()).or_else(|| did_you_mean(found, allowed))
}

/// The nearest of the allowed names, if it is near.
pub(super) fn did_you_mean(found: &str, allowed: &[&str]) -> Option<String> {
    let likeness = |name: &str| strsim::jaro_winkler(&found.to_lowercase(), &name.to_lowercase());
    let (likeness, name) = allowed.iter().map(|name| (likeness(name), name)).max_by(|a, b| a.0.total_cmp(&b.0))?;
    (likeness > 0.75).then(|| format!("did you mean `{name}`?"))
}

/// Whether a word is a unit, such as one that follows a number.
pub(super) fn is_unit(word: &str) -> bool {
    UNITS.contains(&word.split(['/', '^', '*']).next().unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_others_are_understood_and_never_taken_for_lookalikes() {
        let layer = ["thickness", "shear_modulus", "young", "poisson"];
        let punches = ["Cylinder", "Parabola", "Flat", "ElasticCylinder", "Wedge"];
        for (found, allowed, hint) in [
            ("E", &layer[..], Some("write `young`")),
            ("nu", &layer, Some("write `poisson`")),
            (
                "friction",
                &layer,
                Some("friction is not supported: contacts are without it, `Bonded` does not slide at all"),
            ),
            ("thikness", &layer, Some("did you mean `thickness`?")),
            ("roller", &punches, Some("write `Cylinder` or `ElasticCylinder`")),
            ("diameter", &["radius"], Some("write `radius`, which is half of it")),
            ("zzz", &layer, None),
        ] {
            assert_eq!(instead_of(found, allowed).as_deref(), hint, "{found}");
        }
        assert!(instead_of("Sphere", &punches).unwrap_or_default().contains("Axisymmetric"));
        assert!(is_unit("GPa") && is_unit("N/mm^2") && !is_unit("Receding"));
    }
}

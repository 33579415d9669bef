//! Hints for words that scenes do not know: the word to write in their place.
//!
//! Tables have one row for words that mean the same, with what to say about them behind an arrow.

/// Words that mean something of a scene under another name: the names that it may have there, and how the number differs.
const OTHER_NAMES: &str = r#"
E Young youngs_modulus young_modulus elastic_modulus modulus stiffness => young
nu ν v poisson_ratio poissons_ratio => poisson
G mu μ shear => shear_modulus
Gxy G_xy G12 => shear_modulus
Ex E_x E1 r => x
Ey E_y => y
Ez E_z => z
nu_xy nuxy ν_xy => xy
yx nu_yx => xy, which is yx · young.x / young.y
nu_xz nuxz ν_xz => xz
zx nu_zx => xz, which is zx · young.x / young.z
nu_yz nuyz ν_yz => yz
zy nu_zy => yz, which is zy · young.y / young.z
h t d height depth => thickness
R r curvature => radius
diameter => radius, which is half of it
mean_radius middle => radius
inner_radius outer_radius inner outer r_inner r_outer ri ro => radius half_width: this is a disc; a pressure on a ring is `Ring(radius: ..., half_width: ...)`
P F Q load => force
x x0 place position location offset centre center => at
e offset lever lever_arm arm => eccentricity
angle rotation inclination => tilt
punch profile indenter roller => shape
a b c half_length => half_width
width thickness => half_width, which is half of it
a contact_length contact_width => half_length
indentation approach displacement delta => depth
pressure traction => load
tangent => slope
right right_slope slope_right => slope
left_slope slope_left left_face second_slope => left
angle inclination => slope half_angle: the tangent of the angle with the stack, or the angle with the axis, such as `"70.3 deg"`
semi_angle semi_vertical_angle half_apex_angle half_opening_angle => half_angle
apex_angle opening_angle included_angle => half_angle, which is half of it
indenter roller wheel tool => punch
indenters rollers wheels tools => punches
layers items => stack
k kn normal_stiffness => stiffness normal
kt shear_stiffness tangential_stiffness => shear_stiffness tangential
m n power => exponent
Elastic Isotropic Layer Strip Film Coating => Homogeneous
FGM FunctionallyGraded Gradient => Exponential Graded
Ply Laminate Composite Anisotropic TransverselyIsotropic => Orthotropic
HalfSpace Foundation Substrate Ground Soil Base => HalfPlane
Tied Glued Welded Perfect Fixed Stick Continuous => Bonded
Frictionless Contact Unilateral Loose Resting Open Unbonded => Receding
Slip Smooth Slide => Sliding
Springs Elastic Interlayer => Spring Winkler
Fixed Wall Floor => Rigid
Angle Turned Rotated Prescribed => Fixed
Loose Hinged Pivoted Eccentric => Free
Roller Wheel Circle => Cylinder ElasticCylinder
Cylinder Ball Hemisphere Circle => Sphere
ElasticCylinder ElasticBall => ElasticSphere
Wedge Cone => Cone Wedge
Line Concentrated => Point
Annulus Annular => Ring
Disc Disk Circle => Uniform
Berkovich Vickers Pyramid => Cone, of the same area at any depth: `half_angle: "70.3 deg"`
half_width halfwidth => radius
radius => half_width
Knife Vee => Wedge
Block Plate Stamp Rectangle => Flat
Point Concentrated => Line
Constant Rectangular Block => Uniform
Hertz Hertzian => Elliptic
Strain strain plane_strain => PlaneStrain
Stress stress plane_stress => PlaneStress
Round Axial Rotational Circular => Axisymmetric
"#;

/// Words for features that are not supported, each with its alternative.
const NOT_SUPPORTED: &str = r#"
friction friction_coefficient coefficient_of_friction cof Friction Coulomb Stiction => friction is not supported: contacts are without it, `Bonded` does not slide at all
Sphere Ball Hemisphere ElasticSphere => for a sphere write `geometry: Axisymmetric`; in a plane problem all that presses is as long as the stack out of the plane
Ellipsoid Torus => this is not supported: punches are the same along a line or about an axis, and what presses about an axis is one disc or one ring
Berkovich Vickers Pyramid => pyramids are not supported: in their place, write `geometry: Axisymmetric` and `Cone(half_angle: "70.3 deg")`
Ring Annulus Annular Tube => punches with a hole are not supported: a pressure on a ring is `load: Ring(...)` with `geometry: Axisymmetric`
thickness => only layers have a thickness: a half-plane reaches down without end
plane => write `geometry: PlaneStrain`, or `geometry: PlaneStress` for `plane: Stress`
adhesion work_of_adhesion surface_energy Adhesive => adhesion is not supported: what is not bonded does not stick
density gravity own_weight weight => own weight is not supported: layers have none
gap clearance initial_gap => initial gaps are not supported: layers rest on each other before they are loaded
tilt moment angle rotation offset eccentricity at => a punch that is turned, or whose tip is not at x = 0, is one of `punches: [(shape: ..., at: ..., force: ..., tilt: ...)]` in a plane scene
depth half_length => `depth` and `half_length` are for one `punch: ...` only, and stand beside it in the scene: each of several punches has its `force`
plastic yield yield_stress hardness => plasticity is not supported: materials are linear elastic
viscosity relaxation creep damping => time is not supported: materials are linear elastic
temperature thermal_expansion => temperature is not supported
"#;

/// Numbers of an orthotropic material for one direction each, with the field in which all of them stand.
const DIRECTIONS: &str = "
Ex Ey Ez E_x E_y E_z E1 E2 E3 young_x young_y young_z => young
nu_xy nu_xz nu_yz nuxy nuxz nuyz ν_xy ν_xz ν_yz nu12 nu13 nu23 poisson_xy poisson_xz poisson_yz => poisson
";

/// The texts behind the arrow in the rows of a table that have this word.
fn rows(table: &'static str, found: &str) -> impl Iterator<Item = &'static str> {
    // of one letter, case tells: E is not e, R is not r
    let same = move |word: &str| word == found || found.chars().count() > 1 && word.eq_ignore_ascii_case(found);
    let rows = table.lines().filter_map(|row| row.split_once(" => "));
    rows.filter(move |(words, _)| words.split(' ').any(same)).map(|(_, meaning)| meaning)
}

/// The field in which a number for one direction belongs.
pub(super) fn directions(found: &str, allowed: &[&str]) -> Option<&'static str> {
    rows(DIRECTIONS, found).find(|field| allowed.contains(field))
}

/// The hint for one number where an orthotropic material has several, or the other way round.
pub(super) fn number_of_material(field: &str, several: bool) -> Option<&'static str> {
    Some(match (field, several) {
        ("young" | "poisson", true) => "one number is enough for `Homogeneous` and `HalfPlane`",
        ("young" | "poisson", false) => {
            "it is one number here; `Orthotropic` and `OrthotropicHalfPlane` have one for each direction"
        }
        ("shear_modulus", false) => "it is one number, of an orthotropic material G_xy",
        _ => return None,
    })
}

/// What to do about a name that is none of those allowed: another name for the same, that it is not supported, or the
/// nearest of the allowed names.
pub(super) fn instead_of(found: &str, allowed: &[&str]) -> Option<String> {
    let (mut names, mut how) = (Vec::new(), "");
    for row in rows(OTHER_NAMES, found) {
        let (own, difference) = row.split_at(row.find([',', ':']).unwrap_or(row.len()));
        let own: Vec<&str> = own.split(' ').filter(|name| allowed.contains(name)).collect();
        how = if own.is_empty() { how } else { difference };
        names.extend(own);
    }
    if names.is_empty() {
        let not_supported = rows(NOT_SUPPORTED, found).next().map(str::to_owned);
        return not_supported.or_else(|| did_you_mean(found, allowed));
    }
    let between = if names == ["radius", "half_width"] {
        how = ", half the sum and half the difference of the outer and the inner radius";
        "` and `"
    } else {
        "` or `"
    };
    Some(format!("write `{}`{how}", names.join(between)))
}

/// The hint for a field that has one of a few names.
pub(super) fn names_of(field: &str) -> Option<&'static str> {
    (field == "tilt").then_some("write `Fixed(angle)`, with a small angle in radians, or `Free(eccentricity: ...)`")
}

/// The nearest of the allowed names, if it is near.
pub(super) fn did_you_mean(found: &str, allowed: &[&str]) -> Option<String> {
    let likeness = |name: &str| strsim::jaro_winkler(&found.to_lowercase(), &name.to_lowercase());
    let (likeness, name) = allowed.iter().map(|name| (likeness(name), name)).max_by(|a, b| a.0.total_cmp(&b.0))?;
    (likeness > 0.75).then(|| format!("did you mean `{name}`?"))
}

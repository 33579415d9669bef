"""Layers, interfaces, bases, punches and loads.

Numbers may be texts with a unit, such as '26 GPa', where the scene names its units.

Written by make_items.py from the JSON Schema of scenes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from ._items import Load, Profile, Punch, StackItem
from ._values import Number, Row, Rows


class OrthotropicYoung(NamedTuple):
    """Young's moduli.

    Args:
        x: E_x, in stress. Allowed: a finite number > 0.
        y: E_y, in stress. Allowed: a finite number > 0.
        z: E_z, in stress; it matters in plane strain only. Allowed: a finite number > 0.
    """

    x: float | str
    y: float | str
    z: float | str


class OrthotropicPoisson(NamedTuple):
    """Poisson's ratios.

    Args:
        xy: ν_xy, dimensionless. Allowed: a finite number.
        xz: ν_xz, dimensionless; it matters in plane strain only. Allowed: a finite number.
        yz: ν_yz, dimensionless; it matters in plane strain only. Allowed: a finite number.
    """

    xy: float | str
    xz: float | str
    yz: float | str


class Homogeneous(StackItem):
    """One isotropic material through the thickness.

    Args:
        thickness: Thickness h, in length. Allowed: a finite number >= 0 (0 means: not there).
        poisson: Poisson's ratio ν, dimensionless. Allowed: -1 < poisson <= 0.5.
        shear_modulus: Shear modulus μ, in stress; or in its place `young`. Allowed: a finite number > 0.
        young: Young's modulus E, in stress; or in its place `shear_modulus`. Allowed: a finite number > 0.
        name: A name by which reports and pictures call the layer. Allowed: a text of 1 to 40 characters in one line
            that is no number.
        eigenstrain: The strain that the layer would have in all directions if nothing held it; 0 if it is not given.
            Allowed: a finite number.
        specific_weight: The weight of the layer, force per volume, by which it presses on what lies below; 0 if it is
            not given. Allowed: a finite number >= 0.
    """

    __slots__ = ("thickness", "poisson", "shear_modulus", "young", "name", "eigenstrain", "specific_weight")
    thickness: float | str
    poisson: float | str
    shear_modulus: float | str | None
    young: float | str | None
    name: str | None
    eigenstrain: float | str | None
    specific_weight: float | str | None

    def __init__(
        self,
        *,
        thickness: Number,
        poisson: Number,
        shear_modulus: Number | None = None,
        young: Number | None = None,
        name: str | None = None,
        eigenstrain: Number | None = None,
        specific_weight: Number | None = None,
    ) -> None:
        self._set(
            thickness=thickness,
            poisson=poisson,
            shear_modulus=shear_modulus,
            young=young,
            name=name,
            eigenstrain=eigenstrain,
            specific_weight=specific_weight,
        )


class Exponential(StackItem):
    """Shear modulus varies as exp(beta d) with the depth d.

    Args:
        thickness: Thickness h, in length. Allowed: a finite number >= 0 (0 means: not there).
        poisson: Poisson's ratio ν, dimensionless. Allowed: -1 < poisson <= 0.5.
        beta: Grading exponent β, in 1/length: the modulus at depth d is that at the top face times exp(beta d).
            Allowed: a finite number.
        shear_modulus: Shear modulus μ at the top face, in stress; or in its place `young`. Allowed: a finite number >
            0.
        young: Young's modulus E at the top face, in stress; or in its place `shear_modulus`. Allowed: a finite number >
            0.
        name: A name by which reports and pictures call the layer. Allowed: a text of 1 to 40 characters in one line
            that is no number.
        eigenstrain: The strain that the layer would have in all directions if nothing held it; 0 if it is not given.
            Allowed: a finite number.
        specific_weight: The weight of the layer, force per volume, by which it presses on what lies below; 0 if it is
            not given. Allowed: a finite number >= 0.
    """

    __slots__ = ("thickness", "poisson", "beta", "shear_modulus", "young", "name", "eigenstrain", "specific_weight")
    thickness: float | str
    poisson: float | str
    beta: float | str
    shear_modulus: float | str | None
    young: float | str | None
    name: str | None
    eigenstrain: float | str | None
    specific_weight: float | str | None

    def __init__(
        self,
        *,
        thickness: Number,
        poisson: Number,
        beta: Number,
        shear_modulus: Number | None = None,
        young: Number | None = None,
        name: str | None = None,
        eigenstrain: Number | None = None,
        specific_weight: Number | None = None,
    ) -> None:
        self._set(
            thickness=thickness,
            poisson=poisson,
            beta=beta,
            shear_modulus=shear_modulus,
            young=young,
            name=name,
            eigenstrain=eigenstrain,
            specific_weight=specific_weight,
        )


class Graded(StackItem):
    """Shear modulus and Poisson's ratio vary in any way.

    Args:
        thickness: Thickness h, in length. Allowed: a finite number >= 0 (0 means: not there).
        shear_modulus: Shear modulus as a function of the depth d, in stress; or in its place `young`.
        young: Young's modulus as a function of the depth d, in stress; or in its place `shear_modulus`.
        poisson: Poisson's ratio, if it is the same at any depth. Allowed: -1 < poisson <= 0.5.
        poisson_profile: Poisson's ratio as a function of depth, in place of `poisson`.
        name: A name by which reports and pictures call the layer. Allowed: a text of 1 to 40 characters in one line
            that is no number.
        eigenstrain: The strain that the layer would have in all directions if nothing held it; 0 if it is not given.
            Allowed: a finite number.
        specific_weight: The weight of the layer, force per volume, by which it presses on what lies below; 0 if it is
            not given. Allowed: a finite number >= 0.
    """

    __slots__ = ("thickness", "shear_modulus", "young", "poisson", "poisson_profile", "name", "eigenstrain", "specific_weight")
    thickness: float | str
    shear_modulus: Profile | None
    young: Profile | None
    poisson: float | str | None
    poisson_profile: Profile | None
    name: str | None
    eigenstrain: float | str | None
    specific_weight: float | str | None

    def __init__(
        self,
        *,
        thickness: Number,
        shear_modulus: Profile | None = None,
        young: Profile | None = None,
        poisson: Number | None = None,
        poisson_profile: Profile | None = None,
        name: str | None = None,
        eigenstrain: Number | None = None,
        specific_weight: Number | None = None,
    ) -> None:
        self._set(
            thickness=thickness,
            shear_modulus=shear_modulus,
            young=young,
            poisson=poisson,
            poisson_profile=poisson_profile,
            name=name,
            eigenstrain=eigenstrain,
            specific_weight=specific_weight,
        )


class Orthotropic(StackItem):
    """One orthotropic material through the thickness.

    Args:
        thickness: Thickness h, in length. Allowed: a finite number >= 0 (0 means: not there).
        young: Young's moduli.
        poisson: Poisson's ratios.
        shear_modulus: Shear modulus G_xy, in stress. Allowed: a finite number > 0.
        name: A name by which reports and pictures call the layer. Allowed: a text of 1 to 40 characters in one line
            that is no number.
        eigenstrain: The strain that the layer would have in all directions if nothing held it; 0 if it is not given.
            Allowed: a finite number.
        specific_weight: The weight of the layer, force per volume, by which it presses on what lies below; 0 if it is
            not given. Allowed: a finite number >= 0.
    """

    __slots__ = ("thickness", "young", "poisson", "shear_modulus", "name", "eigenstrain", "specific_weight")
    thickness: float | str
    young: OrthotropicYoung
    poisson: OrthotropicPoisson
    shear_modulus: float | str
    name: str | None
    eigenstrain: float | str | None
    specific_weight: float | str | None

    def __init__(
        self,
        *,
        thickness: Number,
        young: OrthotropicYoung | tuple[Number, Number, Number] | Mapping[str, Number],
        poisson: OrthotropicPoisson | tuple[Number, Number, Number] | Mapping[str, Number],
        shear_modulus: Number,
        name: str | None = None,
        eigenstrain: Number | None = None,
        specific_weight: Number | None = None,
    ) -> None:
        self._set(
            thickness=thickness,
            young=young,
            poisson=poisson,
            shear_modulus=shear_modulus,
            name=name,
            eigenstrain=eigenstrain,
            specific_weight=specific_weight,
        )


class HalfPlane(StackItem):
    """One isotropic material, down to any depth.

    Args:
        poisson: Poisson's ratio ν, dimensionless. Allowed: -1 < poisson <= 0.5.
        shear_modulus: Shear modulus μ, in stress; or in its place `young`. Allowed: a finite number > 0.
        young: Young's modulus E, in stress; or in its place `shear_modulus`. Allowed: a finite number > 0.
        name: A name by which reports and pictures call the layer. Allowed: a text of 1 to 40 characters in one line
            that is no number.
    """

    __slots__ = ("poisson", "shear_modulus", "young", "name")
    poisson: float | str
    shear_modulus: float | str | None
    young: float | str | None
    name: str | None

    def __init__(
        self,
        *,
        poisson: Number,
        shear_modulus: Number | None = None,
        young: Number | None = None,
        name: str | None = None,
    ) -> None:
        self._set(poisson=poisson, shear_modulus=shear_modulus, young=young, name=name)


class GradedHalfPlane(StackItem):
    """Shear modulus grows as exp(beta d).

    Args:
        poisson: Poisson's ratio ν, dimensionless. Allowed: -1 < poisson <= 0.5.
        beta: Grading exponent β, in 1/length: the modulus at depth d is that at the face times exp(beta d). Allowed: a
            finite number >= 0 (a half-plane that softens without end carries no force).
        shear_modulus: Shear modulus μ at the face, in stress; or in its place `young`. Allowed: a finite number > 0.
        young: Young's modulus E at the face, in stress; or in its place `shear_modulus`. Allowed: a finite number > 0.
        name: A name by which reports and pictures call the layer. Allowed: a text of 1 to 40 characters in one line
            that is no number.
    """

    __slots__ = ("poisson", "beta", "shear_modulus", "young", "name")
    poisson: float | str
    beta: float | str
    shear_modulus: float | str | None
    young: float | str | None
    name: str | None

    def __init__(
        self,
        *,
        poisson: Number,
        beta: Number,
        shear_modulus: Number | None = None,
        young: Number | None = None,
        name: str | None = None,
    ) -> None:
        self._set(poisson=poisson, beta=beta, shear_modulus=shear_modulus, young=young, name=name)


class PowerHalfPlane(StackItem):
    """Shear modulus grows as (1 + d/length)^exponent.

    Args:
        poisson: Poisson's ratio ν, dimensionless. Allowed: -1 < poisson <= 0.5.
        length: Length l over which the modulus rises first, in length. Allowed: a finite number > 0.
        exponent: Exponent m, dimensionless: the modulus at depth d is that at the face times (1 + d/length)^m. Allowed:
            a finite number > -1 (a half-plane that softens faster carries no force).
        shear_modulus: Shear modulus μ at the face, in stress; or in its place `young`. Allowed: a finite number > 0.
        young: Young's modulus E at the face, in stress; or in its place `shear_modulus`. Allowed: a finite number > 0.
        name: A name by which reports and pictures call the layer. Allowed: a text of 1 to 40 characters in one line
            that is no number.
    """

    __slots__ = ("poisson", "length", "exponent", "shear_modulus", "young", "name")
    poisson: float | str
    length: float | str
    exponent: float | str
    shear_modulus: float | str | None
    young: float | str | None
    name: str | None

    def __init__(
        self,
        *,
        poisson: Number,
        length: Number,
        exponent: Number,
        shear_modulus: Number | None = None,
        young: Number | None = None,
        name: str | None = None,
    ) -> None:
        self._set(
            poisson=poisson,
            length=length,
            exponent=exponent,
            shear_modulus=shear_modulus,
            young=young,
            name=name,
        )


class OrthotropicHalfPlane(StackItem):
    """One orthotropic material.

    Args:
        young: Young's moduli.
        poisson: Poisson's ratios.
        shear_modulus: Shear modulus G_xy, in stress. Allowed: a finite number > 0.
        name: A name by which reports and pictures call the layer. Allowed: a text of 1 to 40 characters in one line
            that is no number.
    """

    __slots__ = ("young", "poisson", "shear_modulus", "name")
    young: OrthotropicYoung
    poisson: OrthotropicPoisson
    shear_modulus: float | str
    name: str | None

    def __init__(
        self,
        *,
        young: OrthotropicYoung | tuple[Number, Number, Number] | Mapping[str, Number],
        poisson: OrthotropicPoisson | tuple[Number, Number, Number] | Mapping[str, Number],
        shear_modulus: Number,
        name: str | None = None,
    ) -> None:
        self._set(young=young, poisson=poisson, shear_modulus=shear_modulus, name=name)


class Winkler(StackItem):
    """Springs on rigid ground; the layer above is to be bonded to them.

    Args:
        stiffness: Stiffness k, in stress/length. Allowed: a finite number > 0.
        shear_stiffness: Stiffness k_t along the face, in stress/length; without it, the layer slides freely. Allowed: a
            finite number > 0.
        name: A name by which reports and pictures call the layer. Allowed: a text of 1 to 40 characters in one line
            that is no number.
    """

    __slots__ = ("stiffness", "shear_stiffness", "name")
    stiffness: float | str
    shear_stiffness: float | str | None
    name: str | None

    def __init__(self, *, stiffness: Number, shear_stiffness: Number | None = None, name: str | None = None) -> None:
        self._set(stiffness=stiffness, shear_stiffness=shear_stiffness, name=name)


class Bonded(StackItem):
    """All displacements and stresses are continuous."""

    __slots__ = ()

    def __init__(self) -> None:
        self._set()


class Sliding(StackItem):
    """No friction, but no opening either: only v and σ_yy are continuous."""

    __slots__ = ()

    def __init__(self) -> None:
        self._set()


class Receding(StackItem):
    """No friction, no adhesion, free to open: where closed it transmits pressure only. Where layers are apart before
    they are loaded, `Receding(gap: ...)` with the shape of a punch.

    Args:
        gap: How far the layers are apart before they are loaded: a shape as of a punch.
    """

    __slots__ = ("gap",)
    gap: Punch | None

    def __init__(self, *, gap: Punch | None = None) -> None:
        self._set(gap=gap)


class Rigid(StackItem):
    """A rigid base, to which the layer above is joined or on which it lies loose."""

    __slots__ = ()

    def __init__(self) -> None:
        self._set()


class Spring(StackItem):
    """Springs that neither open nor slide freely: σ_yy = normal · [v], σ_xy = tangential · [u].

    Args:
        normal: Stress σ_yy per length by which the layers separate. Allowed: a finite number > 0.
        tangential: Stress σ_xy per length by which the layers slide on each other; none if it is not given. Allowed: a
            finite number > 0.
    """

    __slots__ = ("normal", "tangential")
    normal: float | str
    tangential: float | str | None

    def __init__(self, *, normal: Number, tangential: Number | None = None) -> None:
        self._set(normal=normal, tangential=tangential)


class Cylinder(Punch):
    """A circular cylinder, exactly: height R − √(R² − x²), slope x/√(R² − x²).

    Args:
        radius: Radius R, in length. Allowed: a finite number > 0.
    """

    __slots__ = ("radius",)
    _geometries = {"PlaneStrain": ("radius",)}
    radius: float | str

    def __init__(self, *, radius: Number) -> None:
        self._set(radius=radius)


class Parabola(Punch):
    """A parabola: height x²/(2R), slope x/R.

    Args:
        radius: Radius of curvature R at the tip, in length. Allowed: a finite number > 0.
    """

    __slots__ = ("radius",)
    _geometries = {"PlaneStrain": ("radius",), "Axisymmetric": ("radius",)}
    radius: float | str

    def __init__(self, *, radius: Number) -> None:
        self._set(radius=radius)


class Power(Punch):
    """A power of the distance from the tip: height (|x|/half_width)^exponent · height.

    Args:
        exponent: Exponent, 1 for a wedge, 2 for a parabola; dimensionless. Allowed: a number from 1 to 100.
        height: Height there above the tip, in length. Allowed: a finite number > 0.
        half_width: Where the height is given, in length. Allowed: a finite number > 0.
        radius: Where the height is given, in length. Allowed: a finite number > 0.
    """

    __slots__ = ("exponent", "height", "half_width", "radius")
    _geometries = {
        "PlaneStrain": ("exponent", "half_width", "height"),
        "Axisymmetric": ("exponent", "radius", "height"),
    }
    exponent: float | str
    height: float | str
    half_width: float | str | None
    radius: float | str | None

    def __init__(
        self,
        *,
        exponent: Number,
        height: Number,
        half_width: Number | None = None,
        radius: Number | None = None,
    ) -> None:
        self._set(exponent=exponent, height=height, half_width=half_width, radius=radius)


class Polynomial(Punch):
    """A polynomial in even powers: height h₁ s² + h₂ s⁴ + h₃ s⁶ + ..., s = x/half_width. If it falls in the end, the
    punch ends where that begins.

    Args:
        heights: h₁, h₂, h₃ and so on, in length. Allowed: [height, height, ...], one or more finite numbers that are
            not all 0.
        half_width: Where s is 1, in length. Allowed: a finite number > 0.
        radius: Where s is 1, in length. Allowed: a finite number > 0.
    """

    __slots__ = ("heights", "half_width", "radius")
    _geometries = {"PlaneStrain": ("half_width", "heights"), "Axisymmetric": ("radius", "heights")}
    heights: tuple[Row, ...]
    half_width: float | str | None
    radius: float | str | None

    def __init__(self, *, heights: Rows, half_width: Number | None = None, radius: Number | None = None) -> None:
        self._set(heights=heights, half_width=half_width, radius=radius)


class Wedge(Punch):
    """A wedge: height s |x|, s its slope or the cotangent of its half-angle, with another slope on the left if there is
    one. The pressure is infinite at the tip, like a logarithm.

    Args:
        slope: Slope s of its surface, dimensionless: the tangent of its angle with the stack; or in its place
            `half_angle`. Allowed: a finite number > 0.
        half_angle: Angle of its surface with the axis x = 0, half of the angle at the tip; or in its place `slope`, its
            cotangent. Allowed: an angle > 0 and < pi/2, in radians or with its unit, such as "70.3 deg".
        left: Slope of its surface on the left, x < 0, if that is not as steep as `slope` on the right; dimensionless.
            Allowed: a finite number > 0.
    """

    __slots__ = ("slope", "half_angle", "left")
    _geometries = {"PlaneStrain": ("slope", "half_angle", "left")}
    slope: float | str | None
    half_angle: float | str | None
    left: float | str | None

    def __init__(
        self,
        *,
        slope: Number | None = None,
        half_angle: Number | None = None,
        left: Number | None = None,
    ) -> None:
        self._set(slope=slope, half_angle=half_angle, left=left)


class RoundedFlat(Punch):
    """A flat punch with rounded corners: height 0 up to half_width, from there on (|x| − half_width)²/(2R).

    Args:
        radius: Radius of curvature R of the corners, in length. Allowed: a finite number > 0.
        half_width: Half-width of the flat part, in length. Allowed: a finite number >= 0 (0 means: not there).
        flat_radius: Radius of the flat part, in length. Allowed: a finite number >= 0 (0 means: not there).
    """

    __slots__ = ("radius", "half_width", "flat_radius")
    _geometries = {"PlaneStrain": ("half_width", "radius"), "Axisymmetric": ("flat_radius", "radius")}
    radius: float | str
    half_width: float | str | None
    flat_radius: float | str | None

    def __init__(self, *, radius: Number, half_width: Number | None = None, flat_radius: Number | None = None) -> None:
        self._set(radius=radius, half_width=half_width, flat_radius=flat_radius)


class Flat(Punch):
    """A flat punch with sharp corners: the contact is as long as the punch, and the pressure is infinite at its
    corners, like an inverse root.

    Args:
        half_width: Half-width of the punch, in length. Allowed: a finite number > 0.
        radius: Radius of the punch, in length. Allowed: a finite number > 0.
    """

    __slots__ = ("half_width", "radius")
    _geometries = {"PlaneStrain": ("half_width",), "Axisymmetric": ("radius",)}
    half_width: float | str | None
    radius: float | str | None

    def __init__(self, *, half_width: Number | None = None, radius: Number | None = None) -> None:
        self._set(half_width=half_width, radius=radius)


class Table(Punch):
    """Heights at distances from the tip, as in `Table([(0, 0), (0.5, 0.01), (1, 0.05)])`, with a smooth curve through
    them. If the left is not the mirror image of the right, the distances on the left are negative.

    Args:
        rows: Allowed: [(x, height), ...], two or more with increasing x: from 0, the tip, on if the left is the mirror
            image of the right, or from the left end, with a height at 0.
    """

    __slots__ = ("rows",)
    _geometries = {"PlaneStrain": ("rows",), "Axisymmetric": ("rows",)}
    rows: tuple[Row, ...]

    def __init__(self, rows: Rows) -> None:
        self._set(rows=rows)


class Dent(Punch):
    """A dent, of layers that lie on each other: a gap depth · exp(−(x/half_width)²), and no punch.

    Args:
        depth: The gap in the middle, in length. Allowed: a finite number > 0.
        half_width: Where the gap is less by a factor e, in length. Allowed: a finite number > 0.
        radius: Where the gap is less by a factor e, in length. Allowed: a finite number > 0.
    """

    __slots__ = ("depth", "half_width", "radius")
    _geometries = {"PlaneStrain": ("depth", "half_width"), "Axisymmetric": ("depth", "radius")}
    depth: float | str
    half_width: float | str | None
    radius: float | str | None

    def __init__(self, *, depth: Number, half_width: Number | None = None, radius: Number | None = None) -> None:
        self._set(depth=depth, half_width=half_width, radius=radius)


class ElasticCylinder(Punch):
    """A circular cylinder of an elastic material: it is flattened like a half-plane.

    Args:
        radius: Radius R, in length. Allowed: a finite number > 0.
        poisson: Poisson's ratio of the cylinder, dimensionless. Allowed: -1 < poisson <= 0.5.
        shear_modulus: Shear modulus of the cylinder, in stress; or in its place `young`. Allowed: a finite number > 0.
        young: Young's modulus of the cylinder, in stress; or in its place `shear_modulus`. Allowed: a finite number >
            0.
    """

    __slots__ = ("radius", "poisson", "shear_modulus", "young")
    _geometries = {"PlaneStrain": ("radius", "shear_modulus", "young", "poisson")}
    radius: float | str
    poisson: float | str
    shear_modulus: float | str | None
    young: float | str | None

    def __init__(
        self,
        *,
        radius: Number,
        poisson: Number,
        shear_modulus: Number | None = None,
        young: Number | None = None,
    ) -> None:
        self._set(radius=radius, poisson=poisson, shear_modulus=shear_modulus, young=young)


class Covered(Punch):
    """A circular cylinder with elastic layers on its core: a second stack, which is pressed on the first one.

    Args:
        radius: Radius R of the outer face, in length. Allowed: a finite number > 0.
        layers: The layers and the interfaces between them, from the outer face inwards; they are thin compared with the
            radius. Allowed: a list in `[` and `]` of layers and interfaces in turn.
        core: What the last layer lies on, bonded unless an interface stands between: `Rigid`, or a half-plane for an
            elastic core. Allowed: a base, as at the bottom of a stack.
    """

    __slots__ = ("radius", "layers", "core")
    _geometries = {"PlaneStrain": ("radius", "layers", "core"), "Axisymmetric": ("radius", "layers", "core")}
    radius: float | str
    layers: tuple[StackItem, ...]
    core: StackItem

    def __init__(self, *, radius: Number, layers: Iterable[StackItem], core: StackItem) -> None:
        self._set(radius=radius, layers=layers, core=core)


class Sphere(Punch):
    """A sphere, exactly: height R − √(R² − r²), slope r/√(R² − r²).

    Args:
        radius: Radius R, in length. Allowed: a finite number > 0.
    """

    __slots__ = ("radius",)
    _geometries = {"Axisymmetric": ("radius",)}
    radius: float | str

    def __init__(self, *, radius: Number) -> None:
        self._set(radius=radius)


class Cone(Punch):
    """A cone: height s r, s its slope or the cotangent of its half-angle. The pressure is infinite at the tip, like a
    logarithm.

    Args:
        slope: Slope s of its surface, dimensionless: the tangent of its angle with the stack; or in its place
            `half_angle`. Allowed: a finite number > 0.
        half_angle: Angle of its surface with the axis, half of the angle at the tip; or in its place `slope`, its
            cotangent. Allowed: an angle > 0 and < pi/2, in radians or with its unit, such as "70.3 deg".
    """

    __slots__ = ("slope", "half_angle")
    _geometries = {"Axisymmetric": ("slope", "half_angle")}
    slope: float | str | None
    half_angle: float | str | None

    def __init__(self, *, slope: Number | None = None, half_angle: Number | None = None) -> None:
        self._set(slope=slope, half_angle=half_angle)


class ElasticSphere(Punch):
    """A sphere of an elastic material: it is flattened like a half-space.

    Args:
        radius: Radius R, in length. Allowed: a finite number > 0.
        poisson: Poisson's ratio of the cylinder, dimensionless. Allowed: -1 < poisson <= 0.5.
        shear_modulus: Shear modulus of the cylinder, in stress; or in its place `young`. Allowed: a finite number > 0.
        young: Young's modulus of the cylinder, in stress; or in its place `shear_modulus`. Allowed: a finite number >
            0.
    """

    __slots__ = ("radius", "poisson", "shear_modulus", "young")
    _geometries = {"Axisymmetric": ("radius", "shear_modulus", "young", "poisson")}
    radius: float | str
    poisson: float | str
    shear_modulus: float | str | None
    young: float | str | None

    def __init__(
        self,
        *,
        radius: Number,
        poisson: Number,
        shear_modulus: Number | None = None,
        young: Number | None = None,
    ) -> None:
        self._set(radius=radius, poisson=poisson, shear_modulus=shear_modulus, young=young)


class Line(Load):
    """The whole force on a line."""

    __slots__ = ()
    _geometries = {"PlaneStrain": ()}

    def __init__(self) -> None:
        self._set()


class Uniform(Load):
    """The same pressure everywhere on |x| < half_width, x from the middle of the load.

    Args:
        half_width: Half-width of the loaded strip, in length. Allowed: a finite number > 0.
        radius: Radius of the loaded disc, in length. Allowed: a finite number > 0.
    """

    __slots__ = ("half_width", "radius")
    _geometries = {"PlaneStrain": ("half_width",), "Axisymmetric": ("radius",)}
    half_width: float | str | None
    radius: float | str | None

    def __init__(self, *, half_width: Number | None = None, radius: Number | None = None) -> None:
        self._set(half_width=half_width, radius=radius)


class Parabolic(Load):
    """A pressure like 1 − (x/half_width)².

    Args:
        half_width: Half-width of the loaded strip, in length. Allowed: a finite number > 0.
        radius: Radius of the loaded disc, in length. Allowed: a finite number > 0.
    """

    __slots__ = ("half_width", "radius")
    _geometries = {"PlaneStrain": ("half_width",), "Axisymmetric": ("radius",)}
    half_width: float | str | None
    radius: float | str | None

    def __init__(self, *, half_width: Number | None = None, radius: Number | None = None) -> None:
        self._set(half_width=half_width, radius=radius)


class Elliptic(Load):
    """A pressure like √(1 − (x/half_width)²), as under Hertz's cylinder.

    Args:
        half_width: Half-width of the loaded strip, in length. Allowed: a finite number > 0.
        radius: Radius of the loaded disc, in length. Allowed: a finite number > 0.
    """

    __slots__ = ("half_width", "radius")
    _geometries = {"PlaneStrain": ("half_width",), "Axisymmetric": ("radius",)}
    half_width: float | str | None
    radius: float | str | None

    def __init__(self, *, half_width: Number | None = None, radius: Number | None = None) -> None:
        self._set(half_width=half_width, radius=radius)


class Point(Load):
    """The whole force at the point r = 0."""

    __slots__ = ()
    _geometries = {"Axisymmetric": ()}

    def __init__(self) -> None:
        self._set()


class Ring(Load):
    """The same pressure everywhere on a ring, |r − radius| < half_width.

    Args:
        radius: Radius of the middle of the ring, in length. Allowed: a finite number > 0.
        half_width: Half of its width, in length; at least a ten-thousandth of the radius. Allowed: a finite number > 0.
    """

    __slots__ = ("radius", "half_width")
    _geometries = {"Axisymmetric": ("radius", "half_width")}
    radius: float | str
    half_width: float | str

    def __init__(self, *, radius: Number, half_width: Number) -> None:
        self._set(radius=radius, half_width=half_width)


__all__ = [
    "Bonded",
    "Cone",
    "Covered",
    "Cylinder",
    "Dent",
    "ElasticCylinder",
    "ElasticSphere",
    "Elliptic",
    "Exponential",
    "Flat",
    "Graded",
    "GradedHalfPlane",
    "HalfPlane",
    "Homogeneous",
    "Line",
    "Load",
    "Orthotropic",
    "OrthotropicHalfPlane",
    "OrthotropicPoisson",
    "OrthotropicYoung",
    "Parabola",
    "Parabolic",
    "Point",
    "Polynomial",
    "Power",
    "PowerHalfPlane",
    "Punch",
    "Receding",
    "Rigid",
    "Ring",
    "RoundedFlat",
    "Sliding",
    "Sphere",
    "Spring",
    "StackItem",
    "Table",
    "Uniform",
    "Wedge",
    "Winkler",
]

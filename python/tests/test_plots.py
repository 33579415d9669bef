"""Pictures on axes of matplotlib."""

import numpy as np
import pytest

import recede

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
plt = pytest.importorskip("matplotlib.pyplot")


@pytest.fixture
def slab():
    scene = recede.Scene.from_ron(
        """Scene(units: (length: "m", force: "MN"), geometry: PlaneStrain, load: Uniform(half_width: 0.1), force: 1.2, stack: [
            Homogeneous(thickness: 0.2, young: 30000.0, poisson: 0.2, specific_weight: 0.024),
            Receding, HalfPlane(young: 100.0, poisson: 0.35)])"""
    )
    return scene.solve()


def test_pressures_are_drawn_with_their_units(slab):
    axes = slab.plot()
    labels = [line.get_label() for line in axes.get_lines()]
    assert labels == ["punch", "1|2"]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x, m", "pressure, MPa")
    own = plt.subplots()[1]
    assert slab.plot(own) is own
    # the pressure is the weight far away, and nothing in openings
    x, pressure = axes.get_lines()[1].get_data()
    [opening, *_] = slab.closed[0].openings
    inside = (x > opening.left) & (x < opening.right)
    assert np.allclose(pressure[inside], 0.0) and pressure.max() > 0.1
    plt.close("all")


def test_maps_have_all_layers_and_a_scale(slab):
    field = slab.field()
    assert [layer[0] for layer in field.layers] == [1, 2] and field.layers[0][1:] == (0.0, 0.2)
    (left, right), (top, bottom) = field.window()
    assert left == -right and top == 0.0 and bottom > 0.2
    # the window has the openings
    assert right > slab.closed[0].openings[-1].right
    axes = field.map("sigma_xx")
    assert len(axes.collections) == 2 and axes.get_ylim() == (bottom, 0.0)
    bar = axes.figure.axes[1]
    assert bar.get_ylabel() == "sigma_xx, MPa" and axes.get_ylabel() == "depth, m"
    low, high = axes.collections[0].get_clim()
    assert low == -high
    assert field.map("eps_1", x=[0.0, 0.1], depth=[0.0, 0.1]).figure.axes[1].get_ylabel() == "eps_1"
    with pytest.raises(KeyError, match="there is no 'sigma_rr'; there are x, depth, layer, sigma_xx"):
        field.map("sigma_rr")
    [upper, lower] = field.by_layer([0.0, 0.5], [0.0, 0.1, 0.3])
    assert upper.depth[-1, 0] == 0.2 == lower.depth[0, 0] and upper.sigma_xx[-1, 0] != lower.sigma_xx[0, 0]
    plt.close("all")


def test_columns_of_tables_are_drawn(scene):
    table = recede.sweep(scene, {"force": [1e-3, 2e-3, 3e-3]}, at=["0,0=sigma_yy"])
    axes = table.plot()
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("force", "punch_half_length")
    axes = table.plot("punch_half_length", ["force", "sigma_yy_at_0_0"])
    assert [line.get_label() for line in axes.get_lines()] == ["force", "sigma_yy_at_0_0"]
    assert axes.get_lines()[0].get_marker() == "."
    with pytest.raises(KeyError, match="there is no column of numbers 'forc'"):
        table.plot("forc")
    plt.close("all")


def test_tables_are_data_frames(scene):
    pytest.importorskip("pandas")
    frame = recede.sweep(scene, {"force": [1e-3, 2e-3]}).to_pandas()
    assert frame["punch_half_length"].is_monotonic_increasing and frame.attrs["scene"].startswith("Scene(")

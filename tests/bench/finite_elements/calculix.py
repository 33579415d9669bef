"""Strip pressed by a parabolic punch onto a half-plane, by CalculiX (Debian package calculix-ccx).

Half of the problem, x >= 0, one layer of C3D8I elements with plane strain enforced, meshes fine within the contacts and
growing geometrically to `FAR` thicknesses, frictionless surface-to-surface contact, small displacements. The punch is a
block of elements made rigid, pressed by a force on its reference node. Half-lengths follow from the pressures: the force
T beyond x goes to zero like (edge - x)^(3/2).

    python calculix.py 0.05 [folder]       element length at the contacts, in thicknesses
"""
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from q9 import FORCE, MU, NU, RADIUS, grown

FAR = 200.0
FINE = 1.8
WIDTH = 0.05  # of the layer of elements, out of plane
STIFFNESS = 2e3  # of the contact, in shear moduli per thickness and element length


class Mesh:
    """Nodes and eight-node bricks of all bodies, in the order in which they are added."""

    def __init__(self):
        self.points, self.elements, self.count = [], {}, 0

    def block(self, name, x, y):
        """A block between breakpoints (y may depend on x); returns its node numbers [z][row][column]."""
        y = np.broadcast_to(np.asarray(y, float).T, (len(x), np.shape(y)[0])).T if np.ndim(y) == 1 else np.asarray(y)
        rows, columns = y.shape
        nodes = self.count + 1 + np.arange(2 * rows * columns).reshape(2, rows, columns)
        for z in range(2):
            for row in range(rows):
                self.points += [(x[c], y[row, c], z * WIDTH) for c in range(columns)]
        self.count += 2 * rows * columns
        first = sum(len(e) for e in self.elements.values()) + 1
        a, b = nodes[:, :-1, :-1], nodes[:, 1:, 1:]
        lower_right, upper_left = nodes[:, :-1, 1:], nodes[:, 1:, :-1]
        faces = [np.stack([a[z], lower_right[z], b[z], upper_left[z]], axis=-1).reshape(-1, 4) for z in range(2)]
        self.elements[name] = np.concatenate([first + np.arange(len(faces[0]))[:, None], *faces], axis=1)
        return nodes


def lines(numbers, per_line=12):
    numbers = [str(n) for n in np.ravel(numbers)]
    return "\n".join(", ".join(numbers[k : k + per_line]) for k in range(0, len(numbers), per_line))


def deck(element):
    """The input of ccx, and the nodes of the strip's top and bottom face."""
    fine = np.linspace(0, FINE, round(FINE / element) + 1)
    x = np.concatenate([fine, grown(FINE, element, FAR, 1.2)])
    rows = max(6, round(0.7 / element))
    y = 0.5 - 0.5 * np.cos(np.pi * np.arange(rows + 1) / rows)
    mesh = Mesh()
    plane = mesh.block("PLANE", x, np.concatenate([-grown(0, element, FAR, 1.2)[::-1], [0.0]]))
    strip = mesh.block("STRIP", x, y)
    # the punch ends where its contact certainly does not reach
    px = fine[: np.searchsorted(fine, 1.0) + 1]
    bottom = 1 + px**2 / (2 * RADIUS)
    punch = mesh.block("PUNCH", px, np.stack([bottom, np.full_like(px, 1.2)]))
    reference = mesh.count + 1
    # rows of elements follow each other, columns within a row
    per_row = len(x) - 1
    plane_top = mesh.elements["PLANE"][-per_row:, 0]
    strip_bottom, strip_top = mesh.elements["STRIP"][:per_row, 0], mesh.elements["STRIP"][-per_row:, 0]
    out = ["*NODE, NSET=ALL"]
    out += [f"{k + 1}, {p[0]:.12g}, {p[1]:.12g}, {p[2]:.12g}" for k, p in enumerate(mesh.points)]
    out += ["*NODE, NSET=REFERENCE", f"{reference}, 0, 1.2, 0", f"{reference + 1}, 0, 1.2, 0"]
    for name, elements in mesh.elements.items():
        out += [f"*ELEMENT, TYPE=C3D8I, ELSET={name}"] + [", ".join(map(str, e)) for e in elements]
    out += ["*MATERIAL, NAME=ELASTIC", "*ELASTIC", f"{2 * MU * (1 + NU)}, {NU}"]
    out += [f"*SOLID SECTION, ELSET={name}, MATERIAL=ELASTIC" for name in mesh.elements]
    # faces of bricks: 3 is y-, 5 is y+ in this numbering of the corners
    inside = lambda elements: elements[: len(fine) - 1]
    for name, elements, face in [
        ("PUNCHFACE", mesh.elements["PUNCH"][:, 0], "S3"),
        ("STRIPTOP", inside(strip_top), "S5"),
        ("STRIPBOTTOM", inside(strip_bottom), "S3"),
        ("PLANETOP", inside(plane_top), "S5"),
    ]:
        out += [f"*SURFACE, NAME={name}"] + [f"{e}, {face}" for e in elements]
    out += ["*SURFACE INTERACTION, NAME=CONTACT", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR"]
    out += [f"{STIFFNESS * MU / element}, {1e-7 * MU}, {1e-7}"]
    out += ["*CONTACT PAIR, INTERACTION=CONTACT, TYPE=SURFACE TO SURFACE", "STRIPTOP, PUNCHFACE"]
    out += ["*CONTACT PAIR, INTERACTION=CONTACT, TYPE=SURFACE TO SURFACE", "STRIPBOTTOM, PLANETOP"]
    out += ["*NSET, NSET=PUNCHNODES", lines(punch), f"*RIGID BODY, NSET=PUNCHNODES, REF NODE={reference}, ROT NODE={reference + 1}"]
    out += ["*NSET, NSET=AXIS", lines([plane[:, :, 0].ravel().tolist() + strip[:, :, 0].ravel().tolist()])]
    out += ["*NSET, NSET=DEPTH", lines(plane[:, 0, :]), "*NSET, NSET=BODIES", lines([plane.ravel().tolist() + strip.ravel().tolist()])]
    out += ["*NSET, NSET=TOP", lines(strip[:, -1, : len(fine)]), "*NSET, NSET=BOTTOM", lines(strip[:, 0, : len(fine)])]
    out += ["*BOUNDARY", "AXIS, 1, 1", "DEPTH, 1, 2", "BODIES, 3, 3", f"{reference}, 1, 1", f"{reference}, 3, 3", f"{reference + 1}, 1, 3"]
    out += ["*STEP, INC=200", "*STATIC", "1.0, 1.0, 1e-5, 1.0", "*CLOAD", f"{reference}, 2, {-FORCE / 2 * WIDTH}"]
    out += ["*NODE FILE, FREQUENCY=1000", "U", "*CONTACT FILE, FREQUENCY=1000", "CSTR", "*END STEP"]
    unknowns = 2 * (plane.size + strip.size)
    return "\n".join(out) + "\n", strip[0, -1, : len(fine)], strip[0, 0, : len(fine)], fine, unknowns


def contact_pressures(frd):
    """Normal contact pressures by node, of the last increment."""
    found, reading, at = {}, False, None
    for line in frd.splitlines():
        if line.startswith(" -4"):
            reading = "CONTACT" in line
            if reading:
                found = {}
        elif reading and line.startswith(" -1"):
            values = [float(line[13 + 12 * k : 25 + 12 * k]) for k in range(6)]
            found[int(line[3:13])] = values[3]
    return found


def end_of_contact(x, p):
    """The zero of T^(2/3) from where T is not yet smeared by the contact's stiffness and by pressures at nodes."""
    beyond = np.array([np.trapezoid(p[k:], x[k:]) for k in range(len(x))])
    use = (beyond > 0.1 * beyond[0]) & (beyond < 0.5 * beyond[0])
    return np.polyfit(beyond[use] ** (2 / 3), x[use], min(3, use.sum() - 1))[-1]


def solve(element, folder):
    text, top, bottom, x, unknowns = deck(element)
    (Path(folder) / "strip.inp").write_text(text)
    run = subprocess.run(["ccx", "strip"], cwd=folder, capture_output=True, text=True, env={"OMP_NUM_THREADS": "1", "PATH": "/usr/bin:/bin"})
    if "Job finished" not in run.stdout or "*ERROR" in run.stdout:
        raise SystemExit(run.stdout[-3000:])
    pressures = contact_pressures((Path(folder) / "strip.frd").read_text())
    lengths = []
    for nodes in (top, bottom):
        p = np.array([max(pressures.get(int(n), 0.0), 0.0) for n in nodes])
        lengths.append(end_of_contact(x, p))
    return lengths, unknowns


if __name__ == "__main__":
    element = float(sys.argv[1]) if len(sys.argv) > 1 else 0.05
    start = time.process_time()
    with tempfile.TemporaryDirectory() as folder:
        (a, b), unknowns = solve(element, sys.argv[2] if len(sys.argv) > 2 else folder)
    ccx = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{a:.9f} {b:.9f} {unknowns} {time.process_time() - start + ccx.ru_utime + ccx.ru_stime:.3f}")

"""Strip pressed by a parabola onto a half-plane: biquadratic finite elements and an active set.

Half of the plane-strain problem, x >= 0. Both bodies are meshed by nine-node rectangles, fine within the contacts and
growing geometrically to `FAR` thicknesses away; each is reduced to the compliance between its contact nodes, and the
contact is found by an active set of nodal forces. Half-lengths follow from the force T beyond x, which goes to zero like
(edge - x)^(3/2): a polynomial through T^(2/3).

    python q9.py 0.05        element length at the contacts, in thicknesses
"""
import sys
import time

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

FAR = 400.0
FINE = 1.8  # elements are fine out to here
MU, NU = 1.0, 0.25
RADIUS, FORCE = 500.0, 0.001


def grown(start, step, end, by=1.4):
    """Breakpoints from `start` to `end`, each step longer than the last by the same factor."""
    lengths = []
    while sum(lengths) < end - start:
        step *= by
        lengths.append(step)
    return start + np.cumsum(lengths) * (end - start) / sum(lengths)


def element_stiffness(a, b):
    """Stiffness of a nine-node rectangle a by b, plane strain, three by three Gauss points."""
    lam = 2 * MU * NU / (1 - 2 * NU)
    d = np.array([[lam + 2 * MU, lam, 0], [lam, lam + 2 * MU, 0], [0, 0, MU]])
    gauss = [(-np.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (np.sqrt(0.6), 5 / 9)]
    shape = lambda t: np.array([t * (t - 1) / 2, 1 - t * t, t * (t + 1) / 2])
    slope = lambda t: np.array([t - 0.5, -2 * t, t + 0.5])
    k = np.zeros((18, 18))
    for x, wx in gauss:
        for y, wy in gauss:
            dx = np.outer(shape(y), slope(x)).ravel() * 2 / a
            dy = np.outer(slope(y), shape(x)).ravel() * 2 / b
            strain = np.zeros((3, 18))
            strain[0, 0::2], strain[1, 1::2] = dx, dy
            strain[2, 0::2], strain[2, 1::2] = dy, dx
            k += wx * wy * a * b / 4 * strain.T @ d @ strain
    return k


class Body:
    """A mesh of rectangles between breakpoints, its stiffness factorised with the given degrees of freedom fixed."""

    def __init__(self, x, y, fixed):
        nx, ny = len(x) - 1, len(y) - 1
        self.x = np.interp(np.arange(2 * nx + 1) / 2, np.arange(nx + 1), x)
        self.columns = 2 * nx + 1
        cx, cy = np.meshgrid(np.arange(nx), np.arange(ny))
        first = (2 * cy * self.columns + 2 * cx).ravel()
        local = (np.arange(3)[:, None] * self.columns + np.arange(3)).ravel()
        nodes = first[:, None] + local
        dofs = (2 * nodes[:, :, None] + np.arange(2)).reshape(len(nodes), 18)
        # an a by b rectangle has the stiffness A q + B/q + C, q = a/b
        samples = np.stack([element_stiffness(1, 1), element_stiffness(2, 1), element_stiffness(1, 2)])
        parts = np.linalg.solve([[1, 1, 1], [2, 0.5, 1], [0.5, 2, 1]], samples.reshape(3, -1))
        ratio = (np.diff(x)[cx.ravel()] / np.diff(y)[cy.ravel()])[:, None]
        values = (ratio * parts[0] + parts[1] / ratio + parts[2]).reshape(-1, 18, 18)
        size = 2 * self.columns * (2 * ny + 1)
        rows = np.repeat(dofs, 18, axis=1).ravel()
        cols = np.tile(dofs, (1, 18)).ravel()
        k = coo_matrix((values.ravel(), (rows, cols)), shape=(size, size)).tocsc()
        free = np.setdiff1d(np.arange(size), fixed(self.columns, 2 * ny + 1))
        self.size, self.free, self.unknowns = size, free, len(free)
        self.factor = splu(k[free][:, free], permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})

    def compliance(self, dofs):
        """Displacements of `dofs` under unit forces on them."""
        place = np.full(self.size, -1)
        place[self.free] = np.arange(len(self.free))
        at = place[dofs]
        loads = np.zeros((len(self.free), len(dofs)))
        loads[at, np.arange(len(dofs))] = 1.0
        return self.factor.solve(loads)[at]


def edge(x, force):
    """Where the contact ends: the zero of T^(2/3), T being the force beyond a corner node."""
    last = np.nonzero(force > 0)[0][-1]
    corners = np.arange(0, last + 1, 2)
    beyond = np.array([force[c + 1:].sum() + force[c] / 2 for c in corners])
    use = (beyond < 0.6 * beyond[0]) & (corners <= last - 2)
    return np.polyfit(beyond[use] ** (2 / 3), x[corners[use]], min(4, use.sum() - 1))[-1]


def solve(element):
    fine = np.linspace(0, FINE, round(FINE / element) + 1)
    x = np.concatenate([fine, grown(FINE, element, FAR)])
    rows = max(4, 2 * round(0.5 / element))
    # rows of the strip, finer at its faces
    y = 0.5 - 0.5 * np.cos(np.pi * np.arange(rows + 1) / rows) if rows > 8 else np.linspace(0, 1, rows + 1)
    symmetry = lambda columns, lines: 2 * columns * np.arange(lines)
    # the strip floats: one vertical displacement is held, and the motion is an unknown of the contact
    strip = Body(x, y, lambda columns, lines: np.append(symmetry(columns, lines), 2 * (columns * (lines // 2)) + 1))
    depth = np.concatenate([-grown(0, element / 2, FAR)[::-1], [0.0]])
    fixed_bottom = lambda columns, lines: np.concatenate([symmetry(columns, lines), np.arange(2 * columns)])
    plane = Body(x, depth, fixed_bottom)

    contact = np.arange(np.searchsorted(strip.x, FINE))
    n = len(contact)
    top = 2 * (strip.columns * (2 * (len(y) - 1)) + contact) + 1
    bottom = 2 * contact + 1
    surface = 2 * (plane.columns * (2 * (len(depth) - 1)) + contact) + 1
    # gaps under nodal forces that press: g0 + C f - unknown motions
    whole = strip.compliance(np.concatenate([top, bottom]))
    c = np.block([[whole[:n, :n], -whole[:n, n:]], [-whole[n:, :n], whole[n:, n:] + plane.compliance(surface)]])
    px = strip.x[contact]
    gap = np.concatenate([px**2 / (2 * RADIUS), np.zeros(n)])
    # punch and strip move down by d and e: gap 0 shrinks by d - e, gap 1 by e
    motion = np.zeros((2 * n, 2))
    motion[:n, 0], motion[:n, 1], motion[n:, 1] = -1, 1, -1
    resultants = np.zeros((2, 2 * n))
    resultants[0, :n], resultants[1, n:] = 1, 1
    active = np.concatenate([px < 0.7, px < 1.5])
    for _ in range(60):
        k = np.nonzero(active)[0]
        matrix = np.block([[c[np.ix_(k, k)], motion[k]], [resultants[:, k], np.zeros((2, 2))]])
        found = np.linalg.solve(matrix, np.concatenate([-gap[k], [FORCE / 2, FORCE / 2]]))
        force = np.zeros(2 * n)
        force[k] = found[:-2]
        opened = gap + c @ force + motion @ found[-2:]
        wrong = (active & (force < 0)) | (~active & (opened < -1e-15))
        if not wrong.any():
            break
        active ^= wrong
    lengths = edge(px, force[:n]), edge(px, force[n:])
    return lengths, strip.unknowns + plane.unknowns


if __name__ == "__main__":
    start = time.process_time()
    (a, b), unknowns = solve(float(sys.argv[1]) if len(sys.argv) > 1 else 0.05)
    print(f"{a:.9f} {b:.9f} {unknowns} {time.process_time() - start:.3f}")

#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the stickslip authors
"""Which small waves grow on a fault between two endless layers that slide?

Usage: sliding_layers.py [--check | --limits] [--modes N] [--waves N]
                         [NAME=VALUE ...]

The layers and the friction are those of doc/stability.md. The lower layer is held
at its bottom. The upper one is moved along x at its top, where the normal traction
is given or the layer is held in y. Perturbations are

    u(x, y, t) = U(y) exp(ikx + st)

with complex s. The shear traction and the normal stress on the fault change by

    tau' = mu sigma_n' + Z(s) [u_x],    Z = sigma_n (a s/V - b (s/L)/(s + V/L)),

the first term only where the normal stress follows the contact pressure. Each
layer has two pairs of waves; eight conditions determine their coefficients, and s
are the zeros of the determinant. All of them in a rectangle are found by the
argument principle, and refined by Newton's method.

NAME is an attribute of Scene or, with the prefix lower. or upper., of Layer, in SI
units. Prints the fastest growing, or slowest decaying, modes of the waves with
n = 1, 2, ... wave lengths on the length of the scene: growth rate in 1/s, angular
frequency in rad/s (positive: the wave runs against the slip of the upper layer).

With --limits it prints the table of doc/stability.md: the least a at which no wave
grows, and the least viscosity, by bisection.

With --check the status is 1 unless limits with known answers are met.
"""

import argparse
import dataclasses
import sys

import numpy as np


@dataclasses.dataclass
class Layer:
    young: float = 4e7
    poisson: float = 0.3
    density: float = 5e3
    shear_viscosity: float = 100.0
    bulk_viscosity: float = 100.0
    thickness: float = 0.5

    def moduli(self, s):
        """Shear modulus and first Lame parameter of a Kelvin-Voigt solid."""
        shear = self.young / 2 / (1 + self.poisson) + s * self.shear_viscosity
        nu = self.poisson
        lame = self.young * nu / ((1 + nu) * (1 - 2 * nu))
        lame = lame + s * (self.bulk_viscosity - 2 / 3 * self.shear_viscosity)
        return shear, lame


@dataclasses.dataclass
class Scene:
    lower: Layer = dataclasses.field(default_factory=Layer)
    upper: Layer = dataclasses.field(default_factory=Layer)
    length: float = 1.0
    mu: float = 0.6
    a: float = 0.01
    b: float = 0.0
    characteristic_slip: float = 1e-3
    normal_stress: float = 1e4
    slip_rate: float = 1e-2
    follows: bool = True
    top_is_held: bool = False
    inertia: str = "dynamic"

    def radiation_damping(self):
        if self.inertia != "quasi-dynamic":
            return 0.0
        return 1 / sum(
            (x.density * x.moduli(0)[0]) ** -0.5 for x in (self.lower, self.upper)
        )

    def resistance(self, s):
        """Shear traction for a slip of one, without that of the normal stress."""
        rate = self.slip_rate / self.characteristic_slip
        state = s / self.characteristic_slip / (s + rate)
        friction = self.a * s / self.slip_rate - self.b * state
        return self.normal_stress * friction + self.radiation_damping() * s


def waves(layer, k, s, y, has_mass):
    """Four waves of a layer that begins at the fault, at a distance |y| from it:
    displacements and tractions, of shape (4, 4) for each s; of size one at the end
    that they grow to. And the logarithm of what makes them symmetric."""
    mu, lame = layer.moduli(s)
    h = np.copysign(layer.thickness, y)
    rho = layer.density
    p = np.sqrt(k**2 + rho * s**2 / (lame + 2 * mu)) if has_mass else k + 0 * s
    q = np.sqrt(k**2 + rho * s**2 / mu) if has_mass else k + 0 * s
    result = np.empty(s.shape + (4, 4), dtype=complex)
    for j, r in enumerate((p, -p, q, -q)):
        # From the end where exp(r y) is largest.
        start = np.where(r.real * h > 0, h, 0.0)
        e = np.exp(r * (y - start))
        if j < 2:
            u, v = 1j * k * e, r * e
            du, dv = r * u, r * v
        elif has_mass:
            u, v = r * e, -1j * k * e
            du, dv = r * u, r * v
        else:
            # Both kinds coincide: the second one grows with the distance.
            kappa = (lame + 3 * mu) / (lame + mu)
            u = 1j * k * y * e
            v = (r * y - kappa) * e
            du = 1j * k * e + r * u
            dv = r * e + r * v
        result[..., 0, j] = u
        result[..., 1, j] = v
        result[..., 2, j] = mu * (du + 1j * k * v)
        result[..., 3, j] = (lame + 2 * mu) * dv + lame * 1j * k * u
    return result, (p + q) * layer.thickness, p * q


def determinant_matrix(scene, k, s):
    """The conditions for the coefficients of the waves, for each s; and the
    logarithm of the factor that makes the determinant an analytic function."""
    s = np.asarray(s, dtype=complex)
    has_mass = scene.inertia == "dynamic"
    matrix = np.zeros(s.shape + (8, 8), dtype=complex)
    factor = np.zeros(s.shape, dtype=complex)
    fault = []
    unit = k * scene.lower.moduli(0)[0]
    for i, layer in enumerate((scene.lower, scene.upper)):
        sign = (-1.0, 1.0)[i]
        columns = slice(4 * i, 4 * i + 4)
        h = sign * layer.thickness
        end, log_scale, product = waves(layer, k, s, h, has_mass)
        matrix[..., 2 * i, columns] = end[..., 0, :]
        held = i == 0 or scene.top_is_held
        matrix[..., 2 * i + 1, columns] = end[..., 1 if held else 3, :] / (
            1 if held else unit
        )
        at_fault, _, _ = waves(layer, k, s, sign * 0.0, has_mass)
        fault.append(at_fault)
        # Symmetric waves, and the wave that is lost where exp(qy) = exp(-qy).
        factor += log_scale - np.log(product)
    lower, upper = fault
    for i, part in enumerate((1, 2, 3)):
        scale = 1 if part == 1 else unit
        matrix[..., 4 + i, :4] = -lower[..., part, :] / scale
        matrix[..., 4 + i, 4:] = upper[..., part, :] / scale
    z = scene.resistance(s)[..., None]
    matrix[..., 7, :4] = z * lower[..., 0, :] / unit
    matrix[..., 7, 4:] = (
        upper[..., 2, :]
        + (scene.mu * upper[..., 3, :] if scene.follows else 0)
        - z * upper[..., 0, :]
    ) / unit
    if has_mass:
        # Both kinds of waves coincide at s = 0.
        factor -= 8 * np.log(s)
    if scene.b > 0:
        factor += np.log(s + scene.slip_rate / scene.characteristic_slip)
    return matrix, factor


def log_determinant(scene, k, s):
    matrix, factor = determinant_matrix(scene, k, s)
    sign, log = np.linalg.slogdet(matrix)
    return log + 1j * np.angle(sign) + factor


def difference(a, b):
    """Of logarithms, with an angle within pi."""
    d = b - a
    return d.real + 1j * ((d.imag + np.pi) % (2 * np.pi) - np.pi)


def count(scene, k, box):
    """Zeros in a rectangle: left, right, lower, upper."""
    left, right, low, high = box
    corners = [
        left + 1j * low, right + 1j * low, right + 1j * high, left + 1j * high,
        left + 1j * low,
    ]
    total = 0.0
    # What the phase of the waves that cross the layers turns by.
    delay = sum(
        4 * x.thickness / shear_speed(x) for x in (scene.lower, scene.upper)
    )
    for begin, end in zip(corners[:-1], corners[1:]):
        x = np.linspace(0, 1, 17 + int(delay * abs(end - begin)))
        f = log_determinant(scene, k, begin + x * (end - begin))
        for _ in range(40):
            turns = np.abs(difference(f[:-1], f[1:]))
            coarse = np.flatnonzero(turns > 0.7)
            if len(coarse) == 0:
                break
            new = (x[coarse] + x[coarse + 1]) / 2
            f_new = log_determinant(scene, k, begin + new * (end - begin))
            x = np.insert(x, coarse + 1, new)
            f = np.insert(f, coarse + 1, f_new)
        total += difference(f[:-1], f[1:]).imag.sum()
    return int(round(total / 2 / np.pi))


def newton(scene, k, s):
    for _ in range(50):
        h = 1e-5 * abs(s)
        f = log_determinant(scene, k, np.array([s - h, s + h, s]))
        if not np.isfinite(f[2]):
            break
        relative = np.exp(f[:2] - f[2])
        step = -2 * h / (relative[1] - relative[0])
        s = s + step
        if abs(step) < 1e-13 * abs(s):
            break
    return s


def residual(scene, k, s):
    """Of a zero: least over largest but one singular value."""
    matrix, _ = determinant_matrix(scene, k, np.array([s]))
    matrix /= np.linalg.norm(matrix, axis=-2, keepdims=True)
    values = np.linalg.svd(matrix[0], compute_uv=False)
    return values[-1] / values[-2]


def zeros(scene, k, box):
    """All zeros in a rectangle."""
    found, boxes = [], [(box, count(scene, k, box))]
    while boxes:
        (left, right, low, high), n = boxes.pop()
        if n <= 0:
            continue
        middle = (left + right) / 2 + 1j * (low + high) / 2
        if n == 1:
            s = newton(scene, k, middle)
            if left <= s.real <= right and low <= s.imag <= high:
                found.append(s)
                continue
        if max(right - left, high - low) < 1e-9 * abs(middle):
            found += n * [middle]
            continue
        # Not in the middle, where symmetric scenes have zeros.
        if right - left > high - low:
            x = left + 0.4871 * (right - left)
            parts = [(left, x, low, high), (x, right, low, high)]
        else:
            y = low + 0.4871 * (high - low)
            parts = [(left, right, low, y), (left, right, y, high)]
        n_first = count(scene, k, parts[0])
        boxes += [(parts[0], n_first), (parts[1], n - n_first)]
    return sorted(found, key=lambda s: -s.real)


def shear_speed(layer):
    return np.sqrt(layer.moduli(0)[0].real / layer.density)


def modes(scene, n, decay=None, highest=6.0):
    """Modes with n wave lengths that do not decay faster than a rate, up to some
    multiple of the frequency of shear waves."""
    k = 2 * np.pi * n / scene.length
    w = max(shear_speed(x) * max(k, np.pi / x.thickness)
            for x in (scene.lower, scene.upper))
    decay = 0.05 * w if decay is None else decay
    box = (-decay, 2.013 * w, -highest * w, (highest + 0.017) * w)
    return zeros(scene, k, box)


def grows(scene):
    """Whether any of some waves grows, by more than 0.02/s."""
    return any(
        count(
            scene, 2 * np.pi * n / scene.length,
            (0.02, 2500.0 * n, -2.5e4, 2.5003e4),
        )
        for n in (1, 2, 3, 4, 6, 8)
    )


def least(make_scene, low, high):
    """The least value at which nothing grows, within a hundredth."""
    while high / low > 1.01:
        middle = np.sqrt(low * high)
        low, high = (middle, high) if grows(make_scene(middle)) else (low, middle)
    return high


def print_limits():
    print("| E lower/upper | upper side | mu | least a | least viscosity, Pa s |")
    print("|---|---|---|---|---|")
    for young, is_held in ((4e7, False), (1.2e8, False), (1.2e8, True)):
        for mu in (0.1, 0.2, 0.4, 0.6, 0.8):

            def make_scene(a, viscosity):
                viscous = dict(shear_viscosity=viscosity, bulk_viscosity=viscosity)
                return Scene(
                    Layer(young=young, **viscous), Layer(**viscous), mu=mu, a=a,
                    top_is_held=is_held,
                )

            a = least(lambda a: make_scene(a, 100.0), 1e-3, 10.0)
            viscosity = least(lambda eta: make_scene(0.01, eta), 1.0, 1e6)
            side = "held in y" if is_held else "pressed"
            print(
                f"| {young / 4e7:.0f} | {side} | {mu} | {a:.3f} "
                f"| {viscosity:.0f} |",
                flush=True,
            )


# Checks: each returns the largest relative error.


def inviscid(**values):
    return Layer(shear_viscosity=0.0, bulk_viscosity=0.0, **values)


def largest_error(found, expected):
    if len(found) != len(expected):
        return np.inf
    return np.abs(np.asarray(found) / np.asarray(expected) - 1).max()


def check_column():
    """Long waves in layers that do not slip: shear waves of a column with both
    ends held, pressure waves of one with a free end."""
    scene = Scene(inviscid(), inviscid(), a=1e9, length=1e4, follows=False)
    mu, lame = scene.lower.moduli(0)
    density, height = scene.lower.density, 2 * scene.lower.thickness
    c_s, c_p = np.sqrt(mu / density), np.sqrt((lame + 2 * mu) / density)
    expected = np.pi / height * np.append(
        np.arange(1, 4) * c_s, (np.arange(2) + 0.5) * c_p
    )
    box = (-5.0, 5.3, 40.0, expected.max() + 10.0)
    found = zeros(scene, 2 * np.pi / scene.length, box)
    return largest_error(np.sort([s.imag for s in found]), np.sort(expected))


def check_rayleigh():
    """Between equal half-spaces without friction, Rayleigh waves; nu = 1/4."""
    layers = [inviscid(poisson=0.25, thickness=10.0) for _ in range(2)]
    scene = Scene(*layers, a=1e-15, mu=0.0)
    k = 2 * np.pi
    w = k * shear_speed(scene.lower)
    found = zeros(scene, k, (-1.0, 1.3, 0.85 * w, 0.97 * w))
    expected = w * np.sqrt(2 - 2 / np.sqrt(3))
    return min((abs(s.imag / expected - 1) for s in found), default=np.inf)


def check_half_spaces():
    """Without inertia K = G k / (2 (1 - nu)) between half-spaces (Rice and Ruina
    1983), and s obeys a quadratic equation."""
    error = 0.0
    for inertia in ("quasi-static", "quasi-dynamic"):
        scene = Scene(
            inviscid(thickness=5.0), inviscid(thickness=5.0), b=0.015,
            characteristic_slip=1e-6, slip_rate=1e-3, follows=False,
            top_is_held=True, inertia=inertia,
        )
        k = 2 * np.pi
        stiffness = scene.lower.moduli(0)[0] * k / 2 / (1 - scene.lower.poisson)
        V, L = scene.slip_rate, scene.characteristic_slip
        damping = scene.radiation_damping()
        A = scene.a * scene.normal_stress / V + damping
        drive = (scene.b - scene.a) * scene.normal_stress - damping * V
        expected = np.roots([A, stiffness - drive / L, stiffness * V / L])
        found = [newton(scene, k, s * (1.01 + 0.01j)) for s in expected]
        error = max(error, largest_error(found, expected))
    return error


def check_rate_and_state():
    """Growth rates with a fixed normal stress of doc/accuracy.md, from another
    program: fast, with unequal viscous layers."""
    layer = {"young": 4.12e7}
    scene = Scene(
        inviscid(**layer), inviscid(**layer), b=0.015, characteristic_slip=5e-6,
        normal_stress=5e4, slip_rate=2e-5, follows=False, top_is_held=True,
        inertia="quasi-static",
    )
    # The critical wave length, of equal layers.
    w = scene.slip_rate / scene.characteristic_slip
    w *= np.sqrt((scene.b - scene.a) / scene.a)
    low, high = 0.1, 10.0
    while high / low > 1 + 1e-10:
        length = np.sqrt(low * high)
        s = newton(scene, 2 * np.pi / length, 1j * w)
        low, high = (low, length) if s.real > 0 else (length, high)
    scene.slip_rate, scene.inertia = 4e-3, "dynamic"
    scene.lower = Layer(6e7, 0.3, 5e3, 2e3, 0.0, 0.6)
    scene.upper = Layer(4.12e7, 0.2, 3e3, 0.0, 4e3, 0.4)
    expected = {0.6: -32.22 + 678.2j, 1.7: 34.52 + 293.4j}
    found = [
        newton(scene, 2 * np.pi / (factor * low), s * (1 + 0.01j))
        for factor, s in expected.items()
    ]
    return largest_error(found, list(expected.values()))


def check_symmetry():
    """Between equal layers that are held in the same way slip does not change
    the normal stress: nothing grows."""
    scene = Scene(mu=0.8, top_is_held=True)
    box = (0.05, 700.0, -3e3, 3.01e3)
    grows = count(scene, 2 * np.pi, box) > 0
    scene.top_is_held = False
    return 0.0 if not grows and count(scene, 2 * np.pi, box) > 0 else np.inf


def check_unequal_half_spaces():
    """Without friction, generalised Rayleigh waves: the normal compliances of
    the half-spaces cancel. With it, one of them grows (Ranjith and Rice 2001)."""
    layers = inviscid(thickness=4.0), inviscid(thickness=4.0, young=5e7)
    scene = Scene(*layers, a=1e-12, mu=0.0)
    c_s = shear_speed(scene.lower)

    def compliance(c):
        total = 0.0
        for layer in layers:
            mu, lame = layer.moduli(0)
            p = np.sqrt(1 - c**2 * layer.density / (lame + 2 * mu))
            q = np.sqrt(1 - c**2 * layer.density / mu)
            total += p * (1 - q**2) / mu / (4 * p * q - (1 + q**2) ** 2)
        return total

    # From the Rayleigh waves of the softer one to its shear waves.
    low, high = 0.93 * c_s, c_s * (1 - 1e-9)
    sign = np.sign(compliance(low))
    while high - low > 1e-13 * c_s:
        c = (low + high) / 2
        low, high = (c, high) if np.sign(compliance(c)) == sign else (low, c)
    k = 2 * np.pi
    s = newton(scene, k, 1j * low * k * 0.999)
    scene.mu = 0.1
    grown = [newton(scene, k, sign * s * (1 + 0.001j)) for sign in (1, -1)]
    grows = [x.real > 1e-3 * abs(s) for x in grown]
    error = abs(s.imag / (low * k) - 1)
    return error if sum(grows) == 1 else np.inf


CHECKS = [
    ("column", check_column, 1e-6),
    ("Rayleigh waves", check_rayleigh, 1e-10),
    ("half-spaces without inertia", check_half_spaces, 1e-10),
    ("rate and state in layers", check_rate_and_state, 3e-4),
    ("no growth in symmetric scenes", check_symmetry, 1e-10),
    ("unequal half-spaces", check_unequal_half_spaces, 1e-5),
]


def check():
    good = True
    for name, function, tolerance in CHECKS:
        error = function()
        print(f"{name}: {error:.1e}{'' if error < tolerance else ' WRONG'}")
        good = good and error < tolerance
    return good


def set_attribute(scene, text):
    name, value = text.split("=")
    target = scene
    if "." in name:
        part, name = name.split(".")
        target = getattr(scene, part)
    old = getattr(target, name)
    if isinstance(old, bool):
        value = value == "true"
    setattr(target, name, type(old)(value))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--limits", action="store_true")
    parser.add_argument("--modes", type=int, default=3)
    parser.add_argument("--waves", type=int, default=3)
    parser.add_argument("settings", nargs="*", metavar="NAME=VALUE")
    arguments = parser.parse_args()
    if arguments.check:
        sys.exit(0 if check() else 1)
    if arguments.limits:
        print_limits()
        return
    scene = Scene()
    for text in arguments.settings:
        set_attribute(scene, text)
    for n in range(1, arguments.waves + 1):
        k = 2 * np.pi * n / scene.length
        for s in modes(scene, n)[: arguments.modes]:
            print(f"{n} {s.real:12.5f} {s.imag:12.4f} {residual(scene, k, s):.1e}")


if __name__ == "__main__":
    main()

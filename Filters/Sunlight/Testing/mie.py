# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scattering by homogeneous spheres (Mie), and the phase function of cloud droplets; `python mie.py` writes DropletPhaseFunction.h.

The series and the downward recurrence of the logarithmic derivative are those of Bohren and Huffman 1983 (4.53 to 4.62, 4.88, 4.89), the number of terms
that of Wiscombe 1980.
"""
import pathlib

import numpy as np

WAVELENGTH = 0.55  # micrometres
WATER = 1.333 + 1.96e-9j  # HaleQuerry1973
RADIUS, VARIANCE = 10.0, 0.1  # effective radius (micrometres) and variance of the gamma distribution of Hansen 1971
STEP = 0.25  # degrees


def coefficients(x, m):
    """a_n and b_n of a sphere with size parameter x and refractive index m."""
    count = int(x + 4.05 * x ** (1 / 3) + 2)
    n = np.arange(1, count + 1)
    inside = m * x
    derivative = np.zeros(int(max(count, 1.1 * abs(inside))) + 50, complex)
    for k in range(len(derivative) - 1, 0, -1):
        derivative[k - 1] = k / inside - 1 / (derivative[k] + k / inside)
    psi, chi = np.empty(count + 1), np.empty(count + 1)
    psi[0], chi[0] = np.sin(x), np.cos(x)
    before_psi, before_chi = np.cos(x), -np.sin(x)
    for k in n:
        psi[k] = (2 * k - 1) / x * psi[k - 1] - before_psi
        chi[k] = (2 * k - 1) / x * chi[k - 1] - before_chi
        before_psi, before_chi = psi[k - 1], chi[k - 1]
    xi = psi - 1j * chi
    d = derivative[1:count + 1]
    electric, magnetic = d / m + n / x, d * m + n / x
    a = (electric * psi[1:] - psi[:-1]) / (electric * xi[1:] - xi[:-1])
    b = (magnetic * psi[1:] - psi[:-1]) / (magnetic * xi[1:] - xi[:-1])
    return a, b


def efficiencies(x, m):
    """Efficiencies of extinction and scattering, the asymmetry parameter, and the efficiency of backscattering."""
    a, b = coefficients(x, m)
    n = np.arange(1, len(a) + 1)
    extinction = 2 / x**2 * np.sum((2 * n + 1) * (a + b).real)
    scattering = 2 / x**2 * np.sum((2 * n + 1) * (abs(a) ** 2 + abs(b) ** 2))
    k, pair = n[:-1], a[:-1] * a[1:].conj() + b[:-1] * b[1:].conj()
    asymmetry = 4 / (x**2 * scattering) * np.sum(k * (k + 2) / (k + 1) * pair.real)
    asymmetry += 4 / (x**2 * scattering) * np.sum((2 * n + 1) / (n * (n + 1)) * (a * b.conj()).real)
    back = abs(np.sum((2 * n + 1) * (-1.0) ** n * (a - b))) ** 2 / x**2
    return extinction, scattering, asymmetry, back


def intensity(x, m, cosine):
    """(|S1|^2 + |S2|^2) / 2 at scattering angles with these cosines."""
    a, b = coefficients(x, m)
    before, pi = np.zeros_like(cosine), np.ones_like(cosine)
    s1, s2 = np.zeros(cosine.shape, complex), np.zeros(cosine.shape, complex)
    for k in range(1, len(a) + 1):
        tau = k * cosine * pi - (k + 1) * before
        factor = (2 * k + 1) / (k * (k + 1))
        s1 += factor * (a[k - 1] * pi + b[k - 1] * tau)
        s2 += factor * (a[k - 1] * tau + b[k - 1] * pi)
        before, pi = pi, ((2 * k + 1) * cosine * pi - (k + 1) * before) / k
    return (abs(s1) ** 2 + abs(s2) ** 2) / 2


def droplet_phase_function(radius=RADIUS, variance=VARIANCE, wavelength=WAVELENGTH, step=STEP, sizes=1500):
    """Scattering angles (degrees) and the phase function, with the mean 1, of droplets in a gamma distribution."""
    angles = np.arange(0, 180 + step / 2, step)
    cosine = np.cos(np.radians(angles))
    r = np.linspace(0.02, 4, sizes) * radius
    number = r ** ((1 - 3 * variance) / variance) * np.exp(-r / (radius * variance))
    total, scattered = np.zeros_like(cosine), 0.0
    for each, share in zip(r, number / number.max()):
        if share > 1e-8:
            x = 2 * np.pi * each / wavelength
            total += share * intensity(x, WATER, cosine)
            scattered += share * x**2 * efficiencies(x, WATER)[1] / 4
    return angles, total / scattered


def integral(values, cosine):
    """By the trapezoidal rule, for descending cosines."""
    return np.sum((values[1:] + values[:-1]) / 2 * -np.diff(cosine))


def henyey_greenstein(g, cosine):
    return (1 - g**2) / (1 + g**2 - 2 * g * cosine) ** 1.5


def double_henyey_greenstein(angles, phase, asymmetry):
    """Two Henyey-Greenstein functions with this asymmetry parameter that fit the logarithm of a phase function best from 3 degrees on: the share of the first,
    and their parameters."""
    seen = angles >= 3
    cosine, logarithm = np.cos(np.radians(angles[seen])), np.log(phase[seen])

    def error(share, backward):
        forward = (asymmetry - (1 - share) * backward) / share
        two = share * henyey_greenstein(forward, cosine) + (1 - share) * henyey_greenstein(backward, cosine)
        return np.mean((np.log(two) - logarithm) ** 2) if forward < 1 else np.inf
    best = min(((share, backward) for share in np.arange(0.9, 1, 0.001) for backward in np.arange(-0.95, 0, 0.01)), key=lambda pair: error(*pair))
    return best[0], (asymmetry - (1 - best[0]) * best[1]) / best[0], best[1]


HEADER = """// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Phase function of cloud droplets in green light (0.55 micrometres), effective radius 10 micrometres, effective variance 0.1 (Hansen 1971), from 0 to 180
// degrees in steps of {step}. Written by Testing/mie.py.
#ifndef nephoscope_DropletPhaseFunction_h
#define nephoscope_DropletPhaseFunction_h

namespace nephoscope
{{
// Two Henyey-Greenstein functions (Kattawar 1975) with the same asymmetry parameter, fitted from 3 degrees on: the share of the first,
// and their asymmetry parameters.
constexpr double dropletForwardShare = {share:.6f}, dropletForward = {forward:.6f},
                 dropletBackward = {backward:.6f};

// clang-format off
constexpr float dropletPhaseFunction[] = {{
{values}
}};
// clang-format on
}}

#endif
"""


def table():
    """The phase function of droplets, its values below 4 degrees such that the trapezoidal rule gives the mean 1."""
    angles, phase = droplet_phase_function()
    cosine, inner = np.cos(np.radians(angles)), angles < 4
    middle = integral(np.where(inner, phase, 0), cosine) / 2
    phase[inner] *= 1 - (integral(phase, cosine) / 2 - 1) / middle
    return angles, phase


def main():
    angles, phase = table()
    cosine = np.cos(np.radians(angles))
    share, forward, backward = double_henyey_greenstein(angles, phase, integral(phase * cosine, cosine) / 2)
    rows = [", ".join(f"{value:.5g}f" if "." in f"{value:.5g}" or "e" in f"{value:.5g}" else f"{value:.5g}.0f" for value in phase[k:k + 14]) for k in range(0, len(phase), 14)]
    text = HEADER.format(step=STEP, share=share, forward=forward, backward=backward, values=",\n".join("  " + row for row in rows))
    (pathlib.Path(__file__).parent.parent / "PhaseFunctions" / "DropletPhaseFunction.h").write_text(text)


if __name__ == "__main__":
    main()

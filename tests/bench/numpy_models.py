"""The default three models with NumPy and SciPy: checks calibration.json, then prints both times and their ratio.

usage: numpy_models.py SWEEP.csv CALIBRATION.json BENCHMARK.json
"""
import csv
import json
import statistics
import sys
import time

import numpy as np
from scipy.interpolate import CubicSpline

GRID = 4096
STEPS = np.arange(GRID)
ANGLES = STEPS * 360 / GRID
SEGMENT, PART = STEPS * 32 // GRID, (STEPS * 32 % GRID) / GRID
BASE = np.zeros((GRID, 32))
BASE[STEPS, SEGMENT] += 1 - PART
BASE[STEPS, (SEGMENT + 1) % 32] += PART
BINS = STEPS * 64 // GRID


def read(path):
    rows = [row for row in csv.reader(open(path)) if row and not row[0].startswith("#")][1:]
    return np.array([[float(cell) for cell in row[:2]] for row in rows]).T


def wrapped(angle):
    return (angle + 180) % 360 - 180


def curve(encoder, sensor):
    order = np.argsort(sensor)
    x, y = sensor[order], encoder[order] - sensor[order]
    y = y[0] + np.concatenate([[0.0], np.cumsum(wrapped(np.diff(y)))])
    spline = CubicSpline(np.append(x, x[0] + 360), np.append(y, y[0]), bc_type="periodic")
    values = spline(np.where(ANGLES < x[0], ANGLES + 360, ANGLES))
    return values - 360 * np.floor((values.mean() + 180) / 360)


def models(encoder, sensor):
    """Offset and four largest harmonics, 32 segments, 64 bins, with the errors against curve and points."""
    values = curve(encoder, sensor)
    spectrum = np.fft.rfft(values)[:65] / GRID
    largest = 1 + np.argsort(-np.abs(spectrum[1:]))[:4]
    kept = np.zeros(GRID // 2 + 1, dtype=complex)
    kept[0] = spectrum[0]
    kept[largest] = spectrum[largest]
    linear = np.linalg.solve(BASE.T @ BASE, BASE.T @ values)
    table = np.bincount(BINS, values) / (GRID // 64)
    on_grid = [np.fft.irfft(kept, GRID) * GRID, BASE @ linear, table[BINS]]
    phases = np.exp(1j * np.outer(np.radians(sensor), largest))
    at_points = [
        spectrum[0].real + 2 * (phases * spectrum[largest]).real.sum(axis=1),
        np.interp(sensor % 360, np.arange(33) * 11.25, np.append(linear, linear[0])),
        table[(sensor % 360 * 64 / 360).astype(int)],
    ]
    errors = []
    for grid, points in zip(on_grid, at_points):
        on_curve, at = wrapped(grid - values), wrapped(sensor + points - encoder)
        errors.append((np.abs(on_curve).max(), np.sqrt((on_curve**2).mean()), np.abs(at).max(), np.sqrt((at**2).mean())))
    return spectrum, largest, linear, table, errors


def main():
    encoder, sensor = read(sys.argv[1])
    calibration = json.load(open(sys.argv[2]))
    ours = {run["aggregate_name"]: run for run in json.load(open(sys.argv[3]))["benchmarks"]}["median"]
    spectrum, _, linear, table, errors = models(encoder, sensor)
    harmonic, segments, bins = calibration["models"]
    difference = max(
        max(abs(h["amplitude_deg"] * np.exp(1j * h["phase_rad"]) - 2 * spectrum[h["order"]]) for h in harmonic["harmonics"]),
        np.abs(linear - segments["values_deg"]).max(),
        np.abs(table - bins["values_deg"]).max(),
        max(abs(error[0] - model["max_error_deg"]["curve"]) for error, model in zip(errors, calibration["models"])),
    )
    if difference > 1e-9:
        sys.exit(f"the two do not compute the same: largest difference {difference:.3g} degrees")
    times = []
    for _ in range(300):
        start = time.perf_counter()
        models(encoder, sensor)
        times.append(time.perf_counter() - start)
    theirs_us = statistics.median(times) * 1e6
    ours_us = ours["real_time"] * {"ns": 1e-3, "us": 1.0, "ms": 1e3}[ours["time_unit"]]
    print(f"same coefficients and errors to {difference:.1e} degrees")
    print(f"NumPy and SciPy {theirs_us:.1f} us, ours {ours_us:.1f} us: ratio 1/{theirs_us / ours_us:.1f} (goal: at most 1/20)")


main()

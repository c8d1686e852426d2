// Offset and harmonics: how they are chosen and evaluated.
#pragma once

#include "core/angle/harmonic_spectrum.h"
#include "core/angle/model.h"

#include <span>

namespace straightedge::angle {

/// Offset and the harmonics of the given orders, in that order.
HarmonicModel harmonicModelOf(const HarmonicSpectrum& spectrum, std::span<const int> orders);

/// Adds one harmonic at i·360/count to out[0 … count).
void addHarmonic(const HarmonicTerm& term, double* out, int count);

/// Correction at i·360/count, degrees.
void evaluateHarmonics(const HarmonicModel& model, double* out, int count);

double harmonicAt(const HarmonicModel& model, double readingDeg);

} // namespace straightedge::angle

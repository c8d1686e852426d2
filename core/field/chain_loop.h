// The loop over many readings, written once and built for each width of vector. Only for the sources that build it:
// everything has internal linkage, and no header with inline functions is used (see chain_coefficients.h).
#pragma once

#include "core/field/chain_coefficients.h"

#include <cstddef>

namespace straightedge::field {
namespace {

#if defined(__GNUC__)
template <std::size_t Bytes>
struct Lanes {
  typedef double Vector __attribute__((vector_size(Bytes))); // an alias would lose the size
  static constexpr std::size_t count = Bytes / sizeof(double);
  static Vector load(const double* from) {
    Vector vector;
    __builtin_memcpy(&vector, from, Bytes);
    return vector;
  }
  static void store(double* to, const Vector& vector) { __builtin_memcpy(to, &vector, Bytes); }
};
#else
template <std::size_t Bytes>
struct Lanes {
  using Vector = double;
  static constexpr std::size_t count = 1;
  static Vector load(const double* from) { return *from; }
  static void store(double* to, Vector vector) { *to = vector; }
};
#endif

/// Vectors on the way at the same time, so that one's latency is the others' time.
constexpr std::size_t together = 4;

template <class L>
struct Group {
  typename L::Vector v[together];
};

template <class L>
Group<L> load(const double* from) {
  Group<L> group;
  for (std::size_t k = 0; k < together; ++k) {
    group.v[k] = L::load(from + k * L::count);
  }
  return group;
}

template <class L>
Group<L> polynomial(const ChainPolynomial& p, const Group<L>& x) {
  Group<L> sum;
  for (std::size_t k = 0; k < together; ++k) {
    sum.v[k] = x.v[k] * 0.0 + p.values[p.count - 1];
  }
  for (std::size_t power = p.count - 1; power-- > 0;) {
    const double coefficient = p.values[power];
    for (std::size_t k = 0; k < together; ++k) {
      sum.v[k] = sum.v[k] * x.v[k] + coefficient;
    }
  }
  return sum;
}

template <class L>
Group<L> throughAxis(const AxisCoefficients& axis, const double* rawT, const Group<L>& probe,
                     const Group<L>& electronics) {
  Group<L> v = polynomial<L>(axis.nonlinearity, load<L>(rawT));
  for (std::size_t k = 0; k < together; ++k) {
    v.v[k] -= probe.v[k] * axis.offset1 + axis.offset0;
  }
  const Group<L> slope = polynomial<L>(axis.slope, v);
  const Group<L> intercept = polynomial<L>(axis.intercept, v);
  for (std::size_t k = 0; k < together; ++k) {
    v.v[k] -= slope.v[k] * probe.v[k] + intercept.v[k];
    v.v[k] -= electronics.v[k] * axis.electronics1 + axis.electronics0;
    v.v[k] -= (v.v[k] * axis.sensitivity1 + axis.sensitivity0) * electronics.v[k];
  }
  return v;
}

template <class L>
void correctColumns(const ChainCoefficients& c, const ChainColumns& columns) {
  static_assert(chainStep % (together * L::count) == 0);
  for (std::size_t at = 0; at < columns.count; at += together * L::count) {
    Group<L> probe = load<L>(columns.pt100Ohm + at);
    Group<L> electronics = load<L>(columns.electronicsC + at);
    for (std::size_t k = 0; k < together; ++k) {
      probe.v[k] = probe.v[k] * c.pt100Slope + c.pt100Intercept;
      electronics.v[k] -= c.referenceC;
    }
    const Group<L> x = throughAxis<L>(c.axes[0], columns.rawT[0] + at, probe, electronics);
    const Group<L> y = throughAxis<L>(c.axes[1], columns.rawT[1] + at, probe, electronics);
    const Group<L> z = throughAxis<L>(c.axes[2], columns.rawT[2] + at, probe, electronics);
    for (std::size_t row = 0; row < 3; ++row) {
      const double* m = c.inverse[row];
      for (std::size_t k = 0; k < together; ++k) {
        L::store(columns.fieldT[row] + at + k * L::count, x.v[k] * m[0] + y.v[k] * m[1] + z.v[k] * m[2]);
      }
    }
  }
}

} // namespace
} // namespace straightedge::field

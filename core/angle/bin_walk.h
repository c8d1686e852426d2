// Which samples of an evenly sampled turn belong to which of `size` equal bins or segments: sample i to ⌊i·size/count⌋.
#pragma once

namespace straightedge::angle {

/// First sample of bin k: the smallest i with ⌊i·size/count⌋ = k.
constexpr int firstOfBin(int k, int size, int count) {
  return static_cast<int>((static_cast<long long>(k) * count + size - 1) / size);
}

/// Goes from bin to bin without dividing. Needs size ≤ count and size·count below 2^31.
class BinWalk {
public:
  BinWalk(int size, int count) : m_size(size), m_count(count), m_whole(count / size) { measure(); }

  int first() const { return m_first; }     ///< sample the bin starts with
  int samples() const { return m_samples; } ///< at least one
  /// How far the first sample lies into the bin, in units of 1/count of the bin's width; sample j lies at into +
  /// j·size.
  int into() const { return m_into; }

  void next() {
    m_first += m_samples;
    m_into += m_samples * m_size - m_count;
    measure();
  }

private:
  void measure() { m_samples = m_whole + (m_into + m_whole * m_size < m_count ? 1 : 0); }

  int m_size, m_count, m_whole;
  int m_first = 0;
  int m_samples = 0;
  int m_into = 0;
};

} // namespace straightedge::angle

#include "app/gui/plots/ticks.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace straightedge::gui {
namespace {

const QChar minusSign(0x2212);

/// Smallest 1, 2 or 5 · 10ᵏ that is not below `atLeast`.
double niceStep(double atLeast) {
  const double decade = std::pow(10.0, std::floor(std::log10(atLeast)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    if (factor * decade >= atLeast * (1.0 - 1e-9)) {
      return factor * decade;
    }
  }
  return 10.0 * decade;
}

double chooseStep(double span, int maximumCount, std::optional<double> preferred) {
  const double atLeast = span / std::max(1, maximumCount - 1);
  const double nice = niceStep(atLeast);
  if (!preferred || !(*preferred > 0.0)) {
    return nice;
  }
  for (const double factor : {1.0 / 45.0, 1.0 / 9.0, 1.0 / 3.0, 1.0, 2.0, 4.0, 8.0}) {
    const double step = *preferred * factor;
    if (step >= atLeast * (1.0 - 1e-9)) {
      return span / step >= 2.0 ? step : nice;
    }
  }
  return nice;
}

/// Into how many parts minor ticks divide a step: never finer than the preferred step where that means something whole.
int minorParts(double step, std::optional<double> preferred) {
  if (preferred && *preferred > 0.0) {
    const double multiple = step / *preferred;
    if (multiple >= 1.0 - 1e-9) {
      const bool angle = std::abs(std::remainder(*preferred, 45.0)) < 1e-9;
      return multiple > 1.5 ? static_cast<int>(std::lround(multiple)) : (angle ? 3 : 1);
    }
  }
  const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
  return std::abs(mantissa - 2.0) < 0.1 ? 4 : 5;
}

QString withMinus(QString text) {
  if (text.startsWith(u'-')) {
    text[0] = minusSign;
  }
  return text;
}

QString fixedText(double value, int decimals) {
  const double unit = std::pow(10.0, -decimals);
  if (std::abs(value) < unit * 0.5) {
    value = 0.0; // no "-0"
  }
  return withMinus(QString::number(value, 'f', decimals));
}

int decimalsOf(double step) {
  for (int decimals = 0; decimals < 15; ++decimals) {
    const double scaled = step * std::pow(10.0, decimals);
    if (std::abs(scaled - std::round(scaled)) < 1e-6 * scaled) {
      return decimals;
    }
  }
  return 15;
}

/// An offset in full, "1700000000" rather than "1.7e+09", as long as it is of a size people read.
QString offsetText(double offset) {
  if (offset >= 1e15 || offset < 1e-3) {
    return QString::fromStdString(formatDouble(offset));
  }
  QString text = QString::number(offset, 'f', 15 - static_cast<int>(std::ceil(std::log10(offset))));
  while (text.contains(u'.') && (text.endsWith(u'0') || text.endsWith(u'.'))) {
    text.chop(1);
  }
  return text;
}

/// Labels as (value − offset) / 10^exponent, and the remark that says so.
void labelLinear(Ticks& ticks, double step, const AxisScale& scale) {
  double offset = 0.0;
  const double largest = std::max(std::abs(scale.minimum), std::abs(scale.maximum));
  if (largest / step >= 1e5) { // labels would need more than 5 digits: take out what they share
    const double coarse = std::pow(10.0, std::floor(std::log10(scale.span())) + 1.0);
    offset = std::round(0.5 * (scale.minimum + scale.maximum) / coarse) * coarse;
    if (std::abs(offset) < scale.span()) {
      offset = 0.0;
    }
  }
  const double reach = std::max(std::abs(scale.minimum - offset), std::abs(scale.maximum - offset));
  int exponent = 0;
  if (reach >= 1e5 || reach < 1e-3) {
    exponent = 3 * static_cast<int>(std::floor(std::log10(reach) / 3.0));
  }
  const double factor = std::pow(10.0, exponent);
  const int decimals = decimalsOf(step / factor);
  for (const double position : ticks.positions) {
    ticks.labels << fixedText((position - offset) / factor, decimals);
  }
  if (exponent != 0) {
    ticks.remark = QStringLiteral("× ") + powerOfTen(exponent);
  }
  if (offset != 0.0) {
    const QString amount = offsetText(std::abs(offset));
    ticks.remark += (ticks.remark.isEmpty() ? QString() : QStringLiteral(" ")) +
                    (offset < 0.0 ? QString(minusSign) : QStringLiteral("+")) + u' ' + amount;
  }
}

QString decadeLabel(int exponent, bool plain) {
  if (plain || (exponent >= -2 && exponent <= 3)) {
    return QString::number(std::pow(10.0, exponent), 'f', std::max(0, -exponent));
  }
  return powerOfTen(exponent);
}

QString logarithmicLabel(int mantissa, int exponent, bool plain) {
  if (mantissa == 1) {
    return decadeLabel(exponent, plain);
  }
  if (plain || (exponent >= -2 && exponent <= 3)) {
    return QString::number(mantissa * std::pow(10.0, exponent), 'f', std::max(0, -exponent));
  }
  return QString::number(mantissa) + u'·' + powerOfTen(exponent);
}

} // namespace

QString powerOfTen(int exponent) {
  static const std::array<QChar, 10> raised = {QChar(0x2070), QChar(0x00b9), QChar(0x00b2), QChar(0x00b3),
                                               QChar(0x2074), QChar(0x2075), QChar(0x2076), QChar(0x2077),
                                               QChar(0x2078), QChar(0x2079)};
  QString text = QStringLiteral("10");
  for (const QChar c : QString::number(exponent)) {
    text += c == u'-' ? QChar(0x207b) : raised.at(static_cast<std::size_t>(c.digitValue()));
  }
  return text;
}

Ticks linearTicks(const AxisScale& scale, int maximumCount, std::optional<double> preferredStep) {
  Ticks ticks;
  const double step = chooseStep(scale.span(), maximumCount, preferredStep);
  const double tolerance = scale.span() * 1e-9;
  const double first = std::ceil((scale.minimum - tolerance) / step);
  const double last = std::floor((scale.maximum + tolerance) / step);
  for (double k = first; k <= last && ticks.positions.size() < 200; k += 1.0) {
    ticks.positions << k * step;
  }
  labelLinear(ticks, step, scale);
  const int parts = minorParts(step, preferredStep);
  for (double k = (first - 1.0) * parts; k <= (last + 1.0) * parts && ticks.minor.size() < 1000; k += 1.0) {
    const double position = k * step / parts;
    if (std::fmod(k, parts) != 0.0 && position > scale.minimum && position < scale.maximum) {
      ticks.minor << position;
    }
  }
  return ticks;
}

Ticks logarithmicTicks(const AxisScale& scale, int maximumCount) {
  const double low = std::log10(scale.minimum);
  const double high = std::log10(scale.maximum);
  if (high - low < 0.8) {
    AxisScale linear = scale;
    linear.logarithmic = false;
    Ticks ticks = linearTicks(linear, maximumCount);
    ticks.minor.clear();
    return ticks;
  }
  Ticks ticks;
  const int firstDecade = static_cast<int>(std::floor(low - 1e-9));
  const int lastDecade = static_cast<int>(std::ceil(high + 1e-9));
  const double decades = high - low;
  const int every = std::max(1, static_cast<int>(std::ceil(decades / std::max(1, maximumCount - 1))));
  const bool plain = low >= -4.01 && high <= 4.99; // one way of writing for the whole axis
  // Labels at 1, 1-3, 1-2-5 of a decade, as many as there is room for.
  const bool oneTwoFive = every == 1 && decades * 3.0 <= maximumCount;
  const bool oneThree = every == 1 && !oneTwoFive && decades < 2.0 && decades * 2.0 <= maximumCount;
  const auto inside = [&scale](double v) { return v >= scale.minimum * (1 - 1e-9) && v <= scale.maximum * (1 + 1e-9); };
  for (int decade = firstDecade; decade <= lastDecade; ++decade) {
    for (int mantissa = 1; mantissa < 10; ++mantissa) {
      const double value = mantissa * std::pow(10.0, decade);
      if (!inside(value)) {
        continue;
      }
      const bool labelled = (mantissa == 1 && decade % every == 0) ||
                            (oneTwoFive && (mantissa == 2 || mantissa == 5)) || (oneThree && mantissa == 3);
      if (labelled) {
        ticks.positions << value;
        ticks.labels << logarithmicLabel(mantissa, decade, plain);
      } else if (every == 1 || mantissa == 1) {
        ticks.minor << value;
      }
    }
  }
  return ticks;
}

Ticks fittingTicks(const AxisScale& scale, double length, double gap, std::optional<double> preferredStep,
                   const std::function<double(const QString&)>& extent) {
  const auto make = [&](int count) {
    return scale.logarithmic ? logarithmicTicks(scale, count) : linearTicks(scale, count, preferredStep);
  };
  const auto fits = [&](const Ticks& ticks, double between) {
    for (qsizetype i = 1; i < ticks.positions.size(); ++i) {
      const double distance = (scale.toUnit(ticks.positions[i]) - scale.toUnit(ticks.positions[i - 1])) * length;
      if (distance < 0.5 * (extent(ticks.labels[i]) + extent(ticks.labels[i - 1])) + between) {
        return false;
      }
    }
    return ticks.positions.size() >= 2;
  };
  const int most = std::clamp(static_cast<int>(length / std::max(8.0, gap)) + 1, 2, preferredStep ? 20 : 12);
  for (int count = most; count >= 2; --count) {
    const Ticks ticks = make(count);
    if (fits(ticks, gap)) {
      return ticks;
    }
  }
  for (int count = 3; count <= 12; ++count) { // coarse steps may all but miss a short axis: two labels matter more
    const Ticks ticks = make(count);
    if (fits(ticks, 2.0)) {
      return ticks;
    }
  }
  Ticks ticks = make(2);
  for (qsizetype i = 1; i < ticks.labels.size(); ++i) { // no room at all: the first label only
    ticks.labels[i].clear();
  }
  return ticks;
}

QString readableValue(double value, const AxisScale& scale) {
  if (!std::isfinite(value)) {
    return QStringLiteral("–");
  }
  const double span = scale.logarithmic ? std::abs(value) : scale.span();
  const double resolution = span * 1e-4;
  const double size = std::abs(value);
  const int significant =
      size > 0.0 ? std::clamp(static_cast<int>(std::ceil(std::log10(size / resolution))) + 1, 1, 16) : 1;
  QString text;
  if (size != 0.0 && (size >= 1e7 || size < 1e-4) && significant < 8) {
    text = QString::number(value, 'e', std::max(0, significant - 1));
    const qsizetype mark = text.indexOf(u'e');
    QString mantissa = text.left(mark);
    if (mantissa.contains(u'.')) {
      while (mantissa.endsWith(u'0')) {
        mantissa.chop(1);
      }
      if (mantissa.endsWith(u'.')) {
        mantissa.chop(1);
      }
    }
    return withMinus(mantissa + QStringLiteral(" × ") + powerOfTen(text.mid(mark + 1).toInt()));
  }
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(resolution))), 0, 15);
  text = QString::number(value, 'f', decimals);
  if (text.contains(u'.')) {
    while (text.endsWith(u'0')) {
      text.chop(1);
    }
    if (text.endsWith(u'.')) {
      text.chop(1);
    }
  }
  return text == QStringLiteral("-0") ? QStringLiteral("0") : withMinus(text);
}

} // namespace straightedge::gui

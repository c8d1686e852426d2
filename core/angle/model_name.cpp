#include "core/angle/model_name.h"

#include "core/angle/model_limits.h"
#include "core/base/number_text.h"

#include <array>

namespace straightedge::angle {

namespace {

constexpr std::array allKinds = {ModelKind::Harmonic, ModelKind::Linear, ModelKind::LookupTable};
constexpr std::array allMethods = {FitMethod::ByAmplitude, FitMethod::Ordered, FitMethod::LeastSquares,
                                   FitMethod::OnCurve,     FitMethod::Minimax, FitMethod::Mean,
                                   FitMethod::MidRange};

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

std::unexpected<Error> wrongName(std::string_view name, const std::string& what, std::string remedy) {
  return fail(ErrorKind::Usage, "model " + quoted(name) + ": " + what, std::move(remedy));
}

std::string methodsOf(ModelKind kind) {
  std::string list;
  for (const FitMethod method : allMethods) {
    if (methodBelongsTo(method, kind)) {
      list += (list.empty() ? "@" : " or @") + std::string(methodText(method));
    }
  }
  return list;
}

std::optional<ModelKind> kindOf(std::string_view text) {
  for (const ModelKind kind : allKinds) {
    if (text == kindText(kind)) {
      return kind;
    }
  }
  return std::nullopt;
}

std::optional<FitMethod> methodOf(std::string_view text, ModelKind kind) {
  for (const FitMethod method : allMethods) {
    if (methodBelongsTo(method, kind) && text == methodText(method)) {
      return method;
    }
  }
  return std::nullopt;
}

} // namespace

const char* kindText(ModelKind kind) {
  switch (kind) {
  case ModelKind::Harmonic:
    return "harmonic";
  case ModelKind::Linear:
    return "linear";
  case ModelKind::LookupTable:
    return "lut";
  }
  return "";
}

const char* methodText(FitMethod method) {
  switch (method) {
  case FitMethod::ByAmplitude:
    return "amplitude";
  case FitMethod::Ordered:
    return "ordered";
  case FitMethod::LeastSquares:
    return "least-squares";
  case FitMethod::OnCurve:
    return "on-curve";
  case FitMethod::Minimax:
    return "minimax";
  case FitMethod::Mean:
    return "mean";
  case FitMethod::MidRange:
    return "midrange";
  }
  return "";
}

FitMethod defaultMethod(ModelKind kind) {
  switch (kind) {
  case ModelKind::Harmonic:
    return FitMethod::ByAmplitude;
  case ModelKind::Linear:
    return FitMethod::LeastSquares;
  case ModelKind::LookupTable:
    return FitMethod::Mean;
  }
  return FitMethod::ByAmplitude;
}

bool methodBelongsTo(FitMethod method, ModelKind kind) {
  switch (method) {
  case FitMethod::ByAmplitude:
  case FitMethod::Ordered:
    return kind == ModelKind::Harmonic;
  case FitMethod::LeastSquares:
  case FitMethod::OnCurve:
  case FitMethod::Minimax:
    return kind == ModelKind::Linear;
  case FitMethod::Mean:
  case FitMethod::MidRange:
    return kind == ModelKind::LookupTable;
  }
  return false;
}

Result<ModelName> checkedModelName(const ModelName& name) {
  const std::string text = name.text();
  if (!methodBelongsTo(name.method, name.kind)) {
    return wrongName(text, "unknown method " + quoted(methodText(name.method)), "use " + methodsOf(name.kind));
  }
  const SizeRange range = sizeRange(name.kind);
  if (name.size < range.smallest || name.size > range.largest) {
    return wrongName(text, "size " + std::to_string(name.size) + " is out of range",
                     "use " + std::to_string(range.smallest) + " to " + std::to_string(range.largest));
  }
  if (name.bits && (*name.bits < smallestBits || *name.bits > largestBits)) {
    return wrongName(text, "cannot store in " + std::to_string(*name.bits) + " bits",
                     "use /" + std::to_string(smallestBits) + " to /" + std::to_string(largestBits));
  }
  return name;
}

Result<ModelName> parseModelName(std::string_view text) {
  const auto colon = text.find(':');
  const auto kind = kindOf(text.substr(0, colon));
  if (!kind) {
    return wrongName(text, "unknown kind " + quoted(text.substr(0, colon)),
                     "use harmonic:N, linear:N or lut:N, as in linear:32");
  }
  if (colon == std::string_view::npos) {
    return wrongName(text, "the size is missing", "write " + std::string(kindText(*kind)) + ":N, as in linear:32");
  }
  ModelName name;
  name.kind = *kind;
  name.method = defaultMethod(*kind);
  std::string_view rest = text.substr(colon + 1);
  if (const auto slash = rest.find('/'); slash != std::string_view::npos) {
    const auto bits = parseInt(rest.substr(slash + 1));
    if (!bits) {
      return wrongName(text, quoted(rest.substr(slash + 1)) + " is not a number of bits",
                       "use /" + std::to_string(smallestBits) + " to /" + std::to_string(largestBits));
    }
    name.bits = bits;
    rest = rest.substr(0, slash);
  }
  if (const auto at = rest.find('@'); at != std::string_view::npos) {
    const auto method = methodOf(rest.substr(at + 1), *kind);
    if (!method) {
      return wrongName(text, "unknown method " + quoted(rest.substr(at + 1)), "use " + methodsOf(*kind));
    }
    name.method = *method;
    rest = rest.substr(0, at);
  }
  const auto size = parseInt(rest);
  if (!size) {
    const SizeRange range = sizeRange(*kind);
    return wrongName(text, quoted(rest) + " is not a size",
                     "use a whole number from " + std::to_string(range.smallest) + " to " +
                         std::to_string(range.largest));
  }
  name.size = *size;
  return checkedModelName(name);
}

int ModelName::storageBytes() const {
  const int entries = storageEntries();
  return bits ? (entries * *bits + 7) / 8 : entries * 4;
}

std::string ModelName::text() const {
  std::string result = std::string(kindText(kind)) + ":" + std::to_string(size);
  if (method != defaultMethod(kind)) {
    result += std::string("@") + methodText(method);
  }
  if (bits) {
    result += "/" + std::to_string(*bits);
  }
  return result;
}

std::string ModelName::fileStem() const {
  std::string result = std::string(kindText(kind)) + "-" + std::to_string(size);
  if (method != defaultMethod(kind)) {
    result += std::string("-") + methodText(method);
  }
  if (bits) {
    result += "-" + std::to_string(*bits) + "bit";
  }
  return result;
}

std::vector<ModelName> defaultModels() {
  return {ModelName{ModelKind::Harmonic, 4, FitMethod::ByAmplitude, {}},
          ModelName{ModelKind::Linear, 32, FitMethod::LeastSquares, {}},
          ModelName{ModelKind::LookupTable, 64, FitMethod::Mean, {}}};
}

} // namespace straightedge::angle

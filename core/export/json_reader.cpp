#include "core/export/json_reader.h"

#include <algorithm>
#include <cmath>

namespace straightedge::exporting {

using nlohmann::json;

Result<json> parseJson(std::string_view text, const std::string& name, std::string_view remedyText) {
  const std::string remedy(remedyText);
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return fail(ErrorKind::Input, "the file is empty", remedy, name);
  }
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    const std::size_t position = std::min(error.byte == 0 ? 0 : error.byte - 1, text.size());
    const auto before = text.substr(0, position);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const auto lineBegin = before.find_last_of('\n');
    const std::size_t column = position - (lineBegin == std::string_view::npos ? 0 : lineBegin + 1) + 1;
    const std::string what = position >= text.size() ? "the file ends too early, it is not complete JSON"
                                                     : "this is not JSON at column " + std::to_string(column);
    return fail(ErrorKind::Input, what, remedy, name + ":" + std::to_string(line));
  } catch (const json::exception&) {
    return fail(ErrorKind::Input, "a number is too large to be read", remedy, name);
  }
}

JsonNode JsonNode::optional(std::string_view key) const {
  JsonNode child{.value = nullptr, .path = path.empty() ? std::string(key) : path + "." + std::string(key)};
  if (value != nullptr && value->is_object()) {
    const auto found = value->find(std::string(key));
    if (found != value->end() && !found->is_null()) {
      child.value = &*found;
    }
  }
  return child;
}

JsonNode JsonNode::item(std::size_t index) const {
  return {.value = &(*value)[index], .path = path + "[" + std::to_string(index) + "]"};
}

void JsonReader::blame(std::string what, std::string remedy) {
  if (!m_problem) {
    m_problem = Error{.kind = ErrorKind::Input, .what = std::move(what), .remedy = std::move(remedy), .where = m_name};
  }
}

void JsonReader::wrongType(const JsonNode& node, std::string_view wanted) {
  blame((node.path.empty() ? "the file" : node.path) + " is a JSON " + node.value->type_name() + " instead of " +
        std::string(wanted));
}

JsonNode JsonReader::required(const JsonNode& parent, std::string_view key) {
  JsonNode child = parent.optional(key);
  if (!child) {
    blame(child.path + " is missing");
  }
  return child;
}

bool JsonReader::requireObject(const JsonNode& node) {
  if (node && !node.value->is_object()) {
    wrongType(node, "an object");
    return false;
  }
  return static_cast<bool>(node);
}

JsonNode JsonReader::object(const JsonNode& parent, std::string_view key) {
  JsonNode child = required(parent, key);
  if (!requireObject(child)) {
    child.value = nullptr;
  }
  return child;
}

JsonNode JsonReader::list(const JsonNode& parent, std::string_view key) {
  JsonNode child = required(parent, key);
  if (child && !child.value->is_array()) {
    wrongType(child, "a list");
    child.value = nullptr;
  }
  return child;
}

double JsonReader::number(const JsonNode& parent, std::string_view key) { return asNumber(required(parent, key)); }

long long JsonReader::integer(const JsonNode& parent, std::string_view key, long long least, long long most) {
  return asInteger(required(parent, key), least, most);
}

double JsonReader::asNumber(const JsonNode& node) {
  if (!node) {
    return 0.0;
  }
  if (!node.value->is_number()) {
    wrongType(node, "a number");
    return 0.0;
  }
  const auto number = node.value->get<double>();
  if (!std::isfinite(number)) {
    blame(node.path + " is not a finite number");
    return 0.0;
  }
  return number;
}

long long JsonReader::asInteger(const JsonNode& node, long long least, long long most) {
  const double number = asNumber(node);
  if (!node || m_problem) {
    return least;
  }
  if (std::floor(number) != number || number < static_cast<double>(least) || number > static_cast<double>(most)) {
    blame(node.path + " is " + node.value->dump() + " but must be a whole number from " + std::to_string(least) +
          " to " + std::to_string(most));
    return least;
  }
  return static_cast<long long>(number);
}

std::string JsonReader::text(const JsonNode& parent, std::string_view key) {
  const JsonNode child = required(parent, key);
  if (!child) {
    return {};
  }
  if (!child.value->is_string()) {
    wrongType(child, "text");
    return {};
  }
  return child.value->get<std::string>();
}

bool JsonReader::truth(const JsonNode& parent, std::string_view key) {
  const JsonNode child = required(parent, key);
  if (!child) {
    return false;
  }
  if (!child.value->is_boolean()) {
    wrongType(child, "true or false");
    return false;
  }
  return child.value->get<bool>();
}

} // namespace straightedge::exporting

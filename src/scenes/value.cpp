#include "scenes/value.hpp"

#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "base/error.hpp"
#include "base/nearest_name.hpp"

namespace sph {

Accepted Accepted::Any() { return {std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()}; }
Accepted Accepted::Positive() { return {0, std::numeric_limits<double>::max(), true}; }
Accepted Accepted::NotNegative() { return {0, std::numeric_limits<double>::max()}; }

std::string Accepted::InWords() const {
  const bool bounded_below = least > std::numeric_limits<double>::lowest();
  const bool bounded_above = greatest < std::numeric_limits<double>::max();
  std::string words = "a finite number";
  if (bounded_below) words += fmt::format(" {} {}", open ? ">" : ">=", least);
  if (bounded_above) words += fmt::format("{} <= {}", bounded_below ? " and" : "", greatest);
  return words;
}

Value::Value(const toml::node& node, std::string key, std::string source)
    : node_(node), key_(std::move(key)), source_(std::move(source)) {}

std::string Value::Place() const {
  const toml::source_position place = node_.source().begin;
  return source_.starts_with("--") ? source_ : fmt::format("{}:{}:{}", source_, place.line, place.column);
}

void Value::Refuse(const std::string& accepted) const {
  std::ostringstream found;
  if (const auto* text = node_.as_string()) {
    found << '\'' << text->get() << '\'';
  } else {
    node_.visit([&](const auto& node) { found << node; });
  }
  throw UsageError("{}: {} = {} is not accepted; it takes {}", Place(), key_, found.str(), accepted);
}

double Value::AsNumber(const Accepted& accepted) const {
  const auto number = node_.is_number() ? node_.value<double>() : std::nullopt;
  if (!number || !std::isfinite(*number) || !accepted.Holds(*number)) Refuse(accepted.InWords());
  return *number;
}

std::int64_t Value::AsInteger(std::int64_t least, std::int64_t greatest) const {
  const auto* integer = node_.as_integer();
  if (integer == nullptr || integer->get() < least || integer->get() > greatest) {
    Refuse(fmt::format("a whole number from {} to {}", least, greatest));
  }
  return integer->get();
}

std::string Value::AsText() const {
  const auto* text = node_.as_string();
  if (text == nullptr) Refuse("a text in quotes");
  return text->get();
}

bool Value::AsFlag() const {
  const auto* flag = node_.as_boolean();
  if (flag == nullptr) Refuse("true or false");
  return flag->get();
}

std::vector<double> Value::AsNumbers(std::size_t count, const std::string& accepted) const {
  const auto* array = node_.as_array();
  if (array == nullptr || array->size() != count) Refuse(accepted);
  std::vector<double> numbers;
  for (const toml::node& element : *array) {
    const auto number = element.is_number() ? element.value<double>() : std::nullopt;
    if (!number || !std::isfinite(*number)) Refuse(accepted);
    numbers.push_back(*number);
  }
  return numbers;
}

Vec2 Value::AsVec2() const {
  const auto v = AsNumbers(2, "two finite numbers [x, y]");
  return {v[0], v[1]};
}

Box Value::AsBox() const {
  const std::string accepted = "four finite numbers [x0, y0, x1, y1] with x0 < x1 and y0 < y1";
  const auto v = AsNumbers(4, accepted);
  if (!(v[0] < v[2] && v[1] < v[3])) Refuse(accepted);
  return {v[0], v[1], v[2], v[3]};
}

std::size_t Value::AsChoice(std::span<const std::string> names) const {
  const std::string text = AsText();
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == text) return k;
  }
  Refuse(fmt::format("one of: {}.{}", fmt::join(names, ", "), DidYouMean(text, names)));
}

}  // namespace sph

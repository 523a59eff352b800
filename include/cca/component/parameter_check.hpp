// Checks the values of a parameters struct: each has one, each number is finite and in its range, each choice
// has a name, and the struct's own `check()` agrees. Runs between beats, where it may allocate.
#pragma once

#include <charconv>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/compiler.hpp>
#include <cca/component/schema.hpp>

namespace cca::detail {

// ---- parameters without a value ----
//
// BOOST_HANA_DEFINE_STRUCT gives its fields none, so a plain number, bool, enumeration or Eigen vector has
// one only if the component states it: `parameters p{1.5};`. A controller fills the place of the parameters
// with a mark before it constructs the component (runtime/state.hpp). Where the mark is still there when they
// are checked, nobody has written a value. An integer of one or two bytes is not looked at: its value may
// well be the mark. Cost: some stores where a controller is constructed, nothing in a beat.

inline constexpr unsigned char unset_mark = 0xA5;  // no bool, and of no enumeration that has names

// Only of a type that does not state its own first value, as `bounded`, `quantity` and `text` do.
constexpr bool may_be_unset(const schema& type) {
  switch (type.what) {
    case kind::boolean:
    case kind::choice:
      return true;
    case kind::integer:
      return !type.stated_range && type.bytes > 2;
    case kind::number:
      return !type.stated_range;
    case kind::array:
      return may_be_unset(*type.element);
    case kind::table:
      for (std::size_t i = 0; i < type.count; ++i)
        if (may_be_unset(*type.members[i].type)) return true;
      return false;
    default:
      return false;
  }
}

// Of a number, a bool, an enumeration.
inline bool is_unset(const schema& type, const void* value) {
  if (type.bytes == 0 || !may_be_unset(type)) return false;
  const auto* const at = static_cast<const unsigned char*>(value);
  for (std::size_t i = 0; i < type.bytes; ++i)
    if (at[i] != unset_mark) return false;
  return true;
}

// Not of a component whose parameters are in a virtual base: its constructor finds their place.
template <class Component> concept MayLeaveUnset = requires(typename Component::parameters& p) {
  static_cast<typename Component::parameters Component::*>(&Component::p);
  requires may_be_unset(schema_of<typename Component::parameters>);
};

// Before the component at this place is constructed.
struct parameters_marked {
  template <class Component>
  explicit parameters_marked(Component* at) {
    constexpr typename Component::parameters Component::* member = &Component::p;
    void* const p = std::addressof(at->*member);
    std::memset(p, unset_mark, sizeof(typename Component::parameters));
    forget_content(p);
  }
};

// ---- values ----

struct complaint {
  std::string path, what;
};

inline std::string number_text(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

inline std::string number_text(const schema& type, double value) {
  if (!type.single) return number_text(value);
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, static_cast<float>(value)).ptr};
}

inline std::string with_unit(std::string text, const schema& type) {
  return type.unit.empty() ? text : text.append(" ").append(type.unit);
}

// "0.1 to 5", "at least 0 rad"; empty if every number is allowed.
inline std::string range_text(const schema& type) {
  if (type.what == kind::integer) return std::to_string(type.lowest) + " to " + std::to_string(type.highest);
  const double all = type.single ? static_cast<double>(std::numeric_limits<float>::max()) : largest_double;
  const bool below = type.lower > -all, above = type.upper < all;
  const std::string from = number_text(type, type.lower), to = number_text(type, type.upper);
  if (!below && !above) return {};
  if (!above) return with_unit("at least " + from, type);
  if (!below) return with_unit("at most " + to, type);
  return with_unit(from + " to " + to, type);
}

// "flat, slope or steps"
inline std::string names_text(const schema& type) {
  std::string text;
  std::size_t last = 0;
  for (std::size_t i = 0; i < type.count; ++i)
    if (!type.names[i].empty()) last = i;
  for (std::size_t i = 0; i < type.count; ++i)
    if (!type.names[i].empty())
      text.append(text.empty() ? "" : i == last ? " or " : ", ").append(type.names[i]);
  return text;
}

// What is wrong with a number; empty if nothing is. `shown` is the number as the user wrote it.
inline std::string number_complaint(const schema& type, double value, const std::string& shown) {
  if (value >= type.lower && value <= type.upper) return {};
  const std::string range = range_text(type);
  if (!std::isfinite(value))
    return shown + " is not allowed, expected " + (range.empty() ? "a finite number" : range);
  return range.empty() ? shown + " is too large for a float" : shown + " is out of range, expected " + range;
}

inline std::string integer_complaint(const schema& type, std::int64_t value) {
  if (value >= type.lowest && value <= type.highest) return {};
  return std::to_string(value) + " is out of range, expected " + range_text(type);
}

// A TOML file is UTF-8, so it can't hold any other text.
constexpr bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i++]);
    const int more = lead < 0x80                   ? 0
                     : lead >= 0xC2 && lead < 0xE0 ? 1
                     : lead >= 0xE0 && lead < 0xF0 ? 2
                     : lead >= 0xF0 && lead < 0xF5 ? 3
                                                   : -1;
    if (more < 0) return false;
    for (int k = 0; k < more; ++k, ++i) {
      const auto next = i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
      const bool overlong = k == 0 && ((lead == 0xE0 && next < 0xA0) || (lead == 0xF0 && next < 0x90));
      const bool outside = k == 0 && ((lead == 0xED && next > 0x9F) || (lead == 0xF4 && next > 0x8F));
      if ((next & 0xC0) != 0x80 || overlong || outside) return false;
    }
  }
  return true;
}

inline std::string value_complaint(const schema& type, const void* value) {
  if (is_unset(type, value))
    return "has no value: give it a default, as in `parameters p{...};`, or set it before load()";
  switch (type.what) {
    case kind::integer:
      return integer_complaint(type, type.integer(value));
    case kind::number:
      return number_complaint(type, type.number(value),
                              with_unit(number_text(type, type.number(value)), type));
    case kind::choice: {
      const std::int64_t i = type.integer(value);
      if (i >= 0 && i < static_cast<std::int64_t>(type.count) && !type.names[i].empty()) return {};
      return "the value " + std::to_string(i) + " has no name, expected " + names_text(type);
    }
    case kind::text:
      return is_utf8(type.characters(value)) ? "" : "the text is not UTF-8";
    default:
      return {};
  }
}

inline std::string member_path(const std::string& table, std::string_view name) {
  return table.empty() ? std::string(name) : std::string(table).append(".").append(name);
}

inline std::string element_path(const std::string& array, std::size_t i) {
  return array + "[" + std::to_string(i) + "]";
}

// Calls a struct's own check() only if all fields are allowed, so check() never sees NaN. A template, like
// `refuse`, so it is compiled only where parameters are checked.
template <class Complaints>
void check(const schema& type, const void* value, const std::string& path, Complaints& found) {
  const std::size_t before = found.size();
  if (type.what == kind::table) {
    for (std::size_t i = 0; i < type.count; ++i)
      check(*type.members[i].type, type.members[i].of(value), member_path(path, type.members[i].name), found);
    if (!type.complaint || found.size() != before) return;
    if (auto what = type.complaint(value); !what.empty()) found.push_back({path, std::move(what)});
  } else if (type.what == kind::array) {
    for (std::size_t i = 0; i < type.count; ++i)
      check(*type.element, type.at(value, i), element_path(path, i), found);
  } else if (auto what = value_complaint(type, value); !what.empty()) {
    found.push_back({path, std::move(what)});
  }
}

}  // namespace cca::detail

// All parameters of a controller as numbered fields: what the page's forms show and set.
//
// A value is checked as one from a file, and by all that `controller::set` asks. A refused value changes
// nothing.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/math/roots.hpp>
#include <cca/component/parameters.hpp>

#include "json_text.hpp"

namespace cca::page {

using detail::kind;
using detail::schema;

// Calls f(type, value, path) for each number, choice and bool in a parameters struct.
template <class F>
void each_field(const schema& type, const void* value, const std::string& path, F& f) {
  if (type.what == kind::table) {
    for (std::size_t i = 0; i < type.count; ++i)
      page::each_field(*type.members[i].type, type.members[i].of(value),
                       detail::member_path(path, type.members[i].name), f);
  } else if (type.what == kind::array) {
    for (std::size_t i = 0; i < type.count; ++i)
      page::each_field(*type.element, type.at(value, i), detail::element_path(path, i), f);
  } else if (type.what != kind::text && type.what != kind::unsupported) {
    f(type, value, path);
  }
}

inline double number_of(const schema& type, const void* value) {
  return type.what == kind::number ? type.number(value) : static_cast<double>(type.integer(value));
}

inline void add_field(json_text& json, const schema& type, const void* value, const std::string& path) {
  json.open('{').key("path").add(path).key("value").add(number_of(type, value));
  if (type.what == kind::boolean) json.key("kind").add("boolean");
  if (type.what == kind::choice) {
    json.key("kind").add("choice").key("names").open('[');
    for (std::size_t i = 0; i < type.count; ++i) json.add(type.names[i]);
    json.close(']');
  }
  if (type.what == kind::integer) {
    json.key("kind").add("integer");
    if (type.stated_range)
      json.key("lower")
          .add(static_cast<double>(type.lowest))
          .key("upper")
          .add(static_cast<double>(type.highest));
  }
  if (type.what == kind::number) {
    json.key("kind").add("number").key("unit").add(type.unit);
    if (type.stated_range) json.key("lower").add(type.lower).key("upper").add(type.upper);
    json.key("units").open('[');
    for (const unit* u = type.units; u && !u->text.empty(); ++u)
      json.open('{').key("text").add(u->text).key("factor").add(u->factor).close('}');
    json.close(']');
  }
  json.close('}');
}

template <class Controller>
void add_parameters(json_text& json, const Controller& c) {
  json.key("parameters").open('[');
  const auto add = [&](const schema& type, const void* value, const std::string& path) {
    add_field(json, type, value, path);
  };
  c.for_each_component([&]<class C>(std::string_view path, const C& component) {
    if constexpr (HasParameters<C>)
      page::each_field(detail::schema_of<typename C::parameters>, &component.p, std::string(path), add);
  });
  json.close(']');
}

template <class Controller>
std::vector<double> parameter_values(const Controller& c) {
  std::vector<double> all;
  const auto add = [&](const schema& type, const void* value, const std::string&) {
    all.push_back(number_of(type, value));
  };
  c.for_each_component([&]<class C>(std::string_view path, const C& component) {
    if constexpr (HasParameters<C>)
      page::each_field(detail::schema_of<typename C::parameters>, &component.p, std::string(path), add);
  });
  return all;
}

// A number that no field of this type can hold; empty: it can.
inline std::string put(const schema& type, void* value, double number) {
  if (type.what == kind::number) {
    type.set_number(value, number);
    return {};
  }
  if (!(std::abs(number) < 9e15) || number != cca::math::floor(number)) return "expected a whole number";
  const auto whole = static_cast<std::int64_t>(number);
  if (type.what == kind::integer)
    if (auto what = detail::integer_complaint(type, whole); !what.empty()) return what;
  if (type.what == kind::choice && (whole < 0 || whole >= static_cast<std::int64_t>(type.count)))
    return "expected " + detail::names_text(type);
  type.set_integer(value, whole);
  return {};
}

// Sets the field with this number. What it returns is the reason of a refusal; empty: it is set.
template <class Controller>
std::string set_field(Controller& c, int wanted, double number) {
  std::string refusal = "there is no such parameter";
  int next = 0;
  c.for_each_component([&]<class C>(std::string_view path, C& component) {
    if constexpr (HasParameters<C>) {
      auto copy = component.p;
      bool is_here = false;
      std::string field, problem;
      const auto set = [&](const schema& type, const void* value, const std::string& its_path) {
        if (next++ != wanted) return;
        is_here = true;
        field = its_path;
        problem = put(type, const_cast<void*>(value), number);
      };
      page::each_field(detail::schema_of<typename C::parameters>, &copy, std::string(path), set);
      if (!is_here) return;
      if (!problem.empty()) {
        refusal = field + ": " + problem;
        return;
      }
      refusal.clear();
      for (const auto& one : detail::complaints_of(component, copy, path, c.step_of(path)))
        refusal.append(refusal.empty() ? "" : "\n").append(one.path).append(one.path.empty() ? "" : ": ") +=
            one.what;
      if (refusal.empty()) component.p = copy;
    }
  });
  return refusal;
}

}  // namespace cca::page

// Members of a JSON object that another program has sent: what is missing, or of another type, is the
// default.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace cca_door {

using json = nlohmann::json;

inline const json& member(const json& of, const char* name) {
  static const json none;
  if (!of.is_object()) return none;
  const auto found = of.find(name);
  return found == of.end() ? none : *found;
}
inline std::string text_in(const json& of, const char* name) {
  const json& one = member(of, name);
  return one.is_string() ? one.get<std::string>() : std::string();
}
inline double number_in(const json& of, const char* name, double otherwise = 0) {
  const json& one = member(of, name);
  return one.is_number() ? one.get<double>() : otherwise;
}
inline std::int64_t whole_in(const json& of, const char* name) {
  const json& one = member(of, name);
  return one.is_number_integer() ? one.get<std::int64_t>() : 0;
}
inline bool is_set(const json& of, const char* name) {
  const json& one = member(of, name);
  return one.is_boolean() && one.get<bool>();
}
// A list; empty: there is none.
inline const json& list_in(const json& of, const char* name) {
  static const json none = json::array();
  const json& one = member(of, name);
  return one.is_array() ? one : none;
}
inline std::vector<std::string> texts_in(const json& of, const char* name) {
  std::vector<std::string> all;
  for (const json& one : list_in(of, name))
    if (one.is_string()) all.push_back(one.get<std::string>());
  return all;
}

// What another program sent may be no UTF-8: then its bytes are replaced.
inline std::string written(const json& one, int indentation = -1) {
  return one.dump(indentation, ' ', false, json::error_handler_t::replace);
}

}  // namespace cca_door

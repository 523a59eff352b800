// Names of C++ from names of URDF: letters, digits and single underscores, no keyword, no macro, each once.
//
// The names of joints are also those of axes and ports, so they must not be those of the robot's other nodes.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "taken/globals.hpp"

namespace cca_urdf {

inline bool is_keyword(std::string_view word) {
  static constexpr std::array<std::string_view, 92> all{
      "alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
      "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char16_t",
      "char32_t",    "char8_t",  "class",      "co_await",  "co_return", "co_yield",     "compl",
      "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
      "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
      "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
      "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
      "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
      "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
      "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
      "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
      "true",        "try",      "typedef",    "typeid",    "typename",  "union",        "unsigned",
      "using",       "virtual",  "void",       "volatile",  "wchar_t",   "while",        "xor",
      "xor_eq"};
  return std::ranges::find(all, word) != all.end();
}

inline std::string identifier_of(std::string_view name) {
  std::string id;
  for (const char c : name) {
    const bool fits = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (fits) id += c;
    else if (!id.empty() && id.back() != '_') id += '_';
  }
  while (!id.empty() && id.back() == '_') id.pop_back();
  if (id.empty() || (id[0] >= '0' && id[0] <= '9')) id = "n" + id;
  return is_keyword(id) || is_macro(id) || id == "cca" ? id + "_" : id;
}

// The namespace of a robot: of a taken name with `_robot`.
inline std::string namespace_of(std::string_view name) {
  const std::string id = identifier_of(name), bare = id.substr(0, id.find_last_not_of('_') + 1);
  return is_global(bare) || bare == "sim" ? bare + "_robot" : id;
}

// Names of one kind, each once.
class name_list {
public:
  explicit name_list(std::set<std::string> taken = {}) : used_(std::move(taken)) {}

  const std::string& add(const std::string& name) {
    const std::string wanted = identifier_of(name);
    std::string id = wanted;
    const char* between = wanted.ends_with('_') ? "" : "_";
    for (int& n = last_.emplace(wanted, 1).first->second; !used_.insert(id).second;)
      id = wanted + between + std::to_string(++n);
    return given_[name] = id;
  }
  bool has(const std::string& name) const { return given_.contains(name); }
  const std::string& operator[](const std::string& name) const { return given_.at(name); }

private:
  std::set<std::string> used_;
  std::map<std::string, int> last_;  // the last number after a name
  std::map<std::string, std::string> given_;
};

// `robot::left`: identifiers with `::` between them, the first of which is not declared otherwise.
inline bool is_namespace(std::string_view text) {
  if (is_global(text.substr(0, text.find("::")))) return false;
  while (true) {
    const std::size_t end = std::min(text.find("::"), text.size());
    if (const auto word = text.substr(0, end); identifier_of(word) != word || is_keyword(word)) return false;
    if (end == text.size()) return true;
    text.remove_prefix(end + 2);
  }
}

}  // namespace cca_urdf

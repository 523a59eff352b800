// XML elements with numbers, read strictly: what is missing, written twice or no number is an error with its
// line. tinyxml2 itself would take the first of two children and the beginning of a wrong number.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <tinyxml2.h>

#include "numbers.hpp"
#include "remarks.hpp"

namespace cca_urdf {

using element = tinyxml2::XMLElement;

inline std::string tag(const element& e) { return std::string("<") + e.Name() + ">"; }

// The only child of that name, or null. A second one is an error.
inline const element* child_of(const element& e, const char* name, remarks& said) {
  const element* first = e.FirstChildElement(name);
  if (first)
    if (const element* second = first->NextSiblingElement(name))
      said.error(second->GetLineNum(),
                 tag(e) + " (line " + std::to_string(e.GetLineNum()) + ") has a second " + tag(*second));
  return first;
}

// Reads one element, whose owner is named in messages: `joint 'elbow'`.
class reader {
public:
  reader(std::string owner, remarks& said) : owner_(std::move(owner)), said_(said) {}

  void error(const element& e, const std::string& text) const {
    said_.error(e.GetLineNum(), owner_ + ": " + text);
  }

  void note(const element& e, const std::string& text) const {
    said_.note(e.GetLineNum(), owner_ + ": " + text);
  }

  // Empty if it isn't there; an error, too, if it is needed.
  std::string text(const element& e, const char* attribute, bool needed = true) const {
    const char* value = e.Attribute(attribute);
    if (!value || !*value) {
      if (needed || value) error(e, tag(e) + " needs `" + attribute + "`");
      return {};
    }
    return value;
  }

  std::optional<double> optional_number(const element& e, const char* attribute) const {
    const char* value = e.Attribute(attribute);
    if (!value) return {};
    const auto words = words_of(value);
    const auto n = words.size() == 1 ? number_of(words[0]) : std::nullopt;
    if (!n) error(e, quoted(e, attribute, value) + " is no finite number");
    return n;
  }

  // 0 after an error.
  double number(const element& e, const char* attribute) const {
    if (!e.Attribute(attribute)) error(e, tag(e) + " needs `" + attribute + "`");
    return optional_number(e, attribute).value_or(0);
  }

  template <std::size_t Count>
  std::array<double, Count> list(const element& e,
                                 const char* attribute,
                                 const std::array<double, Count>& otherwise) const {
    const char* value = e.Attribute(attribute);
    if (!value) return otherwise;
    const auto n = numbers_of<Count>(value);
    if (!n) error(e, quoted(e, attribute, value) + " is not " + std::to_string(Count) + " finite numbers");
    return n.value_or(otherwise);
  }

  const element* needed_child(const element& e, const char* name) const {
    const element* found = child_of(e, name, said_);
    if (!found) error(e, tag(e) + " needs a <" + name + ">");
    return found;
  }

  remarks& said() const { return said_; }

private:
  static std::string quoted(const element& e, const char* attribute, const char* value) {
    return tag(e) + " has " + attribute + "=\"" + value + "\", which";
  }

  std::string owner_;
  remarks& said_;
};

}  // namespace cca_urdf

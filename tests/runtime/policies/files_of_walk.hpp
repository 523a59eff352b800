// The files of walk/, to break them and to import them.
#pragma once

#include <string>

#include <doctest/doctest.h>

#include <cca/base/file.hpp>

#include "policy/writing.hpp"

namespace policies {

inline const std::string folder = CCA_POLICIES "/walk/";

struct files {
  std::string onnx = cca::detail::read_file(folder + "walk.onnx"),
              deploy = cca::detail::read_file(folder + "deploy.yaml"),
              map = cca::detail::read_file(folder + "map.toml");
};

inline void put(std::string& text, const std::string& old, const std::string& now) {
  const auto at = text.find(old);
  REQUIRE_MESSAGE(at != std::string::npos, old);
  text.replace(at, old.size(), now);
}
// In an ONNX file, whose texts have lengths.
inline void put_in_place(std::string& text, const std::string& old, const std::string& now) {
  REQUIRE(old.size() == now.size());
  put(text, old, now);
}

inline cca_policy::imported imported(const files& f, cca_policy::complaints& wrong) {
  return cca_policy::import_policy({"walk.onnx", f.onnx}, {"deploy.yaml", f.deploy}, {"map.toml", f.map},
                                   wrong);
}

// What the importer says first; empty: it writes a header.
inline std::string said_of(const files& f) {
  try {
    cca_policy::complaints wrong;
    (void)imported(f, wrong);
    return wrong.all().empty() ? "" : wrong.all().front();
  } catch (const cca::refused& e) { return e.what(); }
}

}  // namespace policies

// A parameter of the graph that Python has set: one value for all worlds, or one for each.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include <cca/config.hpp>

namespace cca::python {

struct given_parameter {
  std::string path;
  std::vector<std::variant<double, bool, std::string>> values;  // one, or as many as there are worlds

  // Throws cca::refused with the path and what is wrong.
  template <class Controller>
  void apply(Controller& c, std::size_t world) const {
    std::visit([&](const auto& value) { c.set(path, value); }, values[values.size() == 1 ? 0 : world]);
  }
};

}  // namespace cca::python

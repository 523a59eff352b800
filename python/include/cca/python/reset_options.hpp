// The options of reset() in Python: a dictionary with parameters of the graph by their paths, each a number,
// a bool, a text, or an array with a number for each world; and `reset_mask`, the worlds that begin anew.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cca/python/array_checks.hpp>
#include <cca/python/given_parameter.hpp>

namespace cca::python::detail {

inline given_parameter parameter_of(const std::string& path, const py::handle& given, std::size_t count) {
  given_parameter g{path, {}};
  if (py::isinstance<py::bool_>(given)) {
    g.values.emplace_back(given.cast<bool>());
  } else if (py::isinstance<py::str>(given)) {
    g.values.emplace_back(given.cast<std::string>());
  } else if (py::isinstance<py::float_>(given) || py::isinstance<py::int_>(given)) {
    g.values.emplace_back(given.cast<double>());
  } else {
    const auto each = doubles(py::reinterpret_borrow<py::object>(given), {static_cast<py::ssize_t>(count)},
                              "the option '" + path + "'");
    for (py::ssize_t i = 0; i < each.size(); ++i) g.values.emplace_back(each.data()[i]);
  }
  return g;
}

inline std::pair<std::vector<std::uint8_t>, std::vector<given_parameter>> reset_options(
    const py::object& given, std::size_t count) {
  std::pair<std::vector<std::uint8_t>, std::vector<given_parameter>> all;
  if (given.is_none()) return all;
  if (!py::isinstance<py::dict>(given)) throw py::type_error("options is no dictionary");
  for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(given)) {
    if (!py::isinstance<py::str>(key)) throw py::type_error("a key of options is no text");
    const auto name = key.cast<std::string>();
    if (name != "reset_mask") {
      all.second.push_back(parameter_of(name, value, count));
      continue;
    }
    if (!py::isinstance<py::array_t<bool>>(value))
      throw py::type_error("reset_mask is no numpy array of bool");
    const auto mask = py::array_t<bool, py::array::c_style>::ensure(value);
    if (mask.ndim() != 1 || static_cast<std::size_t>(mask.size()) != count)
      throw py::value_error("reset_mask has the shape " +
                            shape_in_words({mask.shape(), mask.shape() + mask.ndim()}) + ", and (" +
                            std::to_string(count) + ",) is expected");
    all.first.assign(mask.data(), mask.data() + count);
  }
  return all;
}

}  // namespace cca::python::detail

// A described box: what Gymnasium calls a space, with names and units.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cca/python/array_checks.hpp>
#include <cca/python/described_numbers.hpp>

namespace cca::python {

struct box {
  described_numbers numbers;
  std::size_t worlds = 0;  // 0: of a single one

  std::vector<pybind11::ssize_t> shape() const {
    const auto n = static_cast<pybind11::ssize_t>(numbers.count());
    return worlds == 0 ? std::vector{n} : std::vector{static_cast<pybind11::ssize_t>(worlds), n};
  }
};

namespace detail {

// One row, or the same row for each world without a copy of it.
inline py::array of_each(const box& b, const std::vector<double>& row) {
  py::array_t<double> one(static_cast<py::ssize_t>(row.size()), row.data());
  one.attr("flags").attr("writeable") = false;
  return b.worlds == 0 ? py::array(one)
                       : py::array(py::module_::import("numpy").attr("broadcast_to")(one, b.shape()));
}

inline bool contains(const box& b, const py::object& given) {
  if (!py::isinstance<py::array_t<double>>(given) && !py::isinstance<py::array_t<float>>(given)) return false;
  const auto array = py::reinterpret_borrow<py::array>(given);
  if (std::vector<py::ssize_t>(array.shape(), array.shape() + array.ndim()) != b.shape()) return false;
  const auto values = doubles(given, b.shape(), "x");
  const auto n = static_cast<py::ssize_t>(b.numbers.count());
  for (py::ssize_t i = 0; i < values.size(); ++i) {
    const auto at = static_cast<std::size_t>(i % n);
    if (!(values.data()[i] >= b.numbers.low[at] && values.data()[i] <= b.numbers.high[at])) return false;
  }
  return true;
}

inline std::string text_of(const box& b) {
  std::string text;
  for (std::size_t i = 0; i < b.numbers.count(); ++i)
    text += b.numbers.names[i] + " [" + b.numbers.units[i] + "] " +
            std::string(py::str(py::float_(b.numbers.low[i]))) + " to " +
            std::string(py::str(py::float_(b.numbers.high[i]))) + "\n";
  return text;
}

// Once for a module.
inline void declare_box(py::module_& m) {
  if (py::hasattr(m, "box")) return;
  py::class_<box>(m, "box", py::module_local(), "numbers with names, units and limits")
      .def_property_readonly("shape", [](const box& b) { return py::tuple(py::cast(b.shape())); })
      .def_property_readonly("dtype", [](const box&) { return py::dtype::of<double>(); })
      .def_property_readonly("low", [](const box& b) { return of_each(b, b.numbers.low); })
      .def_property_readonly("high", [](const box& b) { return of_each(b, b.numbers.high); })
      .def_property_readonly("names", [](const box& b) { return b.numbers.names; })
      .def_property_readonly("units", [](const box& b) { return b.numbers.units; })
      .def("contains", &contains, py::arg("x"), "whether x has the shape, and is within the limits")
      .def("__repr__", [](const box& b) { return "box" + shape_in_words(b.shape()) + "\n" + text_of(b); });
}

}  // namespace detail
}  // namespace cca::python

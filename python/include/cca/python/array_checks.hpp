// What Python gives, checked before anything moves: an array of the wrong type or shape is an exception with
// what was expected.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace cca::python::detail {

namespace py = pybind11;

inline std::string shape_in_words(const std::vector<py::ssize_t>& shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i) text += (i ? ", " : "") + std::to_string(shape[i]);
  return text + (shape.size() == 1 ? ",)" : ")");
}

// Numbers as doubles in rows. Arrays of float64 that are contiguous are not copied; float32 is.
inline py::array_t<double, py::array::c_style> doubles(const py::object& given,
                                                       const std::vector<py::ssize_t>& shape,
                                                       const std::string& what) {
  if (!py::isinstance<py::array>(given))
    throw py::type_error(what + " is a " + std::string(py::str(py::type::of(given).attr("__name__"))) +
                         ", not a numpy array of float64 or float32");
  const auto array = py::reinterpret_borrow<py::array>(given);
  if (!py::isinstance<py::array_t<double>>(array) && !py::isinstance<py::array_t<float>>(array))
    throw py::type_error(what + " is an array of " + std::string(py::str(array.dtype())) +
                         ", not of float64 or float32");
  const std::vector<py::ssize_t> there(array.shape(), array.shape() + array.ndim());
  if (there != shape)
    throw py::value_error(what + " has the shape " + shape_in_words(there) + ", and " +
                          shape_in_words(shape) + " is expected");
  auto result = py::array_t < double, py::array::c_style | py::array::forcecast > ::ensure(array);
  if (!result) throw py::error_already_set();
  return result;
}

inline std::int64_t whole_seed(const py::handle& given) {
  if (!PyLong_Check(given.ptr()) && !py::hasattr(given, "__index__"))
    throw py::type_error("a seed is a whole number, not a " +
                         std::string(py::str(py::type::of(given).attr("__name__"))));
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
  if (!number) throw py::error_already_set();
  int overflow = 0;
  const long long seed = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
  if (overflow != 0 || seed < 0 || seed >= (1ll << 53))
    throw py::value_error("a seed is from 0 to 2^53 - 1, and this one is " + std::string(py::str(given)));
  return seed;
}

// One seed for each world; -1: the next one of its own. A number is the seed of the first world.
inline std::vector<std::int64_t> seeds_of(const py::object& given, std::size_t count) {
  std::vector<std::int64_t> seeds;
  if (given.is_none()) return seeds;
  if (py::isinstance<py::sequence>(given) || py::isinstance<py::array>(given)) {
    for (const py::handle one : given) seeds.push_back(one.is_none() ? -1 : whole_seed(one));
    if (seeds.size() != count)
      throw py::value_error(std::to_string(seeds.size()) + " seeds for " + std::to_string(count) + " worlds");
    return seeds;
  }
  const std::int64_t first = whole_seed(given);
  for (std::size_t i = 0; i < count; ++i) seeds.push_back(first + static_cast<std::int64_t>(i));
  return seeds;
}

}  // namespace cca::python::detail

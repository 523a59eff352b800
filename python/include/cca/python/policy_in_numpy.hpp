// The file of a policy's weights from Python: layers as pairs of numpy arrays, (units, inputs) and (units,).
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cca/python/array_checks.hpp>
#include <cca/python/policy_file.hpp>

namespace cca::python::detail {

inline std::vector<double> copied(const py::object& given,
                                  const std::vector<py::ssize_t>& shape,
                                  const std::string& what) {
  const auto all = doubles(given, shape, what);
  return std::vector<double>(all.data(), all.data() + all.size());
}

// Defines `policy_layers`, `policy_activation`, `save_policy` and `load_policy`.
template <class Policy, class Class>
void add_policy_file(Class& of) {
  using sizes = std::vector<py::ssize_t>;
  static const auto numbers = [](const py::object& given, int count, const char* what) {
    return given.is_none() ? std::vector<double>() : copied(given, sizes{count}, what);
  };
  of.attr("policy_layers") = py::tuple(py::cast(layer_sizes<Policy>()));
  of.attr("policy_activation") = activation_name<Policy>();
  of.def_static(
      "save_policy",
      [](const std::filesystem::path& file, const py::sequence& layers, const py::object& centre,
         const py::object& scale, const py::object& offset, const py::object& gain) {
        const std::vector<int> size = layer_sizes<Policy>();
        if (layers.size() + 1 != size.size())
          throw py::value_error("this policy has " + std::to_string(size.size() - 1) + " layers, not " +
                                std::to_string(layers.size()));
        policy_numbers n;
        n.centre = numbers(centre, size.front(), "centre"), n.scale = numbers(scale, size.front(), "scale");
        n.offset = numbers(offset, size.back(), "offset"), n.gain = numbers(gain, size.back(), "gain");
        for (std::size_t l = 0; l < layers.size(); ++l) {
          const auto pair = layers[l].cast<py::sequence>();
          const std::string name = "layer " + std::to_string(l);
          if (pair.size() != 2) throw py::value_error(name + " is no pair (matrix, bias)");
          n.layers.push_back({copied(pair[0], sizes{size[l + 1], size[l]}, "the matrix of " + name),
                              copied(pair[1], sizes{size[l + 1]}, "the bias of " + name)});
        }
        try {
          save_policy<Policy>(file.string(), n);
        } catch (const refused& e) { throw py::value_error(e.what()); }
      },
      py::arg("file"), py::arg("layers"), py::kw_only(), py::arg("centre") = py::none(),
      py::arg("scale") = py::none(), py::arg("offset") = py::none(), py::arg("gain") = py::none(),
      "writes weights that the robot's program loads: y = offset + gain * layers((x - centre) * scale)");
  of.def_static(
      "load_policy",
      [](const std::filesystem::path& file) {
        policy_numbers n;
        try {
          n = load_policy<Policy>(file.string());
        } catch (const refused& e) { throw py::value_error(e.what()); }
        const auto array = [](const std::vector<double>& v) {
          return py::array_t<double>(static_cast<py::ssize_t>(v.size()), v.data());
        };
        const std::vector<int> size = layer_sizes<Policy>();
        py::list layers;
        for (std::size_t l = 0; l < n.layers.size(); ++l)
          layers.append(py::make_tuple(array(n.layers[l].weights).reshape(sizes{size[l + 1], size[l]}),
                                       array(n.layers[l].biases)));
        return py::dict(py::arg("layers") = layers, py::arg("centre") = array(n.centre),
                        py::arg("scale") = array(n.scale), py::arg("offset") = array(n.offset),
                        py::arg("gain") = array(n.gain));
      },
      py::arg("file"), "the numbers that save_policy takes");
}

}  // namespace cca::python::detail

// The weights of a cca::policy as layers, and its file: what Python has trained is a file that the robot's
// program loads.
//
// A layer is a matrix of as many rows as it has units, row by row, and a number for each unit. The file has
// the description of the policy's ports (mapping/policy.hpp), so a robot with others refuses it.
//
// Errors: std::invalid_argument for sizes; cca::refused for files and for numbers that are not finite.
#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <cca/mapping/policy.hpp>

namespace cca::python {

struct policy_layer {
  std::vector<double> weights, biases;
};
// y = offset + gain (layers of (x - centre) scale): empty ones are 0 or 1.
struct policy_numbers {
  std::vector<policy_layer> layers;
  std::vector<double> centre, scale, offset, gain;
};

namespace detail {

template <class... In, int... Units, class Activation, Space To>
std::vector<int> sizes_of(const policy<policy_inputs<In...>, hidden_layers<Units...>, Activation, To>*) {
  return {(In::space::size + ... + 0), Units..., To::size};
}
template <class Inputs, class Hidden, class Activation, Space To>
std::string activation_of(const policy<Inputs, Hidden, Activation, To>*) {
  return std::string(Activation::name);
}

inline void need_size(const std::string& what, std::size_t there, std::size_t wanted) {
  if (there != wanted)
    throw std::invalid_argument(what + " has " + std::to_string(there) + " numbers, not " +
                                std::to_string(wanted));
}
template <class Vector>
void take(const char* what, const std::vector<double>& from, Vector& to) {
  if (from.empty()) return;
  need_size(what, from.size(), static_cast<std::size_t>(to.size()));
  to = Vector::Map(from.data());
}
template <class Vector>
std::vector<double> numbers_of(const Vector& v) {
  return std::vector<double>(v.data(), v.data() + v.size());
}

}  // namespace detail

// The number of inputs, the units of each hidden layer, the number of outputs.
template <class Policy>
std::vector<int> layer_sizes() {
  return detail::sizes_of(static_cast<const Policy*>(nullptr));
}
template <class Policy>
std::string activation_name() {
  return detail::activation_of(static_cast<const Policy*>(nullptr));
}

template <class Policy>
void save_policy(const std::string& file, const policy_numbers& n) {
  const std::vector<int> sizes = layer_sizes<Policy>();
  if (n.layers.size() + 1 != sizes.size())
    throw std::invalid_argument("this policy has " + std::to_string(sizes.size() - 1) + " layers, not " +
                                std::to_string(n.layers.size()));
  const auto p = std::make_unique<Policy>();
  detail::take("centre", n.centre, p->weights.centre), detail::take("scale", n.scale, p->weights.scale);
  detail::take("offset", n.offset, p->weights.offset), detail::take("gain", n.gain, p->weights.gain);
  std::size_t at = 0;
  for (std::size_t l = 0; l < n.layers.size(); ++l) {
    const auto from = static_cast<std::size_t>(sizes[l]), to = static_cast<std::size_t>(sizes[l + 1]);
    const std::string name = "layer " + std::to_string(l);
    detail::need_size("the matrix of " + name, n.layers[l].weights.size(), from * to);
    detail::need_size("the bias of " + name, n.layers[l].biases.size(), to);
    for (std::size_t j = 0; j < from; ++j)
      for (std::size_t i = 0; i < to; ++i) p->weights.weights[at++] = n.layers[l].weights[i * from + j];
    for (const double b : n.layers[l].biases) p->weights.weights[at++] = b;
  }
  p->save(file);
}

template <class Policy>
policy_numbers load_policy(const std::string& file) {
  const auto p = std::make_unique<Policy>();
  p->read(file);
  policy_numbers n;
  n.centre = detail::numbers_of(p->weights.centre), n.scale = detail::numbers_of(p->weights.scale);
  n.offset = detail::numbers_of(p->weights.offset), n.gain = detail::numbers_of(p->weights.gain);
  const std::vector<int> sizes = layer_sizes<Policy>();
  std::size_t at = 0;
  for (std::size_t l = 0; l + 1 < sizes.size(); ++l) {
    const auto from = static_cast<std::size_t>(sizes[l]), to = static_cast<std::size_t>(sizes[l + 1]);
    policy_layer layer{std::vector<double>(from * to), std::vector<double>(to)};
    for (std::size_t j = 0; j < from; ++j)
      for (std::size_t i = 0; i < to; ++i) layer.weights[i * from + j] = p->weights.weights[at++];
    for (double& b : layer.biases) b = p->weights.weights[at++];
    n.layers.push_back(std::move(layer));
  }
  return n;
}

}  // namespace cca::python

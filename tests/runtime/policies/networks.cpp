// Networks of every operator, imported by cca-policy, beside the actions of onnxruntime over 1,000 steps
// (judge.mjs). With CCA_POLICY_ANSWERS=FOLDER, answers of that folder.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include <doctest/doctest.h>

#include "robot.hpp"

#include "written/batch_norm.hpp"
#include "written/beside.hpp"
#include "written/constants.hpp"
#include "written/elu.hpp"
#include "written/elu_alpha.hpp"
#include "written/encoder.hpp"
#include "written/gemm.hpp"
#include "written/gru.hpp"
#include "written/gru_reset_before.hpp"
#include "written/layer_norm.hpp"
#include "written/layer_norm_parts.hpp"
#include "written/layout.hpp"
#include "written/leaky_relu.hpp"
#include "written/lstm.hpp"
#include "written/lstm_normalised.hpp"
#include "written/lstm_two_layers.hpp"
#include "written/pieces.hpp"
#include "written/relu.hpp"
#include "written/sigmoid.hpp"
#include "written/silu.hpp"
#include "written/silu_raw.hpp"
#include "written/softmax.hpp"
#include "written/softmax_old.hpp"
#include "written/tangent.hpp"

namespace {

std::string answers() {
  const char* const other = std::getenv("CCA_POLICY_ANSWERS");
  return other ? other : CCA_POLICIES "/answers";
}

struct distance {
  double largest = 0, squares = 0;
  void add(double one, double other) {
    const double off = std::abs(one - other);
    if (!(off <= largest)) largest = off;  // NaN too
    squares += off * off;
  }
};

// How far apart the actions are: those of the network in float and in double, and of onnxruntime, which
// computes in float.
struct distances {
  distance float_to_runtime, float_to_double, runtime_to_double;
};

template <class Network, class Number>
struct running {
  explicit running(const auto& of) : weights(of.begin(), of.end()) {}
  auto answer(const cca::neural::numbers<float, Network::inputs>& x) {
    return Network::answer(weights.data(),
                           cca::neural::numbers<Number, Network::inputs>(x.template cast<Number>()), memory);
  }
  std::vector<Number> weights;
  cca::neural::numbers<Number, Network::memory> memory =
      cca::neural::numbers<Number, Network::memory>::Zero();
};

template <class Contract>
distances distances_of(const typename policies::walking<Contract>::weight_array& weights) {
  using network = typename Contract::network;
  std::ifstream said(answers() + "/" + std::string(Contract::name) + ".txt");
  running<network, float> in_float(weights);
  running<network, double> in_double(weights);
  std::uint32_t bits = 1;
  distances found;
  int compared = 0;
  std::string line;
  int next = -1;
  std::array<float, 4> wanted{};
  const auto read = [&] {
    next = -1;
    if (!std::getline(said, line)) return;
    std::istringstream in(line);
    in >> next;
    for (float& one : wanted) in >> one;
    REQUIRE(!in.fail());
  };
  read();
  for (int k = 0; k < 1000; ++k) {
    cca::neural::numbers<float, network::inputs> x;
    for (int i = 0; i < network::inputs; ++i) {
      bits = bits * 1664525u + 1013904223u;
      x[i] = static_cast<float>(bits >> 8) / 4194304.0f - 2.0f;
    }
    const auto a = in_float.answer(x);
    const auto b = in_double.answer(x);
    if (k != next) continue;
    for (int i = 0; i < network::outputs; ++i) {
      const double runtime = wanted[static_cast<std::size_t>(i)], exact = b[i];
      found.float_to_runtime.add(a[i], runtime);
      found.float_to_double.add(a[i], exact);
      found.runtime_to_double.add(runtime, exact);
    }
    ++compared;
    read();
  }
  CHECK(compared >= 40);
  return found;
}

template <class Contract>
distances compare(double within) {
  const auto policy = std::make_unique<policies::walking<Contract>>();
  policy->read(std::string(CCA_WRITTEN "/") + std::string(Contract::name) + ".policy");
  const distances found = distances_of<Contract>(policy->weights);
  MESSAGE(Contract::name << ": to onnxruntime " << found.float_to_runtime.largest << " in float, "
                         << found.runtime_to_double.largest << " in double; float to double "
                         << found.float_to_double.largest);
  CHECK(found.float_to_runtime.largest < within);
  CHECK(found.runtime_to_double.largest < within);
  CHECK(found.runtime_to_double.largest > 0);  // it is not the same code
  return found;
}

template <class... Contracts>
void compare_all() {
  (compare<Contracts>(2e-6), ...);
}

}  // namespace

TEST_CASE("networks of every operator act as in onnxruntime, over 1,000 steps") {
  compare_all<batch_norm::contract, beside::contract, constants::contract, elu::contract, elu_alpha::contract,
              encoder::contract, gemm::contract, gru::contract, gru_reset_before::contract,
              layer_norm::contract, layer_norm_parts::contract, layout::contract, leaky_relu::contract,
              lstm::contract, lstm_normalised::contract, lstm_two_layers::contract, pieces::contract,
              relu::contract, sigmoid::contract, silu::contract, softmax::contract, softmax_old::contract,
              tangent::contract>();
}

// A wide layer, and observations that the normaliser multiplies by up to 50: what is rounded away in the
// sums is most of the difference.
TEST_CASE("far outside of the training, float is nearer to double than onnxruntime is") {
  const distances found = compare<silu_raw::contract>(1e-5);
  CHECK(found.float_to_double.largest < found.runtime_to_double.largest);
  CHECK(found.float_to_double.squares < found.runtime_to_double.squares);
}

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
#include "written/softmax.hpp"
#include "written/softmax_old.hpp"
#include "written/tangent.hpp"

namespace {

std::string answers() {
  const char* const other = std::getenv("CCA_POLICY_ANSWERS");
  return other ? other : CCA_POLICIES "/answers";
}

// The largest difference to onnxruntime, of actions of around one.
template <class Contract, class Number>
double worst_of(const typename policies::walking<Contract>::weight_array& weights) {
  using network = typename Contract::network;
  std::ifstream said(answers() + "/" + std::string(Contract::name) + ".txt");
  const std::vector<Number> w(weights.begin(), weights.end());
  cca::neural::numbers<Number, network::memory> memory =
      cca::neural::numbers<Number, network::memory>::Zero();
  std::uint32_t bits = 1;
  double worst = 0;
  int compared = 0;
  std::string line;
  int next = -1;
  std::array<double, 4> wanted{};
  const auto read = [&] {
    next = -1;
    if (!std::getline(said, line)) return;
    std::istringstream in(line);
    in >> next;
    for (double& one : wanted) in >> one;
    REQUIRE(!in.fail());
  };
  read();
  for (int k = 0; k < 1000; ++k) {
    cca::neural::numbers<Number, network::inputs> x;
    for (int i = 0; i < network::inputs; ++i) {
      bits = bits * 1664525u + 1013904223u;
      x[i] = static_cast<Number>(static_cast<float>(bits >> 8) / 4194304.0f - 2.0f);
    }
    const auto y = network::answer(w.data(), x, memory);
    if (k != next) continue;
    for (int i = 0; i < network::outputs; ++i)
      worst = std::max(worst, std::abs(static_cast<double>(y[i]) - wanted[static_cast<std::size_t>(i)]));
    ++compared;
    read();
  }
  CHECK(compared >= 40);
  return worst;
}

template <class Contract>
void compare() {
  const auto policy = std::make_unique<policies::walking<Contract>>();
  policy->read(std::string(CCA_WRITTEN "/") + std::string(Contract::name) + ".policy");
  const double in_float = worst_of<Contract, float>(policy->weights),
               in_double = worst_of<Contract, double>(policy->weights);
  MESSAGE(Contract::name << ": " << in_float << " in float, " << in_double << " in double");
  CHECK(in_float < 2e-6);
  CHECK(in_double < 2e-6);
  CHECK(in_double > 0);  // it is not the same code
}

template <class... Contracts>
void compare_all() {
  (compare<Contracts>(), ...);
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

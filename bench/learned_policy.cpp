// A learned policy in a graph, beside the bare products of its matrices.
//
//   policy check                                 compares a network with the same arithmetic by hand; exits
//                                                with 1 if they differ
//   policy list                                  the names of the networks
//   policy NAME policy|products|by_hand BEATS    runs one form (under callgrind)
//   policy NAME allocations                      the allocations of 1000 beats of the policy
//
// `products`: y = W x + b for each layer, and nothing else. `by_hand`: the same with activations, scales and
// limits, on Eigen vectors. `policy`: a whole beat of a graph with the sources of its observations.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string_view>

#include <cca/cca.hpp>
#include <cca/mapping/policy.hpp>

#include "words.hpp"

extern "C" long bench_allocations();

namespace bench {

template <int I>
struct joint : cca::dimension<"joint"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.5, 1.5}};
};
template <class Domain>
struct legs : cca::space<Domain,
                         cca::axes<joint<0>,
                                   joint<1>,
                                   joint<2>,
                                   joint<3>,
                                   joint<4>,
                                   joint<5>,
                                   joint<6>,
                                   joint<7>,
                                   joint<8>,
                                   joint<9>,
                                   joint<10>,
                                   joint<11>>,
                         cca::rate<50>> {};
using angles = legs<cca::joint_angles>;
using rates = legs<cca::joint_velocities>;
using numbers = legs<cca::number>;

// Observations of a quadruped: angles, velocities and two vectors of twelve more.
struct source {
  auto process(cca::beat) -> std::tuple<cca::out<"angles", angles>,
                                        cca::out<"rates", rates>,
                                        cca::out<"before", numbers>,
                                        cca::out<"wish", numbers>> {
    for (int i = 0; i < 48; ++i) x[i] = 0.999 * x[i] + 1e-3 * (i % 7);
    return {x.segment<12>(0), x.segment<12>(12), x.segment<12>(24), x.segment<12>(36)};
  }
  Eigen::Matrix<double, 48, 1> x = Eigen::Matrix<double, 48, 1>::LinSpaced(-1, 1);
};
struct sink {
  void process(cca::in<"targets", angles> to) { last = to.vector(); }
  angles::vector_type last = angles::vector_type::Zero();
};

template <class Activation, int... Units>
struct walking_policy : cca::policy<cca::policy_inputs<cca::in<"angles", angles>,
                                                       cca::in<"rates", rates>,
                                                       cca::in<"before", numbers>,
                                                       cca::in<"wish", numbers>>,
                                    cca::hidden_layers<Units...>,
                                    Activation,
                                    angles> {};

template <class Policy>
struct walking : cca::graph<cca::rate<50>,
                            cca::node<"in", source>,
                            cca::node<"policy", Policy>,
                            cca::node<"out", sink>,
                            cca::wire<"in.angles", "policy.angles">,
                            cca::wire<"in.rates", "policy.rates">,
                            cca::wire<"in.before", "policy.before">,
                            cca::wire<"in.wish", "policy.wish">,
                            cca::wire<"policy.output", "out.targets">> {};

template <class Activation, bool All, int From, int To, int... Rest>
[[gnu::always_inline]] inline auto by_hand_from(const double* w, const auto& x) {
  const Eigen::Map<const Eigen::Matrix<double, To, From>> W(w);
  const Eigen::Map<const Eigen::Matrix<double, To, 1>> b(w + To * From);
  Eigen::Matrix<double, To, 1> y = b;
  y.noalias() += W * x;
  if constexpr (sizeof...(Rest) == 0) {
    return y;
  } else {
    if constexpr (All) Activation::apply(y);
    return by_hand_from<Activation, All, To, Rest...>(w + To * (From + 1), y);
  }
}

template <class Activation, int... Units>
struct forms {
  using policy = walking_policy<Activation, Units...>;
  using network = typename policy::network;

  struct graph {
    cca::controller<walking<policy>> c;
    explicit graph(const typename network::parameters& p) {
      c.template get<"policy">().weights = p;
      c.load();
      c.start();
    }
    [[gnu::noinline]] void beat() { c.step(); }
    auto result() { return c.template get<"out">().last; }
  };
  template <bool All>
  struct bare {
    typename network::parameters p;
    source in;
    angles::vector_type last = angles::vector_type::Zero();
    explicit bare(const typename network::parameters& with) : p(with) {}
    [[gnu::noinline]] void beat() {
      (void)in.process(cca::beat(0, 1, 1));
      if constexpr (All) {
        const typename network::input z = (in.x - p.centre).cwiseProduct(p.scale);
        const auto y = by_hand_from<Activation, true, 48, Units..., 12>(p.weights.data(), z);
        last = (p.offset + p.gain.cwiseProduct(y)).cwiseMax(-1.5).cwiseMin(1.5);
      } else {
        last = by_hand_from<Activation, false, 48, Units..., 12>(p.weights.data(), in.x);
      }
    }
    auto result() { return last; }
  };
};

template <class Forms>
std::unique_ptr<typename Forms::network::parameters> drawn() {
  auto p = std::make_unique<typename Forms::network::parameters>();
  std::uint64_t bits = 1;
  for (double& w : p->weights) {
    bits = bits * 6364136223846793005u + 1442695040888963407u;
    w = 0.1 * (static_cast<double>(bits >> 11) * 0x1p-52 - 1);
  }
  return p;
}

template <class Form>
void run(int beats, const auto& p) {
  const auto form = std::make_unique<Form>(p);
  for (int k = 0; k < beats; ++k) form->beat();
  if (!form->result().allFinite()) std::abort();
}

template <class Forms>
bool same() {
  const auto p = drawn<Forms>();
  const auto a = std::make_unique<typename Forms::graph>(*p);
  const auto b = std::make_unique<typename Forms::template bare<true>>(*p);
  for (int k = 0; k < 100; ++k) {
    a->beat(), b->beat();
    if (!((a->result() - b->result()).norm() < 1e-12)) return false;
  }
  return true;
}

template <class Forms>
bool is_run(std::string_view name, std::string_view wanted, std::string_view form, int argc, char** argv) {
  if (name != wanted) return false;
  const auto p = drawn<Forms>();
  if (form == "allocations" && argc == 3) {
    const auto g = std::make_unique<typename Forms::graph>(*p);
    const long before = bench_allocations();
    for (int k = 0; k < 1000; ++k) g->beat();
    std::printf("%ld\n", bench_allocations() - before);
    return true;
  }
  if (argc != 4) refuse(form, "policy, products or by_hand and a number of beats, or allocations");
  const int beats = beats_in(argv[3]);
  if (form == "policy") run<typename Forms::graph>(beats, *p);
  else if (form == "products") run<typename Forms::template bare<false>>(beats, *p);
  else if (form == "by_hand") run<typename Forms::template bare<true>>(beats, *p);
  else refuse(form, "policy, products, by_hand or allocations");
  return true;
}

}  // namespace bench

int main(int argc, char** argv) {
  using small_tanh = bench::forms<cca::hyperbolic_tangent, 64, 64>;
  using large_tanh = bench::forms<cca::hyperbolic_tangent, 256, 128, 64>;
  using small_relu = bench::forms<cca::rectifier, 64, 64>;
  using large_relu = bench::forms<cca::rectifier, 256, 128, 64>;
  const std::string_view name = argc > 1 ? argv[1] : "", form = argc > 2 ? argv[2] : "";
  if (name == "list") return std::puts("tanh 64 64\ntanh 256 128 64\nrelu 64 64\nrelu 256 128 64"), 0;
  if (name == "check")
    return !(bench::same<small_tanh>() && bench::same<large_tanh>() && bench::same<small_relu>() &&
             bench::same<large_relu>());
  if (bench::is_run<small_tanh>(name, "tanh 64 64", form, argc, argv) ||
      bench::is_run<large_tanh>(name, "tanh 256 128 64", form, argc, argv) ||
      bench::is_run<small_relu>(name, "relu 64 64", form, argc, argv) ||
      bench::is_run<large_relu>(name, "relu 256 128 64", form, argc, argv))
    return 0;
  bench::refuse(name, "check, list, or the name of a network");
}

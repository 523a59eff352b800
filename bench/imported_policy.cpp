// An imported policy in a graph, beside the bare products of its matrices on Eigen.
//
//   imported_policy list                        the networks
//   imported_policy NAME policy|products BEATS  runs one form (under callgrind)
//   imported_policy check                       compares both networks without activations; exits with 1 if
//                                               they differ
//
// `products`: y = W x + b for each layer, and nothing else. `policy`: a whole beat of a graph, with the
// sources of 48 observations, scales, default pose, the activation, and 12 commands within their limits.
//
//   for n in $(./imported_policy list); do for f in policy products; do valgrind --tool=callgrind
//   --callgrind-out-file=/dev/null ./imported_policy $n $f 120; done; done, minus the same with 20
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <cca/cca.hpp>
#include <cca/mapping/imported/imported_policy.hpp>
#include <cca/mapping/network/operators.hpp>

#include "words.hpp"

namespace bench {

template <int I>
struct joint : cca::dimension<"joint"> {
  static constexpr char letters[] = {'j', static_cast<char>('a' + I)};
  static constexpr std::string_view name{letters, 2};
  static constexpr auto limits = cca::limits{cca::angle{-1.5, 1.5}};
};
template <class Indices>
struct twelve;
template <int... I>
struct twelve<std::integer_sequence<int, I...>> {
  using axes = cca::axes<joint<I>...>;
  static constexpr std::array<cca::policy_number, 12> numbers{{{joint<I>::name, 0.1, 0.25}...}};
};
using joints = twelve<std::make_integer_sequence<int, 12>>;
struct angles : cca::space<cca::joint_angles, joints::axes, cca::rate<50>> {};
struct rates : cca::space<cca::joint_velocities, joints::axes, cca::rate<50>> {};
struct numbers : cca::space<cca::number, joints::axes, cca::rate<50>> {};

struct elu {
  static auto of(const auto& x) { return cca::neural::elu(x, 1); }
};
struct silu {
  static auto of(const auto& x) { return cca::neural::silu(x); }
};
struct tangent {
  static auto of(const auto& x) { return cca::neural::tangent(x); }
};
struct none {
  static auto of(const auto& x) { return x; }
};

// Of W x + b for each layer, with an activation between them.
template <class Active, int From, int To, int... Rest>
struct layers {
  static constexpr int weights = (From + 1) * To + layers<Active, To, Rest...>::weights;
  static constexpr int outputs = layers<Active, To, Rest...>::outputs;
  template <class Number>
  [[gnu::always_inline]] static auto of(const Number* w, const cca::neural::numbers<Number, From>& x) {
    return layers<Active, To, Rest...>::of(w + (From + 1) * To, Active::of(cca::neural::dense<To>(w, x)));
  }
  template <class Number>
  [[gnu::always_inline]] static auto by_eigen(const Number* w, const cca::neural::numbers<Number, From>& x) {
    const Eigen::Map<const Eigen::Matrix<Number, To, From>> W(w);
    cca::neural::numbers<Number, To> y = Eigen::Map<const cca::neural::numbers<Number, To>>(w + To * From);
    y.noalias() += W * x;
    return layers<Active, To, Rest...>::by_eigen(w + (From + 1) * To, y);
  }
};
template <class Active, int From, int To>
struct layers<Active, From, To> {
  static constexpr int weights = (From + 1) * To, outputs = To;
  template <class Number>
  [[gnu::always_inline]] static auto of(const Number* w, const cca::neural::numbers<Number, From>& x) {
    return cca::neural::dense<To>(w, x);
  }
  template <class Number>
  [[gnu::always_inline]] static auto by_eigen(const Number* w, const cca::neural::numbers<Number, From>& x) {
    const Eigen::Map<const Eigen::Matrix<Number, To, From>> W(w);
    cca::neural::numbers<Number, To> y = Eigen::Map<const cca::neural::numbers<Number, To>>(w + To * From);
    y.noalias() += W * x;
    return y;
  }
};

template <class Active, int... Sizes>
struct net : layers<Active, Sizes...> {
  static constexpr int inputs = 48, memory = 0;
  template <class Number>
  static cca::neural::numbers<Number, 12> answer(const Number* w,
                                                 const cca::neural::numbers<Number, 48>& x,
                                                 cca::neural::numbers<Number, 0>&) {
    return net::of(w, x);
  }
};

template <class Number, class Network>
struct contract {
  struct term_angles {
    static constexpr std::string_view name = "angles", is = "joint_angles";
    static constexpr auto numbers = joints::numbers;
  };
  struct term_rates {
    static constexpr std::string_view name = "rates", is = "joint_velocities";
    static constexpr auto numbers = joints::numbers;
  };
  struct term_before {
    static constexpr std::string_view name = "before", is = "number";
    static constexpr auto numbers = joints::numbers;
  };
  struct term_last {
    static constexpr std::string_view name = "last", is = "last_action";
    static constexpr auto numbers = joints::numbers;
  };
  struct action {
    static constexpr std::string_view name = "action", is = "joint_angles";
    static constexpr auto numbers = joints::numbers;
    static constexpr bool observed_clipped = false;
  };
  static constexpr std::string_view name = "walk";
  static constexpr double rate = 50, oldest = 1;
  using number = Number;
  using network = Network;
  using terms = cca::policy_terms<term_angles, term_rates, term_before, term_last>;
  static constexpr int history = 1;
  static constexpr auto layout = cca::history_layout::by_term;
  static constexpr auto order = cca::history_order::oldest_first;
  static constexpr auto start = cca::history_start::repeated;
  static constexpr std::array<std::string_view, 0> lines{};
};

struct source {
  auto process(cca::beat)
      -> std::tuple<cca::out<"angles", angles>, cca::out<"rates", rates>, cca::out<"before", numbers>> {
    for (int i = 0; i < 36; ++i) x[i] = 0.999 * x[i] + 1e-3 * (i % 7);
    return {x.segment<12>(0), x.segment<12>(12), x.segment<12>(24)};
  }
  Eigen::Matrix<double, 48, 1> x = Eigen::Matrix<double, 48, 1>::LinSpaced(-1, 1);
};
struct sink {
  void process(cca::in<"targets", angles> to) { last = to.vector(); }
  angles::vector_type last = angles::vector_type::Zero();
};

template <class Contract>
struct policy
    : cca::imported_policy<
          Contract,
          cca::policy_inputs<cca::in<"angles", angles>, cca::in<"rates", rates>, cca::in<"before", numbers>>,
          angles> {};
template <class Policy>
struct walking : cca::graph<cca::rate<50>,
                            cca::node<"in", source>,
                            cca::node<"policy", Policy>,
                            cca::node<"out", sink>,
                            cca::wire<"in.angles", "policy.angles">,
                            cca::wire<"in.rates", "policy.rates">,
                            cca::wire<"in.before", "policy.before">,
                            cca::wire<"policy.output", "out.targets">> {};

void draw(auto& weights) {
  std::uint64_t bits = 1;
  for (auto& w : weights) {
    bits = bits * 6364136223846793005u + 1442695040888963407u;
    w = static_cast<std::remove_reference_t<decltype(w)>>(0.1 *
                                                          (static_cast<double>(bits >> 11) * 0x1p-52 - 1));
  }
}

template <class Active, class Number, int... Units>
struct forms {
  using network = net<Active, 48, Units..., 12>;
  using component = policy<contract<Number, network>>;
  struct graph {
    cca::controller<walking<component>> c;
    graph() {
      draw(c.template get<"policy">().weights);
      c.load();
      c.start();
    }
    [[gnu::noinline]] void beat() { c.step(); }
    bool is_finite() { return c.template get<"out">().last.allFinite(); }
  };
  struct products {
    typename component::weight_array w;
    source in;
    cca::neural::numbers<Number, 12> last;
    products() { draw(w); }
    [[gnu::noinline]] void beat() {
      (void)in.process(cca::beat(0, 1, 1));
      last = network::by_eigen(w.data(), cca::neural::numbers<Number, 48>(in.x.template cast<Number>()));
    }
    bool is_finite() { return last.allFinite(); }
  };
  static bool same() {
    const auto p = std::make_unique<products>();
    for (int k = 0; k < 10; ++k) {
      p->beat();
      const auto y = net<none, 48, Units..., 12>::of(
          p->w.data(), cca::neural::numbers<Number, 48>(p->in.x.template cast<Number>()));
      if (!((y - p->last).norm() < 1e-4)) return false;
    }
    return true;
  }
  template <class Form>
  static void run(int beats) {
    const auto form = std::make_unique<Form>();
    for (int k = 0; k < beats; ++k) form->beat();
    if (!form->is_finite()) std::abort();
  }
  static bool is_run(std::string_view form, int beats) {
    if (form == "policy") run<graph>(beats);
    else if (form == "products") run<products>(beats);
    else refuse(form, "policy or products");
    return true;
  }
};

// Calls `f` with the name and the forms of each network; true: one of the calls was.
template <class Active>
bool any_with(const std::string& activation, auto f) {
  const auto with = [&]<class Number>(const std::string& number, Number) {
    return f(number + "64_64", forms<Active, Number, 64, 64>()) ||
           f(number + "256_128", forms<Active, Number, 256, 128>()) ||
           f(number + "512_256_128", forms<Active, Number, 512, 256, 128>());
  };
  return with(activation + "_float_", 0.0f) || with(activation + "_double_", 0.0);
}
bool any_of_all(auto f) {
  return any_with<elu>("elu", f) || any_with<silu>("silu", f) || any_with<tangent>("tangent", f);
}

}  // namespace bench

int main(int argc, char** argv) {
  using namespace bench;
  const std::string_view name = argc > 1 ? argv[1] : "", form = argc > 2 ? argv[2] : "";
  if (name == "list")
    return any_of_all([](const std::string& one, auto) { return std::puts(one.c_str()) < 0; });
  if (name == "check") return any_with<elu>("", [](const std::string&, auto f) { return !f.same(); });
  if (any_of_all([&](const std::string& one, auto f) {
        if (one != name) return false;
        if (argc != 4) refuse(form, "policy or products, and a number of beats");
        return f.is_run(form, beats_in(argv[3]));
      }))
    return 0;
  refuse(name, "check, list, or the name of a network");
}

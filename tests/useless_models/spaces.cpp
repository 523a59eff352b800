// Samples, mappings, skeletons, and the laws of finite numbers and of parameters.
#include <limits>

#include <cca/cca.hpp>
#include <cca/mapping.hpp>

#include "../laws/finite_laws.hpp"
#include "../laws/mapping_laws.hpp"
#include "../laws/skeleton_laws.hpp"
#include "../laws/space_laws.hpp"
#include "trials.hpp"

using namespace useless;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
enum class kind { nothing, refusing, repeating };

struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct leg : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
struct paw : cca::space<cca::joint_angles, cca::axes<knee, hip>> {};
using v3 = Eigen::Vector3d;

// A sample with every operation, none of which computes anything.
template <kind What>
struct odd {
  v3 x = v3::Zero();
  std::int64_t made = cca::never;
  odd() = default;
  explicit odd(const v3& v, std::int64_t t = cca::never) : x(v), made(t) {}
  const v3& vector() const { return x; }
  std::int64_t origin() const { return made; }
  odd result() const {
    if (What == kind::nothing) return {};
    if (What == kind::refusing) return odd(v3::Constant(no_number));
    return *this;
  }
  friend odd operator*(const odd& a, const odd&) { return a.result(); }
  friend odd operator+(const odd& a, const odd&) { return a.result(); }
  friend odd operator-(const odd& a, const odd&) { return a.result(); }
  friend odd operator*(double, const odd& a) { return a.result(); }
  friend odd operator*(const odd& a, double) { return a.result(); }
  odd operator-() const { return result(); }
  odd inverse() const { return result(); }
  odd interpolated(const odd&, double) const { return result(); }
  v3 difference(const odd&) const { return result().x; }
  double distance(const odd& o) const { return (x - o.x).norm(); }
};
template <kind What>
struct odd_model {
  static auto random(laws::source& from) { return odd<What>(from.vector(3)); }
  static auto point(laws::source& from) { return odd<What>(from.vector(3)); }
  static odd<What> act(const odd<What>& a, const odd<What>&) {
    return What == kind::repeating ? a : What == kind::refusing ? a.result() : odd<What>{};
  }
  static bool close(const odd<What>& a, const odd<What>& b) { return (a.x - b.x).norm() < 1e-12; }
  static odd<What> plus(const odd<What>& a, const v3&) { return a.result(); }
};
template <kind What>
void space() {
  using model = odd_model<What>;
  laws::law("group", laws::group<model>);
  laws::law("action", laws::action<model>);
  laws::law("differences", laws::differences<model>);
  laws::law("interpolation", laws::interpolation<model>);
  laws::law("straight", laws::straight<model>);
  laws::law("sums", laws::sums<model>);
  laws::law("origins", [] { laws::origins<model>([](const auto& a, const auto& b) { return a * b; }); });
}

// ---- mappings ----

template <kind What, class From, class To>
struct lazy_map {
  Eigen::Vector2d last = Eigen::Vector2d::Zero();
  Eigen::Vector2d operator()(const Eigen::Vector2d& x) {
    const Eigen::Vector2d before = last;
    last = x;
    return What == kind::nothing    ? Eigen::Vector2d(0, 0)
           : What == kind::refusing ? Eigen::Vector2d(no_number, no_number)
                                    : before;
  }
};
template <kind What>
struct lazy_mapping {
  using forward = cca::mapping<leg, paw, lazy_map<What, leg, paw>>;
  using inverse = cca::mapping<paw, leg, lazy_map<What, paw, leg>>;
  static Eigen::Vector2d random(laws::source& from) { return {from(-1, 1), from(-1, 1)}; }
  static bool close(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return (a - b).norm() < 1e-9; }
};

// ---- skeletons ----

struct always {
  auto process(cca::beat now) -> cca::out<"y", leg> {
    (void)now;
    return Eigen::Vector2d(0.75, 0.75);
  }
};
struct ending {
  std::vector<Eigen::Vector2d> values;
  std::vector<std::int64_t> beats, origins;
  void reserve(std::size_t n) { values.reserve(n), beats.reserve(n), origins.reserve(n); }
  void process(cca::in<"x", leg> x, cca::beat now) {
    values.push_back(x.vector());
    beats.push_back(now.index());
    origins.push_back(x.origin());
  }
};
template <kind What>
struct blocked {
  auto process(cca::in<"input", leg> x) -> cca::maybe<"output", leg> {
    if (What == kind::nothing) return {};
    if (What == kind::refusing) return cca::maybe<"output", leg>(Eigen::Vector2d(no_number, no_number));
    if (first == cca::never) first = x.origin(), value = x.vector();
    return cca::maybe<"output", leg>(value).with_origin(first);
  }
  std::int64_t first = cca::never;
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
};
template <kind What>
struct around : cca::graph<cca::rate<1000>,
                           cca::node<"source", always>,
                           cca::node<"skeleton", blocked<What>>,
                           cca::node<"end", ending>,
                           cca::wire<"source.y", "skeleton.input">,
                           cca::wire<"skeleton.output", "end.x">> {};
template <kind What>
struct skeleton_case {
  using graph = around<What>;
  static constexpr double value = 0.75;
  static constexpr std::string_view name = "useless";
  static void feed(cca::controller<graph>&) {}
  static std::int64_t oldest(std::int64_t beat) { return beat; }
};

// ---- finite numbers ----

template <kind What>
struct numb {
  auto process(cca::in<"x", leg> x) -> cca::out<"y", leg> {
    if (What == kind::repeating && !has_first) has_first = true, first = x.vector();
    return What == kind::refusing ? Eigen::Vector2d(no_number, no_number) : first;
  }
  bool has_first = What != kind::repeating;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
};
template <kind What>
struct numb_case : laws::finite_case<numb<What>> {
  static constexpr bool says_unreadable = false;
};

struct without_values {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (bool, is_on));
  };
};

}  // namespace

TEST_CASE("space") {
  try_model("space", does_nothing, 6, space<kind::nothing>);
  try_model("space", refuses, 7, space<kind::refusing>);
  try_model("space", repeats, 7, space<kind::repeating>);
}
TEST_CASE("mapping") {
  const auto try_kind = [](auto model, auto kind_of) {
    try_model("mapping", model, 1, [] {
      laws::law("the inverse undoes it", laws::inverse<lazy_mapping<decltype(kind_of)::value>>);
    });
  };
  try_kind(does_nothing, std::integral_constant<kind, kind::nothing>());
  try_kind(refuses, std::integral_constant<kind, kind::refusing>());
  try_kind(repeats, std::integral_constant<kind, kind::repeating>());
}
TEST_CASE("skeleton") {
  try_model("skeleton", does_nothing, 2, laws::skeleton<skeleton_case<kind::nothing>>);
  try_model("skeleton", refuses, 2, laws::skeleton<skeleton_case<kind::refusing>>);
  try_model("skeleton", repeats, 1, laws::skeleton<skeleton_case<kind::repeating>>);
}
TEST_CASE("finite numbers") {
  try_model("finite numbers", does_nothing, 1, laws::finite<numb_case<kind::nothing>>);
  try_model("finite numbers", refuses, 2, laws::finite<numb_case<kind::refusing>>);
  try_model("finite numbers", repeats, 1, laws::finite<numb_case<kind::repeating>>);
}
TEST_CASE("parameters") {
  try_model("parameters", "leaves its fields without a value", 1, [] {
    laws::law("each field begins with a value", laws::begins_with_values<without_values::parameters>);
  });
}

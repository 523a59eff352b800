// The parameters of a recording are those of the component only if they have the same names: the values alone
// don't say which is which.
#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "graphs.hpp"
#include "rewriting.hpp"

using namespace record_test;

namespace {

enum class gait { walk, trot };
enum class longer_gait { walk, trot, gallop };
enum class other_gait { trot, walk };

template <class Parameters>
struct tuned {
  using parameters = Parameters;
  parameters p{};
  auto process(cca::in<"x", leg_angles> x) -> cca::out<"y", slow_angles> { return x.vector(); }
};
struct untuned {
  auto process(cca::in<"x", leg_angles> x) -> cca::out<"y", slow_angles> { return x.vector(); }
};
struct inner {
  BOOST_HANA_DEFINE_STRUCT(inner, (double, upper), (double, lower));
};
struct other_inner {
  BOOST_HANA_DEFINE_STRUCT(other_inner, (double, upper), (double, deeper));
};
struct a_b {
  BOOST_HANA_DEFINE_STRUCT(a_b, (double, a), (double, b));
};
struct wide_a_b {  // another range
  BOOST_HANA_DEFINE_STRUCT(wide_a_b, (cca::bounded<double, -9, 9>, a), (double, b));
};
struct b_a {
  BOOST_HANA_DEFINE_STRUCT(b_a, (double, b), (double, a));
};
struct a_c {
  BOOST_HANA_DEFINE_STRUCT(a_c, (double, a), (double, c));
};
struct a_b_c {
  BOOST_HANA_DEFINE_STRUCT(a_b_c, (double, a), (double, b), (double, c));
};
struct only_a {
  BOOST_HANA_DEFINE_STRUCT(only_a, (double, a));
};
struct whole_a {
  BOOST_HANA_DEFINE_STRUCT(whole_a, (std::int64_t, a));
};
struct angle_a {
  BOOST_HANA_DEFINE_STRUCT(angle_a, (cca::quantity<cca::angle, -2.0, 2.0>, a));
};
struct velocity_a {
  BOOST_HANA_DEFINE_STRUCT(velocity_a, (cca::quantity<cca::velocity, -2.0, 2.0>, a));
};
template <class Value>
struct one {
  BOOST_HANA_DEFINE_STRUCT(one, (Value, a));
};

// What is said when a recording of the second component is replayed by the first, after the usual words.
template <class Here, class Recorded>
std::string said(const rewriting& how = {}, bool is_rewritten = false) {
  const temporary_file file("parameters"), other("other_parameters");
  {
    cca::controller<walking<Recorded>> c;
    cca::recording::recorder recording(c, file.path, {.waits = true});
    c.load();
    c.start();
    c.run(cca::for_beats<20>{});
  }
  if (is_rewritten) rewrite(file.path, other.path, how);
  try {
    const auto result = cca::recording::replay<walking<Here>>(is_rewritten ? other.path : file.path);
    return result ? "replayed" : "differs";
  } catch (const cca::refused& e) {
    const std::string all = e.what(),
                      usual = ": the recorded parameters of `filter` are not those of this component";
    const auto at = all.find(usual);
    return at == all.npos ? all : all.substr(at + usual.size());
  }
}
template <class Here, class Recorded>
std::string difference() {
  return said<tuned<Here>, tuned<Recorded>>();
}

}  // namespace

TEST_CASE("a recording of parameters with other names is refused, and they are named") {
  CHECK(difference<a_b, a_b>() == "replayed");
  CHECK(difference<wide_a_b, a_b>() == "replayed");
  CHECK(difference<a_c, a_b>() == ": the recording lacks `c`, and `b` is only in the recording");
  CHECK(difference<b_a, a_b>() == ": they are in another order: here `b`, `a`, in the recording `a`, `b`");
  CHECK(difference<a_b_c, a_b>() == ": the recording lacks `c`");
  CHECK(difference<only_a, a_b_c>() == ": `b`, `c` are only in the recording");
  CHECK(difference<one<other_inner>, one<inner>>() ==
        ": the recording lacks `a_deeper`, and `a_lower` is only in the recording");
  CHECK(difference<one<std::array<double, 3>>, one<std::array<double, 2>>>() ==
        ": the recording lacks `a_2`");
  CHECK(said<untuned, tuned<a_b>>() == ": `a`, `b` are only in the recording");
}

TEST_CASE("a recording of parameters with other types, units or choices is refused, and they are named") {
  CHECK(difference<whole_a, only_a>() == ": another type of `a`: here `int64`, in the recording `float64`");
  CHECK(difference<angle_a, only_a>() == "replayed");  // now it says its unit
  CHECK(difference<angle_a, velocity_a>() == ": another unit of `a`: here `rad`, in the recording `rad/s`");
  CHECK(difference<one<longer_gait>, one<gait>>() == "replayed");
  CHECK(difference<one<other_gait>, one<gait>>() ==
        ": other choices of `a`: here `0 trot`, `1 walk`, in the recording `0 walk`, `1 trot`");
}

TEST_CASE("a file that does not describe its parameters is replayed by their values") {
  const rewriting bare{.has_schemas = false};
  CHECK(said<tuned<b_a>, tuned<a_b>>(bare, true) == "replayed");
  CHECK(said<tuned<only_a>, tuned<a_b>>(bare, true) == "");
}

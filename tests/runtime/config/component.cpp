// Parameters without files: supported field types, and setting values between two beats.
#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <cca/base/nearest.hpp>
#include <cca/component/parameters.hpp>

#include "mock.hpp"

using namespace cca::detail;

namespace {

template <class Type>
struct one {
  BOOST_HANA_DEFINE_STRUCT(one, (int, first), (Type, second));
};
struct nested {
  BOOST_HANA_DEFINE_STRUCT(nested, (one<std::string>, inner));
};
struct many {
  BOOST_HANA_DEFINE_STRUCT(many, (std::array<one<std::vector<int>>, 3>, legs));
};
struct plain {
  double x;
};
struct empty {
  BOOST_HANA_DEFINE_STRUCT(empty);
};
enum unscoped { a, b };
enum class letters : char { x = 'x' };

template <class Type>
constexpr std::string_view bad = unsupported_field<one<Type>>();

static_assert(bad<double>.empty() && bad<float>.empty() && bad<bool>.empty() && bad<long long>.empty() &&
              bad<std::uint64_t>.empty());
static_assert(bad<cca::bounded<float, 0, 1>>.empty() && bad<cca::bounded<int, -3, 3>>.empty() &&
              bad<cca::quantity<cca::torque>>.empty());
static_assert(bad<config_test::terrain>.empty() && bad<cca::text<4>>.empty());
static_assert(bad<std::array<std::array<bool, 2>, 2>>.empty() && bad<Eigen::Vector3d>.empty() &&
              bad<Eigen::Matrix<float, 2, 3, Eigen::RowMajor>>.empty());
static_assert(bad<config_test::coupling>.empty() && bad<std::array<config_test::leg, 4>>.empty() &&
              bad<empty>.empty());

static_assert(bad<std::string> == "second" && bad<std::vector<double>> == "second" &&
              bad<double*> == "second" && bad<long double> == "second");
static_assert(bad<Eigen::VectorXd> == "second" && bad<std::array<double, 0>> == "second" &&
              bad<char> == "second" && bad<const double> == "second");
static_assert(bad<unscoped> == "second" && bad<plain> == "second" && bad<std::unique_ptr<int>> == "second" &&
              bad<cca::bounded<char, 'a', 'z'>> == "second");
static_assert(unsupported_field<nested>() == "inner.second");
static_assert(unsupported_field<many>() == "legs.second");
static_assert(unsupported_field<plain>() == "p" && unsupported_field<double>() == "p");
static_assert(unsupported_type<many>() == "std::vector<int>");

struct no_member {
  struct parameters {
    double x;
  };
};
struct hidden {
  struct parameters {
    double x;
  };
  parameters values;
};
static_assert(cca::HasParameters<config_test::hopf> && !cca::HasParameters<config_test::adder> &&
              !cca::HasParameters<no_member>);
static_assert(ForgotParameters<no_member> && ForgotParameters<hidden> &&
              !ForgotParameters<config_test::hopf> && !ForgotParameters<config_test::adder>);

struct vague {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (std::string, name));
  };
  parameters p;
};
static_assert(bad_field_of<vague>.name == "name" && bad_field_of<no_member>.forgot_parameters);
static_assert(bad_field_of<config_test::hopf>.name.empty() &&
              !bad_field_of<config_test::hopf>.forgot_parameters &&
              bad_field_of<config_test::adder>.name.empty());

static_assert(edit_distance("", "abc") == 3 && edit_distance("cgp", "cpg") == 1 &&
              edit_distance("frequncy", "frequency") == 1);
static_assert(nearest_name("frequncy", std::array<std::string_view, 2>{"gain", "frequency"}) == "frequency");
static_assert(nearest_path("arm.angle",
                           std::array<std::string_view, 3>{"armature", "arm.angle.whole", "arm.angel"}) ==
              "arm.angle.whole");
static_assert(nearest_path("arm.angles.whole", std::array<std::string_view, 1>{"arm.angle.whole"}) ==
              "arm.angle.whole");
static_assert(nearest_path("", std::array<std::string_view, 1>{".x"}).empty());
static_assert(nearest_name("zzz", std::array<std::string_view, 1>{"gain"}).empty());

template <class F>
std::string words_of(F f) {
  try {
    f();
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return {};
}

}  // namespace

TEST_SUITE("config component") {
  TEST_CASE("field types are used like the plain ones") {
    const config_test::hopf h;
    const config_test::posture pose;
    CHECK_EQ(std::sin(pose.p.hip), std::sin(0.25));
    CHECK_EQ(2 * h.p.gain + pose.p.hip, 2.25);
    CHECK_EQ((h.p.gain * Eigen::Vector2d(1, 2))[1], 2.0);
    CHECK_EQ(cca::bounded<double, 0.5, 2>{}.value(), 0.5);
    CHECK_EQ(cca::quantity<cca::angle>{}.value(), 0.0);
  }

  TEST_CASE("values are checked, then all set") {
    config_test::hopf h;
    apply_parameters(h, {2.0, 3.0, {1.0, {0.0, 1.0}}}, "cpg");
    CHECK_EQ(h.p.frequency, 2.0);
    CHECK_EQ(double{h.p.gain}, 3.0);
    CHECK_EQ(words_of([&] { apply_parameters(h, {1.0, 9.0, {1.0, {NAN, 1.0}}}, "cpg"); }),
             "cpg.gain: 9 is out of range, expected 0.1 to 5\ncpg.links.offsets[0]: nan rad is not allowed, "
             "expected a finite number");
    CHECK_EQ(words_of([&] { apply_parameters(h, {1.0, 1.0, {1.0, {0.0, 1.0}}}, "cpg"); }),
             "cpg: frequency and gain are the same");
    CHECK_EQ(words_of([&] { apply_parameters(h, {1.0, 6.0, {1.0, {0.0, 1.0}}}); }),
             "gain: 6 is out of range, expected 0.1 to 5");
    CHECK_EQ(h.p.frequency, 2.0);
    CHECK_EQ(double{h.p.gain}, 3.0);
  }

  TEST_CASE("a program may set exactly the values that a file may hold") {
    one<std::uint64_t> seed{0, std::numeric_limits<std::uint64_t>::max()};
    CHECK_EQ(words_of([&] { cca::check_parameters(seed, "x"); }),
             "x.second: 9223372036854775807 is out of range, expected 0 to 9223372036854775806");
    one<cca::text<4>> text{0, "\xff"};
    CHECK_EQ(words_of([&] { cca::check_parameters(text, "x"); }), "x.second: the text is not UTF-8");
    one<cca::bounded<double, -cca::infinity, 0>> low{0, -cca::infinity};
    CHECK_EQ(words_of([&] { cca::check_parameters(low, "x"); }), "");
    low.second = 1;
    CHECK_EQ(words_of([&] { cca::check_parameters(low, "x"); }),
             "x.second: 1 is out of range, expected at most 0");
  }

  TEST_CASE("assigning a text that is too long changes nothing") {
    cca::text<4> t = "abcd";
    CHECK_FALSE(t.assign("abcde"));
    CHECK_EQ(t.view(), "abcd");
    CHECK(t.assign("x"));
    CHECK((t == cca::text<4>("x")));
  }

  TEST_CASE("UTF-8") {
    for (const std::string_view good :
         {"", "a", "\xc3\xa4", "\xe2\x82\xac", "\xf0\x9f\x90\x95", "\xf4\x8f\xbf\xbf"})
      CHECK(is_utf8(good));
    for (const std::string_view wrong : {"\x80", "\xc3", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80",
                                         "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xe2\x82"})
      CHECK_FALSE(is_utf8(wrong));
  }

  TEST_CASE("names of enumerators") {
    CHECK_EQ(enumerators<config_test::terrain>[2], "steps");
    CHECK_EQ(enumerators<config_test::terrain>[3], "");
  }

}  // TEST_SUITE

// A parameter without a value is refused by load(): nothing begins with what was in memory before.
#include <doctest/doctest.h>

#include <cstdint>
#include <memory>
#include <string>

#include <cca/cca.hpp>

namespace {

struct hip : cca::dimension<"hip"> {};
struct reading : cca::space<cca::number, cca::axes<hip>> {};

enum class ground { flat, slope };
struct range {
  BOOST_HANA_DEFINE_STRUCT(range, (double, low), (double, high));
};
struct values {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (double, gain),
                             (float, slope),
                             (bool, on),
                             (int, steps),
                             (std::int64_t, ticks),
                             (ground, terrain),
                             (Eigen::Vector2d, offset),
                             (range, swing),
                             (cca::bounded<double, 1.0, 2.0>, factor),
                             (cca::quantity<cca::angle>, lean),
                             (cca::text<8>, label));
  };
  auto process(cca::beat) -> cca::out<"y", reading> { return 0.0; }
};

struct no_values : values {
  parameters p;
};
struct default_values : values {
  parameters p{1, 2, true, 3, 4, ground::slope, Eigen::Vector2d(5, 6), {7, 8}, 1.5, 0.1, "a"};
};
struct by_constructor : values {
  parameters p;
  by_constructor() {
    p.gain = p.slope = 0;
    p.on = false;
    p.steps = -1, p.ticks = INT64_MIN;
    p.terrain = ground::flat;
    p.offset.setZero();
    p.swing = {-1e300, 1e300};
  }
};
// g++ drops what is in the place of such an object before, if nothing prevents it.
struct half_constructed {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (double, offset), (int, steps));
  };
  parameters p;
  double state[3];
  half_constructed() {
    p.gain = 1;
    state[0] = 2;
  }
  auto process(cca::beat) -> cca::out<"y", reading> { return p.gain + state[0]; }
};
struct has_virtual_functions {
  virtual ~has_virtual_functions() = default;
  virtual int answer() const { return 42; }
};
struct some_values : has_virtual_functions, values {
  parameters p;
  some_values() : has_virtual_functions() {
    p.gain = 1, p.slope = 2;
    p.on = true;
    p.steps = 3, p.ticks = 4;
    p.terrain = ground::slope;
    p.offset[0] = 5;
    p.swing.high = answer();
  }
};
// Where no value of the type is free, nothing is refused.
struct small_numbers {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (std::uint8_t, small), (std::int16_t, short_one));
  };
  parameters p{0xA5, static_cast<std::int16_t>(0xA5A5)};
  auto process(cca::beat) -> cca::out<"y", reading> { return 0.0; }
};

template <class C>
struct one : cca::graph<cca::rate<1000>, cca::node<"arm", C>, cca::observe<"arm.y">> {};
template <class C>
struct two : cca::graph<cca::rate<1000>,
                        cca::node<"leg", default_values>,
                        cca::node<"arm", C>,
                        cca::observe<"arm.y">,
                        cca::observe<"leg.y">> {};

template <class Controller>
std::string refusal_of(Controller& c) {
  try {
    c.load();
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return {};
}

std::string lines(std::initializer_list<const char*> names) {
  std::string all;
  for (const char* const name : names)
    all += std::string(all.empty() ? "" : "\n") + name +
           ": has no value: give it a default, as in `parameters p{...};`, or set it before load()";
  return all;
}

// Static storage is zero before its constructor runs.
cca::controller<one<no_values>> in_static_storage;

template <class C>
[[gnu::noinline]] std::unique_ptr<cca::controller<two<C>>> on_heap() {
  return std::make_unique<cca::controller<two<C>>>();
}

// All of the components' memory stays as large as it was.
static_assert(sizeof(cca::detail::kept_component<no_values>) == sizeof(no_values));
static_assert(sizeof(cca::detail::kept_component<some_values>) == sizeof(some_values));

}  // namespace

TEST_CASE("a parameter without a value is refused by load(), with its path") {
  const std::string all = lines({"arm.gain", "arm.slope", "arm.on", "arm.steps", "arm.ticks", "arm.terrain",
                                 "arm.offset[0]", "arm.offset[1]", "arm.swing.low", "arm.swing.high"});
  cca::controller<one<no_values>> c;
  CHECK_EQ(refusal_of(c), all);
  CHECK_EQ(c.state(), cca::state::created);
  cca::controller<two<no_values>> value_initialised{};
  CHECK_EQ(refusal_of(value_initialised), all);
  CHECK_EQ(refusal_of(*on_heap<no_values>()), all);
  CHECK_EQ(refusal_of(in_static_storage), all);
}

TEST_CASE("so is one that a constructor forgets") {
  cca::controller<one<half_constructed>> half;
  CHECK_EQ(refusal_of(half), lines({"arm.offset", "arm.steps"}));
  cca::controller<two<some_values>> c;
  const std::string forgotten = lines({"arm.offset[1]", "arm.swing.low"});
  CHECK_EQ(refusal_of(c), forgotten);
  auto copy = c;
  CHECK_EQ(refusal_of(copy), forgotten);
  const auto moved = std::make_unique<cca::controller<two<some_values>>>(std::move(copy));
  CHECK_EQ(refusal_of(*moved), forgotten);
}

TEST_CASE("parameters that are set before load() are not refused") {
  cca::controller<one<no_values>> c;
  c.set<"arm">(default_values{}.p);
  CHECK_EQ(refusal_of(c), "");
  CHECK_EQ(c.get<"arm">().p.steps, 3);
}

TEST_CASE_TEMPLATE("parameters with values are taken", C, default_values, by_constructor, small_numbers) {
  cca::controller<two<C>> c;
  CHECK_EQ(refusal_of(c), "");
  CHECK_EQ(refusal_of(*on_heap<C>()), "");
}

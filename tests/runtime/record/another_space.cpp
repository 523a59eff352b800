// The recording of a graph in which one space was another one: the message says what differs.
#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

#include <cca/modes.hpp>
#include <cca/record/replay/described_space.hpp>

#include "graphs.hpp"

using namespace record_test;

namespace {

struct cx : cca::dimension<"cx"> {};
struct cy : cca::dimension<"cy"> {};
struct cz : cca::dimension<"cz"> {};
struct world : cca::frame<"world"> {};
struct trunk : cca::frame<"trunk"> {};
struct ankle : cca::dimension<"ankle"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}, cca::velocity{-0.5, 0.5}};
};
struct free_ankle : cca::dimension<"ankle"> {};
template <int Micro>
struct bent : cca::dimension<"ankle"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5 + Micro * 1e-6 + 1e-12}};
};
// Two programs may mean something else by one name.
struct degrees : cca::angle {
  static constexpr std::string_view unit = "deg";
};
namespace here {
struct gauges : cca::detail::linear_domain {
  using quantity = cca::angle;
  template <class Self>
  struct methods : cca::detail::additive<Self> {};
};
}  // namespace here
namespace recorded {
struct gauges : cca::detail::linear_domain {
  using quantity = degrees;
  template <class Self>
  struct methods : cca::detail::additive<Self> {};
};
}  // namespace recorded

template <class Space>
struct source {
  auto sense() -> cca::out<"y", Space> { return Eigen::Vector2d(1, 2); }
};
template <class Space>
struct relay {
  auto process(cca::in<"x", Space> x) -> cca::out<"y", Space> { return x.vector(); }
};
template <class Space>
struct first {
  auto process(cca::in<"x", Space> x) -> cca::out<"y", steps> { return x.vector()[0]; }
};
template <class Axis>
struct plane : cca::space<cca::number, cca::axes<cx, Axis>> {};
template <class Axis>
struct graph : cca::graph<cca::rate<1000>,
                          cca::node<"s", source<plane<Axis>>>,
                          cca::node<"r", relay<plane<Axis>>>,
                          cca::node<"f", first<plane<Axis>>>,
                          cca::wire<"s.y", "r.x">,
                          cca::wire<"r.y", "f.x">,
                          cca::observe<"f.y">>,
               cca::recordable {};

template <class Axis>
struct rest : cca::graph<cca::rate<1000>,
                         cca::node<"s", source<plane<Axis>>>,
                         cca::node<"f", first<plane<Axis>>>,
                         cca::wire<"s.y", "f.x">,
                         cca::observe<"f.y">> {};
template <class Axis>
struct two_modes : cca::modes<cca::mode<"rest", rest<Axis>>, cca::mode<"go", graph<Axis>>>,
                   cca::recordable {};

// Of two modes, since the outputs of each mode are counted anew.
template <class Wire>
struct crossed : cca::graph<cca::rate<1000>,
                            cca::node<"s", source<plane<cy>>>,
                            cca::node<"r", relay<plane<cy>>>,
                            cca::node<"f", first<plane<cy>>>,
                            cca::wire<"s.y", "r.x">,
                            Wire,
                            cca::observe<"r.y">,
                            cca::observe<"f.y">>,
                 cca::recordable {};
template <class Wire>
struct crossed_modes : cca::modes<cca::mode<"rest", rest<cy>>, cca::mode<"go", crossed<Wire>>>,
                       cca::recordable {};
using from_source = cca::wire<"s.y", "f.x">;
using from_relay = cca::wire<"r.y", "f.x">;

// What is said when Recorded is replayed as Here, after the name of the file.
template <class Here, class Recorded>
std::string refusal(std::vector<std::string> scopes = {}) {
  const temporary_file file("another_space");
  {
    cca::controller<Recorded> c;
    cca::recording::recorder recording(c, file.path, {.scopes = scopes, .waits = true});
    c.load();
    c.start();
    c.run(cca::for_beats<3>{});
  }
  try {
    cca::recording::replay<Here>(file.path);
  } catch (const cca::refused& e) {
    const std::string all = e.what(), begin = "another architecture: ";
    return all.substr(all.find(begin) + begin.size());
  }
  return "replayed";
}

template <class Domain, class... More>
struct space : cca::space<Domain, More...> {};
template <class Domain, class... More>
using along_ankle = space<Domain, cca::axes<ankle>, More...>;
template <class Here, class Recorded>
std::string difference() {
  using cca::recording::detail::described_space;
  return difference_of(described_space(cca::detail::space_of<Here>),
                       described_space(cca::detail::space_of<Recorded>));
}

}  // namespace

TEST_CASE("a recording of another axis is refused with both axes") {
  CHECK(refusal<graph<cz>, graph<cy>>() ==
        "the output `s.y` has another axis 2: here `cz`, in the recording `cy`; here it is `number` of `cx`, "
        "`cz`, in the recording `number` of `cx`, `cy`");
  CHECK(refusal<two_modes<cz>, two_modes<cy>>().starts_with(
      "the output `s.y` of mode `rest` has another axis 2: here `cz`, in the recording `cy`"));
  CHECK(refusal<graph<cz>, two_modes<cy>>() == "here `1000000 ns a beat`, there `mode rest`");
}

TEST_CASE("an output that was not recorded is known by another one of its space, or said to be unknown") {
  CHECK(refusal<graph<cz>, graph<cy>>({"r"}).starts_with(
      "the output `s.y` has another axis 2: here `cz`, in the recording `cy`"));
  CHECK(
      refusal<graph<cz>, graph<cy>>({"f"}) ==
      "the output `s.y` has another space: here `number` of `cx`, `cz`; the recording has no topic with that "
      "output's 2 numbers, so it does not say what they are");
}

TEST_CASE("a wire that differs is shown with the output from which it comes") {
  CHECK(refusal<crossed<from_source>, crossed<from_relay>>() ==
        "here `wire to f.x from s.y, delayed 0`, there `wire to f.x from r.y, delayed 0`");
  CHECK(refusal<crossed_modes<from_source>, crossed_modes<from_relay>>() ==
        "here `wire to f.x from s.y, delayed 0`, there `wire to f.x from r.y, delayed 0`");
}

TEST_CASE("what differs first in a space is named") {
  CHECK(difference<space<cca::number, cca::axes<cx>>, plane<cy>>().starts_with(
      "another axis 2: here none, in the recording `cy`"));
  CHECK(difference<along_ankle<cca::joint_angles>, along_ankle<cca::joint_velocities>>() ==
        "another domain type: here `joint_angles`, in the recording `joint_velocities`");
  CHECK(difference<space<cca::cartesian_position<world>, cca::axes<cx>>,
                   space<cca::cartesian_position<trunk>, cca::axes<cx>>>() ==
        "another frame: here `world`, in the recording `trunk`");
  CHECK(difference<along_ankle<here::gauges>, along_ankle<recorded::gauges>>() ==
        "another unit of the axis `ankle`: here `rad`, in the recording `deg`");
  CHECK(difference<space<cca::joint_angles, cca::axes<bent<1000>>>, along_ankle<cca::joint_angles>>() ==
        "other limits of the axis `ankle`: here `-0.5 to 0.501`, in the recording `-0.5 to 0.5`");
  CHECK(difference<along_ankle<cca::joint_angles>, space<cca::joint_angles, cca::axes<free_ankle>>>() ==
        "other limits of the axis `ankle`: here `-0.5 to 0.5`, in the recording none");
  CHECK(difference<slow_angles, leg_angles>() == "another rate in Hz: here `100`, in the recording `1000`");
  CHECK(difference<along_ankle<cca::joint_angles>, along_ankle<cca::joint_angles, cca::rate<500>>>() ==
        "another rate in Hz: here none, in the recording `500`");
  CHECK(difference<along_ankle<cca::joint_angles>, space<cca::joint_angles, cca::axes<bent<0>>>>() ==
        "other limits or another rate, but only after the sixth digit, which is the last one in the file");
}

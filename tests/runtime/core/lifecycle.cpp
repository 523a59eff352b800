// The life-cycle: what each call does in each state, and which hooks run.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <functional>

#include "counting.hpp"

using namespace core_test;
using cca::state;

namespace {

std::vector<std::string> hooks_called;

template <cca::fixed_string Name>
struct chatty {
  auto process() -> cca::out<"y", reading> { return ++beats; }
  void on_load() { tell("load"); }
  void on_save() { tell("save"); }
  void on_start() { tell("start"); }
  void on_stop() { tell("stop"); }
  void on_fault() { tell("fault"); }
  void tell(const char* what) { hooks_called.push_back(std::string(Name.view()) + " " + what); }
  double beats = 0;
};

struct breaking {  // returns a fault on demand
  auto process() -> cca::fault { return broken ? cca::fault("it broke") : cca::fault(); }
  void on_fault() { hooks_called.push_back("breaking fault"); }
  bool broken = false;
};

template <cca::fixed_string Name>
struct device {
  auto sense() -> cca::out<"y", reading> { return 0; }
  void on_load() { hooks_called.push_back(std::string(Name.view()) + " load"); }
  void on_fault() { hooks_called.push_back(std::string(Name.view()) + " fault"); }
};

struct inner : cca::graph<cca::node<"deep", chatty<"deep">>, cca::expose<"deep.y", "y">> {};
struct whole : cca::graph<cca::rate<1000>,
                          cca::node<"first", chatty<"first">>,
                          cca::node<"inner", inner>,
                          cca::node<"device", device<"device">>,
                          cca::node<"other", device<"other">>,
                          cca::node<"breaking", breaking>> {};
using controller = cca::controller<whole>;

struct act {
  const char* name;
  std::function<void(controller&)> call;
};
const std::array acts{
    act{"load", [](controller& c) { c.load(); }},
    act{"save", [](controller& c) { c.save(); }},
    act{"start", [](controller& c) { c.start(); }},
    act{"stop", [](controller& c) { c.stop(); }},
    act{"resume", [](controller& c) { c.resume(); }},
    act{"run", [](controller& c) { c.run(cca::for_beats<2>{}); }},
    act{"step",
        [](controller& c) {
          if (!c.step()) throw cca::refused("no beat");
        }},
};

void bring(controller& c, state to) {
  if (to == state::created) return;
  c.load();
  if (to == state::loaded) return;
  c.start();
  if (to == state::faulted) {
    c.get<"breaking">().broken = true;
    c.step();
    c.get<"breaking">().broken = false;
  }
}

struct rule {
  state from;
  const char* act;
  state to;
  const char* remedy;  // null: legal
};
// The seed's section 4.1.1, and a way back from a fault.
const std::array rules{
    rule{state::created, "load", state::loaded, nullptr},
    rule{state::created, "save", state::created, "load() it first"},
    rule{state::created, "start", state::created, "load() it first"},
    rule{state::created, "stop", state::created, "load() and start() it first"},
    rule{state::created, "resume", state::created, "nothing has faulted"},
    rule{state::created, "run", state::created, "load() and start() it first"},
    rule{state::created, "step", state::created, ""},
    rule{state::loaded, "load", state::loaded, nullptr},
    rule{state::loaded, "save", state::created, nullptr},
    rule{state::loaded, "start", state::started, nullptr},
    rule{state::loaded, "stop", state::loaded, "start() it first"},
    rule{state::loaded, "resume", state::loaded, "nothing has faulted"},
    rule{state::loaded, "run", state::loaded, "start() it first"},
    rule{state::loaded, "step", state::loaded, ""},
    rule{state::started, "load", state::started, "stop() it first"},
    rule{state::started, "save", state::started, "stop() it first"},
    rule{state::started, "start", state::started, "it has been started already"},
    rule{state::started, "stop", state::loaded, nullptr},
    rule{state::started, "resume", state::started, "nothing has faulted"},
    rule{state::started, "run", state::started, nullptr},
    rule{state::started, "step", state::started, nullptr},
    rule{state::running, "load", state::running, "stop() it first"},
    rule{state::running, "save", state::running, "stop() it first"},
    rule{state::running, "start", state::running, "it has been started already"},
    rule{state::running, "stop", state::running, "it is running"},
    rule{state::running, "resume", state::running, "nothing has faulted"},
    rule{state::running, "run", state::running, "it is running"},
    rule{state::running, "step", state::running, ""},
    rule{state::faulted, "load", state::faulted,
         "a component has faulted: look at fault(), then resume() or stop()"},
    rule{state::faulted, "save", state::faulted,
         "a component has faulted: look at fault(), then resume() or stop()"},
    rule{state::faulted, "start", state::faulted,
         "a component has faulted: look at fault(), then resume() or stop()"},
    rule{state::faulted, "stop", state::loaded, nullptr},
    rule{state::faulted, "resume", state::started, nullptr},
    rule{state::faulted, "run", state::faulted,
         "a component has faulted: look at fault(), then resume() or stop()"},
    rule{state::faulted, "step", state::faulted, ""},
};
static_assert(rules.size() == 5 * acts.size());

void check(const rule& r, controller& c) {
  CAPTURE(std::string(cca::to_string(r.from)));
  CAPTURE(std::string(r.act));
  REQUIRE_EQ(c.state(), r.from);
  const auto beats = c.beat_index();
  const auto fired = c.get<"first">().beats;
  const std::string reason = c.fault().reason();
  hooks_called.clear();
  const auto& chosen =
      *std::find_if(acts.begin(), acts.end(), [&](const act& a) { return std::string(a.name) == r.act; });
  const std::string words = words_of([&] { chosen.call(c); });
  CHECK_EQ(c.state(), r.to);
  if (!r.remedy) {
    CHECK_EQ(words, "");
    CHECK_EQ(std::string(c.fault().reason()), "");
    return;
  }
  const std::string call = std::string(r.act) + "()";
  if (*r.remedy)
    CHECK_EQ(words, "cca::controller: " + call + " is refused in the state `" +
                        std::string(cca::to_string(r.from)) + "`: " + r.remedy);
  else CHECK_EQ(words, "no beat");
  CHECK(hooks_called.empty());  // no hook ran
  CHECK_EQ(c.beat_index(), beats);
  CHECK_EQ(c.get<"first">().beats, fired);
  CHECK_EQ(std::string(c.fault().reason()), reason);
}

}  // namespace

TEST_SUITE("life-cycle") {
  TEST_CASE("every call in every state") {
    for (const rule& r : rules) {
      controller c;
      bring(c, r.from);
      if (r.from != state::running) {
        check(r, c);
      } else {
        bool called = false;
        c.run(cca::for_beats<3>{}, cca::as_fast_as_possible{}, [&](controller& running) {
          if (!called) check(r, running);
          called = true;
        });
        CHECK(called);
        CHECK_EQ(c.beat_index(), 3);
      }
    }
  }

  TEST_CASE("the table has every state and every transition") {
    for (const auto what :
         {cca::detail::transition::load, cca::detail::transition::save, cca::detail::transition::start,
          cca::detail::transition::stop, cca::detail::transition::run, cca::detail::transition::pause,
          cca::detail::transition::fail, cca::detail::transition::resume})
      for (const auto from :
           {state::created, state::loaded, state::started, state::running, state::faulted}) {
        bool in_table = false;
        for (const auto& t : cca::detail::transitions)
          in_table = in_table || (t.what == what && t.from == from);
        CHECK_EQ(cca::detail::is_legal(what, from), in_table);
        if (!in_table) CHECK_EQ(cca::detail::after(what, from), from);
      }
  }

  TEST_CASE(
      "hooks run in the order of declaration, inner graphs in their place, and only when theirs is the "
      "transition") {
    using words = std::vector<std::string>;
    controller c;
    hooks_called.clear();
    c.load();
    CHECK_EQ(hooks_called, words{"first load", "deep load", "device load", "other load"});
    hooks_called.clear();
    c.start();
    CHECK_EQ(hooks_called, words{"first start", "deep start"});
    hooks_called.clear();
    c.run(cca::for_beats<5>{});
    c.step();
    CHECK_EQ(hooks_called, words{});
    c.get<"breaking">().broken = true;
    c.step();
    CHECK_EQ(hooks_called,
             words{"device fault", "other fault"});  // only resource nodes: they control the robot
    hooks_called.clear();
    c.step();
    c.resume();
    CHECK_EQ(hooks_called, words{});
    c.stop();
    CHECK_EQ(hooks_called, words{"first stop", "deep stop"});
    hooks_called.clear();
    c.save();
    CHECK_EQ(hooks_called, words{"first save", "deep save"});
  }

  TEST_CASE("after stop() and start() it goes on where it was") {
    auto c = started<whole>();
    c.run(cca::for_beats<5>{});
    c.stop();
    c.start();
    CHECK_EQ(c.beat_index(), 5);
    c.step();
    CHECK_EQ(c.get<"first">().beats, 6);
  }
}

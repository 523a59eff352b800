// Skeletons whose parts run in environments of their own: a farm whose workers are apart from what shares out
// and what joins, a pipeline cut between two stages, an adaptive component cut between its module and its
// criterion, a generator cut in its module. Everywhere it is the same for all transports: the bits of one
// loop.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <tuple>

#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/deployment.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>
#include <cca/motor/generator.hpp>
#include <cca/skeleton/farm.hpp>
#include <cca/skeleton/pipeline.hpp>

#include "process.hpp"

namespace cut_skeletons {

struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct stride : cca::dimension<"stride"> {};
struct leg : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct spot : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};
using spots = cca::array_of<spot, 4>;
using v2 = Eigen::Vector2d;

// All bits of all samples, and of when they came and originated.
struct witness {
  std::uint64_t all = 14695981039346656037u;
  int samples = 0;

  template <class Sample>
  void hear(const Sample& s, cca::beat now) {
    if (!s.fresh()) return;
    ++samples;
    add(static_cast<std::uint64_t>(now.index()));
    add(static_cast<std::uint64_t>(s.origin()));
    for (int i = 0; i < s.vector().size(); ++i) {
      std::uint64_t bits = 0;
      const double number = s.vector()[i];
      std::memcpy(&bits, &number, sizeof bits);
      add(bits);
    }
  }

private:
  void add(std::uint64_t word) { all = (all ^ word) * 1099511628211u; }
};

// ---- a farm ----

// [farm]
struct thought {  // remembers what it saw, and does not answer each time
  auto process(cca::in<"spot", spot> seen, cca::beat now) -> cca::maybe<"spot", spot> {
    before = 0.9 * before + 0.1 * v2(std::sin(seen.vector()[0]), std::cos(3 * seen.vector()[1]));
    if (now.index() % 7 == 3) return {};
    return v2(before + seen.vector());
  }
  v2 before{0, 0};
};

struct eye {
  auto process(cca::beat now) -> cca::maybe<"y", spots> {
    if (now.index() % 5 == 4) return {};
    cca::maybe<"y", spots> all = spots::vector_type::Zero().eval();
    for (int i = 0; i < spots::size; ++i)
      all.vector()[i] = std::sin(0.1 * static_cast<double>(now.index() + i));
    return all;
  }
};
struct hand : witness {
  void process(cca::in<"x", spots> x, cca::beat now) { hear(x, now); }
};

struct thinking
    : cca::graph<cca::rate<1000>,
                 cca::node<"eye", eye>,
                 cca::node<"brain", cca::farm<thought, spots, spots, cca::inner_wires<cca::delayed<1>>>>,
                 cca::node<"hand", hand>,
                 cca::wire<"eye.y", "brain.input">,
                 cca::wire<"brain.output", "hand.x">> {};

// Two workers have environments of their own, two share one.
struct spread : cca::deployment<thinking,
                                cca::environment<"body", cca::other_nodes>,
                                cca::environment<"first", cca::nodes<"brain.worker0">>,
                                cca::environment<"second", cca::nodes<"brain.worker1">>,
                                cca::environment<"rest", cca::nodes<"brain.worker2", "brain.worker3">>> {};
// [farm end]

// ---- a pipeline ----

struct twice {
  auto process(cca::in<"in", spot> x) -> cca::out<"out", spot> { return 2 * x.vector(); }
};
struct smooth {
  auto process(cca::in<"in", spot> x) -> cca::maybe<"out", spot> {
    kept = 0.7 * kept + 0.3 * x.vector();
    if (++count % 4 == 0) return {};
    return kept;
  }
  v2 kept{0, 0};
  int count = 0;
};
struct pixel {
  auto process(cca::beat now) -> cca::out<"y", spot> {
    return v2(std::sin(0.01 * static_cast<double>(now.index())), 1);
  }
};
struct sink : witness {
  void process(cca::in<"x", spot> x, cca::beat now) { hear(x, now); }
};
struct piped
    : cca::graph<cca::rate<1000>,
                 cca::node<"pixel", pixel>,
                 cca::node<"signal", cca::pipeline<twice, smooth, twice, cca::inner_wires<cca::delayed<2>>>>,
                 cca::node<"hand", sink>,
                 cca::wire<"pixel.y", "signal.input">,
                 cca::wire<"signal.output", "hand.x", cca::delayed<1>>> {};
struct piped_apart : cca::deployment<piped,
                                     cca::environment<"body", cca::nodes<"pixel", "signal.stage0", "hand">>,
                                     cca::environment<"mind", cca::nodes<"signal.stage1">>,
                                     cca::environment<"rest", cca::other_nodes>> {};

// ---- a tracker and a generator ----

struct skill : cca::tracker<cca::dmp_rhythmic_module<leg, stride, 10>,
                            cca::tracking<leg>,
                            cca::inner_wires<cca::delayed<1>>> {};
struct swing : cca::generator<stride,
                              cca::dmp_rhythmic_module<leg, stride, 10>,
                              cca::tracking<leg>,
                              cca::hopf<stride>,
                              cca::inner_wires<cca::delayed<1>>> {};

struct source {
  auto process(cca::beat now) -> std::tuple<cca::out<"phase", cca::over<cca::phase, stride>>,
                                            cca::out<"amplitude", cca::over<cca::amplitude, stride>>,
                                            cca::out<"frequency", cca::over<cca::frequency, stride>>,
                                            cca::out<"centre", leg>,
                                            cca::out<"shown", leg>> {
    const double f = 0.0063 * static_cast<double>(now.index());
    return {f, 1.0, 1.5, v2(0.1, -0.8), v2(0.1 + 0.3 * std::sin(f), -0.8 + 0.2 * std::cos(f))};
  }
};
struct servo {
  auto process(cca::in<"command", leg> wanted) -> cca::out<"angles", leg> {
    return angles += 0.2 * (wanted.vector() - angles);
  }
  v2 angles{0, 0};
};
struct judge : witness {
  void process(cca::in<"error", cca::criterion_error> error,
               cca::in<"status", cca::component_status_port> status,
               cca::in<"module", cca::module_status_port> module,
               cca::in<"angles", leg> angles,
               cca::beat now) {
    hear(error, now);
    hear(status, now);
    hear(module, now);
    hear(angles, now);
  }
};
struct tracked : cca::graph<cca::rate<1000>,
                            cca::node<"source", source>,
                            cca::node<"skill", skill>,
                            cca::node<"servo", servo>,
                            cca::node<"hand", judge>,
                            cca::wire<"source.phase", "skill.phase", cca::delayed<1>>,
                            cca::wire<"source.amplitude", "skill.amplitude", cca::delayed<1>>,
                            cca::wire<"source.centre", "skill.reference", cca::delayed<1>>,
                            cca::wire<"source.shown", "skill.demonstration", cca::delayed<1>>,
                            cca::wire<"skill.command", "servo.command", cca::delayed<1>>,
                            cca::wire<"servo.angles", "skill.feedback">,
                            cca::wire<"servo.angles", "hand.angles">,
                            cca::wire<"skill.error", "hand.error">,
                            cca::wire<"skill.component_status", "hand.status">,
                            cca::wire<"skill.module_status", "hand.module">> {};
struct tracked_apart : cca::deployment<tracked,
                                       cca::environment<"body", cca::other_nodes>,
                                       cca::environment<"mind", cca::nodes<"skill.module">>> {};

struct swung : cca::graph<cca::rate<1000>,
                          cca::node<"source", source>,
                          cca::node<"swing", swing>,
                          cca::node<"servo", servo>,
                          cca::node<"hand", judge>,
                          cca::wire<"source.frequency", "swing.frequency", cca::delayed<1>>,
                          cca::wire<"source.amplitude", "swing.amplitude", cca::delayed<1>>,
                          cca::wire<"source.centre", "swing.centre", cca::delayed<1>>,
                          cca::wire<"source.shown", "swing.demonstration", cca::delayed<1>>,
                          cca::wire<"swing.command", "servo.command", cca::delayed<1>>,
                          cca::wire<"servo.angles", "swing.feedback">,
                          cca::wire<"servo.angles", "hand.angles">,
                          cca::wire<"swing.error", "hand.error">,
                          cca::wire<"swing.component_status", "hand.status">,
                          cca::wire<"swing.module_status", "hand.module">> {};
struct swung_apart
    : cca::deployment<swung,
                      cca::environment<"body", cca::other_nodes>,
                      cca::environment<"rhythm", cca::nodes<"swing.module.oscillator", "swing.module.shift">>,
                      cca::environment<"mind", cca::nodes<"swing.module.pattern">>> {};

template <class Played>
witness played(Played& c, int beats = 1500) {
  c.load();
  c.start();
  c.run(cca::for_some_beats{beats / 3});
  c.run(cca::for_some_beats{beats - beats / 3});
  return c.template get<"hand">();
}
inline std::string words(const witness& w) { return std::to_string(w.samples) + " " + std::to_string(w.all); }

// The same, each environment of the farm in a process of its own.
template <class Meeting>
void a_farm_in_processes() {
  const std::string name = Meeting::other_name();
  const auto worker = [&](const char* environment) {
    return [environment, &name] {
      cca::deployed<spread> d(cca::only{environment}, Meeting::transport(name));
      d.load();
      d.start();
      d.run(cca::for_some_beats{500});
      d.run(cca::for_some_beats{1000});
      return std::string("done");
    };
  };
  process first(worker("first")), second(worker("second")), rest(worker("rest"));
  process body([&] {
    cca::deployed<spread> d(cca::only{"body"}, Meeting::transport(name));
    return words(played(d));
  });
  cca::controller<thinking> one;
  CHECK_EQ(body.said(), words(played(one)));
  for (process* p : {&first, &second, &rest}) CHECK_EQ(p->said(), "done");
}

}  // namespace cut_skeletons

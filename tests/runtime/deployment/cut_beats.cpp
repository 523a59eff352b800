// After a fault has cut a beat: what counts as published in it does so in every environment, as in one loop,
// also where an environment does not know the clock of its own output.
#include <doctest/doctest.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include <cca/deployment.hpp>

namespace {

struct number : cca::space<cca::number, cca::axes<cca::x>> {};

struct source {
  double n = 0, time = 0;
  auto process(cca::beat now) -> cca::out<"y", number> {
    time += now.dt();
    return ++n;
  }
};
// Faults in one beat.
struct faults {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (int, beat));
  };
  parameters p{-1};
  auto process(cca::beat now) -> cca::fault {
    return now.index() == p.beat ? cca::fault("as planned") : cca::fault();
  }
};
struct relay {
  double time = 0;
  auto process(cca::in<"x", number> x, cca::beat now) -> cca::out<"y", number> {
    time += now.dt();
    return 2 * x[cca::x{}];
  }
};
struct reader {
  std::int64_t fresh = 0;
  double sum = 0, time = 0;
  auto process(cca::in<"x", number> x, cca::in<"late", number> late, cca::beat now) -> cca::out<"y", number> {
    time += now.dt();
    fresh += x.fresh() + 100 * late.fresh();
    sum = 0.5 * sum + x[cca::x{}] + late[cca::x{}];
    return sum;
  }
};

struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"source", source, cca::timed<3>>,
                                 cca::node<"faults", faults>,
                                 cca::node<"relay", relay>,
                                 cca::node<"reader", reader, cca::timed<1>>,
                                 cca::wire<"source.y", "relay.x", cca::delayed<1>>,
                                 cca::wire<"relay.y", "reader.x", cca::latest>,
                                 cca::wire<"relay.y", "reader.late", cca::delayed<2>>,
                                 cca::observe<"relay.y">,
                                 cca::observe<"reader.y">> {};
// In the environment of the relay nobody knows when the source publishes, so neither when the relay does.
struct apart : cca::deployment<architecture,
                               cca::environment<"source", cca::nodes<"source", "faults">>,
                               cca::environment<"rest", cca::other_nodes>> {};

template <class Played>
std::vector<std::string> story(int beat) {
  Played c;
  c.load();
  c.template set<"faults">({beat});
  c.start();
  std::vector<std::string> pages;
  const auto tell = [&] {
    std::ostringstream text;
    text << c.beat_index() << ' ' << cca::to_string(c.state()) << ' ' << c.template get<"reader">().fresh
         << ' ' << c.template get<"reader">().sum << ' ' << c.template get<"reader">().time << ' '
         << c.template get<"relay">().time << ' ' << c.template get<"source">().time;
    c.observed([&](const cca::observation& o) {
      text << ' ' << o.path << ' ' << o.values[0] << ' ' << o.origin << ' ' << o.fresh;
    });
    pages.push_back(text.str());
  };
  c.run(cca::for_beats<20>{});
  tell();
  if (c.state() == cca::state::faulted) c.resume();
  for (int i = 0; i < 5; ++i) {
    c.step();
    tell();
  }
  return pages;
}

}  // namespace

TEST_CASE("cut beats: what is observed, and what a reader takes for fresh, is as in one loop") {
  for (int beat = 0; beat < 12; ++beat) {
    CAPTURE(beat);
    const auto one = story<cca::controller<architecture>>(beat), all = story<cca::deployed<apart>>(beat);
    REQUIRE_EQ(one.size(), all.size());
    REQUIRE_EQ(one.size(), 6);
    // The reader fires in each beat: all its dt together are the time of all beats, though one was cut.
    std::ostringstream time;
    time << ' ' << 0.001 * (beat == 0 ? 5 : beat + 6) << ' ';
    CHECK_NE(one.back().find(time.str()), std::string::npos);
    for (std::size_t page = 0; page < one.size(); ++page) CHECK_EQ(one[page], all[page]);
  }
}

// A trace, read by a parser of others, and a graph whose components count how often they fire.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <cca/cca.hpp>
#include <cca/trace.hpp>

#include "../../laws/temporary_file.hpp"

namespace trace_test {

using laws::temporary_file;

struct event {
  std::string name, category;
  char phase = 0;
  int track = 0;
  std::int64_t begin = 0, end = 0;  // ns
  nlohmann::json arguments{};
};

inline std::string text_of(const std::string& file) {
  std::ifstream from(file);
  return {std::istreambuf_iterator<char>(from), {}};
}

// In the order of the file. Throws where it is no JSON.
inline std::vector<event> events_in(const std::string& text) {
  std::vector<event> all;
  const auto ns = [](const nlohmann::json& one) { return std::llround(one.get<double>() * 1000); };
  for (const auto& one : nlohmann::json::parse(text)) {
    event e{one.at("name"),
            one.at("cat"),
            one.at("ph").get<std::string>().at(0),
            one.at("tid"),
            0,
            0,
            one.value("args", nlohmann::json())};
    one.at("pid").get<std::int64_t>();
    if (e.phase != 'M') e.begin = e.end = ns(one.at("ts"));
    if (e.phase == 'X') e.end += ns(one.at("dur"));
    if (e.phase == 'i') CHECK(one.at("s") == "t");
    all.push_back(std::move(e));
  }
  return all;
}
inline std::vector<event> events_of(const std::string& file) { return events_in(text_of(file)); }

inline std::int64_t count_of(const std::vector<event>& all, const std::string& name, int track = 0) {
  std::int64_t count = 0;
  for (const event& e : all) count += e.name == name && (track == 0 || e.track == track);
  return count;
}
inline int track_named(const std::vector<event>& all, const std::string& name) {
  for (const event& e : all)
    if (e.phase == 'M' && e.name == "thread_name" && e.arguments.at("name") == name) return e.track;
  return -1;
}

// A beat and what fired in it, as "path" or "path (sense)".
struct beat {
  std::int64_t number = -1, begin = 0, end = 0;
  std::vector<std::string> fired{};
};

// Of one track. Checks that each firing lies in its beat, and that they follow one another.
inline std::vector<beat> beats_of(const std::vector<event>& all, int track) {
  std::vector<beat> beats;
  std::int64_t last = 0;
  for (const event& e : all) {
    if (e.track != track || e.phase != 'X' || e.category == "lost") continue;
    REQUIRE(e.begin <= e.end);
    if (e.category == "beat") {
      if (!beats.empty()) CHECK(e.begin >= beats.back().end);
      beats.push_back({e.arguments.at("beat"), e.begin, e.end, {}});
      last = e.begin;
      continue;
    }
    REQUIRE(!beats.empty());
    CHECK(e.begin >= last);
    CHECK(e.end <= beats.back().end);
    last = e.end;
    if (e.category != "wait")
      beats.back().fired.push_back(e.category == "process" ? e.name : e.name + " (" + e.category + ")");
  }
  return beats;
}

inline std::map<std::string, std::int64_t> firings_in(const std::vector<beat>& beats) {
  std::map<std::string, std::int64_t> count;
  for (const beat& one : beats)
    for (const std::string& name : one.fired) ++count[name];
  return count;
}

// ---- a graph ----

struct fast_value : cca::space<cca::number, cca::axes<cca::x>, cca::rate<1000>> {};
struct slow_value : cca::space<cca::number, cca::axes<cca::x>, cca::rate<100>> {};
struct value : cca::space<cca::number, cca::axes<cca::x>> {};

struct plant {
  double at = 1;
  std::int64_t senses = 0, acts = 0;
  auto sense() -> cca::out<"y", fast_value> {
    ++senses;
    return at;
  }
  void act(cca::in<"u", fast_value> u) {
    ++acts;
    at += 0.01 * (u[cca::x{}] - at);
  }
};
struct gain {
  std::int64_t fired = 0;
  auto process(cca::in<"x", value> x) -> cca::out<"y", value> {
    ++fired;
    return 0.9 * x[cca::x{}];
  }
};
struct average {
  double sum = 0;
  std::int64_t fired = 0;
  auto process(cca::in<"x", fast_value> x) -> cca::out<"mean", slow_value> {
    ++fired;
    return sum += 0.1 * (x[cca::x{}] - sum);
  }
};
// Publishes every seventh beat; faults on demand.
struct seldom {
  std::int64_t fired = 0, fault_at = -1;
  auto process(cca::in<"x", fast_value>, cca::beat now) -> std::tuple<cca::maybe<"y", value>, cca::fault> {
    ++fired;
    const cca::fault bad = now.index() == fault_at ? cca::fault("a \"bad\" beat") : cca::fault();
    if (now.index() % 7 != 0) return {cca::maybe<"y", value>(), bad};
    return {cca::maybe<"y", value>(1.0), bad};
  }
};
struct log {
  std::int64_t fired = 0;
  void process(cca::in<"x", value>) { ++fired; }
};

struct pair : cca::graph<cca::node<"first", gain>,
                         cca::node<"second", gain>,
                         cca::wire<"first.y", "second.x">,
                         cca::expose<"first.x", "x">,
                         cca::expose<"second.y", "y">> {};

struct loop : cca::graph<cca::rate<1000>,
                         cca::node<"log", log>,  // declared first, fires after `seldom`
                         cca::node<"mean", average, cca::timed<10>>,
                         cca::node<"seldom", seldom>,
                         cca::node<"pair", pair>,
                         cca::node<"plant", plant>,
                         cca::wire<"seldom.y", "log.x">,
                         cca::wire<"plant.y", "mean.x", cca::latest>,
                         cca::wire<"plant.y", "seldom.x">,
                         cca::wire<"plant.y", "pair.x">,
                         cca::wire<"pair.y", "plant.u">,
                         cca::observe<"mean.mean">> {};

}  // namespace trace_test

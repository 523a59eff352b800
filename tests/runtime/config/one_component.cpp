// One component, or those of an inner graph, is loaded and saved alone: its parameters, and its hooks where
// it is loaded and not started.
#include <doctest/doctest.h>

#include <string>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/deployment.hpp>
#include <cca/modes.hpp>

#include "../../laws/temporary_file.hpp"

namespace {

struct reading : cca::space<cca::number, cca::axes<cca::x>> {};
struct oscillator {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::bounded<double, 0.1, 5>, frequency));
  };
  parameters p{1.5};
  auto process() -> cca::out<"y", reading> { return static_cast<double>(p.frequency); }
  void on_load() { ++loads; }
  void on_save() { ++saves; }
  int loads = 0, saves = 0;
};
struct reader {
  void process(cca::in<"a", reading>, cca::in<"b", reading>) {}
};
struct inner : cca::graph<cca::node<"ode", oscillator>,
                          cca::node<"other", oscillator>,
                          cca::expose<"ode.y", "a">,
                          cca::expose<"other.y", "b">> {};
struct both : cca::graph<cca::rate<1000>,
                         cca::node<"cpg", oscillator>,
                         cca::node<"dmp", inner, cca::stoppable<>>,
                         cca::node<"last", reader>,
                         cca::node<"more", reader>,
                         cca::wire<"cpg.y", "last.a">,
                         cca::wire<"dmp.a", "last.b">,
                         cca::wire<"cpg.y", "more.a">,
                         cca::wire<"dmp.b", "more.b", cca::delayed<1>>> {};
struct split : cca::deployment<both,
                               cca::environment<"one", cca::nodes<"cpg", "last", "dmp.ode", "more">>,
                               cca::environment<"two", cca::other_nodes>> {};
struct other_mode : cca::graph<cca::rate<1000>,
                               cca::node<"cpg", oscillator>,
                               cca::node<"last", reader>,
                               cca::wire<"cpg.y", "last.a">,
                               cca::wire<"cpg.y", "last.b">> {};
struct modes : cca::modes<cca::mode<"both", both>, cca::mode<"other", other_mode>> {};

template <class F>
std::string words_of(F f) {
  try {
    f();
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return {};
}

}  // namespace

TEST_SUITE("one component") {
  TEST_CASE_TEMPLATE("is saved alone", Played, cca::controller<both>, cca::deployed<split>,
                     cca::controller<modes>) {
    Played c;
    const laws::temporary_file file("part.toml");
    CHECK_EQ(words_of([&] { c.template save<"cpg">(file.path); }),
             "cca::controller: save(path, file) is refused in the state `created`: load() it first");
    c.load();
    c.template save<"cpg">(file.path);
    CHECK_EQ(file.text(), "[cpg]\nfrequency = 1.5  # 0.1 to 5\n");
    CHECK_EQ(c.template get<"cpg">().saves, 1);
    CHECK_EQ(c.template get<"dmp.ode">().saves, 0);
    CHECK_EQ(c.state(), cca::state::loaded);
    c.save("dmp", file.path);
    CHECK_EQ(file.text(),
             "[dmp.ode]\nfrequency = 1.5  # 0.1 to 5\n\n[dmp.other]\nfrequency = 1.5  # 0.1 to 5\n");
    CHECK_EQ(c.template get<"dmp.other">().saves, 1);

    c.start();
    c.template save<"dmp">(file.path);
    CHECK_EQ(c.template get<"dmp.ode">().saves, 1);  // it runs: nothing but its parameters
    c.template stop<"dmp">();
    c.template save<"dmp">(file.path);
    CHECK_EQ(c.template get<"dmp.ode">().saves, 2);  // it is stopped, so its life-cycle allows it
    CHECK_EQ(c.template get<"cpg">().saves, 1);
    CHECK_EQ(c.state(), cca::state::started);
    CHECK_EQ(words_of([&] { c.save("dnp", file.path); }),
             "cca::controller: save: there is no node `dnp`; did you mean `dmp`?");
  }

  TEST_CASE_TEMPLATE("is loaded alone", Played, cca::controller<both>, cca::deployed<split>,
                     cca::controller<modes>) {
    Played c;
    const laws::temporary_file file(
        "part.toml", "[cpg]\nfrequency = 2\n[dmp.ode]\nfrequency = 3\n[dmp.other]\nfrequency = 4\n");
    c.load();
    c.template load<"dmp.ode">(file.path);
    CHECK_EQ(double(c.template get<"cpg">().p.frequency), 1.5);
    CHECK_EQ(double(c.template get<"dmp.ode">().p.frequency), 3);
    CHECK_EQ(double(c.template get<"dmp.other">().p.frequency), 1.5);
    CHECK_EQ(c.template get<"dmp.ode">().loads, 2);
    CHECK_EQ(c.template get<"cpg">().loads, 1);
    c.start();
    c.load("cpg", file.path);
    CHECK_EQ(double(c.template get<"cpg">().p.frequency), 2);
    CHECK_EQ(c.template get<"cpg">().loads, 1);  // it runs
    c.stop("dmp");
    c.template load<"dmp">(file.path);
    CHECK_EQ(double(c.template get<"dmp.other">().p.frequency), 4);
    CHECK_EQ(c.template get<"dmp.other">().loads, 2);
  }

  TEST_CASE("what is refused changes nothing") {
    cca::controller<both> c;
    c.load();
    const laws::temporary_file file(
        "part.toml", "[cpg]\nfrequency = 2\n[dmp.ode]\nfrequency = 3\n[dmp.other]\nfrequency = 40\n");
    CHECK_NE(words_of([&] { c.load<"dmp">(file.path); }).find("dmp.other.frequency"), std::string::npos);
    CHECK_EQ(double(c.get<"dmp.ode">().p.frequency), 1.5);
    CHECK_EQ(c.get<"dmp.ode">().loads, 1);
    c.load<"cpg">(file.path);  // what is wrong elsewhere does not matter
    CHECK_EQ(double(c.get<"cpg">().p.frequency), 2);
    const laws::temporary_file typing("typing.toml", "[cpgg]\nfrequency = 2\n");
    CHECK_NE(words_of([&] { c.load<"cpg">(typing.path); }).find("did you mean `cpg`?"), std::string::npos);
  }
}

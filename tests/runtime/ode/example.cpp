// The example of docs/ode.md.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <string_view>

#include <cca/adaptive/ode_status.hpp>
#include <cca/cca.hpp>

#include "../picture.hpp"
#include "models.hpp"

using ode_test::decay;

namespace {

// [component]
struct level : cca::dimension<"level"> {};
struct wish : cca::space<cca::number, cca::axes<level>> {};

struct low_pass {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0, 1000>, rate),
                             (cca::ode_settling, settling));
  };
  parameters p{3.0, {}};

  auto process(cca::in<"wish", wish> w, cca::beat now)
      -> std::tuple<cca::out<"level", wish>, cca::out<"status", cca::ode_status_port>> {
    const decay::parameters at{p.rate};
    solver.advance(w.vector(), at, now.dt());
    return {solver.get(), cca::status_of(status.update(solver.rate(w.vector(), at).norm(), p.settling))};
  }

private:
  cca::ode_solver<decay, cca::rk4> solver;
  cca::ode_monitor status;
};
// [component end]

struct step {
  auto process() -> cca::out<"wish", wish> { return 1.0; }
};
struct sink {
  void process(cca::in<"level", wish> x, cca::in<"status", cca::ode_status_port> s) {
    level_seen = x[level{}], status = s.as<cca::ode_status>();
  }
  double level_seen = 0;
  cca::ode_status status{};
};
struct filtered : cca::graph<cca::rate<1000>,
                             cca::node<"step", step>,
                             cca::node<"filter", low_pass, cca::timed<1>>,
                             cca::node<"sink", sink>,
                             cca::wire<"step.wish", "filter.wish">,
                             cca::wire<"filter.level", "sink.level">,
                             cca::wire<"filter.status", "sink.status">> {};

}  // namespace

TEST_CASE("an ode in a component follows its closed form in a controller") {
  cca::controller<filtered> c;
  c.load();
  c.start();
  c.run(cca::for_beats<1000>{});
  CHECK(c.get<"sink">().level_seen == doctest::Approx(1 - std::exp(-3.0)).epsilon(1e-10));
  CHECK(c.get<"sink">().status == cca::ode_status::transient);
  c.run(cca::for_beats<2000>{});
  CHECK(c.get<"sink">().status == cca::ode_status::converged);
}

namespace {

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  n0["step<br/><i>1000 Hz</i>"]
  n1["filter<br/><i>1000 Hz</i>"]
  n2["sink<br/><i>1000 Hz</i>"]
  n0 -- "wish<br/>wish, 1000 Hz" --> n1
  n1 -- "level<br/>wish, 1000 Hz" --> n2
  n1 -- "status<br/>ode_status_port, 1000 Hz" --> n2
)";  // [picture end]

}  // namespace

TEST_CASE("the picture of a component with an ode is the one on its page") {
  test::check_picture<filtered>(picture);
}

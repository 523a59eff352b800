// Equations, criteria, learners, modules and adaptive components.
#include <cmath>
#include <limits>

#include <cca/adaptive.hpp>
#include <cca/motor/modules/gmr_module.hpp>

#include "../laws/adaptive_component_laws.hpp"
#include "../laws/criterion_laws.hpp"
#include "../laws/learner_laws.hpp"
#include "../laws/module_laws.hpp"
#include "../laws/request_laws.hpp"
#include "../runtime/ode/models.hpp"
#include "trials.hpp"

using namespace useless;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
enum class kind { nothing, refusing, repeating };

struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct leg : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct other_leg : cca::space<cca::joint_angles, cca::axes<knee, hip>> {};
using v1 = Eigen::Matrix<double, 1, 1>;
using v2 = Eigen::Vector2d;

// ---- equations ----

template <kind What>
struct flat {
  using state = v2;
  using input = v1;
  using parameters = ode_test::oscillator::parameters;
  static constexpr int positions = 1;
  static state derivative(const state& x, const input&, const parameters&) {
    return What == kind::nothing ? v2(v2::Zero()) : What == kind::refusing ? v2(v2::Constant(no_number)) : x;
  }
};
template <kind What>
struct flat_case : ode_test::oscillator_case {
  using ode = flat<What>;
};

// ---- criteria ----

template <kind What>
struct judge {
  static constexpr auto compares = cca::criterion_target::command;
  static constexpr bool at_rest = false;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::error_limits<cca::angle>, limits));
  };
  parameters p{};
  auto process(cca::in<"target", leg> target, cca::in<"feedback", leg> feedback, cca::beat)
      -> std::tuple<cca::out<"error", cca::criterion_error>, cca::out<"state", cca::criterion_port>> {
    const double error = cca::apart<leg>(target, feedback);
    if (What == kind::repeating && last < 0) last = error;
    const auto state = What == kind::refusing                               ? cca::criterion_state::lost
                       : What == kind::repeating && last <= p.limits.within ? cca::criterion_state::fulfilled
                                                                            : cca::criterion_state::open;
    return {What == kind::repeating ? last : 0.0, cca::status_of(state)};
  }
  void on_start() {}
  double last = -1;
};
template <kind What>
struct judged_case {
  using criterion = judge<What>;
  using space = leg;
  static auto at(double error) { return std::pair(v2(0.3, -0.2), v2(0.3 + error / 2, -0.2 - error)); }
};

// ---- learners ----

template <kind What>
struct memory {
  using input = v1;
  using output = v2;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (v2, last));
    parameters() : last(v2::Zero()) {}
  };
  static output answer(const parameters& p, const input&) { return p.last; }
  static std::string title() { return "useless v1"; }
};
template <kind What>
struct dunce {
  using model = memory<What>;
  static constexpr std::string_view name = "dunce";
  struct settings {
    BOOST_HANA_DEFINE_STRUCT(settings, (cca::bounded<double, 0, 1>, none));
    constexpr settings(double zero = 0) : none(zero) {}
  };
  struct learned {
    BOOST_HANA_DEFINE_STRUCT(learned, (typename model::parameters, function));
    learned() : function() {}
  };
  static bool inside(const learned&, const v1&, const settings&) { return What == kind::repeating; }
  static void step(learned& known, const v1&, const v2& y, const settings&) {
    if (What == kind::repeating) known.function.last = y;
    if (What == kind::refusing) known.function.last.setConstant(no_number);
  }
  static learned batch(std::span<const cca::example<model>> all, const settings& s) {
    learned known;
    if (!all.empty()) step(known, all.back().x, all.back().y, s);
    return known;
  }
};
template <kind What>
struct lesson {
  using learner = dunce<What>;
  static constexpr double left = 0.06;
  static v1 input(laws::ode_source& random) { return v1(random(0, 2)); }
  static v2 truth(const v1& x) { return {std::sin(3 * x[0]), 0.5 * std::cos(2 * x[0]) + 0.3}; }
  static v1 far() { return v1(4); }
};

// ---- modules ----

// Around a learner that learns nothing: its command is the reference, nothing, or the last demonstration.
template <kind What, int Size = 1>
struct puppet {
  using learner = dunce<What>;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (typename learner::settings, settings), (cca::learned_files, files));
  };
  parameters p{};
  cca::training<learner, 2000> learning;
  v2 last = v2::Zero();

  laws::module_firing fire(double time, laws::shown what, const v2& shown, cca::learning_call call) {
    const v1 x(time);
    if (What != kind::refusing) learning.obey(call);
    const v2 y = what == laws::shown::broken ? v2(v2::Constant(no_number)) : shown;
    if (what != laws::shown::nothing) {
      learning.teach(x, y, p.settings);
      if (What == kind::repeating) last = y;
    }
    return laws::firing_of(What == kind::refusing ? no_number : last[0], 0,
                           cca::sample<cca::module_status_port>(learning.status(x, p.settings)));
  }
  void on_load() {
    if (!p.files.load.view().empty() && What == kind::refusing) throw cca::refused("no");
    if (!p.files.load.view().empty() && What == kind::repeating)
      learning.load(std::string(p.files.load.view()), {});
  }
  void on_save() {
    if (!p.files.save.view().empty() && What == kind::repeating)
      learning.save(std::string(p.files.save.view()), {});
  }
  void on_start() {}
};
template <kind What>
struct puppet_case {
  using module = puppet<What>;
  using other_size = puppet<What, 2>;
  using other_space = puppet<What, 3>;
  static constexpr int lesson = 500;
  static constexpr double bound = 0.03;
  static v2 truth(double t) { return v2(0.3 * std::sin(3 * t), 0.2 * std::cos(2 * t)); }
  template <class Module>
  static laws::module_firing fire(Module& m, int k, laws::shown what, cca::learning_call call) {
    return m.fire(1e-3 * k, what, truth(1e-3 * k), call);
  }
  template <class Module>
  static double worst(Module& m) {
    double most = 0;
    for (int k = 0; k < lesson; ++k) {
      const double off =
          fire(m, k, laws::shown::nothing, cca::learning_call::nothing).command - truth(1e-3 * k)[0];
      most = std::abs(off) <= most ? most : std::abs(off);
    }
    return most;
  }
  static void change(auto& p) { p.settings.none = 1; }
};

// ---- requests ----

// One does nothing and answers nothing, one refuses everything, one says yes to everything and does nothing.
template <kind What>
struct deaf_case : laws::lone_learner<lesson<What>> {
  using student = typename laws::lone_learner<lesson<What>>::student;
  static laws::told_of_request fire(student& s, double call, bool) {
    if (call != 0)
      s.answer = What == kind::refusing ? cca::learning_answer::impossible : cca::learning_answer::accepted;
    return {s.learning.state(), cca::trained_region::outside,
            What == kind::nothing ? cca::learning_answer::none : s.answer};
  }
};

// ---- adaptive components ----

struct wished {
  auto process(cca::beat now) -> cca::out<"y", leg> {
    return v2(now.index() < 300 ? v2(0.1, 0.2) : v2(1, 1));
  }
};
template <kind What>
struct constant_criterion {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::error_limits<cca::angle>, limits));
  };
  parameters p{};
  auto process(cca::in<"reference", leg>)
      -> std::tuple<cca::out<"error", cca::criterion_error>, cca::out<"state", cca::criterion_port>> {
    return {What == kind::refusing ? 1e12 : 0.0,
            cca::status_of(What == kind::nothing    ? cca::criterion_state::open
                           : What == kind::refusing ? cca::criterion_state::lost
                                                    : cca::criterion_state::fulfilled)};
  }
};
struct constant_module {
  auto process(cca::in<"reference", leg>)
      -> std::tuple<cca::out<"ode", cca::ode_status_port>, cca::out<"module", cca::module_status_port>> {
    return {cca::status_of(cca::ode_status::converged),
            cca::status_of(cca::learning::idle, cca::trained_region::inside)};
  }
};
template <kind What>
struct constant_skill : cca::graph<cca::node<"module", constant_module>,
                                   cca::node<"criterion", constant_criterion<What>>,
                                   cca::node<"status", cca::status_of_component<false>>,
                                   cca::expose<"module.reference", "reference">,
                                   cca::expose<"criterion.reference", "same">,
                                   cca::wire<"module.ode", "status.ode">,
                                   cca::wire<"module.module", "status.module">,
                                   cca::wire<"criterion.state", "status.criterion">> {};
template <kind What>
struct skilled : cca::graph<cca::rate<1000>,
                            cca::node<"wish", wished>,
                            cca::node<"skill", constant_skill<What>>,
                            cca::wire<"wish.y", "skill.reference">,
                            cca::wire<"wish.y", "skill.same">,
                            cca::observe<"skill.**.*">> {};
template <kind What>
struct skill_case {
  using graph = skilled<What>;
  static constexpr int beats = 600;
  static constexpr bool at_rest = false;
  static void prepare(cca::controller<graph>&) {}
  static std::set<cca::component_status> expected() {
    return {cca::component_status::converging, cca::component_status::reached,
            cca::component_status::diverged};
  }
};

}  // namespace

TEST_CASE("ode") {
  try_model("ode", does_nothing, 3, laws::ode<flat_case<kind::nothing>>);
  try_model("ode", refuses, 9, laws::ode<flat_case<kind::refusing>>);
  try_model("ode", repeats, 3, laws::ode<flat_case<kind::repeating>>);
}
TEST_CASE("criterion") {
  try_model("criterion", does_nothing, 2, laws::criterion<judged_case<kind::nothing>>);
  try_model("criterion", refuses, 2, laws::criterion<judged_case<kind::refusing>>);
  try_model("criterion", repeats, 2, laws::criterion<judged_case<kind::repeating>>);
}
TEST_CASE("learner") {
  try_model("learner", does_nothing, 3, laws::learner<lesson<kind::nothing>>);
  try_model("learner", refuses, 4, laws::learner<lesson<kind::refusing>>);
  try_model("learner", repeats, 3, laws::learner<lesson<kind::repeating>>);
}
TEST_CASE("module") {
  try_model("adaptive module", does_nothing, 3, laws::adaptive_module<puppet_case<kind::nothing>>);
  try_model("adaptive module", refuses, 4, laws::adaptive_module<puppet_case<kind::refusing>>);
  try_model("adaptive module", repeats, 3, laws::adaptive_module<puppet_case<kind::repeating>>);
}
TEST_CASE("requests") {
  try_model("requests", does_nothing, 5, laws::requests<deaf_case<kind::nothing>>);
  try_model("requests", refuses, 4, laws::requests<deaf_case<kind::refusing>>);
  try_model("requests", repeats, 5, laws::requests<deaf_case<kind::repeating>>);
}
TEST_CASE("adaptive component") {
  try_model("adaptive component", does_nothing, 1, laws::adaptive_component<skill_case<kind::nothing>>);
  try_model("adaptive component", refuses, 1, laws::adaptive_component<skill_case<kind::refusing>>);
  try_model("adaptive component", repeats, 1, laws::adaptive_component<skill_case<kind::repeating>>);
}

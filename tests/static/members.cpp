// Components with members of many kinds compile, start, run and are copied if they can be. g++ 12.2 crashed
// on some of them (internal compiler error in gimplify_var_or_parm_decl) as long as an aggregate initialised
// the components of a controller: with `double x = 0;` beside a std::vector, a std::unique_ptr or a
// std::optional<std::vector>. This file is compiled twice, at -O0 and at -O2.
#include <array>
#include <atomic>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <cca/cca.hpp>

namespace {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}};
};
struct angles : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};

struct aggregate {
  double number = 0;
  std::vector<int> numbers{1, 2, 3};
};
enum class color { red, green };

// The joint of docs/how_it_becomes_one_loop.md, with another member before or after its angle.
template <class Member>
struct member_after {
  auto sense() -> cca::out<"angle", angles> { return angle; }
  void act(cca::in<"command", angles> to) { angle = to[hip{}]; }
  double angle = 0;
  Member member{};
};
template <class Member>
struct member_before {
  auto sense() -> cca::out<"angle", angles> { return angle; }
  void act(cca::in<"command", angles> to) { angle = to[hip{}]; }
  Member member{};
  double angle = 0;
};
template <class Member>
struct member_without_initializer {
  auto sense() -> cca::out<"angle", angles> { return angle; }
  void act(cca::in<"command", angles> to) { angle = to[hip{}]; }
  Member member;
  double angle = 0.1;
};
template <class Member>
struct member_and_constructor {
  member_and_constructor() : angle(0) {}
  auto sense() -> cca::out<"angle", angles> { return angle; }
  void act(cca::in<"command", angles> to) { angle = to[hip{}]; }
  double angle;
  Member member{};
};

struct ramp {
  double value = 0;
  auto process(cca::beat) -> cca::out<"angle", angles> { return value += 0.001; }
};

template <class Joint>
struct moved : cca::graph<cca::node<"ramp", ramp>,
                          cca::node<"limits", cca::limiter<angles>>,
                          cca::node<"joint", Joint>,
                          cca::wire<"ramp.angle", "limits.command">,
                          cca::wire<"limits.safe", "joint.command">> {};

// What a user's main function does with it.
template <class Joint>
void use() {
  cca::controller<moved<Joint>> controller;
  controller.load();
  controller.start();
  controller.step();
  if constexpr (std::is_copy_constructible_v<Joint>) {
    cca::controller<moved<Joint>> copy = controller;
    copy.step();
  }
}

}  // namespace

void use_members_of_many_kinds();
void use_members_of_many_kinds() {
  use<member_after<std::vector<double>>>();
  use<member_before<std::vector<double>>>();
  use<member_after<std::unique_ptr<int>>>();
  use<member_before<std::unique_ptr<int>>>();
  use<member_after<std::optional<std::vector<int>>>>();
  use<member_before<std::optional<std::vector<int>>>>();
  use<member_without_initializer<std::vector<double>>>();
  use<member_and_constructor<std::unique_ptr<int>>>();
  use<member_after<std::tuple<color, std::array<double, 3>, Eigen::Vector3d, Eigen::VectorXd>>>();
  use<member_after<std::pair<aggregate, std::variant<int, std::vector<int>>>>>();
  use<member_before<std::map<int, std::string>>>();
  use<member_after<std::function<void()>>>();
  use<member_before<std::shared_ptr<std::vector<int>>>>();
  use<member_after<std::deque<std::string>>>();
  use<member_before<std::atomic<int>>>();
  use<member_after<std::mutex>>();
}

// A contract as cca-policy writes it, of a leg: gyro and joint angles to joint angles, at 50 Hz.
#pragma once
#include <cca/cca.hpp>
#include <cca/mapping/imported/imported_policy.hpp>
#include <cca/mapping/network/operators.hpp>

namespace walk {

struct network {
  static constexpr int inputs = 5, outputs = 2, memory = 0, weights = 12;
  template <class Number>
  static cca::neural::numbers<Number, outputs> answer(
      const Number* w,
      const cca::neural::numbers<Number, inputs>& observed,
      [[maybe_unused]] cca::neural::numbers<Number, memory>& kept) {
    return cca::neural::dense<2>(w, observed);
  }
};
struct gyro {
  static constexpr std::string_view name = "gyro", is = "turning_in<trunk>";
  static constexpr std::array<cca::policy_number, 3> numbers{{{"x"}, {"y"}, {"z"}}};
};
struct joint_pos {
  static constexpr std::string_view name = "joint_pos", is = "joint_angles";
  static constexpr std::array<cca::policy_number, 2> numbers{{{"hip", 0.1}, {"knee", -0.8}}};
};
struct action {
  static constexpr std::string_view name = "action", is = "joint_angles";
  static constexpr std::array<cca::policy_number, 2> numbers{{{"hip", 0.1, 0.25}, {"knee", -0.8, 0.25}}};
  static constexpr bool observed_clipped = false;
};
struct contract {
  static constexpr std::string_view name = "walk";
  static constexpr double rate = 50;
  using number = float;
  using network = walk::network;
  using terms = cca::policy_terms<gyro, joint_pos>;
  using action = walk::action;
  static constexpr int history = 1;
  static constexpr cca::history_layout layout = cca::history_layout::by_term;
  static constexpr cca::history_order order = cca::history_order::oldest_first;
  static constexpr cca::history_start start = cca::history_start::repeated;
  static constexpr double oldest = 0.1;
  static constexpr std::array<cca::policy_gains, 2> gains{{{"hip", 25, 0.5}, {"knee", 25, 0.5}}};
  static constexpr std::array<std::string_view, 1> lines{"rate 50 Hz"};
};

}  // namespace walk

struct trunk : cca::frame<"trunk"> {};
struct imu : cca::frame<"imu"> {};
template <class Frame>
struct turning_in : cca::number {};
struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct rates : cca::space<turning_in<trunk>, xyz> {};
struct angles : cca::space<cca::joint_angles, cca::axes<knee, hip>> {};
struct targets : cca::space<cca::joint_angles, cca::axes<knee, hip>, cca::rate<50>> {};

// A joint of a robot and the drive that moves it, as a type: axis, drive, mounting, servo, bus.
//
//   struct left_front
//       : cca::hardware::joint<cca::robots::oncilla::left_front_hip,
//                              cca::hardware::mit_drive<cca::hardware::ak60_6, 1>,
//                              cca::hardware::mounting{.gear = 1, .sign = -1, .offset = 0.2},
//                              cca::hardware::joint_servo{.stiffness = 30, .damping = 0.375},
//                              0> {};
//
// Angle of the joint = sign (angle of the drive / gear) + offset; gear is turns of the drive's output per
// turn of the joint. Torque of the joint = sign gear (torque of the drive). All drives on one bus state the
// same bit rates, by default 1 Mbit/s, and 5 for fast FD frames (checked by robot_buses.hpp). The limits are
// those of the axis, as far as the drive's frames can express them; a continuous axis needs none of angle,
// but a drive that counts on or wraps. Errors: space.missing_limits, drive.bad_joint. Cost: constants, and
// some multiplications. docs/hardware.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string_view>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/drives/drive.hpp>
#include <cca/space/limits.hpp>
#include <cca/space/quantity.hpp>
#include <cca/space/space.hpp>

namespace cca::hardware {

// [mounting]
struct mounting {
  double gear = 1;    // turns of the drive's output per turn of the joint, above 0
  double sign = 1;    // 1, or -1: the drive turns the other way round
  double offset = 0;  // rad, the joint's angle where the drive's is 0
  double wraps = 0;   // rad, by which the drive's position jumps back at the end of its range; 0: it does not
};
// [mounting end]

// [servo]
struct joint_servo {
  double stiffness = 0;     // N m/rad, while it follows commands
  double damping = 0;       // N m s/rad, likewise
  double safe_damping = 1;  // N m s/rad, after a stop and before the first command
  double most_stiff = 200;  // N m/rad, the largest that a controller can ask for
  double most_damping = 5;  // N m s/rad, likewise
};
// [servo end]

struct joint_bounds {
  double lower, upper;
  constexpr double nearest(double x) const { return x < lower ? lower : x > upper ? upper : x; }
  constexpr bool holds(double x) const { return lower <= x && x <= upper; }
};

namespace detail {

// The limits that a drive needs: of velocity, torque and, unless the axis is continuous, angle.
template <class Axis>
struct stated_limits {
  static constexpr bool angle = is_continuous<Axis> || cca::detail::axis_has_limits<Axis, cca::angle>,
                        velocity = cca::detail::axis_has_limits<Axis, cca::velocity>,
                        torque = cca::detail::axis_has_limits<Axis, cca::torque>,
                        sound = angle && velocity && torque;
  static constexpr void tell(auto& m) {
    m << "space.missing_limits: the axis `" << Axis::name << "` of a joint states no limits of ";
    const auto list = [&](std::string_view before, std::string_view between, std::string_view after) {
      bool any = false;
      const auto add = [&](bool stated, std::string_view quantity) {
        if (stated) return;
        if (any) m << between;
        m << before << quantity << after;
        any = true;
      };
      add(angle, "angle"), add(velocity, "velocity"), add(torque, "torque");
    };
    list("", " and ", "");
    m << "; a drive is commanded only within limits: add ";
    list("`cca::", ", ", "{lower, upper}`");
    m << " to the `limits` of its dimension";
    if (!angle) m << ", or `static constexpr bool continuous = true;` if it turns without end";
  }
};

// Turns of the drive's output until its position ends.
template <Drive Device>
constexpr double turns_of() {
  if constexpr (Device::limits.template has<cca::angle>)
    return (Device::limits.template of<cca::angle>().upper - Device::limits.template of<cca::angle>().lower) /
           (2 * std::numbers::pi);
  else return std::numeric_limits<double>::infinity();
}

template <class Axis, mounting Mounting>
struct bad_mounting {
  static constexpr void tell(auto& m) {
    m << "drive.bad_joint: the mounting of the joint `" << Axis::name << "` is impossible: ";
    if (!(Mounting.gear > 0))
      m << "its `gear` is " << Mounting.gear
        << ", and it is above 0; a drive that turns the other way round has `sign` -1";
    else if (Mounting.sign != 1 && Mounting.sign != -1)
      m << "its `sign` is " << static_cast<double>(Mounting.sign) << ", and it is 1 or -1";
    else m << "its `wraps` is " << Mounting.wraps << ", and it is the width of a range, or 0";
  }
};
template <class Axis, joint_servo Servo>
struct bad_safe_damping {
  static constexpr void tell(auto& m) {
    m << "drive.bad_joint: `safe_damping` of the servo of the joint `" << Axis::name
      << "`, with which it stops, is " << Servo.safe_damping
      << (Servo.safe_damping < 0 ? ", below 0" : ", above its `most_damping`, ");
    if (!(Servo.safe_damping < 0)) m << Servo.most_damping;
    m << "; raise `most_damping`, or stop more softly";
  }
};
template <class Axis, class Device, mounting Mounting>
struct wheel_without_wraps {
  static constexpr void tell(auto& m) {
    m << "drive.bad_joint: the axis `" << Axis::name
      << "` of this joint is continuous, but the position of its "
      << "drive, " << Device::name << ", ends after " << turns_of<Device>() / Mounting.gear
      << " turns of the joint: state in `wraps` of the mounting the width of the range after which it begins "
         "again, or use a drive that counts on";
  }
};

// In a function; cca/mapping/mapping.hpp says why.
template <class Axis, Drive Device, mounting Mounting, joint_servo Servo>
constexpr auto check_joint() {
  using cca::detail::holds_or_tells;
  constexpr bool is_mounted =
      Mounting.gear > 0 && (Mounting.sign == 1 || Mounting.sign == -1) && Mounting.wraps >= 0;
  constexpr bool stops = Servo.safe_damping >= 0 && Servo.safe_damping <= Servo.most_damping;
  constexpr bool turns_on =
      !is_continuous<Axis> || Mounting.wraps > 0 || turns_of<Device>() / Mounting.gear >= 1000;
  static_assert(holds_or_tells<is_mounted, bad_mounting<Axis, Mounting>>::value);
  static_assert(holds_or_tells<stops, bad_safe_damping<Axis, Servo>>::value);
  static_assert(holds_or_tells<stated_limits<Axis>::sound, stated_limits<Axis>>::value);
  static_assert(
      holds_or_tells<(turns_on || !is_mounted), wheel_without_wraps<Axis, Device, Mounting>>::value);
}

}  // namespace detail

template <class Axis,
          Drive Device,
          mounting Mounting,
          joint_servo Servo,
          std::size_t Bus = 0,
          bit_rates Rates = bit_rates{}>
struct joint {
  using axis = Axis;
  using drive = Device;
  static constexpr mounting mounted = Mounting;
  static constexpr joint_servo servo = Servo;
  static constexpr std::size_t bus = Bus;
  static constexpr bit_rates rates = Rates;

  using checked = decltype(detail::check_joint<Axis, Device, Mounting, Servo>());

  static constexpr double angle_of(double drive_angle) {
    return Mounting.sign * drive_angle / Mounting.gear + Mounting.offset;
  }
  static constexpr double drive_angle_of(double of_joint) {
    return Mounting.sign * (of_joint - Mounting.offset) * Mounting.gear;
  }
  static constexpr double speed_of(double drive_speed) { return Mounting.sign * drive_speed / Mounting.gear; }
  static constexpr double drive_speed_of(double of_joint) { return Mounting.sign * of_joint * Mounting.gear; }
  static constexpr double torque_of(double drive_torque) {
    return Mounting.sign * drive_torque * Mounting.gear;
  }
  static constexpr double drive_torque_of(double of_joint) {
    return Mounting.sign * of_joint / Mounting.gear;
  }

  // A command to the joint as a command to its drive, and back. Stiffness and damping scale with the square
  // of the gear.
  static constexpr drive_command to_drive(const drive_command& c) {
    constexpr double square = Mounting.gear * Mounting.gear;
    return {drive_angle_of(c.position), drive_speed_of(c.velocity), drive_torque_of(c.torque),
            c.stiffness / square, c.damping / square};
  }
  static constexpr drive_command from_drive(const drive_command& c) {
    constexpr double square = Mounting.gear * Mounting.gear;
    return {angle_of(c.position), speed_of(c.velocity), torque_of(c.torque), c.stiffness * square,
            c.damping * square};
  }

  static constexpr joint_bounds angle = {cca::detail::lower_limit_of<Axis, cca::angle>,
                                         cca::detail::upper_limit_of<Axis, cca::angle>};
  static constexpr joint_bounds speed = {cca::detail::lower_limit_of<Axis, cca::velocity>,
                                         cca::detail::upper_limit_of<Axis, cca::velocity>};
  static constexpr joint_bounds torque = {cca::detail::lower_limit_of<Axis, cca::torque>,
                                          cca::detail::upper_limit_of<Axis, cca::torque>};
  // N m/s, for the torque that a set-point feeds forward. If the axis states no `torque_rate`: the whole
  // range in 10 ms.
  static constexpr double torque_rate = [] {
    if constexpr (cca::detail::axis_has_limits<Axis, cca::torque_rate>)
      return cca::detail::upper_limit_of<Axis, cca::torque_rate>;
    else return (torque.upper - torque.lower) / 0.01;
  }();
};

// The joints of a robot, in the order of its axes.
template <class... Joints>
struct joint_list {
  static constexpr std::size_t count = sizeof...(Joints);
  using axes = cca::axes<typename Joints::axis...>;
  static constexpr std::array<joint_bounds, count> angle{Joints::angle...}, speed{Joints::speed...},
      torque{Joints::torque...};
  static constexpr std::array<double, count> torque_rate{Joints::torque_rate...};
  static constexpr std::array<joint_servo, count> servo{Joints::servo...};
  static constexpr std::array<std::string_view, count> names{Joints::axis::name...};
  static constexpr std::array<bool, count> continuous{is_continuous<typename Joints::axis>...};
};

namespace detail {

// Of `connect(...)`.
template <std::size_t Given, class Board, class... J>
struct other_count_of_buses {
  static constexpr void tell(auto& m) {
    constexpr std::size_t last = std::max({Board::bus, J::bus...});
    m << "robot.drives: " << static_cast<std::int64_t>(Given) << (Given == 1 ? " bus is" : " buses are")
      << " connected, and the joints and the board of this robot are on "
      << static_cast<std::int64_t>(last + 1) << ": give one for each number from 0 to "
      << static_cast<std::int64_t>(last);
    const char* between = "; on the last is `";
    const auto one = [&](bool is_there, std::string_view name) {
      if (is_there) m << between << name << "`", between = ", `";
    };
    (one(J::bus == last, J::axis::name), ...);
  }
};
// The same of a bus of another type.
template <class Bus, class... Given>
struct other_type_of_bus {
  static constexpr bool none = (std::is_convertible_v<Given*, Bus*> && ...);
  static constexpr void tell(auto& m) {
    std::int64_t number = -1;
    (void)((++number, one<Given>(m, number)) || ...);
  }

private:
  template <class One>
  static constexpr bool one(auto& m, std::int64_t number) {
    if (std::is_convertible_v<One*, Bus*>) return false;
    m << "robot.drives: bus " << number << " that is connected is of the type "
      << cca::detail::type_name<One>() << ", and the buses of this robot are of the type "
      << cca::detail::type_name<Bus>()
      << ", which stands before its joints: connect such a bus, or state the other type there";
    return true;
  }
};

template <class Bus, class Board, class Joints, class... Given>
struct mistake_of_buses;
template <class Bus, class Board, class... J, class... Given>
struct mistake_of_buses<Bus, Board, joint_list<J...>, Given...> {
  using types = other_type_of_bus<Bus, Given...>;
  static constexpr bool all_given = sizeof...(Given) == 1 + std::max({Board::bus, J::bus...});
  static constexpr bool none = all_given && types::none;
  static constexpr void tell(auto& m) {
    if (all_given) types::tell(m);
    else other_count_of_buses<sizeof...(Given), Board, J...>::tell(m);
  }
};

}  // namespace detail

}  // namespace cca::hardware

// A drive whose family, number and ranges are known only at run time; and such a drive, played.
//
// The codecs of cca::hardware are types. Each family becomes a type once, with number 1 and ranges of 1 (a
// "unit drive"); here its frames get their real number, and its numbers their real size.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <cca/hardware/drive.hpp>
#include <cca/hardware/virtual_drive.hpp>

namespace cca_can {

namespace hw = cca::hardware;

// 1 of a unit drive's numbers in SI units.
struct drive_scale {
  double position = 1, velocity = 1, torque = 1, stiffness = 1, damping = 1;
  // rad, the width of the range of the positions that it reports, half of it on each side of 0: at its end
  // the position begins again. 0: it goes on.
  double wraps = 0;
  bool may_stay = false;  // at the end of that range, instead: it depends on the firmware

  hw::drive_command to_drive(const hw::drive_command& c) const {
    return {c.position / position, c.velocity / velocity, c.torque / torque, c.stiffness / stiffness,
            c.damping / damping};
  }
  hw::drive_command from_drive(const hw::drive_command& c) const {
    return {c.position * position, c.velocity * velocity, c.torque * torque, c.stiffness * stiffness,
            c.damping * damping};
  }
};

// What a drive has reported about its settings.
struct drive_settings {
  std::optional<std::uint32_t> mode{}, most_torque{};
};

class any_drive {
public:
  std::string text;       // its name on the command line: "mit:ak80-9:3"
  std::string family;     // "MIT, AK firmware"
  std::uint8_t uses = 0;  // drive_quantity: what a set point has
  bool needs_fd = false, clocked = false;
  bool scaled = true;  // false: its ranges are unknown, so only its position is known
  double wraps = 0;    // of drive_scale; what it reports and takes is within this range, `talk` unwraps it
  bool may_stay = false;

  virtual ~any_drive() = default;
  bool takes_gains() const { return (uses & hw::of_stiffness) != 0; }
  bool takes_torque_alone() const { return uses == hw::of_torque; }

  // Settings that must be known before it may be enabled. ask_settings gives the frames that ask for what is
  // not yet known, and is empty when nothing is missing. wrong_setting says why the settings don't agree with
  // the drive's name, or allow more than this torque (0: any); empty: they do agree.
  virtual hw::drive_frames ask_settings() const { return {}; }
  virtual void hear_setting(const hw::can_frame&) {}
  virtual std::string wrong_setting(double) const { return {}; }

  // Frames that it answers and that can't move it. None: it reports by itself.
  virtual hw::drive_frames ask() const = 0;
  // The same for its position and state.
  virtual hw::drive_frames ask_state() const = 0;
  virtual bool decode(const hw::can_frame& f, hw::drive_report& r) const = 0;
  // Whether the frame comes from it, even if it says nothing about its state.
  virtual bool is_from(const hw::can_frame& f) const = 0;
  virtual hw::set_point_frames set_point(const hw::drive_command& c, double most_torque) const = 0;
  virtual hw::drive_frames disable() const = 0;
  virtual void begin() = 0;
  virtual hw::enable_step enable(const hw::drive_report& r) = 0;
};

// Drive: number 1, ranges of 1. Address: `to_real(frame)` changes number 1 to the real one, `to_unit(frame)`
// back (false: not this drive's frame); `ask(to_real)`: see any_drive.
template <hw::Drive Drive, class Address>
class drive_at : public any_drive {
public:
  drive_at(Address a, drive_scale s) : address(a), scale(s) {
    uses = Drive::uses;
    family = Address::family;
    needs_fd = Address::needs_fd;
    clocked = Address::clocked;
    wraps = s.wraps;
    may_stay = s.may_stay;
  }

  hw::drive_frames ask_settings() const override {
    if constexpr (requires { address.template ask_settings<Drive>(settings); })
      return address.template ask_settings<Drive>(settings);
    else return {};
  }
  void hear_setting(const hw::can_frame& f) override {
    if constexpr (requires { address.hear_setting(f, settings); }) address.hear_setting(f, settings);
  }
  std::string wrong_setting(double torque) const override {
    if constexpr (requires { address.template wrong_setting<Drive>(settings, torque, 1.0); })
      return address.template wrong_setting<Drive>(settings, torque, scale.torque);
    else return {};
  }
  hw::drive_frames ask() const override { return address.ask(); }
  hw::drive_frames ask_state() const override { return address.ask_state(); }
  bool decode(const hw::can_frame& f, hw::drive_report& r) const override {
    hw::can_frame unit = f;
    if (!address.to_unit(unit)) return false;
    // The codec works in the unit drive's numbers, all others in SI units.
    hw::drive_report heard = r;
    if (!Drive::decode(unit, heard)) return false;
    if (heard.told & hw::of_position) heard.position *= scale.position;
    if (heard.told & hw::of_velocity) heard.velocity *= scale.velocity;
    if (heard.told & hw::of_torque) heard.torque *= scale.torque;
    r = heard;
    return true;
  }
  bool is_from(const hw::can_frame& f) const override {
    hw::can_frame unit = f;
    hw::drive_report r;
    return address.is_answer(f) || (address.to_unit(unit) && Drive::decode(unit, r));
  }
  hw::set_point_frames set_point(const hw::drive_command& c, double most_torque) const override {
    hw::set_point_frames s = address.template set_point<Drive>(scale.to_drive(c), most_torque);
    s.frames = real(s.frames);
    return s;
  }
  hw::drive_frames disable() const override { return real(Drive::disable()); }
  void begin() override { way = {}; }
  hw::enable_step enable(const hw::drive_report& r) override {
    hw::drive_report unit = r;
    unit.position /= scale.position;
    unit.velocity /= scale.velocity;
    unit.torque /= scale.torque;
    hw::enable_step s = way.next(unit);
    s.frames = real(s.frames);
    return s;
  }

private:
  hw::drive_frames real(const hw::drive_frames& unit) const {
    hw::drive_frames all;
    for (hw::can_frame f : unit) {
      address.to_real(f);
      all.add(f);
    }
    if (clocked && all.size() < 8)
      all.add({.id = hw::standard(0x080)});  // CANopen's SYNC: now the drive acts
    return all;
  }

  Address address;
  drive_scale scale;
  drive_settings settings{};
  typename Drive::enabling way{};
};

// A drive that is played: firmware, motor and load.
class any_virtual {
public:
  virtual ~any_virtual() = default;
  virtual bool hear(const hw::can_frame& f, std::int64_t now) = 0;
  // Moves until `now`, and gives the answers.
  virtual hw::drive_frames advance(std::int64_t now) = 0;
  virtual hw::drive_command law(std::int64_t now) = 0;
  virtual void go_silent(bool yes) = 0;
  virtual void fail(std::uint32_t code) = 0;
  hw::virtual_motor motor{};
  double load = 0;  // N m
};

template <hw::VirtualDrive Virtual, class Address>
class virtual_at : public any_virtual {
public:
  virtual_at(Address a, drive_scale s) : address(a), scale(s) { motor.most_torque = scale.torque; }

  bool hear(const hw::can_frame& f, std::int64_t now) override {
    hw::can_frame unit = f;
    if constexpr (requires { address.template answer<typename Virtual::drive>(f); })
      if (const auto said = address.template answer<typename Virtual::drive>(f)) return told = said, true;
    if constexpr (requires { address.to_unit_request(unit); })
      return address.to_unit_request(unit) && drive.hear(unit, now);
    else return address.to_unit(unit) && drive.hear(unit, now);
  }
  hw::drive_frames advance(std::int64_t now) override {
    if (now > then && then >= 0) motor.advance(law(now), load, static_cast<double>(now - then) * 1e-9);
    then = now;
    hw::drive_frames all;
    if (told) all.add(*told), told.reset();
    for (hw::can_frame f :
         drive.answer({(motor.now.position - turned()) / scale.position, motor.now.velocity / scale.velocity,
                       motor.now.torque / scale.torque})) {
      address.to_real(f);
      all.add(f);
    }
    return all;
  }
  hw::drive_command law(std::int64_t now) override {
    hw::drive_command c = scale.from_drive(drive.law(now));
    c.position += turned();
    return c;
  }
  void go_silent(bool yes) override { drive.go_silent(yes); }
  void fail(std::uint32_t code) override { drive.fail(code); }

private:
  // How far the motor is from what a drive that wraps reports: whole widths.
  double turned() const {
    if (scale.wraps == 0 || scale.may_stay) return 0;
    return scale.wraps * std::round(motor.now.position / scale.wraps);
  }

  Address address;
  drive_scale scale;
  Virtual drive{};
  std::optional<hw::can_frame> told{};  // about its settings
  std::int64_t then = -1;
};

}  // namespace cca_can

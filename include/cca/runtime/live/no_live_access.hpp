// The live_access of a controller that breaks a rule. The compiler says what is wrong with the controller,
// and this has all that a program calls, so nothing else is reported.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <cca/base/fixed_string.hpp>
#include <cca/component/fault.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/runtime/live/live_output.hpp>
#include <cca/runtime/refusal.hpp>

namespace cca::detail {

struct no_live_access {
  ~no_live_access() {}

  bool operator()(const auto&) { return false; }
  std::optional<live_sample> newest(std::string_view) const { return {}; }
  template <fixed_string Path>
  bool set(anything) {
    return false;
  }
  bool set(std::string_view, anything) { return false; }
  bool load(std::string_view, std::string_view = {}) { return false; }
  bool save(std::string_view, std::string_view = {}) { return false; }
  std::optional<std::string> parameter(std::string_view) { return {}; }
  bool stop(std::string_view) { return false; }
  bool start(std::string_view) { return false; }
  bool switch_to(std::string_view) { return false; }
  template <fixed_string Mode>
  bool switch_to() {
    return false;
  }
  bool is_taken() const noexcept { return false; }
  std::string refused_by() const { return {}; }
  cca::state state() const noexcept { return {}; }
  std::int64_t beat_index() const noexcept { return 0; }
  std::int64_t overruns() const noexcept { return 0; }
  cca::fault fault() const noexcept { return {}; }
  std::string_view mode() const noexcept { return {}; }
  void end_run() noexcept {}
  void pause() {}
  void go_on() {}
  void step() {}
  bool is_paused() const noexcept { return false; }
  void set_speed(double) {}
  bool has_refused_speed() const noexcept { return false; }
};

}  // namespace cca::detail

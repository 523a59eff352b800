// robot.unlimited_command: every command to an actuator passes a limiter, and so does every initial value
// that a wire states.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>
#include <cca/graph/plan/commands.hpp>

namespace cca::detail {

struct robot_unlimited_command {
  static constexpr std::string_view id = "robot.unlimited_command";

  static constexpr bool is_broken(when::finished_input, const flat_view& g, finding& f) {
    const int actuator = f.input;
    const auto& in = g.inputs[actuator];
    if (!is_actuated(g, in)) return false;
    if (const int way = unlimited_way(g, actuator); way >= 0) {
      f.item = g.inputs[way].wire;
      f.output = g.inputs[way].writer;
      return true;
    }
    if (const auto beyond = find_initial_beyond_limits(g, actuator); beyond.axis >= 0) {
      const auto& wired = g.inputs[beyond.input];
      f.item = wired.initial;
      f.scope = scope_of_call(g, g.calls[wired.call]);
      f.input = beyond.input;
      f.other_input = actuator;
      f.axis = beyond.axis;
      return true;
    }
    return false;
  }

  static constexpr void tell(auto& m) {
    m.at_wire();
    if (m.found().axis >= 0) return tell_initial(m);
    const auto& to = m.g.inputs[m.found().input];
    m.port(m.g.outputs[m.found().output]);
    m.say() << " reaches the actuator ";
    m.port(to);
    m.say() << " without passing a limiter: put a cca::limiter<" << m.space(to).name
            << "> between them (its input is `command`, its output `safe`), or a cca::unlimited where that "
               "is meant";
  }

private:
  static constexpr void tell_initial(auto& m) {
    const auto& in = m.g.inputs[m.found().input];
    m.port(in);
    m.say() << " may be read before a first command has passed a limiter, and would then hold the "
               "cca::initial of its "
               "wire, which lies outside of the limits of `"
            << m.space(in).axes[m.found().axis] << "`, on its way to the actuator";
    if (m.found().input != m.found().other_input) {
      m.say() << " ";
      m.port(m.g.inputs[m.found().other_input]);
    }
    m.say() << ": give the wire a cca::initial<...> within them";
  }
};

}  // namespace cca::detail

// modes.command_jumps: what goes to an actuator comes from the same limiter in every mode, and in the same
// way. The limiter goes on from its last command, so at a switch no command jumps.
#pragma once

#include <cca/graph/modes/events_of_modes.hpp>

namespace cca::detail {

struct modes_command_jumps {
  static constexpr std::string_view id = "modes.command_jumps";

  static constexpr bool is_broken(when::parting_commands, const flat_view&, const finding&) { return true; }

  static constexpr void tell(auto& m) {
    const auto& f = m.found();
    m.at_node();
    m.where << "." << f.name;
    m.say() << "`" << m.where.view() << "` gets its commands ";
    if (f.output >= 0 && f.output == other_output(f)) {
      m.say() << "from ";
      m.port(m.g.outputs[f.output]);
      m.say() << " in ";
      m.mode(in_mode(f));
      m.say() << " and in ";
      m.mode(other_mode(f));
      m.say()
          << ", but by wires of different delay or queue, so at a switch they could jump: give both wires "
             "the same policy";
      return;
    }
    from(m, f.output, in_mode(f));
    m.say() << " but ";
    from(m, other_output(f), other_mode(f));
    m.say()
        << ", so at a switch they could jump: put one cca::limiter in front of it that both modes have, of "
           "the same path and type; it goes on from its last command, at most at the rates of the axes";
  }

private:
  static constexpr void from(auto& m, int output, int mode) {
    if (output < 0) {
      m.say() << "from nothing";
    } else {
      m.say() << "from ";
      m.port(m.g.outputs[output]);
    }
    m.say() << " in ";
    m.mode(mode);
  }
};

}  // namespace cca::detail

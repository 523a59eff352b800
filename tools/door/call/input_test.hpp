// cca-call test: a signal on an input of the running program, and what came of it.
#pragma once

#include <chrono>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <string>
#include <string_view>

#include <cca/base/refused.hpp>
#include <cca/main/command_line.hpp>

#include "conversation.hpp"
#include "options.hpp"

namespace cca_door {

// `chirp amplitude=0.05 frequency=1 to=50 axis=elbow`: the arguments of /cca/test.
inline json arguments_of_test(const call_options& o) {
  json all{{"input", o.words[0]}, {"output", o.words[1]}, {"signal", o.words[2]}};
  for (std::size_t i = 3; i < o.words.size(); ++i) {
    const std::size_t equals = o.words[i].find('=');
    if (equals == 0 || equals == std::string::npos)
      throw cca::command_line_error(o.words[i] + ": expected NAME=VALUE, as amplitude=0.1");
    const std::string name = o.words[i].substr(0, equals), value = o.words[i].substr(equals + 1);
    const bool is_axis = name == "axis" || name == "output_axis" || name == "from_axis";
    const bool is_named = value.empty() || value.find_first_not_of("0123456789") != value.npos;
    if (name == "from" || (is_axis && is_named)) all[name] = value;
    else if (is_axis) all[name] = cca::whole_number_in(name, value, 0, 999);
    else all[name] = cca::number_in(name, value, -1e12, 1e12);
  }
  return all;
}

inline void tell_response(const json& of, std::ostream& out) {
  constexpr double degrees = 57.29577951308232;
  if (!of.contains("frequency")) {
    for (const char* name : {"gain", "rise_time", "overshoot", "settling_time"})
      out << name << ' ' << of.value(name, 0.0) << (std::string_view(name).ends_with("time") ? " s" : "")
          << '\n';
    return;
  }
  out << "# frequency Hz, gain, phase deg, coherence\n" << std::setprecision(5);
  for (std::size_t i = 0; i < of["frequency"].size(); ++i)
    out << of["frequency"][i].get<double>() << ' ' << of["gain"][i].get<double>() << ' '
        << degrees * of["phase"][i].get<double>() << ' ' << of["coherence"][i].get<double>() << '\n';
}

// The test ends with this call, however that ends: giving the command back ends it.
inline void test(conversation& door, const json& arguments, bool as_json, std::ostream& out) {
  const command_right mine(door);
  door.call("/cca/test", arguments);
  json answer;
  for (;;) {
    try {
      answer = door.call("/cca/response");
      break;
    } catch (const cca::refused& e) {
      if (std::string_view(e.what()).find(" runs") == std::string_view::npos) throw;
    }
    const auto again = conversation::clock::now() + std::chrono::milliseconds(200);
    while (conversation::clock::now() < again) door.next([](const event&) { return false; });
  }
  const json& response = answer["response"];
  if (as_json) out << response.dump(2) << '\n';
  else tell_response(response, out);
}

}  // namespace cca_door

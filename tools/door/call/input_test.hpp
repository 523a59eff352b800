// cca-call test: a signal on an input of the running program, and what came of it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iomanip>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/refused.hpp>

#include "../sample_fields.hpp"
#include "conversation.hpp"
#include "options.hpp"

namespace cca_door {

// The names of the axes of an output, as its schema has them.
inline std::vector<std::string> axes_of_output(const known_door& door, const std::string& path) {
  std::vector<std::string> all;
  if (const channel* const found = door.channel_named(path))
    if (const message_schema schema(found->schema); schema.is_of_output())
      for (std::size_t i = 2; i < schema.fields().size(); ++i) all.push_back(schema.fields()[i].name);
  return all;
}
// `elbow`, or its place in the list.
inline json axis_in(const std::string& argument,
                    const std::string& text,
                    const std::vector<std::string>& axes) {
  const auto found = std::find(axes.begin(), axes.end(), text);
  if (found != axes.end()) return found - axes.begin();
  const bool is_number = !text.empty() && text.find_first_not_of("0123456789") == text.npos;
  if (is_number) return cca::whole_number_in(argument, text, 0, 999);
  std::string names;
  for (const std::string& one : axes) names += (names.empty() ? "" : ", ") + one;
  throw cca::refused(argument + " = " + text + ": expected an axis" +
                     (names.empty() ? ", by its number from 0 on" : ": " + names));
}

// `chirp amplitude=0.05 frequency=1 to=50 axis=elbow`: the arguments of /cca/test.
inline json arguments_of_test(conversation& door, const call_options& o) {
  json all{{"input", o.words[0]}, {"output", o.words[1]}, {"signal", o.words[2]}};
  std::map<std::string, std::string> axes;
  for (std::size_t i = 3; i < o.words.size(); ++i) {
    const std::size_t equals = o.words[i].find('=');
    if (equals == 0 || equals == std::string::npos)
      throw cca::command_line_error(o.words[i] + ": expected NAME=VALUE, as amplitude=0.1");
    const std::string name = o.words[i].substr(0, equals), value = o.words[i].substr(equals + 1);
    if (name == "axis" || name == "output_axis" || name == "from_axis") axes[name] = value;
    else if (name == "from") all[name] = value;
    else all[name] = cca::number_in(name, value, -1e12, 1e12);
  }
  for (const auto& [name, value] : axes) {
    std::vector<std::string> names;
    if (name == "axis") {
      const json described = door.describe();
      for (const json& one : list_in(described, "tests"))
        if (text_in(one, "input") == o.words[0]) names = texts_in(one, "axes");
    } else {
      names = axes_of_output(door.told(), all.value(name == "output_axis" ? "output" : "from", ""));
    }
    all[name] = axis_in(name, value, names);
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
inline void test(conversation& door, const call_options& o, std::ostream& out) {
  const json arguments = arguments_of_test(door, o);
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
  if (o.json) out << response.dump(2) << '\n';
  else tell_response(response, out);
}

}  // namespace cca_door

// The commands that a program offers (cca/runtime/observers/run_command.hpp), on their way from the door to
// the loop: one at a time, and neither side waits.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/array_size.hpp>
#include <cca/base/refused.hpp>
#include <cca/door/controls.hpp>
#include <cca/runtime/observers/run_command.hpp>

namespace cca::detail {

template <class Controller>
class offered_commands {
public:
  using command = run_command<Controller>;

  explicit offered_commands(std::vector<command> offers) : all(std::move(offers)), is_held(all.size()) {
    for (const command& one : all)
      if (one.arguments.size() > command::most_arguments || !one.begin)
        throw refused("cca::door: the command `" + one.name + "` needs a function `begin`, and at most " +
                      std::to_string(command::most_arguments) + " arguments");
  }

  std::vector<door_command> described() const {
    std::vector<door_command> told;
    for (const command& one : all) {
      door_command& to = told.emplace_back();
      to.name = one.name, to.help = one.help, to.is_held = static_cast<bool>(one.end);
      for (const auto& a : one.arguments) to.arguments.push_back({a.name, a.unit, a.value, a.lower, a.upper});
    }
    return told;
  }

  // ---- the door's thread ----

  bool is_taken() const noexcept { return !is_asked.load(std::memory_order_acquire); }
  // Of the one that was taken last: why its function has refused it. Empty: it has not.
  const std::string& failure() const noexcept { return why_failed; }
  // Why not; empty: it is asked. `rests`: it makes no beats now.
  std::string ask(const door_request& request, bool rests) {
    const std::size_t number = number_of(request.text);
    if (number == all.size()) return "there is no command `" + request.text + "`" + known();
    const command& one = all[number];
    const bool ends = request.about == door_request::what::release;
    if (ends && !one.end) return "`" + one.name + "` is over at once: there is nothing to release";
    if (one.only_at_rest && !rests) return "pause it first: `" + one.name + "` is refused while it runs";
    if (!ends)
      for (std::size_t a = 0; a < one.arguments.size(); ++a) values[a] = one.arguments[a].value;
    for (const auto& [name, value] : request.values)
      if (std::string why = take(one, name, value); !why.empty()) return why;
    asked = number, is_end = ends;
    is_asked.store(true, std::memory_order_release);
    return {};
  }

  // ---- the loop's, between two beats ----

  void obey(Controller& c) {
    if (!is_asked.load(std::memory_order_acquire)) return;
    const command& one = all[asked];
    // A command is the program's: what it throws is its answer, and no end of the run.
    try {
      why_failed.clear();
      if (!is_end) {
        one.begin(c, std::span(values).first(one.arguments.size()));
        is_held[asked] = bool{one.end};
      } else if (std::exchange(is_held[asked], false)) {
        one.end(c);
      }
    } catch (const std::exception& e) { why_failed = one.name + ": " + e.what(); }
    is_asked.store(false, std::memory_order_release);
  }
  // The run is over: nothing goes on being held.
  void end(Controller& c) {
    obey(c);
    for (std::size_t n = 0; n < all.size(); ++n)
      if (std::exchange(is_held[n], false)) try {
          all[n].end(c);
        } catch (const std::exception& e) {
          std::fprintf(stderr, "cca::door: the end of %s: %s\n", all[n].name.c_str(), e.what());
        }
  }

private:
  std::size_t number_of(std::string_view name) const {
    std::size_t n = 0;
    while (n < all.size() && all[n].name != name) ++n;
    return n;
  }
  std::string known() const {
    std::string names;
    for (const command& one : all) names.append(names.empty() ? ": it has " : ", ").append(one.name);
    return names.empty() ? ": this program offers none" : names;
  }
  std::string take(const command& one, const std::string& name, const door_value& value) {
    for (std::size_t a = 0; a < one.arguments.size(); ++a) {
      const auto& argument = one.arguments[a];
      if (argument.name != name) continue;
      const bool is_whole = value.what == door_value::kind::integer;
      const double number = is_whole ? static_cast<double>(value.integer) : value.number;
      const bool is_number = is_whole || value.what == door_value::kind::number;
      if (!is_number || !(number >= argument.lower && number <= argument.upper))
        return one.name + ": " + name + ": expected a number from " + as_text(argument.lower) + " to " +
               as_text(argument.upper) + (argument.unit.empty() ? "" : " " + argument.unit);
      values[a] = number;
      return {};
    }
    return one.name + ": there is no argument `" + name + "`";
  }
  static std::string as_text(double number) {
    std::string digits = std::to_string(number);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.ends_with('.')) digits.pop_back();
    return digits;
  }

  std::vector<command> all;
  std::vector<char> is_held;  // the loop's
  std::array<double, command::most_arguments> values{};
  std::size_t asked = 0;
  bool is_end = false;
  std::string why_failed{};  // the loop's until is_asked is false
  std::atomic<bool> is_asked{false};
};

}  // namespace cca::detail

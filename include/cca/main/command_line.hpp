// The options of a program: what each takes, and one line of help. CLI11 splits the words; a mistake is
// refused with a message that says what was expected.
//
//   cca::command_line line("a simulated Oncilla trots");
//   line.number("--speed V", o.speed, 0, 1, "m/s (the parameters' speed)");
//   line.flag("--quiet", o.quiet, "prints nothing");
//   line.parse({"--speed", "0.5"});   // throws cca::command_line_error
//
// Behind the name of an option stands what --help calls its value. `into` is a variable, an optional one, or
// a function that takes the value. Each option may be given once, those of `texts` several times. What is
// called FILE is a file: two options that name one file are refused, however they spell it (one_file.hpp).
// Test: tests/runtime/programs/command_line.cpp; docs/programs.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include <cca/main/one_file.hpp>

namespace cca {

struct command_line_error : std::runtime_error {
  using runtime_error::runtime_error;
};

// The number that a text is, or a refusal: `--speed x: expected a number from 0 to 1`.
inline double number_in(const std::string& option, const std::string& text, double low, double high) {
  std::size_t read = 0;
  double value = 0;
  try {
    value = std::stod(text, &read);
  } catch (const std::exception&) { read = 0; }
  if (read == 0 || read != text.size() || !(value >= low && value <= high)) {
    std::ostringstream expected;
    expected << option << ' ' << text << ": expected a number from " << low << " to " << high;
    throw command_line_error(expected.str());
  }
  return value;
}

inline constexpr std::uint64_t any_whole_number = std::numeric_limits<std::uint64_t>::max();

inline std::uint64_t whole_number_in(const std::string& option,
                                     const std::string& text,
                                     std::uint64_t least = 0,
                                     std::uint64_t most = any_whole_number) {
  const bool is_number =
      !text.empty() && text.size() <= 18 && text.find_first_not_of("0123456789") == text.npos;
  if (!is_number || std::stoull(text) < least || std::stoull(text) > most) {
    const std::string from = std::to_string(least);
    throw command_line_error(option + " " + text + ": expected a whole number" +
                             (most == any_whole_number ? ", " + from + " or more"
                                                       : " from " + from + " to " + std::to_string(most)));
  }
  return std::stoull(text);
}

namespace detail {

// A function that puts a value into a variable; or the function that was given.
template <class Value, class Into>
auto setter(Into& into) {
  if constexpr (std::invocable<Into&, Value>) return into;
  else
    return [&into](const Value& value) {
      if constexpr (std::is_arithmetic_v<Into> || std::is_enum_v<Into>) into = static_cast<Into>(value);
      else into = value;
    };
}

}  // namespace detail

class command_line {
public:
  explicit command_line(std::string what_it_does) : purpose(std::move(what_it_does)) {
    app.set_help_flag();  // cca::run_program answers --help, -h and --version
    app.allow_extras();
  }

  void flag(std::string_view option, bool& into, std::string_view help) {
    app.add_flag(name_in(option), into);
    describe(option, help);
  }
  // take(text) checks it, and refuses by command_line_error, std::invalid_argument or cca::refused.
  void value(std::string_view option, std::function<void(const std::string&)> take, std::string_view help) {
    const auto given = [this, name = name_in(option), is_file = is_file(option),
                        take = std::move(take)](const std::string& text) {
      try {
        take(text);
      } catch (const std::invalid_argument& wrong) { throw command_line_error(wrong.what()); }
      if (is_file) files.emplace_back(name, text);
    };
    app.add_option_function<std::string>(name_in(option), given);
    describe(option, help);
  }
  template <class Into>
  void text(std::string_view option, Into&& into, std::string_view help) {
    value(option, detail::setter<std::string>(into), help);
  }
  void texts(std::string_view option, std::vector<std::string>& into, std::string_view help) {
    app.add_option(name_in(option), into)->allow_extra_args(false);
    if (is_file(option)) lists_of_files.emplace_back(name_in(option), &into);
    describe(option, help);
  }
  template <class Into>
  void number(std::string_view option, Into&& into, double low, double high, std::string_view help) {
    value(
        option,
        [put = detail::setter<double>(into), name = name_in(option), low, high](const std::string& given) {
          put(number_in(name, given, low, high));
        },
        help);
  }
  template <class Into>
  void whole_number(std::string_view option,
                    Into&& into,
                    std::uint64_t least,
                    std::string_view help,
                    std::uint64_t most = any_whole_number) {
    value(
        option,
        [put = detail::setter<std::uint64_t>(into), name = name_in(option), least,
         most](const std::string& given) { put(whole_number_in(name, given, least, most)); },
        help);
  }
  // One of these names; its number goes into a number or an enumeration.
  template <class Into, class Names>
  void one_of(std::string_view option, Into&& into, const Names& names, std::string_view help) {
    const std::vector<std::string> all(std::begin(names), std::end(names));
    value(
        option,
        [put = detail::setter<std::size_t>(into), name = name_in(option), all](const std::string& given) {
          const auto found = std::ranges::find(all, given);
          if (found == all.end()) {
            std::string expected = name + " " + given + ": expected one of";
            for (const auto& each : all) expected.append(" ").append(each);
            throw command_line_error(expected);
          }
          put(static_cast<std::size_t>(found - all.begin()));
        },
        help);
  }
  // What the program does instead of its work, and its exit code. The option takes a value if `option` says
  // so, else the text is empty.
  void instead(std::string_view option, std::function<int(const std::string&)> act, std::string_view help) {
    const auto chosen = [this, name = name_in(option), act = std::move(act)](const std::string& text) {
      if (other_work) throw command_line_error(name + " and " + other_name + ": take one of them");
      other_name = name;
      other_work = [act, text] { return act(text); };
    };
    if (option.find(' ') != option.npos) return value(option, chosen, help);
    app.add_flag_callback(name_in(option), [chosen] { chosen({}); });
    describe(option, help);
  }
  // Empty: its own work.
  const std::function<int()>& work_instead() const { return other_work; }

  // Words without an option, at most so many.
  void words(std::string_view names,
             std::vector<std::string>& into,
             std::size_t most,
             std::string_view help) {
    free_words = &into;
    most_words = most;
    describe(names, help);
  }

  bool has(std::string_view option) const { return app.get_option_no_throw(name_in(option)) != nullptr; }
  bool is_given(std::string_view option) const { return has(option) && app.count(name_in(option)) > 0; }

  void parse(std::vector<std::string> arguments) {
    std::ranges::reverse(arguments);
    try {
      app.parse(arguments);
    } catch (const CLI::ArgumentMismatch& wrong) {
      const std::string said = wrong.what();
      const bool is_missing = said.find("ost") == said.npos;  // not "at most"
      throw command_line_error(said.substr(0, said.find(':')) +
                               (is_missing ? ": expected a value after it" : ": it stands there twice"));
    } catch (const CLI::ParseError& wrong) { throw command_line_error(wrong.what()); }
    for (const std::string& left : app.remaining()) {
      const bool is_option = left.starts_with("-");
      if (is_option || !free_words) throw command_line_error(left + ": no such option; --help lists them");
      if (free_words->size() == most_words)
        throw command_line_error(left + ": expected at most " + std::to_string(most_words) +
                                 " words; see --help");
      free_words->push_back(left);
    }
    for (const auto& [option, all] : lists_of_files)
      for (const std::string& file : *all) files.emplace_back(option, file);
    if (const std::string twice = complaint_of_one_file(files); !twice.empty())
      throw command_line_error(twice);
  }

  // What --help prints.
  std::string help(std::string_view program) const {
    std::string all = std::string(program) + ": " + purpose + "\n\n" + listed;
    for (const auto& [option, what] : {std::pair{"--version", "the version of cca"}, {"--help", "this text"}})
      all += line_of(option, what);
    return all;
  }

private:
  static std::string name_in(std::string_view option) {
    return std::string(option.substr(0, option.find(' ')));
  }
  static bool is_file(std::string_view option) { return option.ends_with(" FILE"); }
  static std::string line_of(std::string_view option, std::string_view what) {
    constexpr std::size_t column = 20;
    std::string line = "  " + std::string(option);
    line.append(std::max(column, line.size() + 2) - line.size(), ' ');
    for (const char c : what) {
      line += c;
      if (c == '\n') line.append(column, ' ');
    }
    return line + '\n';
  }
  void describe(std::string_view option, std::string_view help) { listed += line_of(option, help); }

  CLI::App app;
  std::string purpose, listed;
  std::vector<std::string>* free_words = nullptr;
  std::size_t most_words = 0;
  std::vector<named_file> files;
  std::vector<std::pair<std::string, const std::vector<std::string>*>> lists_of_files;
  std::string other_name;
  std::function<int()> other_work;
};

}  // namespace cca

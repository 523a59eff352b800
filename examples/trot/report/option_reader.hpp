#pragma once
// The options of a program, read by CLI11. A mistake is refused with a message that says what was expected.
//
//   option_reader read;
//   read.number("--seconds", o.seconds, 0.001, 36000);
//   read.flag("--quiet", o.quiet);
//   read.all(arguments);                  // throws command_line_error
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace trot {

struct command_line_error : std::runtime_error {
  using runtime_error::runtime_error;
};

namespace detail {

inline double number(const std::string& option, const std::string& text, double low, double high) {
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

inline std::uint64_t whole_number(const std::string& option,
                                  const std::string& text,
                                  std::uint64_t least = 0) {
  const bool is_number =
      !text.empty() && text.size() <= 18 && text.find_first_not_of("0123456789") == text.npos;
  if (!is_number || std::stoull(text) < least)
    throw command_line_error(option + " " + text + ": expected a whole number, " + std::to_string(least) +
                             " or more");
  return std::stoull(text);
}

}  // namespace detail

class option_reader {
public:
  option_reader() {
    app.set_help_flag();  // trot::program answers --help, -h and --version
    app.allow_extras();
  }

  void flag(const std::string& name, bool& into) { app.add_flag(name, into); }
  // take(text) checks the value.
  void value(const std::string& name, std::function<void(const std::string&)> take) {
    app.add_option_function<std::string>(name, std::move(take));
  }
  template <class Text>  // std::string, or an optional one
  void text(const std::string& name, Text& into) {
    value(name, [&into](const std::string& given) { into = given; });
  }
  template <class Number>  // double, or an optional one
  void number(const std::string& name, Number& into, double low, double high) {
    value(name, [&into, name, low, high](const std::string& given) {
      into = detail::number(name, given, low, high);
    });
  }
  template <class Number>
  void whole_number(const std::string& name, Number& into, std::uint64_t least = 0) {
    value(name, [&into, name, least](const std::string& given) {
      into = static_cast<Number>(detail::whole_number(name, given, least));
    });
  }

  void all(std::vector<std::string> arguments) {
    std::reverse(arguments.begin(), arguments.end());
    try {
      app.parse(arguments);
    } catch (const CLI::ArgumentMismatch& wrong) {
      const std::string said = wrong.what();
      const bool is_missing = said.find("ost") == said.npos;  // not "at most"
      throw command_line_error(said.substr(0, said.find(':')) +
                               (is_missing ? ": expected a value after it" : ": it stands there twice"));
    } catch (const CLI::ParseError& wrong) { throw command_line_error(wrong.what()); }
    if (const auto left = app.remaining(); !left.empty())
      throw command_line_error(left.front() + ": no such option; --help lists them");
  }

private:
  CLI::App app;
};

}  // namespace trot

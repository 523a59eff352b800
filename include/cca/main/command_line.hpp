// The options of a program: what each takes, and one line of help. CLI11 splits the words; a mistake is
// refused with a message that says what was expected.
//
//   cca::command_line line("a simulated Oncilla trots");
//   line.number("--speed V", o.speed, 0, 1, "m/s (the parameters' speed)");
//   line.whole_number("--count N", o.count, 1, 100, "how many (10)");
//   line.flag("--quiet", o.quiet, "prints nothing");
//   line.parse({"--speed", "0.5"});   // throws cca::command_line_error
//
// Behind the name of an option stands what --help calls its value. `into` is a variable, an optional one, or
// a function that takes the value; in brackets, as in `--door [PORT]`, it may be left out, and is empty then.
// Each option may be given once, those of `texts` several times. What is called FILE is a file: two options
// that name one file are refused, however they spell it (one_file.hpp). Test:
// tests/runtime/programs/command_line.cpp; docs/programs.md.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/base/separate/compiled.hpp>
#include <cca/main/one_file.hpp>

namespace cca {

struct command_line_error : std::runtime_error {
  using runtime_error::runtime_error;
};

// The number that a text is, or a refusal: `--speed x: expected a number from 0 to 1`.
double number_in(const std::string& option, const std::string& text, double low, double high);

inline constexpr std::uint64_t any_whole_number = std::numeric_limits<std::uint64_t>::max();

std::uint64_t whole_number_in(const std::string& option,
                              const std::string& text,
                              std::uint64_t least = 0,
                              std::uint64_t most = any_whole_number);

namespace detail {

struct option_words;  // of CLI11: command_line_functions.hpp

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
  explicit command_line(std::string what_it_does);
  command_line(const command_line&) = delete;
  command_line& operator=(const command_line&) = delete;
  ~command_line();

  void flag(std::string_view option, bool& into, std::string_view help);
  // take(text) checks it, and refuses by command_line_error, std::invalid_argument or cca::refused.
  void value(std::string_view option, std::function<void(const std::string&)> take, std::string_view help);
  template <class Into>
  void text(std::string_view option, Into&& into, std::string_view help) {
    value(option, detail::setter<std::string>(into), help);
  }
  void texts(std::string_view option, std::vector<std::string>& into, std::string_view help);
  template <class Into>
  void number(std::string_view option, Into&& into, double least, double most, std::string_view help) {
    value(
        option,
        [put = detail::setter<double>(into), name = name_in(option), least, most](const std::string& given) {
          put(number_in(name, given, least, most));
        },
        help);
  }
  // From `least` on; with `most`, no more than that.
  template <class Into>
  void whole_number(std::string_view option, Into&& into, std::uint64_t least, std::string_view help) {
    whole_number(option, into, least, any_whole_number, help);
  }
  template <class Into>
  void whole_number(
      std::string_view option, Into&& into, std::uint64_t least, std::uint64_t most, std::string_view help) {
    value(
        option,
        [put = detail::setter<std::uint64_t>(into), name = name_in(option), least,
         most](const std::string& given) { put(whole_number_in(name, given, least, most)); },
        help);
  }
  // The order of earlier versions.
  template <class Into>
  void whole_number(
      std::string_view option, Into&& into, std::uint64_t least, std::string_view help, std::uint64_t most) {
    whole_number(option, into, least, most, help);
  }
  // One of these names; its number goes into a number or an enumeration.
  template <class Into, class Names>
  void one_of(std::string_view option, Into&& into, const Names& names, std::string_view help) {
    value(
        option,
        [put = detail::setter<std::size_t>(into), name = name_in(option),
         all = std::vector<std::string>(std::begin(names), std::end(names))](const std::string& given) {
          put(number_of(name, given, all));
        },
        help);
  }
  // What the program does instead of its work, and its exit code. The option takes a value if `option` says
  // so, else the text is empty.
  void instead(std::string_view option, std::function<int(const std::string&)> act, std::string_view help);
  // `option` allows another one beside it only where why_not(name) is empty; else that is why it does not.
  // Words without an option are asked for, too.
  void refuses(std::string_view option, std::function<std::string(const std::string& other)> why_not);
  // Empty: its own work.
  const std::function<int()>& work_instead() const { return other_work; }

  // Words without an option, at most so many; a number below 0 is one, too.
  void words(std::string_view names,
             std::vector<std::string>& into,
             std::size_t most,
             std::string_view help) {
    free_words = &into;
    most_words = most;
    describe(names, help);
  }

  bool has(std::string_view option) const;
  bool is_given(std::string_view option) const;

  void parse(std::vector<std::string> arguments);

  // What --help prints.
  std::string help(std::string_view program) const;

private:
  static std::string name_in(std::string_view option) {
    return std::string(option.substr(0, option.find(' ')));
  }
  static bool is_file(std::string_view option) { return option.ends_with(" FILE"); }
  static std::string line_of(std::string_view option, std::string_view what);
  static std::size_t number_of(const std::string& option,
                               const std::string& given,
                               const std::vector<std::string>& all);
  void refuse_beside() const;
  void describe(std::string_view option, std::string_view help) { listed += line_of(option, help); }

  std::unique_ptr<detail::option_words> app;
  std::string purpose, listed;
  std::vector<std::string>* free_words = nullptr;
  std::size_t most_words = 0;
  std::vector<named_file> files;
  std::vector<std::pair<std::string, const std::vector<std::string>*>> lists_of_files;
  std::vector<std::pair<std::string, std::function<std::string(const std::string&)>>> refusing;
  std::string other_name;
  std::function<int()> other_work;
};

}  // namespace cca

#if !CCA_HAS_COMPILED_MAIN
#include <cca/main/command_line_functions.hpp>
#endif

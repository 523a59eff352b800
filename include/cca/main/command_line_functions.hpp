// The functions of a command line that need CLI11. command_line.hpp includes this, unless they are compiled
// once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include <cca/main/command_line.hpp>

namespace cca {
namespace detail {

struct option_words : CLI::App {};

// `-3`, `-.5`, `-30deg`: no option begins so, and CLI11 would take it for one.
inline bool is_below_zero(std::string_view word) {
  constexpr std::string_view digits = "0123456789";
  if (!word.starts_with('-')) return false;
  word.remove_prefix(word.starts_with("-.") ? 2 : 1);
  return !word.empty() && digits.find(word.front()) != digits.npos;
}

}  // namespace detail

CCA_MAIN_INLINE double number_in(const std::string& option,
                                 const std::string& text,
                                 double low,
                                 double high) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);  // std::stod refuses 1e-320
  if (end == text.c_str() || end != text.c_str() + text.size() || !(value >= low && value <= high)) {
    std::ostringstream expected;
    expected << option << ' ' << text << ": expected a number from " << low << " to " << high;
    throw command_line_error(expected.str());
  }
  return value;
}

CCA_MAIN_INLINE std::uint64_t whole_number_in(const std::string& option,
                                              const std::string& text,
                                              std::uint64_t least,
                                              std::uint64_t most) {
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

CCA_MAIN_INLINE command_line::command_line(std::string what_it_does)
    : app(std::make_unique<detail::option_words>()), purpose(std::move(what_it_does)) {
  app->set_help_flag();  // cca::run_program answers --help, -h and --version
  app->allow_extras();
}

CCA_MAIN_INLINE command_line::~command_line() = default;

CCA_MAIN_INLINE void command_line::flag(std::string_view option, bool& into, std::string_view help) {
  app->add_flag(name_in(option), into);
  describe(option, help);
}

CCA_MAIN_INLINE void command_line::value(std::string_view option,
                                         std::function<void(const std::string&)> take,
                                         std::string_view help) {
  const auto given = [this, name = name_in(option), is_file = is_file(option),
                      take = std::move(take)](const std::string& text) {
    try {
      take(text);
    } catch (const std::invalid_argument& wrong) { throw command_line_error(wrong.what()); }
    if (is_file) files.emplace_back(name, text);
  };
  auto* const added = app->add_option_function<std::string>(name_in(option), given);
  if (option.find(" [") != option.npos) added->expected(0, 1);
  describe(option, help);
}

CCA_MAIN_INLINE void command_line::texts(std::string_view option,
                                         std::vector<std::string>& into,
                                         std::string_view help) {
  app->add_option(name_in(option), into)->allow_extra_args(false);
  if (is_file(option)) lists_of_files.emplace_back(name_in(option), &into);
  describe(option, help);
}

CCA_MAIN_INLINE void command_line::instead(std::string_view option,
                                           std::function<int(const std::string&)> act,
                                           std::string_view help) {
  const auto chosen = [this, name = name_in(option), act = std::move(act)](const std::string& text) {
    if (other_work) throw command_line_error(name + " and " + other_name + ": take one of them");
    other_name = name;
    other_work = [act, text] { return act(text); };
  };
  if (option.find(' ') != option.npos) return value(option, chosen, help);
  app->add_flag_callback(name_in(option), [chosen] { chosen({}); });
  describe(option, help);
}

CCA_MAIN_INLINE void command_line::refuses(std::string_view option,
                                           std::function<std::string(const std::string&)> why_not) {
  refusing.emplace_back(name_in(option), std::move(why_not));
}

CCA_MAIN_INLINE void command_line::refuse_beside() const {
  std::vector<std::string> given;
  for (const CLI::Option* const one : app->parse_order()) given.push_back(one->get_name());
  for (const std::string& word : app->remaining()) given.push_back(word);
  for (const auto& [option, why_not] : refusing)
    if (is_given(option))
      for (const std::string& other : given)
        if (other != option)
          if (const std::string why = why_not(other); !why.empty())
            throw command_line_error(other + " and " + option + ": " + why);
}

CCA_MAIN_INLINE bool command_line::has(std::string_view option) const {
  return app->get_option_no_throw(name_in(option)) != nullptr;
}

CCA_MAIN_INLINE bool command_line::is_given(std::string_view option) const {
  return has(option) && app->count(name_in(option)) > 0;
}

CCA_MAIN_INLINE void command_line::parse(std::vector<std::string> arguments) {
  std::ranges::reverse(arguments);
  try {
    app->parse(arguments);
  } catch (const CLI::ArgumentMismatch& wrong) {
    const std::string said = wrong.what();
    const bool is_missing = said.find("ost") == said.npos;  // not "at most"
    throw command_line_error(said.substr(0, said.find(':')) +
                             (is_missing ? ": expected a value after it" : ": it stands there twice"));
  } catch (const CLI::ParseError& wrong) { throw command_line_error(wrong.what()); }
  for (const std::string& left : app->remaining()) {
    const bool is_option = left.starts_with("-") && !detail::is_below_zero(left);
    if (is_option || !free_words) throw command_line_error(left + ": no such option; --help lists them");
    if (free_words->size() == most_words)
      throw command_line_error(left + ": expected at most " + std::to_string(most_words) +
                               " words; see --help");
    free_words->push_back(left);
  }
  refuse_beside();
  for (const auto& [option, all] : lists_of_files)
    for (const std::string& file : *all) files.emplace_back(option, file);
  if (const std::string twice = complaint_of_one_file(files); !twice.empty()) throw command_line_error(twice);
}

CCA_MAIN_INLINE std::string command_line::help(std::string_view program) const {
  std::string all = std::string(program) + ": " + purpose + "\n\n" + listed;
  for (const auto& [option, what] : {std::pair{"--version", "the version of cca"}, {"--help", "this text"}})
    all += line_of(option, what);
  return all;
}

CCA_MAIN_INLINE std::string command_line::line_of(std::string_view option, std::string_view what) {
  constexpr std::size_t column = 20;
  std::string line = "  " + std::string(option);
  line.append(std::max(column, line.size() + 2) - line.size(), ' ');
  for (const char c : what) {
    line += c;
    if (c == '\n') line.append(column, ' ');
  }
  return line + '\n';
}

CCA_MAIN_INLINE std::size_t command_line::number_of(const std::string& option,
                                                    const std::string& given,
                                                    const std::vector<std::string>& all) {
  const auto found = std::ranges::find(all, given);
  if (found == all.end()) {
    std::string expected = option + " " + given + ": expected one of";
    for (const auto& each : all) expected.append(" ").append(each);
    throw command_line_error(expected);
  }
  return static_cast<std::size_t>(found - all.begin());
}

}  // namespace cca

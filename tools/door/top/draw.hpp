// The lines of the screen, made of the model and the view. They are ASCII, but for names that the program
// brings.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model.hpp"
#include "screen.hpp"
#include "view.hpp"

namespace cca_door {

namespace detail {

inline std::string formatted(const char* how, double number) {
  char text[64];
  std::snprintf(text, sizeof text, how, number);
  return text;
}

// `0.8 ms`, `12.3 s`, `5 min`: at most seven characters.
inline std::string duration_text(double seconds) {
  if (seconds < 0.9995e-3) return formatted("%.0f us", seconds * 1e6);
  if (seconds < 0.9995) return formatted(seconds < 9.995e-3 ? "%.2f ms" : "%.1f ms", seconds * 1e3);
  if (seconds < 99.95) return formatted("%.1f s", seconds);
  if (seconds < 6000) return formatted("%.0f s", seconds);
  return formatted(seconds < 360000 ? "%.0f min" : "%.0f h",
                   seconds < 360000 ? seconds / 60 : seconds / 3600);
}

inline std::string rate_text(double hz) {
  if (!(hz > 0)) return "-";
  if (hz < 9.995) return formatted("%.2f Hz", hz);
  return formatted(hz < 99.95 ? "%.1f Hz" : "%.0f Hz", hz);
}

// Mean, 99 of 100, most: `12/25/101 us`, in one unit.
inline std::string three_times(double mean, double p99, double most) {
  if (!(most > 0)) return "-";
  const double scale = most < 9.995e-3 ? 1e6 : most < 9.995 ? 1e3 : 1;
  const auto one = [&](double of) {
    const double number = of * scale;
    return formatted(number < 0.0995 && number > 0 ? "%.3f" : number < 9.95 ? "%.1f" : "%.0f", number);
  };
  return one(mean) + "/" + one(p99) + "/" + one(most) + (scale == 1e6 ? " us" : scale == 1e3 ? " ms" : " s");
}

inline std::string values_text(const watched_output& of, std::size_t most) {
  std::string text;
  if (of.last.empty()) return text;
  const auto read = of.schema.read(of.last);
  if (!read) return "(does not fit its schema)";
  std::size_t i = 0;
  for (const auto& [name, value] : read->items()) {
    if (i++ < 2) continue;  // beat and origin
    if (!text.empty()) text += ' ';
    text += value.is_number() ? formatted("%.4g", value.get<double>()) : written(value);
    if (text.size() > most) break;
  }
  return text;
}

inline std::string time_of_day(double seconds) {
  const auto when = static_cast<std::time_t>(seconds);
  std::tm parts{};
  if (!::localtime_r(&when, &parts)) return "--:--:--";
  char text[16];
  std::strftime(text, sizeof text, "%H:%M:%S", &parts);
  return text;
}

class drawing {
public:
  drawing(const top_model& of, top_view& v, const std::string& address, terminal_size s, bool has_utf8)
      : model(of), view(v), where(address), size(s), utf8(has_utf8) {}

  std::vector<screen_line> lines() {
    view.looked_at.clear();
    head();
    if (view.at != page::environments)
      environments(std::max<std::size_t>(1, (size.height - std::min<std::size_t>(size.height, 10)) / 4));
    tabs();
    // The last lines are for what is said, two if it is long, and for the keys.
    const std::size_t last = view.types == top_view::typing::nothing && size.height > 10 &&
                                     columns_of(model.remark, utf8) > size.width
                                 ? 3
                                 : 2;
    const std::size_t rows = size.height > all.size() + 1 + last ? size.height - all.size() - 1 - last : 0;
    titles();
    view.keep_in_view(view.row_count(model), rows);
    const std::size_t end = all.size() + rows;
    switch (view.at) {
      case page::components:
        components(rows);
        break;
      case page::parameters:
        parameters(rows);
        break;
      case page::log:
        log(rows);
        break;
      case page::environments:
        environment_rows(view.here().first, rows);
        break;
      case page::commands:
        commands(rows);
        break;
    }
    while (all.size() < end) line();
    // On a terminal of a few lines the head gives way: what is said and the keys stay.
    const std::size_t kept = size.height > last ? size.height - last : 0;
    if (all.size() > kept) all.resize(kept, screen_line(size.width, utf8));
    if (size.height > 1) said();
    keys();
    return std::move(all);
  }

private:
  const top_model& model;
  top_view& view;
  const std::string& where;
  terminal_size size;
  bool utf8;
  std::vector<screen_line> all{};

  screen_line& line() { return all.emplace_back(size.width, utf8); }

  void head() {
    const std::string state = model.is_open ? text_in(model.status, "state") : "NOT CONNECTED";
    const std::string program = text_in(model.description, "program");
    const bool is_paused = is_set(model.status, "is_paused");
    const std::string end = (is_paused && model.is_open ? "paused, " : "") + state + " ";
    screen_line& first = line();
    const style how = model.is_open ? style::bar : style::stop;
    const std::size_t end_size = std::min(columns_of(end, utf8), size.width);
    first.add(left(" cca-top " + where + "  " + (program.empty() ? program_of(model.door) : program),
                   size.width - end_size, utf8),
              how);
    first.add(end, how);
    if (!model.is_open) line().add(model.why_closed + "; trying again", style::alarm);

    const std::int64_t period = whole_in(model.status, "period");
    const double speed = number_in(model.status, "speed", 1);
    std::string text = "time " + formatted("%.3f", static_cast<double>(model.now) * 1e-9) + " s  beat " +
                       std::to_string(whole_in(model.status, "beat"));
    if (period > 0) text += " of " + duration_text(static_cast<double>(period) * 1e-9);
    text += speed > 0 ? "  speed " + formatted("%.3g", speed) : "  a fast run";
    if (const std::string mode = text_in(model.status, "mode"); !mode.empty()) text += "  mode " + mode;
    screen_line& second = line();
    second.add(text);
    if (const auto overruns = whole_in(model.status, "overruns"); overruns > 0)
      second.add("  overruns " + std::to_string(overruns), style::alarm);

    screen_line& third = line();
    if (!model.is_open) third.add("below is what it told last", style::faint);
    else if (!model.has_token || (model.door.has_rights && !model.door.may_change))
      third.add("you only read", style::bold);
    else if (!model.door.has_rights) third.add("asks the door what you may do", style::faint);
    else if (model.door.commands) third.add("YOU COMMAND", style::bold);
    else third.add("you may take the command", style::bold);
    if (model.is_open && model.door.has_rights && !model.door.commands)
      third.add(model.door.commanded_by.empty() ? ", nobody commands"
                                                : ", " + model.door.commanded_by + " commands");
    if (const auto clients = whole_in(model.status, "clients"); clients > 0)
      third.add("  " + std::to_string(clients) + (clients == 1 ? " client" : " clients"));
    if (const std::string file = text_in(model.status, "recording"); !file.empty())
      third.add("  recording " + file);
    if (const std::string problem = text_in(model.status, "recording_problem"); !problem.empty())
      line().add("RECORDING INCOMPLETE " + problem, style::alarm);

    const std::string fault = text_in(model.status, "fault"), path = text_in(model.status, "fault_path");
    if (!fault.empty() || !path.empty())
      line().add("FAULT " + (path.empty() || fault.find(path) != fault.npos ? "" : path + ": ") + fault,
                 style::alarm);
    std::string parts;
    for (const std::string& one : texts_in(model.status, "stopped_parts")) parts += " " + one;
    if (!parts.empty()) line().add("stopped:" + parts, style::bold);
    for (const json& one : list_in(model.status, "twins")) {
      const std::string says = text_in(one, "says");
      line()
          .add("twin of " + text_in(one, "client") + ": ", style::faint)
          .add(says, says.starts_with("first difference") ? style::alarm : style::bold);
    }
  }

  // ---- environments ----

  std::size_t name_width() const { return size.width > 76 ? size.width - 68 : 8; }
  void environment_titles() {
    line().add(left("environment", name_width(), utf8) + right("beats", 11, utf8) +
                   right("overruns", 9, utf8) + right("lost", 6, utf8) + right("late", 6, utf8) +
                   right("beat mean/p99/max", 18, utf8) + right("wake mean/p99/max", 18, utf8),
               style::faint);
  }
  void environment_rows(std::size_t first, std::size_t rows) {
    const json& known = list_in(model.status, "environments");
    for (std::size_t i = first; i < known.size() && i < first + rows; ++i) {
      const json& one = known[i];
      const auto count = [&](const char* name, std::size_t width) {
        const std::int64_t value = whole_in(one, name);
        all.back().add(right(std::to_string(value), width, utf8), value > 0 ? style::alarm : style::plain);
      };
      line().add(left(text_in(one, "name"), name_width(), utf8));
      all.back().add(right(std::to_string(whole_in(one, "beats")), 11, utf8));
      count("overruns", 9), count("lost_periods", 6), count("late", 6);
      for (const char* const what : {"beat", "wake_up"}) {
        const std::string of = what;
        all.back().add(
            right(three_times(number_in(one, (of + "_mean").c_str()), number_in(one, (of + "_p99").c_str()),
                              number_in(one, (of + "_most").c_str())),
                  18, utf8));
      }
    }
  }
  void environments(std::size_t most) {
    const std::size_t count = list_in(model.status, "environments").size();
    if (count == 0) return;
    environment_titles();
    environment_rows(0, count > most ? most - (most > 1 ? 1 : 0) : most);
    if (count > most && most > 1)
      line().add("... " + std::to_string(count - most + 1) + " more: 4", style::faint);
  }

  // ---- pages ----

  void tabs() {
    screen_line& l = line();
    for (std::size_t i = 0; i < page_names.size(); ++i) {
      l.add(" " + std::to_string(i + 1) + " " + std::string(page_names[i]) + " ",
            static_cast<std::size_t>(view.at) == i ? style::chosen : style::plain);
      l.add(" ");
    }
    const std::size_t count = view.row_count(model);
    std::string which = view.rows_shown < count
                            ? std::to_string(view.here().first + 1) + "-" +
                                  std::to_string(std::min(count, view.here().first + view.rows_shown)) +
                                  " of " + std::to_string(count)
                            : std::string();
    if (!view.filter.empty()) which += (which.empty() ? "" : "  ") + ("/" + view.filter);
    l.add(right(shown(which, l.room(), utf8).text, l.room(), utf8), style::faint);
  }

  std::size_t path_width() const { return std::clamp<std::size_t>(size.width / 2 - 10, 12, 60); }
  std::size_t value_width() const { return std::clamp<std::size_t>(size.width / 4, 10, 40); }

  void titles() {
    switch (view.at) {
      case page::components:
        line().add(left("output", path_width(), utf8) + right("rate", 10, utf8) + right("age", 10, utf8) +
                       "  values",
                   style::faint);
        break;
      case page::parameters:
        line().add(left("parameter", path_width(), utf8) + "  " + left("value", value_width(), utf8) +
                       "  unit, range",
                   style::faint);
        break;
      case page::log:
        line().add("who did what", style::faint);
        break;
      case page::environments:
        environment_titles();
        break;
      case page::commands:
        line().add(left("command", command_width, utf8) + "  arguments", style::faint);
        break;
    }
  }
  bool is_chosen(std::size_t i) const { return i == view.here().chosen; }

  void components(std::size_t rows) {
    const auto known = view.components(model);
    for (std::size_t i = view.here().first; i < known.size() && i < view.here().first + rows; ++i) {
      const component_row& row = known[i];
      if (row.output) view.looked_at.insert(row.path);
      screen_line& l = line();
      const bool is_faulty = model.is_faulty(row.node), is_stopped = model.is_stopped(row.node);
      l.add(end_of(row.path, path_width(), utf8), is_chosen(i) ? style::chosen
                                                  : is_faulty  ? style::alarm
                                                               : style::plain);
      if (is_faulty) l.add(right("FAULT", 10, utf8), style::alarm);
      else if (is_stopped) l.add(right("stopped", 10, utf8), style::bold);
      else l.add(right(row.output ? rate_text(row.output->rate()) : "", 10, utf8));
      if (!row.output) {
        l.add(right("", 10, utf8)).add("  no outputs", style::faint);
        continue;
      }
      const auto age = row.output->age(model.now);
      l.add(right(age ? duration_text(*age) : "none yet", 10, utf8), age ? style::plain : style::faint);
      l.add("  ");
      l.add(left(values_text(*row.output, l.room()), l.room(), utf8));
    }
    if (known.empty() && rows > 0)
      line().add(view.filter.empty() ? "no outputs: is the program recordable?"
                                     : "no output has /" + view.filter + " in its path",
                 style::faint);
  }

  void parameters(std::size_t rows) {
    const auto known = view.parameters(model);
    for (std::size_t i = view.here().first; i < known.size() && i < view.here().first + rows; ++i) {
      const parameter& one = *known[i];
      screen_line& l = line();
      l.add(end_of(one.path, path_width(), utf8), is_chosen(i) ? style::chosen : style::plain);
      l.add("  ").add(left(text_of_value(one.value), value_width(), utf8), style::bold).add("  ");
      const std::string range = range_of(one);
      l.add(left(range.empty() ? one.unit : range, l.room(), utf8), style::faint);
    }
    if (known.empty() && rows > 0)
      line().add(view.filter.empty() ? "no parameters" : "no parameter has /" + view.filter + " in its path",
                 style::faint);
  }

  static constexpr std::size_t command_width = 16;
  void commands(std::size_t rows) {
    const auto known = view.commands(model);
    for (std::size_t i = view.here().first; i < known.size() && i < view.here().first + rows; ++i) {
      const command& one = *known[i];
      screen_line& l = line();
      l.add(left(one.name, command_width, utf8), is_chosen(i) ? style::chosen : style::plain).add("  ");
      if (model.held.contains(one.name)) l.add("HELD, enter releases it  ", style::alarm);
      l.add(arguments_text(one));
      l.add((one.arguments.empty() ? "" : "  ") + one.help, style::faint);
    }
    if (known.empty() && rows > 0)
      line().add(
          view.filter.empty() ? "the program offers none" : "no command has /" + view.filter + " in its name",
          style::faint);
  }
  // `forward (-60 to 60 N), left (-60 to 60 N)`
  static std::string arguments_text(const command& of) {
    std::string text;
    for (const parameter& one : of.arguments) {
      const std::string range = range_of(one).empty() ? one.unit : range_of(one);
      text += (text.empty() ? "" : ", ") + one.path + (range.empty() ? "" : " (" + range + ")");
    }
    return text;
  }

  // Of this machine the port says who it is.
  static std::string client_text(const std::string& client) {
    return client.starts_with("127.0.0.1:") ? client.substr(9) : client;
  }
  void log(std::size_t rows) {
    for (std::size_t i = view.here().first; i < model.log.size() && i < view.here().first + rows; ++i) {
      const log_line& one = model.log[model.log.size() - 1 - i];  // the newest first
      const bool is_refusal = one.what.starts_with("refused: ");
      line()
          .add(time_of_day(one.time) + " ", style::faint)
          .add(left(client_text(one.client), 15, utf8) + " ")
          .add(one.what, is_refusal ? style::alarm : style::plain);
    }
    if (model.log.empty() && rows > 0) line().add("nothing was changed", style::faint);
  }

  // ---- the last two lines ----

  void said() {
    if (view.types == top_view::typing::nothing) {
      const style how = model.is_refusal ? style::alarm : style::bold;
      const shown_text first = shown(model.remark, size.width, utf8);
      line().add(first.text, how);
      if (size.height > 10 && columns_of(model.remark, utf8) > size.width)
        line().add(without_first(model.remark, size.width), how);
      return;
    }
    screen_line& l = line();
    if (view.types == top_view::typing::filter) l.add("/", style::bold);
    else if (view.types == top_view::typing::file) l.add("record into ", style::bold);
    else if (view.types == top_view::typing::arguments) l.add(view.typed_for + " ", style::bold);
    else {
      std::string range;
      for (const parameter& one : model.parameters)
        if (one.path == view.typed_for) range = range_of(one).empty() ? one.unit : range_of(one);
      l.add(
          left(view.typed_for + (range.empty() ? "" : " (" + range + ")"),
               std::min(columns_of(view.typed_for, utf8) + (range.empty() ? 0 : columns_of(range, utf8) + 3),
                        size.width / 2),
               utf8) +
              " = ",
          style::bold);
    }
    // The end of it that has room, with the cursor in it.
    const std::string text = view.typed + " ";
    const std::size_t cursor = std::min(view.cursor, view.typed.size());
    const std::size_t from = cursor + 1 > l.room() ? cursor + 1 - l.room() : 0;
    l.add(text.substr(from, cursor - from))
        .add(text.substr(cursor, 1), style::bar)
        .add(text.substr(cursor + 1));
  }
  // What follows the first columns.
  std::string_view without_first(std::string_view text, std::size_t columns) const {
    std::size_t used = 0;
    while (!text.empty()) {
      const std::size_t bytes = std::max<std::size_t>(cca::recording::detail::shown_bytes(text), 1);
      const std::size_t more = columns_of(text.substr(0, bytes), utf8);
      if (used + more > columns) break;
      used += more;
      text.remove_prefix(bytes);
    }
    return text;
  }
  void keys() {
    screen_line& l = line();
    const bool can_stop = model.has_token && (!model.door.has_rights || model.door.may_change);
    l.add(can_stop ? " SPACE STOP " : " SPACE STOP needs a token ", can_stop ? style::stop : style::bar);
    const auto add = [&l](std::string_view name, std::string_view does) {
      l.add(" ").add(name, style::bold).add(" ").add(does);
    };
    if (view.types == top_view::typing::value) return add("enter", "set"), add("esc", "leave it as it is");
    if (view.types == top_view::typing::filter) return add("enter", "keep"), add("esc", "show all");
    if (view.types != top_view::typing::nothing)
      return add("enter", view.types == top_view::typing::file ? "record" : "do it"), add("esc", "don't");
    if (model.has_token) {
      add("c", model.door.commands ? "give it back" : "command");
      if (text_in(model.status, "state") == "faulted") add("r", "resume"), add("s", "start anew");
      else if (text_in(model.status, "state") == "loaded") add("s", "start");
      else add("p", "pause"), add("g", "go on"), add("n", "step");
      if (view.at == page::parameters) add("enter", "set"), add("u", "undo");
      else add("w", text_in(model.status, "recording").empty() ? "record" : "end recording");
      if (const command* const of = view.chosen_command(model))
        add("enter", model.held.contains(of->name) ? "release" : of->name);
    }
    add("/", "find"), add("q", "quit");
  }
};

}  // namespace detail

inline std::vector<screen_line> draw(
    const top_model& model, top_view& view, const std::string& address, terminal_size size, bool utf8) {
  return detail::drawing(model, view, address, size, utf8).lines();
}

}  // namespace cca_door

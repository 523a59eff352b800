// What a key does.
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include <cca/base/refused.hpp>

#include "keys.hpp"
#include "model.hpp"
#include "view.hpp"

namespace cca_door {

namespace detail {

// Needs no right to command, and goes before everything: also while something is typed.
inline void press_stop(top_model& model) {
  if (!model.has_token) return model.remark_on("STOP needs the token: cca-top --token or --token-file", true);
  if (!model.is_open || !model.door.has_rights)
    return model.remark_on("NOT CONNECTED: STOP WAS NOT SENT", true);
  model.ask("/cca/stop", "STOP: the run ends");
}

inline bool may_command(top_model& model) {
  if (!model.is_open) model.remark_on("not connected", true);
  else if (model.has_token && !model.door.has_rights)  // its services may not be known yet either
    model.remark_on("the door has not said yet what you may do", true);
  else if (!model.has_token)
    model.remark_on("you only read: cca-top --token or --token-file may change something", true);
  else if (model.door.commands) return true;
  else if (model.door.commanded_by.empty())
    model.remark_on("press c to take the right to command first", true);
  else model.remark_on(model.door.commanded_by + " commands, and must give the command back first", true);
  return false;
}

inline void press_command(top_model& model) {
  if (model.door.commands) return model.ask("/cca/give_command", "you gave the command back");
  if (!model.is_open || !model.has_token || !model.door.has_rights) return void(may_command(model));
  model.ask("/cca/take_command", "you command");
}

inline void set_typed(top_model& model, top_view& view) {
  for (const parameter& one : model.parameters)
    if (one.path == view.typed_for) {
      if (!may_command(model)) return;
      try {
        model.set(one, value_in(one, view.typed));
        model.remark_on(one.path + " = " + view.typed + " ...");
      } catch (const cca::refused& wrong) { model.remark_on(wrong.what(), true); }
      return;
    }
  model.remark_on("there is no parameter " + view.typed_for + " any more", true);
}

// `forward=10,left=-5`; what is not said is as the program says. No blanks: that is the key that stops.
inline json arguments_in(const command& of, const std::string& text) {
  json all = json::object();
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find(',', from), text.size()), is = text.find('=', from);
    const std::string name = text.substr(from, std::min(is, end) - from);
    const auto known = std::find_if(of.arguments.begin(), of.arguments.end(),
                                    [&](const parameter& one) { return one.path == name; });
    if (is >= end || known == of.arguments.end())
      throw cca::refused(of.name + ": " + text.substr(from, end - from) + ": expected an argument, as " +
                         (of.arguments.empty() ? "none" : of.arguments[0].path + "=1"));
    all[name] = value_in(*known, text.substr(is + 1, end - is - 1));
    from = end + 1;
  }
  return all;
}
inline void call_typed(top_model& model, top_view& view) {
  for (const command& one : model.commands)
    if (one.name == view.typed_for) {
      if (!may_command(model)) return;
      try {
        model.ask("/cca/command/" + one.name,
                  one.name + (one.is_held ? ": held, enter releases it" : ": done"),
                  arguments_in(one, view.typed));
        view.given[one.name] = view.typed;
      } catch (const cca::refused& wrong) { model.remark_on(wrong.what(), true); }
      return;
    }
  model.remark_on("there is no command " + view.typed_for + " any more", true);
}
inline void record_typed(top_model& model, top_view& view) {
  if (!may_command(model)) return;
  view.file = view.typed;
  model.ask("/cca/record", "records into " + view.file, {{"file", view.file}});
}

inline void type(const key& one, top_model& model, top_view& view) {
  using k = key::kind;
  std::string& text = view.typed;
  view.cursor = std::min(view.cursor, text.size());
  const auto insert = [&](const std::string& more) {
    text.insert(view.cursor, more);
    view.cursor += more.size();
  };
  const auto what = std::exchange(view.types, view.types);
  switch (one.what) {
    case k::character:
      insert(std::string(1, one.letter));
      break;
    case k::pasted:
      for (const char c : one.text)
        if (c >= ' ' && c <= '~') insert(std::string(1, c));
      break;
    case k::backspace:
      if (view.cursor > 0) text.erase(--view.cursor, 1);
      break;
    case k::remove:
      text.erase(view.cursor, view.cursor < text.size() ? 1 : 0);
      break;
    case k::erase_all:
      text.clear(), view.cursor = 0;
      break;
    case k::left:
      view.cursor -= view.cursor > 0 ? 1 : 0;
      break;
    case k::right:
      view.cursor += view.cursor < text.size() ? 1 : 0;
      break;
    case k::home:
      view.cursor = 0;
      break;
    case k::end:
      view.cursor = text.size();
      break;
    case k::escape:
      view.types = top_view::typing::nothing;
      if (what == top_view::typing::filter) view.filter.clear();
      return;
    case k::enter:
      view.types = top_view::typing::nothing;
      if (what == top_view::typing::value) set_typed(model, view);
      if (what == top_view::typing::arguments) call_typed(model, view);
      if (what == top_view::typing::file) record_typed(model, view);
      return;
    default:
      break;
  }
  if (what == top_view::typing::filter) view.filter = text;
}

inline void begin_typing(top_view& view, top_view::typing what, std::string text) {
  view.types = what;
  view.typed = std::move(text);
  view.cursor = view.typed.size();
}

// A command that is held ends with the same key that began it; a terminal does not tell when a key is let go.
inline void begin_or_release(const command& of, top_model& model, top_view& view) {
  if (!may_command(model)) return;
  if (model.held.contains(of.name)) return model.ask("/cca/release/" + of.name, of.name + ": released");
  std::string& text = view.given[of.name];
  if (text.empty())
    for (const parameter& one : of.arguments)
      text += (text.empty() ? "" : ",") + one.path + "=" + text_of_value(one.value);
  view.typed_for = of.name;
  begin_typing(view, top_view::typing::arguments, text);
  if (of.arguments.empty()) view.types = top_view::typing::nothing, call_typed(model, view);
}
inline void press_record(top_model& model, top_view& view) {
  if (!may_command(model)) return;
  const std::string file = text_in(model.status, "recording");
  if (!file.empty()) return model.ask("/cca/end_recording", "recorded: " + file);
  begin_typing(view, top_view::typing::file, view.file);
}

}  // namespace detail

// False: the program ends.
inline bool press(const key& one, top_model& model, top_view& view) {
  using k = key::kind;
  if (one.what == k::interrupt) return false;
  if (one.is(' ')) return detail::press_stop(model), true;
  if (view.types != top_view::typing::nothing) return detail::type(one, model, view), true;

  constexpr int pages = static_cast<int>(page_names.size());
  const std::size_t count = view.row_count(model);
  const auto rows = static_cast<std::ptrdiff_t>(view.rows_shown);
  const auto ask = [&](const char* service, const char* said, json arguments = json::object()) {
    if (detail::may_command(model)) model.ask(service, said, std::move(arguments));
  };
  switch (one.what) {
    case k::up:
      view.move(-1, count);
      break;
    case k::down:
      view.move(1, count);
      break;
    case k::page_up:
      view.move(-rows, count);
      break;
    case k::page_down:
      view.move(rows, count);
      break;
    case k::home:
      view.here().chosen = 0;
      break;
    case k::end:
      view.here().chosen = count > 0 ? count - 1 : 0;
      break;
    case k::tab:
    case k::right:
      view.at = static_cast<page>((static_cast<int>(view.at) + 1) % pages);
      break;
    case k::left:
      view.at = static_cast<page>((static_cast<int>(view.at) + pages - 1) % pages);
      break;
    case k::escape:
      view.filter.clear(), model.remark_on({});
      break;
    case k::enter:
      if (const parameter* const of = view.chosen_parameter(model)) {
        if (!detail::may_command(model)) break;
        view.typed_for = of->path;
        detail::begin_typing(view, top_view::typing::value, text_of_value(of->value));
      } else if (const command* const to_call = view.chosen_command(model)) {
        detail::begin_or_release(*to_call, model, view);
      }
      break;
    case k::character:
      switch (one.letter) {
        case '1':
        case '2':
        case '3':
        case '4':
        case '5':
          view.at = static_cast<page>(one.letter - '1');
          break;
        case 'j':
          view.move(1, count);
          break;
        case 'k':
          view.move(-1, count);
          break;
        case 'p':
          ask("/cca/pause", "paused");
          break;
        case 'g':
          ask("/cca/go_on", "it goes on");
          break;
        case 'r':
          ask("/cca/resume", "it goes on after the fault");
          break;
        case 's':
          ask("/cca/start", "it begins anew");
          break;
        case 'n':
          ask("/cca/step", "one beat", {{"beats", 1}});
          break;
        case 'u':
          ask("/cca/undo", "the last change is undone");
          break;
        case 'w':
          detail::press_record(model, view);
          break;
        case 'c':
          detail::press_command(model);
          break;
        case '/':
          detail::begin_typing(view, top_view::typing::filter, view.filter);
          break;
        case 'q':
          return false;
        default:
          break;
      }
      break;
    default:
      break;
  }
  return true;
}

}  // namespace cca_door

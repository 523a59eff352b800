// cca-top: a running program in a terminal, through its door. docs/door_tools.md; `cca-top --help`.
#include <chrono>
#include <clocale>
#include <csignal>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <langinfo.h>

#include <cca/main/run_program.hpp>
#include <cca/runtime/interruption.hpp>

#include "../address.hpp"
#include "../client.hpp"
#include "draw.hpp"
#include "press.hpp"
#include "terminal.hpp"

namespace {

using namespace cca_door;
using clock_type = std::chrono::steady_clock;
using namespace std::chrono_literals;

struct top_options {
  std::vector<std::string> words{};
  token_option token{};
};

class top_program {
public:
  top_program(const door_address& to, const token_option& t)
      : address(to), where(to.text()), token(t), model(!t.value().empty()) {}

  int run() {
    const cca::interruption signals;
    terminal shown_on;
    screen image;
    std::optional<terminal_size> size;
    auto drawn = clock_type::time_point{}, second = clock_type::now();
    bool goes_on = true, is_gone = false;
    while (goes_on && !signals) {
      connect();
      line->wait(50ms, STDIN_FILENO);
      while (const auto one = line->next()) model.take(*one);
      bool is_changed = false;
      std::string typed;
      if (!shown_on.read(typed)) {
        is_gone = true;
        break;
      }
      keys.add(typed);
      // An escape alone: the rest of a code comes at once.
      while (const auto one = keys.next(typed.empty())) {
        if (one->what == key::kind::suspend) shown_on.suspend();
        else if (one->what == key::kind::redraw) image.forget();
        else goes_on = press(*one, model, view) && goes_on;
        is_changed = true;
      }
      if (shown_on.is_suspended()) shown_on.suspend();
      if (shown_on.is_continued()) image.forget(), is_changed = true;
      const auto now = clock_type::now();
      if (now - second > 1s) second = now, model.each_second();
      if (is_changed || now - drawn > 100ms || size != shown_on.size()) {
        drawn = now, size = shown_on.size();
        if (!shown_on.write(image.show(draw(model, view, where, *size, has_utf8()), *size))) {
          is_gone = true;
          break;
        }
        model.look_at(view.looked_at);
      }
      send();
    }
    // Who loses the terminal is lost to the robot, too: the door does what it was told for that.
    const bool is_lost = is_gone || signals.exit_code() == 128 + SIGHUP;
    if (line && model.door.commands && !is_lost) {
      model.ask("/cca/give_command", {});
      send();
    }
    if (line) line->close();
    return is_gone ? 128 + SIGHUP : signals.exit_code();
  }

private:
  // The file of the token is read again: a program that starts anew may have a new one.
  void connect() {
    if (line && (!line->is_closed() || clock_type::now() < next_try)) return;
    next_try = clock_type::now() + 1s;
    std::string secret;
    try {
      secret = token.value();
    } catch (const std::exception& wrong) { model.remark_on(wrong.what(), true); }
    line.emplace(address, secret);
  }

  void send() {
    for (const to_door& one : std::exchange(model.outgoing, {})) {
      if (one.service.empty()) {
        line->send(one.message);
        continue;
      }
      const auto service = model.door.services.find(one.service);
      if (service == model.door.services.end())
        model.remark_on("this door has no service " + one.service, true);
      else model.called(line->call(service->second, one.message), one);
    }
  }
  static bool has_utf8() {
    static const bool has = std::string_view(::nl_langinfo(CODESET)) == "UTF-8";
    return has;
  }

  door_address address;
  std::string where;
  token_option token;
  top_model model;
  top_view view{};
  key_reader keys{};
  std::optional<client> line{};
  clock_type::time_point next_try{};
};

int watch(const top_options& o) {
  if (o.words.empty()) throw cca::command_line_error("expected the port of a door, as 8765; see --help");
  std::setlocale(LC_ALL, "");
  std::setlocale(LC_NUMERIC, "C");
  return top_program(address_in(o.words[0]), o.token).run();
}

}  // namespace

int main(int count, char** words) {
  top_options o;
  cca::command_line line("shows a running program in a terminal, through its door");
  line.words("[ADDRESS:]PORT", o.words, 1, "the door, as 8765 or 192.168.1.5:8765");
  o.token.add_to(line);
  return cca::run_program(count, words, line, [&] { return watch(o); });
}

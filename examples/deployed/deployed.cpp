// The Combination of Skills in four environments, in every form: as one loop, in threads, in processes. Each
// form must give the bits of the loop, sample by sample. docs/deployed.md; --help lists the options.
//
// Read architecture.hpp first, then forms.hpp.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/runtime/interruption.hpp>

#include "../combination_of_skills/command_line.hpp"
#include "../trot/report/program.hpp"
#include "forms.hpp"
#include "report.hpp"

namespace {

struct options {
  deployed::settings run;
  std::string form, address = "0";
  std::optional<std::string> only, summary;
};

constexpr std::string_view usage =
    "deployed: the Combination of Skills in four environments, each form compared with the single loop\n"
    "\n"
    "  --seconds S       of trot, before and after (6)\n"
    "  --beats N         ends earlier (60000)\n"
    "  --shape FILE      the learned shape of the trot (trot.shape)\n"
    "  --form F          only `threads` or `shared_memory` (every form)\n"
    "  --summary FILE    the figures as JSON: a list of forms\n"
    "  --only E          one environment in this process, by --form (shared_memory); others run the rest\n"
    "  --address N       only processes with the same number find each other (0)\n"
    "  --version         the version of cca\n"
    "  --help            this text\n";

options parse(const std::vector<std::string>& arguments) {
  options o;
  trot::option_reader read;
  read.value("--seconds", [&o](const std::string& text) {
    skills::set_seconds(o.run.run, trot::detail::number("--seconds", text, 1, 20));
  });
  read.whole_number("--beats", o.run.most_beats, 1);
  read.text("--shape", o.run.shape);
  read.text("--form", o.form);
  read.text("--summary", o.summary);
  read.text("--only", o.only);
  read.text("--address", o.address);
  read.all(arguments);
  constexpr auto& names = deployed::transport_names;
  const bool is_known =
      o.form.empty() || o.form == "threads" || std::find(names.begin(), names.end(), o.form) != names.end();
  if (!is_known) throw trot::command_line_error("--form " + o.form + ": no such form; --help lists them");
  return o;
}

int run_forms(options o) {
  const cca::interruption interrupted;  // ctrl-c: the summary is of the forms that are over
  std::vector<deployed::compared_form> forms;
  const auto add = [&](deployed::outcome one, const deployed::outcome& loop) {
    if (interrupted) return;
    forms.emplace_back(std::move(one), loop);
    print(forms.back());
  };
  deployed::print_heading();
  const deployed::outcome loop = deployed::run_loop(o.run, interrupted);
  add(loop, loop);
  const bool is_whole = loop.beats < o.run.most_beats;
  o.run.most_beats = loop.beats;  // all others do as many
  const auto both_paces = [&](std::string_view form, auto run) {
    if (!o.form.empty() && o.form != form) return;
    if (!interrupted) add(run(cca::as_fast_as_possible{}), loop);
    if (!interrupted) add(run(cca::at_wall_clock()), loop);
  };
  both_paces("threads", [&](auto pace) { return deployed::run_threads(o.run, pace, interrupted); });
  for (const std::string_view transport : deployed::transport_names)
    both_paces(transport, [&](auto pace) {
      return deployed::run_processes(std::string(transport), o.run, pace, interrupted);
    });
  if (o.summary) trot::write(*o.summary, [&](std::ostream& file) { deployed::write_json(file, forms); });
  if (interrupted) return interrupted.exit_code();
  const bool all_good =
      std::all_of(forms.begin(), forms.end(), [](const auto& one) { return one.is_good(); });
  return all_good && (!is_whole || skills::succeeded(loop.judged)) ? 0 : 1;
}

int run(const options& o) {
  if (o.only)
    return deployed::run_environment(*o.only, o.form.empty() ? "shared_memory" : o.form, o.address, o.run);
  return run_forms(o);
}

}  // namespace

int main(int count, char** arguments) {
  return trot::program("deployed", usage, count, arguments,
                       [](const std::vector<std::string>& given) { return run(parse(given)); });
}

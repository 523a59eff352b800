// The Combination of Skills in four environments, in every form: as one loop, in threads, in processes. Each
// form must give the bits of the loop, sample by sample. docs/deployed.md; --help lists the options.
//
// Read architecture.hpp first, then forms.hpp.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/main/command_line.hpp>
#include <cca/main/descriptions.hpp>
#include <cca/main/run_program.hpp>
#include <cca/runtime/interruption.hpp>

#include "../combination_of_skills/command_line.hpp"
#include "../trot/report/file.hpp"
#include "forms.hpp"
#include "report.hpp"

namespace {

constexpr auto form_names = [] {
  std::array<std::string_view, 1 + deployed::transport_names.size()> all{"threads"};
  std::ranges::copy(deployed::transport_names, all.begin() + 1);
  return all;
}();

struct options {
  deployed::settings run;
  std::string form, address = "0";
  std::optional<std::string> only, summary;

  void offer(cca::command_line& line) {
    line.number(
        "--seconds S", [this](double seconds) { skills::set_seconds(run.run, seconds); }, 1, 20,
        "of trot, before and after (6)");
    line.whole_number("--beats N", run.most_beats, 1, "ends earlier (60000)");
    line.text("--shape FILE", run.shape, "the learned shape of the trot (trot.shape)");
    line.one_of(
        "--form F", [this](std::size_t i) { form = form_names[i]; }, form_names,
        "only threads, shared_memory or dds, beside the loop (every form)");
    line.text("--summary FILE", summary, "the figures as JSON: a list of forms");
    deployed::offer_observing<cca::deployed<deployed::split>>(
        line, run.files, "of each form\nand process, whose names are added to FILE");
    line.text("--only E", only,
              "one environment in this process; others run the rest. It reaches them by\n"
              "--form: shared_memory or dds (shared_memory)");
    using split = cca::deployed<deployed::split>;
    cca::offer_descriptions<split>(line, [this](split& c) { skills::name_shape(c, run.shape); });
    line.text("--address N", address, "only processes with the same number find each other (0)");
  }
};

int run_forms(options o) {
  const cca::interruption interrupted;  // ctrl-c: the summary is of the forms that are over
  std::vector<deployed::compared_form> forms;
  const auto add = [&](deployed::outcome one, const deployed::outcome& loop) {
    if (interrupted) return;
    forms.emplace_back(std::move(one), loop);
    print(forms.back());
    std::fputs(forms.back().what.traced.c_str(), stdout);
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

int main(int count, char** words) {
  options o;
  cca::command_line line(
      "the Combination of Skills in four environments, each form compared with the single loop");
  o.offer(line);
  return cca::run_program(count, words, line, [&] { return run(o); });
}

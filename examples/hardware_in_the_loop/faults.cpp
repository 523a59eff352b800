// The fault campaign: one run for each fault of fault_rows.hpp. Prints a table.
//
// usage: hardware_in_the_loop_faults [--one-loop] [--every N] [faults.json [docs/hardware.md]]
//   faults.json        writes the table as JSON
//   docs/hardware.md   replaces the table in this page
//   --one-loop         without the delays between gait and buses; else as in the real robot's program
//   --every N          the first fault, and each N-th after it
#include <fstream>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/main/descriptions.hpp>
#include <cca/main/run_program.hpp>
#include <cca/runtime/interruption.hpp>

#include "../trot/report/json.hpp"
#include "fault_rows.hpp"

namespace {

using namespace hil;

constexpr std::string_view head =
    "| fault | first cause | found by, after beats | safe after | joint moves, rad | torque, N m | outside "
    "limits | restarts |\n";

std::string table_of(const std::vector<result>& all) {
  std::ostringstream out;
  out << head << "|---|---|---|---|---|---|---|---|\n" << std::fixed;
  for (const result& r : all) {
    const bool found = r.beats_to_detect >= 0;
    out << "| " << r.fault << " | "
        << (!found                  ? "goes on"
            : r.first_cause.empty() ? "-"
                                    : r.first_cause)
        << " | " << r.detected_by << (found ? ", " + std::to_string(r.beats_to_detect) : "") << " | "
        << (found ? std::to_string(r.beats_to_safe) : "-") << " | " << std::setprecision(2) << r.max_excursion
        << " | " << std::setprecision(1) << r.max_torque << " | " << r.sent_outside_limits << " of " << r.sent
        << " | " << (r.recovered ? "yes" : "no") << " |\n";
  }
  return out.str();
}

std::string json_of(const std::vector<result>& all) {
  trot::json list = trot::json::array();
  for (const result& r : all)
    list.push_back({{"fault", r.fault},
                    {"first_cause", r.first_cause},
                    {"detected_by", r.detected_by},
                    {"beats_to_detect", r.beats_to_detect < 0 ? trot::json() : trot::json(r.beats_to_detect)},
                    {"beats_to_safe", r.beats_to_safe},
                    {"max_excursion_rad", r.max_excursion},
                    {"max_torque_nm", r.max_torque},
                    {"set_points_sent", r.sent},
                    {"sent_outside_limits", r.sent_outside_limits},
                    {"recovered", r.recovered}});
  std::ostringstream out;
  trot::write(out, list);
  return out.str();
}

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path + ": could not be written to its end");
}

// The page with the new table.
std::string renewed(const std::string& path, const std::string& table) {
  std::ostringstream page;
  page << std::ifstream(path).rdbuf();
  std::string text = page.str();
  const std::size_t from = text.find(head), to = text.find("\n\n", from);
  if (to == std::string::npos) throw std::runtime_error(path + ": has no table of the campaign");
  return text.replace(from, to + 1 - from, table);
}

// The first row, and each `every`-th after it; after a signal, those that were over.
template <class Delay>
std::vector<result> run_rows(std::optional<cca::interruption>& interrupted, int every) {
  std::vector<result> all;
  int number = 0;
  campaign<Delay>([&](auto row, bool raises_signal) {
    if (number++ % every != 0 || *interrupted) return;
    all.push_back(row());
    std::cerr << '.' << std::flush;
    if (raises_signal) interrupted.emplace();  // the row's own signal ends the row, not the campaign
  });
  std::cerr << '\n';
  return all;
}

int run_campaign(bool one_loop, int every, const std::vector<std::string>& files) {
  if (every > 1 && files.size() > 1)
    throw std::invalid_argument(files[1] + ": its table has all faults; leave out --every");
  std::optional<cca::interruption> signals(std::in_place);
  const auto all =
      one_loop ? run_rows<cca::latest>(signals, every) : run_rows<cca::delayed<1>>(signals, every);
  const cca::interruption& interrupted = *signals;
  const std::string table = table_of(all);
  std::cout << table;
  if (files.size() > 0) write(files[0], json_of(all));
  if (files.size() > 1 && !interrupted) write(files[1], renewed(files[1], table));
  int bad = 0;
  for (const result& r : all)
    if (!r.good()) {
      std::cerr << r.fault << ": " << (r.recovered ? "" : "does not recover; ") << r.unexpected
                << (r.beats_to_safe > 3 ? "is not safe within 3 beats; " : "")
                << (r.sent_outside_limits ? "a set-point outside of the limits was sent; " : "")
                << (r.lost_beats == r.expected_lost_beats
                        ? ""
                        : "lost " + std::to_string(r.lost_beats) + " beats, not " +
                              std::to_string(r.expected_lost_beats))
                << '\n';
      ++bad;
    }
  if (interrupted)
    std::cerr << "hardware_in_the_loop_faults: interrupted after " << all.size() << " faults\n";
  return interrupted ? interrupted.exit_code() : bad ? 1 : 0;
}

}  // namespace

int main(int count, char** words) {
  std::vector<std::string> files;
  bool one_loop = false;
  int every = 1;
  cca::command_line line("the trot on virtual drives, and everything that can go wrong");
  line.flag("--one-loop", one_loop, "without the delays between gait and buses");
  line.number("--every N", every, 1, 1000, "only the first fault, and each N-th after it (1: all)");
  cca::offer_descriptions<cca::controller<limited<cca::delayed<1>>>>(line);
  line.words("[FILE [PAGE]]", files, 2,
             "writes the table as JSON, and replaces that of the page, docs/hardware.md");
  return cca::run_program(count, words, line, [&] { return run_campaign(one_loop, every, files); });
}

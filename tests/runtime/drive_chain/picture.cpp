// The picture of docs/hardware.md: the nodes between the servos and the drives, from the picture of the whole
// robot.
#include <algorithm>
#include <initializer_list>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

#include <cca/graph/describe.hpp>

#include "../../../examples/hardware_in_the_loop/in_memory.hpp"
#include "../picture.hpp"

namespace {

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  n0[("synchronizer<br/><i>1000 Hz</i>")]
  n20[("servos<br/><i>1000 Hz</i>")]
  n21[("finite<br/><i>1000 Hz</i>")]
  n22[("stale<br/><i>1000 Hz</i>")]
  n23[("emergency_stop<br/><i>1000 Hz</i>")]
  n24[("soft_stop<br/><i>1000 Hz</i>")]
  n25[("damping_stop<br/><i>1000 Hz</i>")]
  n26[("rate<br/><i>1000 Hz</i>")]
  n27[("limits<br/><i>1000 Hz</i>")]
  n27 -- "safe → set_points<br/>set_points, 1000 Hz" --> n0
  n0 -- "joints<br/>joint_states, 1000 Hz" --> n20
  n20 -- "wanted<br/>wanted_points, 1000 Hz" --> n21
  n21 -- "safe → wanted<br/>wanted_points, 1000 Hz" --> n22
  n22 -- "safe → wanted<br/>wanted_points, 1000 Hz" --> n23
  n0 -- "joints<br/>joint_states, 1000 Hz" --> n23
  n23 -- "safe → wanted<br/>set_points, 1000 Hz" --> n24
  n0 -- "joints<br/>joint_states, 1000 Hz" --> n24
  n24 -- "safe → wanted<br/>set_points, 1000 Hz" --> n25
  n0 -- "joints<br/>joint_states, 1000 Hz" --> n25
  n25 -- "safe → wanted<br/>set_points, 1000 Hz" --> n26
  n0 -- "joints<br/>joint_states, 1000 Hz" --> n26
  n26 -- "safe → wanted<br/>set_points, 1000 Hz" --> n27
  n0 -- "joints<br/>joint_states, 1000 Hz" --> n27
)";  // [picture end]

// The lines of a picture for these nodes and the wires between them. Names of spaces lose their template
// arguments.
std::string part(const std::string& mermaid, std::initializer_list<std::string_view> names) {
  std::istringstream lines(mermaid);
  std::vector<std::string> kept;
  std::string text;
  const auto keeps = [&](const std::string& id) {
    return std::find(kept.begin(), kept.end(), id) != kept.end();
  };
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first, last;
    words >> first;
    last = line.substr(line.rfind(' ') + 1);
    const std::string id = first.substr(0, first.find_first_of("[("));
    const bool node = id != first && std::any_of(names.begin(), names.end(), [&](std::string_view name) {
                        return line.find("\"" + std::string(name) + "<br/>") != std::string::npos;
                      });
    if (node) kept.push_back(id);
    if (const auto list = line.find("&lt;"); list != std::string::npos)
      line.erase(list, line.rfind("&gt;") + 4 - list);
    if (node || first == "flowchart" || (keeps(first) && keeps(last))) text += line + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("the picture of the safety chain") {
  CHECK_EQ(part(cca::describe<hil::oncilla<hil::memory_end>>::mermaid(),
                {"synchronizer", "servos", "finite", "stale", "emergency_stop", "soft_stop", "damping_stop",
                 "rate", "limits"}),
           test::on_page(picture));
}

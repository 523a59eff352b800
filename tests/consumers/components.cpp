// A user's program with all components: has the main function for robots, reads a parameter from a file,
// joins a DDS domain, steps a world of the simulator, sends a set-point to a drive over a bus in memory,
// makes runs on all ranks, opens a door, which serves the page of cca.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/dds.hpp>
#include <cca/door/server.hpp>
#include <cca/hardware/memory_bus.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/main.hpp>
#include <cca/mpi/ranks.hpp>
#include <cca/record.hpp>
#include <cca/robots/oncilla/spaces.hpp>
#include <cca/sim/oncilla/world.hpp>

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}};
};
struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};

struct goal {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, angle));
  };
  parameters p{0.1};
  auto process(cca::beat) -> cca::out<"angle", hip_angle> { return p.angle; }
};
struct joint {
  void act(cca::in<"command", hip_angle> to) { at = to[hip{}]; }
  double at = 0;
};
struct moving : cca::graph<cca::node<"goal", goal>,
                           cca::node<"limits", cca::limiter<hip_angle>>,
                           cca::node<"joint", joint>,
                           cca::wire<"goal.angle", "limits.command">,
                           cca::wire<"limits.safe", "joint.command">>,
                cca::recordable {};

// A program behind a door, without its graph.
struct nothing_to_show : cca::detail::door_controls {
  using outcome_of = cca::detail::door_outcome;
  cca::detail::door_description text{};
  const cca::detail::door_description& description() const override { return text; }
  cca::detail::door_status status() const override { return {}; }
  std::vector<cca::detail::door_environment> environments() const override { return {}; }
  std::optional<std::vector<cca::detail::door_parameter>> parameters() override { return {}; }
  outcome_of begin(const cca::detail::door_request&) override { return {}; }
  outcome_of outcome() override { return {}; }
  void note(std::string_view, std::string_view) override {}
};

struct alone : cca::deployment<moving, cca::environment<"all", cca::other_nodes>> {};

// What a browser gets at http://127.0.0.1:PORT/ is the page of cca.
bool serves_page(std::uint16_t port) {
  const int file = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET, to.sin_port = htons(port), to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  std::string answer;
  if (::connect(file, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0) {
    const std::string ask = "GET / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n\r\n";
    std::array<char, 1 << 16> some;
    for (auto size = ::write(file, ask.data(), ask.size()); size > 0;) {
      size = ::read(file, some.data(), some.size());
      if (size > 0) answer.append(some.data(), static_cast<std::size_t>(size));
    }
  }
  ::close(file);
  std::ifstream known(cca::door_settings{}.page, std::ios::binary);
  const std::string page{std::istreambuf_iterator<char>(known), {}};
  return page.find("<!-- the recording -->") != page.npos && answer.ends_with("\r\n\r\n" + page);
}

static_assert(cca::robots::oncilla::leg_axes::count == 8);

int main(int count, char** words) {
  cca::mpi::ranks all(count, words);
  nothing_to_show nothing;
  const cca::detail::door_server door({.port = 0, .tells_where = false}, nothing);
  if (count > 1) return cca::robot_main<moving>(count, words);
  std::ofstream("moving.toml") << "[goal]\nangle = 0.25\n";
  cca::controller<moving> c;
  cca::recording::recorder recording(c, "moving.mcap");
  c.load("moving.toml");
  c.start();
  c.run(cca::for_beats<10>{});

  cca::deployed<alone> d(cca::only{"all"}, cca::dds::domain(static_cast<unsigned>(::getpid()) % 200));
  d.load();
  d.start();
  d.run(cca::for_beats<10>{});

  cca::sim::world world;
  world.advance({});

  using drive = cca::hardware::mit_drive<cca::hardware::ak80_9, 3>;
  cca::hardware::memory_bus<> wire;
  wire.end(0).send(drive::set_point({.position = 0.25, .stiffness = 20}).frames);
  wire.advance(1'000'000);
  std::array<cca::hardware::received_frame, 4> heard;
  const auto twice = all.rollouts(3, [](std::size_t i) { return 2 * i; });
  return twice.back() == 4 && c.get<"joint">().at == 0.25 && d.beat_index() == 10 && world.mass() > 5 &&
                 serves_page(door.port()) && wire.end(1).receive(heard) == 1
             ? 0
             : 1;
}

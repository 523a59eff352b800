// The trot of the example: it trots, straight, from disturbances, and a snapshot of it trots on bit for bit.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

#include <doctest/doctest.h>

#include <cca/config.hpp>
#include <cca/sim/rollouts.hpp>

#include "../../../tools/gait_search/cma_es.hpp"
#include "../../../examples/trot/report/bounds.hpp"
#include "../../../examples/trot/report/command_line.hpp"
#include "../../../examples/trot/report/csv.hpp"
#include "../../../examples/trot/rollout.hpp"
#include "../../../examples/trot/report/statistics.hpp"
#include "../../../examples/trot/report/summary.hpp"
#include "../../../examples/trot/report/svg.hpp"

namespace {

trot::recording run(double seconds,
                    std::uint64_t seed,
                    double speed = trot::throttle{}.p.speed,
                    const cca::sim::terrain& ground = cca::sim::terrain::flat()) {
  trot::trotting controller;
  controller.load();
  auto wanted = controller.get<"throttle">().p;
  wanted.speed = speed;
  controller.set<"throttle">(wanted);
  return trot::roll_out(controller, ground, cca::sim::disturbance::from_seed(seed, seconds), seconds,
                        [](const cca::sim::world&, double) {});
}

// All parameters, as a file has them.
std::string text_of(trot::trotting controller, const char* loaded_from = nullptr) {
  const auto path =
      std::filesystem::temp_directory_path() / ("cca_trot_all_" + std::to_string(::getpid()) + ".toml");
  if (loaded_from) controller.load(loaded_from);
  else controller.load();
  controller.save(path.string());
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  file.close();
  std::filesystem::remove(path);
  return text;
}

trot::options given(const std::vector<std::string>& words) {
  cca::command_line line("trots");
  cca::run_settings settings;
  trot::options o;
  o.offer(line, settings);
  line.parse(words);
  return o;
}

}  // namespace

TEST_SUITE("trot") {
  TEST_CASE("it trots: upright, fast, straight, with diagonal legs together") {
    const trot::recording recorded = run(6, 3);
    const trot::statistics s = trot::evaluate(recorded);
    CHECK(!s.fell);
    CHECK(s.cruise >= 0.6);
    CHECK(std::abs(s.drift) < 0.05 * s.distance);
    CHECK(s.max_roll < cca::sim::degrees(30));
    CHECK(s.max_pitch < cca::sim::degrees(30));
    CHECK(s.stride_frequency == doctest::Approx(4.0).epsilon(0.02));
    const double commanded = trot::gait{}.p.duty;
    for (const double duty : s.duty_factor) CHECK(std::abs(duty - commanded) < 0.12);
  }

  TEST_CASE("it does not skate: load-weighted slip of the feet, and what friction takes") {
    const trot::statistics s = trot::evaluate(run(10, 1));
    CHECK(s.cruise >= 0.6);
    CHECK(s.foot_slip > 0);
    CHECK(s.foot_slip <= 0.15);
    CHECK(s.friction_power > 0);
    CHECK(s.friction_power < 6);
  }

  TEST_CASE(
      "up and down slopes of 6 degrees and up steps of 6 mm: no fall, 0.6 m/s, little slip, even stance") {
    // The seeds that were nearest to a bound, or beyond one, with earlier gaits.
    struct hard {
      const char* ground;
      std::uint64_t seed;
    };
    const std::array hards{hard{"slope:6", 2},  hard{"slope:6", 15},  hard{"slope:-6", 1},
                           hard{"slope:-6", 4}, hard{"slope:-6", 16}, hard{"steps:6", 2},
                           hard{"steps:6", 4},  hard{"flat", 10},     hard{"flat", 12}};
    const std::vector<trot::statistics> all = cca::sim::rollouts(hards.size(), [&](std::size_t i) {
      return trot::evaluate(
          run(20, hards[i].seed, trot::throttle{}.p.speed, cca::sim::terrain::named(hards[i].ground)));
    });
    const double commanded = trot::gait{}.p.duty;
    for (std::size_t i = 0; i < all.size(); ++i) {
      CAPTURE(hards[i].ground);
      CAPTURE(hards[i].seed);
      CHECK(!all[i].fell);
      CHECK(all[i].cruise >= 0.6);
      CHECK(all[i].foot_slip <= 0.15);
      CHECK(trot::farthest_off_duty(all[i], commanded) <= 0.12);
      CHECK(trot::keeps(all[i], commanded));
    }
  }

  TEST_CASE("ten disturbances, 20 s each: no fall, 0.6 m/s, straight") {
    const std::vector<trot::statistics> all =
        cca::sim::rollouts(10, [](std::size_t seed) { return trot::evaluate(run(20, seed)); });
    for (std::size_t seed = 0; seed < all.size(); ++seed) {
      CAPTURE(seed);
      const trot::statistics& s = all[seed];
      CHECK(!s.fell);
      CHECK(s.speed >= 0.6);
      CHECK(std::abs(s.drift) < 0.05 * s.distance);
      CHECK(s.max_roll < cca::sim::degrees(30));
      CHECK(s.max_pitch < cca::sim::degrees(30));
    }
  }

  TEST_CASE(
      "it converges: half of the physics step, and half again, change speed and cost of transport by 3 %") {
    const auto figures = [](int steps_per_beat) {
      cca::sim::robot_world_settings physics;
      physics.steps_per_beat = steps_per_beat;
      trot::trotting controller;
      controller.load();
      return trot::evaluate(trot::roll_out(
          controller, cca::sim::terrain::flat(), cca::sim::disturbance::none(), 8,
          [](const cca::sim::world&, double) {}, physics));
    };
    trot::statistics before = figures(2);
    for (const int steps : {4, 8}) {
      CAPTURE(steps);
      const trot::statistics now = figures(steps);
      CHECK(!now.fell);
      CHECK(now.cruise == doctest::Approx(before.cruise).epsilon(0.03));
      CHECK(now.cost_of_transport == doctest::Approx(before.cost_of_transport).epsilon(0.03));
      before = now;
    }
  }

  TEST_CASE("the throttle: slower is slower, and no speed is standing") {
    for (const double speed : {0.2, 0.4, 0.6, 0.8}) {
      CAPTURE(speed);
      const trot::statistics s = trot::evaluate(run(5, 1, speed));
      CHECK(!s.fell);
      CHECK(s.cruise == doctest::Approx(speed).epsilon(0.1));
    }
    const trot::statistics standing = trot::evaluate(run(3, 1, 0.0));
    CHECK(!standing.fell);
    CHECK(std::abs(standing.distance) < 0.1);
  }

  TEST_CASE("controller and world, copied in the middle of the trot, go on bit for bit") {
    trot::trotting original;
    original.load();
    original.start();
    original.run(cca::for_beats<900>{});
    trot::trotting copy = original;
    original.run(cca::for_beats<600>{});
    copy.run(cca::for_beats<600>{});
    CHECK(original.get<"robot.simulator">().world().hash() == copy.get<"robot.simulator">().world().hash());
  }

  TEST_CASE("controller and world, set back to a snapshot, go on bit for bit") {
    trot::trotting controller;
    controller.load();
    controller.start();
    controller.run(cca::for_beats<900>{});
    const trot::trotting snapshot = controller;
    const auto go_on = [&] {
      std::vector<std::uint64_t> hashes;
      for (int k = 0; k < 300; ++k) {
        controller.step();
        hashes.push_back(controller.get<"robot.simulator">().world().hash());
      }
      return hashes;
    };
    const auto first = go_on();
    controller = snapshot;
    CHECK(controller.beat_index() == 900);
    CHECK(go_on() == first);
  }

  TEST_CASE("the same seed gives the same bits, in two threads at once, too - another seed others") {
    const auto hash_of = [](std::uint64_t seed) {
      trot::trotting controller;
      controller.load();
      trot::roll_out(controller, cca::sim::terrain::named("steps:6"),
                     cca::sim::disturbance::from_seed(seed, 5), 4, [](const cca::sim::world&, double) {});
      return controller.get<"robot.simulator">().world().hash();
    };
    const std::uint64_t alone = hash_of(3);
    std::vector<std::uint64_t> together(3);
    const std::array<std::uint64_t, 3> seeds{3, 3, 4};
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < 3; ++i) threads.emplace_back([&, i] { together[i] = hash_of(seeds[i]); });
    for (auto& thread : threads) thread.join();
    CHECK(together[0] == alone);
    CHECK(together[1] == alone);
    CHECK(together[2] != alone);
  }

  TEST_CASE("the file of the example has the parameters of the code") {
    std::istringstream file(text_of({}, CCA_EXAMPLES "/trot/trot.toml")), code(text_of({}));
    std::string of_file, of_code;
    std::size_t words = 0;
    while (file >> of_file) {
      code >> of_code;
      REQUIRE(!code.fail());
      ++words;
      if (of_file == of_code) continue;  // else a number, with or without a unit, that differs by rounding
      const auto number = [](const std::string& word) { return std::stod(word.substr(word.front() == '"')); };
      CHECK(number(of_file) == doctest::Approx(number(of_code)).epsilon(1e-12));
    }
    code >> of_code;
    CHECK(code.fail());
    CHECK(words > 100);
  }

  TEST_CASE(
      "a file that is refused leaves the controller as it was - where it stands, which key, and what was "
      "expected is told") {
    struct bad {
      const char *text, *words;
    };
    const auto path =
        std::filesystem::temp_directory_path() / ("cca_trot_" + std::to_string(::getpid()) + ".toml");
    for (const bad& b :
         {bad{"[cpg]\nfrequncy = 2.0\n", ":2: cpg.frequncy: unknown parameter, did you mean `frequency`?"},
          bad{"[gait]\nduty = \"half\"\n",
              ":2: gait.duty: expected a number, got a string \"half\"; for example `duty = 0.5"},
          bad{"[cpg]\nfrequency = 3.0\n[throttle]\nspeed = 1.5\n",
              ":4: throttle.speed: 1.5 m/s is out of range, expected 0 to 1 m/s"},
          bad{nullptr, ": cannot be read: No such file or directory"}}) {
      trot::trotting c;
      const std::string before = text_of(c);
      std::filesystem::remove(path);
      if (b.text) std::ofstream(path) << b.text;
      std::string words;
      try {
        c.load(path.string());
      } catch (const cca::refused& refusal) { words = refusal.what(); }
      CHECK_EQ(words.substr(0, path.string().size() + std::string_view(b.words).size()),
               path.string() + b.words);
      CHECK(c.state() == cca::state::created);
      CHECK(text_of(c) == before);
    }
    std::filesystem::remove(path);
  }

  TEST_CASE("a mistake on the command line is refused with its name") {
    const trot::options o = given({"--seconds", "2.5", "--seed", "7", "--terrain", "slope:4", "--quiet"});
    CHECK(o.seed == 7);
    CHECK(o.ground.name() == "slope");
    CHECK(!given({"--seed", "none"}).seed);
    cca::command_line line("trots");
    cca::run_settings settings;
    trot::options listed;
    listed.offer(line, settings);
    line.parse({"--seconds", "2.5", "--quiet"});
    CHECK(settings.seconds == 2.5);
    CHECK(settings.quiet);
    for (const char* option :
         {"--seconds", "--seed", "--terrain", "--speed", "--summary", "--csv", "--svg"}) {
      CHECK(line.help("trot").find(option) != std::string::npos);
      const std::string value = option == std::string("--terrain") ? "flat" : "1";
      CHECK_NOTHROW(given({option, value}));
    }
    for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{{"--fast"},
                                                                                     {"--seconds"},
                                                                                     {"--seconds", "x"},
                                                                                     {"--seconds", "-1"},
                                                                                     {"--seed", "-1"},
                                                                                     {"--terrain", "sea"},
                                                                                     {"--seconds", "nan"}})
      CHECK_THROWS_AS(given(bad), cca::command_line_error);
  }

  TEST_CASE("table, JSON, CSV and picture are complete") {
    const trot::recording recorded = run(2.5, 0);
    const trot::statistics s = trot::evaluate(recorded);
    std::ostringstream table, json, csv, svg;
    trot::write_table(table, s, trot::costs{});
    trot::write_json(json, s, trot::costs{}, {0, "flat"});
    trot::write_csv(csv, recorded);
    trot::write_svg(svg, recorded, "a test");
    CHECK(table.str().find("cost of transport") != std::string::npos);
    for (const char* key : {"speed_m_s", "distance_m", "drift_m", "fell", "max_roll_deg", "max_pitch_deg",
                            "foot_slip_m_s", "slip_of_foot_m_s", "friction_power_w", "cost_of_transport",
                            "real_time_factor", "controller_ns_per_beat"})
      CHECK(trot::json::parse(json.str()).contains(key));
    CHECK(trot::json::parse(json.str())["duty_factor"]["lf"] == s.duty_factor[0]);  // all digits
    CHECK(trot::json::parse(json.str())["seed"] == 0);
    const std::string lines = csv.str();
    CHECK(std::count(lines.begin(), lines.end(), '\n') == 1 + 2500 / 5);
    CHECK(svg.str().ends_with("</svg>\n"));
    for (const char* part : {"footfalls", "path", "angles", "left front", "right hind"})
      CHECK(svg.str().find(part) != std::string::npos);
    for (const char* row : {"distance", "speed", "stride frequency", "duty factor", "foot slip",
                            "friction power", "roll", "pitch", "real-time factor", "controller", "physics"})
      CHECK(table.str().find(row) != std::string::npos);
    CHECK(svg.str().find("nan") == std::string::npos);
  }

  TEST_CASE("the search finds the top of a hill that is bent and stretched") {
    const auto hill = [](const Eigen::VectorXd& x) {
      const double a = x[0] - 0.3, b = x[1] - 0.6 - a * a, c = x[2] - 0.5;
      return -(a * a + 100 * b * b + 10 * c * c);
    };
    gait_search::cma_es search(Eigen::VectorXd::Constant(3, 0.8), 0.2, 10, 1);
    for (int generation = 0; generation < 120; ++generation) {
      std::vector<double> values;
      for (const auto& x : search.ask()) values.push_back(hill(x));
      search.tell(values);
    }
    CHECK(hill(search.mean()) > -1e-8);
  }
}

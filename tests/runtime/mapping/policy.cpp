// A policy: a network whose observations are ports, with weights from a file that knows these ports.
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>
#include <string>

#include <cca/cca.hpp>
#include <cca/mapping/policy.hpp>

#include <doctest/doctest.h>

#include "../../laws/temporary_file.hpp"

namespace laws {
std::size_t allocations();
}

namespace {

struct trunk : cca::frame<"trunk"> {};
struct world : cca::frame<"world"> {};
struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
// [policy]
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<50>> {};
struct gravity : cca::space<cca::cartesian_position<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};

struct walk : cca::policy<cca::policy_inputs<cca::in<"angles", leg_angles>, cca::in<"down", gravity>>,
                          cca::hidden_layers<16, 8>,
                          cca::hyperbolic_tangent,
                          leg_angles> {};

struct robot {
  auto process(cca::beat) -> std::tuple<cca::out<"angles", leg_angles>, cca::out<"down", gravity>> {
    return {angles, Eigen::Vector3d(0, 0, -1)};
  }
  Eigen::Vector2d angles{0.1, -0.5};
};
struct servo {
  void process(cca::in<"command", leg_angles> to) { command = to.vector(); }
  Eigen::Vector2d command{0, 0};
};
struct walking : cca::graph<cca::rate<50>,
                            cca::node<"robot", robot>,
                            cca::node<"walk", walk>,
                            cca::node<"servo", servo>,
                            cca::wire<"robot.angles", "walk.angles">,
                            cca::wire<"robot.down", "walk.down">,
                            cca::wire<"walk.output", "servo.command">> {};
// [policy end]

struct ankle : cca::dimension<"ankle"> {};
struct other_joints : cca::space<cca::joint_angles, cca::axes<hip, ankle>, cca::rate<50>> {};
struct swapped : cca::space<cca::joint_angles, cca::axes<knee, hip>, cca::rate<50>> {};
struct faster : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<100>> {};
struct velocities : cca::space<cca::joint_velocities, cca::axes<hip, knee>, cca::rate<50>> {};
struct gravity_in_world : cca::space<cca::cartesian_position<world>, cca::axes<cca::x, cca::y, cca::z>> {};

template <class Angles, class Down, class To, int Units = 16, cca::fixed_string Name = "angles">
using variant = cca::policy<cca::policy_inputs<cca::in<Name, Angles>, cca::in<"down", Down>>,
                            cca::hidden_layers<Units, 8>,
                            cca::hyperbolic_tangent,
                            To>;

walk::network::parameters drawn(double size, std::uint64_t seed = 1) {
  std::mt19937_64 bits(seed);
  std::uniform_real_distribution<double> any(-size, size);
  walk::network::parameters all;
  for (double& w : all.weights) w = any(bits);
  for (int i = 0; i < all.centre.size(); ++i) all.centre[i] = any(bits), all.scale[i] = 1 + 0.5 * any(bits);
  all.offset = {0.1, -0.6};
  all.gain = {0.3, 0.5};
  return all;
}

using temporary = laws::temporary_file;

template <class F>
std::string words_of(F f) {
  try {
    f();
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return {};
}

auto fired(walk& w, const Eigen::Vector2d& angles, const Eigen::Vector3d& down, std::int64_t origin = 0) {
  return w.process(cca::in<"angles", leg_angles>(angles, 0, true),
                   cca::in<"down", gravity>(down, origin, true));
}

}  // namespace

TEST_CASE("the activations: the tangent to 7e-6, odd and never falling - the rectifier") {
  Eigen::Matrix<double, 1, 1> v, before(-1.1);
  double worst = 0;
  for (double x = -20; x <= 20; x += 1e-3) {
    v[0] = x;
    cca::hyperbolic_tangent::apply(v);
    worst = std::max(worst, std::abs(v[0] - std::tanh(x)));
    CHECK(v[0] >= before[0] - 1e-12);
    before = v;
    Eigen::Matrix<double, 1, 1> mirrored(-x);
    cca::hyperbolic_tangent::apply(mirrored);
    CHECK(mirrored[0] == -v[0]);
    v[0] = x;
    cca::rectifier::apply(v);
    CHECK(v[0] == (x > 0 ? x : 0));
  }
  CHECK(worst < 7e-6);
  CHECK(worst > 1e-6);  // it is not std::tanh
  for (const double huge : {1e12, 1e300, cca::infinity}) {
    v[0] = huge;
    cca::hyperbolic_tangent::apply(v);
    CHECK(v[0] == doctest::Approx(1).epsilon(1e-5));
    v[0] = huge;
    cca::rectifier::apply(v);
    CHECK(v[0] == 1e12);
  }
}

TEST_CASE("the network is the formula of its header") {
  const auto p = drawn(0.8);
  const double* w = p.weights.data();
  for (int k = 0; k < 50; ++k) {
    const walk::network::input x = walk::network::input::Random();
    Eigen::VectorXd h = (x - p.centre).cwiseProduct(p.scale);
    const double* at = w;
    for (const auto& [from, to] : {std::pair(5, 16), std::pair(16, 8), std::pair(8, 2)}) {
      Eigen::VectorXd y(to);
      for (int i = 0; i < to; ++i) {
        y[i] = at[to * from + i];
        for (int j = 0; j < from; ++j) y[i] += at[j * to + i] * h[j];
      }
      at += to * (from + 1);
      h = to == 2 ? y : Eigen::VectorXd(y.array().tanh());
    }
    CHECK(at == w + walk::network::weight_count);
    const Eigen::Vector2d wanted = p.offset + p.gain.cwiseProduct(Eigen::Vector2d(h));
    CHECK((walk::network::answer(p, x) - wanted).norm() < 1e-4);
  }
}

TEST_CASE(
    "in a graph a policy reads its wires in order, and its output stays within the limits of its axes") {
  cca::controller<walking> c;
  CHECK(words_of([&] { c.load(); })
            .find("cca::policy: it has no weights; name their file in the parameter "
                  "`file`, or set `weights` before the load") != std::string::npos);
  auto& w = c.get<"walk">();
  w.weights = drawn(0.8);
  c.load();
  c.start();
  const std::size_t before = laws::allocations();
  c.run(cca::for_beats<3>{});
  CHECK(laws::allocations() == before);
  walk::network::input x;
  x << 0.1, -0.5, 0, 0, -1;
  CHECK(c.get<"servo">().command == walk::network::answer(w.weights, x));
  w.weights.gain.setConstant(1e9);
  for (double angle = -1; angle < 1; angle += 0.05) {
    c.get<"robot">().angles[0] = angle;
    c.step();
    const Eigen::Vector2d y = c.get<"servo">().command;
    CHECK(std::abs(y[0]) <= 0.9);
    CHECK(y[1] >= -1.8);
    CHECK(y[1] <= 0);
  }
}

TEST_CASE("a policy publishes nothing before each input has come, and while one is not finite") {
  walk w;
  w.weights = drawn(0.8);
  const auto status = [](const auto& result) { return std::get<1>(result).vector()[0]; };
  CHECK(!std::get<0>(fired(w, {0.1, -0.5}, {0, 0, -1}, cca::never)));
  const auto good = fired(w, {0.1, -0.5}, {0, 0, -1});
  REQUIRE(std::get<0>(good));
  for (const double broken : {std::nan(""), cca::infinity, -cca::infinity}) {
    const auto one = fired(w, {0.1, broken}, {0, 0, -1}), other = fired(w, {0.1, 0.2}, {broken, 0, -1});
    CHECK(!std::get<0>(one));
    CHECK(!std::get<0>(other));
    CHECK(status(one) == cca::status_of(cca::input_status::unreadable));
    CHECK(status(other) == cca::status_of(cca::input_status::unreadable));
  }
  const auto huge = fired(w, {1e200, -0.5}, {0, 0, -1}), cut = fired(w, {1e12, -0.5}, {0, 0, -1});
  CHECK(status(huge) == cca::status_of(cca::input_status::clamped));
  CHECK(std::get<0>(huge).vector() == std::get<0>(cut).vector());
  CHECK(std::get<0>(fired(w, {0.1, -0.5}, {0, 0, -1})).vector() == std::get<0>(good).vector());
}

TEST_CASE("a saved policy comes back bit for bit, and its file describes its ports") {
  const temporary file("policy"), again("policy_again");
  walk w;
  w.weights = drawn(0.8);
  w.save(file.path);
  const auto text = file.text();
  CHECK(
      text.starts_with("cca learned 1\nmodel feed_forward tanh 5 16 8 2\nlearner policy\n"
                       "input angles: joint_angles at 50 Hz\n"
                       "input angles: number 0, hip, rad from -0.9 to 0.9\n"
                       "input angles: number 1, knee, rad from -1.8 to 0\n"
                       "input angles: schema "));
  walk other;
  REQUIRE(other.p.file.assign(file.path));
  other.on_load();
  CHECK(other.weights.weights == w.weights.weights);
  CHECK(std::get<0>(fired(other, {0.1, -0.5}, {0, 0, -1})).vector() ==
        std::get<0>(fired(w, {0.1, -0.5}, {0, 0, -1})).vector());
  other.save(again.path);
  CHECK(again.text() == text);
  w.weights.weights[3] = std::nan("");
  CHECK(words_of([&] { w.save(file.path); }).find("not written: weights[3]") != std::string::npos);
  w.weights.weights[3] = 1e13;
  CHECK(words_of([&] { w.save(file.path); }).find("a number is above 1e12") != std::string::npos);
  CHECK(file.text() == text);
}

TEST_CASE("a file for other inputs is refused, with the port, the difference and what to do") {
  const temporary file("policy_of_others");
  walk w;
  w.weights = drawn(0.8);
  w.save(file.path);
  const auto says = [&]<class Policy>(std::type_identity<Policy>) {
    const auto other = std::make_unique<Policy>();
    (void)other->p.file.assign(file.path);
    const auto words = words_of([&] { other->on_load(); });
    CHECK(std::ranges::all_of(other->weights.weights, [](double x) { return x == 0; }) == !words.empty());
    return words;
  };
  const auto refusal = [&](int line, const std::string& port, const std::string& found,
                           const std::string& wanted) {
    return file.path + ":" + std::to_string(line) + ": the file was made for another `" + port +
           "`; wire the one of the file, or learn again: found `" + found + "`, expected `" + wanted + "`";
  };
  CHECK(says(std::type_identity<variant<leg_angles, gravity, leg_angles>>()) == "");
  CHECK(says(std::type_identity<variant<velocities, gravity, leg_angles>>()) ==
        refusal(4, "input angles", "input angles: joint_angles at 50 Hz",
                "input angles: joint_velocities at 50 Hz"));
  CHECK(says(std::type_identity<variant<faster, gravity, leg_angles>>()) ==
        refusal(4, "input angles", "input angles: joint_angles at 50 Hz",
                "input angles: joint_angles at 100 Hz"));
  CHECK(says(std::type_identity<variant<swapped, gravity, leg_angles>>()) ==
        refusal(5, "input angles", "input angles: number 0, hip, rad from -0.9 to 0.9",
                "input angles: number 0, knee, rad from -1.8 to 0"));
  CHECK(says(std::type_identity<variant<other_joints, gravity, leg_angles>>()) ==
        refusal(6, "input angles", "input angles: number 1, knee, rad from -1.8 to 0",
                "input angles: number 1, ankle, rad from -inf to inf"));
  CHECK(says(std::type_identity<variant<leg_angles, gravity_in_world, leg_angles>>())
            .starts_with(file.path +
                         ":8: the file was made for another `input down`; wire the one of the file"));
  CHECK(says(std::type_identity<variant<leg_angles, gravity, other_joints>>())
            .starts_with(file.path + ":15: the file was made for another `output`"));
  CHECK(says(std::type_identity<variant<leg_angles, gravity, leg_angles, 16, "joints">>())
            .starts_with(file.path + ":4: the file was made for another `input joints`"));
  CHECK(says(std::type_identity<variant<leg_angles, gravity, leg_angles, 17>>()) ==
        file.path +
            ":2: the file belongs to another model; name the file of this one, or learn again: found "
            "`model feed_forward tanh 5 16 8 2`, expected `model feed_forward tanh 5 17 8 2`");
  auto text = file.text();
  text[text.size() / 2] ^= 1;
  std::ofstream(file.path, std::ios::binary) << text;
  CHECK(says(std::type_identity<walk>()).find("damaged") != std::string::npos);
}

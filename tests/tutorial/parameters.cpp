// The example of docs/parameters.md: loads parameters from a file, saves them, and prints what was saved.
//
//   cca_tutorial_parameters FILE SAVED
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>

#include <cca/cca.hpp>
#include <cca/config.hpp>

namespace {

struct hip : cca::dimension<"hip"> {};
struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};

// [check]
struct range {
  BOOST_HANA_DEFINE_STRUCT(range, (double, low), (double, high));
  const char* check() const { return low < high ? "" : "low must be below high"; }
};
// [check end]

// [component]
enum class terrain { flat, slope, steps };

struct oscillator {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0.1, 5>, frequency),       // Hz, from 0.1 to 5
                             (cca::quantity<cca::angle, -0.9, 0.9>, offset),  // rad here, "30 deg" in a file
                             (terrain, ground),
                             (range, swing));
  };
  parameters p{1.5, 0.0, terrain::flat, {-0.2, 0.2}};

  auto process(cca::beat now) -> cca::out<"angle", hip_angle> {
    const double turns = p.frequency * 1e-9 * static_cast<double>(now.time());
    const double part = 0.5 + 0.5 * std::sin(2 * cca::pi * turns);
    return p.offset + p.swing.low + part * (p.swing.high - p.swing.low);
  }
};
// [component end]

struct walking : cca::graph<cca::node<"cpg", oscillator>> {};

// [controller]
void load_and_save(const char* file, const char* saved) {
  cca::controller<walking> c;
  c.load(file);   // created -> loaded
  c.save(saved);  // loaded -> created
}
// [controller end]

}  // namespace

int main(int, char** arguments) {
  try {
    load_and_save(arguments[1], arguments[2]);
    std::cout << std::ifstream(arguments[2]).rdbuf();
  } catch (const cca::refused& refusal) { std::printf("%s\n", refusal.what()); }
}

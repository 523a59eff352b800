// A controller and its components for these tests.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "shown_components.hpp"

namespace config_test {

enum class terrain { flat, slope, steps };

struct coupling {
  BOOST_HANA_DEFINE_STRUCT(coupling, (double, strength), (std::array<cca::quantity<cca::angle>, 2>, offsets));
  const char* check() const { return strength > 10 ? "so strong a coupling makes the phases jump" : ""; }
};

struct leg {
  BOOST_HANA_DEFINE_STRUCT(leg, (cca::quantity<cca::angle, -1.8, 0.0>, knee), (bool, front));
};

struct hopf {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (double, frequency),
                             (cca::bounded<double, 0.1, 5>, gain),
                             (coupling, links));
    std::string check() const { return frequency == gain ? "frequency and gain are the same" : ""; }
  };
  parameters p{1.5, 1.0, {3.0, {0.0, 0.5}}};
};

struct posture {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::angle, -0.9, 0.9>, hip),
                             (cca::quantity<cca::torque>, load),
                             (Eigen::Vector2d, offset),
                             (Eigen::Matrix2d, mixing),
                             (cca::bounded<int, 0, 3>, mode),
                             (std::uint8_t, retries),
                             (bool, stiff),
                             (terrain, ground),
                             (cca::text<8>, label),
                             (float, slack),
                             (cca::bounded<double, 0.0, cca::infinity>, patience),
                             (std::array<leg, 2>, legs),
                             (cca::quantity<cca::value, 0.0, 1.0>, duty),
                             (std::int64_t, seed));
  };
  parameters p{0.25,   2.0,  {1, 2}, Eigen::Matrix2d::Identity(),     1,   3, true, terrain::slope,
               "trot", 0.1f, 2.0,    {{{-0.5, true}, {-1.0, false}}}, 0.5, 7};
};

struct adder {};

struct controller : shown_components<controller> {
  static constexpr std::string_view file = "trot.toml";
  hopf cpg, ode;
  adder sum;
  posture pose;

  void load(std::string_view from) { cca::detail::config_backend<controller>::load(*this, from); }
  void save(std::string_view to) const { cca::detail::config_backend<controller>::save(*this, to); }

  template <class Self, class F>
  static void each(Self& self, F& f) {
    f("cpg", self.cpg);
    f("sum", self.sum);
    f("dmp.ode", self.ode);
    f("pose", self.pose);
  }
};

}  // namespace config_test

#pragma once
// The ground as a value: level, a slope or steps, and its friction. Built of boxes whose tops are the ground.
//
// The robot starts around x = 0 on level ground at z = 0; slopes and steps begin at `start`.
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace cca::sim {

// A strip of ground: begins at `from_x` in the height `from_z`, has `length` along the surface, rises by the
// angle `pitch`.
struct ground_strip {
  double from_x, from_z, length, pitch;
};

class terrain {
public:
  static terrain flat() { return terrain("flat", {{-reach, 0, 2 * reach, 0}}); }

  static terrain slope(double pitch, double start = 1.5) {
    return terrain("slope", {{-reach, 0, reach + start, 0}, {start, 0, reach, pitch}});
  }

  // Steps up by `rise` every `run` metres, `count` of them.
  static terrain steps(double rise = 0.006, double run = 0.6, int count = 12, double start = 1.5) {
    std::vector<ground_strip> strips{{-reach, 0, 2 * reach, 0}};
    for (int i = 0; i < count; ++i) strips.push_back({start + i * run, (i + 1) * rise, reach - i * run, 0});
    return terrain("steps", std::move(strips));
  }

  // By name, as a command line gives it: `flat`, `slope` or `slope:DEGREES`, `steps` or `steps:MILLIMETRES`.
  static terrain named(std::string_view text) {
    const auto colon = text.find(':');
    const std::string_view name = text.substr(0, colon);
    const std::string number(colon == text.npos ? "" : text.substr(colon + 1));
    std::size_t read = 0;
    double value = 0;
    try {
      if (colon != text.npos) value = std::stod(number, &read);
    } catch (const std::exception&) { read = number.size() + 1; }
    if (read == number.size() && std::isfinite(value)) {
      if (name == "flat" && colon == text.npos) return flat();
      if (name == "slope" && std::abs(value) <= 30)
        return slope((colon == text.npos ? 3.0 : value) * 0.017453292519943295);
      if (name == "steps" && std::abs(value) <= 100) return steps(colon == text.npos ? 0.006 : value / 1000);
    }
    throw std::invalid_argument(
        "terrain '" + std::string(text) +
        "': expected flat, slope[:degrees, at most 30] or steps[:millimetres, at most 100]");
  }

  const std::string& name() const { return name_; }
  const std::vector<ground_strip>& strips() const { return strips_; }

  double friction() const { return friction_; }
  terrain with_friction(double mu) const {
    terrain t = *this;
    t.friction_ = mu;
    return t;
  }

  double height(double x) const {
    double top = -reach;
    for (const auto& s : strips_) {
      const double along = x - s.from_x;
      if (along < 0 || along > s.length * std::cos(s.pitch)) continue;
      const double z = s.from_z + along * std::tan(s.pitch);
      if (z > top) top = z;
    }
    return top;
  }

private:
  static constexpr double reach = 200;  // m; farther than any run goes

  terrain(std::string name, std::vector<ground_strip> strips)
      : name_(std::move(name)), strips_(std::move(strips)) {}

  std::string name_;
  std::vector<ground_strip> strips_;
  double friction_ = 0.75;
};

}  // namespace cca::sim

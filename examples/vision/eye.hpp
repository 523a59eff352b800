// A camera above the table, and the search for the ball on its image: it computes as fast as it can. Where
// the ball was seen before it is searched nearby, which takes a tenth of the time of the whole image.
//
//   in  "ball"   where it is: stands for the light that falls into the camera
//   out "spot"   where it was seen; nothing if it was not
//
// The image is searched by the correlation with discs of several sizes, because the height of the camera is
// not known well. The place is the centre of brightness around the best match.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "table.hpp"

namespace vision {

class eye {
public:
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, noise), (double, least), (int, sizes));
    parameters(double of_a_pixel = 0.05, double least_match = 0.5, int discs = 4)
        : noise(of_a_pixel), least(least_match), sizes(discs) {}
  };
  parameters p{};

  // [process]
  auto process(cca::in<"ball", point> ball) -> cca::maybe<"spot", point> {
    take_image(ball.vector());
    last_seen = last_seen ? find_around(*last_seen, 20) : std::nullopt;
    if (!last_seen) last_seen = find_around({columns / 2, rows / 2}, columns);
    ++images;
    if (!last_seen) return {};
    ++found;
    return centre_around(*last_seen);
  }
  // [process end]

  std::int64_t images = 0, found = 0;

private:
  static constexpr int columns = 160, rows = 120, largest = 6;  // pixels
  static constexpr double metres = 0.005;                       // a pixel
  struct pixel {
    int column, row;
  };

  static Eigen::Vector2d place_of(double column, double row) {
    return {metres * column, metres * (row - rows / 2)};
  }
  float& at(int column, int row) { return image[static_cast<std::size_t>(row * columns + column)]; }

  // The table is brighter on one side, the ball has a soft edge, and each pixel its noise.
  void take_image(const Eigen::Vector2d& ball) {
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        const double distance = (place_of(column, row) - ball).norm();
        const double covered = std::clamp((ball_radius - distance) / metres + 0.5, 0.0, 1.0);
        bits = bits * 6364136223846793005u + 1442695040888963407u;
        const double grain = static_cast<double>(bits >> 11) * 0x1p-52 - 1;
        at(column, row) = static_cast<float>(0.2 + 0.1 * column / columns + 0.6 * covered + p.noise * grain);
      }
  }

  // How much brighter a disc is than the ring around it.
  double match(pixel centre, int radius) {
    double inside = 0, outside = 0;
    int count_inside = 0, count_outside = 0;
    for (int y = -radius - 2; y <= radius + 2; ++y)
      for (int x = -radius - 2; x <= radius + 2; ++x) {
        const int d = x * x + y * y;
        const double value = at(centre.column + x, centre.row + y);
        if (d <= radius * radius) inside += value, ++count_inside;
        else if (d <= (radius + 2) * (radius + 2)) outside += value, ++count_outside;
      }
    return inside / count_inside - outside / count_outside;
  }
  std::optional<pixel> find_around(pixel centre, int window) {
    constexpr int edge = largest + 2;
    double best = p.least;
    std::optional<pixel> found_at;
    for (int row = std::max(edge, centre.row - window); row < std::min(rows - edge, centre.row + window);
         ++row)
      for (int column = std::max(edge, centre.column - window);
           column < std::min(columns - edge, centre.column + window); ++column)
        for (int size = 0; size < std::min(p.sizes, largest - 2); ++size)
          if (const double m = match({column, row}, largest - size); m > best)
            best = m, found_at = pixel{column, row};
    return found_at;
  }
  Eigen::Vector2d centre_around(pixel about) {
    double weight = 0, column = 0, row = 0;
    for (int y = -largest; y <= largest; ++y)
      for (int x = -largest; x <= largest; ++x) {
        const double bright = std::max(0.0, at(about.column + x, about.row + y) - 0.5);
        weight += bright;
        column += bright * (about.column + x);
        row += bright * (about.row + y);
      }
    return weight > 0 ? place_of(column / weight, row / weight) : place_of(about.column, about.row);
  }

  std::array<float, static_cast<std::size_t>(rows* columns)> image{};
  std::optional<pixel> last_seen{};
  std::uint64_t bits = 1;
};

}  // namespace vision

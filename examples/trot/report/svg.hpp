#pragma once
// A run as a picture: the footfalls of the last seconds, the path of the trunk from above, the joint angles
// of one leg.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <ostream>
#include <string>

#include "footfalls.hpp"
#include "recording.hpp"

namespace trot {

namespace detail {

struct range {
  double low, high;
  double part(double x) const { return (x - low) / (high - low); }
};

// A rectangle of the page with axes: maps values to points and draws with them.
class panel {
public:
  panel(std::ostream& out, double top, double height, range x, range y)
      : out_(out), top_(top), height_(height), x_(x), y_(y) {
    out_ << "<rect x='" << left << "' y='" << top_ << "' width='" << width << "' height='" << height_
         << "' fill='#fafafa' stroke='#bbb'/>\n";
  }

  void title(const std::string& text) { label(left, top_ - 8, text, "font-weight='bold'"); }
  void x_ticks(double every, const char* unit) {
    for (double v = std::ceil(x_.low / every) * every; v <= x_.high + 1e-9; v += every) {
      line_at(at_x(v), top_, at_x(v), top_ + height_);
      label(at_x(v), top_ + height_ + 15, number(v) + unit, "text-anchor='middle'");
    }
  }
  void y_ticks(double every, const char* unit) {
    for (double v = std::ceil(y_.low / every) * every; v <= y_.high + 1e-9; v += every) {
      line_at(left, at_y(v), left + width, at_y(v));
      label(left - 6, at_y(v) + 4, number(v) + unit, "text-anchor='end'");
    }
  }
  void row_name(double y, std::string_view text) {
    label(left - 6, at_y(y) + 4, std::string(text), "text-anchor='end'");
  }

  void bar(double from, double to, double low, double high, const char* colour) {
    out_ << "<rect x='" << number(at_x(from)) << "' y='" << number(at_y(high)) << "' width='"
         << number(at_x(to) - at_x(from)) << "' height='" << number(at_y(low) - at_y(high)) << "' fill='"
         << colour << "'/>\n";
  }

  void curve(const recording& run,
             std::size_t first,
             std::size_t every,
             const char* style,
             const std::function<std::pair<double, double>(const moment&)>& point) {
    out_ << "<polyline fill='none' " << style << " points='";
    for (std::size_t i = first; i < run.moments.size(); i += every) {
      const auto [x, y] = point(run.moments[i]);
      out_ << number(at_x(x)) << ',' << number(at_y(y)) << ' ';
    }
    out_ << "'/>\n";
  }

  void note(double part, const char* colour, const std::string& text) {
    label(left + part * width, top_ - 8, text, std::string("fill='") + colour + "'");
  }

private:
  static constexpr double left = 110, width = 820;

  static std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", std::abs(x) < 1e-9 ? 0.0 : x);
    return text;
  }
  double at_x(double x) const { return left + width * x_.part(x); }
  double at_y(double y) const { return top_ + height_ * (1 - y_.part(y)); }
  void line_at(double x1, double y1, double x2, double y2) {
    out_ << "<line x1='" << number(x1) << "' y1='" << number(y1) << "' x2='" << number(x2) << "' y2='"
         << number(y2) << "' stroke='#e4e4e4'/>\n";
  }
  void label(double x, double y, const std::string& text, const std::string& style) {
    out_ << "<text x='" << number(x) << "' y='" << number(y) << "' " << style << ">" << text << "</text>\n";
  }

  std::ostream& out_;
  double top_, height_;
  range x_, y_;
};

inline range path_range(const recording& run) {
  double reach = 0.25;
  for (const moment& m : run.moments) reach = std::max(reach, std::abs(m.position[1] - run.start[1]));
  return {-1.1 * reach, 1.1 * reach};
}

inline double tick(double span) { return span > 8 ? 2 : (span > 3 ? 1 : (span > 1 ? 0.5 : 0.1)); }

}  // namespace detail

inline void write_svg(std::ostream& out,
                      const recording& run,
                      const std::string& title,
                      double window = 2.0) {
  if (run.moments.empty()) return;
  constexpr const char* colours[] = {"#1b6ca8", "#d1495b", "#66a182", "#edae49"};
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 960 800' font-family='sans-serif' "
         "font-size='12'>\n"
         "<rect width='960' height='800' fill='white'/>\n<text x='110' y='28' font-size='16'>"
      << title << "</text>\n";
  const double end = run.moments.back().time, begin = std::max(0.0, end - window);
  const auto first = static_cast<std::size_t>(std::max(0.0, std::round(begin / run.beat)));

  detail::panel feet(out, 70, 160, {begin, end}, {0, 4});
  feet.title("footfalls: a bar where a foot stands");
  feet.x_ticks(0.2, " s");
  for (std::size_t leg = 0; leg < 4; ++leg) {
    const double y = 3 - static_cast<double>(leg);
    feet.row_name(y + 0.5, leg_names[leg]);
    for (const stance& s : stances(run, leg))
      if (s.end > begin) feet.bar(std::max(s.begin, begin), s.end, y + 0.2, y + 0.8, colours[leg]);
  }

  double farthest = 0.5;
  for (const moment& m : run.moments) farthest = std::max(farthest, m.position[0] - run.start[0]);
  const detail::range sideways = detail::path_range(run);
  detail::panel path(out, 300, 150, {0, 1.02 * farthest}, sideways);
  path.title("path of the trunk, from above (y is stretched)");
  path.x_ticks(detail::tick(farthest), " m");
  path.y_ticks(detail::tick(2 * sideways.high) / 2, " m");
  path.curve(run, 0, 20, "stroke='#333' stroke-width='2'", [&](const moment& m) {
    return std::pair(m.position[0] - run.start[0], m.position[1] - run.start[1]);
  });

  detail::panel angles(out, 520, 220, {begin, end}, {-40, 140});
  angles.title("joint angles, left front: measured, and commanded (thin)");
  angles.x_ticks(0.2, " s");
  angles.y_ticks(20, "&#176;");
  angles.note(0.62, colours[0], "hip");
  angles.note(0.70, colours[1], "knee (flexion)");
  constexpr double degree = 57.29577951308232;
  constexpr std::size_t leg = 0;
  using point = std::pair<double, double>;
  angles.curve(run, first, 4, "stroke='#1b6ca8' stroke-width='2'",
               [](const moment& m) { return point(m.time, degree * m.hip[leg]); });
  angles.curve(run, first, 4, "stroke='#1b6ca8' stroke-width='0.7'",
               [](const moment& m) { return point(m.time, degree * m.hip_command[leg]); });
  angles.curve(run, first, 4, "stroke='#d1495b' stroke-width='2'",
               [](const moment& m) { return point(m.time, degree * m.knee[leg]); });
  angles.curve(run, first, 4, "stroke='#d1495b' stroke-width='0.7'",
               [](const moment& m) { return point(m.time, degree * m.knee_command[leg]); });
  out << "</svg>\n";
}

}  // namespace trot

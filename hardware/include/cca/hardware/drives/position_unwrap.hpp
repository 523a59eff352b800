// A position without jumps, for drives whose position wraps: some MIT firmware reports +12.5 rad and then
// -12.5.
//
//   position_unwrap unwrap{25.0};         // the width of the range
//   q = unwrap(report.position);
//   unwrap.turned()                       // how far q is from the last report: whole widths
//
// A joint of a robot does this itself if its mounting states `wraps`.
//
// It works as long as the drive moves less than half the width between two reports: with 25 rad and 50 rad/s
// they may be 250 ms apart. The first report is the start. Use it only for drives that wrap, not for those
// that stay at the end of their range.
#pragma once

namespace cca::hardware {

class position_unwrap {
public:
  constexpr explicit position_unwrap(double width_of_range) : width(width_of_range) {}

  // A number that is not finite changes nothing.
  constexpr double operator()(double reported) {
    if (!(reported - reported == 0)) return now;
    if (begun) {
      double moved = reported - last;
      if (moved > width / 2) moved -= width;
      else if (moved < -width / 2) moved += width;
      now += moved;
    } else {
      now = reported;
    }
    begun = true;
    last = reported;
    return now;
  }
  constexpr double turned() const { return now - last; }
  constexpr void restart() { begun = false; }

private:
  double width, last = 0, now = 0;
  bool begun = false;
};

}  // namespace cca::hardware

// What the page plots: a row of numbers for each beat, the newest value of every output and what the page's
// program adds. The last ones are kept, in a ring.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <cca/graph/layout/lookup.hpp>
#include <cca/runtime/observers/beat_tap.hpp>

namespace cca::page {

// Told of each beat, as a recorder is.
template <class Graph>
class page_tap final : public detail::beat_tap<Graph> {
  static constexpr int outputs = detail::counts_of<Graph>.output_count;
  static constexpr const auto& layout = detail::frame_layout_of<Graph>;

public:
  static constexpr int coordinates = [] {
    int all = 0;
    for (int o = 0; o < outputs; ++o) all += layout.size[static_cast<std::size_t>(o)];
    return all;
  }();

  page_tap()
      : detail::beat_tap<Graph>(4), newest(coordinates), origins(outputs, -1), published(outputs, -1) {}

  // The newest samples, after a beat.
  void take() {
    while (const std::int64_t* const frame = this->ring.oldest()) {
      int at = 0;
      for (std::size_t o = 0; o < static_cast<std::size_t>(outputs); ++o) {
        const auto size = static_cast<std::size_t>(layout.size[o]);
        if (const std::int64_t origin = frame[1 + o]; origin != never) {
          const auto* from = reinterpret_cast<const double*>(frame + layout.at[o]);
          std::copy(from, from + size, newest.data() + at);
          origins[o] = static_cast<double>(origin) * 1e-9;
          published[o] = static_cast<double>(frame[0]);
        }
        at += static_cast<int>(size);
      }
      this->ring.take();
    }
  }

  void parameters_changed(const detail::controller_state<Graph>&, std::int64_t) noexcept override {}
  void moved(state, std::int64_t) noexcept override {}
  void failed(int, const char*, std::int64_t) noexcept override {}
  void controller_is_gone() noexcept override {}

  std::vector<double> newest;     // coordinates of all outputs
  std::vector<double> origins;    // of each output, s
  std::vector<double> published;  // the last beat in which it was; -1: never
};

class row_ring {
public:
  static constexpr std::int64_t beats = 20'000;

  explicit row_ring(int numbers) : width(numbers), numbers_(static_cast<std::size_t>(beats * numbers)) {}
  double* row(std::int64_t beat) { return numbers_.data() + beat % beats * width; }
  double* all() { return numbers_.data(); }

  const int width;

private:
  std::vector<double> numbers_;
};

}  // namespace cca::page

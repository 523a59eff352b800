// What a twin gets of a run.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <cca/record.hpp>
#include <cca/record/twin.hpp>

namespace record_test {

using bytes = std::vector<unsigned char>;

// `before(topic, beat, message)` may change a message, or leave it out.
struct streaming final : cca::recording::message_sink {
  using change = std::function<bool(const std::string& topic, std::int64_t beat, bytes& message)>;
  explicit streaming(change c = {}) : before(std::move(c)) {}

  void channel(const cca::recording::channel_info& one) override {
    topics[one.id] = one.topic;
    writer.channel(one);
  }
  void message(std::uint16_t id,
               std::uint64_t,
               std::uint64_t,
               cca::recording::detail::byte_view data) override {
    bytes copy(data.begin(), data.end());
    std::int64_t beat;
    std::memcpy(&beat, copy.data() + 4, sizeof beat);
    if (!before || before(topics.at(id), beat, copy)) writer.message(id, copy);
  }
  void metadata(const std::string& name, const cca::recording::detail::text_map& entries) override {
    writer.metadata(name, entries);
  }

  change before;
  std::map<std::uint16_t, std::string> topics;
  cca::recording::detail::twin_writer writer;
};

// run() makes the beats of a controller that is loaded and started.
template <class Controller, class Run>
bytes stream_of(Controller& c, const streaming::change& change, Run run) {
  streaming stream(change);
  cca::recording::recorder recording(c, {.waits = true});
  recording.add(stream);
  recording.open();
  c.load();
  c.start();
  run();
  recording.close();
  REQUIRE(recording.lost_beats() == 0);
  return {stream.writer.view().begin(), stream.writer.view().end()};
}

}  // namespace record_test

// A recording's messages into an MCAP file. What can't be written ends the file, not those who write:
// problem() says what happened and where the rest is.
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <string>
#include <vector>

#include <cca/base/array_size.hpp>
#include <cca/record/file/message_sink.hpp>
#include <cca/record/file/settings.hpp>
#include <cca/record/mcap/writer.hpp>

namespace cca::recording::detail {

class file_sink final : public message_sink {
public:
  // Errors: those of mcap_writer.
  file_sink(const std::string& name, const settings& s) : file(name, s.chunk_bytes, s.compression_level) {}

  void channel(const channel_info& one) override {
    guarded([&] {
      channels.resize(one.id + std::size_t{1});
      channels[one.id] = file.channel(one.topic, one.type, one.schema, one.metadata);
    });
  }
  void message(std::uint16_t id,
               std::uint64_t log_time,
               std::uint64_t publish_time,
               byte_view data) override {
    guarded([&] { file.message(channels[id], log_time, publish_time, data); });
  }
  void metadata(const std::string& name, const text_map& entries) override {
    guarded([&] { file.metadata(name, entries); });
  }
  void flush() override {
    guarded([&] { file.flush(); });
  }
  void close() {
    guarded([&] { file.close(); });
  }
  void discard() {
    guarded([&] { file.discard(); });
  }

  bool is_broken() const noexcept { return broken.load(std::memory_order_acquire); }
  // Empty: all is well.
  std::string problem() const {
    const std::scoped_lock lock(guard);
    return what_failed;
  }

private:
  template <class F>
  void guarded(F f) {
    if (is_broken()) return;
    try {
      f();
    } catch (const std::exception& e) {
      const std::scoped_lock lock(guard);
      what_failed = std::string(e.what()) + "; up to there it is in " + file.written_to();
      broken.store(true, std::memory_order_release);
    }
  }

  mcap_writer file;
  std::vector<std::uint16_t> channels;  // the file's numbers
  std::atomic<bool> broken{false};
  mutable std::mutex guard;  // of what_failed
  std::string what_failed;
};

}  // namespace cca::recording::detail

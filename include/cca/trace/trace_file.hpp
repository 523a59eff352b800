// Writes events in Chrome's trace format, as one array: one event a line. A file that was cut off between two
// events lacks only its last bracket, which readers of the format don't need.
//
// Until it is closed the events are in a part beside it (base/system/output_file.hpp).
//
// Errors: std::system_error if it can't be opened or written, cca::refused if another program writes it.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <cca/base/system/output_file.hpp>
#include <cca/trace/json_text.hpp>

namespace cca::detail {

class trace_file {
public:
  explicit trace_file(std::string file) : to(std::move(file)) { text << '['; }

  // What lasts. Times in ns; `arguments` are the members of a JSON object.
  void write_span(std::string_view called,
                  std::string_view category,
                  int track,
                  std::int64_t begin,
                  std::int64_t end,
                  std::string_view arguments = {}) {
    begin_event(called, category, 'X', track);
    (text << R"(,"ts":)").add_microseconds(begin);
    (text << R"(,"dur":)").add_microseconds(end - begin);
    end_event(arguments);
  }
  void write_moment(std::string_view called,
                    std::string_view category,
                    int track,
                    std::int64_t at,
                    std::string_view arguments = {}) {
    begin_event(called, category, 'i', track);
    (text << R"(,"s":"t","ts":)").add_microseconds(at);
    end_event(arguments);
  }
  // `what`: process_name, thread_name.
  void write_name(std::string_view what, int track, std::string_view called) {
    begin_event(what, "__metadata", 'M', track);
    json_text argument;
    end_event(argument.add_member("name", called).view());
  }

  // Whole events, so that what is there after a crash can be read.
  void flush() {
    to.write(text.view());
    text.clear();
  }
  void close() {
    text << "\n]\n";
    flush();
    to.keep();
  }
  // An older file of this name stays.
  void discard() { to.discard(); }
  const std::string& written_to() const { return to.written_to(); }  // until it is closed

private:
  static constexpr std::size_t most_buffered = 1 << 18;

  void begin_event(std::string_view called, std::string_view category, char phase, int track) {
    text << (std::exchange(is_first, false) ? "\n" : ",\n") << R"({"name":)";
    text.add_quoted(called) << R"(,"cat":)";
    text.add_quoted(category) << R"(,"ph":")" << phase << R"(","pid":)" << process << R"(,"tid":)"
                              << std::int64_t{track};
  }
  void end_event(std::string_view arguments) {
    if (!arguments.empty()) text << R"(,"args":{)" << arguments << '}';
    text << '}';
    if (text.view().size() > most_buffered) flush();
  }

  output_file to;
  bool is_first = true;
  std::int64_t process = ::getpid();
  json_text text;
};

}  // namespace cca::detail

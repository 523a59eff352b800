// The network side of a door: a WebSocket server of the Foxglove protocol in a thread of its own. It knows no
// graph: a message_sink brings what it shows, and its requests go through door_controls.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <cca/base/separate/compiled.hpp>
#include <cca/door/controls.hpp>
#include <cca/door/network/limits.hpp>
#include <cca/door/settings.hpp>
#include <cca/record/file/message_sink.hpp>

namespace cca::detail {

class door_server {
public:
  // Errors: cca::refused, with the address, if it can't listen there or the token's file is not this user's
  // alone.
  door_server(const door_settings&, door_controls&, const door_limits& = {});
  door_server(const door_server&) = delete;
  door_server& operator=(const door_server&) = delete;
  ~door_server();  // closes all connections

  recording::message_sink& sink();  // for the thread that writes a recording

  std::uint16_t port() const;
  std::string token() const;
  std::string one_time_url() const;  // for a viewer that knows only a URL: each is valid once

private:
  struct inside;
  std::unique_ptr<inside> in;
};

}  // namespace cca::detail

#if !CCA_HAS_COMPILED_DOOR
#include <cca/door/server_functions.hpp>
#endif

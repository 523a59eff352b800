// How much a client may ask of a door: so its memory is bounded, and nothing waits for a client.
#pragma once

#include <chrono>
#include <cstddef>

namespace cca::detail {

struct door_limits {
  std::size_t message = 64 << 10;       // bytes of a message that a client sends
  std::size_t greeting = 8 << 10;       // bytes of the request that opens a connection
  std::size_t half_open = 64;           // connections whose greeting is not finished: then the oldest goes
  std::size_t subscriptions = 4096;     // of a client
  std::size_t name = 256;               // bytes of the name of a parameter that a client subscribes to
  std::size_t complaints = 8;           // that answer one message
  std::size_t answers = 4 << 20;        // bytes of answers that a client has not read: then it is dropped
  std::size_t waiting_bytes = 1 << 20;  // bytes of samples that a client has not read: the oldest go first
  std::size_t waiting_messages = 8192;  // and their number
  std::size_t handed_over = 8 << 20;    // bytes between the recording's thread and the door's
  std::size_t requests = 64;            // that wait for the controller, of all clients
  double messages_per_second = 1000;    // of a client; twice as many at once
  double bytes_per_second = 1 << 20;    // likewise
  std::size_t depth = 16;               // of JSON
  std::size_t twin_text = 400;          // bytes of what a client tells of its twin
  int wrong_tokens = 3;                 // of a connection
  std::chrono::milliseconds greeting_time{5000};      // to finish the greeting
  std::chrono::milliseconds page_time{30000};         // to read the page
  std::chrono::milliseconds taken_time{5000};         // for a controller to take a request
  std::chrono::milliseconds silence{10000};           // of a client, which is asked each second
  std::chrono::milliseconds commander_silence{5000};  // and of the one that commands
};

}  // namespace cca::detail

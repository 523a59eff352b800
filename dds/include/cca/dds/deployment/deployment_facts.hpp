// What the threads of the transport need to know of a deployment, without its type: so they are compiled
// once.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cca/base/fixed_string.hpp>
#include <cca/dds/deployment/messages.hpp>

namespace cca::dds::detail {

struct leaving_output {
  int environment = 0;
  std::string topic, type;
  std::size_t size = 0;       // numbers of a sample
  std::int32_t depth = 0;     // samples that readers may be behind
  std::uint64_t readers = 0;  // a bit for each environment that reads it
};

struct environment_facts {
  std::string_view name;
  // What it has sent tells how far it is: it can't fault, and its clocks are known. And it tells that to all
  // who have to know.
  bool samples_tell = false, samples_tell_all = false;
};

struct deployment_facts {
  std::vector<environment_facts> environments;
  std::uint64_t here = 0;  // a bit for each environment of this process
  std::vector<leaving_output> outputs;
  std::string manifest;
  bounds limits;

  bool is_here(std::size_t environment) const { return (here >> environment & 1) != 0; }
  std::size_t first_here() const { return static_cast<std::size_t>(std::countr_zero(here)); }
  std::vector<std::size_t> outputs_of(std::size_t environment) const {
    std::vector<std::size_t> all;
    for (std::size_t o = 0; o < outputs.size(); ++o)
      if (outputs[o].environment == static_cast<int>(environment)) all.push_back(o);
    return all;
  }
  std::string status_topic(std::size_t environment) const {
    return "cca/" + std::string(environments[environment].name) + "/status";
  }
  // Processes of another deployment have another type.
  std::string status_type() const { return "cca::status_" + as_text(cca::detail::hash(manifest)); }

  static std::string as_text(std::uint64_t hash) {
    std::string text(16, '0');
    for (std::size_t i = 16; i-- > 0; hash >>= 4) text[i] = "0123456789abcdef"[hash & 15];
    return text;
  }
};

// The exchange of this process. Each record and each ring in it has one writer: the environments that run
// here write theirs, and the receiving thread writes those of the others.
class exchange_of_process {
public:
  virtual ~exchange_of_process() = default;

  // For the thread that sends. `take`: the next sample of an output as a message; false: there is none.
  virtual void read(std::size_t environment, status& to) const = 0;
  virtual bool take(std::size_t output, std::uint64_t& next, words& message) const = 0;

  // For the thread that receives. `at`: when the status came, by this machine's clock.
  virtual void write(std::size_t environment, const status& from, std::int64_t at) = 0;
  virtual void forget(std::size_t environment) = 0;  // as if it had never begun
  virtual void put(std::size_t output, std::span<const std::uint64_t> message) = 0;

  virtual std::int64_t newest_beat() const = 0;
  virtual std::int64_t run_ready(std::size_t environment) const = 0;
  virtual std::int64_t run_arrived(std::size_t environment) const = 0;
  virtual std::int64_t run_finished(std::size_t environment) const = 0;
};

// What all threads of this process know of an environment that another process runs.
struct contact {
  std::atomic<std::uint64_t> accepted{0};    // the participant that this process listens to; 0: none
  std::atomic<std::int64_t> accepted_in{0};  // the newest run that this process began before that
  std::atomic<std::int64_t> heard{0};        // when its newest status came (ns); 0: never
  std::atomic<bool> has_left{false};         // it said so, or it was refused
};
using contacts = std::unique_ptr<contact[]>;

}  // namespace cca::dds::detail

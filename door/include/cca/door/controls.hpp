// What the door asks of the program behind it, without the types of its graph.
//
// All functions are called from the thread of the door. None waits: a request is begun, and later asked
// whether it has been taken. What is refused throws nothing here: the outcome says why.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cca::detail {

// A value as JSON knows it: of a parameter, or an argument of a command.
struct door_value {
  enum class kind { number, integer, boolean, text, numbers } what = kind::number;
  double number = 0;
  std::int64_t integer = 0;  // and of a boolean
  std::string text{};        // also of a choice: its name
  std::vector<double> numbers{};
  bool operator==(const door_value&) const = default;
};

struct door_parameter {
  std::string path;  // `gait.frequency`, `arm.gains`
  door_value value{};
  std::string unit{};                      // empty: none
  std::optional<double> lower{}, upper{};  // of a number; in SI units
  std::vector<std::string> choices{};      // of a choice
};

// A command that a program has beside those of every door: a push, a jog. While it is held it has an effect,
// which ends when it is released, or when the connection of the client that holds it is lost.
struct door_command {
  struct argument {
    std::string name, unit{};
    double value = 0, lower = 0, upper = 0;  // at first, and its range
  };
  std::string name, help{};
  std::vector<argument> arguments{};
  bool is_held = false;
};

// An input that a test may add a signal to (cca::test_input), and the node whose parameters say which.
struct door_test_input {
  std::string input, node, unit{};  // `servo.reference`, `test_servo_reference`
  std::vector<std::string> axes{};
  double most = 0;  // the largest amplitude
};

struct door_environment {
  std::string name;
  std::int64_t beats = 0, overruns = 0, lost_periods = 0, late = 0;
  double beat_mean = 0, beat_p99 = 0, beat_most = 0;           // s, how long a beat computes; 0: not measured
  double wake_up_mean = 0, wake_up_p99 = 0, wake_up_most = 0;  // s, how late it begins
};

struct door_status {
  std::string state{};  // created, loaded, started, running, faulted
  std::int64_t beat = 0, overruns = 0;
  std::int64_t period = 0;  // ns
  bool is_paused = false;
  double speed = 1;                           // times the clock; 0: in a fast run
  std::string mode{}, fault{}, fault_path{};  // empty: none
  std::string recording{};                    // the file; empty: none
  std::string recording_problem{};            // why nothing more comes into it; empty: all is well
  std::vector<std::string> stopped_parts{};
  // Where there is no beat, after a fault or in a pause: what components say has stopped the robot, the first
  // cause first.
  std::vector<std::string> causes{};
};

// What never changes.
struct door_description {
  std::string program{}, architecture{};  // its type, and the text that recordings have
  std::vector<std::string> modes{}, parts{}, nodes{};
  std::vector<std::pair<std::string, std::string>> wires{};  // output path, input path
  std::vector<door_command> commands{};
  std::vector<door_test_input> tests{};
};

struct door_request {
  // `call`: a command of the program; `release`: the end of one that is held.
  enum class what {
    set,
    load,
    save,
    stop_part,
    start_part,
    switch_mode,
    pause,
    go_on,
    step,
    end_steps,  // that are to come
    speed,
    end_run,
    resume,
    start,
    record,
    end_recording,
    call,
    release
  } about = what::pause;
  std::vector<std::pair<std::string, door_value>> values{};  // set: path and value; call: argument and value
  // A file, a part, a mode, the name of a command; end_run: what has ended the run, for a person.
  std::string text{};
  std::string scope{};  // load, save: a component or a graph; empty: all
  double number = 0;    // speed; step: how many beats
};

struct door_outcome {
  enum class how { done, begun, busy, refused } is = how::done;
  std::string why{};  // refused: a sentence that says what, where and what to do
};

class door_controls {
public:
  door_controls() = default;
  door_controls(const door_controls&) = delete;
  door_controls& operator=(const door_controls&) = delete;
  virtual ~door_controls() = default;

  virtual const door_description& description() const = 0;
  virtual door_status status() const = 0;
  virtual std::vector<door_environment> environments() const = 0;
  // Why nothing more comes into the file of the recording; empty: all is well. It asks no beat.
  virtual std::string recording_problem() const { return {}; }
  // All, in the order of the graph. Empty: busy, ask again later.
  virtual std::optional<std::vector<door_parameter>> parameters() = 0;

  // Done at once, refused, busy (an earlier one has not been taken: try again), or begun: then `outcome`
  // tells later. One at a time. All of one request has effect in one beat, or nothing of it.
  virtual door_outcome begin(const door_request&) = 0;
  // Of the last request that was begun: begun (not taken yet), done or refused.
  virtual door_outcome outcome() = 0;

  // Into the recording and the log: who changed what. `client`: `127.0.0.1:40312`.
  virtual void note(std::string_view client, std::string_view what) = 0;
};

}  // namespace cca::detail

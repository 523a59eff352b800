// The part of a test peer that all vendors share: what it publishes, and how it prints what it receives.
//
//   peer hear DOMAIN TYPE TOPIC   prints the first message, then ends; 1 if none comes within 20 s
//   peer tell DOMAIN TYPE TOPIC   sends one message fifty times a second until it is killed, or for 30 s
//   peer big  DOMAIN TYPE TOPIC   the same, as a machine that is big-endian writes it (Fast DDS only)
//   peer lie  DOMAIN TYPE TOPIC   the same with broken bytes (Fast DDS only)
//
// On a topic that ends in "_static" messages are kept for those that come later. A peer shares no code with
// cca.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

// A message of any type: texts, and numbers field by field.
struct content {
  std::string frame;
  std::int32_t sec = 0;
  std::vector<std::string> words;
  std::vector<std::vector<double>> numbers;
};

inline std::string as_text(const content& c) {
  std::string all = "frame `" + c.frame + "`";
  const bool is_recent = c.sec >= std::time(nullptr) - 5 && c.sec <= std::time(nullptr) + 1;
  all += c.sec == 0 ? ", no stamp" : is_recent ? ", stamped now" : ", another time";
  for (const auto& word : c.words) all += " " + word;
  for (const auto& field : c.numbers) {
    all += " |";
    for (const double number : field) {
      char digits[32];
      std::snprintf(digits, sizeof digits, " %g", number);
      all += digits;
    }
  }
  return all;
}

// In JointState the joints stand in another order than in the graph, and there is one more.
inline content told(const std::string& type) {
  const std::vector<double> unknown(9, 0.0);
  if (type == "JointState") return {"", 7, {"knee", "tail", "hip"}, {{-0.5, 9, 0.25}, {2, 9, 1}, {4, 9, 3}}};
  if (type == "Imu")
    return {"trunk", 7, {}, {{0, 0, 0.6, 0.8}, unknown, {1, 2, 3}, unknown, {4, 5, 9.81}, unknown}};
  if (type == "WrenchStamped") return {"trunk", 7, {}, {{1, 2, 3}, {4, 5, 6}}};
  if (type == "TwistStamped") return {"world", 7, {}, {{1, 2, 3}, {4, 5, 6}}};
  if (type == "PoseStamped") return {"world", 7, {}, {{1, 2, 3}, {0, 0, 0.6, 0.8}}};
  if (type == "Twist") return {"", 0, {}, {{1, 2, 3}, {4, 5, 6}}};
  if (type == "TransformStamped") return {"world", 7, {"trunk"}, {{1, 2, 3}, {0, 0, 0.6, 0.8}}};
  if (type == "TFMessage")  // two of them
    return {"world", 7, {"odom", "trunk"}, {{9, 9, 9}, {0, 0, 0, 1}, {1, 2, 3}, {0, 0, 0.6, 0.8}}};
  if (type == "JointTrajectory")  // for each point: positions, velocities, accelerations, effort, time
    return {"",
            0,
            {"knee", "tail", "hip"},
            {{-0.5, 9, 0.25}, {2, 9, 1}, {}, {}, {0.5}, {-1, 9, 0.5}, {4, 9, 3}, {9, 9, 9}, {}, {1.25}}};
  if (type == "Image") {  // height, width, is_bigendian, step; two bytes after each row are no pixels
    std::vector<double> data;
    for (int row = 0; row < 2; ++row) {
      for (int i = 0; i < 12; ++i) data.push_back(10 * (12 * row + i) + 10);
      data.insert(data.end(), {255, 255});
    }
    return {"camera", 7, {"rgb8"}, {{2, 4, 0, 14}, data}};
  }
  return {"", 0, {}, {{0}, {7, 8}}};  // an array whose layout is empty; its offset is the first number
}

inline constexpr int big_endian = -1;  // instead of the number of a lie

// `Peer` is constructed of domain, type and topic, and has `hear(content&)` and `tell(content)`.
template <class Peer>
int run_peer(int count, char** arguments) {
  using namespace std::chrono_literals;
  if (count != 5) return 2;
  const std::string what = arguments[1], type = arguments[3];
  Peer peer(static_cast<std::uint32_t>(std::stoul(arguments[2])), type, "rt/" + std::string(arguments[4]),
            what);
  if (what == "hear") {
    for (int i = 0; i < 2000; ++i) {
      content c;
      if (peer.hear(c)) {
        std::printf("%s\n", as_text(c).c_str());
        return 0;
      }
      std::this_thread::sleep_for(10ms);
    }
    std::printf("nothing\n");
    return 1;
  }
  for (int i = 0; i < 1500; ++i) {
    peer.tell(told(type), what == "lie" ? i : what == "big" ? big_endian : 0);
    std::this_thread::sleep_for(what == "lie" ? 2ms : 20ms);
  }
  return 0;
}

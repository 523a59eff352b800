// A program that shares no code with cca: its types are code that Cyclone's idlc made of what cca::idl wrote.
//
//   space_peer hear DOMAIN TOPIC TYPE       prints the first sample, then ends; 1 if none comes within 20 s
//   space_peer tell DOMAIN TOPIC TYPE HOW   sends a sample fifty times a second until it is killed, or for 30
//   s
//
// HOW: fit, or what is wrong with it: other_space, future, nan, turned, half.
#include <dds/dds.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "spaces.h"

namespace {

// Loopback only, as cca's own default.
constexpr const char* on_this_machine =
    "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface address=\"127.0.0.1\" "
    "multicast=\"false\"/></Interfaces><AllowMulticast>false</AllowMulticast></General><Discovery>"
    "<ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>31</MaxAutoParticipantIndex>"
    "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery></Domain></CycloneDDS>";

// For each type: its number, and its coordinates in order.

struct leg_angles {
  using type = cca_talk_leg_angles_sample;
  static constexpr std::int64_t space = cca_talk_leg_angles_space;
  static const dds_topic_descriptor_t& about() { return cca_talk_leg_angles_sample_desc; }
  static std::vector<double*> fields(type& m) { return {&m.hip_, &m.knee_}; }
};
struct leg_torques {
  using type = cca_talk_leg_torques_sample;
  static constexpr std::int64_t space = cca_talk_leg_torques_space;
  static const dds_topic_descriptor_t& about() { return cca_talk_leg_torques_sample_desc; }
  static std::vector<double*> fields(type& m) { return {&m.hip_, &m.knee_}; }
};
struct any {
  using type = cca_talk_any_sample;
  static constexpr std::int64_t space = cca_talk_any_space;
  static const dds_topic_descriptor_t& about() { return cca_talk_any_sample_desc; }
  static std::vector<double*> fields(type& m) { return {&m.in_, &m.octet_, &m.c3rd_}; }
};
struct trunk_pose {
  using type = cca_talk_trunk_pose_sample;
  static constexpr std::int64_t space = cca_talk_trunk_pose_space;
  static const dds_topic_descriptor_t& about() { return cca_talk_trunk_pose_sample_desc; }
  static std::vector<double*> fields(type& m) {
    return {&m.x_, &m.y_, &m.z_, &m.qx_, &m.qy_, &m.qz_, &m.qw_};
  }
};
struct mood {
  using type = cca_talk_mood_sample;
  static constexpr std::int64_t space = cca_talk_mood_space;
  static const dds_topic_descriptor_t& about() { return cca_talk_mood_sample_desc; }
  static std::vector<double*> fields(type& m) { return {&m.hip_}; }
};
std::vector<double*> all_of(double* values, std::size_t count) {
  std::vector<double*> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(values + i);
  return all;
}
struct pads {
  using type = cca_talk_pads_sample;
  static constexpr std::int64_t space = cca_talk_pads_space;
  static const dds_topic_descriptor_t& about() { return cca_talk_pads_sample_desc; }
  static std::vector<double*> fields(type& m) { return all_of(m.values, std::size(m.values)); }
};
struct paws {
  using type = cca_talk_paws_sample;
  static constexpr std::int64_t space = cca_talk_paws_space;
  static const dds_topic_descriptor_t& about() { return cca_talk_paws_sample_desc; }
  static std::vector<double*> fields(type& m) { return all_of(m.values, std::size(m.values)); }
};
struct picture {
  using type = cca_talk_picture_sample;
  static constexpr std::int64_t space = cca_talk_picture_space;
  static const dds_topic_descriptor_t& about() { return cca_talk_picture_sample_desc; }
  static std::vector<double*> fields(type& m) { return all_of(m.values, std::size(m.values)); }
};

template <class F>
void with_type(const std::string& name, F f) {
  if (name == "leg_angles") f(leg_angles{});
  if (name == "leg_torques") f(leg_torques{});
  if (name == "any") f(any{});
  if (name == "pads") f(pads{});
  if (name == "trunk_pose") f(trunk_pose{});
  if (name == "paws") f(paws{});
  if (name == "mood") f(mood{});
  if (name == "picture") f(picture{});
}

// Coordinate i of what it sends: 1, 1.5, 2, ... A quaternion is 0, 0, 0.6, 0.8.
double told(const std::string& name, std::size_t i) {
  constexpr double turned[] = {0, 0, 0.6, 0.8};
  if ((name == "trunk_pose" || name == "paws") && i % 7 >= 3) return turned[i % 7 - 3];
  return name == "picture" ? static_cast<double>(i % 256) : 1 + 0.5 * static_cast<double>(i);
}

// The first eight coordinates, and the sum of all.
template <class Type>
std::string as_text(typename Type::type& m) {
  std::string all = m.space == Type::space ? "its space" : "another space";
  all += m.age >= 0 && m.age < 1'000'000'000 ? ", fresh |" : ", old |";
  double sum = 0;
  const auto fields = Type::fields(m);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    sum += *fields[i];
    char digits[32];
    std::snprintf(digits, sizeof digits, " %g", *fields[i]);
    if (i < 8) all += digits;
  }
  return all + " | " + std::to_string(sum);
}

template <class Type>
bool hear(dds_entity_t reader) {
  void* one[1] = {nullptr};
  dds_sample_info_t about;
  const int count = dds_take(reader, one, &about, 1, 1);
  if (count <= 0) return false;
  const bool is_sample = about.valid_data;
  if (is_sample) std::printf("%s\n", as_text<Type>(*static_cast<typename Type::type*>(one[0])).c_str());
  dds_return_loan(reader, one, count);
  return is_sample;
}

template <class Type>
void tell(dds_entity_t writer, const std::string& name, const std::string& how) {
  const auto m = std::make_unique<typename Type::type>();
  m->space = Type::space + (how == "other_space" ? 1 : 0);
  m->age = how == "future" ? -1 : 250'000'000;
  const auto fields = Type::fields(*m);
  for (std::size_t i = 0; i < fields.size(); ++i) *fields[i] = told(name, i);
  if (how == "nan") *fields.back() = std::numeric_limits<double>::quiet_NaN();
  if (how == "turned") *fields.back() = 2;
  if (how == "half") *fields[0] = 1.5;
  dds_write(writer, m.get());
}

}  // namespace

int main(int count, char** words) {
  using namespace std::chrono_literals;
  if (count < 5) return 2;
  const std::string what = words[1], name = words[4], how = count > 5 ? words[5] : "fit";
  const auto domain = static_cast<dds_domainid_t>(std::stoul(words[2]));
  dds_create_domain(domain, on_this_machine);
  const dds_entity_t in = dds_create_participant(domain, nullptr, nullptr);
  dds_qos_t* const q = dds_create_qos();
  dds_qset_reliability(q, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
  int code = what == "hear";
  with_type(name, [&](auto type) {
    using Type = decltype(type);
    const dds_entity_t on = dds_create_topic(in, &Type::about(), words[3], nullptr, nullptr);
    if (what == "hear") {
      const dds_entity_t reader = dds_create_reader(in, on, q, nullptr);
      for (int i = 0; i < 2000 && code != 0; ++i, std::this_thread::sleep_for(10ms))
        if (hear<Type>(reader)) code = 0;
      if (code != 0) std::printf("nothing\n");
    } else {
      const dds_entity_t writer = dds_create_writer(in, on, q, nullptr);
      for (int i = 0; i < 1500; ++i, std::this_thread::sleep_for(20ms)) tell<Type>(writer, name, how);
    }
  });
  dds_delete_qos(q);
  return code;
}

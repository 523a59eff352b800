// A peer whose types are code that Cyclone's idlc made of ros2_types.idl.
#include <dds/dds.h>

#include <cstring>

#include "peer.hpp"
#include "ros2_types.h"

namespace {

// Loopback only, as cca's own default.
constexpr const char* on_this_machine =
    "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface address=\"127.0.0.1\" "
    "multicast=\"false\"/></Interfaces><AllowMulticast>false</AllowMulticast></General><Discovery>"
    "<ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>31</MaxAutoParticipantIndex>"
    "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery></Domain></CycloneDDS>";

template <class Sequence>
void fill(Sequence& to, std::vector<double>& from) {
  to._maximum = to._length = static_cast<std::uint32_t>(from.size());
  to._buffer = from.data();
  to._release = false;
}
std::vector<double> list(const auto& from) { return {from._buffer, from._buffer + from._length}; }
std::vector<double> list_3(const geometry_msgs_msg_dds__Vector3_& v) { return {v.x_, v.y_, v.z_}; }
geometry_msgs_msg_dds__Vector3_ vector_3(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }
void read(const std_msgs_msg_dds__Header_& h, content& c) {
  c.frame = h.frame_id_;
  c.sec = h.stamp_.sec_;
}

// For each type: what its messages hold, and messages that hold it.

struct joint_state {
  using type = sensor_msgs_msg_dds__JointState_;
  static const dds_topic_descriptor_t& about() { return sensor_msgs_msg_dds__JointState__desc; }
  static void read_from(const type& m, content& c) {
    read(m.header_, c);
    for (std::uint32_t i = 0; i < m.name_._length; ++i) c.words.emplace_back(m.name_._buffer[i]);
    c.numbers = {list(m.position_), list(m.velocity_), list(m.effort_)};
  }
  static void write(dds_entity_t writer, content c) {
    type m{};
    m.header_ = {{c.sec, 0}, c.frame.data()};
    std::vector<char*> names;
    for (auto& word : c.words) names.push_back(word.data());
    m.name_._maximum = m.name_._length = static_cast<std::uint32_t>(names.size());
    m.name_._buffer = names.data();
    fill(m.position_, c.numbers[0]);
    fill(m.velocity_, c.numbers[1]);
    fill(m.effort_, c.numbers[2]);
    dds_write(writer, &m);
  }
};

struct imu {
  using type = sensor_msgs_msg_dds__Imu_;
  static const dds_topic_descriptor_t& about() { return sensor_msgs_msg_dds__Imu__desc; }
  static std::vector<double> list_9(const double (&from)[9]) { return {from, from + 9}; }
  static void read_from(const type& m, content& c) {
    read(m.header_, c);
    const auto& q = m.orientation_;
    c.numbers = {{q.x_, q.y_, q.z_, q.w_},       list_9(m.orientation_covariance_),
                 list_3(m.angular_velocity_),    list_9(m.angular_velocity_covariance_),
                 list_3(m.linear_acceleration_), list_9(m.linear_acceleration_covariance_)};
  }
  static void write(dds_entity_t writer, content c) {
    type m{};
    m.header_ = {{c.sec, 0}, c.frame.data()};
    const auto& q = c.numbers[0];
    m.orientation_ = {q[0], q[1], q[2], q[3]};
    m.angular_velocity_ = vector_3(c.numbers[2]);
    m.linear_acceleration_ = vector_3(c.numbers[4]);
    dds_write(writer, &m);
  }
};

struct wrench_stamped {
  using type = geometry_msgs_msg_dds__WrenchStamped_;
  static const dds_topic_descriptor_t& about() { return geometry_msgs_msg_dds__WrenchStamped__desc; }
  static void read_from(const type& m, content& c) {
    read(m.header_, c);
    c.numbers = {list_3(m.wrench_.force_), list_3(m.wrench_.torque_)};
  }
  static void write(dds_entity_t writer, content c) {
    type m{};
    m.header_ = {{c.sec, 0}, c.frame.data()};
    m.wrench_ = {vector_3(c.numbers[0]), vector_3(c.numbers[1])};
    dds_write(writer, &m);
  }
};

struct twist_stamped {
  using type = geometry_msgs_msg_dds__TwistStamped_;
  static const dds_topic_descriptor_t& about() { return geometry_msgs_msg_dds__TwistStamped__desc; }
  static void read_from(const type& m, content& c) {
    read(m.header_, c);
    c.numbers = {list_3(m.twist_.linear_), list_3(m.twist_.angular_)};
  }
  static void write(dds_entity_t writer, content c) {
    type m{};
    m.header_ = {{c.sec, 0}, c.frame.data()};
    m.twist_ = {vector_3(c.numbers[0]), vector_3(c.numbers[1])};
    dds_write(writer, &m);
  }
};

struct float64_multi_array {
  using type = std_msgs_msg_dds__Float64MultiArray_;
  static const dds_topic_descriptor_t& about() { return std_msgs_msg_dds__Float64MultiArray__desc; }
  static void read_from(const type& m, content& c) {
    c.numbers.push_back({double(m.layout_.data_offset_)});
    for (std::uint32_t i = 0; i < m.layout_.dim_._length; ++i) {
      const auto& d = m.layout_.dim_._buffer[i];
      c.words.emplace_back(d.label_);
      c.numbers.push_back({double(d.size_), double(d.stride_)});
    }
    c.numbers.push_back(list(m.data_));
  }
  static void write(dds_entity_t writer, content c) {
    type m{};
    fill(m.data_, c.numbers[1]);
    dds_write(writer, &m);
  }
};

std::vector<double> list_4(const geometry_msgs_msg_dds__Quaternion_& q) { return {q.x_, q.y_, q.z_, q.w_}; }
geometry_msgs_msg_dds__Quaternion_ quaternion(const std::vector<double>& q) {
  return {q[0], q[1], q[2], q[3]};
}

struct pose_stamped {
  using type = geometry_msgs_msg_dds__PoseStamped_;
  static const dds_topic_descriptor_t& about() { return geometry_msgs_msg_dds__PoseStamped__desc; }
  static void read_from(const type& m, content& c) {
    read(m.header_, c);
    const auto& p = m.pose_.position_;
    c.numbers = {{p.x_, p.y_, p.z_}, list_4(m.pose_.orientation_)};
  }
  static void write(dds_entity_t writer, content c) {
    type m{};
    m.header_ = {{c.sec, 0}, c.frame.data()};
    m.pose_.position_ = {c.numbers[0][0], c.numbers[0][1], c.numbers[0][2]};
    m.pose_.orientation_ = quaternion(c.numbers[1]);
    dds_write(writer, &m);
  }
};

struct twist {
  using type = geometry_msgs_msg_dds__Twist_;
  static const dds_topic_descriptor_t& about() { return geometry_msgs_msg_dds__Twist__desc; }
  static void read_from(const type& m, content& c) { c.numbers = {list_3(m.linear_), list_3(m.angular_)}; }
  static void write(dds_entity_t writer, content c) {
    const type m{vector_3(c.numbers[0]), vector_3(c.numbers[1])};
    dds_write(writer, &m);
  }
};

geometry_msgs_msg_dds__TransformStamped_ transform(content& c, std::size_t i) {
  return {{{c.sec, 0}, c.frame.data()},
          c.words[i].data(),
          {vector_3(c.numbers[2 * i]), quaternion(c.numbers[2 * i + 1])}};
}
void read(const geometry_msgs_msg_dds__TransformStamped_& m, content& c) {
  read(m.header_, c);
  c.words.emplace_back(m.child_frame_id_);
  c.numbers.push_back(list_3(m.transform_.translation_));
  c.numbers.push_back(list_4(m.transform_.rotation_));
}
struct transform_stamped {
  using type = geometry_msgs_msg_dds__TransformStamped_;
  static const dds_topic_descriptor_t& about() { return geometry_msgs_msg_dds__TransformStamped__desc; }
  static void read_from(const type& m, content& c) { read(m, c); }
  static void write(dds_entity_t writer, content c) {
    const type m = transform(c, 0);
    dds_write(writer, &m);
  }
};
struct tf_message {
  using type = tf2_msgs_msg_dds__TFMessage_;
  static const dds_topic_descriptor_t& about() { return tf2_msgs_msg_dds__TFMessage__desc; }
  static void read_from(const type& m, content& c) {
    for (std::uint32_t i = 0; i < m.transforms_._length; ++i) read(m.transforms_._buffer[i], c);
  }
  static void write(dds_entity_t writer, content c) {
    std::vector<geometry_msgs_msg_dds__TransformStamped_> all;
    for (std::size_t i = 0; i < c.words.size(); ++i) all.push_back(transform(c, i));
    type m{};
    m.transforms_._maximum = m.transforms_._length = static_cast<std::uint32_t>(all.size());
    m.transforms_._buffer = all.data();
    dds_write(writer, &m);
  }
};

struct joint_trajectory {
  using type = trajectory_msgs_msg_dds__JointTrajectory_;
  static const dds_topic_descriptor_t& about() { return trajectory_msgs_msg_dds__JointTrajectory__desc; }
  static void read_from(const type& m, content& c) {
    read(m.header_, c);
    for (std::uint32_t i = 0; i < m.joint_names_._length; ++i)
      c.words.emplace_back(m.joint_names_._buffer[i]);
    for (std::uint32_t i = 0; i < m.points_._length; ++i) {
      const auto& p = m.points_._buffer[i];
      for (const auto& each : {list(p.positions_),
                               list(p.velocities_),
                               list(p.accelerations_),
                               list(p.effort_),
                               {p.time_from_start_.sec_ + 1e-9 * p.time_from_start_.nanosec_}})
        c.numbers.push_back(each);
    }
  }
  static void write(dds_entity_t writer, content c) {
    type m{};
    m.header_ = {{c.sec, 0}, c.frame.data()};
    std::vector<char*> names;
    for (auto& word : c.words) names.push_back(word.data());
    m.joint_names_._maximum = m.joint_names_._length = static_cast<std::uint32_t>(names.size());
    m.joint_names_._buffer = names.data();
    std::vector<trajectory_msgs_msg_dds__JointTrajectoryPoint_> points(c.numbers.size() / 5);
    for (std::size_t i = 0; i < points.size(); ++i) {
      fill(points[i].positions_, c.numbers[5 * i]);
      fill(points[i].velocities_, c.numbers[5 * i + 1]);
      fill(points[i].accelerations_, c.numbers[5 * i + 2]);
      fill(points[i].effort_, c.numbers[5 * i + 3]);
      const double time = c.numbers[5 * i + 4][0];
      points[i].time_from_start_.sec_ = static_cast<std::int32_t>(time);
      points[i].time_from_start_.nanosec_ =
          static_cast<std::uint32_t>(1e9 * (time - points[i].time_from_start_.sec_));
    }
    m.points_._maximum = m.points_._length = static_cast<std::uint32_t>(points.size());
    m.points_._buffer = points.data();
    dds_write(writer, &m);
  }
};

struct image {
  using type = sensor_msgs_msg_dds__Image_;
  static const dds_topic_descriptor_t& about() { return sensor_msgs_msg_dds__Image__desc; }
  static void read_from(const type& m, content& c) {
    read(m.header_, c);
    c.words.emplace_back(m.encoding_);
    c.numbers = {{double(m.height_), double(m.width_), double(m.is_bigendian_), double(m.step_)},
                 list(m.data_)};
  }
  static void write(dds_entity_t writer, content c) {
    type m{};
    m.header_ = {{c.sec, 0}, c.frame.data()};
    const auto& about = c.numbers[0];
    m.height_ = static_cast<std::uint32_t>(about[0]);
    m.width_ = static_cast<std::uint32_t>(about[1]);
    m.encoding_ = c.words[0].data();
    m.is_bigendian_ = static_cast<std::uint8_t>(about[2]);
    m.step_ = static_cast<std::uint32_t>(about[3]);
    std::vector<std::uint8_t> bytes;
    for (const double byte : c.numbers[1]) bytes.push_back(static_cast<std::uint8_t>(byte));
    m.data_._maximum = m.data_._length = static_cast<std::uint32_t>(bytes.size());
    m.data_._buffer = bytes.data();
    dds_write(writer, &m);
  }
};

template <class F>
void with_type(const std::string& name, F f) {
  if (name == "JointState") f(joint_state{});
  if (name == "Imu") f(imu{});
  if (name == "WrenchStamped") f(wrench_stamped{});
  if (name == "TwistStamped") f(twist_stamped{});
  if (name == "Float64MultiArray") f(float64_multi_array{});
  if (name == "PoseStamped") f(pose_stamped{});
  if (name == "Twist") f(twist{});
  if (name == "TransformStamped") f(transform_stamped{});
  if (name == "TFMessage") f(tf_message{});
  if (name == "JointTrajectory") f(joint_trajectory{});
  if (name == "Image") f(image{});
}

class idlc_peer {
public:
  idlc_peer(std::uint32_t domain, const std::string& type, const std::string& topic, const std::string& what)
      : name(type) {
    dds_create_domain(domain, on_this_machine);
    const dds_entity_t in = dds_create_participant(domain, nullptr, nullptr);
    dds_qos_t* const q = dds_create_qos();
    if (topic.ends_with("_static")) dds_qset_durability(q, DDS_DURABILITY_TRANSIENT_LOCAL);
    dds_qset_reliability(q, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    with_type(name, [&](auto t) {
      const dds_entity_t on = dds_create_topic(in, &t.about(), topic.c_str(), nullptr, nullptr);
      end = what == "hear" ? dds_create_reader(in, on, q, nullptr) : dds_create_writer(in, on, q, nullptr);
    });
    dds_delete_qos(q);
  }
  bool hear(content& c) const {
    bool has = false;
    with_type(name, [&](auto t) {
      void* message[1] = {nullptr};
      dds_sample_info_t about;
      const int count = dds_take(end, message, &about, 1, 1);
      if (count > 0 && about.valid_data) {
        t.read_from(*static_cast<typename decltype(t)::type*>(message[0]), c);
        c.words.push_back(user_data(about.publication_handle));
        has = true;
      }
      if (count > 0) dds_return_loan(end, message, count);
    });
    return has;
  }
  void tell(const content& c, int) const {
    with_type(name, [&](auto t) { t.write(end, c); });
  }

private:
  std::string user_data(dds_instance_handle_t writer) const {
    std::string text;
    dds_builtintopic_endpoint_t* const found = dds_get_matched_publication_data(end, writer);
    if (!found) return text;
    void* bytes = nullptr;
    std::size_t size = 0;
    if (dds_qget_userdata(found->qos, &bytes, &size) && bytes) text.assign(static_cast<char*>(bytes), size);
    dds_free(bytes);
    dds_builtintopic_free_endpoint(found);
    return text;
  }

  std::string name;
  dds_entity_t end = 0;
};

}  // namespace

int main(int count, char** arguments) { return run_peer<idlc_peer>(count, arguments); }

// A peer of another vendor: eProsima Fast DDS, on which rmw_fastrtps stands. Its types are written here by
// hand over Fast CDR.
#include <fastcdr/Cdr.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include <cstring>
#include <functional>
#include <memory>
#include <random>

#include "peer.hpp"

namespace {

using namespace eprosima::fastdds::dds;
using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;
using eprosima::fastrtps::rtps::InstanceHandle_t;
using eprosima::fastrtps::rtps::SerializedPayload_t;

struct message : content {
  int lie = 0;  // 0: none, or big_endian
};

class any_type : public TopicDataType {
public:
  explicit any_type(const std::string& type) : name(type) {
    const std::string package = type == "JointState" || type == "Imu" || type == "Image" ? "sensor_msgs"
                                : type == "Float64MultiArray"                            ? "std_msgs"
                                : type == "JointTrajectory"                              ? "trajectory_msgs"
                                : type == "TFMessage"                                    ? "tf2_msgs"
                                                                                         : "geometry_msgs";
    setName((package + "::msg::dds_::" + type + "_").c_str());
    m_typeSize = 4096;
    m_isGetKeyDefined = false;
  }

  bool serialize(void* from, SerializedPayload_t* to) override {
    const message& m = *static_cast<message*>(from);
    FastBuffer buffer(reinterpret_cast<char*>(to->data), to->max_size);
    const bool is_big = m.lie == big_endian;
    Cdr c(buffer, is_big ? Cdr::BIG_ENDIANNESS : Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
    to->encapsulation = is_big ? CDR_BE : CDR_LE;
    c.serialize_encapsulation();
    write(c, m);
    to->length = static_cast<std::uint32_t>(c.getSerializedDataLength());
    if (m.lie > 0) spoil(*to, m.lie);
    return true;
  }
  bool deserialize(SerializedPayload_t* from, void* to) override {
    FastBuffer buffer(reinterpret_cast<char*>(from->data), from->length);
    Cdr c(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
    c.read_encapsulation();
    read(c, *static_cast<message*>(to));
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void*) override {
    return [] { return 4096u; };
  }
  void* createData() override { return new message; }
  void deleteData(void* data) override { delete static_cast<message*>(data); }
  bool getKey(void*, InstanceHandle_t*, bool) override { return false; }

private:
  void write(Cdr& c, const message& m) const {
    if (name == "Float64MultiArray") {  // with the layout that names the axes
      c << std::uint32_t{1} << std::string("hip,knee") << std::uint32_t{2} << std::uint32_t{2}
        << std::uint32_t{0} << m.numbers[1];
      return;
    }
    if (name == "TFMessage") {
      c << static_cast<std::uint32_t>(m.words.size());
      for (std::size_t i = 0; i < m.words.size(); ++i) {
        c << m.sec << std::uint32_t{0} << m.frame << m.words[i];
        for (const std::size_t k : {2 * i, 2 * i + 1})
          c.serializeArray(m.numbers[k].data(), m.numbers[k].size());
      }
      return;
    }
    if (name != "Twist") c << m.sec << std::uint32_t{0} << m.frame;
    if (name == "JointState") {
      c << m.words << m.numbers[0] << m.numbers[1] << m.numbers[2];
    } else if (name == "JointTrajectory") {
      c << m.words << static_cast<std::uint32_t>(m.numbers.size() / 5);
      for (std::size_t i = 0; i < m.numbers.size(); i += 5) {
        for (std::size_t k = 0; k < 4; ++k) c << m.numbers[i + k];
        const double time = m.numbers[i + 4][0];
        c << static_cast<std::int32_t>(time)
          << static_cast<std::uint32_t>(1e9 * (time - static_cast<std::int32_t>(time)));
      }
    } else if (name == "Image") {
      const auto& about = m.numbers[0];
      c << static_cast<std::uint32_t>(about[0]) << static_cast<std::uint32_t>(about[1]) << m.words[0]
        << static_cast<std::uint8_t>(about[2]) << static_cast<std::uint32_t>(about[3]);
      std::vector<std::uint8_t> bytes;
      for (const double byte : m.numbers[1]) bytes.push_back(static_cast<std::uint8_t>(byte));
      c << bytes;
    } else {
      if (name == "TransformStamped") c << m.words[0];
      for (const auto& field : m.numbers) c.serializeArray(field.data(), field.size());
    }
  }
  void read(Cdr& c, message& m) const {
    if (name == "Float64MultiArray") {
      std::uint32_t count = 0, size = 0, stride = 0, offset = 0;
      std::string label;
      std::vector<double> data;
      c >> count;
      if (count != 1) return;
      c >> label >> size >> stride >> offset >> data;
      m.words = {label};
      m.numbers = {{double(offset)}, {double(size), double(stride)}, data};
      return;
    }
    std::uint32_t nanosec = 0;
    if (name == "TFMessage") {
      std::uint32_t count = 0;
      c >> count;
      if (count != 1) return;
    }
    if (name != "Twist") c >> m.sec >> nanosec >> m.frame;
    if (name == "TFMessage" || name == "TransformStamped") {
      std::string child;
      c >> child;
      m.words = {child};
    }
    if (name == "JointTrajectory") {
      std::uint32_t count = 0;
      c >> m.words >> count;
      for (std::uint32_t i = 0; i < count; ++i) {
        std::vector<double> fields[4];
        std::int32_t sec = 0;
        c >> fields[0] >> fields[1] >> fields[2] >> fields[3] >> sec >> nanosec;
        for (const auto& field : fields) m.numbers.push_back(field);
        m.numbers.push_back({sec + 1e-9 * nanosec});
      }
      return;
    }
    if (name == "Image") {
      std::uint32_t height = 0, width = 0, step = 0;
      std::string encoding;
      std::uint8_t is_big = 0;
      std::vector<std::uint8_t> bytes;
      c >> height >> width >> encoding >> is_big >> step >> bytes;
      m.words = {encoding};
      m.numbers = {{double(height), double(width), double(is_big), double(step)},
                   {bytes.begin(), bytes.end()}};
      return;
    }
    if (name == "JointState") {
      m.numbers.resize(3);
      c >> m.words >> m.numbers[0] >> m.numbers[1] >> m.numbers[2];
      return;
    }
    for (const auto& field : told(name == "TFMessage" ? "TransformStamped" : name).numbers) {
      std::vector<double> some(field.size());
      c.deserializeArray(some.data(), some.size());
      m.numbers.push_back(some);
    }
  }

  // Random bytes, a random length, or a length of a sequence that can't be; always the same of one number.
  static void spoil(SerializedPayload_t& p, int lie) {
    std::mt19937 random(static_cast<unsigned>(lie));
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random()) % n; };
    if (lie % 3 == 0) {
      p.length = 4 + below(p.max_size - 4);
    } else if (lie % 3 == 1) {
      const std::uint32_t huge = lie % 2 == 0 ? 0xffffffffu : 0x10000000u;
      std::memcpy(p.data + 4 + 4 * below((p.length - 8) / 4), &huge, sizeof huge);
    } else {
      for (int i = 0; i < 8; ++i) p.data[4 + below(p.length - 4)] = static_cast<std::uint8_t>(random());
    }
  }

  std::string name;
};

class fast_dds_peer {
public:
  fast_dds_peer(std::uint32_t domain,
                const std::string& type,
                const std::string& topic,
                const std::string& what) {
    DomainParticipantQos own = PARTICIPANT_QOS_DEFAULT;
    const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    udp->interfaceWhiteList.push_back("127.0.0.1");
    own.transport().use_builtin_transports = false;
    own.transport().user_transports.push_back(udp);
    for (std::uint32_t i = 0; i < 32; ++i) {
      eprosima::fastrtps::rtps::Locator_t there;
      eprosima::fastrtps::rtps::IPLocator::setIPv4(there, "127.0.0.1");
      there.port = 7410 + 250 * domain + 2 * i;
      own.wire_protocol().builtin.initialPeersList.push_back(there);
    }
    auto* const in = DomainParticipantFactory::get_instance()->create_participant(domain, own);
    TypeSupport support(new any_type(type));
    support.register_type(in);
    auto* const on = in->create_topic(topic, support.get_type_name(), TOPIC_QOS_DEFAULT);
    const auto kept = topic.ends_with("_static") ? TRANSIENT_LOCAL_DURABILITY_QOS : VOLATILE_DURABILITY_QOS;
    if (what == "hear") {
      DataReaderQos q = DATAREADER_QOS_DEFAULT;
      q.durability().kind = kept;
      q.reliability().kind = RELIABLE_RELIABILITY_QOS;
      reader = in->create_subscriber(SUBSCRIBER_QOS_DEFAULT)->create_datareader(on, q);
    } else {
      DataWriterQos q = DATAWRITER_QOS_DEFAULT;
      q.durability().kind = kept;
      q.reliability().kind = RELIABLE_RELIABILITY_QOS;
      writer = in->create_publisher(PUBLISHER_QOS_DEFAULT)->create_datawriter(on, q);
    }
  }
  bool hear(content& c) const {
    message m;
    SampleInfo about;
    if (reader->take_next_sample(&m, &about) != ReturnCode_t::RETCODE_OK || !about.valid_data) return false;
    c = m;
    return true;
  }
  void tell(const content& c, int lie) const {
    message m;
    static_cast<content&>(m) = c;
    m.lie = lie;
    writer->write(&m);
  }

private:
  DataReader* reader = nullptr;
  DataWriter* writer = nullptr;
};

}  // namespace

int main(int count, char** arguments) { return run_peer<fast_dds_peer>(count, arguments); }

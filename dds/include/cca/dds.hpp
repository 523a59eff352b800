// Environments in several processes, on one machine or on several, over Cyclone DDS.
//
//   cca::deployed<split> d(cca::only{"robot"}, cca::dds::domain(7));
//   cca::deployed<split> d(cca::only{"robot"},
//       cca::dds::domain(7, cca::dds::network::between("192.168.1.10", {"192.168.1.11"})));
//
// And nodes that exchange samples with programs that share no code with cca: `cca::dds::publisher`,
// `command_publisher`, `subscriber`, for any space, and `cca::idl`, which gives its type.
//
// Target cca::dds. CYCLONEDDS_URI configures the network; without it all stays on this machine. Pages:
// docs/transports.md, docs/dds.md.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <cca/deployment.hpp>
#include <cca/dds/deployment/replicated_exchange.hpp>
#include <cca/dds/idl.hpp>
#include <cca/dds/domain/network.hpp>
#include <cca/dds/publisher.hpp>
#include <cca/dds/subscriber.hpp>

namespace cca::dds {

class domain {
public:
  // All processes of a deployment use one number, 0 to 230. Deployments that share a domain need a partition
  // each.
  explicit domain(std::uint32_t number, std::string partition = "cca", network by = {})
      : id(number),
        part(std::move(partition)),
        over(std::move(by)),
        counted(std::make_shared<detail::refusals>()) {}
  domain(std::uint32_t number, network by) : domain(number, "cca", std::move(by)) {}

  template <class D>
  auto open(const cca::detail::environments_here<D>& here) const {
    return std::make_shared<detail::replicated_exchange<D>>(id, part, over, here, counted);
  }

  // What was refused so far by this process, by all deployments that were made with this object. Any thread
  // may ask.
  std::int64_t refused_messages() const { return counted->count(); }
  std::vector<refusal> refusals() const { return counted->list(); }
  // Samples that had a number which is not finite. They are passed on, as in one process.
  std::int64_t not_finite() const { return counted->count_not_finite(); }

private:
  std::uint32_t id;
  std::string part;
  network over;
  std::shared_ptr<detail::refusals> counted;
};

}  // namespace cca::dds

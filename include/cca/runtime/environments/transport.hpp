// What `cca::deployed` asks of a transport: that it makes the environments of several processes one
// deployment. cca::shared_memory and cca::dds::domain are models; docs/transports.md shows one of your own.
//
//   struct by_cable {
//     template <class D>
//     std::shared_ptr<cabled<D>> open(const cca::environments_here<D>& here) const;
//   };
//   template <class D>
//   struct cabled : cca::peers {            // the medium
//     cca::exchange<D>* exchanged();
//     bool is_gone(int environment) const override;
//   };
//
// Errors: deployment.no_transport; `cca::refused`, thrown by `open`, where this process must not take part.
// tests/laws/transport_laws.hpp says what a transport has to keep.
#pragma once

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/runtime/environments/exchange/exchange.hpp>
#include <cca/runtime/environments/exchange/peers.hpp>

namespace cca {

// here[e]: this process runs environment number e of the deployment, in the order of its declaration.
template <class D>
using environments_here = detail::environments_here<D>;

// All numbers and samples that the environments of a deployment tell each other. Each has one writer. Either
// all processes see one block, or each has its own and the transport copies what others write.
template <class D>
using exchange = detail::exchange<D>;

// What a medium knows of the other processes: which of them are gone.
using peers = detail::peers;

namespace detail {

template <class T, class D>
using opened_by =
    decltype(std::declval<const T&>().template open<D>(std::declval<const environments_here<D>&>()));

template <class T, class D> concept Opens = requires {
  typename opened_by<T, D>::element_type;
} && std::same_as<opened_by<T, D>, std::shared_ptr<typename opened_by<T, D>::element_type>>;

template <class Medium, class D> concept Exchanges = requires(Medium& medium) {
  { medium.exchanged() } -> std::same_as<exchange<D>*>;
};

}  // namespace detail

// The medium lives as long as the `deployed`, and what `exchanged()` points to as long as the medium.
template <class Medium, class D> concept TransportMedium =
    std::derived_from<Medium, peers> && detail::Exchanges<Medium, D>;

template <class T, class D> concept Transport =
    detail::Opens<T, D> && TransportMedium<typename detail::opened_by<T, D>::element_type, D>;

namespace detail {

struct no_argument {};
template <class D, class T>
struct no_transport {
  static constexpr void tell(text& m) {
    m << "deployment.no_transport: the second argument of cca::deployed<" << type_name<D>();
    if (std::is_same_v<T, no_argument>) m << "> is missing";
    else m << ">, `" << type_name<T>() << "`, is no transport";
    m << ": write cca::shared_memory(`/name`), cca::dds::domain(number), or an object that meets the concept "
         "cca::Transport (docs/transports.md: An own transport)";
  }
};
// Its first argument.
template <class D>
struct no_deployment {
  static constexpr void tell(text& m) {
    m << "cca::deployed: `" << type_name<D>() << "` is no deployment: derive one from `cca::deployment<"
      << type_name<D>() << ", cca::environment<...>, ...>`, or run the graph by `cca::controller<"
      << type_name<D>() << ">`";
  }
};

}  // namespace detail

}  // namespace cca

// The files of a learned policy. The first byte says which one the rest is: the network, deploy.yaml or the
// map. It is refused, or a network has a text and finite weights. Beside the network lies a file of 64 kB.
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "../../tools/policy/writing.hpp"
#include "must.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    cca_policy::statements said;
    cca_policy::complaints wrong;
    if (data[0] % 3 == 0) {
      const cca_policy::onnx_model model =
          cca_policy::read_onnx(text, [](const std::string&) { return std::string(1 << 16, '<'); });
      cca_policy::read_metadata(model, "walk.onnx", said, wrong);
      const cca_policy::network_options how{};
      cca_policy::imported p;
      p.net = cca_policy::lowering(model, how).run();
      fuzz::must(!p.net.code.empty() && p.net.inputs > 0 && p.net.outputs > 0);
      for (const double w : p.net.weights) fuzz::must(std::isfinite(w));
      fuzz::must(!cca_policy::header(p).text().empty() && !cca_policy::weights_file(p).empty());
    } else if (data[0] % 3 == 1) {
      cca_policy::deploy_reader(text, "deploy.yaml", said, wrong);
    } else {
      cca_policy::map_reader(text, "map.toml", said, wrong);
    }
    cca_policy::resolver(said, wrong).all("walk");
  } catch (const cca::refused& e) { fuzz::must(!std::string_view(e.what()).empty()); }
  return 0;
}

// From the nodes of an ONNX file to the text of a function and its weights. Shapes are fixed: a batch is one.
#pragma once

#include <string>
#include <vector>

namespace cca_policy {

struct network {
  std::string observations, actions;  // names in the file
  int inputs = 0, outputs = 0, memory = 0;
  bool begins_with_normaliser = false;
  bool is_double = false;              // a tensor of the file is
  std::vector<std::string> operators;  // as the file names them, in its order
  std::string code;                    // the body of `answer`
  std::vector<double> weights;
};

struct network_options {
  std::string observations, actions;                        // empty: the only ones
  std::vector<std::pair<std::string, std::string>> memory;  // input and output beside those of X_in, X_out
  std::vector<double> mean, deviation;                      // of a normaliser that the file lacks
};

}  // namespace cca_policy

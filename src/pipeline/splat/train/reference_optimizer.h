// The optimiser (optimizer.h) as scalar C++ in double, slow, for tests.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "pipeline/splat/train/optimizer_options.h"

namespace macula::splat {

// In all arrays, component k of splat i is at k * count + i.
class ReferenceOptimizer {
  public:
    ReferenceOptimizer(std::size_t count, int shDegree, const OptimizerOptions& options);

    void step(std::span<double> parameters, std::span<const double> gradients,
              std::span<const std::uint32_t> visible);

    std::uint64_t skipped() const { return skipped_; }
    const std::vector<std::uint32_t>& steps() const { return steps_; }

  private:
    // How far a parameter moves, in units of its learning rate.
    double learn(std::size_t component, std::size_t splat, double gradient);
    glm::dmat3 rotationOf(std::span<const double> parameters, std::size_t splat) const;

    OptimizerOptions options_;
    int shDegree_;
    std::vector<std::uint32_t> steps_;
    std::vector<double> first_;
    std::vector<double> second_;
    std::uint64_t stepsDone_ = 0;
    std::uint64_t skipped_ = 0;
};

}  // namespace macula::splat

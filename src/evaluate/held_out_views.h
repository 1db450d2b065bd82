// Traces views that no model learns from, and compares models with them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "base/camera.h"
#include "base/progress.h"
#include "base/result.h"
#include "evaluate/view_scores.h"
#include "live/device/scene_on_device.h"
#include "pipeline/hybrid/views/pose_sampling.h"
#include "pipeline/hybrid/views/truth_pictures.h"
#include "pipeline/splat/model/splats.h"

namespace macula::evaluate {

struct Comparison {
    std::vector<ViewScores> scores;  // by view
    double drawMs = 0.0;             // of a picture of the model, median, with waiting
    // By view, as displayed: truth on the left, model on the right; RGBA, opaque.
    std::vector<std::vector<std::uint8_t>> pictures;
};

class HeldOutViews {
  public:
    // Traces truthPictures of `count` views of `poses`, such as groundTruth; if there are fewer than
    // poses.count, some from each distance.
    static Result<HeldOutViews> trace(std::shared_ptr<gpu::Device> device, live::SceneOnDevice& scene,
                                      const hybrid::PoseSampling& poses, std::size_t count,
                                      const hybrid::TruthOptions& options, const std::filesystem::path& cache,
                                      Progress& progress);

    // The model must be valid. Adds a stage to `progress`, with a step for each view.
    Result<Comparison> compare(const splat::Splats& model, Progress& progress) const;

    const std::vector<hybrid::TruthPicture>& pictures() const { return truth_; }
    std::vector<Camera> cameras() const;
    double seconds() const { return seconds_; }  // time for tracing the views
    std::size_t fromCache() const;               // views found completely in the cache
    std::size_t givenUp() const { return givenUp_; }

  private:
    explicit HeldOutViews(std::shared_ptr<gpu::Device> device) : device_(std::move(device)) {}

    std::shared_ptr<gpu::Device> device_;
    std::vector<hybrid::TruthPicture> truth_;
    glm::ivec2 sizePx_{0};
    double seconds_ = 0.0;
    std::size_t givenUp_ = 0;
};

}  // namespace macula::evaluate

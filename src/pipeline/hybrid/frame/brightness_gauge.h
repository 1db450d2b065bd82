// How bright a model is beside what is traced, so that one can take the other's place on a screen.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/camera.h"
#include "base/frames.h"
#include "base/result.h"
#include "pipeline/hybrid/views/traced_view.h"
#include "pipeline/splat/draw/model_painter.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// What is traced over what is drawn: the ratio of their mean luminances (Rec. 709, linear) over the pixels in
// which both cover more than half. 1 where these are too few to tell, or nothing shines in them; from 1/2 to
// 2, because what is farther off is wrong in more than its brightness. Pictures in pairs of the same size;
// what is not finite is left out.
double brightnessGain(std::span<const std::vector<glm::vec4>> traced,
                      std::span<const std::vector<glm::vec4>> drawn);

// Six small pictures, from each side of the patient, of a scene in which all that is seen lies in a box. They
// have few samples, whose noise is gone in the mean over all pixels.
class BrightnessGauge {
  public:
    explicit BrightnessGauge(const Box& seenMm);

    bool isWhole() const { return pictures_.size() == cameras_.size(); }
    // The next ones; `keepGoing` is asked between dispatches of some 40 ms, and the next call goes on there.
    // The tracer is of the scene, and is left with other settings and another view; `settings` are those of
    // what is shown.
    Result<void> traceSome(trace::PathTracer& tracer, const trace::Settings& settings,
                           const std::function<bool()>& keepGoing);

    // So far. Denoised a little: to learn from, too.
    const std::vector<TracedView>& pictures() const { return pictures_; }

    // brightnessGain of what `painter` has, whose origin that is. When it is whole. Waits.
    Result<double> gainOf(splat::ModelPainter& painter, const glm::dvec3& originMm) const;

  private:
    std::vector<Camera> cameras_;
    std::vector<TracedView> pictures_;  // in their order
    bool hasBegun_ = false;             // the next one
};

}  // namespace macula::hybrid

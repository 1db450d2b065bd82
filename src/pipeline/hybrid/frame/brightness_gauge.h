// How much brighter traced pictures are than those of a model, so that one can replace the other on a screen.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/camera.h"
#include "base/frames.h"
#include "base/result.h"
#include "pipeline/hybrid/light/traced_view.h"
#include "pipeline/splat/draw/model_painter.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::hybrid {

// The mean luminance (Rec. 709, linear) of the traced pictures over that of the drawn ones, over the pixels
// in which both cover more than half. 1 if these are too few or all black. Limited to 1/2 to 2, because a
// model that is farther off has more than its brightness wrong. Pictures come in pairs of the same size;
// pixels that are not finite do not count.
double brightnessGain(std::span<const std::vector<glm::vec4>> traced,
                      std::span<const std::vector<glm::vec4>> drawn);

// Traces six small pictures, one from each side of the patient, of a scene whose visible part lies in a box.
// They have few samples: the mean over all pixels has hardly any noise.
class BrightnessGauge {
  public:
    explicit BrightnessGauge(const Box& seenMm);

    bool isWhole() const { return pictures_.size() == cameras_.size(); }
    // Traces the next pictures. Asks `keepGoing` between dispatches of some 40 ms; the next call continues
    // there. The tracer must have the scene, and is left with other settings and another view; `settings` are
    // those of the picture on screen.
    Result<void> traceSome(trace::PathTracer& tracer, const trace::Settings& settings,
                           const std::function<bool()>& keepGoing);

    // The pictures traced so far, denoised a little, so that a model can learn from them too.
    const std::vector<TracedView>& pictures() const { return pictures_; }

    // brightnessGain of the model that `painter` draws, whose origin is `originMm`. Only when isWhole().
    // Waits for the device.
    Result<double> gainOf(splat::ModelPainter& painter, const glm::dvec3& originMm) const;

  private:
    std::vector<Camera> cameras_;
    std::vector<TracedView> pictures_;  // by camera
    bool hasBegun_ = false;             // the tracer has begun the next picture
};

}  // namespace macula::hybrid

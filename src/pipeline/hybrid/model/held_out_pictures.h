// The pictures that judge a model (held_out.h), and its error in each.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/views/training_views.h"
#include "pipeline/splat/train/loss_options.h"
#include "pipeline/splat/train/trainer.h"
#include "pipeline/splat/train/training_view.h"

namespace macula::hybrid {

// Mean absolute difference to a held-out picture, over its coverage.
struct HeldOutErrors {
    double trained = 0.0;  // of the model, when it was last judged
    double shown = 0.0;
    double best = 0.0;    // of the best one that was shown
    double coarse = 0.0;  // of the picture itself at a coarse resolution
};

struct HeldOutPicture {
    std::shared_ptr<const splat::TrainingView> picture;
    double coverage = 0.0;
    HeldOutErrors errors;
};

// The splats that frames show, and the best that were shown; one object if these are the same.
struct ShownOfModel {
    const splat::Splats& now;
    const splat::Splats& best;
};

// Used by one thread at a time, the one that uses the device.
class HeldOutPictures {
  public:
    bool empty() const { return held_.empty(); }
    std::size_t size() const { return held_.size(); }
    bool canJudge() const;  // has kLeastHeldOut pictures
    auto begin() const { return held_.begin(); }
    auto end() const { return held_.end(); }

    // Holds these pictures out from now on, and compares the trained model and the shown splats with them.
    // Errors of shown splats are measured, because the trained model may have become worse since. `options`
    // are those of its training. Fails as Trainer::create and differenceTo do, and then nothing has changed.
    Result<void> take(std::span<const std::shared_ptr<const splat::TrainingView>> pictures,
                      splat::Trainer& trainer, const std::shared_ptr<gpu::Device>& device,
                      const splat::TrainerOptions& options, const ShownOfModel& shown);

    // Begins a comparison of the model with all pictures, one in each judgeNext(). The model must not change
    // meanwhile.
    void beginJudging() { judged_ = 0; }
    bool isJudged() const { return judged_ >= held_.size(); }
    Result<void> judgeNext(splat::Trainer& trainer);
    // Frames now show the model as it was judged.
    void judgedIsShown(bool isBest);

    HeldOutErrors meanErrors() const;  // zeros if no pictures are held out
    double pixels() const;             // of all pictures together
    // The angle around `centre` between the eye of `view` and the nearest held-out one; 180 without any.
    double degreesBeside(const splat::RasterView& view, const glm::dvec3& centre) const;
    // Whether a held-out picture was seen from there (isSamePose).
    bool hasFrom(const splat::RasterView& view, double radiusMm, const AdmissionOptions& options) const;

  private:
    std::vector<HeldOutPicture> held_;
    std::size_t judged_ = 0;  // in this round of judging
};

// The mean coverage by which the difference to a view is divided. It has a lower limit, so that a view that
// shows hardly anything has no huge error.
double judgedCoverage(const splat::TrainingView& view);

// The coarse picture that a person sees in motion while there is no model, which must be better than this:
// the view as a picture of `lines` lines that is scaled up: nearest-neighbour decimation, which keeps the
// noise of each pixel, and bilinear magnification to the size of the view. A view with no more lines stays as
// it is. A pixel interpolated from unknown (not finite) ones is unknown too.
splat::TrainingView coarselyShown(const splat::TrainingView& view, int lines);

// The mean absolute difference between both, as Trainer::differenceTo measures that of a model. Unknown
// pixels count as equal.
double coarseDifference(const splat::TrainingView& view, int lines, const splat::LossOptions& loss);

}  // namespace macula::hybrid

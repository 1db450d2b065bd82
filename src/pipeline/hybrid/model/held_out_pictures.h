// The pictures that judge a model (held_out.h), and how far it was from each.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/views/training_views.h"
#include "pipeline/splat/train/trainer.h"

namespace macula::hybrid {

// Mean absolute difference to a held-out picture, over its coverage.
struct HeldOutErrors {
    double trained = 0.0;  // of the model, when it was last judged
    double shown = 0.0;
    double best = 0.0;    // of the best that was shown
    double coarse = 0.0;  // of the picture itself, as a coarse one would show it
};

struct HeldOutPicture {
    std::shared_ptr<const splat::TrainingView> picture;
    double coverage = 0.0;
    HeldOutErrors errors;
};

// What was shown of a model; the same object where it is the best that was.
struct ShownOfModel {
    const splat::Splats& now;
    const splat::Splats& best;
};

// Used by one thread at a time, the one that uses the device.
class HeldOutPictures {
  public:
    bool empty() const { return held_.empty(); }
    std::size_t size() const { return held_.size(); }
    bool canJudge() const;  // kLeastHeldOut
    auto begin() const { return held_.begin(); }
    auto end() const { return held_.end(); }

    // Compares the model and what was shown of it with these, which are held out from now on. The trained
    // model must not stand in for what was shown: it may have become worse since. `options` are those of its
    // training. Fails as Trainer::create and differenceTo, and then nothing has changed.
    Result<void> take(std::span<const std::shared_ptr<const splat::TrainingView>> pictures,
                      splat::Trainer& trainer, const std::shared_ptr<gpu::Device>& device,
                      const splat::TrainerOptions& options, const ShownOfModel& shown);

    // Compares the model with all of them, one for each judgeNext(); it has to stay as it is meanwhile.
    void beginJudging() { judged_ = 0; }
    bool isJudged() const { return judged_ >= held_.size(); }
    Result<void> judgeNext(splat::Trainer& trainer);
    // The model is shown as it was judged.
    void judgedIsShown(bool isBest);

    HeldOutErrors meanErrors() const;  // zeros where nothing is held out
    double pixels() const;             // of all of them
    // From so many degrees beside the nearest of them it is seen, around `centre`; 180 where there is none.
    double degreesBeside(const splat::RasterView& view, const glm::dvec3& centre) const;
    // Whether one is from there (isSamePose).
    bool hasFrom(const splat::RasterView& view, double radiusMm, const AdmissionOptions& options) const;

  private:
    std::vector<HeldOutPicture> held_;
    std::size_t judged_ = 0;  // in this round of judging
};

// The mean coverage that the difference to a view is divided by: no less than a small part, because the error
// of a view that shows hardly anything is not that of its few pixels.
double judgedCoverage(const splat::TrainingView& view);

}  // namespace macula::hybrid

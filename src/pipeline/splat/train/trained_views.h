// The views of a trainer (trainer.h): the loss of each when it was last drawn, and which is drawn next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "pipeline/splat/train/picture_pyramid.h"
#include "pipeline/splat/train/training_view.h"

namespace macula::splat {

struct TrainedView {
    std::optional<PicturePyramid> pictures;  // empty: not on the device
    std::shared_ptr<const TrainingView> given;
    double loss = -1.0;  // when it was last drawn; below 0: never drawn
    double l1 = 0.0;
    bool hasNoRoom = false;  // left out of training, see Trainer::step
};

// Neither a stand-in nor an outline.
inline bool isPicture(const TrainingView& view) {
    return view.kind == ViewKind::picture;
}

class TrainedViews {
  public:
    std::size_t size() const { return views_.size(); }
    const TrainedView& operator[](std::size_t index) const { return views_[index]; }
    TrainedView& operator[](std::size_t index) { return views_[index]; }
    TrainedView& last() { return views_.back(); }
    auto begin() const { return views_.begin(); }
    auto end() const { return views_.end(); }

    void add(TrainedView view) { views_.push_back(std::move(view)); }
    void forgetStandIns();
    // Views that had no room take part again.
    void tryAllAgain();

    // Which view to draw in the step after `steps` steps; nothing when none has room. Depends only on its
    // arguments and the views.
    std::optional<std::size_t> next(std::uint32_t seed, std::uint64_t steps) const;

    // Means over views with colours, each as it was when last drawn: see TrainingReport.
    struct Means {
        double loss = 0.0;
        double l1 = 0.0;
    };
    Means means() const;

  private:
    std::vector<TrainedView> views_;
};

}  // namespace macula::splat

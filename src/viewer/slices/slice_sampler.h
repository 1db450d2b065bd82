// Makes the picture of a slice, away from the UI thread.
#pragma once

#include <QImage>
#include <QString>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "app/frame/latest.h"
#include "base/volume.h"
#include "slices/sampled_slice.h"
#include "slices/segment_picture.h"
#include "slices/slice_plane.h"

namespace macula::viewer {

struct SliceWish {
    std::uint64_t study = 0;  // counted by who asks
    std::shared_ptr<const Volume> volume;
    slices::SliceFrame frame;
    slices::Slab slab;
    DisplayWindow window;
    bool isInverted = false;
    std::shared_ptr<const slices::ShownSegments> segments = {};  // over it; null: none
    // What the picture is shown with: handed through.
    QString positionText;
    bool isInterpolated = false;  // no image was taken there
    double pixelRatio = 1.0;
    glm::dvec3 crosshairMm{0.0};

    bool operator==(const SliceWish&) const = default;
};

struct SlicePicture {
    SliceWish of;
    QImage grey;           // of the frame's size; null when there was no memory for it
    QImage segments = {};  // over it; null where none is seen
};

// One wish at a time on a thread of its own; of those that come meanwhile the newest is next. Values are
// sampled again only where they are others: a window is a matter of grey.
class SliceSampler {
  public:
    // `made` is called on the thread of this, once for each wish that is not replaced or given up.
    explicit SliceSampler(std::function<void(SlicePicture)> made);
    SliceSampler(const SliceSampler&) = delete;
    SliceSampler& operator=(const SliceSampler&) = delete;
    ~SliceSampler();  // gives up what it does

    // Any wish of an earlier study is given up. Without a volume it only lets go of the one before.
    void publish(SliceWish wish);

  private:
    void run();
    SlicePicture make(const SliceWish& wish);
    void paintSegments(const SliceWish& wish);  // keeps them

    struct Sampled {
        std::shared_ptr<const Volume> volume;
        slices::SliceFrame frame;
        slices::Slab slab;
        slices::SampledSlice slice;
    };

    std::function<void(SlicePicture)> made_;
    app::Latest<SliceWish> wishes_;
    std::atomic<std::uint64_t> study_{0};
    std::atomic<bool> ends_{false};
    std::optional<Sampled> last_;  // of the thread, as the two below
    SliceWish painted_;            // the wish that `segments_` are of
    QImage segments_;
    std::jthread thread_;  // the last: it uses the rest
};

}  // namespace macula::viewer

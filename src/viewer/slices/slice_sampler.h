// Makes the picture of a slice, away from the UI thread.
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "base/volume.h"
#include "live/frame/latest.h"
#include "slices/colour_table.h"
#include "slices/sampled_slice.h"
#include "slices/segment_picture.h"
#include "slices/slice_plane.h"

namespace macula::viewer {

// Whose voxels are in a picture.
enum class SliceShows {
    study,
    second,        // the second volume, at the same place
    secondByHand,  // the same, and nobody knows where it is in the study
};

// A second volume in colours over the picture.
struct SliceOver {
    std::shared_ptr<const Volume> volume;
    glm::dmat4 volumeFromPane{1.0};
    DisplayWindow window;
    bool isInverted = false;
    slices::ColourTable colours = slices::ColourTable::hotIron;
    double opacity = 1.0;

    bool operator==(const SliceOver&) const = default;
};

struct SliceWish {
    std::uint64_t study = 0;  // counted by who asks
    std::shared_ptr<const Volume> volume;
    slices::SliceFrame frame;  // where the pane is, in the world of the study
    slices::Slab slab;
    DisplayWindow window;
    bool isInverted = false;
    std::shared_ptr<const slices::ShownSegments> segments = {};  // over it; null: none
    // What the picture is shown with: handed through.
    QString positionText;
    bool isInterpolated = false;  // no image was taken there
    bool isLowBright = false;     // the display of the images shows low values white
    double pixelRatio = 1.0;
    glm::dvec3 crosshairMm{0.0};
    // Of a second volume, if there is one.
    glm::dmat4 volumeFromPane{1.0};  // rigid: from the world of the study to that of `volume`
    SliceShows shows = SliceShows::study;
    std::optional<SliceOver> over = {};
    QStringList tags = {};         // whose picture it is, whatever else is hidden
    QStringList names = {};        // the same, of a second volume, with names
    QStringList secondNotes = {};  // what has to be known of it

    bool operator==(const SliceWish&) const = default;
};

struct SlicePicture {
    SliceWish of;
    QImage grey;           // of the frame's size; null when there was no memory for it
    QImage segments = {};  // over it; null where none is seen
    QImage colours = {};   // of a second volume, over both; null where nothing is
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

    struct Sampled;
    const slices::SampledSlice* sampled(std::optional<Sampled>& kept,
                                        const std::shared_ptr<const Volume>& volume,
                                        const slices::SliceFrame& frame, const SliceWish& wish);

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
    std::optional<Sampled> last_;      // of the thread, as those below
    std::optional<Sampled> lastOver_;  // the same, of what lies over it
    SliceWish painted_;                // the wish that `segments_` are of
    QImage segments_;
    std::jthread thread_;  // the last: it uses the rest
};

}  // namespace macula::viewer

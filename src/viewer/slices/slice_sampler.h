// Makes the pictures of slices on a thread of its own.
#pragma once

#include <QImage>
#include <QPointF>
#include <QString>
#include <QStringList>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "base/volume.h"
#include "live/frame/latest.h"
#include "slices/colour_table.h"
#include "slices/sampled_slice.h"
#include "slices/segment_picture.h"
#include "slices/slice_plane.h"
#include "viewer/slices/dose_over.h"

namespace macula::viewer {

// The volume of a picture.
enum class SliceShows {
    study,
    second,        // the second volume, at the same place
    secondByHand,  // the same, with an unknown position in the study
};

// A second volume in colours over the picture.
struct SliceOver {
    std::shared_ptr<const Volume> volume;
    glm::dmat4 volumeFromPane{1.0};
    DisplayWindow window;
    bool isInverted = false;
    slices::ColourTable colours = slices::ColourTable::hotIron;
    double opacity = 1.0;
    std::optional<DoseOver> dose = {};  // if it is a dose

    bool operator==(const SliceOver&) const = default;
};

struct SliceRequest {
    std::uint64_t study = 0;  // number of the study, counted by the caller
    std::shared_ptr<const Volume> volume;
    slices::SliceFrame frame;  // where the pane is, in the world of the study
    slices::Slab slab;
    DisplayWindow window;
    bool isInverted = false;
    slices::ColourTable colours = slices::ColourTable::grey;
    std::shared_ptr<const slices::ShownSegments> segments = {};  // over the picture; null: none
    // Passed through to the picture.
    QString positionText;
    bool isInterpolated = false;  // no image was taken there
    bool isLowBright = false;     // the display of the images shows low values white
    bool isOtherPhase = false;    // not the one that is open
    bool isDifference = false;    // of two phases: in diverging colours
    double pixelRatio = 1.0;
    glm::dvec3 crosshairMm{0.0};
    // For a second volume, if there is one.
    glm::dmat4 volumeFromPane{1.0};  // rigid: from the world of the study to that of `volume`
    SliceShows shows = SliceShows::study;
    std::optional<SliceOver> over = {};
    QStringList tags = {};         // identify the picture; never hidden
    QStringList names = {};        // lines that identify a second volume's patient
    QStringList secondNotes = {};  // notes about the second volume

    bool showsStudy() const { return shows == SliceShows::study; }
    // Convert a place in the pane, in logical pixels, to pixels of the frame and to the world of the study.
    glm::dvec2 frameFromPane(const QPointF& place) const {
        return glm::dvec2(place.x(), place.y()) * pixelRatio;
    }
    glm::dvec3 worldFromPane(const QPointF& place) const {
        return frame.worldFromPicture(frameFromPane(place));
    }

    bool operator==(const SliceRequest&) const = default;
};

struct SlicePicture {
    SliceRequest of;
    QImage grey;                             // of the frame's size; null when there was no memory for it
    QImage segments = {};                    // over `grey`; null without segments
    QImage colours = {};                     // a second volume in colours, over both; null without one
    std::vector<IsodosePath> isodoses = {};  // over all of these; of the plane alone, whatever the slab
};

// Makes one picture at a time; of the requests that arrive meanwhile, only the newest is made next. Samples
// again only for another volume, frame or slab: a new window only changes the greys.
class SliceSampler {
  public:
    // Calls `made` on its thread, once for each request that is neither replaced nor cancelled.
    explicit SliceSampler(std::function<void(SlicePicture)> made);
    SliceSampler(const SliceSampler&) = delete;
    SliceSampler& operator=(const SliceSampler&) = delete;
    ~SliceSampler();  // cancels the current request

    // Cancels requests for other studies. Without a volume it only releases the old one.
    void publish(SliceRequest request);

  private:
    void run();
    SlicePicture make(const SliceRequest& request);
    void paintSegments(const SliceRequest& request);  // into segments_
    void drawIsodoses(const SliceRequest& request);   // into isodoses_
    void forgetIsodoses();

    struct Sampled;
    const slices::SampledSlice* sampled(std::optional<Sampled>& kept,
                                        const std::shared_ptr<const Volume>& volume,
                                        const slices::SliceFrame& frame, const slices::Slab& slab,
                                        std::uint64_t study);
    const slices::SampledSlice* sampledOver(std::optional<Sampled>& kept, const SliceRequest& request,
                                            const slices::Slab& slab);
    static void forgetUncovered(Sampled& dose);

    struct Sampled {
        std::shared_ptr<const Volume> volume;
        slices::SliceFrame frame;
        slices::Slab slab;
        slices::SampledSlice slice;

        bool isOf(const std::shared_ptr<const Volume>& of, const slices::SliceFrame& in,
                  const slices::Slab& through) const {
            return volume == of && frame == in && slab == through;
        }
    };

    std::function<void(SlicePicture)> made_;
    live::Latest<SliceRequest> requests_;
    std::atomic<std::uint64_t> study_{0};
    std::atomic<bool> ends_{false};
    std::optional<Sampled> last_;      // only the thread uses this and the next three
    std::optional<Sampled> lastOver_;  // for the second volume over it
    SliceRequest painted_;             // the request of `segments_`
    QImage segments_;
    SliceOver drawn_;  // the dose of `isodoses_`, in `drawnFrame_`
    slices::SliceFrame drawnFrame_;
    std::vector<IsodosePath> isodoses_;
    std::jthread thread_;  // last member: the thread uses the others
};

}  // namespace macula::viewer

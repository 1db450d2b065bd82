// What of a session is in the 3D picture beside the volume: a second volume, and segments in colour.
#pragma once

#include <QObject>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "pipeline/volume/additions.h"
#include "scene/second/beside_state.h"
#include "scene/segments/segment_tints.h"
#include "scene/segments/segmentation_choice.h"
#include "viewer/jobs/background_job.h"
#include "viewer/session/viewer_session.h"
#include "viewer/slices/second_series.h"

namespace macula::viewer {

class SegmentationKeeper;

// Follows the session, and makes both in the background: until they are there, what was there before stays.
// What is not to be had is not chosen any more. Lives on the UI thread.
class ShownAdditions : public QObject {
    Q_OBJECT

  public:
    // Both outlive it.
    ShownAdditions(ViewerSession& session, const SegmentationKeeper& segments, QObject* parent = nullptr);

    // Null: there are none.
    const std::shared_ptr<const Additions>& additions() const { return additions_; }
    bool isAtRest() const { return !joining_.running() && !colouring_.running(); }

    void forget();  // all of a study that is not shown any more; tells nobody
    void setSecond(std::shared_ptr<const SecondSeries> second);  // null: there is none

  signals:
    void changed();  // additions()
    void failed(const macula::Error& error);

  private:
    void update();
    void updateSecond();
    void updateTints();
    void onSecond(const Result<SecondVolume>& outcome);
    void join();
    void onTintBox(const Result<std::shared_ptr<const TintBox>>& outcome);
    void showTints();
    void showNoTints();
    void show();

    ViewerSession& session_;
    const SegmentationKeeper& segments_;
    std::shared_ptr<const SecondSeries> second_;
    // Its volume as it is drawn, once made: another curve is no other volume to the device.
    std::shared_ptr<const Volume> drawn_;
    std::optional<app::BesideState> wantedSecond_;
    app::BesideState joiningOf_;  // what the last job was asked for
    app::BesideState madeOf_;     // what made_.second is of
    std::vector<app::ColouredIn3d> wantedTints_;
    std::vector<app::ColouredIn3d> makingTints_;  // those of them that are loaded
    std::vector<app::ColouredIn3d> madeTints_;    // what made_.tints are of
    std::size_t tintsOf_ = 0;                     // loaded segmentations
    // Voxels are gone through for another geometry alone: colours are a table beside it.
    std::vector<SegmentTints::Colour> wantedColours_;
    app::TintGeometry makingGeometry_;
    app::TintGeometry boxOf_;
    std::shared_ptr<const TintBox> box_;  // the last one, though none of it may be shown
    Additions made_;
    std::shared_ptr<const Additions> additions_;
    BackgroundJob<SecondVolume> joining_;
    BackgroundJob<std::shared_ptr<const TintBox>> colouring_;
};

}  // namespace macula::viewer

// The additions to the volume in the 3D picture: a second volume, and coloured segments.
#pragma once

#include <QObject>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "pipeline/volume/additions.h"
#include "scene/second/second_volume_state.h"
#include "scene/segments/segment_tints.h"
#include "scene/segments/segmentation_settings.h"
#include "viewer/editor/study_editor.h"
#include "viewer/jobs/background_job.h"
#include "viewer/slices/second_volume_texts.h"

namespace macula::viewer {

class SegmentationKeeper;

// Follows the session, and makes both in the background; the old ones stay until then. A choice that fails is
// taken out of the session's state. Lives on the UI thread.
class ShownAdditions : public QObject {
    Q_OBJECT

  public:
    // Both outlive it.
    ShownAdditions(StudyEditor& session, const SegmentationKeeper& segments, QObject* parent = nullptr);

    // Null without additions.
    const std::shared_ptr<const Additions>& additions() const { return additions_; }
    // The same without coloured segments, which are of the open phase. Null without a second volume.
    const std::shared_ptr<const Additions>& ofPhases() const { return ofPhases_; }
    bool isAtRest() const { return !joining_.running() && !colouring_.running(); }

    void forget();  // drops everything of the old study; emits nothing
    void setSecond(std::shared_ptr<const SecondVolumeTexts> second);  // null: no second volume

  Q_SIGNALS:
    void changed();  // additions()
    void failed(const macula::Error& error);

  private:
    void update();
    void updateSecond();
    void updateTints();
    void onSecond(const Result<DrawnSecondVolume>& outcome);
    void join();
    void onTintBox(const Result<std::shared_ptr<const TintBox>>& outcome);
    void showTints();
    void showNoTints();
    void show();

    StudyEditor& session_;
    const SegmentationKeeper& segments_;
    std::shared_ptr<const SecondVolumeTexts> second_;
    // Its volume as drawn, made once: another curve must not upload another volume.
    std::shared_ptr<const Volume> drawn_;
    std::optional<scene::SecondVolumeState> wantedSecond_;
    scene::SecondVolumeState joiningOf_;  // the state of the last job
    scene::SecondVolumeState madeOf_;     // the state of made_.second
    std::vector<scene::ColouredIn3d> wantedTints_;
    std::vector<scene::ColouredIn3d> makingTints_;  // the loaded ones of wantedTints_
    std::vector<scene::ColouredIn3d> madeTints_;    // the choices of made_.tints
    std::size_t tintsOf_ = 0;                       // how many segmentations were loaded for them
    // Only another geometry needs a pass over the voxels: colours are in a table.
    std::vector<SegmentTints::Colour> wantedColours_;
    scene::TintGeometry makingGeometry_;
    scene::TintGeometry boxOf_;
    std::shared_ptr<const TintBox> box_;  // the last one, even if it is not shown
    Additions made_;
    std::shared_ptr<const Additions> additions_;
    std::shared_ptr<const Additions> ofPhases_;
    BackgroundJob<DrawnSecondVolume> joining_;
    BackgroundJob<std::shared_ptr<const TintBox>> colouring_;
};

}  // namespace macula::viewer

// The segmentations of the study that is open: found, loaded, and brought to slices and to 3D.
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/segments/segment_mask.h"
#include "slices/segment_picture.h"
#include "study/segmentation/found_segmentation.h"
#include "study/segmentation/loaded_segmentation.h"
#include "viewer/jobs/background_job.h"
#include "viewer/session/viewer_session.h"

namespace macula::viewer {

// Looks at the session: headers are read when a study is shown, and voxels once a segmentation is. What was
// loaded is kept as long as the study. All reading is in the background, one segmentation at a time. Lives on
// the UI thread.
class SegmentationKeeper : public QObject {
    Q_OBJECT

  public:
    // The session must outlive it.
    explicit SegmentationKeeper(ViewerSession& session, QObject* parent = nullptr);

    const std::vector<app::FoundSegmentation>& found() const { return found_; }
    bool isFinding() const { return finding_.running(); }
    bool isLoading() const { return loading_.running(); }
    bool isAtRest() const { return !isFinding() && !isLoading() && !masking_.running(); }
    const app::LoadedSegmentation* loaded(std::string_view digest) const;  // null: not, or not yet
    const app::LoadedSegmentations& allLoaded() const { return loaded_; }
    QString trouble(std::string_view digest) const;  // why it could not be loaded; empty: nothing went wrong

    // What the mask is of that was made last.
    const std::vector<app::In3dOf>& madeIn3d() const { return made_; }

    // What is over slices now; null: nothing.
    const std::shared_ptr<const slices::ShownSegments>& shown() const { return shown_; }
    // What has to be known of the study because of them; empty: nothing.
    QString note() const;

    // Of loading: what is not there yet is not shown any more.
    void cancel();

  signals:
    void listChanged();                                      // found(), loaded() or trouble()
    void shownChanged();                                     // shown()
    void maskMade(const std::optional<macula::Mask>& mask);  // of what is left in 3D; nothing: all of it
    // The mask that was asked for is not to be had: the one before stays, and what is chosen becomes that of
    // it.
    void refused(const macula::Error& error);
    void began();
    void progressed(const QString& stage, double fraction);
    void ended();
    void failed(const macula::Error& error);

  private:
    using Found = std::vector<app::FoundSegmentation>;
    using Loaded = std::shared_ptr<const app::LoadedSegmentation>;

    void onStudyShown();
    void onChanged(const app::StudyState& before);
    void onFound(const Result<Found>& outcome);
    void onLoaded(const Result<Loaded>& outcome);
    void loadNext();
    void showOnSlices();
    void mask();
    void onRefused(const Error& error);
    const dicom::Stack* stack() const;  // of the volume that is open; null: it is of no folder

    ViewerSession& session_;
    Found found_;
    std::vector<Loaded> loaded_;
    std::map<std::string, QString, std::less<>> troubles_;  // by digest
    std::string isBeingLoaded_;                             // digest
    std::shared_ptr<const slices::ShownSegments> shown_;
    std::vector<app::In3dOf> masked_;  // what the last mask was asked for
    std::vector<app::In3dOf> making_;  // of that, what is there to be made
    std::vector<app::In3dOf> made_;    // the last that was
    std::size_t maskedOf_ = 0;         // and of how many loaded ones
    BackgroundJob<Found> finding_;
    BackgroundJob<Loaded> loading_;
    BackgroundJob<std::optional<Mask>> masking_;
};

}  // namespace macula::viewer

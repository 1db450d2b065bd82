// Finds and loads the segmentations of the open study, and makes them ready for slices and 3D.
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
#include "study/segmentation/label_map.h"
#include "study/segmentation/loaded_segmentation.h"
#include "viewer/editor/study_editor.h"
#include "viewer/jobs/background_job.h"
#include "viewer/segmentation/own_revisions.h"

namespace macula::viewer {

// Follows the session: reads headers when a study is shown, and voxels once a segmentation is shown. Keeps
// what it loaded as long as the study. Reads in the background, one segmentation at a time. Lives on the UI
// thread.
class SegmentationKeeper : public QObject {
    Q_OBJECT

  public:
    // The session must outlive it.
    explicit SegmentationKeeper(StudyEditor& session, QObject* parent = nullptr);

    const std::vector<study::FoundSegmentation>& found() const { return found_; }
    bool isFinding() const { return finding_.running(); }
    bool isLoading() const { return loading_.running(); }
    bool isAtRest() const { return !isFinding() && !isLoading() && !masking_.running(); }
    const study::LoadedSegmentation* loaded(std::string_view digest) const;  // null: not loaded
    const scene::LoadedSegmentations& allLoaded() const { return loaded_; }
    QString trouble(std::string_view digest) const;  // why loading failed; empty without error

    // The choices that the last finished mask was made from.
    const std::vector<scene::In3dOf>& madeIn3d() const { return made_; }

    // The segments over slices now; null: none.
    const std::shared_ptr<const slices::ShownSegments>& shown() const { return shown_; }
    // A note on the segmentations of the study; empty: none.
    QString note() const;

    // A label map that a person opened from a file: listed and shown until the next study, in place of an
    // earlier one of the same file. One undo step.
    void takeOpened(const study::OpenedLabelMap& opened);

    // Stops loading, and hides the segmentations that are not loaded.
    void cancel();

    // The segments that a person makes here: one segmentation among found() and allLoaded(), at the revision
    // that the state names. Null without any.
    const std::shared_ptr<const study::LoadedSegmentation>& own() const { return own_.current(); }
    bool isOwn(std::string_view digest) const { return own_.find(digest) != nullptr; }
    // As they were left; makes no undo step.
    void takeOwn(std::shared_ptr<const study::LoadedSegmentation> left);
    // One undo step, after which the segmentation is shown, each segment in a colour of its own.
    void changeOwn(const QString& what, std::shared_ptr<const study::LoadedSegmentation> next);
    // Whether own segments of this study may still come: until then note() does not miss them.
    void expectOwn(bool expected) { isOwnExpected_ = expected; }
    // Over the segments on slices, until the next study; nothing: none.
    void setPreview(std::optional<slices::ShownSegment> preview);

  Q_SIGNALS:
    void listChanged();                                      // found(), loaded() or trouble()
    void shownChanged();                                     // shown()
    void maskMade(const std::optional<macula::Mask>& mask);  // the voxels to show in 3D; nothing: all
    // The wanted mask failed: the old one stays, and the session's state is corrected to it.
    void refused(const macula::Error& error);
    void began();
    void progressed(const QString& stage, double fraction);
    void ended();
    void failed(const macula::Error& error);
    void ownChanged();  // another revision of own() counts

  private:
    using Found = std::vector<study::FoundSegmentation>;
    using Loaded = std::shared_ptr<const study::LoadedSegmentation>;

    void onStudyShown();
    void onChanged(const scene::StudyState& before);
    void onFound(const Result<Found>& outcome);
    void onLoaded(const Result<Loaded>& outcome);
    void loadNext();
    void showOnSlices();
    void mask();
    void onRefused(const Error& error);
    void listOwn();
    const dicom::Stack* stack() const;  // the open volume's images; null if it is from no folder

    StudyEditor& session_;
    Found found_;
    Found opened_;  // of these, label maps from files
    std::vector<Loaded> loaded_;
    std::map<std::string, QString, std::less<>> troubles_;  // the key is a digest
    std::string isBeingLoaded_;                             // digest
    std::shared_ptr<const slices::ShownSegments> shown_;
    OwnRevisions own_;
    std::string listedOwn_;  // digest of the revision among found_ and loaded_
    bool isOwnExpected_ = false;
    std::optional<slices::ShownSegment> preview_;
    std::vector<scene::In3dOf> masked_;  // the choices wanted for the last mask
    std::vector<scene::In3dOf> making_;  // those of `masked_` that are loaded
    std::vector<scene::In3dOf> made_;    // the choices behind the last finished mask
    std::size_t maskedOf_ = 0;           // how many were loaded when `masked_` was set
    BackgroundJob<Found> finding_;
    BackgroundJob<Loaded> loading_;
    BackgroundJob<std::optional<Mask>> masking_;
};

}  // namespace macula::viewer

// What a person does to own segments: makes, paints and changes them, each as one undo step.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/volume.h"
#include "base/voxel_set.h"
#include "scene/segments/own_segments.h"
#include "segment/statistics.h"
#include "segment/threshold.h"
#include "viewer/editor/study_editor.h"
#include "viewer/jobs/background_job.h"
#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/segmenting/segment_filter.h"

namespace macula::viewer {

enum class BrushMode { paint, erase, grow };
enum class PreviewJoin { add, takeAway, replace };

// What the controls say.
struct BrushChoice {
    BrushMode mode = BrushMode::paint;
    double radiusMm = 5.0;
    bool inOneSlice = false;
    double tolerance = 50.0;     // of growing, in the unit of the volume
    bool overCorners = false;    // 26 neighbours; otherwise 6
    double mostMl = 500.0;       // growing stops there
    bool withinSegment = false;  // growing and threshold: in the selected segment alone
};

// Works on the voxels and values of the open study; keeper and session outlive it. Long work is done in the
// background, one at a time; what a person undoes meanwhile counts, and the work is dropped then. Needs no
// window. Lives on the UI thread.
class SegmentWork : public QObject {
    Q_OBJECT

  public:
    SegmentWork(StudyEditor& session, SegmentationKeeper& keeper, QObject* parent = nullptr);

    void select(std::optional<std::uint16_t> number);  // of the own segment that the tools change
    const std::optional<std::uint16_t>& selected() const { return selected_; }
    const study::LoadedSegment* segment() const;  // the selected one; null: none
    bool isWorking() const { return finding_.running() || editing_.running(); }
    void cancel();

    // Without a label it is called after its number; it is selected.
    void addSegment(const QString& label);
    void addSegments(std::vector<scene::OwnSegment> segments, const QString& what);  // with other numbers
    void rename(const QString& label);
    void removeSegment();

    void setBrush(const BrushChoice& choice);
    const BrushChoice& brush() const { return brush_; }

    // A preview is a set of voxels on slices, of no segment yet.
    void growAt(const glm::dvec3& mm);  // from the voxel nearest to a point
    void previewBetween(const ValueRange& range);
    bool hasPreview() const { return preview_ != nullptr; }
    const VoxelSet* preview() const { return preview_.get(); }
    QString previewText() const;  // its size in ml, and what is to be known of it; empty without one
    void dropPreview();
    void joinPreview(PreviewJoin how);

    void apply(SegmentFilter filter, double amount);
    bool isEditing() const { return editing_.running(); }
    // The voxels of the selected segment, from now on.
    void commitVoxels(const QString& what, VoxelSet voxels, bool byHand);
    void refuseForMemory();

    // Of the selected segment; nothing before they are counted.
    const std::optional<segment::Statistics>& statistics() const { return statistics_; }

  Q_SIGNALS:
    void selectionChanged();
    void previewChanged();
    void statisticsChanged();
    void added(std::uint16_t number);  // and selected
    void began(const QString& what);
    void progressed(const QString& stage, double fraction);
    void ended();
    void failed(const macula::Error& error);

  private:
    using Revision = std::shared_ptr<const study::LoadedSegmentation>;
    using Voxels = std::shared_ptr<const VoxelSet>;
    using Found = std::pair<Voxels, QString>;  // with what is to be known of it
    using Change = std::function<Result<VoxelSet>(const VoxelSet& before, Progress&)>;

    std::shared_ptr<const Volume> volume() const { return session_.study().measured(); }
    std::vector<scene::OwnSegment> ownSegments() const;
    void commit(const QString& what, std::vector<scene::OwnSegment> segments);
    void edit(const QString& what, const Change& change);
    void showPreview(Voxels voxels, const QString& text);
    void count();
    void forget();

    StudyEditor& session_;
    SegmentationKeeper& keeper_;
    BrushChoice brush_;
    std::optional<std::uint16_t> selected_;
    Voxels preview_;
    QString previewText_;
    std::optional<segment::Statistics> statistics_;
    QString editingWhat_;
    Revision editingOf_;
    std::uint16_t editingNumber_ = 0;
    BackgroundJob<Found> finding_;
    BackgroundJob<Voxels> editing_;
    BackgroundJob<segment::Statistics> counting_;
};

}  // namespace macula::viewer

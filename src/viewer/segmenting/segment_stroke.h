// The strokes of a hand on slices, which paint and erase own segments.
#pragma once

#include <QCoreApplication>
#include <glm/glm.hpp>
#include <optional>

#include "base/voxel_set.h"
#include "viewer/segmenting/segment_work.h"
#include "viewer/slices/slice_brush.h"

namespace macula::viewer {

// A stroke is a preview until the button goes up, and then one undo step. A press that grows a region does
// so at once. All that it refers to outlives it.
class SegmentStroke : public SliceBrush {
    Q_DECLARE_TR_FUNCTIONS(SegmentStroke)

  public:
    SegmentStroke(StudyEditor& session, SegmentationKeeper& keeper, SegmentWork& work)
        : session_(session), keeper_(keeper), work_(work) {}

    bool press(const BrushTouch& at) override;
    void drag(const BrushTouch& to) override;
    void release() override;
    void drop() override;
    double radiusMm() const override;

  private:
    const Volume& volume() const { return *session_.study().measured(); }
    void showStroke();

    StudyEditor& session_;
    SegmentationKeeper& keeper_;
    SegmentWork& work_;
    VoxelSet stroke_;
    std::optional<glm::dvec3> atMm_;  // nothing: no stroke
};

}  // namespace macula::viewer

// The settings of the study's segments in the session's state, and a person's edits of them.
#pragma once

#include <QColor>
#include <QCoreApplication>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "viewer/editor/study_editor.h"
#include "viewer/segmentation/segmentation_keeper.h"

namespace macula::viewer {

// A segment, or, without a number, a whole segmentation. Number 0 is a segment, too.
struct SegmentId {
    std::string digest;
    std::optional<std::uint16_t> number = {};

    bool operator==(const SegmentId&) const = default;
};

// Only show() and isShown() accept a whole segmentation; the others need a segment. Needs no window.
class SegmentEdits {
    Q_DECLARE_TR_FUNCTIONS(SegmentEdits)

  public:
    SegmentEdits(StudyEditor& session, const SegmentationKeeper& keeper);  // both outlive this

    scene::SegmentSettings settings(const SegmentId& id) const;
    bool isShown(const SegmentId& id) const;  // on slices: the check mark of a segment or segmentation
    std::optional<Segment> segment(const SegmentId& id) const;
    const study::LoadedSegment* loaded(const SegmentId& id) const;  // null: not loaded yet
    QColor colour(const SegmentId& id) const;

    void show(const SegmentId& id, bool isShown);
    void setColour(const SegmentId& id, const QColor& rgb);
    void dragOpacity(const SegmentId& id, double scene::SegmentSettings::*opacity, double to);
    // When switched on, also shows the segmentation if it is hidden: it has no effect in 3D while hidden.
    void setIn3d(const SegmentId& id, scene::In3d in3d, bool on);
    void setColoured(const SegmentId& id, bool on);
    void centreOn(const SegmentId& id);  // the cross-hair; does nothing before it is loaded

  private:
    using Edit = std::function<void(scene::SegmentSettings&)>;
    static void apply(scene::StudyState& next, const SegmentId& id, const Edit& edit);
    void editIn3d(const QString& what, const SegmentId& id, bool needsShown, const Edit& edit);

    StudyEditor& session_;
    const SegmentationKeeper& keeper_;
};

}  // namespace macula::viewer

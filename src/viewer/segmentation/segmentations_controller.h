// Segmentations of the open study: their panel, and their segments on slices.
#pragma once

#include <QObject>
#include <array>

#include "viewer/context/window_context.h"

namespace macula::viewer {

class SegmentationKeeper;
class SegmentationPanel;
class SliceView;
class WorkBar;

// Lives on the UI thread.
class SegmentationsController : public QObject {
    Q_OBJECT

  public:
    // `keeper` outlives it.
    SegmentationsController(const WindowContext& context, SegmentationKeeper& keeper,
                            const std::array<SliceView*, 3>& slices);

    SegmentationPanel& panel() const { return *panel_; }
    WorkBar* bar() const { return bar_; }  // while segments load

  private:
    WindowContext context_;
    SegmentationKeeper& keeper_;
    std::array<SliceView*, 3> slices_;
    SegmentationPanel* panel_;
    WorkBar* bar_;
};

}  // namespace macula::viewer

// The panes of the window: the volume, slices of it, and the tools for slices.
#pragma once

#include <QObject>
#include <array>
#include <filesystem>
#include <optional>

#include "scene/state/study_state.h"
#include "slices/slice_plane.h"
#include "viewer/context/window_context.h"

class QMenu;

namespace macula::viewer {

class PaneGrid;
class SlicePair;
class SliceView;
class ToolBox;
enum class Pane;

// Grid and tools belong to the window. Lives on the UI thread.
class PanesController : public QObject {
    Q_OBJECT

  public:
    explicit PanesController(const WindowContext& context);

    PaneGrid& grid() const { return *grid_; }
    ToolBox& tools() const { return *tools_; }
    SliceView& slices(slices::Orientation orientation) const { return *slices_.at(std::size_t(orientation)); }
    const std::array<SliceView*, 3>& allSlices() const { return slices_; }  // by slices::Orientation
    SlicePair& pair(slices::Orientation orientation) const { return *pairs_.at(std::size_t(orientation)); }
    // The same views, each paired with a view of the second volume.
    const std::array<SlicePair*, 3>& pairs() const { return pairs_; }

    // `folder` keeps a person's own windows between runs; nothing: they are not kept.
    void shareOwnWindows(const std::optional<std::filesystem::path>& folder);
    void addActions(QMenu& view);  // layouts

    bool isVolumeShown() const;
    void showLayout();  // the layout of the session's state
    void favour(std::optional<slices::Orientation> orientation);
    void focusPicture();  // the last focused pane, or a shown one
    void showNames(bool shown);

  Q_SIGNALS:
    void layoutShown();

  private:
    void makeSlices();
    void makeTools();
    void changeLayout(scene::Layout layout);
    void askWhereToSave(const QImage& picture);
    void setCine(bool plays);  // in the active slice pane, else in a shown one

    WindowContext context_;
    std::array<SliceView*, 3> slices_{};
    std::array<SlicePair*, 3> pairs_{};
    PaneGrid* grid_ = nullptr;
    ToolBox* tools_ = nullptr;
    std::optional<Pane> lastPane_;
};

}  // namespace macula::viewer

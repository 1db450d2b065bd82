// Clips in the pictures: handles, the cut from the eye, the scissors, and what they leave of the voxels.
#pragma once

#include <QObject>
#include <array>

#include "viewer/context/window_context.h"

class QAction;
class QDockWidget;
class QMenu;
class QMenuBar;

namespace macula::viewer {

class ChoiceMenu;
class ClipEditing;
class ClipHandlesTool;
class ScissorTool;
class SliceView;
class VoxelCutting;
class WorkBar;

// Lives on the UI thread.
class ClipsController : public QObject {
    Q_OBJECT

  public:
    // `cutting` outlives it.
    ClipsController(const WindowContext& context, const std::array<SliceView*, 3>& slices,
                    VoxelCutting& cutting);

    ScissorTool& scissors() const { return *scissors_; }
    ClipHandlesTool& handles() const { return *handles_; }
    WorkBar* bar() const { return bar_; }
    QWidget* makePanel();
    void setDock(QDockWidget& dock);  // of the panel
    // `first` stands above all else: it removes the table.
    void addMenu(QMenuBar& bar, QAction& first);

  private:
    void showChosen();  // in the menu, as the session has it
    void connectTools();
    void addTools();
    void addEyeCut();
    void addPresets();

    WindowContext context_;
    std::array<SliceView*, 3> slices_;
    ClipEditing* editing_;
    ScissorTool* scissors_;
    ClipHandlesTool* handles_;
    WorkBar* bar_;
    ChoiceMenu* menu_ = nullptr;
};

}  // namespace macula::viewer

// Clips in the pictures: their handles, the cut from the eye, the scissors, and the voxels that these hide.
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
    // `cutting` lives until the window's destructor.
    ClipsController(const WindowContext& context, const std::array<SliceView*, 3>& slices,
                    VoxelCutting& cutting);

    ScissorTool& scissors() const { return *scissors_; }
    ClipHandlesTool& handles() const { return *handles_; }
    WorkBar* bar() const { return bar_; }
    QWidget* makePanel();
    void setDock(QDockWidget& dock);  // the panel's dock
    // `first` is the menu's first entry: it removes the patient table.
    void addMenu(QMenuBar& bar, QAction& first);

  private:
    void showChosen();  // checks the session's clip in the menu
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

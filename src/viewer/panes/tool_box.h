// What is done with slices: a slim bar of tools, and of how they are shown.
#pragma once

#include <QToolBar>
#include <array>

#include "scene/state/study_state.h"
#include "viewer/keys/slice_tool.h"

class QAction;
class QActionGroup;
class QDoubleSpinBox;
class QToolButton;

namespace macula::viewer {

class ViewerSession;
enum class Glyph;

// Slab, inversion, planes and layout are the session's: they are proposed to it, and shown as it has them.
// Tool and cine are of the window. Stands at the left, or wherever its orientation fits.
class ToolBox : public QToolBar {
    Q_OBJECT

  public:
    // `session` outlives it.
    explicit ToolBox(ViewerSession& session, QWidget* parent = nullptr);

    SliceTool tool() const { return tool_; }
    void setTool(SliceTool tool);  // tells nobody
    void setCine(bool plays);      // tells nobody

  signals:
    void toolChosen(macula::viewer::SliceTool tool);  // by a person
    void cineToggled(bool plays);                     // by a person
    void thicknessEntered();  // with Enter: what is typed next is meant for the pictures

  private:
    void addTools();
    void addSlab();
    void addShownAs();
    void addLayouts();
    QAction* add(Glyph glyph, const char* name, const QString& title, const QString& tip);
    void fitOrientation();
    void showState();
    void showSlab(const slices::Slab& slab);

    ViewerSession& session_;
    SliceTool tool_ = SliceTool::crosshair;
    QActionGroup* tools_;
    QDoubleSpinBox* thickness_ = nullptr;
    QToolButton* projection_ = nullptr;
    QActionGroup* projections_;
    QAction* invert_ = nullptr;
    QAction* acquired_ = nullptr;
    QActionGroup* layouts_;
    QAction* cine_ = nullptr;
};

}  // namespace macula::viewer

// A slim tool bar for slices: tools, and how slices are shown.
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

class StudyEditor;
enum class Glyph;

// Shows slab, inversion, planes and layout of the session's state, and proposes changes to them. The window
// owns tool and cine. May stand in any tool bar area.
class ToolBox : public QToolBar {
    Q_OBJECT

  public:
    // `session` outlives it.
    explicit ToolBox(StudyEditor& session, QWidget* parent = nullptr);

    SliceTool tool() const { return tool_; }
    void setTool(SliceTool tool);  // emits nothing
    void setCine(bool plays);      // emits nothing

  Q_SIGNALS:
    void toolChosen(macula::viewer::SliceTool tool);  // a person's choice
    void cineToggled(bool plays);                     // a person's choice
    void thicknessEntered();  // a person pressed Enter: the focus should return to the pictures

  private:
    void addTools();
    void addSlab();
    void addShownAs();
    void addLayouts();
    QAction* add(Glyph glyph, const char* name, const QString& title, const QString& tip);
    void fitOrientation();
    void showState();
    void showSlab(const slices::Slab& slab);

    StudyEditor& session_;
    SliceTool tool_ = SliceTool::crosshair;
    QActionGroup* tools_;
    QDoubleSpinBox* thickness_ = nullptr;
    QToolButton* projection_ = nullptr;
    QActionGroup* projections_;
    QAction* invert_ = nullptr;
    QAction* acquired_ = nullptr;
    QAction* straight_ = nullptr;
    QActionGroup* layouts_;
    QAction* cine_ = nullptr;
};

}  // namespace macula::viewer

// Windowing on a pane of slices: the display window by drag, number key and own list.
#pragma once

#include <QCoreApplication>
#include <glm/glm.hpp>
#include <optional>

#include "viewer/editor/study_editor.h"
#include "viewer/slices/own_window_list.h"
#include "viewer/slices/pane_content.h"

namespace macula::viewer {

// Proposes changes of the window of the volume that the pane is to show: the second one's unless it is linked
// to that of the study.
class SliceWindowing {
    Q_DECLARE_TR_FUNCTIONS(SliceWindowing)

  public:
    SliceWindowing(StudyEditor& session, const PaneContent& content);  // both outlive this

    // The own windows; null: none. The list outlives this.
    void setOwn(OwnWindowList* own) { own_ = own; }
    OwnWindowList* own() const { return own_; }
    void applyPreset(int digit);      // one of scene::windowPresets; does nothing without it
    void applyOwn(int number);        // from 1; does nothing without it
    void drag(glm::dvec2 byHeights);  // see scene::dragged

  private:
    void propose(const std::optional<DisplayWindow>& window, bool isDrag);

    StudyEditor& session_;
    const PaneContent& content_;
    OwnWindowList* own_ = nullptr;
};

}  // namespace macula::viewer

// The presets of the window: their library, gallery, menu and list, and the choice of one of them.
#pragma once

#include <QObject>
#include <functional>
#include <memory>

#include "scene/state/study_state.h"
#include "viewer/context/window_context.h"

class QMenu;
class QMenuBar;
class QToolBar;

namespace macula::live {
class StudyKeeper;
}

namespace macula::viewer {

class PresetBox;
class PresetGallery;
class PresetLibrary;
struct LibraryPreset;

// Lives on the UI thread.
class PresetsController : public QObject {
    Q_OBJECT

  public:
    // `stateNow` returns the state with the camera. `keeper` null: presets are not kept.
    PresetsController(const WindowContext& context, const std::shared_ptr<live::StudyKeeper>& keeper,
                      std::function<scene::StudyState()> stateNow);

    PresetGallery& gallery() const { return *gallery_; }
    void addMenu(QMenuBar& bar);
    void addFileAction(QMenu& file);
    void addBox(QToolBar& bar);  // the list

  private:
    void connectLibrary();
    void onChanged(const scene::StudyState& before);
    void showChosen();  // selects the session's preset in the list
    void showLook();
    void fillMenu(QMenu& menu);
    void use(const LibraryPreset& preset);
    void askForFile();
    void askWhereToExport(const LibraryPreset& preset);
    void askWhereToSaveShown();
    void compare(const LibraryPreset& preset);

    WindowContext context_;
    PresetLibrary* library_;
    PresetGallery* gallery_;
    PresetBox* box_ = nullptr;  // null before addBox
};

}  // namespace macula::viewer

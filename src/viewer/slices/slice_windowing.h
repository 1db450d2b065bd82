// Windowing on a pane of slices: the display window by drag, number key and own list, which all panes share.
#pragma once

#include <QCoreApplication>
#include <QObject>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/slices/own_windows.h"
#include "viewer/editor/study_editor.h"
#include "viewer/jobs/background_job.h"
#include "viewer/slices/pane_content.h"

namespace macula::viewer {

// The person's own display windows. Kept in a session::Store between runs, in the background; without a store
// they last for the run. Each change is applied to the store's present content, which another program window
// may have changed; content that cannot be read is copied before it is replaced. Lives on the UI thread.
class OwnWindowList : public QObject {
    Q_OBJECT

  public:
    // `folder` of the store; nothing: no store. The windows arrive later, with `changed`.
    explicit OwnWindowList(std::optional<std::filesystem::path> folder, QObject* parent = nullptr);
    ~OwnWindowList() override;  // writes the remaining changes and waits for that

    const std::vector<scene::OwnWindow>& all() const { return windows_; }
    std::vector<scene::OwnWindow> fitting(const Volume& volume) const {
        return scene::ownWindowsFor(windows_, volume);
    }
    // Fails as scene::withOwnWindow does.
    Result<void> add(scene::OwnWindow window);
    void remove(const scene::OwnWindow& window);

  Q_SIGNALS:
    void changed();
    void failed(const macula::Error& error);  // the windows could not be read or stored

  private:
    struct Edit {
        scene::OwnWindow window;
        bool isRemoved = false;
    };
    using Edits = std::vector<Edit>;
    struct Kept {
        std::vector<scene::OwnWindow> windows;
        std::optional<Error> leftOut;  // why an added window did not fit any more
    };

    static Kept edited(std::vector<scene::OwnWindow> windows, const Edits& edits);
    static Result<Kept> keepIn(const std::filesystem::path& folder, const Edits& edits);
    void onRead(const Result<std::string>& json);
    void onKept(const Result<Kept>& kept);
    void edit(Edit made);
    void keep();

    std::optional<std::filesystem::path> folder_;
    std::vector<scene::OwnWindow> windows_;
    Edits toKeep_;   // edits to write after the running read or write
    Edits keeping_;  // being written
    std::optional<BackgroundJob<std::string>> reading_;
    std::optional<BackgroundJob<Kept>> writing_;
};

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

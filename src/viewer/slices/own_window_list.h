// The windows of one's own that all panes of slices share.
#pragma once

#include <QObject>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/slices/own_windows.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// Kept in a session::Store between runs, which nobody waits for; where there is none they last for the run.
// What is kept are the changes, made to what the store holds by then: another window may have kept some too,
// and what could not be read once is not overwritten. Lives on the UI thread.
class OwnWindowList : public QObject {
    Q_OBJECT

  public:
    // `folder` of the store; nothing: none. They come a moment later.
    explicit OwnWindowList(std::optional<std::filesystem::path> folder, QObject* parent = nullptr);
    ~OwnWindowList() override;  // keeps what is not kept yet, and waits for that

    const std::vector<app::OwnWindow>& all() const { return windows_; }
    std::vector<app::OwnWindow> fitting(const Volume& volume) const {
        return app::ownWindowsFor(windows_, volume);
    }
    // As app::withOwnWindow.
    Result<void> add(app::OwnWindow window);
    void remove(const app::OwnWindow& window);

  signals:
    void changed();
    void failed(const macula::Error& error);  // they could not be read or kept

  private:
    struct Edit {
        app::OwnWindow window;
        bool isRemoved = false;
    };
    using Edits = std::vector<Edit>;
    struct Kept {
        std::vector<app::OwnWindow> windows;
        std::optional<Error> leftOut;  // of those that did not fit any more
    };

    static Kept edited(std::vector<app::OwnWindow> windows, const Edits& edits);
    static Result<Kept> keepIn(const std::filesystem::path& folder, const Edits& edits);
    void onRead(const Result<std::string>& json);
    void onKept(const Result<Kept>& kept);
    void edit(Edit made);
    void keep();

    std::optional<std::filesystem::path> folder_;
    std::vector<app::OwnWindow> windows_;
    Edits toKeep_;   // once what was kept is read, or written
    Edits keeping_;  // by the job
    std::optional<BackgroundJob<std::string>> reading_;
    std::optional<BackgroundJob<Kept>> writing_;
};

}  // namespace macula::viewer

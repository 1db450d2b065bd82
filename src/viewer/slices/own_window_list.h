// The windows of one's own that all panes of slices share.
#pragma once

#include <QObject>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/slices/own_windows.h"
#include "viewer/background_job.h"

namespace macula::viewer {

// Kept in a session::Store between runs, which nobody waits for; where there is none they last for the run.
// Lives on the UI thread.
class OwnWindowList : public QObject {
    Q_OBJECT

  public:
    // `folder` of the store; nothing: none. They come a moment later.
    explicit OwnWindowList(std::optional<std::filesystem::path> folder, QObject* parent = nullptr);
    ~OwnWindowList() override;  // waits for what is being written

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
    void onRead(const Result<std::string>& json);
    void keep();

    std::optional<std::filesystem::path> folder_;
    std::vector<app::OwnWindow> windows_;
    bool isRead_ = false;
    bool mustKeep_ = false;  // once what was kept is read, or written
    BackgroundJob<std::string> reading_;
    BackgroundJob<bool> writing_;
};

}  // namespace macula::viewer

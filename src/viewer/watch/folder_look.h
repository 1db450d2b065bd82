// Looks at one watched folder again and again.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <chrono>
#include <cstddef>
#include <memory>
#include <vector>

#include "study/watch/watched_folder.h"

namespace macula::viewer {

// How often a folder is looked at, and how long nothing may change in a study before it counts as whole.
struct WatchPace {
    std::chrono::milliseconds every{3000};
    std::chrono::milliseconds quiet{6000};
};

// Polls, since network file systems do not tell of changes; a look that takes long is followed by a longer
// pause. Each folder has a thread of its own, which a share that hangs can hold for ever: then this object is
// destroyed without it. Lives on the UI thread.
class FolderLook : public QObject {
    Q_OBJECT

  public:
    FolderLook(const QString& folder, WatchPace pace, QObject* parent);
    ~FolderLook() override;  // waits two seconds at most for a look in progress

    const QString& folder() const { return folder_; }
    bool isAbsent() const { return isAbsent_; }  // it cannot be read now, or does not answer
    std::size_t looks() const { return looks_; }

  Q_SIGNALS:
    void arrived(const macula::study::ArrivedStudy& study);
    void absenceChanged();

  private:
    // What one look found.
    struct Looked {
        std::vector<study::ArrivedStudy> studies;
        bool isAbsent = false;
        std::chrono::milliseconds took{0};
    };
    struct Shared;  // with the thread

    void onTimer();
    void look();
    void take(const Looked& looked);
    void setAbsent(bool isAbsent);
    static Looked lookedAt(study::WatchedFolder& folder, const CancelToken& cancel);
    static void lookOn(const std::shared_ptr<Shared>& shared);

    QString folder_;
    WatchPace pace_;
    std::shared_ptr<Shared> shared_;
    QTimer timer_;
    bool isLooking_ = false;
    bool isAbsent_ = false;
    std::size_t looks_ = 0;
};

}  // namespace macula::viewer

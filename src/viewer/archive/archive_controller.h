// Studies from archives: the panel that searches them, and fetching in the background.
#pragma once

#include <QObject>
#include <QStringList>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "net/archive/query.h"
#include "net/sources/source_list.h"
#include "study/archive/fetched_study.h"
#include "study/open/opened_study.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QAction;
class QMenu;

namespace macula::viewer {

class ArchivePanel;
class OpeningController;
class WorkBar;

// A study is shown as soon as there are enough images of it for a volume, again when there are twice as many,
// and at last whole.
// Lives on the UI thread.
class ArchiveController : public QObject {
    Q_OBJECT

  public:
    ArchiveController(const WindowContext& context, OpeningController& opening);

    ArchivePanel& panel() const { return *panel_; }
    WorkBar* bar() const { return bar_; }                     // while a study is fetched
    void setShownAction(QAction& shown) { shown_ = &shown; }  // shows and hides the panel
    void addAction(QMenu& file);
    void showNames(bool shown);
    bool fetching() const { return fetch_.running(); }

  Q_SIGNALS:
    void answered(const QString& archive);  // its name: it can be reached

  private:
    // A study that comes, or came last. Another one that is fetched makes what is still heard of it void.
    struct Coming {
        std::uint64_t number = 0;
        std::string studyInstanceUid;
        study::StudySource openBefore;  // what was open when it began
        std::filesystem::path folder;   // once something came
        std::size_t lookedAt = 0;       // instances
    };

    void readSources();
    void setUp();
    void search(const net::StudyQuery& query);
    void fetch(const net::FoundStudy& study);
    void cancel();
    void lookAt(std::uint64_t number, const study::Arrival& arrival);
    void showPart(const std::filesystem::path& folder);
    void showWhole(const Result<study::FetchedStudy>& fetched);
    bool isOtherOpen() const;  // a person opened another study since the fetch began
    QStringList notes() const;

    WindowContext context_;
    OpeningController& opening_;
    ArchivePanel* panel_;
    WorkBar* bar_;
    QAction* shown_ = nullptr;
    std::optional<net::SourceList> sources_;
    QString searched_;  // the archive whose answers are listed
    Coming coming_;
    BackgroundJob<net::StudyAnswers> search_;
    BackgroundJob<study::FetchedStudy> fetch_;
    BackgroundJob<std::filesystem::path> look_;  // whether what has come can be shown; its folder
};

}  // namespace macula::viewer

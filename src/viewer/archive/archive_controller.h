// Studies from archives: the panel that searches them, and fetching in the background.
#pragma once

#include <QObject>
#include <filesystem>
#include <optional>

#include "net/archive/query.h"
#include "net/sources/source_list.h"
#include "study/archive/fetched_study.h"
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

  private:
    void readSources();
    void setUp();
    void search(const net::StudyQuery& query);
    void fetch(const net::FoundStudy& study);
    void lookAt(const study::Arrival& arrival);
    void showWhole(const Result<study::FetchedStudy>& fetched);

    WindowContext context_;
    OpeningController& opening_;
    ArchivePanel* panel_;
    WorkBar* bar_;
    QAction* shown_ = nullptr;
    std::optional<net::SourceList> sources_;
    BackgroundJob<net::StudyAnswers> search_;
    BackgroundJob<study::FetchedStudy> fetch_;
    BackgroundJob<std::filesystem::path> look_;  // whether what has come of a study can be shown; its folder
    std::size_t lookedAt_ = 0;                   // instances
};

}  // namespace macula::viewer

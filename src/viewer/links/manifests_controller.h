// Opens imaging manifests: fetches what they name from archives that are set up, and shows it.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <vector>

#include "study/archive/fetched_study.h"
#include "study/open/opened_study.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

class OpeningController;
class WorkBar;

// Lives on the UI thread.
class ManifestsController : public QObject {
    Q_OBJECT

  public:
    ManifestsController(const WindowContext& context, OpeningController& opening);

    void open(const QString& manifest);
    WorkBar* bar() const { return bar_; }  // while its studies are fetched
    bool fetching() const { return fetch_.running(); }
    // Says what did not come of the study that is shown now.
    void onStudyShown();

  private:
    void show(const Result<std::vector<study::FetchedStudy>>& fetched);

    WindowContext context_;
    OpeningController& opening_;
    WorkBar* bar_;
    study::StudySource openBefore_;  // what was open when it began
    std::filesystem::path shown_;    // folder of the study that is opened of the last manifest
    QStringList told_;               // with it
    BackgroundJob<std::vector<study::FetchedStudy>> fetch_;
};

}  // namespace macula::viewer

// The bench of the window: how soon a study is open, how long the user interface stalls over a day's work,
// and how well the picture follows.
#pragma once

#include "viewer/window/main_window.h"  // before Qt, see vulkan_window.h

#include <QJsonObject>
#include <QObject>
#include <QStringList>
#include <cstdint>
#include <filesystem>
#include <memory>

#include "viewer/driven/driven_hand.h"
#include "viewer/driven/driven_steps.h"
#include "viewer/driven/gauges.h"
#include "viewer/driven/session_steps.h"

namespace macula::viewer {

struct ColdFiles {
    std::size_t files = 0;
    std::uint64_t bytes = 0;
    // Bytes still cached after posix_fadvise(DONTNEED): pages that another program has mapped or not written
    // yet. The disc's own cache is unknown. A file whose state is unknown counts in full.
    std::uint64_t bytesStillCached = 0;
};

// Drops a file, or all files below a folder. Does not follow links, needs only read rights, and leaves out
// unreadable files.
ColdFiles dropFromCache(const std::filesystem::path& path);

struct WorkdayScriptOptions {
    study::StudySource study;
    bool opensOnly = false;  // ends once slice, picture and model have arrived
    WorkdaySteps work;
    double modelSeconds = 60.0;  // at most, for the preview to be sharp enough to show
};

// First drops the files of the study from the system's cache. `finished` carries the exit code: 0; that of
// the error when the study could not be opened or the device used, or no picture came in time; kExitFault
// when a step was not done or an object was missing, so that the report is incomplete.
class WorkdayScript : public QObject {
    Q_OBJECT

  public:
    WorkdayScript(MainWindow& window, WorkdayScriptOptions options, QObject* parent = nullptr);

    void start();  // before the window is shown and the study opened
    // After the end: "device", "cold", "startMs" (of the process before start()), "opening" (OpeningTimes),
    // "orbit" (OrbitGauge), "steps" (DrivenSteps), "longestUiStallMs", "missing" (DrivenHand).
    QJsonObject report() const;

  Q_SIGNALS:
    void finished(int exitCode);

  private:
    std::vector<DrivenStep> steps();
    void fail(const Error& error);
    void finish(int exitCode);

    MainWindow& window_;
    WorkdayScriptOptions options_;
    OpeningTimes opening_;
    DrivenHand hand_;
    OrbitGauge orbit_;
    std::unique_ptr<DrivenSteps> steps_;
    ColdFiles cold_;
    double startMs_ = 0.0;
    QString device_;
    bool isDone_ = false;
};

// The age of this process; -1 if the system does not tell it.
double processAgeMs();

// A table of targets and measurements, for a person. `resumed` is the report of another process that opened
// the same study again as it was left; empty: none.
QString sessionTable(const QJsonObject& session, const QJsonObject& resumed);

// Opens the study again in another process, with these arguments of the command line, and prints both: JSON
// to standard output, the table to standard error. Returns `code` if that is not 0, else the exit code of the
// reopening.
int reportSession(int code, const QJsonObject& session, const QStringList& arguments);

}  // namespace macula::viewer

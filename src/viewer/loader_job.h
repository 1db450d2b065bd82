// Opens a folder without keeping anybody waiting.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "viewer/background_job.h"

namespace macula::viewer {

// What came out of a folder. The strings are for the screen; `description` may name a patient.
struct LoadedStudy {
    std::shared_ptr<const Volume> volume;
    std::string description = {};
    std::string whyThisSeries = {};          // empty for the phantom
    std::vector<std::string> messages = {};  // warnings about the series and about files left out
};

// A folder, of which the best series is meant; or a file, of which its own series in its folder is meant;
// nothing is the built-in phantom.
using StudySource = std::optional<std::filesystem::path>;

// Scans, chooses the series and decodes it. Blocks; a file at a time sees a cancellation.
Result<LoadedStudy> loadStudy(const StudySource& source, Progress& progress);

// One load at a time, on a thread of its own. A new one cancels the one before, whose outcome is not
// reported. Lives on the UI thread, and so do its signals.
class StudyLoader : public QObject {
    Q_OBJECT

  public:
    explicit StudyLoader(QObject* parent = nullptr);

    void open(StudySource source);
    void cancel();  // `cancelled` follows
    bool loading() const { return job_.running(); }
    bool atRest() const { return job_.atRest(); }  // cancelled ones have noticed, too

  signals:
    void began();
    void progressed(const QString& stage, double fraction);
    void loaded(const macula::viewer::LoadedStudy& study);
    void failed(const macula::Error& error);
    void cancelled();

  private:
    void tellOutcome(const Result<LoadedStudy>& outcome);

    BackgroundJob<LoadedStudy> job_;
};

}  // namespace macula::viewer

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
#include "viewer/identity.h"

namespace macula::viewer {

class FoundVolumes;

// What came out of a folder. All strings are for the screen; they may name a patient.
struct LoadedStudy {
    std::shared_ptr<const Volume> volume;  // null when there is only a question
    Identity identity = {};
    std::string description = {};
    std::string whyThisSeries = {};          // empty for the phantom
    std::vector<std::string> messages = {};  // warnings about the series and about files left out
    // All volumes of the folder, and which of them this is; null for the phantom and files of one volume.
    std::shared_ptr<const FoundVolumes> found = {};
    std::vector<std::string> volumeTitles = {};
    std::size_t volumeIndex = 0;
    std::string joinQuestion = {};  // see dicom::ScanOptions
};

// A folder, or the DICOMDIR in it, of which the best series is meant; an image, of which its own series in
// its folder is meant; or a file that is a volume by itself (dicom/volume_file.h). Nothing is the built-in
// phantom.
using StudySource = std::optional<std::filesystem::path>;

// Scans, chooses the series and decodes it. Blocks; a file at a time sees a cancellation.
Result<LoadedStudy> loadStudy(const StudySource& source, Progress& progress, bool join = false);
// Decodes another volume of the folder.
Result<LoadedStudy> loadFoundVolume(std::shared_ptr<const FoundVolumes> found, std::size_t index,
                                    Progress& progress);

// One load at a time, on a thread of its own. A new one cancels the one before, whose outcome is not
// reported. Lives on the UI thread, and so do its signals.
class StudyLoader : public QObject {
    Q_OBJECT

  public:
    explicit StudyLoader(QObject* parent = nullptr);

    void open(StudySource source, bool join = false);
    void open(std::shared_ptr<const FoundVolumes> found, std::size_t index);
    void cancel();  // `cancelled` follows
    bool loading() const { return job_.running(); }
    bool atRest() const { return job_.atRest(); }  // cancelled ones have noticed, too

  signals:
    void began();
    void progressed(const QString& stage, double fraction);
    void loaded(const macula::viewer::LoadedStudy& study);
    void askedToJoin(const QString& path, const QString& question);  // open(path, true) is yes
    void failed(const macula::Error& error);
    void cancelled();

  private:
    void tellOutcome(const Result<LoadedStudy>& outcome);

    BackgroundJob<LoadedStudy> job_;
    StudySource source_;
};

}  // namespace macula::viewer

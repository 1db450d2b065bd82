// Presentation states that are written and read while the window goes on.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scene/presentation/presentation_file.h"
#include "scene/presentation/softcopy_on_slices.h"
#include "scene/presentation/state_of_presentation.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// One of each at a time; another one takes the place of the one before. Lives on the UI thread, and so do its
// signals.
class PresentationFiles : public QObject {
    Q_OBJECT

  public:
    explicit PresentationFiles(QObject* parent = nullptr);

    void save(const std::filesystem::path& path, app::PresentationWish wish);
    void cancelSaving() { saving_.cancel(); }
    bool saving() const { return saving_.running(); }
    // For the volume that is open, of these images (app::imagesOf); what the file does not say is as in
    // `usual`. All of its view is seen in a picture of that aspect; 0: not known.
    void open(const std::filesystem::path& path, std::shared_ptr<const Volume> volume,
              std::string seriesDigest, std::vector<dicom::ReferencedFrames> images, app::StudyState usual,
              double aspectWidthOverHeight = 0.0);
    // One of slices, for the study that is open; what the file does not say is as in `usual`.
    void openOnSlices(const std::filesystem::path& path, app::OpenedStudy study, app::SliceState usual);
    // What is being opened is of a study that is not on screen any more: nothing is told of it.
    void cancelOpening();

  signals:
    // `notes` are what other programs will show otherwise, and what is shown otherwise here.
    void saved(const QString& path, const QStringList& notes);
    void opened(const macula::app::StudyState& state, const QStringList& notes);
    void openedOnSlices(const macula::app::SoftcopyOnSlices& shown, const QStringList& notes);
    void failed(const macula::Error& error);

  private:
    QString path_;
    BackgroundJob<std::vector<std::string>> saving_;
    BackgroundJob<app::PresentedState> opening_;
    BackgroundJob<app::SoftcopyOnSlices> openingOnSlices_;
};

}  // namespace macula::viewer

// Writes and reads presentation states in the background.
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

// One of each at a time; a new one replaces the one before. Lives on the UI thread, and so do its signals.
class PresentationFiles : public QObject {
    Q_OBJECT

  public:
    explicit PresentationFiles(QObject* parent = nullptr);

    void save(const std::filesystem::path& path, scene::PresentationRequest request);
    void cancelSaving() { saving_.cancel(); }
    bool saving() const { return saving_.running(); }
    // Opens a presentation state of a 3D view. It must refer to `images`, those of the open volume
    // (study::imagesOf); `usual` supplies what the file omits. The camera is widened so that a picture of
    // this aspect shows the whole view; 0: unknown.
    void open(const std::filesystem::path& path, std::shared_ptr<const Volume> volume,
              std::string seriesDigest, std::vector<dicom::ReferencedFrames> images, scene::StudyState usual,
              double aspectWidthOverHeight = 0.0);
    // Opens a presentation state of slices of the open study; `usual` supplies what the file omits.
    void openOnSlices(const std::filesystem::path& path, study::OpenedStudy study, scene::SliceState usual);
    // Cancels an opening, for example when another study is shown; no signal follows.
    void cancelOpening();

  Q_SIGNALS:
    // `notes` say what other programs will show differently (saved), or what is shown differently here.
    void saved(const QString& path, const QStringList& notes);
    void opened(const macula::scene::StudyState& state, const QStringList& notes);
    void openedOnSlices(const macula::scene::SoftcopyOnSlices& shown, const QStringList& notes);
    void failed(const macula::Error& error);

  private:
    QString path_;
    BackgroundJob<std::vector<Text>> saving_;
    BackgroundJob<scene::PresentedState> opening_;
    BackgroundJob<scene::SoftcopyOnSlices> openingOnSlices_;
};

}  // namespace macula::viewer

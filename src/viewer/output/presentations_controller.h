// Presentation states: the 3D view as a DICOM object, saved and opened again.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/presentation/presentation_file.h"
#include "scene/presentation/softcopy_on_slices.h"
#include "scene/presentation/state_of_presentation.h"
#include "study/list/study_tree.h"
#include "study/open/found_volumes.h"
#include "study/open/opened_study.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"
#include "viewer/settings/save_object_dialog.h"

class QMenu;

namespace macula::viewer {

class OpeningController;
class SliceView;
class StateController;
class StudyBrowser;

// Writes and reads presentation states in the background. One of each at a time; a new one replaces the one
// before. Lives on the UI thread, and so do its signals.
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

// Asks whether a presentation state is to be de-identified. Its value holds once it is accepted.
class PresentationDialog : public SaveObjectDialog {
    Q_OBJECT

  public:
    explicit PresentationDialog(QWidget* parent = nullptr);
};

// Lives on the UI thread.
class PresentationsController : public QObject {
    Q_OBJECT

  public:
    struct Uses {  // all of it outlives the controller
        OpeningController& opening;
        StateController& states;
        StudyBrowser& browser;
        std::array<SliceView*, 3> slices;
    };
    PresentationsController(const WindowContext& context, const Uses& uses);

    void addActions(QMenu& file);

    // The 3D view as it is now. Fails with usage where no DICOM images are open, or where they lack what it
    // needs.
    Result<scene::PresentationRequest> onScreen() const;

    QString unfinished() const;  // a sentence; empty: nothing is being written
    void cancel();
    void onStudyShown();

  Q_SIGNALS:
    void written();

  private:
    void connectList();
    void askForOne();
    void open(const std::filesystem::path& path);  // a 3D view of the open study
    void showListed(const study::StudyRow::Presentation& listed);
    void showOnSlices(const scene::SoftcopyOnSlices& shown, const QStringList& notes);
    void askHowToSave();
    void askWhereToSave(scene::PresentationRequest request);
    const study::OpenedStudy& study() const;

    WindowContext context_;
    Uses uses_;
    PresentationFiles* files_;
    // A presentation to show once its series is open.
    struct Awaited {
        std::shared_ptr<const study::FoundVolumes> found;
        study::StudyRow::Presentation listed;
    };
    std::optional<Awaited> awaiting_;
};

}  // namespace macula::viewer

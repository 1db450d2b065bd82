// Presentation states: the 3D view as a DICOM object, saved and opened again.
#pragma once

#include <QCheckBox>
#include <QDialog>
#include <QObject>
#include <QString>
#include <QStringList>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "study/list/study_tree.h"
#include "study/open/found_volumes.h"
#include "study/open/opened_study.h"
#include "viewer/context/window_context.h"

class QMenu;

namespace macula::scene {
struct PresentationRequest;
struct SoftcopyOnSlices;
}  // namespace macula::scene

namespace macula::viewer {

class OpeningController;
class PresentationFiles;
class SliceView;
class StateController;
class StudyBrowser;

// Asks whether a presentation state is to be de-identified. Its value holds once it is accepted.
class PresentationDialog : public QDialog {
    Q_OBJECT

  public:
    explicit PresentationDialog(QWidget* parent = nullptr);

    bool isDeidentified() const { return deidentified_->isChecked(); }

  private:
    QCheckBox* deidentified_;
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

// The application's window.
#pragma once

#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include <QMainWindow>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "live/store/study_keeper.h"
#include "scene/choice/catalogue.h"
#include "scene/state/study_state.h"
#include "slices/slice_plane.h"
#include "viewer/context/window_context.h"
#include "viewer/editor/study_editor.h"
#include "viewer/output/quit_controller.h"
#include "viewer/panes/panes_controller.h"
#include "viewer/settings/settings_controller.h"
#include "viewer/status/notifications.h"
#include "viewer/status/study_notes.h"
#include "viewer/volume/opening_controller.h"
#include "viewer/volume/shown_volume.h"
#include "viewer/volume/state_controller.h"
#include "viewer/watch/watch_controller.h"
#include "viewer/window/status_controller.h"

namespace macula::viewer {

class ArchiveController;
class BrowserController;
class ClipsController;
class CurveController;
class DoseController;
class DocumentsController;
class FollowUpController;
class HangingController;
class HeadsetController;
class KeyImagesController;
class LightsController;
class LinksController;
class LookController;
class ManifestsController;
class MeasurementsController;
class ModelsController;
class MoviesController;
class PaneGrid;
class PanelsController;
class PhasesController;
class PickController;
class PicturesController;
class PlanarController;
class PlanesController;
class PresentationsController;
class PresetsController;
class QualityController;
class ReadMarks;
class ReceiveController;
class ScissorTool;
class SecondVolumeController;
class SecondVolumeLoader;
class SegmentationKeeper;
class SegmentationsController;
class SegmentingController;
class SendController;
class SlicePair;
class SliceView;
class TableController;
class TransferFunctionEditor;
class UndoActions;
class View3dController;
class ViewsController;

struct MainWindowOptions {
    scene::Catalogue catalogue;
    std::string device = {};                              // its name, see gpu::chooseDevice
    std::shared_ptr<const TransferFunction> preset = {};  // null: by the volume's modality
    std::shared_ptr<const trace::LightRig> lights = {};   // null: the default lights of each look
    std::optional<ViewDirection> firstView = {};          // nothing: scene::usualView
    scene::Layout layout = scene::Layout::fourPanes;
    QSize pictureSize{960, 720};  // of the 3D pane alone; with slices, of the window
    std::uint32_t sampleLimit = 512;
    bool usesModel = true;  // shows splats in motion
    bool namesPatient =
        true;  // over the picture, in the title and beside the presets, until a person hides the names
    // Folder for models and the states of studies. Nothing: keeps none.
    std::optional<std::filesystem::path> sessions = {};
    std::optional<int> keepDays = {};  // deletes studies unopened for longer; nothing: never
    bool calibrates = false;           // measures this machine's speed once, in the background
    Restores restores = Restores::all;
    bool choosesSize = false;  // pictureSize overrides the window's last place
    bool keepsLayout = false;  // `layout` overrides that of a restored study
    Settings settings = {};
    std::optional<std::filesystem::path> settingsFile = {};  // where to keep them; nothing: not kept
    bool showsInHeadset = false;                             // shows the first study in a headset
    WatchPace watchPace = {};
};

// Lists the features: each has a controller, which owns its actions, panels and jobs. The window places them,
// and shows another study to all of them. Nothing here blocks: a StudyLoader reads folders, the viewport's
// render thread makes pictures.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    MainWindow(gpu::Instance instance, MainWindowOptions options);
    ~MainWindow() override;  // waits until learnt models are saved

    void open(study::StudySource source) { opening_->open(std::move(source)); }
    // Asks first; see LinksController.
    void openLink(const QString& link);
    // open() ends with this when it succeeds.
    void showStudy(const study::OpenedStudy& study);
    void cancelLoading() { opening_->loader().cancel(); }
    bool loading() const { return opening_->loader().loading(); }
    bool loaderAtRest() const { return opening_->loader().atRest(); }
    SegmentationKeeper& segments() { return shown_->segments(); }
    SegmentingController& segmenting() { return *segmenting_; }
    bool searchingTable() const;
    bool cutting() const;  // the scissors' mask is being computed
    // The scissors over the 3D picture.
    ScissorTool& scissors();

    Viewport& viewport() { return *viewport_; }
    SliceView& slices(slices::Orientation orientation) { return panes_->slices(orientation); }
    SlicePair& pair(slices::Orientation orientation) { return panes_->pair(orientation); }
    PaneGrid& panes() { return panes_->grid(); }
    PlanarController& images() { return *planar_; }  // as they are
    HangingController& hanging() { return *hanging_; }
    DocumentsController& documents() { return *documents_; }
    SecondVolumeLoader& secondVolume();
    DoseController& dose() { return *dose_; }
    // The last error; the notes on the study. Empty without one, or after it was dismissed.
    QString message() const { return notifications_->text(); }
    QString notes() const { return notes_->text(); }
    QString description() const { return status_->description(); }  // of the open study
    QString voxels() const { return status_->voxels(); }            // of the open study
    QString rate() const { return status_->rate(); }          // pixels, and pictures per second in motion
    QString fidelity() const { return status_->fidelity(); }  // how the picture was made
    QString badge() const { return status_->badge(); }        // final or preliminary
    QString modelState() const { return status_->model(); }   // the state of the peripheral model
    const Settings& settings() const { return settings_->settings(); }
    void takeSettings(const Settings& settings) { settings_->take(settings); }  // applies and stores them
    void tell(const Error& error) { notifications_->showError(error); }
    // Null if nothing is kept.
    live::StudyKeeper* keeper() { return keeper_.get(); }
    bool hasStudy() const { return session_.hasStudy(); }
    StudyEditor& session() { return session_; }
    // See StateController.
    scene::StudyState state() const { return states_->state(); }
    Result<void> setState(const scene::StudyState& state) { return states_->setState(state); }
    bool keepStateNow() { return states_->keepNow(); }
    bool hidesSomething() const { return shown_->hidesSomething(); }
    bool isWriting() const { return !quit_->unfinished().isEmpty(); }  // a picture or movie; quitting asks

  Q_SIGNALS:
    void frameShown(const macula::live::FrameShown& frame);
    void studyShown();
    void loadingCancelled();
    void failed(const macula::Error& error);
    void headsetEnded();  // the headset's session ended, or could not begin

  protected:
    bool event(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;  // asks while something is being written
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void makeStudy();
    void makePanels();
    void makeOthers();
    void makeMenus();
    void makeFileMenu();
    void makeEditMenu();
    void makeViewMenu();
    void makeToolBar();
    void makeStatusBar();
    void connectSettings();
    void connectStudy();
    void connectViewport();
    void connectImages();
    bool showImagesInstead();
    void place();
    void showNames(bool shown);

    MainWindowOptions options_;
    // The open study and its choices, without the camera, which the viewport has. Its preset may differ from
    // that of `options_`.
    StudyEditor session_;
    std::shared_ptr<live::StudyKeeper> keeper_;  // null: nothing is kept

    Notifications* notifications_;
    StudyNotes* notes_;
    FileDialogs* files_;
    ShownVolume* shown_;
    Viewport* viewport_;
    WindowContext context_;
    SettingsController* settings_;
    StateController* states_ = nullptr;
    OpeningController* opening_ = nullptr;
    PanesController* panes_ = nullptr;
    PlanarController* planar_ = nullptr;
    HangingController* hanging_ = nullptr;
    PhasesController* phases_ = nullptr;
    std::weak_ptr<const study::FoundVolumes> foundBefore_;  // in the list, when the last opening began
    PanelsController* panels_ = nullptr;
    UndoActions* undo_ = nullptr;
    TableController* table_ = nullptr;
    LightsController* lights_ = nullptr;
    ClipsController* clips_ = nullptr;
    PickController* pick_ = nullptr;
    PresetsController* presets_ = nullptr;
    TransferFunctionEditor* transfer_ = nullptr;
    SegmentationsController* segmentations_ = nullptr;
    CurveController* curve_ = nullptr;
    SegmentingController* segmenting_ = nullptr;
    ReadMarks* marks_ = nullptr;
    ArchiveController* archive_ = nullptr;
    LinksController* links_ = nullptr;
    ManifestsController* manifests_ = nullptr;
    BrowserController* browser_ = nullptr;
    DocumentsController* documents_ = nullptr;
    KeyImagesController* keyImages_ = nullptr;
    SecondVolumeController* second_ = nullptr;
    DoseController* dose_ = nullptr;
    QualityController* quality_ = nullptr;
    MoviesController* movies_ = nullptr;
    ModelsController* models_ = nullptr;
    HeadsetController* headset_ = nullptr;
    PicturesController* pictures_ = nullptr;
    PlanesController* planes_ = nullptr;
    PresentationsController* presentations_ = nullptr;
    SendController* send_ = nullptr;
    ViewsController* views_ = nullptr;
    MeasurementsController* measurements_ = nullptr;
    FollowUpController* followUp_ = nullptr;
    LookController* look_ = nullptr;
    View3dController* view3d_ = nullptr;
    StatusController* status_ = nullptr;
    WatchController* watch_ = nullptr;
    ReceiveController* receive_ = nullptr;
    QuitController* quit_ = nullptr;
    QAction* names_ = nullptr;
};

}  // namespace macula::viewer

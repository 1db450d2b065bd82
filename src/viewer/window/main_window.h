// The application's window.
#pragma once

#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include <QComboBox>
#include <QMainWindow>
#include <QStringList>
#include <QTimer>
#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "live/quality/calibration.h"
#include "live/store/model_keeper.h"
#include "scene/choice/catalogue.h"
#include "scene/drawing/projection_windows.h"
#include "scene/state/study_state.h"
#include "slices/slice_plane.h"
#include "study/list/study_tree.h"
#include "viewer/jobs/background_job.h"
#include "viewer/output/picture_export.h"
#include "viewer/pick/anatomy_pick.h"
#include "viewer/session/viewer_session.h"
#include "viewer/settings/last_folders.h"
#include "viewer/settings/settings.h"
#include "viewer/status/status_widgets.h"
#include "viewer/volume/shown_volume.h"
#include "viewer/volume/study_loader.h"
#include "viewer/volume/table_removal.h"
#include "viewer/window/choice_menu.h"
#include "viewer/window/volume_choice.h"

class QDockWidget;
class QFileDialog;
class QMenu;

namespace macula::app {
struct PresentationWish;
struct SoftcopyOnSlices;
}  // namespace macula::app

namespace macula::viewer {

class BesideBar;
class BesideStudy;
class ClipEditing;
class ClipPanel;
class ConvergeNow;
class CutTools;
class HeadsetMirror;
class HeadsetShow;
class LightsDesk;
class ModelExport;
class MovieExport;
class MoviePanel;
class OwnWindowList;
class PaneGrid;
class PictureDialog;
class PresentationFiles;
class PresetBox;
class PresetGallery;
class PresetLibrary;
class QualityControl;
class RecentMenu;
class ScissorTool;
class SegmentationKeeper;
class SegmentationPanel;
class SlicePair;
class SliceView;
class StudyBrowser;
class ToolBox;
class TransferFunctionEditor;
class UndoActions;
class VoxelCutting;
enum class Pane;
struct HeadsetChoice;
struct LibraryPreset;

// What comes back of a study that was seen before, and is kept for the next time.
enum class Restores {
    all,
    work,  // measurements and how slices were shown: the rest is as it was asked for
    nothing,
};

struct MainWindowOptions {
    app::Catalogue catalogue;
    std::string device = {};                              // as in gpu::chooseDevice
    std::shared_ptr<const TransferFunction> preset = {};  // null: by the volume's modality
    std::shared_ptr<const trace::LightRig> lights = {};   // null: the default lights of each look
    std::optional<ViewDirection> firstView = {};          // nothing: app::usualView
    app::Layout layout = app::Layout::fourPanes;
    QSize pictureSize{960, 720};  // of the volume alone; with slices, of the window
    std::uint32_t sampleLimit = 512;
    bool usesModel = true;  // of splats, while a hand moves
    bool namesPatient =
        true;  // over the picture, in the title and beside the presets, until somebody hides it
    // Where models, and how studies were left, are kept for the next time. Nothing: nowhere.
    std::optional<std::filesystem::path> sessions = {};
    std::optional<int> keepDays = {};  // what was not opened for so long is deleted there; nothing: never
    bool calibrates = false;           // measures in the background how fast this machine is, once
    Restores restores = Restores::all;
    bool choosesSize = false;  // pictureSize counts more than where the window was left
    bool keepsLayout = false;  // as above, whatever a study was left with
    Settings settings = {};
    std::optional<std::filesystem::path> settingsFile = {};  // where they are kept; nothing: nowhere
    bool showsInHeadset = false;                             // the first study that is shown
};

// Menus, choices, the viewport, and what is known about the picture in it. Nothing here waits: folders are
// read by a StudyLoader, pictures are made by the viewport's render thread.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    MainWindow(gpu::Instance instance, MainWindowOptions options);
    ~MainWindow() override;  // waits until what was learnt is saved

    void open(app::StudySource source);
    // What open() ends with when all went well.
    void showStudy(const app::OpenedStudy& study);
    void cancelLoading() { loader_.cancel(); }
    bool loading() const { return loader_.loading(); }
    SegmentationKeeper& segments() { return *segments_; }
    bool searchingTable() const { return table_->searching(); }
    bool cutting() const;  // with the scissors
    // Over the 3D picture.
    ScissorTool& scissors() { return *scissors_; }
    bool loaderAtRest() const { return loader_.atRest(); }

    Viewport& viewport() { return *viewport_; }
    SliceView& slices(slices::Orientation orientation) { return *slices_.at(std::size_t(orientation)); }
    PaneGrid& panes() { return *panes_; }
    BesideStudy& beside() { return *beside_; }  // the second volume
    SlicePair& pair(slices::Orientation orientation) { return *pairs_.at(std::size_t(orientation)); }
    // What went wrong last; what is to be known about the study. Empty when there is nothing, or dismissed.
    QString message() const { return messages_->isVisible() ? messages_->text() : QString(); }
    QString notes() const { return notes_->isVisible() ? notes_->text() : QString(); }
    QString description() const { return description_->fullText(); }  // of the study on screen
    QString voxels() const { return volumeText_->fullText(); }        // of it
    QString rate() const { return pictureText_->fullText(); }   // pixels, and pictures per second in motion
    QString fidelity() const { return fidelity_->fullText(); }  // how true the picture is
    QString badge() const { return badge_->text(); }            // the same in a word
    const Settings& settings() const { return options_.settings; }
    void takeSettings(const Settings& settings);  // uses them, and keeps them
    void tell(const Error& error) { messages_->showError(error); }
    // Null where nothing is kept.
    app::ModelKeeper* keeper() { return keeper_.get(); }
    QString modelState() const { return modelText_->fullText(); }  // what the peripheral model is doing
    bool hasStudy() const { return session_.hasStudy(); }
    ViewerSession& session() { return session_; }
    // All that was chosen, with the camera of now; and another one of the same study. usage when none is
    // open, inputNotUsable when it was saved of another series.
    app::StudyState state() const;
    Result<void> setState(const app::StudyState& state);
    bool hidesSomething() const { return shown_->hidesSomething(); }
    // What was chosen and measured, before the program is ended: returns once it is kept, or false after some
    // seconds in which it was not.
    bool keepStateNow();
    bool isWriting() const { return !unfinishedWork().isEmpty(); }  // a picture, a movie: quitting asks

  signals:
    void frameShown(const macula::app::FrameShown& frame);
    void studyShown();
    void loadingCancelled();
    void failed(const macula::Error& error);
    void headsetEnded();  // or could not be begun

  protected:
    bool event(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;  // asks while something is being written
    void keyPressEvent(QKeyEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void makePanes();
    void makePanels();
    void makeClipTools();
    void makeLights();
    void connectCutting();
    QWidget* makeClipColumn();
    void addClipActions(QMenu& menu);
    void addClipPanel(QDockWidget& dock);
    void makePresets();
    void makePresetMenu();
    void fillPresetMenu(QMenu& menu);
    void makeBeside();
    void makeBesideBar();
    void addBesideToFile(QMenu& file);
    void addBesideToView(QMenu& view);
    void askForBeside(int mode);  // a QFileDialog::FileMode
    void showBeside();
    QStringList besideNotes() const;  // what is to be known of the second volume
    void makeMenus();
    void makeFileMenu();
    void makeEditMenu();
    void makeViewMenu();
    void addView3dActions(QMenu& view);
    void makeLookMenu();
    void makeClipMenu();
    void makeToolBar();
    void makeStatusBar();
    void makeQuality();
    void addQualityActions(QMenu& view);
    void calibrate();
    void onCalibrated(const Result<app::Calibration>& measured);
    void convergeNow();
    void showCost();  // of frames in motion, in this window
    void makeMovies();
    void makeHeadset();
    void addHeadsetAction(QMenu& view);
    void showInHeadset();
    void takeFromHeadset(const HeadsetChoice& choice);
    void addOutputActions(QMenu& file);
    void askWhereToDrawMovie();
    void askForPath();
    void askWhereToSavePath();
    void askWhereToSaveModel();
    bool hasPictureFor(const QString& what);
    void connectLoader();
    void connectBrowser();
    void showFound(const std::shared_ptr<const app::FoundVolumes>& found, std::optional<std::size_t> open);
    void connectTable();
    void connectSegments();
    const app::Catalogue& catalogue() const { return session_.catalogue(); }
    const app::OpenedStudy& study() const { return session_.study(); }
    void onChanged(const app::StudyState& before);
    void redraw();      // what was chosen has changed
    void showChosen();  // in menus and lists
    std::shared_ptr<app::ModelKeeper> makeKeeper();
    // Empty: nothing comes back.
    std::optional<app::StudyState> stateAsLeft(const app::OpenedStudy& study);
    app::StudyState stateToKeep() const;
    void connectKeeping();
    void beginToKeep();
    void keepState();
    void showAfresh();
    std::shared_ptr<const TransferFunction> usualPreset(const Volume& volume) const;
    void openView(const QString& path);
    void saveView(const QString& path, const std::string& json);
    void askForView();
    void askWhereToSaveView();
    void connectExport();
    void connectQuit();
    QStringList unfinishedWork() const;  // that quitting would lose: sentences
    void connectPick();
    void addPresentationsTo(QMenu& file);
    void askForPresentation();
    void openPresentation(const std::filesystem::path& path);  // of the 3D view of what is open
    void connectListedPresentations();
    void showListed(const app::StudyRow::Presentation& listed);
    void showOnSlices(const app::SoftcopyOnSlices& shown, const QStringList& notes);
    void askHowToSavePresentation();
    void askWhereToSavePresentation(app::PresentationWish wish);
    void askForPicture();
    void askWhereToSavePicture(const PictureDialog& how);
    void openFound(std::size_t index);  // another volume of the folder
    void askForFolder();
    void askForFile();
    void ask(QFileDialog* dialog, FolderKind kind, std::function<void(const QString&)> then);
    void keepFolders();
    void sawStudy(const QString& path);  // its folder: see LastFolders
    void openDropped(const Dropped& what);
    void usePreset(const LibraryPreset& preset);
    void askForPresetFile();
    void askWhereToExportPreset(const LibraryPreset& preset);
    void comparePreset(const LibraryPreset& preset);
    void showOpenError(const Error& error);
    void onRendered(const app::RenderEvent& event);
    void onFrame(const app::FrameShown& frame);
    void onModel(const hybrid::ModelNews& model);
    // Title, task bar, tool bar and status line: of the study that is open, whatever panes there are.
    void showStudyTexts();
    void tellOfPicture();  // in 3D, in the status line
    void tellOfFrame(const app::FrameShown& frame);
    void explainTabs();
    void showPanes();  // of the state
    void favourPane(std::optional<slices::Orientation> orientation);
    void focusPicture();  // the pane that had the keyboard last, or one that is shown
    void showNames(bool shown);
    void setCine(bool plays);  // of the slices that are looked at
    void askWhereToSavePreset();
    void askWhereToSaveMeasurements();
    void tellOfFile(const Result<void>& written, const QString& told);
    void showNotes();
    void triggerShortcut(QKeyEvent* event);
    void useKeys();
    void askForSettings();

    MainWindowOptions options_;
    StudyLoader loader_;
    // What is open, and what was chosen for it. The camera is the viewport's. Its preset need not be the one
    // asked for.
    ViewerSession session_;
    QStringList studyNotes_;  // what is to be known about it
    QString presetNote_;      // and about the preset that was chosen for it
    QString visibilityNote_;  // and why nothing of it can be seen
    QString pictureNote_;     // and about what the device shows of it
    QString deviceNote_;      // and about the device
    bool deviceIsBack_ = true;
    bool pictureFailed_ = false;                // in 3D, of what is open
    std::shared_ptr<app::ModelKeeper> keeper_;  // null: nothing is kept
    // The state that it was given last, or that the study was shown in: what nobody has changed is not kept,
    // and takes the place of nothing that came too late or cannot be read.
    std::optional<app::StudyState> kept_;
    // Its text, or that which was read: what this window's changes are made to. See ModelKeeper::keepState.
    std::shared_ptr<std::string> keptText_;
    QString sessionNote_;          // how this study comes back
    QString storeNote_;            // and what went wrong with the store
    bool storeNoteIsNew_ = false;  // it came with the study that is being opened
    QTimer keeps_;
    QTimer keepsChange_;                              // soon
    QTimer prepares_;                                 // for so long that it is worth a word
    QString preparing_;                               // which
    bool isFirstStart_ = false;                       // app::DeviceReady
    LastFolders folders_{options_.settings.folders};  // of file dialogs

    ShownVolume* shown_ = nullptr;
    Viewport* viewport_ = nullptr;
    std::array<SliceView*, 3> slices_{};  // by slices::Orientation
    std::array<SlicePair*, 3> pairs_{};   // the same, with those of the second volume
    BesideStudy* beside_ = nullptr;
    BesideBar* besideBar_ = nullptr;
    QList<QAction*> besideActions_;  // that need a second volume
    WorkBar* besideWork_ = nullptr;
    PaneGrid* panes_ = nullptr;
    ToolBox* tools_ = nullptr;
    UndoActions* undo_ = nullptr;
    TransferFunctionEditor* transfer_ = nullptr;
    LightsDesk* lightsDesk_ = nullptr;
    ClipPanel* clipPanel_ = nullptr;
    ClipEditing* clipEditing_ = nullptr;
    CutTools* cutTools_ = nullptr;
    ScissorTool* scissors_ = nullptr;
    VoxelCutting* cutting_ = nullptr;
    WorkBar* cuttingBar_ = nullptr;
    SegmentationPanel* segmentsPanel_ = nullptr;
    StudyBrowser* browser_ = nullptr;
    RecentMenu* recent_ = nullptr;
    QAction* browserShown_ = nullptr;  // shows and hides it
    QList<QAction*> panels_;           // show and hide them
    std::optional<Pane> lastPane_;
    MessageBar* notes_ = nullptr;  // stay while other studies are loaded, and when that fails
    MessageBar* messages_ = nullptr;
    WorkBar* loading_ = nullptr;
    TableRemoval* table_ = nullptr;
    WorkBar* searching_ = nullptr;  // for the table
    SegmentationKeeper* segments_ = nullptr;
    WorkBar* segmenting_ = nullptr;  // segments are loaded
    PictureExport* export_ = nullptr;
    PresentationFiles* presentations_ = nullptr;
    // To be shown once its series is there.
    struct AwaitedPresentation {
        std::shared_ptr<const app::FoundVolumes> found;
        app::StudyRow::Presentation listed;
    };
    std::optional<AwaitedPresentation> awaiting_;
    WorkBar* exporting_ = nullptr;
    AnatomyPick* pick_ = nullptr;
    OwnWindowList* ownWindows_ = nullptr;
    QualityControl* quality_ = nullptr;
    BackgroundJob<app::Calibration> calibration_;
    ConvergeNow* converge_ = nullptr;
    WorkBar* converging_ = nullptr;
    QAction* stopConverging_ = nullptr;
    MoviePanel* movie_ = nullptr;
    MovieExport* movieExport_ = nullptr;
    WorkBar* filming_ = nullptr;
    HeadsetShow* headset_ = nullptr;
    HeadsetMirror* mirror_ = nullptr;
    bool isMirrored_ = false;                  // a picture of the headset has come
    bool isFromHeadset_ = false;               // what changes now
    std::shared_ptr<const Clip> headsetClip_;  // that is shown there
    bool quitsWhenDone_ = false;               // with what is being written
    ModelExport* modelExport_ = nullptr;
    WorkBar* savingModel_ = nullptr;
    ChoiceMenu* looks_ = nullptr;
    QAction* shading_ = nullptr;
    QAction* resetWindow_ = nullptr;
    ChoiceMenu* clips_ = nullptr;
    QAction* names_ = nullptr;
    VolumeChoice* volumes_ = nullptr;
    QAction* volumesInBar_ = nullptr;  // shows and hides it
    QTimer rateEnds_;                  // nothing has been shown for a while
    PresetLibrary* presetLibrary_ = nullptr;
    PresetGallery* gallery_ = nullptr;
    PresetBox* presets_ = nullptr;
    QComboBox* lights_ = nullptr;
    ElidingLabel* description_ = nullptr;
    ElidingLabel* fidelity_ = nullptr;
    FidelityBadge* badge_ = nullptr;
    ElidingLabel* volumeText_ = nullptr;
    ElidingLabel* modelText_ = nullptr;
    ElidingLabel* pictureText_ = nullptr;
    ElidingLabel* deviceText_ = nullptr;
};

}  // namespace macula::viewer

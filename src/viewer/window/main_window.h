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
#include "live/store/study_keeper.h"
#include "scene/choice/catalogue.h"
#include "scene/drawing/projection_windows.h"
#include "scene/state/study_state.h"
#include "slices/slice_plane.h"
#include "study/list/study_tree.h"
#include "viewer/editor/study_editor.h"
#include "viewer/jobs/background_job.h"
#include "viewer/output/picture_export.h"
#include "viewer/pick/anatomy_pick.h"
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

namespace macula::scene {
struct PresentationRequest;
struct SoftcopyOnSlices;
}  // namespace macula::scene

namespace macula::viewer {

class SecondVolumeBar;
class SecondVolumeLoader;
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
struct HeadsetSelection;
struct LibraryPreset;

// How much of a study's state is restored, and kept for the next time.
enum class Restores {
    all,
    work,  // measurements and slice display; options decide the rest
    nothing,
};

struct MainWindowOptions {
    scene::Catalogue catalogue;
    std::string device = {};                              // as in gpu::chooseDevice
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
    std::optional<int> keepDays = {};  // deletes what was unopened for longer; nothing: never
    bool calibrates = false;           // measures this machine's speed once, in the background
    Restores restores = Restores::all;
    bool choosesSize = false;  // pictureSize overrides the window's last place
    bool keepsLayout = false;  // `layout` overrides that of a restored study
    Settings settings = {};
    std::optional<std::filesystem::path> settingsFile = {};  // where to keep them; nothing: not kept
    bool showsInHeadset = false;                             // shows the first study in a headset
};

// Menus, choices, the viewport, and texts about its picture. Nothing here blocks: a StudyLoader reads
// folders, the viewport's render thread makes pictures.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    MainWindow(gpu::Instance instance, MainWindowOptions options);
    ~MainWindow() override;  // waits until learnt models are saved

    void open(study::StudySource source);
    // open() ends with this when it succeeds.
    void showStudy(const study::OpenedStudy& study);
    void cancelLoading() { loader_.cancel(); }
    bool loading() const { return loader_.loading(); }
    SegmentationKeeper& segments() { return *segments_; }
    bool searchingTable() const { return table_->searching(); }
    bool cutting() const;  // the scissors' mask is being computed
    // The scissors over the 3D picture.
    ScissorTool& scissors() { return *scissors_; }
    bool loaderAtRest() const { return loader_.atRest(); }

    Viewport& viewport() { return *viewport_; }
    SliceView& slices(slices::Orientation orientation) { return *slices_.at(std::size_t(orientation)); }
    PaneGrid& panes() { return *panes_; }
    SecondVolumeLoader& secondVolume() { return *secondVolume_; }  // the second volume
    SlicePair& pair(slices::Orientation orientation) { return *pairs_.at(std::size_t(orientation)); }
    // The last error; the notes on the study. Empty without one, or after it was dismissed.
    QString message() const { return messages_->isVisible() ? messages_->text() : QString(); }
    QString notes() const { return notes_->isVisible() ? notes_->text() : QString(); }
    QString description() const { return description_->fullText(); }  // of the open study
    QString voxels() const { return volumeText_->fullText(); }        // of it
    QString rate() const { return pictureText_->fullText(); }   // pixels, and pictures per second in motion
    QString fidelity() const { return fidelity_->fullText(); }  // how the picture was made
    QString badge() const { return badge_->text(); }            // the same in a word
    const Settings& settings() const { return options_.settings; }
    void takeSettings(const Settings& settings);  // applies and stores them
    void tell(const Error& error) { messages_->showError(error); }
    // Null if nothing is kept.
    live::StudyKeeper* keeper() { return keeper_.get(); }
    QString modelState() const { return modelText_->fullText(); }  // the state of the peripheral model
    bool hasStudy() const { return session_.hasStudy(); }
    StudyEditor& session() { return session_; }
    // The session's state with the current camera; setState takes one of the same study. usage without a
    // study, inputNotUsable for a state of another series.
    scene::StudyState state() const;
    Result<void> setState(const scene::StudyState& state);
    bool hidesSomething() const { return shown_->hidesSomething(); }
    // Stores choices and measurements before the program ends. Returns true once stored, false after some
    // seconds without success.
    bool keepStateNow();
    bool isWriting() const { return !unfinishedWork().isEmpty(); }  // a picture or movie; quitting asks

  signals:
    void frameShown(const macula::live::FrameShown& frame);
    void studyShown();
    void loadingCancelled();
    void failed(const macula::Error& error);
    void headsetEnded();  // or could not begin

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
    void makeSecondVolume();
    void makeSecondVolumeBar();
    void addSecondToFile(QMenu& file);
    void addSecondToView(QMenu& view);
    void askForSecond(int mode);  // a QFileDialog::FileMode
    void showSecond();
    QStringList besideNotes() const;  // notes on the second volume
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
    void onCalibrated(const Result<live::Calibration>& measured);
    void convergeNow();
    void showCost();  // of frames in motion, in this window
    void makeMovies();
    void makeHeadset();
    void addHeadsetAction(QMenu& view);
    void showInHeadset();
    void takeFromHeadset(const HeadsetSelection& choice);
    void addOutputActions(QMenu& file);
    void askWhereToDrawMovie();
    void askForPath();
    void askWhereToSavePath();
    void askWhereToSaveModel();
    bool hasPictureFor(const QString& what);
    void connectLoader();
    void connectBrowser();
    void showFound(const std::shared_ptr<const study::FoundVolumes>& found, std::optional<std::size_t> open);
    void connectTable();
    void connectSegments();
    const scene::Catalogue& catalogue() const { return session_.catalogue(); }
    const study::OpenedStudy& study() const { return session_.study(); }
    void onChanged(const scene::StudyState& before);
    void redraw();      // call after a choice has changed
    void showChosen();  // in menus and lists
    std::shared_ptr<live::StudyKeeper> makeKeeper();
    // Nothing: the state is not restored.
    std::optional<scene::StudyState> stateAsLeft(const study::OpenedStudy& study);
    scene::StudyState stateToKeep() const;
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
    QStringList unfinishedWork() const;  // sentences: work that quitting would lose
    void connectPick();
    void addPresentationsTo(QMenu& file);
    void askForPresentation();
    void openPresentation(const std::filesystem::path& path);  // a 3D view of the open study
    void connectListedPresentations();
    void showListed(const study::StudyRow::Presentation& listed);
    void showOnSlices(const scene::SoftcopyOnSlices& shown, const QStringList& notes);
    void askHowToSavePresentation();
    void askWhereToSavePresentation(scene::PresentationRequest request);
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
    void onRendered(const live::RenderEvent& event);
    void onFrame(const live::FrameShown& frame);
    void onModel(const hybrid::ModelNews& model);
    // Updates title, task bar, tool bar and status line for the open study.
    void showStudyTexts();
    void tellOfPicture();  // writes the status line of the 3D picture
    void tellOfFrame(const live::FrameShown& frame);
    void explainTabs();
    void showPanes();  // of the state
    void favourPane(std::optional<slices::Orientation> orientation);
    void focusPicture();  // the pane that last had the focus, or a shown one
    void showNames(bool shown);
    void setCine(bool plays);  // for the active slice pane, else for a shown one
    void askWhereToSavePreset();
    void askWhereToSaveMeasurements();
    void tellOfFile(const Result<void>& written, const QString& told);
    void showNotes();
    void triggerShortcut(QKeyEvent* event);
    void useKeys();
    void askForSettings();

    MainWindowOptions options_;
    StudyLoader loader_;
    // The open study and its choices. The viewport has the camera. Its preset may differ from the option.
    StudyEditor session_;
    QStringList studyNotes_;  // notes on the study
    QString presetNote_;      // on its preset
    QString visibilityNote_;  // on why nothing is visible
    QString pictureNote_;     // on what the device shows of it
    QString deviceNote_;      // on the device
    bool deviceIsBack_ = true;
    bool pictureFailed_ = false;                 // the 3D picture of the open study
    std::shared_ptr<live::StudyKeeper> keeper_;  // null: nothing is kept
    // The last state given to the keeper, or the state at opening: an unchanged state is not stored, so it
    // never replaces a stored state that came too late or cannot be read.
    std::optional<scene::StudyState> kept_;
    // Its JSON text, or the text read: the base of this window's changes. See StudyKeeper::keepState.
    std::shared_ptr<std::string> keptText_;
    QString sessionNote_;          // how this study was restored
    QString storeNote_;            // errors of the store
    bool storeNoteIsNew_ = false;  // it came while a study was being opened
    QTimer keeps_;
    QTimer keepsChange_;                              // soon
    QTimer prepares_;                                 // after this delay the status line says so
    QString preparing_;                               // what the device prepares
    bool isFirstStart_ = false;                       // live::DeviceReady
    LastFolders folders_{options_.settings.folders};  // of file dialogs

    ShownVolume* shown_ = nullptr;
    Viewport* viewport_ = nullptr;
    std::array<SliceView*, 3> slices_{};  // by slices::Orientation
    std::array<SlicePair*, 3> pairs_{};   // the same, with those of the second volume
    SecondVolumeLoader* secondVolume_ = nullptr;
    SecondVolumeBar* besideBar_ = nullptr;
    QList<QAction*> besideActions_;  // actions that need a second volume
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
    QList<QAction*> panels_;           // their toggle actions
    std::optional<Pane> lastPane_;
    MessageBar* notes_ = nullptr;  // stay while another study loads, and if that fails
    MessageBar* messages_ = nullptr;
    WorkBar* loading_ = nullptr;
    TableRemoval* table_ = nullptr;
    WorkBar* searching_ = nullptr;  // for the table
    SegmentationKeeper* segments_ = nullptr;
    WorkBar* segmenting_ = nullptr;  // while segments load
    PictureExport* export_ = nullptr;
    PresentationFiles* presentations_ = nullptr;
    // A presentation to show once its series is open.
    struct AwaitedPresentation {
        std::shared_ptr<const study::FoundVolumes> found;
        study::StudyRow::Presentation listed;
    };
    std::optional<AwaitedPresentation> awaiting_;
    WorkBar* exporting_ = nullptr;
    AnatomyPick* pick_ = nullptr;
    OwnWindowList* ownWindows_ = nullptr;
    QualityControl* quality_ = nullptr;
    BackgroundJob<live::Calibration> calibration_;
    ConvergeNow* converge_ = nullptr;
    WorkBar* converging_ = nullptr;
    QAction* stopConverging_ = nullptr;
    MoviePanel* movie_ = nullptr;
    MovieExport* movieExport_ = nullptr;
    WorkBar* filming_ = nullptr;
    HeadsetShow* headset_ = nullptr;
    HeadsetMirror* mirror_ = nullptr;
    bool isMirrored_ = false;                  // a picture of the headset has arrived
    bool isFromHeadset_ = false;               // the present change comes from the headset
    std::shared_ptr<const Clip> headsetClip_;  // the clip shown in the headset
    bool quitsWhenDone_ = false;               // quits when all files are written
    ModelExport* modelExport_ = nullptr;
    WorkBar* savingModel_ = nullptr;
    ChoiceMenu* looks_ = nullptr;
    QAction* shading_ = nullptr;
    QAction* resetWindow_ = nullptr;
    ChoiceMenu* clips_ = nullptr;
    QAction* names_ = nullptr;
    VolumeChoice* volumes_ = nullptr;
    QAction* volumesInBar_ = nullptr;  // shows and hides it
    QTimer rateEnds_;                  // fires after a pause without frames
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

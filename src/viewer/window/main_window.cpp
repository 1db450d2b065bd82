#include "viewer/window/main_window.h"

#include <QAction>
#include <QDockWidget>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <chrono>
#include <utility>

#include "study/spool/spool.h"
#include "viewer/archive/archive_controller.h"
#include "viewer/archive/archive_panel.h"
#include "viewer/archive/read_marks.h"
#include "viewer/archive/send_controller.h"
#include "viewer/archive/waiting_bar.h"
#include "viewer/browser/browser_controller.h"
#include "viewer/browser/recent_menu.h"
#include "viewer/browser/study_browser.h"
#include "viewer/clip/clip_handles_tool.h"
#include "viewer/clip/clips_controller.h"
#include "viewer/clip/scissor_tool.h"
#include "viewer/curve/curve_controller.h"
#include "viewer/curve/curve_panel.h"
#include "viewer/documents/documents_controller.h"
#include "viewer/documents/key_images_controller.h"
#include "viewer/dose/dose_controller.h"
#include "viewer/dose/dose_panel.h"
#include "viewer/editor/undo_actions.h"
#include "viewer/followup/follow_up_controller.h"
#include "viewer/hanging/hanging_controller.h"
#include "viewer/headset/headset_controller.h"
#include "viewer/headset/headset_mirror.h"
#include "viewer/jobs/post.h"
#include "viewer/keys/focus_order.h"
#include "viewer/keys/keys.h"
#include "viewer/lights/lights_controller.h"
#include "viewer/links/links_controller.h"
#include "viewer/links/manifests_controller.h"
#include "viewer/look/look_controller.h"
#include "viewer/look/view3d_controller.h"
#include "viewer/output/models_controller.h"
#include "viewer/output/movies_controller.h"
#include "viewer/output/pictures_controller.h"
#include "viewer/output/planes_controller.h"
#include "viewer/output/presentations_controller.h"
#include "viewer/output/views_controller.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/panes/panels_controller.h"
#include "viewer/panes/tool_box.h"
#include "viewer/panes/usual_layouts.h"
#include "viewer/phases/phase_bar.h"
#include "viewer/phases/phases_controller.h"
#include "viewer/pick/distance_in_3d.h"
#include "viewer/pick/pick_controller.h"
#include "viewer/planar/planar_controller.h"
#include "viewer/planar/planar_presenting.h"
#include "viewer/presets/preset_gallery.h"
#include "viewer/presets/presets_controller.h"
#include "viewer/quality/quality_controller.h"
#include "viewer/receive/receive_controller.h"
#include "viewer/second/second_volume_controller.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/segmentation/label_map_opener.h"
#include "viewer/segmentation/segmentation_panel.h"
#include "viewer/segmentation/segmentations_controller.h"
#include "viewer/segmenting/segmenting_controller.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/settings/window_place.h"
#include "viewer/slices/measurement_list.h"
#include "viewer/slices/measurements_controller.h"
#include "viewer/status/status_widgets.h"
#include "viewer/transfer/transfer_function_editor.h"
#include "viewer/volume/table_controller.h"
#include "viewer/watch/arrival_bar.h"

namespace macula::viewer {

namespace {

// Null: nothing is kept. Errors arrive on another thread, and reach the thread of `home` through its queue.
std::shared_ptr<live::StudyKeeper> keeperFor(const MainWindowOptions& options, QObject* home,
                                             const std::function<void(const Error&)>& tell) {
    if (!options.sessions) return nullptr;
    std::optional<std::chrono::days> retention;
    if (options.keepDays) retention.emplace(*options.keepDays);
    return std::make_shared<live::StudyKeeper>(
        session::StoreOptions{.folder = *options.sessions,
                              .modelCapBytes = std::uint64_t(options.settings.modelCapMb) * 1'000'000},
        [home, tell](const Error& error) { post(home, [tell, error] { tell(error); }); }, retention);
}

}  // namespace

MainWindow::MainWindow(gpu::Instance instance, MainWindowOptions options)
    : options_(std::move(options)),
      session_(options_.catalogue),
      keeper_(keeperFor(options_, this, [this](const Error& error) { opening_->tellOfStore(error); })),
      notifications_(new Notifications(this)),
      notes_(new StudyNotes(this)),
      files_(new FileDialogs(*this, options_.settings.folders)),
      shown_(new ShownVolume(session_, this)),
      viewport_(new Viewport(std::move(instance), options_.device, keeper_)),
      context_{.window = *this,
               .session = session_,
               .shown = *shown_,
               .viewport = *viewport_,
               .notifications = *notifications_,
               .notes = *notes_,
               .files = *files_,
               .focusPicture = [this] { panes_->focusPicture(); },
               .device = options_.device},
      settings_(new SettingsController(*this, *notifications_, options_.settings, options_.settingsFile)) {
    session_.show({}, {.lights = options_.lights, .layout = options_.layout});
    setAcceptDrops(true);

    makeStudy();
    makePanels();
    makeOthers();
    makeMenus();
    makeToolBar();
    makeStatusBar();
    second_->addBars();
    connectSettings();
    connectStudy();
    connectViewport();
    connectImages();
    new FocusOfGreyed(*this, context_.focusPicture);
    settings_->useKeys();
    showNames(options_.namesPatient && options_.settings.showsNames);
    panes_->showLayout();
    view3d_->redraw();
    place();
    context_.focusPicture();
}

// The order of construction is the Tab order, and the order in which the features get the session's signals;
// showStudy() and connectStudy() set the rest.
void MainWindow::makeStudy() {
    const auto* layouts = new UsualLayouts(session_, *settings_, this);
    states_ =
        new StateController(context_,
                            {.preset = options_.preset,
                             .lights = options_.lights,
                             .restores = options_.restores,
                             .keepsLayout = options_.keepsLayout,
                             .usualLayout = [layouts](const Volume& volume) { return layouts->of(volume); }},
                            keeper_.get());
    opening_ = new OpeningController(context_, *states_, keeper_);
    panes_ = new PanesController(context_);
    planar_ = new PlanarController(context_, panes_->grid());
    hanging_ = new HangingController(context_, *planar_, options_.sessions);
    phases_ = new PhasesController(context_, *opening_, panes_->allSlices());
    undo_ = new UndoActions(session_, this);
    table_ = new TableController(context_);
    table_->endAt(undo_->undo());
    table_->endAt(undo_->redo());
    lights_ = new LightsController(context_);
    clips_ = new ClipsController(context_, panes_->allSlices(), shown_->cutting());
    pick_ = new PickController(context_, clips_->scissors());
    viewport_->setTools({&clips_->scissors(), &lights_->tool(), &clips_->handles(), &pick_->distance()});

    watch_ = new WatchController(context_, *opening_, options_.settings.watchedFolders, options_.watchPace);

    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(&panes_->grid(), 1);
    column->addWidget(&planar_->widget(), 1);
    column->addWidget(&phases_->bar());
    column->addWidget(&watch_->bar());
    column->addWidget(&notes_->bar());
    column->addWidget(&notifications_->bar());
    setCentralWidget(centre);
}

void MainWindow::makePanels() {
    constexpr auto kRight = Qt::RightDockWidgetArea;
    const auto key = [](int panel) {
        return QKeySequence(QString::fromLatin1(kPanelKeys[std::size_t(panel)]));
    };
    panels_ = new PanelsController(*this);
    presets_ = new PresetsController(context_, keeper_, [this] { return state(); });
    transfer_ = new TransferFunctionEditor(session_);
    connect(transfer_, &TransferFunctionEditor::saveAsked, &presets_->gallery(),
            &PresetGallery::askToSaveCurve);
    segmentations_ = new SegmentationsController(context_, shown_->segments(), panes_->allSlices());
    opening_->setDropTaken([this](const QString& path) {
        return segmentations_->labelMaps().takesDropped(path,
                                                        [this, path] { opening_->open(path.toStdString()); });
    });
    segmenting_ = new SegmentingController(context_, {.keeper = shown_->segments(),
                                                      .list = segmentations_->panel(),
                                                      .slices = panes_->allSlices(),
                                                      .store = keeper_.get()});
    segmenting_->setToolAction(*panes_->tools().findChild<QAction*>(QStringLiteral("slice-tool-segment")));
    browser_ = new BrowserController(context_, *opening_, keeper_.get());
    QDockWidget* studies =
        panels_->add(Qt::LeftDockWidgetArea, &browser_->browser(), tr("Studies"), "studies-panel", key(0));
    browser_->setShownAction(*studies->toggleViewAction());
    documents_ = new DocumentsController(
        context_, {.opening = *opening_, .browser = browser_->browser(), .images = *planar_});
    keyImages_ =
        new KeyImagesController(context_, {.documents = *documents_, .browser = browser_->browser()});
    archive_ = new ArchiveController(
        context_, {.opening = *opening_, .settings = *settings_, .recent = browser_->recent()});
    marks_ = new ReadMarks(keeper_, this);
    archive_->setMarks(marks_);
    QDockWidget* archive =
        panels_->add(Qt::LeftDockWidgetArea, &archive_->panel(), tr("Archive"), "archive-panel");
    archive_->setShownAction(*archive->toggleViewAction());
    panels_->sharePlace(studies, archive);
    links_ = new LinksController(context_, *archive_);
    manifests_ = new ManifestsController(context_, *opening_);
    QDockWidget* first = panels_->add(kRight, transfer_, tr("Transfer Function"), "transfer-panel", key(1));
    QDockWidget* second = panels_->add(kRight, clips_->makePanel(), tr("Clip"), "clip-panel", key(2));
    clips_->setDock(*second);
    splitDockWidget(first, second, Qt::Vertical);
    QDockWidget* presets = panels_->add(kRight, &presets_->gallery(), tr("Presets"), "presets-panel", key(3));
    QDockWidget* segments = panels_->add(kRight, segmenting_->makePanel(), tr("Segmentations"),
                                         "segments-panel", QKeySequence(Qt::Key_F11));
    QDockWidget* lights = panels_->add(kRight, lights_->panel(), tr("Lights"), "lights-panel", key(4));
    lights_->setDock(*lights);
    curve_ = new CurveController(context_);
    connect(phases_, &PhasesController::shownOnSlices, &curve_->panel(), &CurvePanel::setPhase);
    panels_->add(Qt::BottomDockWidgetArea, &curve_->panel(), tr("Curved Plane"), "curve-dock",
                 keyOf(KeyAction::curve));
    panels_->add(kRight, new MeasurementList(session_), tr("Measurements"), "measurements-panel",
                 keyOf(KeyAction::measurementList));
    panels_->sharePlace(first, presets);
    panels_->sharePlace(second, segments);
    panels_->sharePlace(second, lights);
    panels_->sharePlace(segments, lights);
}

void MainWindow::makeOthers() {
    second_ = new SecondVolumeController(context_, *browser_, panes_->pairs());
    dose_ = new DoseController(context_, second_->loader());
    panels_->add(Qt::RightDockWidgetArea, &dose_->panel(), tr("Dose"), "dose-panel");
    archive_->setOpensBeside([this](const std::filesystem::path& folder) { second_->loader().open(folder); });
    receive_ = new ReceiveController(
        context_, {.settings = *settings_, .arrivals = watch_->bar(), .quiet = options_.watchPace.quiet});
    connect(receive_, &ReceiveController::studiesChanged, archive_, &ArchiveController::onStudiesReceived);
    quality_ = new QualityController(context_, options_.sampleLimit);
    panes_->shareOwnWindows(options_.sessions);
    if (options_.calibrates) quality_->calibrate(options_.sessions);
    movies_ = new MoviesController(context_);
    movies_->setDock(*panels_->add(Qt::RightDockWidgetArea, movies_->panel(), tr("Movie"), "movie-panel"));
    models_ = new ModelsController(context_);
    headset_ = new HeadsetController(context_);
    headset_->setDock(
        *panels_->add(Qt::RightDockWidgetArea, &headset_->mirror(), tr("Headset"), "headset-panel"));
    pictures_ = new PicturesController(context_, panes_->grid(), *settings_);
    planes_ = new PlanesController(context_, panes_->allSlices(), *settings_);
    measurements_ = new MeasurementsController(context_);
    followUp_ = new FollowUpController(context_, second_->loader(), keeper_.get());
    views_ = new ViewsController(context_, *states_);
    presentations_ = new PresentationsController(context_, {.opening = *opening_,
                                                            .states = *states_,
                                                            .browser = browser_->browser(),
                                                            .slices = panes_->allSlices()});
    send_ = new SendController(context_, {.archives = *archive_,
                                          .measurements = *measurements_,
                                          .opening = *opening_,
                                          .pictures = *pictures_,
                                          .presentations = *presentations_,
                                          .segmentations = *segmentations_,
                                          .settings = *settings_});
    centralWidget()->layout()->addWidget(send_->waiting());
    look_ = new LookController(context_);
    view3d_ = new View3dController(context_, *transfer_);
    status_ = new StatusController(context_, *panes_);
    quit_ = new QuitController(context_);
    quit_->waitFor(*pictures_);
    quit_->waitFor(*planes_);
    quit_->waitFor(*movies_);
    quit_->waitFor(*models_);
    quit_->waitFor(*measurements_);
    quit_->waitFor(*presentations_);
    quit_->waitFor(*segmentations_);
    quit_->waitFor(*segmenting_);
    quit_->waitFor(*send_);
}

void MainWindow::connectSettings() {
    const auto endDrag = [this] { viewport_->window().endDrag(); };
    connect(files_, &FileDialogs::aboutToOpen, this, endDrag);
    connect(files_, &FileDialogs::foldersChanged, settings_, &SettingsController::keepFolders);
    connect(watch_, &WatchController::foldersChanged, settings_, &SettingsController::keepWatched);
    connect(settings_, &SettingsController::aboutToAsk, this, endDrag);
    connect(settings_, &SettingsController::namesToggled, this,
            [this](bool shown) { showNames(options_.namesPatient && shown); });
}

void MainWindow::connectStudy() {
    opening_->connectOutcomes();
    connect(opening_, &OpeningController::loaded, this, &MainWindow::showStudy);
    connect(opening_, &OpeningController::cancelled, this, &MainWindow::loadingCancelled);
    connect(notifications_, &Notifications::failed, this, &MainWindow::failed);
    connect(this, &MainWindow::studyShown, archive_, &ArchiveController::onStudyShown);
    connect(this, &MainWindow::studyShown, documents_, &DocumentsController::onStudyShown);
    connect(this, &MainWindow::studyShown, movies_, &MoviesController::onStudyShown);
    connect(this, &MainWindow::studyShown, presentations_, &PresentationsController::onStudyShown);
    connect(this, &MainWindow::studyShown, manifests_, &ManifestsController::onStudyShown);
    connect(headset_, &HeadsetController::ended, this, &MainWindow::headsetEnded);
    if (options_.showsInHeadset)
        connect(this, &MainWindow::studyShown, headset_, &HeadsetController::begin, Qt::SingleShotConnection);
}

void MainWindow::connectImages() {
    connect(&browser_->browser(), &StudyBrowser::imagesChosen, this,
            [this](const dicom::Stack* stack) { planar_->show(browser_->browser().found(), stack); });
    connect(&browser_->browser(), &StudyBrowser::imagesPresented, this,
            [this](const study::StudyRow::Presentation& of) {
                planar_->show(browser_->browser().found(), of.images);
                planar_->presenting().choose(of.file);
            });
    connect(planar_, &PlanarController::shownChanged, this, [this] {
        phases_->setImagesShown(planar_->hidesPanes());
        status_->setImagesShown(planar_->identity());
        archive_->onImagesShown(planar_->identityOfNewest());
        panes_->tools().setEnabled(!planar_->hidesPanes());
        undo_->actOn(planar_->isInFront() ? &planar_->boxes() : nullptr);
        // The notes are about the open study.
        if (planar_->hidesPanes())
            notes_->bar().hide();
        else
            notes_->show();
    });
    connect(&planar_->boxes(), &ImageBoxes::stepsChanged, undo_, &UndoActions::update);
    pictures_->setInstead([this] { return planar_->savePicture(); });
    measurements_->setInstead({.save = [this] { return planar_->saveMeasurements(); },
                               .remove = [this] { return planar_->removeMeasurements(); }});
    if (options_.restores != Restores::nothing) {
        planar_->keepIn(keeper_);
        hanging_->keepIn(keeper_);
    }
    connect(&opening_->loader(), &StudyLoader::began, this,
            [this] { foundBefore_ = browser_->browser().found(); });
    opening_->setInstead([this] { return showImagesInstead(); });
    // What is listed of the open volume may be beneath images.
    connect(&browser_->browser(), &StudyBrowser::openChosen, planar_, &PlanarController::giveWay);
    connect(&browser_->browser(), &StudyBrowser::presentationChosen, planar_, &PlanarController::giveWay);
    connect(this, &MainWindow::studyShown, planar_, &PlanarController::onStudyShown);
    connect(this, &MainWindow::studyShown, hanging_, &HangingController::onStudyShown);
    connect(panes_, &PanesController::layoutShown, planar_, &PlanarController::giveWay);
}

// A folder without any volume is shown as what it holds, and so is an image that is opened itself.
bool MainWindow::showImagesInstead() {
    const auto& found = browser_->browser().found();
    // An opening that read no folder leaves the list as it was, which may be another patient's.
    const bool isNew = found && found->isWhole() && found != foundBefore_.lock();
    const study::StudySource& source = opening_->loader().source();
    if (isNew && source && documents_->openInstead(found, *source)) return true;
    if (!isNew) return false;
    const std::filesystem::path opened = source.value_or(std::filesystem::path());
    const study::PlanarSeries series = study::planarSeriesFor(*found, opened);
    if (series.stack == nullptr || (!found->volumes().empty() && !study::holds(series, opened))) return false;
    planar_->show(found, series.stack);
    // The folder of a fetched study has no name for people.
    if (source && source->parent_path() != study::spoolFolder()) browser_->recent().add(*source);
    return true;
}

void MainWindow::connectViewport() {
    connect(status_, &StatusController::frameShown, quality_, &QualityController::onFrame);
    connect(status_, &StatusController::frameShown, this, &MainWindow::frameShown);
    connect(viewport_, &Viewport::dropped, opening_, &OpeningController::openDropped);
    connect(viewport_, &Viewport::namesToggled, this, &MainWindow::showNames);
    connect(viewport_, &Viewport::keyNotHandled, this, [this](QKeyEvent* keys) {
        if (QAction* action = actionFor(*keys, *this, panes_->tools())) action->trigger();
    });
    viewport_->setSampleLimit(options_.sampleLimit);
    viewport_->setUsesModel(options_.usesModel);
}

void MainWindow::place() {
    if (options_.layout != scene::Layout::volume) {
        resize(options_.pictureSize);
    } else {
        viewport_->setPictureSizeHint(options_.pictureSize);
        resize(minimumSizeHint());  // sizeHint() is never narrower than the tool bar
    }
    if (!options_.choosesSize) placeWindow(*this, options_.settings.windowPlace);
    new WindowPlace(*this, [this](const QString& place) { settings_->keepWindowPlace(place); });
}

// The render thread passes on its model when it ends. The keeper saves it while this window, to which it
// reports errors, still exists.
MainWindow::~MainWindow() {
    states_->keep();
    segmenting_->keep();
    // Destroys everything that refers to the session before the session itself.
    hide();
    for (QDockWidget* panel : findChildren<QDockWidget*>()) delete panel;
    delete &panes_->tools();
    delete presets_;
    notes_->setSource(NoteOn::second, {});
    notes_->setSource(NoteOn::dose, {});
    delete dose_;
    delete second_;
    marks_->letKeeperGo();
    hanging_->keepIn({});
    planar_->keepIn({});
    delete takeCentralWidget();  // with the panes
    viewport_ = nullptr;         // for viewport()
    opening_->letKeeperGo();
    keeper_.reset();
}

}  // namespace macula::viewer

#include "viewer/window/main_window.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMimeData>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <chrono>
#include <utility>
#include <variant>

#include "scene/slices/opening_planes.h"
#include "scene/state/carried_view.h"
#include "study/open/same_place.h"
#include "viewer/browser/study_browser.h"
#include "viewer/clip/scissor_tool.h"
#include "viewer/clip/voxel_cutting.h"
#include "viewer/keys/keys.h"
#include "viewer/language/core_words.h"
#include "viewer/panes/focus_order.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/panes/tool_box.h"
#include "viewer/presets/preset_box.h"
#include "viewer/segmentation/segmentation_keeper.h"
#include "viewer/settings/window_place.h"
#include "viewer/slices/slice_view.h"
#include "viewer/status/status_texts.h"
#include "viewer/status/visibility_note.h"
#include "viewer/window/join_question.h"
#include "viewer/window/study_texts.h"

namespace macula::viewer {

namespace {

constexpr std::chrono::milliseconds kRateLasts{1000};
constexpr std::chrono::milliseconds kPreparingIsTold{200};  // less is not noticed, and its text would flicker

template <class Item>
void select(QComboBox& box, const std::vector<std::shared_ptr<const Item>>& items,
            const std::shared_ptr<const Item>& wanted) {
    // What comes back from a text is equal to what the list has, and another object.
    const auto found = std::find_if(items.begin(), items.end(), [&](const auto& item) {
        return item == wanted || (wanted && *item == *wanted);
    });
    box.setCurrentIndex(found == items.end() ? -1 : int(found - items.begin()));
}

}  // namespace

MainWindow::MainWindow(gpu::Instance instance, MainWindowOptions options)
    : options_(std::move(options)),
      session_(options_.catalogue),
      keeper_(makeKeeper()),
      shown_(new ShownVolume(session_, this)),
      viewport_(new Viewport(std::move(instance), options_.device, keeper_)),
      notes_(new MessageBar),
      messages_(new MessageBar),
      loading_(new WorkBar),
      table_(&shown_->table()),
      searching_(new WorkBar),
      segments_(&shown_->segments()),
      segmenting_(new WorkBar),
      export_(new PictureExport(options_.device, this)),
      exporting_(new WorkBar),
      pick_(new AnatomyPick(this)),
      calibration_(this, {.progressed = [](const ProgressUpdate&) {},
                          .ended = [this](const auto& measured) { onCalibrated(measured); }}) {
    session_.show({}, {.lights = options_.lights, .layout = options_.layout});
    setAcceptDrops(true);

    makePanes();
    makeLights();
    makeClipTools();
    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(panes_, 1);
    column->addWidget(notes_);
    column->addWidget(messages_);
    setCentralWidget(centre);
    makePresets();
    makePanels();
    connectBrowser();
    makeSecondVolume();
    makeQuality();
    makeMovies();
    makeHeadset();
    makeMenus();
    makeToolBar();
    makeStatusBar();
    makeSecondVolumeBar();
    connectLoader();
    connectTable();
    connectSegments();
    connectExport();
    connectQuit();
    connectPick();

    connect(&session_, &StudyEditor::changed, this, &MainWindow::onChanged);
    connect(shown_, &ShownVolume::changed, this, &MainWindow::redraw);
    connect(viewport_, &Viewport::rendered, this, &MainWindow::onRendered);
    connect(viewport_, &Viewport::dropped, this, &MainWindow::openDropped);
    connect(viewport_, &Viewport::namesToggled, this, &MainWindow::showNames);
    rateEnds_.setSingleShot(true);
    rateEnds_.setInterval(kRateLasts);
    connect(&rateEnds_, &QTimer::timeout, this,
            [this] { pictureText_->setFullText(pictureText_->fullText().section(QLatin1Char(','), 0, 0)); });
    prepares_.setSingleShot(true);
    prepares_.setInterval(kPreparingIsTold);
    connect(&prepares_, &QTimer::timeout, this, [this] {
        if (!panes_->isShown(Pane::volume)) return;
        badge_->hide();  // what is on screen is what was wanted before
        fidelity_->setFullText(preparing_);
    });
    new FocusOfGreyed(*this, [this] { focusPicture(); });
    connect(viewport_, &Viewport::keyNotHandled, this, &MainWindow::triggerShortcut);
    connectKeeping();
    viewport_->setSampleLimit(options_.sampleLimit);
    viewport_->setUsesModel(options_.usesModel);
    useKeys();
    showNames(options_.namesPatient && options_.settings.showsNames);
    showPanes();
    redraw();
    if (options_.layout != scene::Layout::volume) {
        resize(options_.pictureSize);
    } else {
        viewport_->setPictureSizeHint(options_.pictureSize);
        resize(minimumSizeHint());  // sizeHint() is never narrower than the tool bar
    }
    if (!options_.choosesSize) placeWindow(*this, options_.settings.windowPlace);
    new WindowPlace(*this, [this](const QString& place) {
        Settings settings = options_.settings;
        settings.windowPlace = place;
        takeSettings(settings);
    });
    focusPicture();
}

void MainWindow::connectLoader() {
    connect(&loader_, &StudyLoader::began, this, [this] {
        messages_->hide();
        loading_->begin(tr("Opening"));
    });
    connect(&loader_, &StudyLoader::progressed, loading_, &WorkBar::setProgress);
    connect(loading_, &WorkBar::cancelClicked, &loader_, &StudyLoader::cancel);
    connect(&loader_, &StudyLoader::loaded, this, [this](const study::OpenedStudy& study) {
        loading_->hide();
        showStudy(study);
    });
    connect(&loader_, &StudyLoader::askedToJoin, this, [this](const QString& path, const QString& question) {
        loading_->hide();
        viewport_->window().endDrag();
        askToJoin(this, question, [this, path] { loader_.open(path.toStdString(), true); });
    });
    connect(&loader_, &StudyLoader::failed, this, [this](const Error& error) {
        loading_->hide();
        showOpenError(error);
        emit failed(error);
    });
    connect(&loader_, &StudyLoader::cancelled, this, [this] {
        loading_->hide();
        emit loadingCancelled();
    });
}

void MainWindow::connectTable() {
    connect(table_, &TableRemoval::began, this, [this] {
        messages_->hide();
        searching_->begin(tr("Looking for the table"));
    });
    connect(table_, &TableRemoval::progressed, searching_, &WorkBar::setProgress);
    connect(searching_, &WorkBar::cancelClicked, table_, &TableRemoval::cancel);
    connect(table_, &TableRemoval::ended, searching_, &QWidget::hide);
    connect(table_, &TableRemoval::changed, this, &MainWindow::showNotes);
    connect(table_, &TableRemoval::failed, this, [this](const Error& error) {
        messages_->showError(error);
        emit failed(error);
    });
}

// What is double-clicked in 3D is where the slices go, and what the camera turns around.
void MainWindow::connectPick() {
    connect(viewport_, &Viewport::doubleClicked, this, [this](QPointF place) {
        if (study().volume && !scissors_->isOut())
            pick_->start(study().volume, shown_->drawing(), toCamera(viewport_->camera()),
                         {place.x(), place.y()}, viewport_->aspect());
    });
    connect(pick_, &AnatomyPick::found, this, [this](const glm::dvec3& mm) {
        viewport_->centreOn(mm);
        session_.change(tr("Cross-hair"), [&](scene::StudyState& next) { next.slices.crosshairMm = mm; });
    });
}

void MainWindow::redraw() {
    scene::Drawing now = shown_->drawing();
    const trace::Look look = now.settings.look;
    select(*lights_, catalogue().lights, now.lights);
    lights_->setEnabled(trace::isPathTraced(look));
    lights_->setToolTip(trace::isPathTraced(look) ? tr("Where the light comes from")
                                                  : tr("Only Cinematic and Clear have lights"));
    presets_->setToolTip(trace::isProjection(look)
                             ? tr("In this look a preset that is chosen gives the window only")
                             : tr("What is seen, and in which colours"));
    shading_->setEnabled(look == trace::Look::dvr);
    resetWindow_->setEnabled(trace::isProjection(look));
    QString note;
    if (study().volume) note = visibilityNote(now, *study().volume, catalogue());
    if (std::exchange(visibilityNote_, note) != note) showNotes();
    viewport_->setDrawing(std::move(now));
}

void MainWindow::open(study::StudySource source) {
    keepState();  // it may be the same study that is opened
    if (source) sawStudy(QString::fromStdString(source->string()));
    loader_.open(std::move(source));
}

void MainWindow::openFound(std::size_t index) {
    keepState();  // as in open()
    loader_.open(study().found, index);
    focusPicture();
}

void MainWindow::askForFolder() {
    auto* dialog =
        new QFileDialog(this, tr("Open a folder of DICOM files"), folders_.of(FolderKind::studies));
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    ask(dialog, FolderKind::studies, [this](const QString& path) { open(path.toStdString()); });
}

void MainWindow::askForFile() {
    auto* dialog = new QFileDialog(this, tr("Open an image or a volume"), folders_.of(FolderKind::studies));
    dialog->setFileMode(QFileDialog::ExistingFile);
    ask(dialog, FolderKind::studies, [this](const QString& path) { open(path.toStdString()); });
}

void MainWindow::ask(QFileDialog* dialog, FolderKind kind, std::function<void(const QString&)> then) {
    viewport_->window().endDrag();  // the dialog will see the button go up
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, dialog, kind, then = std::move(then)](const QString& path) {
                folders_.use(kind, dialog->directory().absolutePath());
                keepFolders();
                then(path);
            });
    dialog->open();  // exec() would run a second event loop
}

void MainWindow::openDropped(const Dropped& what) {
    if (what.count == 1) return open(what.path.toStdString());
    showOpenError({ErrorCode::usage,
                   tr("Only one folder or file can be opened at a time.").toStdString(),
                   {},
                   tr("Drop one of them, or the folder that holds them all.").toStdString()});
}

// Somebody who reads this looks at a picture, and must not take it for that of what could not be opened.
void MainWindow::showOpenError(const Error& error) {
    Error told = error;
    if (study().volume) {
        told.hint += tr(" What is on screen is still of the study that was open before.").toStdString();
    }
    messages_->showError(told);
}

// Of the same study. What is drawn of it is told by ShownVolume.
void MainWindow::onChanged(const scene::StudyState& before) {
    const scene::StudyState now = session_.state();
    if (study().volume && now.preset) {
        const QString note = presetWarning(*now.preset, *study().volume);
        if (std::exchange(presetNote_, note) != note) showNotes();
    }
    // A cross-hair that is dragged changes nothing in menus and panes.
    if (now.preset != before.preset || now.clip != before.clip || now.cuts != before.cuts ||
        now.settings.look != before.settings.look || now.settings.shading != before.settings.shading)
        showChosen();
    if (now.settings.bounces != before.settings.bounces) showCost();
    if (now.layout != before.layout) showPanes();
}

// That of the command line where it fits, else the automatic one: what a person chose in one study says
// nothing about another. A curve over Hounsfield units means nothing on the raw numbers of a scanner, and the
// reverse.
std::shared_ptr<const TransferFunction> MainWindow::usualPreset(const Volume& volume) const {
    const auto& wanted = options_.preset;
    return wanted && suits(*wanted, volume.unit()) ? wanted : scene::presetFor(catalogue(), volume);
}

void MainWindow::showStudy(const study::OpenedStudy& study) {
    keepState();  // of the one before
    sessionNote_.clear();
    if (!std::exchange(storeNoteIsNew_, false)) storeNote_.clear();
    const Volume& volume = *study.volume;
    QStringList notes;
    const auto preset = usualPreset(volume);
    if (const auto& wanted = options_.preset; wanted && wanted != preset)
        notes << tr("The preset %1 is not made for this kind of volume; %2 is used instead.")
                     .arg(titleOr(wanted->title, wanted->name), titleOr(preset->title, preset->name));
    // How a study is drawn was chosen in it, or nobody has chosen it. How the window is arranged stays.
    const scene::StudyState& before = session_.state();
    const scene::OpeningPlanes planes = scene::openingPlanes(volume);
    scene::StudyState now{.seriesDigest = study.seriesDigest,
                          .preset = preset,
                          .lights = options_.lights,
                          .showsMarks = before.showsMarks,
                          .background = before.background,
                          .layout = before.layout,
                          .slices = {.asAcquired = planes.asAcquired}};
    std::optional<scene::StudyState> left = stateAsLeft(study);
    if (left && options_.restores == Restores::work) {
        now.slices = left->slices;
        now.measurements = left->measurements;
        now.namedClips = left->namedClips;
        now.segmentations = scene::onSlicesAlone(left->segmentations);
        now.otherKeys = left->otherKeys;
    } else if (left) {
        now = *left;
        if (options_.keepsLayout) now.layout = before.layout;
        now.seriesDigest = study.seriesDigest;
        now.camera.reset();
        now.leavesTableOut = false;  // until it is found
        if (!now.preset) now.preset = preset;
        notes.clear();  // on another preset
        sessionNote_ = tr("This study is shown as it was left. The View menu shows it as when first opened.");
    }
    if (options_.restores == Restores::work) left.reset();
    now.slices = scene::carriedSlices(this->study(), before.slices, study, now.slices);
    const bool keepsCamera = study::staysInPlace(this->study(), study) && !viewport_->framedFrom();
    const Camera camera = toCamera(viewport_->camera());
    presetNote_ = presetWarning(*now.preset, volume);
    pick_->cancel();
    session_.show(study, std::move(now));
    favourPane(planes.largest);
    showChosen();
    showPanes();
    scene::Drawing first = shown_->drawing();
    visibilityNote_ = visibilityNote(first, volume, catalogue());
    viewport_->setStudy(study.volume, linesToShow(study.identity), std::move(first), options_.firstView);
    if (keepsCamera) {
        viewport_->showFrom(camera);
    } else if (left && left->camera) {
        viewport_->showFrom(*left->camera);
    } else if (left) {
        viewport_->setParallel(false);
    }
    redraw();  // menus and lists show it
    if (left) table_->ask(left->leavesTableOut);
    beginToKeep();
    showFound(study.found, study.volumeIndex);
    volumes_->setVolumes(study.volumeTitles, study.volumeIndex);
    pictureFailed_ = false;
    showStudyTexts();
    tellOfPicture();

    for (const std::string& assumption : volume.provenance().assumptions) {
        notes << inWindowsLanguage(assumption);
    }
    for (const std::string& message : study.messages) notes << inWindowsLanguage(message);
    messages_->hide();
    studyNotes_ = notes;
    pictureNote_.clear();
    if (deviceIsBack_) deviceNote_.clear();
    showNotes();
    showCost();
    emit studyShown();
}

void MainWindow::showNotes() {
    QStringList notes = studyNotes_ + table_->notes() + besideNotes();
    if (const QString note = segments_->note(); !note.isEmpty()) notes << note;
    if (!presetNote_.isEmpty()) notes.prepend(presetNote_);
    if (!storeNote_.isEmpty()) notes.prepend(storeNote_);
    if (!sessionNote_.isEmpty()) notes.prepend(sessionNote_);
    if (!visibilityNote_.isEmpty()) notes.prepend(visibilityNote_);
    if (!pictureNote_.isEmpty()) notes << pictureNote_;
    if (!deviceNote_.isEmpty()) notes << deviceNote_;
    if (notes.isEmpty()) {
        notes_->hide();
    } else {
        notes_->showNote(withoutRepeats(notes).join(QLatin1Char(' ')));
    }
}

// Letters of tools are shortcuts of the window; in a list they look for an entry that begins with them.
bool MainWindow::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        const QWidget* focus = QApplication::focusWidget();
        const bool isList = qobject_cast<const QComboBox*>(focus) != nullptr ||
                            qobject_cast<const QAbstractItemView*>(focus) != nullptr;
        if (isList && key.modifiers() == Qt::NoModifier && key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z)
            event->accept();
    }
    return QMainWindow::event(event);
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (!viewport_->handleKey(*event)) QMainWindow::keyPressEvent(event);
}

void MainWindow::triggerShortcut(QKeyEvent* event) {
    // Keys pressed in the native window do not pass through the widgets' shortcuts on every platform.
    const QKeySequence pressed(event->keyCombination());
    for (QAction* action : findChildren<QAction*>()) {
        const bool isHidden = !tools_->isVisible() && tools_->actions().contains(action);
        if (!action->shortcut().isEmpty() && action->shortcut() == pressed && action->isEnabled() &&
            !isHidden) {
            return action->trigger();
        }
    }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    acceptDrop(*event);
}

void MainWindow::dropEvent(QDropEvent* event) {
    if (acceptDrop(*event)) openDropped(droppedBy(event->mimeData()));
}

}  // namespace macula::viewer

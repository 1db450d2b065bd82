#include "viewer/main_window.h"

#include <QAction>
#include <QApplication>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <chrono>
#include <utility>
#include <variant>

#include "app/camera/view_directions.h"
#include "app/state/drawing_of.h"
#include "pipeline/volume/window.h"
#include "viewer/help_boxes.h"
#include "viewer/join_question.h"
#include "viewer/keys.h"
#include "viewer/status_texts.h"
#include "viewer/visibility_note.h"

namespace macula::viewer {

namespace {

constexpr std::chrono::milliseconds kRateLasts{1000};
constexpr std::chrono::milliseconds kPreparingIsTold{200};  // less is not noticed, and its text would flicker
constexpr std::chrono::milliseconds kStateKeptEvery{5000};  // a program that is killed loses no more

QString asText(std::string_view text) {
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

// With a capital.
QString asTitle(const std::string& name) {
    QString title = QString::fromStdString(name);
    if (!title.isEmpty()) title[0] = title[0].toUpper();
    return title;
}

QString titleOr(const std::string& title, const std::string& name) {
    return QString::fromStdString(title.empty() ? name : title);
}

template <class Item>
void fill(QComboBox& box, const std::vector<std::shared_ptr<const Item>>& items) {
    for (const auto& item : items) {
        box.addItem(titleOr(item->title, item->name));
        box.setItemData(box.count() - 1, QString::fromStdString(item->name), Qt::ToolTipRole);
    }
}

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
      keeper_(makeKeeper()),
      viewport_(new Viewport(std::move(instance), options_.device, keeper_)),
      notes_(new MessageBar),
      messages_(new MessageBar),
      loading_(new WorkBar),
      table_(new TableRemoval(this)),
      searching_(new WorkBar) {
    state_.lights = options_.lights;
    setTitle({});
    setAcceptDrops(true);

    auto* centre = new QWidget(this);
    auto* column = new QVBoxLayout(centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(viewport_, 1);
    column->addWidget(notes_);
    column->addWidget(messages_);
    setCentralWidget(centre);
    makeMenus();
    makeToolBar();
    makeStatusBar();
    connectLoader();
    connectTable();

    connect(viewport_, &Viewport::rendered, this, &MainWindow::onRendered);
    connect(viewport_, &Viewport::dropped, this, &MainWindow::openDropped);
    connect(viewport_, &Viewport::namesToggled, names_, &QAction::setChecked);
    rateEnds_.setSingleShot(true);
    rateEnds_.setInterval(kRateLasts);
    connect(&rateEnds_, &QTimer::timeout, this,
            [this] { pictureText_->setFullText(pictureText_->fullText().section(QLatin1Char(','), 0, 0)); });
    prepares_.setSingleShot(true);
    prepares_.setInterval(kPreparingIsTold);
    connect(&prepares_, &QTimer::timeout, this, [this] {
        badge_->hide();  // what is on screen is what was wanted before
        fidelity_->setFullText(preparing_);
    });
    connect(viewport_, &Viewport::keyNotHandled, this, &MainWindow::triggerShortcut);
    loader_.setKeeper(keeper_);
    connect(&keeps_, &QTimer::timeout, this, &MainWindow::keepState);
    if (keeper_) keeps_.start(kStateKeptEvery);
    viewport_->setSampleLimit(options_.sampleLimit);
    viewport_->setUsesModel(options_.usesModel);
    viewport_->showNames(options_.namesPatient);
    redraw();
    viewport_->setPictureSizeHint(options_.pictureSize);
    resize(sizeHint());
    viewport_->setFocus();
}

void MainWindow::makeMenus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->setToolTipsVisible(true);
    QAction* openFolder = file->addAction(tr("&Open Folder…"), this, &MainWindow::askForFolder);
    openFolder->setShortcut(keyOf(KeyAction::openFolder));
    openFolder->setToolTip(tr("Open the best volume in a folder of DICOM files"));
    QAction* openFile = file->addAction(tr("Open &File…"), this, &MainWindow::askForFile);
    openFile->setShortcut(keyOf(KeyAction::openFile));
    openFile->setToolTip(tr("Open the series of an image, a DICOMDIR, or a NIfTI, NRRD or MetaImage file"));
    QAction* phantom = file->addAction(tr("Open &Phantom"), this, [this] { open(std::nullopt); });
    phantom->setToolTip(tr("Open the built-in phantom study"));
    file->addSeparator();
    QAction* openView = file->addAction(tr("Open &View…"), this, &MainWindow::askForView);
    openView->setShortcut(keyOf(KeyAction::openView));
    openView->setToolTip(tr("Show this study as it was when a view was saved"));
    QAction* saveView = file->addAction(tr("&Save View…"), this, &MainWindow::askWhereToSaveView);
    saveView->setShortcut(keyOf(KeyAction::saveView));
    saveView->setToolTip(tr("Preset, clip, lights, look, window and camera, for another time"));
    file->addSeparator();
    QAction* quit = file->addAction(tr("&Quit"), this, &QWidget::close);
    quit->setShortcut(keyOf(KeyAction::quit));

    // The keys of this menu are handled by the viewport, so that they do nothing while a list has the focus.
    QMenu* view = menuBar()->addMenu(tr("&View"));
    const auto withKey = [](const QString& title, KeyAction action) {
        return title + QLatin1Char('\t') + keyOf(action).toString();
    };
    for (const KeyRow& row : kKeys) {
        if (const auto direction = viewDirectionOf(row.action))
            view->addAction(withKey(asTitle(app::nameOf(*direction)), row.action), this,
                            [this, from = *direction] { viewport_->showFrom(from); });
    }
    view->addSeparator();
    view->addAction(withKey(tr("Fit what is visible"), KeyAction::fit), this, [this] { viewport_->fit(); });
    QAction* afresh = view->addAction(tr("Show as when first opened"), this, &MainWindow::showAfresh);
    afresh->setObjectName(QStringLiteral("show-afresh"));
    afresh->setToolTip(
        tr("Preset, lights, clip, look and camera that a study has which nobody has seen yet"));
    view->addSeparator();
    names_ = view->addAction(withKey(tr("Patient and study over the picture"), KeyAction::names));
    names_->setObjectName(QStringLiteral("names"));
    names_->setCheckable(true);
    names_->setChecked(true);
    connect(names_, &QAction::triggered, viewport_, &Viewport::showNames);
    QAction* gaze = view->addAction(tr("Trace where the pointer is, while moving"));
    gaze->setCheckable(true);
    gaze->setChecked(true);
    connect(gaze, &QAction::triggered, viewport_, &Viewport::setGazeFollowsPointer);

    makeLookMenu();
    makeClipMenu();

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    help->addAction(tr("&Keys and Mouse"), this, [this] { showKeys(this); })
        ->setShortcut(keyOf(KeyAction::help));
    help->addAction(tr("&About Macula"), this, [this] { showAbout(this); });
}

void MainWindow::makeLookMenu() {
    looks_ = new ChoiceMenu(tr("&Look"), this);
    menuBar()->addMenu(looks_);
    for (const trace::LookTraits& look : trace::kLooks) {
        looks_->addChoice(asText(look.title), QStringLiteral("look-") + asText(look.name))
            ->setShortcut(keyOf(look.look));
    }
    looks_->addSeparator();
    shading_ = looks_->addAction(tr("&Shade Ray Cast"));
    shading_->setObjectName(QStringLiteral("shade-ray-cast"));
    shading_->setCheckable(true);
    shading_->setShortcut(keyOf(KeyAction::shade));
    shading_->setToolTip(tr("Light ray casts from the eye, as much as the preset says"));
    shading_->setChecked(true);
    QAction* window = looks_->addAction(tr("Reset &Window"), this, [this] {
        state_.windows.at(std::size_t(state_.settings.look)).reset();
        redraw();
    });
    window->setObjectName(QStringLiteral("reset-window"));
    window->setShortcut(keyOf(KeyAction::resetWindow));
    window->setToolTip(tr("Of the values: that of the series"));
    resetWindow_ = window;
    connect(viewport_, &Viewport::windowDragged, this, [this](QPointF byHeights) {
        if (const auto from = drawing().settings.window)
            state_.windows.at(std::size_t(state_.settings.look)) =
                app::dragged(*from, {byHeights.x(), byHeights.y()});
        redraw();
    });
    connect(looks_, &ChoiceMenu::changed, this, [this](int index) {
        state_.settings.look = trace::kLooks.at(std::size_t(index)).look;
        redraw();
    });
    connect(shading_, &QAction::triggered, this, [this](bool shaded) {
        state_.settings.shading = shaded ? trace::Shading::headlight : trace::Shading::none;
        redraw();
    });
}

void MainWindow::makeClipMenu() {
    clips_ = new ChoiceMenu(tr("&Clip"), this);
    menuBar()->addMenu(clips_);
    clips_->addAction(&table_->action());
    clips_->addSeparator();
    clips_->addChoice(tr("&No Clip"), QStringLiteral("no-clip"))->setShortcut(keyOf(KeyAction::noClip));
    for (const auto& clip : options_.catalogue.clips) {
        clips_->addChoice(titleOr(clip->title, clip->name),
                          QStringLiteral("clip-") + QString::fromStdString(clip->name));
    }
    connect(clips_, &ChoiceMenu::changed, this, [this](int index) {
        state_.clip.reset();
        if (index > 0) state_.clip = *options_.catalogue.clips.at(std::size_t(index) - 1);  // 0 is no clip
        updateClip();
    });
}

void MainWindow::makeToolBar() {
    QToolBar* bar = addToolBar(tr("Look"));
    bar->setMovable(false);
    presets_ = new QComboBox(bar);
    presets_->setAccessibleName(tr("Preset"));
    fill(*presets_, options_.catalogue.presets);
    presets_->setCurrentIndex(-1);
    lights_ = new QComboBox(bar);
    lights_->setAccessibleName(tr("Lights"));
    fill(*lights_, options_.catalogue.lights);
    bar->addWidget(new QLabel(tr(" Preset "), bar));
    bar->addWidget(presets_);
    bar->addWidget(new QLabel(tr("  Lights "), bar));
    bar->addWidget(lights_);
    bar->addWidget(new QLabel(QStringLiteral("   "), bar));
    volumes_ = new VolumeChoice(bar);
    volumesInBar_ = bar->addWidget(volumes_);
    volumesInBar_->setVisible(false);
    connect(volumes_, &VolumeChoice::chosen, this, [this](std::size_t index) {
        keepState();  // as in open()
        loader_.open(study_.found, index);
        viewport_->setFocus();
    });
    description_ = new ElidingLabel(tr("Series"), bar);
    description_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(description_);

    connect(presets_, &QComboBox::activated, this, &MainWindow::choosePreset);
    connect(lights_, &QComboBox::activated, this, [this](int index) {
        state_.lights = options_.catalogue.lights[std::size_t(index)];
        redraw();
        viewport_->setFocus();
    });
}

void MainWindow::makeStatusBar() {
    fidelity_ = new ElidingLabel(tr("How true the picture is"));
    modelText_ = new ElidingLabel(
        tr("The peripheral model: splats that are shown with all pixels while a hand moves"));
    pictureText_ = new ElidingLabel(tr("Pixels, pictures per second"));
    volumeText_ = new ElidingLabel(tr("Voxels and their size"));
    deviceText_ = new ElidingLabel(tr("Device"));
    // How far the picture can be trusted is the last thing to be cut short.
    fidelity_->keepLongest();
    statusBar()->addWidget(loading_);
    statusBar()->addWidget(searching_);
    badge_ = new FidelityBadge;
    statusBar()->addWidget(badge_);
    statusBar()->addWidget(fidelity_, 1);
    statusBar()->addPermanentWidget(modelText_);
    statusBar()->addPermanentWidget(pictureText_);
    statusBar()->addPermanentWidget(volumeText_);
    statusBar()->addPermanentWidget(deviceText_);
    fidelity_->setFullText(tr("No study is open"));
}

void MainWindow::connectLoader() {
    connect(&loader_, &StudyLoader::began, this, [this] {
        messages_->hide();
        loading_->begin(tr("Opening"));
    });
    connect(&loader_, &StudyLoader::progressed, loading_, &WorkBar::setProgress);
    connect(loading_, &WorkBar::cancelClicked, &loader_, &StudyLoader::cancel);
    connect(&loader_, &StudyLoader::loaded, this, [this](const app::OpenedStudy& study) {
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
    connect(table_, &TableRemoval::changed, this, [this] {
        updateClip();
        showNotes();
    });
    connect(table_, &TableRemoval::failed, this, [this](const Error& error) {
        messages_->showError(error);
        emit failed(error);
    });
}

app::Drawing MainWindow::drawing() const {
    return app::drawingOf(state_, options_.catalogue, seriesWindows_, study_.volume, clip_);
}

void MainWindow::redraw() {
    app::Drawing now = drawing();
    const trace::Look look = now.settings.look;
    select(*lights_, options_.catalogue.lights, now.lights);
    lights_->setEnabled(trace::isPathTraced(look));
    lights_->setToolTip(trace::isPathTraced(look) ? tr("Where the light comes from")
                                                  : tr("Only Cinematic and Clear have lights"));
    presets_->setToolTip(trace::isProjection(look)
                             ? tr("In this look a preset that is chosen gives the window only")
                             : tr("What is seen, and in which colours"));
    shading_->setEnabled(look == trace::Look::dvr);
    resetWindow_->setEnabled(trace::isProjection(look));
    QString note;
    if (study_.volume) note = visibilityNote(now, *study_.volume, options_.catalogue);
    if (std::exchange(visibilityNote_, note) != note) showNotes();
    viewport_->setDrawing(std::move(now));
}

void MainWindow::updateClip() {
    clip_ = study_.volume ? app::clipOf(state_, *study_.volume, table_->mask()) : nullptr;
    redraw();
}

void MainWindow::open(app::StudySource source) {
    keepState();  // it may be the same study that is opened
    loader_.open(std::move(source));
}

void MainWindow::askForFolder() {
    auto* dialog = new QFileDialog(this, tr("Open a folder of DICOM files"), lastFolder_);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    ask(dialog, [this](const QString& path) { open(path.toStdString()); });
}

void MainWindow::askForFile() {
    auto* dialog = new QFileDialog(this, tr("Open an image or a volume"), lastFolder_);
    dialog->setFileMode(QFileDialog::ExistingFile);
    ask(dialog, [this](const QString& path) { open(path.toStdString()); });
}

void MainWindow::ask(QFileDialog* dialog, std::function<void(const QString&)> then) {
    viewport_->window().endDrag();  // the dialog will see the button go up
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, dialog, then = std::move(then)](const QString& path) {
                lastFolder_ = dialog->directory().absolutePath();
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
    if (study_.volume) {
        told.hint += tr(" What is on screen is still of the study that was open before.").toStdString();
    }
    messages_->showError(told);
}

void MainWindow::choosePreset(int index) {
    options_.preset = options_.catalogue.presets[std::size_t(index)];  // kept for the next study
    state_.preset = options_.preset;
    if (study_.volume) {
        const QString before = std::exchange(presetNote_, presetWarning(*state_.preset, *study_.volume));
        if (presetNote_ != before) showNotes();
        // In projections it is a window, and of those each look has its own.
        if (const trace::Look look = state_.settings.look; trace::isProjection(look))
            state_.windows.at(std::size_t(look)) = presetWindow(*state_.preset, *study_.volume);
    }
    redraw();
    viewport_->setFocus();
}

void MainWindow::showStudy(const app::OpenedStudy& study) {
    keepState();  // of the one before
    study_ = study;
    sessionNote_.clear();
    if (!std::exchange(storeNoteIsNew_, false)) storeNote_.clear();
    const Volume& volume = *study_.volume;
    QStringList notes;
    auto preset = options_.preset;
    if (!preset || !suits(*preset, volume.unit())) {
        const auto wanted = std::exchange(preset, app::presetFor(options_.catalogue, volume));
        // A curve over Hounsfield units means nothing on the raw numbers of a scanner, and the reverse.
        if (wanted) {
            notes << tr("The preset %1 is not made for this kind of volume; %2 is used instead.")
                         .arg(titleOr(wanted->title, wanted->name), titleOr(preset->title, preset->name));
        }
    }
    presetNote_ = presetWarning(*preset, volume);
    select(*presets_, options_.catalogue.presets, preset);
    // What was hidden of the study before may be what matters in this one, and its windows mean nothing here.
    // Of the rest stays what menus and lists show: a number of a view that was opened would go on unseen.
    state_ = {.seriesDigest = study_.seriesDigest,
              .preset = preset,
              .lights = state_.lights,
              .settings = {.look = state_.settings.look, .shading = state_.settings.shading}};
    table_->setVolume(study_.volume);
    seriesWindows_.forget();
    const std::optional<app::StudyState> left = stateAsLeft();
    if (left) {
        state_ = *left;
        state_.seriesDigest = study_.seriesDigest;
        state_.camera.reset();
        if (!state_.preset) state_.preset = preset;
        presetNote_ = presetWarning(*state_.preset, volume);
        notes.clear();  // on another preset
        sessionNote_ = tr("This study is shown as it was left. The View menu shows it as when first opened.");
    }
    showChosen();
    clip_ = app::clipOf(state_, volume, std::nullopt);
    clearStudyTexts();
    app::Drawing first = drawing();
    visibilityNote_ = visibilityNote(first, volume, options_.catalogue);
    viewport_->setStudy(study_.volume, linesOf(study_.identity), std::move(first), options_.firstView);
    if (left && left->camera) viewport_->showFrom(*left->camera);
    redraw();  // menus and lists show it
    if (left) table_->ask(left->leavesTableOut);
    kept_ = stateToKeep();
    volumes_->setVolumes(study_.volumeTitles, study_.volumeIndex);
    volumesInBar_->setVisible(volumes_->count() > 0 && options_.namesPatient);

    for (const std::string& assumption : volume.provenance().assumptions) {
        notes << QString::fromStdString(assumption);
    }
    for (const std::string& message : study_.messages) notes << QString::fromStdString(message);
    messages_->hide();
    studyNotes_ = notes;
    pictureNote_.clear();
    if (deviceIsBack_) deviceNote_.clear();
    showNotes();
    emit studyShown();
}

void MainWindow::showNotes() {
    QStringList notes = studyNotes_ + table_->notes();
    if (!presetNote_.isEmpty()) notes.prepend(presetNote_);
    if (!storeNote_.isEmpty()) notes.prepend(storeNote_);
    if (!sessionNote_.isEmpty()) notes.prepend(sessionNote_);
    if (!visibilityNote_.isEmpty()) notes.prepend(visibilityNote_);
    if (!pictureNote_.isEmpty()) notes << pictureNote_;
    if (!deviceNote_.isEmpty()) notes << deviceNote_;
    if (notes.isEmpty()) {
        notes_->hide();
    } else {
        notes_->showNote(notes.join(QLatin1Char(' ')));
    }
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
    if (!viewport_->handleKey(*event)) QMainWindow::keyPressEvent(event);
}

void MainWindow::triggerShortcut(QKeyEvent* event) {
    // Keys pressed in the native window do not pass through the widgets' shortcuts on every platform.
    const QKeySequence pressed(event->keyCombination());
    for (QAction* action : findChildren<QAction*>()) {
        if (!action->shortcut().isEmpty() && action->shortcut() == pressed && action->isEnabled()) {
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

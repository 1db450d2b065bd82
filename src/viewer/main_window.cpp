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

#include "pipeline/volume/clip_json.h"
#include "pipeline/volume/window.h"
#include "viewer/help_boxes.h"
#include "viewer/join_question.h"
#include "viewer/status_texts.h"
#include "viewer/visibility_note.h"

namespace macula::viewer {

namespace {

struct StandardView {
    ViewDirection direction;
    const char* name;
    const char* key;
};
constexpr std::chrono::milliseconds kRateLasts{1000};

constexpr std::array kStandardViews{
    StandardView{ViewDirection::anterior, QT_TRANSLATE_NOOP("View", "Anterior"), "A"},
    StandardView{ViewDirection::posterior, QT_TRANSLATE_NOOP("View", "Posterior"), "P"},
    StandardView{ViewDirection::left, QT_TRANSLATE_NOOP("View", "Left"), "L"},
    StandardView{ViewDirection::right, QT_TRANSLATE_NOOP("View", "Right"), "R"},
    StandardView{ViewDirection::superior, QT_TRANSLATE_NOOP("View", "Superior"), "S"},
    StandardView{ViewDirection::inferior, QT_TRANSLATE_NOOP("View", "Inferior"), "I"},
};

QString asText(std::string_view text) {
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
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
    const auto found = std::find(items.begin(), items.end(), wanted);
    box.setCurrentIndex(found == items.end() ? -1 : int(found - items.begin()));
}

}  // namespace

MainWindow::MainWindow(gpu::Instance instance, MainWindowOptions options)
    : options_(std::move(options)),
      viewport_(new Viewport(std::move(instance), options_.device)),
      notes_(new MessageBar),
      messages_(new MessageBar),
      loading_(new WorkBar),
      table_(new TableRemoval(this)),
      searching_(new WorkBar) {
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
    connect(viewport_, &Viewport::keyNotHandled, this, &MainWindow::triggerShortcut);
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
    openFolder->setShortcut(QKeySequence::Open);
    openFolder->setToolTip(tr("Open the best volume in a folder of DICOM files"));
    QAction* openFile = file->addAction(tr("Open &File…"), this, &MainWindow::askForFile);
    openFile->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O));
    openFile->setToolTip(tr("Open the series of an image, a DICOMDIR, or a NIfTI, NRRD or MetaImage file"));
    QAction* phantom = file->addAction(tr("Open &Phantom"), this, [this] { open(std::nullopt); });
    phantom->setToolTip(tr("Open the built-in phantom study"));
    file->addSeparator();
    QAction* quit = file->addAction(tr("&Quit"), this, &QWidget::close);
    quit->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Q));

    // The keys of this menu are handled by the viewport, so that they do nothing while a list has the focus.
    QMenu* view = menuBar()->addMenu(tr("&View"));
    for (const StandardView& standard : kStandardViews) {
        view->addAction(QStringLiteral("%1\t%2").arg(QApplication::translate("View", standard.name),
                                                     QString::fromLatin1(standard.key)),
                        this, [this, direction = standard.direction] { viewport_->showFrom(direction); });
    }
    view->addSeparator();
    view->addAction(tr("Fit what is visible\tF"), this, [this] { viewport_->fit(); });
    view->addSeparator();
    names_ = view->addAction(tr("Patient and study over the picture\tN"));
    names_->setObjectName(QStringLiteral("names"));
    names_->setCheckable(true);
    names_->setChecked(true);
    connect(names_, &QAction::triggered, viewport_, &Viewport::showNames);

    makeLookMenu();
    makeClipMenu();

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    help->addAction(tr("&Keys and Mouse"), this, [this] { showKeys(this); })
        ->setShortcut(QKeySequence(Qt::Key_F1));
    help->addAction(tr("&About Macula"), this, [this] { showAbout(this); });
}

void MainWindow::makeLookMenu() {
    looks_ = new ChoiceMenu(tr("&Look"), this);
    menuBar()->addMenu(looks_);
    int key = Qt::Key_1;
    for (const trace::LookName& look : trace::kLooks) {
        looks_->addChoice(asText(look.title), QStringLiteral("look-") + asText(look.name))
            ->setShortcut(QKeySequence(Qt::CTRL | Qt::Key(key++)));
    }
    looks_->addSeparator();
    shading_ = looks_->addAction(tr("&Shade Ray Cast"));
    shading_->setObjectName(QStringLiteral("shade-ray-cast"));
    shading_->setCheckable(true);
    shading_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_0));
    shading_->setToolTip(tr("Light ray casts from the eye, as much as the preset says"));
    shading_->setChecked(true);
    QAction* window = looks_->addAction(tr("Reset &Window"), this, [this] {
        windows_.forget(lookChosen());
        redraw();
    });
    window->setObjectName(QStringLiteral("reset-window"));
    window->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
    window->setToolTip(tr("Of the values: that of the series"));
    resetWindow_ = window;
    connect(viewport_, &Viewport::windowDragged, this, [this](QPointF byHeights) {
        if (const auto from = drawing().settings.window)
            windows_.drag(lookChosen(), *from, {byHeights.x(), byHeights.y()});
        redraw();
    });
    connect(looks_, &ChoiceMenu::changed, this, &MainWindow::redraw);
    connect(shading_, &QAction::triggered, this, &MainWindow::redraw);
}

void MainWindow::makeClipMenu() {
    clips_ = new ChoiceMenu(tr("&Clip"), this);
    menuBar()->addMenu(clips_);
    clips_->addAction(&table_->action());
    clips_->addSeparator();
    clips_->addChoice(tr("&No Clip"), QStringLiteral("no-clip"))
        ->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_U));
    for (const auto& clip : options_.catalogue.clips) {
        clips_->addChoice(titleOr(clip->title, clip->name),
                          QStringLiteral("clip-") + QString::fromStdString(clip->name));
    }
    connect(clips_, &ChoiceMenu::changed, this, &MainWindow::updateClip);
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
        loader_.open(study_.found, index);
        viewport_->setFocus();
    });
    description_ = new ElidingLabel(tr("Series"), bar);
    description_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(description_);

    connect(presets_, &QComboBox::activated, this, &MainWindow::choosePreset);
    connect(lights_, &QComboBox::activated, this, [this](int index) {
        options_.lights = options_.catalogue.lights[std::size_t(index)];
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

trace::Look MainWindow::lookChosen() const {
    return trace::kLooks.at(std::size_t(looks_->chosen())).look;
}

// Everything that was chosen, for the study that is open.
app::Drawing MainWindow::drawing() const {
    const trace::Look look = lookChosen();
    app::Drawing drawing{
        .transferFunction = preset_,
        .lights = options_.lights ? options_.lights : app::defaultLights(options_.catalogue, look),
        .clip = clip_};
    drawing.settings.look = look;
    QStringList remarks;
    if (look == trace::Look::dvr && shading_->isChecked() && preset_ && preset_->lighting.shade) {
        drawing.settings.shading = trace::Shading::headlight;
        remarks << tr("shaded");
    }
    if (trace::isProjection(look) && study_.volume) {
        drawing.settings.window = windows_.of(look, *study_.volume);
        remarks << QString::fromStdString(
            app::windowText(*drawing.settings.window, study_.volume->unitName()));
    }
    if (clip_ && clip_->mask) remarks << tr("table left out");
    if (clip_ && clip_->hasShape()) remarks << tr("clipped");
    drawing.remarks = remarks.join(QStringLiteral(", ")).toStdString();
    return drawing;
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
    clip_.reset();
    if (study_.volume) {
        Clip clip;
        // Number 0 is no clip.
        if (clips_->chosen() > 0) {
            clip = clipFor(*options_.catalogue.clips.at(std::size_t(clips_->chosen()) - 1), *study_.volume);
        }
        clip.mask = table_->mask();
        if (!clip.isNothing()) clip_ = std::make_shared<const Clip>(std::move(clip));
    }
    redraw();
}

void MainWindow::open(app::StudySource source) {
    loader_.open(std::move(source));
}

void MainWindow::askForFolder() {
    auto* dialog = new QFileDialog(this, tr("Open a folder of DICOM files"), lastFolder_);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    ask(dialog);
}

void MainWindow::askForFile() {
    auto* dialog = new QFileDialog(this, tr("Open an image or a volume"), lastFolder_);
    dialog->setFileMode(QFileDialog::ExistingFile);
    ask(dialog);
}

void MainWindow::ask(QFileDialog* dialog) {
    viewport_->window().endDrag();  // the dialog will see the button go up
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QFileDialog::fileSelected, this, [this, dialog](const QString& path) {
        lastFolder_ = dialog->directory().absolutePath();
        open(path.toStdString());
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
    preset_ = options_.preset;
    if (study_.volume) {
        const QString before = std::exchange(presetNote_, presetWarning(*preset_, *study_.volume));
        if (presetNote_ != before) showNotes();
        // In projections it is a window, and of those each look has its own.
        if (const trace::Look look = lookChosen(); trace::isProjection(look))
            windows_.set(look, presetWindow(*preset_, *study_.volume));
    }
    redraw();
    viewport_->setFocus();
}

void MainWindow::showStudy(const app::OpenedStudy& study) {
    study_ = study;
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
    preset_ = preset;
    // What was hidden of the study before may be what matters in this one.
    table_->setVolume(study_.volume);
    clips_->choose(0);
    windows_.forgetAll();
    clip_.reset();
    clearStudyTexts();
    app::Drawing first = drawing();
    visibilityNote_ = visibilityNote(first, volume, options_.catalogue);
    viewport_->setStudy(study_.volume, linesOf(study_.identity), std::move(first), options_.firstView);
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
    if (!visibilityNote_.isEmpty()) notes.prepend(visibilityNote_);
    if (!pictureNote_.isEmpty()) notes << pictureNote_;
    if (!deviceNote_.isEmpty()) notes << deviceNote_;
    if (notes.isEmpty()) {
        notes_->hide();
    } else {
        notes_->showNote(notes.join(QLatin1Char(' ')));
    }
}

void MainWindow::setStudyTexts(const app::OpenedStudy& study) {
    const glm::ivec3 size = study.volume->size();
    const glm::dvec3 spacing = study.volume->spacingMm();
    const QString text = QStringLiteral("%1 %2×%3×%4, %5×%6×%7 mm")
                             .arg(QString::fromStdString(study.volume->modality()))
                             .arg(size.x)
                             .arg(size.y)
                             .arg(size.z)
                             .arg(spacing.x, 0, 'f', 2)
                             .arg(spacing.y, 0, 'f', 2)
                             .arg(spacing.z, 0, 'f', 2);
    volumeText_->setFullText(text);
    const QString why = QString::fromStdString(study.whyThisSeries);
    // The description of a series may name a patient.
    if (options_.namesPatient) description_->setFullText(QString::fromStdString(study.description), why);
    description_->setStatusTip(why);
}

// Names what is on screen, no sooner and no later.
void MainWindow::setTitle(const QString& ofPicture) {
    QString title = ofPicture.simplified();
    if (!options_.namesPatient) title.clear();
    title.replace(QLatin1String("[*]"), QLatin1String("[*][*]"));  // Qt's mark for what is not saved
    setWindowTitle(title.isEmpty() ? QStringLiteral("Macula") : title + QStringLiteral(" \u2013 Macula"));
}

void MainWindow::clearStudyTexts() {
    rateEnds_.stop();
    volumeText_->setFullText({});
    description_->setFullText({});
    description_->setStatusTip({});
    pictureText_->setFullText({});
    modelText_->setFullText({});
}

void MainWindow::onRendered(const app::RenderEvent& event) {
    if (const auto* frame = std::get_if<app::FrameShown>(&event)) {
        onFrame(*frame);
    } else if (const auto* ready = std::get_if<app::DeviceReady>(&event)) {
        deviceText_->setFullText(QString::fromStdString(ready->name));
        deviceText_->setToolTip(QString::fromStdString(ready->description));
        if (!study_.volume) fidelity_->setFullText(tr("No study is open"));  // nothing else comes
    } else if (std::holds_alternative<app::DeviceRestarting>(event)) {
        fidelity_->setFullText(tr("Starting the graphics device again…"));
        deviceNote_ =
            tr("The graphics device stopped responding and is started again; the picture is made "
               "anew. If this comes back, update the graphics driver.");
        deviceIsBack_ = false;
        showNotes();
    } else if (const auto* changed = std::get_if<app::ModelChanged>(&event)) {
        if (changed->study == viewport_->study()) onModel(changed->model);
    } else if (const auto* preparing = std::get_if<app::Preparing>(&event)) {
        fidelity_->setFullText(QString::fromStdString(preparing->what) + QStringLiteral("…"));
    } else if (std::holds_alternative<app::PictureRemoved>(event)) {
        setTitle({});
    } else if (const auto* failure = std::get_if<app::RenderFailure>(&event)) {
        clearStudyTexts();
        setTitle({});
        if (!std::exchange(deviceIsBack_, true)) {
            deviceNote_.clear();  // the error says what became of it
            showNotes();
        }
        fidelity_->setFullText(tr("No picture"));
        messages_->showError(failure->error);
        emit failed(failure->error);
    }
}

void MainWindow::onModel(const hybrid::ModelNews& model) {
    modelText_->setFullText(modelText(model), whyNoModel(model));
}

void MainWindow::onFrame(const app::FrameShown& frame) {
    QString text = fidelityText(frame);
    if (frame.samplesLeftOut > 0) text += tr(", %1 samples left out").arg(frame.samplesLeftOut);
    QStringList about;
    for (const Message& message : frame.messages)
        about << QString::fromStdString(message.sentence) << QString::fromStdString(message.action);
    if (!about.isEmpty()) text += tr(", less than the full resolution");  // also when the note is dismissed
    // Only when it is news: who has dismissed it has read it.
    if (const QString note = about.join(QLatin1Char(' ')); note != pictureNote_) {
        pictureNote_ = note;
        showNotes();
    }
    if (!std::exchange(deviceIsBack_, true)) {
        deviceNote_ =
            tr("The graphics device stopped responding and was started again. If this comes back, "
               "update the graphics driver.");
        if (notes_->isVisible()) showNotes();  // else it was read and dismissed
    }
    fidelity_->setFullText(text);
    onModel(frame.model);
    QString pictureText = QStringLiteral("%1×%2").arg(frame.width).arg(frame.height);
    if (frame.framesPerSecond > 0.0 && frame.stage == app::Stage::moving) {
        pictureText += tr(", %1/s").arg(frame.framesPerSecond, 0, 'f', 1);
        rateEnds_.start();
    }
    pictureText_->setFullText(pictureText);
    setStudyTexts(study_);
    setTitle(QString::fromStdString(titleOf(study_.identity)));
    emit frameShown(frame);
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

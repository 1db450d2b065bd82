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
#include <utility>
#include <variant>

#include "pipeline/volume/clip_json.h"
#include "viewer/help_boxes.h"
#include "viewer/status_texts.h"

namespace macula::viewer {

namespace {

struct StandardView {
    ViewDirection direction;
    const char* name;
    const char* key;
};
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
    setWindowTitle(QStringLiteral("Macula"));
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
    connect(viewport_, &Viewport::pathDropped, this,
            [this](const QString& path) { open(path.toStdString()); });
    connect(viewport_, &Viewport::keyNotHandled, this, &MainWindow::triggerShortcut);
    viewport_->setSampleLimit(options_.sampleLimit);
    viewport_->setUsesModel(options_.usesModel);
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
    view->addAction(tr("Fit the whole volume\tF"), this, [this] { viewport_->fit(); });

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
    window->setToolTip(
        tr("Of the values: that of the preset, where one was chosen, else that of the series"));
    resetWindow_ = window;
    connect(viewport_, &Viewport::windowDragged, this, [this](QPointF byHeights) {
        if (const auto from = drawing().settings.window) windows_.drag(lookChosen(), *from, byHeights);
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
    description_ = new ElidingLabel(tr("Series"), bar);
    description_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(description_);

    connect(presets_, &QComboBox::activated, this, [this](int index) {
        options_.preset = options_.catalogue.presets[std::size_t(index)];  // kept for the next study
        preset_ = options_.preset;
        windows_.forgetAll();
        redraw();
        viewport_->setFocus();
    });
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
    connect(&loader_, &StudyLoader::loaded, this, [this](const LoadedStudy& study) {
        loading_->hide();
        showStudy(study);
    });
    connect(&loader_, &StudyLoader::failed, this, [this](const Error& error) {
        loading_->hide();
        messages_->showError(error);
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
Drawing MainWindow::drawing() const {
    const trace::Look look = lookChosen();
    Drawing drawing{.transferFunction = preset_,
                    .lights = options_.lights ? options_.lights : defaultLights(options_.catalogue, look),
                    .clip = clip_};
    drawing.settings.look = look;
    QStringList remarks;
    if (look == trace::Look::dvr && shading_->isChecked() && preset_ && preset_->lighting.shade) {
        drawing.settings.shading = trace::Shading::headlight;
        remarks << tr("shaded");
    }
    if (trace::isProjection(look) && study_.volume) {
        const Volume& volume = *study_.volume;
        // A preset that was found for the study says nothing about windows.
        const bool isChosen = preset_ && preset_ == options_.preset;
        drawing.settings.window = windows_.of(look, volume, isChosen ? preset_.get() : nullptr);
        remarks << windowText(*drawing.settings.window, volume.unitName());
    }
    if (clip_ && clip_->mask) remarks << tr("table left out");
    if (clip_ && clip_->hasShape()) remarks << tr("clipped");
    drawing.remarks = remarks.join(QStringLiteral(", ")).toStdString();
    return drawing;
}

void MainWindow::redraw() {
    Drawing now = drawing();
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

void MainWindow::open(StudySource source) {
    loader_.open(std::move(source));
}

void MainWindow::askForFolder() {
    auto* dialog = new QFileDialog(this, tr("Open a folder of DICOM files"), lastFolder_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
        lastFolder_ = folder;
        open(folder.toStdString());
    });
    dialog->open();  // exec() would run a second event loop
}

void MainWindow::showStudy(const LoadedStudy& study) {
    study_ = study;
    const Volume& volume = *study_.volume;
    QStringList notes;
    auto preset = options_.preset;
    if (!preset || !suits(*preset, volume.unit())) {
        const auto wanted = std::exchange(preset, presetFor(options_.catalogue, volume));
        // A curve over Hounsfield units means nothing on the raw numbers of a scanner, and the reverse.
        if (wanted) {
            notes << tr("The preset %1 is not made for this kind of volume; %2 is used instead.")
                         .arg(titleOr(wanted->title, wanted->name), titleOr(preset->title, preset->name));
        }
    }
    select(*presets_, options_.catalogue.presets, preset);
    preset_ = preset;
    // What was hidden of the study before may be what matters in this one.
    table_->setVolume(study_.volume);
    clips_->choose(0);
    windows_.forgetAll();
    clip_.reset();
    clearStudyTexts();
    viewport_->setStudy(study_.volume, drawing(), options_.firstView);

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
    if (!pictureNote_.isEmpty()) notes << pictureNote_;
    if (!deviceNote_.isEmpty()) notes << deviceNote_;
    if (notes.isEmpty()) {
        notes_->hide();
    } else {
        notes_->showNote(notes.join(QLatin1Char(' ')));
    }
}

void MainWindow::setStudyTexts(const LoadedStudy& study) {
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
    description_->setFullText(QString::fromStdString(study.description), why);
    description_->setStatusTip(why);
}

void MainWindow::clearStudyTexts() {
    volumeText_->setFullText({});
    description_->setFullText({});
    description_->setStatusTip({});
    pictureText_->setFullText({});
    modelText_->setFullText({});
}

void MainWindow::onRendered(const RenderEvent& event) {
    if (const auto* frame = std::get_if<FrameShown>(&event)) {
        onFrame(*frame);
    } else if (const auto* ready = std::get_if<DeviceReady>(&event)) {
        deviceText_->setFullText(QString::fromStdString(ready->name));
        deviceText_->setToolTip(QString::fromStdString(ready->description));
    } else if (std::holds_alternative<DeviceRestarting>(event)) {
        fidelity_->setFullText(tr("Starting the graphics device again…"));
        deviceNote_ =
            tr("The graphics device stopped responding and is started again; the picture is made "
               "anew. If this comes back, update the graphics driver.");
        deviceIsBack_ = false;
        showNotes();
    } else if (const auto* changed = std::get_if<ModelChanged>(&event)) {
        if (changed->study == viewport_->study()) onModel(changed->model);
    } else if (const auto* preparing = std::get_if<Preparing>(&event)) {
        fidelity_->setFullText(QString::fromStdString(preparing->what) + QStringLiteral("…"));
    } else if (const auto* failure = std::get_if<RenderFailure>(&event)) {
        clearStudyTexts();
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

void MainWindow::onFrame(const FrameShown& frame) {
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
    if (frame.framesPerSecond > 0.0) pictureText += tr(", %1/s").arg(frame.framesPerSecond, 0, 'f', 1);
    pictureText_->setFullText(pictureText);
    setStudyTexts(study_);
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
    if (!droppedPath(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QString path = droppedPath(event->mimeData());
    if (path.isEmpty()) return;
    event->acceptProposedAction();
    open(path.toStdString());
}

}  // namespace macula::viewer

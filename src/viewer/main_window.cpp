#include "viewer/main_window.h"

#include <QAction>
#include <QApplication>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <utility>
#include <variant>

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
      loading_(new LoadingBar) {
    setWindowTitle(QStringLiteral("Macula"));
    setAcceptDrops(true);
    if (!options_.lights) options_.lights = defaultLights(options_.catalogue);

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

    connect(viewport_, &Viewport::rendered, this, &MainWindow::onRendered);
    connect(viewport_, &Viewport::pathDropped, this,
            [this](const QString& path) { open(path.toStdString()); });
    connect(viewport_, &Viewport::keyNotHandled, this, &MainWindow::triggerShortcut);
    viewport_->setSampleLimit(options_.sampleLimit);
    viewport_->setLights(options_.lights);
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

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    help->addAction(tr("&Keys and Mouse"), this, &MainWindow::showKeys)
        ->setShortcut(QKeySequence(Qt::Key_F1));
    help->addAction(tr("&About Macula"), this, &MainWindow::showAbout);
}

void MainWindow::makeToolBar() {
    QToolBar* bar = addToolBar(tr("Look"));
    bar->setMovable(false);
    presets_ = new QComboBox(bar);
    presets_->setToolTip(tr("What is seen, and in which colours"));
    presets_->setAccessibleName(tr("Preset"));
    fill(*presets_, options_.catalogue.presets);
    presets_->setCurrentIndex(-1);
    lights_ = new QComboBox(bar);
    lights_->setToolTip(tr("Where the light comes from"));
    lights_->setAccessibleName(tr("Lights"));
    fill(*lights_, options_.catalogue.lights);
    select(*lights_, options_.catalogue.lights, options_.lights);
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
        viewport_->setTransferFunction(options_.preset);
        viewport_->setFocus();
    });
    connect(lights_, &QComboBox::activated, this, [this](int index) {
        options_.lights = options_.catalogue.lights[std::size_t(index)];
        viewport_->setLights(options_.lights);
        viewport_->setFocus();
    });
}

void MainWindow::makeStatusBar() {
    fidelity_ = new ElidingLabel(tr("How true the picture is"));
    pictureText_ = new ElidingLabel(tr("Traced pixels, pictures per second"));
    volumeText_ = new ElidingLabel(tr("Voxels and their size"));
    deviceText_ = new ElidingLabel(tr("Device"));
    // How far the picture can be trusted is the last thing to be cut short.
    fidelity_->setMinimumWidth(
        fontMetrics().horizontalAdvance(tr("Path traced, %1 of %1 samples, denoised, converging").arg(8888)));
    statusBar()->addWidget(loading_);
    statusBar()->addWidget(fidelity_, 1);
    statusBar()->addPermanentWidget(pictureText_);
    statusBar()->addPermanentWidget(volumeText_);
    statusBar()->addPermanentWidget(deviceText_);
    fidelity_->setFullText(tr("No study is open"));
}

void MainWindow::connectLoader() {
    connect(&loader_, &StudyLoader::began, this, [this] {
        messages_->hide();
        loading_->begin();
    });
    connect(&loader_, &StudyLoader::progressed, loading_, &LoadingBar::setProgress);
    connect(loading_, &LoadingBar::cancelClicked, &loader_, &StudyLoader::cancel);
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
    clearStudyTexts();
    viewport_->setStudy(study_.volume, preset, options_.firstView);

    for (const std::string& assumption : volume.provenance().assumptions) {
        notes << QString::fromStdString(assumption);
    }
    for (const std::string& message : study_.messages) notes << QString::fromStdString(message);
    messages_->hide();
    studyNotes_ = notes;
    pictureNote_.clear();
    showNotes();
    emit studyShown();
}

void MainWindow::showNotes() {
    QStringList notes = studyNotes_;
    if (!pictureNote_.isEmpty()) notes << pictureNote_;
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
}

void MainWindow::onRendered(const RenderEvent& event) {
    if (const auto* frame = std::get_if<FrameShown>(&event)) {
        onFrame(*frame);
    } else if (const auto* ready = std::get_if<DeviceReady>(&event)) {
        deviceText_->setFullText(QString::fromStdString(ready->name));
        deviceText_->setToolTip(QString::fromStdString(ready->description));
    } else if (std::holds_alternative<DeviceRestarting>(event)) {
        fidelity_->setFullText(tr("Starting the graphics device again…"));
        messages_->showNote(
            tr("The graphics device stopped responding and is started again; the picture is "
               "made anew. If this comes back, update the graphics driver."));
    } else if (const auto* preparing = std::get_if<Preparing>(&event)) {
        fidelity_->setFullText(QString::fromStdString(preparing->what) + QStringLiteral("…"));
    } else if (const auto* failure = std::get_if<RenderFailure>(&event)) {
        clearStudyTexts();
        fidelity_->setFullText(tr("No picture"));
        messages_->showError(failure->error);
        emit failed(failure->error);
    }
}

void MainWindow::onFrame(const FrameShown& frame) {
    QString text = tr("Path traced, %1 of %2 samples, ").arg(frame.samplesPerPixel).arg(frame.sampleLimit);
    if (frame.denoised) text += tr("denoised, ");
    switch (frame.stage) {
        case Stage::moving:
            text = frame.denoised ? tr("Path traced preview, denoised") : tr("Path traced preview, smoothed");
            if (frame.scale > 1) text += tr(", 1/%1 of the pixels each way").arg(frame.scale);
            break;
        case Stage::converging:
            text += tr("converging");
            break;
        case Stage::converged:
            text += tr("complete");
            break;
    }
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
    fidelity_->setFullText(text);
    pictureText_->setFullText(
        tr("%1×%2, %3/s").arg(frame.width).arg(frame.height).arg(frame.framesPerSecond, 0, 'f', 1));
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

void MainWindow::showKeys() {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Keys and Mouse"),
                                tr("<table cellspacing='6'>"
                                   "<tr><td>Left drag, arrows</td><td>Walk around the patient</td></tr>"
                                   "<tr><td>Middle drag, Shift + left drag, Shift + arrows</td><td>Move "
                                   "sideways</td></tr>"
                                   "<tr><td>Wheel, right drag, Ctrl + left drag, + and −</td><td>Closer, "
                                   "farther</td></tr>"
                                   "<tr><td>A, P, L, R, S, I</td><td>Look from anterior, posterior, left, "
                                   "right, superior, inferior</td></tr>"
                                   "<tr><td>F</td><td>Fit the whole volume</td></tr>"
                                   "<tr><td>Ctrl + O, or drop a folder</td><td>Open a study</td></tr>"
                                   "</table>"),
                                QMessageBox::Close, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

void MainWindow::showAbout() {
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("About Macula"),
        tr("<p><b>Macula %1</b></p><p>Path-traced anatomy from DICOM.</p>"
           "<p>Not a medical device, and <b>not for primary diagnosis</b>.</p><p>Licence: Apache-2.0.</p>")
            .arg(QApplication::applicationVersion()),
        QMessageBox::Close, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

}  // namespace macula::viewer

// What the window draws beside itself: movies, and its model as a file.
#include <QDockWidget>
#include <QFileDialog>
#include <QMenu>
#include <QScrollArea>
#include <array>

#include "base/atomic_file.h"
#include "viewer/output/model_export.h"
#include "viewer/output/movie_export.h"
#include "viewer/output/movie_panel.h"
#include "viewer/output/movie_stamps.h"
#include "viewer/output/video_encoder.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

namespace {

// A kind of file, and whether colours in it are as displayed.
struct ModelFilter {
    const char* title;
    const char* suffix;
    bool displayColours;
};
constexpr std::array<ModelFilter, 5> kModelFilters{
    {{QT_TRANSLATE_NOOP("macula::viewer::MainWindow", "glTF, for other programs (*.glb)"), "glb", true},
     {QT_TRANSLATE_NOOP("macula::viewer::MainWindow", "PLY, for other programs (*.ply)"), "ply", true},
     {QT_TRANSLATE_NOOP("macula::viewer::MainWindow", "PLY, exact, in linear light (*.ply)"), "ply", false},
     {QT_TRANSLATE_NOOP("macula::viewer::MainWindow", "SPZ, small, for other programs (*.spz)"), "spz", true},
     {QT_TRANSLATE_NOOP("macula::viewer::MainWindow",
                        "Training that can go on, with its pictures (*.macula)"),
      "macula", false}}};

}  // namespace

void MainWindow::makeMovies() {
    movie_ = new MoviePanel([this]() -> std::optional<Camera> {
        if (!study().volume) return std::nullopt;
        return toCamera(viewport_->camera());
    });
    auto* dock = new QDockWidget(tr("Movie"), this);
    dock->setObjectName(QStringLiteral("movie-panel"));
    auto* scrolled = new QScrollArea(dock);  // a low window stays low
    scrolled->setFocusPolicy(Qt::NoFocus);
    scrolled->setWidgetResizable(true);
    scrolled->setFrameShape(QFrame::NoFrame);
    scrolled->setWidget(movie_);
    dock->setWidget(scrolled);
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    dock->hide();
    panels_ << dock->toggleViewAction();
    connect(dock, &QDockWidget::visibilityChanged, movie_, [this](bool isVisible) {
        if (isVisible) movie_->setHasEncoder(!VideoEncoder::find().isEmpty());
    });
    connect(movie_, &MoviePanel::drawAsked, this, &MainWindow::askWhereToDrawMovie);
    connect(movie_, &MoviePanel::openAsked, this, &MainWindow::askForPath);
    connect(movie_, &MoviePanel::saveAsked, this, &MainWindow::askWhereToSavePath);
    // Views of one patient mean nothing for the next.
    connect(this, &MainWindow::studyShown, movie_, [this] { movie_->setViews({}); });

    movieExport_ = new MovieExport(options_.device, this);
    filming_ = new WorkBar;
    connect(movieExport_, &MovieExport::began, this, [this] {
        messages_->hide();
        filming_->begin(tr("Drawing the movie"));
    });
    connect(movieExport_, &MovieExport::progressed, filming_, &WorkBar::setProgress);
    connect(filming_, &WorkBar::cancelClicked, movieExport_, &MovieExport::cancel);
    connect(movieExport_, &MovieExport::ended, filming_, &QWidget::hide);
    connect(movieExport_, &MovieExport::written, messages_, &MessageBar::showNote);

    modelExport_ = new ModelExport(this);
    savingModel_ = new WorkBar;
    connect(modelExport_, &ModelExport::began, this, [this] {
        messages_->hide();
        savingModel_->begin(tr("Writing the model"));
    });
    connect(savingModel_, &WorkBar::cancelClicked, modelExport_, &ModelExport::cancel);
    connect(modelExport_, &ModelExport::ended, savingModel_, &QWidget::hide);
    connect(modelExport_, &ModelExport::written, messages_, &MessageBar::showNote);
    connect(viewport_, &Viewport::rendered, this, [this](const live::RenderEvent& event) {
        if (const auto* taken = std::get_if<live::ModelSnapshot>(&event)) modelExport_->onTaken(*taken);
    });
    const auto tell = [this](const Error& error) {
        messages_->showError(error);
        emit failed(error);
    };
    connect(movieExport_, &MovieExport::failed, this, tell);
    connect(modelExport_, &ModelExport::failed, this, tell);
}

void MainWindow::addOutputActions(QMenu& file) {
    QAction* movie = file.addAction(tr("Save Mo&vie…"), this, [this] {
        auto* dock = findChild<QDockWidget*>(QStringLiteral("movie-panel"));
        dock->show();
        dock->raise();
        movie_->setFocus();
    });
    movie->setObjectName(QStringLiteral("save-movie"));
    movie->setToolTip(tr("A turntable or a way of the camera as pictures, and as a video"));
    QAction* model = file.addAction(tr("Save Mo&del…"), this, &MainWindow::askWhereToSaveModel);
    model->setObjectName(QStringLiteral("save-model"));
    model->setToolTip(
        tr("The preview as a model in mm of the patient (3D Gaussians), for this and other programs"));
}

void MainWindow::askWhereToDrawMovie() {
    if (!hasPictureFor(tr("There is nothing to draw yet."))) return;
    const Camera camera = toCamera(viewport_->camera());
    const auto path = movie_->pathFrom(camera);
    if (!path) return;
    // What is on screen now: while a person looks for a folder another study may come.
    MovieRequest request;
    request.sequence.picture.volume = study().volume;
    request.sequence.picture.seriesDigest = study().seriesDigest;
    request.sequence.picture.drawing = shown_->drawing();
    request.sequence.picture.sizePx = {movie_->sizePx().width(), movie_->sizePx().height()};
    request.sequence.picture.effort.quality = movie_->quality();
    request.sequence.path = *path;
    request.sequence.frames = movie_->frames();
    request.sequence.isClosed = movie_->isClosed();
    request.picturesPerS = movie_->picturesPerS();
    request.wantsVideo = movie_->wantsVideo();
    const std::vector<std::string> lines =
        movie_->withNames() ? linesOf(study().identity) : std::vector<std::string>();
    if (movie_->withLetters() || !lines.empty()) {
        request.sequence.stampsFor = [lines, withLetters = movie_->withLetters(),
                                      sizePx = request.sequence.picture.sizePx](const Camera& from) {
            const scene::EdgeLetters letters =
                withLetters ? scene::edgeLetters(scene::orbitCameraOf(from)) : scene::EdgeLetters{};
            return stampsOf(lines, letters, sizePx);
        };
    }
    auto* dialog =
        new QFileDialog(this, tr("Choose a folder for the pictures"), folders_.of(FolderKind::movies));
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    ask(dialog, FolderKind::movies, [this, request = std::move(request)](const QString& folder) {
        MovieRequest now = request;
        now.sequence.folder = folder.toStdString();
        movieExport_->start(std::move(now));
    });
}

void MainWindow::askForPath() {
    auto* dialog = new QFileDialog(this, tr("Open a way of the camera"), folders_.of(FolderKind::movies),
                                   tr("Ways (*.json)"));
    dialog->setFileMode(QFileDialog::ExistingFile);
    ask(dialog, FolderKind::movies, [this](const QString& file) {
        auto path = scene::readCameraPath(file.toStdString());
        if (!path) return messages_->showError(path.error());
        messages_->hide();
        movie_->setViews(*std::move(path));
    });
}

void MainWindow::askWhereToSavePath() {
    if (movie_->views().stops.empty()) return;
    auto* dialog = new QFileDialog(this, tr("Save the way of the camera"), folders_.of(FolderKind::movies),
                                   tr("Ways (*.json)"));
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("json"));
    dialog->selectFile(QStringLiteral("path.json"));
    ask(dialog, FolderKind::movies, [this, json = toJson(movie_->views())](const QString& file) {
        tellOfFile(writeTextAtomically(file.toStdString(), json),
                   tr("The way is written to %1. macula hybrid draws it with --path %1.").arg(file));
    });
}

void MainWindow::askWhereToSaveModel() {
    if (!hasPictureFor(tr("There is no model to save yet."))) return;
    QStringList filters;
    for (const ModelFilter& filter : kModelFilters) filters << tr(filter.title);
    auto* dialog = new QFileDialog(this, tr("Save the model"), folders_.of(FolderKind::models));
    dialog->setNameFilters(filters);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QLatin1String(kModelFilters.front().suffix));
    dialog->selectFile(QStringLiteral("model"));
    const auto chosen = [filters, dialog]() -> const ModelFilter& {
        const auto at = filters.indexOf(dialog->selectedNameFilter());
        return kModelFilters.at(std::size_t(std::max<qsizetype>(at, 0)));
    };
    connect(dialog, &QFileDialog::filterSelected, dialog,
            [dialog, chosen] { dialog->setDefaultSuffix(QLatin1String(chosen().suffix)); });
    ask(dialog, FolderKind::models, [this, chosen](const QString& file) {
        const bool holdsTraining = file.endsWith(QLatin1String(".macula"), Qt::CaseInsensitive);
        // Of what is drawn now: the model is that of now too.
        modelExport_->expect({.path = file.toStdString(),
                              .displayColours = chosen().displayColours && !holdsTraining,
                              .volume = study().volume,
                              .drawing = shown_->drawing()},
                             viewport_->askForModel(holdsTraining));
    });
}

}  // namespace macula::viewer

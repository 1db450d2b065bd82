#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/output/models_controller.h"

#include <QMainWindow>
#include <QMenu>
#include <algorithm>
#include <array>
#include <new>
#include <utility>
#include <variant>

#include "pipeline/splat/files/model_file.h"
#include "viewer/menus/controls.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/work_status.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

namespace {

// A kind of file, and whether it stores display colours.
struct ModelFilter {
    const char* title;
    const char* suffix;
    bool displayColours;
};
constexpr std::array<ModelFilter, 5> kModelFilters{
    {{QT_TRANSLATE_NOOP("macula::viewer::ModelsController", "glTF, for other programs (*.glb)"), "glb", true},
     {QT_TRANSLATE_NOOP("macula::viewer::ModelsController", "PLY, for other programs (*.ply)"), "ply", true},
     {QT_TRANSLATE_NOOP("macula::viewer::ModelsController", "PLY, exact, in linear light (*.ply)"), "ply",
      false},
     {QT_TRANSLATE_NOOP("macula::viewer::ModelsController", "SPZ, small, for other programs (*.spz)"), "spz",
      true},
     {QT_TRANSLATE_NOOP("macula::viewer::ModelsController",
                        "Training that can go on, with its pictures (*.macula)"),
      "macula", false}}};

}  // namespace

ModelExport::ModelExport(QObject* parent)
    : QObject(parent),
      job_(this, {.ended = [this](const Result<std::size_t>& limited) {
               Q_EMIT ended();
               if (!limited) {
                   if (limited.error().code != ErrorCode::cancelled) Q_EMIT failed(limited.error());
                   return;
               }
               QString told =
                   tr("The model is written to %1.").arg(QString::fromStdString(request_.path.string()));
               if (*limited > 0)
                   told +=
                       tr(" %Ln of its Gaussians have numbers that this format cannot hold; they were "
                          "limited.",
                          nullptr, int(*limited));
               const splat::ModelFormat* format = splat::modelFormatOf(request_.path);
               if (format != nullptr && format->keepsTraining())
                   told += tr(" It holds pictures of the study.");
               Q_EMIT written(told);
           }}) {}

void ModelExport::expect(Request request, std::uint64_t number) {
    cancel();
    request_ = std::move(request);
    expected_ = number;
    Q_EMIT began();
}

void ModelExport::cancel() {
    const bool wasExpected = std::exchange(expected_, 0) != 0;
    forgetStudy();
    if (job_.cancel() || wasExpected) Q_EMIT ended();
}

// Otherwise a closed study would stay in memory after its model was saved.
void ModelExport::forgetStudy() {
    request_.volume.reset();
    request_.drawing = {};
}

void ModelExport::onTaken(const live::ModelSnapshot& taken) {
    if (taken.request != expected_ || expected_ == 0) return;
    expected_ = 0;
    const Request request =
        std::exchange(request_, Request{.path = request_.path, .displayColours = request_.displayColours});
    if (taken.error) {
        Q_EMIT ended();
        Q_EMIT failed(*taken.error);
        return;
    }
    if (!taken.splats) {
        Q_EMIT ended();
        Q_EMIT failed(
            {ErrorCode::inputNotUsable,
             Text::verbatim(tr("There is no model of this picture.").toStdString()),
             {},
             Text::verbatim(
                 tr("Only Cinematic and Clear in lights that stay in place have one. Wait until the status "
                    "line says that it learns.")
                     .toStdString())});
        return;
    }
    live::ModelToWrite model{.splats = taken.splats,
                             .gain = taken.gain,
                             .state = taken.state,
                             .volume = request.volume,
                             .drawing = request.drawing};
    job_.start([model = std::move(model), path = request.path,
                displayColours = request.displayColours](Progress& progress) -> Result<std::size_t> {
        try {
            return live::writeModelFile(path, model, displayColours, progress);
        } catch (const std::bad_alloc&) {
            return Error{ErrorCode::outOfMemory,
                         Text("There is not enough memory to write the model."),
                         {},
                         Text("Close other programs.")};
        }
    });
}

ModelsController::ModelsController(const WindowContext& context)
    : QObject(&context.window), context_(context), export_(new ModelExport(this)), bar_(new WorkBar) {
    showWork(*export_, *bar_, tr("Writing the model"), context_.notifications);
    connect(export_, &ModelExport::written, this, [this](const QString& told) {
        context_.notifications.showNote(told);
        Q_EMIT written();
    });
    connect(&context_.viewport, &Viewport::rendered, this, [this](const live::RenderEvent& event) {
        if (const auto* taken = std::get_if<live::ModelSnapshot>(&event)) export_->onTaken(*taken);
    });
}

void ModelsController::addActions(QMenu& file) {
    QAction* model = file.addAction(tr("Save Mo&del…"), this, &ModelsController::askWhereToSave);
    describe(*model, "save-model",
             tr("The preview as a model in mm of the patient (3D Gaussians), for this and other programs"));
}

QString ModelsController::unfinished() const {
    return export_->running() ? tr("A model is still being written.") : QString();
}

void ModelsController::cancel() {
    export_->cancel();
}

void ModelsController::askWhereToSave() {
    if (!context_.notifications.refuseUnless(context_.session.hasStudy(),
                                             tr("There is no model to save yet.")))
        return;
    if (!context_.notifications.refuseUnless(!context_.viewport.showsOtherPhase(),
                                             whyNotOfOpenPhase(context_.viewport)))
        return;
    QStringList filters;
    for (const ModelFilter& filter : kModelFilters) filters << tr(filter.title);
    auto* dialog =
        context_.files.toSave(FolderKind::models, tr("Save the model"), filters.join(QLatin1String(";;")),
                              QLatin1String(kModelFilters.front().suffix), QStringLiteral("model"));
    const auto chosen = [filters, dialog]() -> const ModelFilter& {
        const auto at = filters.indexOf(dialog->selectedNameFilter());
        return kModelFilters.at(std::size_t(std::max<qsizetype>(at, 0)));
    };
    connect(dialog, &QFileDialog::filterSelected, dialog,
            [dialog, chosen] { dialog->setDefaultSuffix(QLatin1String(chosen().suffix)); });
    context_.files.ask(dialog, FolderKind::models, [this, chosen](const QString& file) {
        // Phases may have played on meanwhile.
        if (!context_.notifications.refuseUnless(!context_.viewport.showsOtherPhase(),
                                                 whyNotOfOpenPhase(context_.viewport)))
            return;
        const bool holdsTraining = file.endsWith(QLatin1String(".macula"), Qt::CaseInsensitive);
        // Takes the drawing of this moment, because the model will be that of this moment, too.
        export_->expect({.path = file.toStdString(),
                         .displayColours = chosen().displayColours && !holdsTraining,
                         .volume = context_.session.study().volume,
                         .drawing = context_.shown.drawing()},
                        context_.viewport.askForModel(holdsTraining));
    });
}

}  // namespace macula::viewer

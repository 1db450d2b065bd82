#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/output/models_controller.h"

#include <QMainWindow>
#include <QMenu>
#include <algorithm>
#include <array>
#include <variant>

#include "viewer/output/model_export.h"
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
    model->setObjectName(QStringLiteral("save-model"));
    model->setToolTip(
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

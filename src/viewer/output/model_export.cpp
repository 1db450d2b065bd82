#include "viewer/output/model_export.h"

#include <new>
#include <utility>

#include "pipeline/splat/files/model_file.h"

namespace macula::viewer {

ModelExport::ModelExport(QObject* parent)
    : QObject(parent),
      job_(this,
           {.progressed = [](const ProgressUpdate&) {},
            .ended =
                [this](const Result<std::size_t>& limited) {
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

}  // namespace macula::viewer

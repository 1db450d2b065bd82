#include "viewer/output/picture_export.h"

#include <new>
#include <utility>

#include "viewer/language/window_language.h"

namespace macula::viewer {

PictureExport::PictureExport(std::string preferredDevice, QObject* parent)
    : QObject(parent),
      preferredDevice_(std::move(preferredDevice)),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          Q_EMIT progressed(inWindowsLanguage(update.stage), update.fraction);
                      },
                  .ended = [this](const auto& outcome) { onEnded(outcome); }}) {}

void PictureExport::start(pictures::ViewPicture picture) {
    path_ = QString::fromStdString(picture.output.string());
    using Written = Result<std::vector<Text>>;
    job_.start([picture = std::move(picture), device = preferredDevice_](Progress& progress) -> Written {
        try {
            return pictures::writeViewPicture(picture, device, progress);
        } catch (const std::bad_alloc&) {
            return Error{ErrorCode::outOfMemory,
                         Text("There is not enough memory for this picture."),
                         {},
                         Text("Choose a smaller size, or close other programs.")};
        }
    });
    Q_EMIT began();
}

void PictureExport::cancel() {
    if (job_.cancel()) Q_EMIT ended();
}

void PictureExport::onEnded(const Result<std::vector<Text>>& outcome) {
    Q_EMIT ended();
    if (!outcome) {
        if (outcome.error().code != ErrorCode::cancelled) Q_EMIT failed(outcome.error());
        return;
    }
    Q_EMIT written(path_, inWindowsLanguage(*outcome));
}

}  // namespace macula::viewer

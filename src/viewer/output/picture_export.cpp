#include "viewer/output/picture_export.h"

#include <new>
#include <utility>

#include "viewer/language/core_words.h"

namespace macula::viewer {

PictureExport::PictureExport(std::string preferredDevice, QObject* parent)
    : QObject(parent),
      preferredDevice_(std::move(preferredDevice)),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          emit progressed(inWindowsLanguage(update.stage), update.fraction);
                      },
                  .ended = [this](const auto& outcome) { onEnded(outcome); }}) {}

void PictureExport::start(pictures::ViewPicture picture) {
    path_ = QString::fromStdString(picture.output.string());
    using Written = Result<std::vector<std::string>>;
    job_.start([picture = std::move(picture), device = preferredDevice_](Progress& progress) -> Written {
        try {
            return pictures::writeViewPicture(picture, device, progress);
        } catch (const std::bad_alloc&) {
            return Error{ErrorCode::outOfMemory,
                         "There is not enough memory for this picture.",
                         {},
                         "Choose a smaller size, or close other programs."};
        }
    });
    emit began();
}

void PictureExport::cancel() {
    if (job_.cancel()) emit ended();
}

void PictureExport::onEnded(const Result<std::vector<std::string>>& outcome) {
    emit ended();
    if (!outcome) {
        if (outcome.error().code != ErrorCode::cancelled) emit failed(outcome.error());
        return;
    }
    QStringList notes;
    for (const std::string& note : *outcome) notes << inWindowsLanguage(note);
    emit written(path_, notes);
}

}  // namespace macula::viewer

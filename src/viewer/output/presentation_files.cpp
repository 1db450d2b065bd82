#include "viewer/output/presentation_files.h"

#include <exception>
#include <new>
#include <utility>

#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

Error tooLarge() {
    return {ErrorCode::outOfMemory,
            Text("There is not enough memory for the presentation state."),
            {},
            Text("Close other programs.")};
}

// Hides the message of a library or file system, which may contain a path.
Error notWritten() {
    return {ErrorCode::outputNotWritable,
            Text("The presentation state could not be written."),
            {},
            Text("Choose another folder, and check free space and permissions.")};
}

Error notRead() {
    return {ErrorCode::inputNotUsable,
            Text("The presentation state could not be read."),
            {},
            Text("The file may be damaged; choose another one.")};
}

}  // namespace

PresentationFiles::PresentationFiles(QObject* parent)
    : QObject(parent),
      saving_(this, {.ended =
                         [this](const auto& leftOut) {
                             if (leftOut) {
                                 Q_EMIT saved(path_, inWindowsLanguage(*leftOut));
                             } else {
                                 Q_EMIT failed(leftOut.error());
                             }
                         }}),
      opening_(this, {.ended =
                          [this](const auto& presented) {
                              if (presented) {
                                  Q_EMIT opened(presented->state, inWindowsLanguage(presented->notes));
                              } else {
                                  Q_EMIT failed(presented.error());
                              }
                          }}),
      openingOnSlices_(this, {.ended = [this](const auto& shown) {
                           if (shown) {
                               Q_EMIT openedOnSlices(*shown, inWindowsLanguage(shown->notes));
                           } else {
                               Q_EMIT failed(shown.error());
                           }
                       }}) {}

void PresentationFiles::save(const std::filesystem::path& path, scene::PresentationRequest request) {
    path_ = QString::fromStdString(path.string());
    saving_.start([path, request = std::move(request)](Progress&) -> Result<std::vector<Text>> {
        try {
            return scene::writePresentation(path, request);
        } catch (const std::bad_alloc&) {
            return tooLarge();
        } catch (const std::exception&) {
            return notWritten();
        }
    });
}

void PresentationFiles::open(const std::filesystem::path& path, std::shared_ptr<const Volume> volume,
                             std::string seriesDigest, std::vector<dicom::ReferencedFrames> images,
                             scene::StudyState usual, double aspectWidthOverHeight) {
    openingOnSlices_.cancel();
    opening_.start([path, volume = std::move(volume), digest = std::move(seriesDigest),
                    images = std::move(images), usual = std::move(usual),
                    aspectWidthOverHeight](Progress&) -> Result<scene::PresentedState> {
        try {
            MACULA_TRY(scene::PresentedState presented,
                       scene::openPresentation(path, *volume, digest, images, usual));
            scene::widenFor(presented, aspectWidthOverHeight);
            return presented;
        } catch (const std::bad_alloc&) {
            return tooLarge();
        } catch (const std::exception&) {
            return notRead();
        }
    });
}

void PresentationFiles::openOnSlices(const std::filesystem::path& path, study::OpenedStudy study,
                                     scene::SliceState usual) {
    opening_.cancel();
    openingOnSlices_.start([path, study = std::move(study),
                            usual = std::move(usual)](Progress&) -> Result<scene::SoftcopyOnSlices> {
        try {
            return scene::openSoftcopy(path, study, usual);
        } catch (const std::bad_alloc&) {
            return tooLarge();
        } catch (const std::exception&) {
            return notRead();
        }
    });
}

void PresentationFiles::cancelOpening() {
    opening_.cancel();
    openingOnSlices_.cancel();
}

}  // namespace macula::viewer

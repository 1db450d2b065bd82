#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/planar/planar_saving.h"

#include <QMainWindow>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/atomic_file.h"
#include "base/exceptions.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

namespace {

std::optional<std::size_t> placeOf(const study::ImageMeasurement& measurement, const dicom::Stack& stack) {
    const auto frame = std::ranges::find_if(stack.frames, [&](const dicom::Frame& each) {
        return each.number == measurement.frame &&
               study::imageKey(each.instance->sopInstanceUid) == measurement.image;
    });
    if (frame == stack.frames.end()) return {};
    return std::size_t(frame - stack.frames.begin());
}

// Reads each image again: a table has the numbers of all frames, of which one is on screen.
Result<bool> writeTable(const std::filesystem::path& path, const dicom::Stack& stack,
                        const std::vector<study::ImageMeasurement>& measurements, const CancelToken& cancel) {
    std::vector<study::ListedImageMeasurement> listed;
    std::optional<std::size_t> read;
    dicom::PlanarHeader header;
    std::optional<dicom::PlanarFrame> pixels;
    std::vector<std::pair<std::size_t, const study::ImageMeasurement*>> places;
    for (const study::ImageMeasurement& each : measurements)
        if (const auto place = placeOf(each, stack)) places.emplace_back(*place, &each);
    std::ranges::stable_sort(places, {}, [](const auto& each) { return each.first; });
    for (const auto& each : places) {
        if (read != each.first) {
            const dicom::Frame& frame = stack.frames[each.first];
            MACULA_TRY(header, dicom::readPlanarHeader(frame.instance->file, frame.number));
            MACULA_TRY(pixels, dicom::loadPlanarFrame(stack, each.first, header, cancel));
            read = each.first;
        }
        listed.push_back(
            {*each.second, int(each.first) + 1, study::measured(*each.second, header, &*pixels)});
    }
    MACULA_TRY_VOID(writeTextAtomically(path, study::csvOf(listed)));
    return true;
}

}  // namespace

Result<void> writePicture(const std::filesystem::path& path, const QImage& picture) {
    return writeAtomically(path, [&](const std::filesystem::path& temporary) -> Result<void> {
        if (picture.save(QString::fromStdString(temporary.string()), "PNG")) return {};
        return Error{ErrorCode::outputNotWritable, Text("The picture could not be written."), path.string(),
                     Text("Choose another folder, and check free space and permissions.")};
    });
}

PlanarSaving::PlanarSaving(const WindowContext& context)
    : QObject(&context.window),
      context_(context),
      writing_(this, {.ended = [this](const auto& written) {
                   if (written)
                       context_.notifications.showDone(tr("The measurements are written to %1.").arg(path_),
                                                       {});
                   else
                       context_.notifications.failUnlessCancelled(written.error());
               }}) {}

void PlanarSaving::savePicture(const QImage& picture) {
    auto* dialog = context_.files.toSave(FolderKind::pictures, tr("Save the picture"), tr("Pictures (*.png)"),
                                         QStringLiteral("png"), QStringLiteral("image"));
    context_.files.ask(dialog, FolderKind::pictures, [this, picture](const QString& path) {
        context_.notifications.showOutcome(writePicture(path.toStdString(), picture),
                                           tr("The picture is written to %1, without names.").arg(path));
    });
}

void PlanarSaving::saveMeasurements(std::shared_ptr<const study::FoundVolumes> found,
                                    const dicom::Stack* stack,
                                    std::vector<study::ImageMeasurement> measurements) {
    if (measurements.empty() || stack == nullptr)
        return context_.notifications.refuse(tr("There are no measurements to save."),
                                             tr("Measure something on an image first: D draws a distance."));
    auto* dialog =
        context_.files.toSave(FolderKind::measurements, tr("Save the measurements"), tr("Table (*.csv)"),
                              QStringLiteral("csv"), QStringLiteral("measurements"));
    context_.files.ask(
        dialog, FolderKind::measurements,
        [this, found = std::move(found), stack, measurements = std::move(measurements)](const QString& path) {
            path_ = path;
            writing_.start(
                [found, stack, measurements, path = path.toStdString()](Progress& progress) -> Result<bool> {
                    try {
                        return writeTable(path, *stack, measurements, progress.token());
                    } catch (const std::exception& thrown) {
                        return errorOf(thrown, Text("write the measurements"));
                    }
                });
        });
}

}  // namespace macula::viewer

#include "viewer/archive/objects_to_send.h"

#include <exception>
#include <iterator>
#include <utility>

#include "base/draft.h"
#include "base/exceptions.h"
#include "base/private_file.h"
#include "net/sources/source_address.h"
#include "net/sources/source_list.h"
#include "study/open/same_patient.h"

namespace macula::viewer {

namespace {

namespace fs = std::filesystem;

Error ofSomebodyElse() {
    return {ErrorCode::inputNotUsable,
            Text("What was made names another patient than the question did; nothing was sent."),
            {},
            Text("The files of this study may have changed on the disk. Open it again.")};
}

// Returns the files, and adds to the notes.
Result<std::vector<fs::path>> makeObjects(ObjectsToSend& objects, const fs::path& folder,
                                          const std::string& device, std::vector<Text>& notes,
                                          Progress& progress) {
    std::vector<fs::path> made;
    const auto add = [&](const fs::path& file, std::vector<Text> more) {
        made.push_back(file);
        notes.insert(notes.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    };
    if (objects.picture) {
        objects.picture->output = folder / "picture.dcm";
        MACULA_TRY(auto more, pictures::writeViewPicture(*objects.picture, device, progress));
        add(objects.picture->output, std::move(more));
    }
    if (objects.view) {
        MACULA_TRY(auto more, scene::writePresentation(folder / "view.dcm", *objects.view));
        add(folder / "view.dcm", std::move(more));
    }
    if (objects.measurements) {
        MACULA_TRY(auto more,
                   scene::writeMeasurementReport(folder / "measurements.dcm", *objects.measurements));
        add(folder / "measurements.dcm", std::move(more));
    }
    if (objects.segmentation) {
        MACULA_TRY(auto more, scene::writeSegmentation(folder / "segmentation.dcm", *objects.segmentation));
        add(folder / "segmentation.dcm", std::move(more));
    }
    return made;
}

// By what the files say of themselves.
Result<void> checkPatient(const ObjectsToSend& objects, const study::FilesToSend& made) {
    const bool isDeidentified = (objects.picture && objects.picture->isDeidentified) ||
                                (objects.view && objects.view->isDeidentified) ||
                                (objects.measurements && objects.measurements->isDeidentified) ||
                                (objects.segmentation && objects.segmentation->isDeidentified);
    for (const study::Identity& named : made.patients) {
        if (!isDeidentified && study::samePatient(objects.patient, named) == study::SamePatient::no)
            return ofSomebodyElse();
    }
    return {};
}

Result<study::OutboxEntry> queueAll(study::Outbox& outbox, ObjectsToSend objects, const std::string& device,
                                    std::vector<Text>& notes, Progress& progress) {
    MACULA_TRY(const Draft draft, Draft::beside(outbox.folder() / "made", Draft::Kind::folder));
    MACULA_TRY_VOID(makePrivateFolder(draft.path()));
    MACULA_TRY(const auto paths, makeObjects(objects, draft.path(), device, notes, progress));
    MACULA_TRY(const net::SourceList list, net::SourceList::read(net::SourceFiles::ofUser()));
    MACULA_TRY(const net::Source archive, list.find(objects.archive));
    study::ToQueue request{.archive = archive.name,
                           .address = net::addressOf(archive),
                           .files = {},
                           .patients = objects.files.patients};
    if (!paths.empty()) {
        MACULA_TRY(const study::FilesToSend made, study::filesToSend(paths, progress));
        MACULA_TRY_VOID(checkPatient(objects, made));
        for (const fs::path& file : made.files) request.files.push_back({file});
        request.patients.insert(request.patients.begin(), made.patients.begin(), made.patients.end());
    }
    for (const fs::path& file : objects.files.files) request.files.push_back({file});
    MACULA_TRY(const std::string id, outbox.queue(request, progress));
    return outbox.find(id);
}

}  // namespace

Result<ObjectsSent> sendObjects(ObjectsToSend objects, const std::string& device, Progress& progress) {
    try {
        ObjectsSent outcome{.archive = objects.archive, .asked = objects.count(), .sent = {}, .notes = {}};
        MACULA_TRY(study::Outbox outbox, study::Outbox::open());
        MACULA_TRY(const study::OutboxEntry entry,
                   queueAll(outbox, std::move(objects), device, outcome.notes, progress));
        outcome.sent = study::sendQueued(outbox, {&entry, 1}, study::openArchiveOfUser, progress);
        return outcome;
    } catch (const std::exception& thrown) {
        return errorOf(thrown, Text("make the objects to send"));
    }
}

}  // namespace macula::viewer

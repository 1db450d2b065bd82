// What a person sends to an archive from the window: objects made of the open study, and files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pictures/view_picture.h"
#include "scene/presentation/presentation_file.h"
#include "scene/segments/segmentation_file.h"
#include "scene/slices/reported_measurements.h"
#include "study/archive/files_to_send.h"
#include "study/outbox/queue_sending.h"

namespace macula::viewer {

struct ObjectsToSend {
    std::string archive;
    // Of what was on screen when the person asked; without an output.
    std::optional<pictures::ViewPicture> picture;
    std::optional<scene::PresentationRequest> view;
    std::optional<scene::ReportRequest> measurements;
    std::optional<scene::SegmentationRequest> segmentation;
    study::Identity patient;   // of these, as the question named it
    study::FilesToSend files;  // chosen from a disk; their patients were named, too

    std::size_t count() const {
        return files.files.size() + (picture ? 1 : 0) + (view ? 1 : 0) + (measurements ? 1 : 0) +
               (segmentation ? 1 : 0);
    }
};

struct ObjectsSent {
    std::string archive;      // empty: of several
    std::size_t asked = 0;    // how many
    study::QueueSent sent;    // what is not stored waits in the queue
    std::vector<Text> notes;  // on how objects differ from what is on screen
};

// Makes the objects, puts all of them into the queue, and sends them from there: whatever ends the program
// after that, nothing is lost. Fails where nothing came into the queue. Blocks.
Result<ObjectsSent> sendObjects(ObjectsToSend objects, const std::string& device, Progress& progress);

}  // namespace macula::viewer

#include "app/study/shown_clip.h"

#include <memory>
#include <utility>

#include "segment/patient.h"

namespace macula::app {

Result<ShownClip> shownClip(const ClipPreset& preset, bool removeTable, const Volume& volume,
                            Progress& progress) {
    ShownClip shown{.clip = clipFor(preset, volume)};
    if (!removeTable) return shown;
    MACULA_TRY(segment::PatientMask patient, segment::findPatient(volume, progress));
    for (const Message& message : patient.messages) shown.notes.push_back(message.sentence);
    shown.tableRemoved = patient.removedMl > 0.0;
    shown.clip.mask = Mask{.labels = std::make_shared<const LabelMap>(std::move(patient.map)),
                           .numbers = {segment::PatientMask::kPatient}};
    return shown;
}

}  // namespace macula::app

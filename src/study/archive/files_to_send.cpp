#include "study/archive/files_to_send.h"

#include <algorithm>

#include "dicom/read/folder.h"
#include "dicom/stack/examination.h"
#include "study/open/file_identity.h"
#include "study/open/same_patient.h"

namespace macula::study {

namespace {

void addPatient(std::vector<Identity>& patients, const Identity& patient) {
    const bool isThere = std::any_of(patients.begin(), patients.end(), [&](const Identity& other) {
        return other == patient ||
               (other.studyInstanceUid == patient.studyInstanceUid && whatDiffers(other, patient).empty());
    });
    if (!isThere) patients.push_back(patient);
}

}  // namespace

Result<FilesToSend> filesToSend(std::span<const std::filesystem::path> paths, Progress& progress) {
    FilesToSend found;
    for (const std::filesystem::path& path : paths) {
        MACULA_TRY(const dicom::FolderListing listing, dicom::listFiles(path, progress));
        const std::size_t before = found.files.size();
        for (const std::filesystem::path& file : listing.files) {
            if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Nothing was sent."), {}, {}};
            const dicom::Examination examined = dicom::examine(file, progress.token());
            if (examined.state == dicom::FileState::notDicom ||
                examined.kind == dicom::Examination::Kind::directory)
                continue;
            if (examined.state != dicom::FileState::complete || examined.sopInstanceUid.empty())
                return Error{ErrorCode::inputNotUsable,
                             Text("One of the files is damaged or cut off; nothing was sent."), file.string(),
                             Text("Leave it out.")};
            found.files.push_back(file);
            addPatient(found.patients, identityOf(examined));
        }
        if (found.files.size() == before)
            return Error{ErrorCode::inputNotUsable, Text("There is no DICOM file."), path.string(),
                         Text("Check the path.")};
    }
    return found;
}

}  // namespace macula::study

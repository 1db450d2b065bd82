#include "study/open/file_identity.h"

namespace macula::study {

Identity identityOf(const dicom::Examination& file) {
    return {.patientName = file.patientName,
            .patientId = file.patient.id,
            .birthDate = file.patient.birthDate,
            .sex = file.patient.sex,
            .studyDate = file.studyDate,
            .studyDescription = file.studyDescription,
            .series = {},
            .isOfNobody = false,
            .studyInstanceUid = file.studyInstanceUid};
}

}  // namespace macula::study

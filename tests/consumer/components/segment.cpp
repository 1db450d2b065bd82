// The phantom lies on no table, so all of it is the patient's.
#include <base/phantom.h>
#include <segment/patient.h>

#include "ends.h"

int main() {
    const macula::Volume volume = macula::phantom::make({.size = {64, 56, 40}, .spacingMm = {4.8, 4.8, 7.5}});
    macula::Progress progress;
    const auto patient = macula::segment::findPatient(volume, progress);
    if (!patient) return fail(patient.error());
    using macula::segment::PatientMask;
    bool keepsAll = true;  // air apart
    const glm::ivec3 size = volume.size();
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                if (volume.value(i, j, k) > -1000.0)
                    keepsAll = keepsAll && patient->map.label(i, j, k) == PatientMask::kPatient;
    return expect(!patient->tableFound && keepsAll, "a patient and no table");
}

// The phantom lies on no table, so all of it is the patient's.
#include <base/phantom.h>
#include <segment/patient.h>

#include "ends.h"

int main() {
    const macula::Volume volume = macula::phantom::make({.size = {64, 56, 40}, .spacingMm = {4.8, 4.8, 7.5}});
    macula::Progress progress;
    const auto patient = macula::segment::findPatient(volume, progress);
    if (!patient) return fail(patient.error());
    return expect(!patient->tableFound && patient->patientMl > 1000.0, "a patient and no table");
}

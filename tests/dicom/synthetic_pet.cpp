#include "synthetic_pet.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace macula::dicom::test {

SyntheticSeries petSeries(bool hasDose) {
    SyntheticSeries series;
    series.modality = "PT";
    series.slope = 10.0;
    series.intercept = 0.0;
    series.ramp = Ramp{.value = 40'000.0,
                       .throughMm = transformPoint(series.worldFromVoxel, 0.5 * glm::dvec3(series.size - 1)),
                       .perMm = {110.0, 230.0, 470.0}};
    series.edits.push_back([hasDose](DcmItem& item) {
        put(item, DCM_Units, "BQML");
        put(item, DCM_CorrectedImage, "DECY\\ATTN");
        put(item, DCM_DecayCorrection, "ADMIN");
        put(item, DCM_PatientWeight, "70");
        put(item, DCM_WindowCenter, "32768");
        put(item, DCM_WindowWidth, "65536");
        DcmItem& tracer = nested(item, DCM_RadiopharmaceuticalInformationSequence);
        if (hasDose) put(tracer, DCM_RadionuclideTotalDose, "350000000");
    });
    return series;
}

}  // namespace macula::dicom::test

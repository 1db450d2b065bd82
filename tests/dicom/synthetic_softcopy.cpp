#include "synthetic_softcopy.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "dicom/read/sop_class.h"

namespace macula::dicom::test {

namespace {

void putArea(DcmItem& item, const std::array<int, 4>& area, const std::string& sizeMode) {
    DcmItem& displayed = nested(item, DCM_DisplayedAreaSelectionSequence);
    const auto putCorner = [&](const DcmTag& tag, int x, int y) {
        const std::array<Sint32, 2> corner{x, y};
        auto made = std::make_unique<DcmSignedLong>(tag);
        EXPECT_TRUE(made->putSint32Array(corner.data(), corner.size()).good());
        EXPECT_TRUE(displayed.insert(made.release(), true).good());
    };
    putCorner(DCM_DisplayedAreaTopLeftHandCorner, area[0], area[1]);
    putCorner(DCM_DisplayedAreaBottomRightHandCorner, area[2], area[3]);
    put(displayed, DCM_PresentationSizeMode, sizeMode);
}

}  // namespace

void writeSoftcopy(const std::filesystem::path& file, const SyntheticSoftcopy& softcopy) {
    const SyntheticSoftcopy& s = softcopy;
    Shell shell{.sopClassUid = std::string(sop_class::kSoftcopyPresentationState),
                .modality = "PR",
                .sopInstanceUid = s.sopInstanceUid,
                .seriesUid = s.seriesUid,
                .edits = {}};
    shell.edits.push_back([&s](DcmItem& item) {
        put(item, DCM_StudyInstanceUID, s.studyUid);
        put(item, DCM_PatientName, s.patientName);
        put(item, DCM_PatientID, s.patientId);
        put(item, DCM_ContentLabel, s.label);
        put(item, DCM_ContentDescription, s.description);
        put(item, DCM_PresentationCreationDate, s.date);
        put(item, DCM_PresentationCreationTime, "101112");
        put(item, DCM_ContentCreatorName, "Reader^Night");
        DcmItem& series = nested(item, DCM_ReferencedSeriesSequence);
        put(series, DCM_SeriesInstanceUID, s.referencedSeriesUid);
        for (const std::string& uid : s.imageUids) {
            DcmItem& image = appended(series, DCM_ReferencedImageSequence);
            put(image, DCM_ReferencedSOPClassUID, std::string(sop_class::kCtImage));
            put(image, DCM_ReferencedSOPInstanceUID, uid);
            if (!s.frames.empty()) put(image, DCM_ReferencedFrameNumber, s.frames);
        }
        if (s.rescale) {
            put(item, DCM_RescaleSlope, decimal(s.rescale->first));
            put(item, DCM_RescaleIntercept, decimal(s.rescale->second));
        }
        if (s.window) {
            DcmItem& voi = nested(item, DCM_SoftcopyVOILUTSequence);
            put(voi, DCM_WindowCenter, decimal(s.window->first));
            put(voi, DCM_WindowWidth, decimal(s.window->second));
        }
        putWord(item, DCM_ImageRotation, s.rotationDeg);
        put(item, DCM_ImageHorizontalFlip, s.isFlipped ? "Y" : "N");
        put(item, DCM_PresentationLUTShape, s.isInverse ? "INVERSE" : "IDENTITY");
        if (s.area) putArea(item, *s.area, s.sizeMode);
    });
    shell.edits.insert(shell.edits.end(), s.edits.begin(), s.edits.end());
    writeShell(file, shell);
}

}  // namespace macula::dicom::test

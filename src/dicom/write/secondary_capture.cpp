#include "dicom/write/secondary_capture.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <vector>

#include "base/check.h"
#include "dicom/stack/examination.h"
#include "dicom/write/object_file.h"
#include "dicom/write/object_owner.h"
#include "dicom/write/uid.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

constexpr int kLongestSide = 65535;               // Rows and Columns, VR US
constexpr std::size_t kLongestDescription = 64;   // VR LO
constexpr std::size_t kLongestDerivation = 1024;  // VR ST

bool isPrintable(const std::string& text) {
    return std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~' && c != '\\'; });
}

Result<void> check(const SecondaryCapture& capture) {
    const auto refuse = [](Text message, Text hint) {
        return Error{ErrorCode::usage, std::move(message), {}, std::move(hint)};
    };
    const auto fits = [](int side) { return side >= 1 && side <= kLongestSide; };
    if (!fits(capture.widthPx) || !fits(capture.heightPx))
        return refuse(Text("A picture of that size cannot be written as DICOM."),
                      Text("Take 1 to {} pixels for each side.", kLongestSide));
    if (capture.rgba.size() != 4 * std::size_t(capture.widthPx) * std::size_t(capture.heightPx))
        return refuse(Text("The pixels do not fit the size of the picture."),
                      Text("Draw the picture again."));
    if (capture.seriesDescription.size() > kLongestDescription ||
        capture.derivation.size() > kLongestDerivation || !isPrintable(capture.seriesDescription) ||
        !isPrintable(capture.derivation) || !isPrintable(capture.softwareVersion))
        return refuse(
            Text("The description is too long, or has characters that it may not have."),
            Text("Take at most {} letters, digits and signs, without a backslash.", kLongestDescription));
    if (!capture.source && !capture.isDeidentified && !capture.isOfNobody)
        return refuse(Text("The files of this study do not say which patient and which study it is."),
                      Text("Write the picture without patient and study, or as PNG."));
    return {};
}

class Writer {
  public:
    explicit Writer(DcmDataset& to) : to_(to) {}

    void text(const DcmTagKey& tag, const std::string& value) {
        ok_ = ok_ && to_.putAndInsertString(tag, value.c_str()).good();
    }
    void word(const DcmTagKey& tag, int value) {
        ok_ = ok_ && to_.putAndInsertUint16(tag, static_cast<Uint16>(value)).good();
    }
    void rgb(const SecondaryCapture& capture) {
        std::vector<Uint8> bytes;
        bytes.reserve(capture.rgba.size() / 4 * 3 + 1);
        for (std::size_t i = 0; i < capture.rgba.size(); i += 4)
            bytes.insert(bytes.end(), {capture.rgba[i], capture.rgba[i + 1], capture.rgba[i + 2]});
        if (bytes.size() % 2 != 0) bytes.push_back(0);  // PS3.5 8.1.1: even
        ok_ = ok_ && to_.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size()).good();
    }
    bool ok() const { return ok_; }

  private:
    DcmDataset& to_;
    bool ok_ = true;
};

void fillSeriesAndEquipment(Writer& write, const SecondaryCapture& capture, const Origin& origin) {
    write.text(DCM_Modality, origin.modality);
    write.text(DCM_SeriesInstanceUID, newUid());
    write.text(DCM_SeriesNumber, std::to_string(capture.seriesNumber));
    write.text(DCM_SeriesDescription, capture.seriesDescription);
    write.text(DCM_Laterality, "");         // type 2C: not known of a part that may be paired
    write.text(DCM_ConversionType, "WSD");  // workstation: PS3.3 C.8.6.1
    write.text(DCM_SecondaryCaptureDeviceManufacturer, "Macula");
    write.text(DCM_SecondaryCaptureDeviceManufacturerModelName, "Macula");
    write.text(DCM_SecondaryCaptureDeviceSoftwareVersions, capture.softwareVersion);
}

void fillImage(Writer& write, const SecondaryCapture& capture, const Origin& origin, const Now& now) {
    write.text(DCM_SOPClassUID, UID_SecondaryCaptureImageStorage);
    write.text(DCM_SOPInstanceUID, newUid());
    write.text(DCM_InstanceNumber, "1");
    write.text(DCM_PatientOrientation, "");  // a view in perspective has none
    write.text(DCM_ImageType, "DERIVED\\SECONDARY\\VOLUME_RENDERING");
    write.text(DCM_ContentDate, now.date);
    write.text(DCM_ContentTime, now.time);
    write.text(DCM_DateOfSecondaryCapture, now.date);
    write.text(DCM_TimeOfSecondaryCapture, now.time);
    write.text(DCM_InstanceCreationDate, now.date);
    write.text(DCM_InstanceCreationTime, now.time);
    write.text(DCM_DerivationDescription, capture.derivation);
    write.text(DCM_BurnedInAnnotation, capture.hasBurnedInNames ? "YES" : "NO");
    if (!capture.isOfNobody)
        write.text(DCM_RecognizableVisualFeatures,
                   mayShowFace(origin.bodyPart, capture.heightMm) ? "YES" : "NO");
    write.text(DCM_LossyImageCompression, "00");
    write.word(DCM_SamplesPerPixel, 3);
    write.text(DCM_PhotometricInterpretation, "RGB");
    write.word(DCM_PlanarConfiguration, 0);
    write.word(DCM_Rows, capture.heightPx);
    write.word(DCM_Columns, capture.widthPx);
    write.word(DCM_BitsAllocated, 8);
    write.word(DCM_BitsStored, 8);
    write.word(DCM_HighBit, 7);
    write.word(DCM_PixelRepresentation, 0);
    write.rgb(capture);
}

// PS3.3 C.7.6.1 Source Image Sequence: what it was derived from.
bool refer(DcmDataset& to, const Origin& origin) {
    if (origin.sopClassUid.empty() || origin.sopInstanceUid.empty()) return true;
    DcmItem* item = nullptr;
    return to.findOrCreateSequenceItem(DCM_SourceImageSequence, item, 0).good() && item != nullptr &&
           item->putAndInsertString(DCM_ReferencedSOPClassUID, origin.sopClassUid.c_str()).good() &&
           item->putAndInsertString(DCM_ReferencedSOPInstanceUID, origin.sopInstanceUid.c_str()).good();
}

}  // namespace

Result<void> writeSecondaryCapture(const fs::path& path, const SecondaryCapture& capture) try {
    MACULA_TRY_VOID(check(capture));
    const QuietToolkit quiet;
    const Error failed{ErrorCode::outputNotWritable, Text("The DICOM file could not be written."),
                       path.string(), Text("Check free space and permissions.")};
    DcmFileFormat format;
    DcmDataset& dataset = *format.getDataset();
    Writer write(dataset);
    Origin origin;
    if (capture.isDeidentified) {
        const std::optional<Origin> kind = writePseudonym(dataset, capture.source);
        if (!kind) return failed;
        origin = *kind;
    } else if (capture.source) {
        MACULA_TRY(origin, copyOwner(dataset, *capture.source));
    } else if (!writeNobody(dataset)) {
        return failed;
    }
    fillSeriesAndEquipment(write, capture, origin);
    fillImage(write, capture, origin, Now());
    if (!write.ok() || !refer(dataset, origin)) return failed;
    return saveObject(path, format);
} catch (const CheckFailure&) {
    throw;  // a bug in Macula, not a fault of the file
} catch (...) {
    return Error{ErrorCode::outputNotWritable, Text("The DICOM file could not be written."), path.string(),
                 Text("Check free space and memory.")};
}

}  // namespace macula::dicom

#include "dicom/write/object_file.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/check.h"
#include "dicom/stack/examination.h"
#include "dicom/write/object_owner.h"
#include "dicom/write/uid.h"
#include "toolkit/character_set.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestCode = 16;  // VR CS

// Rewrites texts and names of the data set, not those of items, and says so. Returns whether it succeeded.
bool convertToUtf8(DcmDataset& dataset) {
    OFString declared;
    dataset.findAndGetOFStringArray(DCM_SpecificCharacterSet, declared);
    std::vector<std::pair<DcmTag, std::string>> texts;
    for (unsigned long i = 0; i < dataset.card(); ++i) {
        DcmElement* element = dataset.getElement(i);
        const DcmEVR vr = element->ident();
        const bool isName = vr == EVR_PN;
        const bool hasValues = vr == EVR_SH || vr == EVR_LO || vr == EVR_UC;
        if (!isName && !hasValues && vr != EVR_ST && vr != EVR_LT && vr != EVR_UT) continue;
        OFString bytes;
        if (element->getOFStringArray(bytes, OFFalse).bad()) return false;
        const Delimiters delimiters = isName      ? Delimiters::ofPersonNames
                                      : hasValues ? Delimiters::betweenValues
                                                  : Delimiters::none;
        texts.emplace_back(
            element->getTag(),
            decodeText({bytes.c_str(), bytes.size()}, {declared.c_str(), declared.size()}, delimiters).utf8);
    }
    return std::ranges::all_of(texts,
                               [&](const auto& text) {
                                   return dataset.putAndInsertString(text.first, text.second.c_str()).good();
                               }) &&
           dataset.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192").good();
}

void writeSeriesAndInstance(ItemWriter to, const ObjectKind& kind, const NewObject& object) {
    const Now now;
    to.text(DCM_Modality, std::string(kind.modality));
    to.text(DCM_SeriesInstanceUID, newUid());
    to.text(DCM_SeriesNumber, std::to_string(kind.seriesNumber));
    to.text(DCM_SeriesDescription, std::string(kind.seriesDescription));
    to.text(DCM_SeriesDate, now.date);
    to.text(DCM_SeriesTime, now.time);
    to.text(DCM_Manufacturer, "Macula");
    to.text(DCM_ManufacturerModelName, "Macula");
    to.text(DCM_DeviceSerialNumber, "0");  // a program has none
    to.text(DCM_SoftwareVersions, object.softwareVersion);
    to.text(DCM_SOPClassUID, std::string(kind.sopClassUid));
    to.text(DCM_SOPInstanceUID, newUid());
    to.text(DCM_InstanceCreationDate, now.date);
    to.text(DCM_InstanceCreationTime, now.time);
    to.text(DCM_InstanceNumber, "1");
}

}  // namespace

Error refusedObject(Text message, Text hint) {
    return {ErrorCode::usage, std::move(message), {}, std::move(hint)};
}

Error textRefused() {
    return refusedObject(Text("The description is too long, or has characters that it may not have."),
                         Text("Take at most 64 letters, digits and signs, without a backslash."));
}

Result<void> checkOwner(const NewObject& object, Text instead) {
    if (object.softwareVersion.empty() || !isPlain(object.softwareVersion)) return textRefused();
    if (!object.image && !object.isDeidentified)
        return refusedObject(Text("The files of this study do not say which patient and which study it is."),
                             std::move(instead));
    return {};
}

Result<void> writeObject(const fs::path& path, const NewObject& object, const ObjectKind& kind,
                         const Fill& fill) try {
    const QuietToolkit quiet;
    DcmFileFormat format;
    DcmDataset& dataset = *format.getDataset();
    std::optional<InstallationKey> standIns;
    bool ok = true;
    if (object.isDeidentified) {
        MACULA_TRY(standIns, InstallationKey::ofUser());
        ok = writePseudonym(dataset, object.image).has_value();
    } else if (const Result<Origin> origin = copyOwner(dataset, *object.image); !origin) {
        return origin.error();
    }
    if (kind.needsUtf8) ok = ok && convertToUtf8(dataset);
    const ItemWriter to(dataset, ok);
    writeSeriesAndInstance(to, kind, object);
    fill(to, standIns ? &*standIns : nullptr);
    if (ok) return saveObject(path, format);
    return Error{ErrorCode::outputNotWritable, Text("The DICOM file could not be made."), path.string(),
                 Text("Check memory.")};
} catch (const CheckFailure&) {
    throw;  // a bug in Macula, not a fault of the file
} catch (...) {
    return Error{ErrorCode::outputNotWritable, Text("The DICOM file could not be written."), path.string(),
                 Text("Check free space and memory.")};
}

Result<void> saveObject(const fs::path& path, DcmFileFormat& format) {
    return writeAtomically(path, [&](const fs::path& draft) -> Result<void> {
        // DCMTK does not report that the last bytes are missing when the disk is full.
        if (format.saveFile(draft.c_str(), EXS_LittleEndianExplicit).good() &&
            examine(draft).state == FileState::complete)
            return {};
        return Error{ErrorCode::outputNotWritable, Text("The DICOM file could not be written."),
                     path.string(), Text("Check free space and permissions.")};
    });
}

bool isAscii(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

bool isPlain(std::string_view text) {
    return text.size() <= kLongestText &&
           std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~' && c != '\\'; });
}

bool isCodeString(std::string_view text) {
    return !text.empty() && text.size() <= kLongestCode && std::ranges::all_of(text, [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' || c == '_';
    });
}

bool areUids(const std::vector<ReferencedImage>& images) {
    return std::ranges::all_of(images, [](const ReferencedImage& image) {
        return isUid(image.sopClassUid) && isUid(image.sopInstanceUid);
    });
}

}  // namespace macula::dicom

#include "dicom/read/sop_class.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcuid.h>

#include <algorithm>
#include <array>
#include <utility>

namespace macula::dicom {

namespace {

struct Kind {
    std::string_view root;  // the UID, or its beginning, which then ends in a dot
    std::string_view name;
    bool projection = false;
};

constexpr std::array kKinds = std::to_array<Kind>({
    {"1.2.840.10008.5.1.4.1.1.1", "Computed radiography image", true},
    {"1.2.840.10008.5.1.4.1.1.1.1", "Digital X-ray image", true},
    {"1.2.840.10008.5.1.4.1.1.1.1.1", "Digital X-ray image, unprocessed", true},
    {"1.2.840.10008.5.1.4.1.1.1.2", "Mammography image", true},
    {"1.2.840.10008.5.1.4.1.1.1.2.1", "Mammography image, unprocessed", true},
    {"1.2.840.10008.5.1.4.1.1.1.3", "Intra-oral X-ray image", true},
    {"1.2.840.10008.5.1.4.1.1.12.1", "X-ray angiographic image", true},
    {"1.2.840.10008.5.1.4.1.1.12.1.1", "Enhanced X-ray angiographic image", true},
    {"1.2.840.10008.5.1.4.1.1.12.2", "X-ray radiofluoroscopic image", true},
    {"1.2.840.10008.5.1.4.1.1.12.2.1", "Enhanced X-ray radiofluoroscopic image", true},
    {"1.2.840.10008.5.1.4.1.1.77.1.", "Visible light image", true},
    {"1.2.840.10008.5.1.4.1.1.3.1", "Ultrasound clip", false},
    {"1.2.840.10008.5.1.4.1.1.6.1", "Ultrasound image", false},
    {"1.2.840.10008.5.1.4.1.1.88.59", "Key object selection", false},
    {"1.2.840.10008.5.1.4.1.1.88.", "Structured report", false},
    {"1.2.840.10008.5.1.4.1.1.11.1", "Presentation state of slices", false},
    {"1.2.840.10008.5.1.4.1.1.11.9", "Presentation state of a 3D view", false},
    {"1.2.840.10008.5.1.4.1.1.11.", "Presentation state", false},
    {"1.2.840.10008.5.1.4.1.1.9.", "Waveform", false},
    {"1.2.840.10008.5.1.4.1.1.66", "Raw data", false},
    {"1.2.840.10008.5.1.4.1.1.66.1", "Spatial registration", false},
    {"1.2.840.10008.5.1.4.1.1.66.2", "Spatial fiducials", false},
    {"1.2.840.10008.5.1.4.1.1.66.3", "Deformable spatial registration", false},
    {"1.2.840.10008.5.1.4.1.1.66.4", "Segmentation", false},
    {"1.2.840.10008.5.1.4.1.1.66.5", "Surface segmentation", false},
    {"1.2.840.10008.5.1.4.1.1.66.6", "Tractography", false},
    {"1.2.840.10008.5.1.4.1.1.66.7", "Label map segmentation", false},
    {"1.2.840.10008.5.1.4.1.1.67", "Real world value mapping", false},
    {"1.2.840.10008.5.1.4.1.1.4.2", "MR spectroscopy", false},
    {"1.2.840.10008.5.1.4.1.1.104.1", "PDF document", false},
    {"1.2.840.10008.5.1.4.1.1.104.2", "CDA document", false},
    {"1.2.840.10008.5.1.4.1.1.104.", "Document", false},
    {"1.2.840.10008.5.1.4.1.1.481.3", "Radiotherapy structure set", false},
    {"1.2.840.10008.5.1.4.1.1.481.5", "Radiotherapy plan", false},
    {"1.2.840.10008.5.1.4.1.1.481.", "Radiotherapy object", false},
});

const Kind* kindOf(std::string_view uid) {
    const auto found = std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& kind) {
        return kind.root.ends_with('.') ? uid.starts_with(kind.root) : uid == kind.root;
    });
    return found == kKinds.end() ? nullptr : &*found;
}

}  // namespace

bool isSegmentation(std::string_view sopClassUid) {
    return sopClassUid == sop_class::kSegmentation || sopClassUid == sop_class::kLabelMapSegmentation;
}

bool isPresentationState(std::string_view sopClassUid) {
    return sopClassUid.starts_with("1.2.840.10008.5.1.4.1.1.11.");
}

bool isImage(std::string_view sopClassUid) {
    const std::string uid(sopClassUid);
    // Doses are slices, though DCMTK does not count them as images.
    return isProjection(uid) || uid == UID_RTDoseStorage || dcmIsImageStorageSOPClassUID(uid.c_str());
}

bool isProjection(std::string_view sopClassUid) {
    const Kind* kind = kindOf(sopClassUid);
    return kind != nullptr && kind->projection;
}

std::string_view modalityOfClass(std::string_view sopClassUid) {
    using Pair = std::pair<std::string_view, std::string_view>;
    constexpr std::array kModalities = std::to_array<Pair>({
        {sop_class::kCtImage, "CT"},
        {sop_class::kEnhancedCtImage, "CT"},
        {sop_class::kLegacyConvertedEnhancedCtImage, "CT"},
        {UID_MRImageStorage, "MR"},
        {UID_EnhancedMRImageStorage, "MR"},
        {UID_LegacyConvertedEnhancedMRImageStorage, "MR"},
        {UID_PositronEmissionTomographyImageStorage, "PT"},
        {UID_EnhancedPETImageStorage, "PT"},
        {UID_LegacyConvertedEnhancedPETImageStorage, "PT"},
        {UID_NuclearMedicineImageStorage, "NM"},
        {UID_RTDoseStorage, "RTDOSE"},
    });
    const auto found = std::ranges::find(kModalities, sopClassUid, &Pair::first);
    return found == kModalities.end() ? std::string_view() : found->second;
}

Text describeSopClass(std::string_view sopClassUid) {
    if (const Kind* kind = kindOf(sopClassUid)) return Text::of(kind->name, {});
    // Does not repeat text that is not a UID: it may be anything, even a name.
    const bool isUid = !sopClassUid.empty() && sopClassUid.size() <= 64 &&
                       sopClassUid.find_first_not_of("0123456789.") == std::string_view::npos;
    if (!isUid) return Text("Object of unknown kind");
    const std::string uid(sopClassUid);
    return Text("Object of class {}", dcmFindNameOfUID(uid.c_str(), uid.c_str()));
}

}  // namespace macula::dicom

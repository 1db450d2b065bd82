#include "dicom/write/object_file.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "dicom/stack/examination.h"
#include "toolkit/character_set.h"

namespace macula::dicom {

namespace fs = std::filesystem;

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

}  // namespace macula::dicom

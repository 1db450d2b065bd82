#include "dicom/read/dictionary.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdicent.h>
#include <dcmtk/dcmdata/dcdict.h>
#include <dcmtk/dcmdata/dctag.h>

#include <string>

#include "dicom/read/dataset.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::dicom {

Vr dictionaryVr(Tag tag, std::string_view privateCreator) {
    if (tag.isPrivate() && tag.element >= 0x0010 && tag.element <= 0x00FF) return vrOf("LO");
    if (tag.element == 0x0000) return vrOf("UL");
    const std::string creator(privateCreator);
    const DcmTag known(tag.group, tag.element, creator.empty() ? nullptr : creator.c_str());
    switch (known.getEVR()) {
        case EVR_xs:
            return kVrUnsignedOrSigned;
        case EVR_lt:
        case EVR_ox:
        case EVR_px:
            return vrOf("OW");
        case EVR_up:
            return vrOf("UL");
        case EVR_UNKNOWN:
        case EVR_UNKNOWN2B:
        case EVR_UN:
            return 0;
        default: {
            const char* name = known.getVRName();
            if (name == nullptr || name[0] < 'A' || name[0] > 'Z') return 0;
            return static_cast<Vr>(static_cast<unsigned char>(name[0]) << 8 |
                                   static_cast<unsigned char>(name[1]));
        }
    }
}

bool hasDictionary() {
    const QuietToolkit quiet;
    const bool isLoaded = dcmDataDict.rdlock().numberOfEntries() > 0;
    dcmDataDict.rdunlock();
    return isLoaded;
}

std::optional<Tag> tagOfKeyword(std::string_view keyword) {
    const std::string terminated(keyword);  // nothing may throw between lock and unlock
    const DcmDataDictionary& dictionary = dcmDataDict.rdlock();
    const DcmDictEntry* entry = dictionary.findEntry(terminated.c_str());
    std::optional<Tag> tag;
    if (entry != nullptr) tag = Tag{entry->getGroup(), entry->getElement()};
    dcmDataDict.rdunlock();
    return tag;
}

}  // namespace macula::dicom

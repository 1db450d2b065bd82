#include "net/dimse/contexts.h"

#include <algorithm>

#include "net/archive/file_meta.h"

namespace macula::net {

namespace {

// In the order in which they are proposed, those first that most archives have.
// Implicit VR stands here too: an archive may change it to Explicit VR where both are offered together.
constexpr std::array kOthers = std::to_array<std::string_view>({
    "1.2.840.10008.1.2",
    "1.2.840.10008.1.2.4.70",   // JPEG Lossless, first-order prediction
    "1.2.840.10008.1.2.4.90",   // JPEG 2000 Lossless
    "1.2.840.10008.1.2.4.50",   // JPEG Baseline
    "1.2.840.10008.1.2.4.91",   // JPEG 2000
    "1.2.840.10008.1.2.5",      // RLE
    "1.2.840.10008.1.2.4.80",   // JPEG-LS Lossless
    "1.2.840.10008.1.2.4.57",   // JPEG Lossless
    "1.2.840.10008.1.2.4.51",   // JPEG Extended
    "1.2.840.10008.1.2.4.81",   // JPEG-LS Near-lossless
    "1.2.840.10008.1.2.4.201",  // High-Throughput JPEG 2000 Lossless
    "1.2.840.10008.1.2.4.202", "1.2.840.10008.1.2.4.203",
    "1.2.840.10008.1.2.4.55",  // JPEG Full Progression
    "1.2.840.10008.1.2.4.53",  // JPEG Spectral Selection
    "1.2.840.10008.1.2.1.98",  // Encapsulated Uncompressed
    "1.2.840.10008.1.2.1.99",  // Deflated
    "1.2.840.10008.1.2.2",     // Explicit VR Big Endian
    "1.2.840.10008.1.2.4.110", "1.2.840.10008.1.2.4.111", "1.2.840.10008.1.2.4.112",  // JPEG XL
    "1.2.840.10008.1.2.8.1",                                                          // Deflated Image Frame
    "1.2.840.10008.1.2.4.102", "1.2.840.10008.1.2.4.103",                             // H.264
    "1.2.840.10008.1.2.4.104", "1.2.840.10008.1.2.4.105", "1.2.840.10008.1.2.4.106",
    "1.2.840.10008.1.2.4.107", "1.2.840.10008.1.2.4.108",  // HEVC
    "1.2.840.10008.1.2.4.100", "1.2.840.10008.1.2.4.101",  // MPEG-2
});
constexpr std::array kPlain{kExplicitLittleEndian, kImplicitLittleEndian};

std::vector<std::string> among(Encodings encodings, std::span<const std::string_view> uids) {
    std::vector<std::string> taken;
    for (const std::string_view uid : uids)
        if (isAmong(encodings, uid)) taken.emplace_back(uid);
    return taken;
}

struct UsualClass {
    std::string_view modality;  // empty: of any
    std::string_view uid;
};
constexpr std::array kUsualClasses = std::to_array<UsualClass>({
    {"CT", "1.2.840.10008.5.1.4.1.1.2"},
    {"CT", "1.2.840.10008.5.1.4.1.1.2.1"},  // Enhanced
    {"CT", "1.2.840.10008.5.1.4.1.1.2.2"},  // Legacy Converted Enhanced
    {"MR", "1.2.840.10008.5.1.4.1.1.4"},
    {"MR", "1.2.840.10008.5.1.4.1.1.4.1"},
    {"MR", "1.2.840.10008.5.1.4.1.1.4.3"},
    {"MR", "1.2.840.10008.5.1.4.1.1.4.4"},
    {"PT", "1.2.840.10008.5.1.4.1.1.128"},
    {"PT", "1.2.840.10008.5.1.4.1.1.130"},
    {"PT", "1.2.840.10008.5.1.4.1.1.128.1"},
    {"NM", "1.2.840.10008.5.1.4.1.1.20"},
    {"US", "1.2.840.10008.5.1.4.1.1.6.1"},
    {"US", "1.2.840.10008.5.1.4.1.1.3.1"},
    {"US", "1.2.840.10008.5.1.4.1.1.6.2"},  // Enhanced US Volume
    {"XA", "1.2.840.10008.5.1.4.1.1.12.1"},
    {"XA", "1.2.840.10008.5.1.4.1.1.12.1.1"},
    {"XA", "1.2.840.10008.5.1.4.1.1.13.1.1"},  // X-Ray 3D Angiographic
    {"CT", "1.2.840.10008.5.1.4.1.1.13.1.2"},  // X-Ray 3D Craniofacial
    {"RF", "1.2.840.10008.5.1.4.1.1.12.2"},
    {"MG", "1.2.840.10008.5.1.4.1.1.1.2"},
    {"MG", "1.2.840.10008.5.1.4.1.1.13.1.3"},  // Breast Tomosynthesis
    {"CR", "1.2.840.10008.5.1.4.1.1.1"},
    {"DX", "1.2.840.10008.5.1.4.1.1.1.1"},
    {"IO", "1.2.840.10008.5.1.4.1.1.1.3"},
    {"OP", "1.2.840.10008.5.1.4.1.1.77.1.5.1"},
    {"OPT", "1.2.840.10008.5.1.4.1.1.77.1.5.4"},
    {"RTDOSE", "1.2.840.10008.5.1.4.1.1.481.2"},
    {"RTSTRUCT", "1.2.840.10008.5.1.4.1.1.481.3"},
    {"RTPLAN", "1.2.840.10008.5.1.4.1.1.481.5"},
    {"RTIMAGE", "1.2.840.10008.5.1.4.1.1.481.1"},
    {"SR", "1.2.840.10008.5.1.4.1.1.88.11"},
    {"SR", "1.2.840.10008.5.1.4.1.1.88.22"},
    {"SR", "1.2.840.10008.5.1.4.1.1.88.33"},
    {"SR", "1.2.840.10008.5.1.4.1.1.88.67"},  // Radiation dose
    {"DOC", "1.2.840.10008.5.1.4.1.1.104.1"},
    {"KO", "1.2.840.10008.5.1.4.1.1.88.59"},
    {"", "1.2.840.10008.5.1.4.1.1.7"},  // Secondary Capture
    {"", "1.2.840.10008.5.1.4.1.1.7.2"},
    {"", "1.2.840.10008.5.1.4.1.1.7.3"},
    {"", "1.2.840.10008.5.1.4.1.1.7.4"},
    {"", "1.2.840.10008.5.1.4.1.1.66.4"},  // Segmentation
    {"", "1.2.840.10008.5.1.4.1.1.66"},    // Raw Data
    {"", "1.2.840.10008.5.1.4.1.1.66.1"},  // Spatial Registration
    {"", "1.2.840.10008.5.1.4.1.1.67"},    // Real World Value Mapping
    {"", "1.2.840.10008.5.1.4.1.1.30"},    // Parametric Map
    {"", "1.2.840.10008.5.1.4.1.1.11.1"},  // Grayscale Softcopy Presentation State
    {"", "1.2.840.10008.5.1.4.1.1.11.2"},
    {"", "1.2.840.10008.5.1.4.1.1.11.4"},
    {"", "1.2.840.10008.5.1.4.1.1.11.6"},  // Volume Rendering Presentation State
});

}  // namespace

bool knowsTransferSyntax(std::string_view uid) {
    return std::ranges::find(kPlain, uid) != kPlain.end() || std::ranges::find(kOthers, uid) != kOthers.end();
}

bool isAmong(Encodings encodings, std::string_view transferSyntaxUid) {
    const bool isPlain = transferSyntaxUid == kExplicitBigEndian ||
                         std::ranges::find(kPlain, transferSyntaxUid) != kPlain.end();
    return knowsTransferSyntax(transferSyntaxUid) &&
           (encodings == Encodings::any || isPlain == (encodings == Encodings::plain));
}

bool isStorageClass(std::string_view uid) {
    return uid.starts_with("1.2.840.10008.5.1.4.1.1.") && isUid(uid);
}

std::string_view modelOf(Service service, bool patientRoot) {
    switch (service) {
        case Service::find:
            return patientRoot ? "1.2.840.10008.5.1.4.1.2.1.1" : "1.2.840.10008.5.1.4.1.2.2.1";
        case Service::move:
            return patientRoot ? "1.2.840.10008.5.1.4.1.2.1.2" : "1.2.840.10008.5.1.4.1.2.2.2";
        case Service::get:
            return patientRoot ? "1.2.840.10008.5.1.4.1.2.1.3" : "1.2.840.10008.5.1.4.1.2.2.3";
        case Service::commit:
            return kCommitment;
        case Service::echo:
        case Service::store:
            break;
    }
    return kVerification;
}

ProposedContext plainContext(std::string_view abstractSyntax) {
    return {std::string(abstractSyntax), {kPlain.begin(), kPlain.end()}, false};
}

std::vector<ProposedContext> contextsToReceive(const std::set<std::string>& classes, std::size_t most,
                                               Encodings encodings) {
    std::vector<std::string> taken;
    for (const std::string& each : classes)
        if (isUid(each) && taken.size() < most) taken.push_back(each);
    std::vector<ProposedContext> contexts;
    if (taken.empty()) return contexts;
    // The plain ones share a context, each other has its own; what is over shares the last one.
    std::vector<std::vector<std::string>> groups;
    const std::size_t mostGroups = most / taken.size();
    const auto add = [&](std::vector<std::string> syntaxes) {
        if (syntaxes.empty()) return;
        if (groups.size() < mostGroups)
            groups.push_back(std::move(syntaxes));
        else
            groups.back().insert(groups.back().end(), syntaxes.begin(), syntaxes.end());
    };
    add(among(encodings, kPlain));
    for (std::string& each : among(encodings, kOthers)) add({std::move(each)});
    for (const std::string& each : taken)
        for (const auto& syntaxes : groups) contexts.push_back({each, syntaxes, true});
    return contexts;
}

std::set<std::string> usualClasses(const std::set<std::string>& modalities) {
    std::set<std::string> classes;
    for (const UsualClass& each : kUsualClasses) {
        if (each.modality.empty() || modalities.empty() || modalities.contains(std::string(each.modality)))
            classes.emplace(each.uid);
    }
    return classes;
}

}  // namespace macula::net

// Hanging protocols (PS3.3 C.23): which images of a study and its priors lie where. Hold no UID and no
// patient.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/text.h"
#include "study/hanging/hanging_images.h"

namespace macula::study {

// What an image box shows (C.23.1.1.5). An empty text asks for nothing.
struct ImageSet {
    int prior = 0;                 // 0: the study that is read; 1: the newest one before it, and so on
    std::string modality = {};     // CR, DX and RG count as one
    std::string description = {};  // words that the series' description holds, in any order and case
    std::string laterality = {};   // "R", "L"
    std::string view = {};         // "CC", "MLO", "PA"
    std::size_t number = 0;        // of those that fit, which one

    bool operator==(const ImageSet&) const = default;
};

struct HangingProtocol {
    std::string name;  // of one's own: a person's words, 1 to kLongestHangingName bytes
    Text title = {};   // of one that is built in; otherwise empty
    // The studies that it is for. An empty text asks for nothing.
    std::string modality = {};     // as ImageSet
    std::string bodyPart = {};     // Body Part Examined
    std::string description = {};  // words of the study's description
    bool isOfSlices = false;       // boxes show series that are volumes, and nothing else
    int rows = 1;
    int columns = 1;
    std::vector<ImageSet> boxes = {};  // row by row; not more than rows * columns
    bool isLinked = false;             // boxes scroll together

    bool operator==(const HangingProtocol&) const = default;
    Text titleForPeople() const { return title.empty() ? Text::verbatim(name) : title; }
};
inline constexpr std::size_t kLongestHangingName = 60;  // in UTF-8
inline constexpr std::size_t kMostHangingProtocols = 50;
inline constexpr int kMostBoxRows = 4;
inline constexpr int kMostBoxColumns = 6;

// Mammograms, X-rays and slices, with priors and without; those that ask for most come first.
const std::vector<HangingProtocol>& builtInHangingProtocols();

// The place of an image in `images` for each box; nothing: the box stays empty. No image hangs twice.
std::vector<std::optional<std::size_t>> hang(const HangingProtocol& protocol, const HangingImages& images);

// Whether it is for that study. One that is built in also fills all of its boxes, one of a person's own at
// least one.
bool isFor(const HangingProtocol& protocol, const HangingImages& images);

// What a person sees, as a protocol: `shown` are places in `images`, one for each box.
HangingProtocol protocolOf(std::string_view name, int rows, int columns,
                           std::span<const std::optional<std::size_t>> shown, bool isLinked,
                           const HangingImages& images);

// Those of a person, as JSON; what the reader would refuse is left out.
std::string toJson(std::span<const HangingProtocol> protocols);
// Error: inputNotUsable; the message names the line or the key, the hint what was expected.
Result<std::vector<HangingProtocol>> hangingProtocolsFromJson(std::string_view text);

// Adds it, in place of one with the same name. Error: usage where its name is empty or too long, or there are
// kMostHangingProtocols already.
Result<std::vector<HangingProtocol>> withHangingProtocol(std::vector<HangingProtocol> all,
                                                         HangingProtocol added);

}  // namespace macula::study

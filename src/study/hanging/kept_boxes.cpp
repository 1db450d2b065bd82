#include "study/hanging/kept_boxes.h"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "base/sha256.h"
#include "study/hanging/hanging_protocol.h"

namespace macula::study {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr std::uint64_t kMostPlaces = 10'000'000;
constexpr std::size_t kDigestDigits = 64;

std::optional<std::size_t> numberOf(const Json& json, const char* key) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number_unsigned()) return {};
    const auto value = found->get<std::uint64_t>();
    return value <= kMostPlaces ? std::optional(std::size_t(value)) : std::nullopt;
}

std::optional<KeptBoxes::Box> boxOf(const Json& json) {
    if (!json.is_object()) return {};
    const auto series = json.find("series");
    const auto stack = numberOf(json, "stack");
    const auto place = numberOf(json, "place");
    if (series == json.end() || !series->is_string() || !stack || !place) return {};
    KeptBoxes::Box box{.series = series->get<std::string>(), .stack = *stack, .place = *place};
    return box.series.size() == kDigestDigits ? std::optional(std::move(box)) : std::nullopt;
}

}  // namespace

std::string seriesDigest(const dicom::Series& series) {
    return sha256Hex("series " + series.studyInstanceUid + " " + series.seriesInstanceUid);
}

std::string toJson(const KeptBoxes& boxes) {
    Json all = Json::array();
    for (const auto& box : boxes.boxes) {
        if (box)
            all.push_back({{"series", box->series}, {"stack", box->stack}, {"place", box->place}});
        else
            all.push_back(nullptr);
    }
    return Json{{"version", kVersion},
                {"rows", boxes.rows},
                {"columns", boxes.columns},
                {"linked", boxes.isLinked},
                {"boxes", std::move(all)}}
        .dump();
}

std::optional<KeptBoxes> keptBoxesOf(std::string_view text) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) return {};
    const auto rows = numberOf(json, "rows");
    const auto columns = numberOf(json, "columns");
    const auto linked = json.find("linked");
    const auto boxes = json.find("boxes");
    const bool isWhole = rows && columns && linked != json.end() && linked->is_boolean() &&
                         boxes != json.end() && boxes->is_array();
    if (!isWhole || *rows < 1 || *rows > std::size_t(kMostBoxRows) || *columns < 1 ||
        *columns > std::size_t(kMostBoxColumns) || boxes->size() > *rows * *columns)
        return {};
    KeptBoxes kept{
        .rows = int(*rows), .columns = int(*columns), .isLinked = linked->get<bool>(), .boxes = {}};
    for (const Json& each : *boxes) kept.boxes.push_back(boxOf(each));
    return kept;
}

const dicom::Stack* stackOf(const KeptBoxes::Box& box, const FoundVolumes& found, int patient) {
    for (const dicom::Study& study : found.scan().studies) {
        if (study.patient != patient) continue;
        for (const dicom::Series& series : study.series) {
            if (box.stack >= series.stacks.size() || seriesDigest(series) != box.series) continue;
            const dicom::Stack& stack = series.stacks[box.stack];
            if (!stack.frames.empty()) return &stack;
        }
    }
    return nullptr;
}

}  // namespace macula::study

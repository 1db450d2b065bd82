// All that a folder holds, for hosts with lists of their own.
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "c/handles.h"
#include "c/last_error.h"
#include "c/study.h"
#include "dicom/best_volume.h"
#include "study/list/scan_json.h"
#include "study/open/found_volumes.h"

namespace macula::c {

namespace {

using Json = nlohmann::ordered_json;

// The place of each volume in that JSON, in the order of macula_study_title.
Json placesOf(const study::FoundVolumes& found) {
    std::map<const dicom::Stack*, std::string> places;
    std::size_t place = 0;
    for (const dicom::Study& study : found.scan().studies)
        for (const dicom::Series& series : study.series) {
            ++place;
            for (std::size_t i = 0; i < series.stacks.size(); ++i)
                places[&series.stacks[i]] = fmt::format("{}.{}", place, i + 1);
        }
    Json list = Json::array();
    for (const study::FoundVolume& volume : found.volumes()) list.push_back(places.at(volume.stack));
    return list;
}

std::string foundText(const study::FoundVolumes* found) {
    const dicom::Scan nothing;
    const dicom::Scan& scan = found == nullptr ? nothing : found->scan();
    const dicom::ChosenStack best = found == nullptr ? dicom::ChosenStack() : dicom::bestVolume(scan);
    Json json = toJson(scan, best, study::PatientData::include);
    json["volumes"] = found == nullptr ? Json::array() : placesOf(*found);
    return json.dump(4, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

extern "C" macula_status macula_study_found(macula_study* study, const char** json) {
    if (json != nullptr) *json = nullptr;
    return guarded([&]() -> Result<void> {
        if (json == nullptr) return nullHandle();
        MACULA_TRY(const Held<macula_study> of, changing(study));
        of->found = foundText(of->opened.found.get());
        *json = of->found.c_str();
        return {};
    });
}

}  // namespace macula::c

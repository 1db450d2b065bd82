#include "study/list/scan_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/english.h"
#include "dicom/read/sop_class.h"
#include "dicom/segmentation/segmentation.h"

namespace macula::study {

namespace {

using Json = nlohmann::ordered_json;

Json toJson(const glm::dvec3& vector) {
    return {vector.x, vector.y, vector.z};
}

Json toJson(const glm::dmat4& matrix) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) {
        Json values = Json::array();
        for (int column = 0; column < 4; ++column) values.push_back(matrix[column][row]);
        rows.push_back(values);
    }
    return rows;
}

Json toJson(const std::vector<Message>& messages) {
    Json list = Json::array();
    for (const Message& message : messages) list.push_back(study::toJson(message));
    return list;
}

// Indices, from 0, of the slices of the volume that have no image.
Json interpolatedSlices(const dicom::Stack& stack) {
    Json list = Json::array();
    for (std::size_t k = 0; k < stack.slices.size(); ++k) {
        if (stack.slices[k].interpolated()) list.push_back(k);
    }
    return list;
}

Json windowsOf(const dicom::Stack& stack) {
    Json list = Json::array();
    for (const DisplayWindow& window : stack.frames[stack.frames.size() / 2].windows) {
        list.push_back({{"center", window.center},
                        {"width", window.width},
                        {"explanation", window.explanation},
                        {"function", window.function.empty() ? "LINEAR" : window.function}});
    }
    return list;
}

Json toJson(const dicom::Stack& stack, const std::string& place, bool isBest, PatientData patientData) {
    Json json = {
        {"place", place},
        {"images", stack.frames.size()},
        {"size",
         {stack.columns, stack.rows, stack.slices.empty() ? stack.frames.size() : stack.slices.size()}},
        {"canBeVolume", stack.canBeVolume()},
        {"best", isBest},
        {"orientation", stack.orientation}};
    if (!stack.splitBy.empty()) {
        Json labels = Json::object();
        for (const dicom::StackLabel& label : stack.splitBy) {
            labels[label.attribute] = patientData == PatientData::leaveOut ? shownValue(label) : label.value;
        }
        json["splitBy"] = labels;
    }
    if (stack.phases > 1) json["phase"] = {{"index", stack.phase}, {"count", stack.phases}};
    if (stack.spacingMm) {
        json["spacingMm"] = toJson(*stack.spacingMm);
        json["calibrated"] = stack.isCalibrated;
    }
    if (stack.firstPositionMm) json["firstPositionMm"] = toJson(*stack.firstPositionMm);
    if (stack.lastPositionMm) json["lastPositionMm"] = toJson(*stack.lastPositionMm);
    if (stack.worldFromVoxel) json["worldFromVoxel"] = toJson(*stack.worldFromVoxel);
    if (Json slices = interpolatedSlices(stack); !slices.empty()) json["interpolatedSlices"] = slices;
    if (stack.suvFactor) json["suvFactor"] = *stack.suvFactor;
    if (Json windows = windowsOf(stack); !windows.empty()) json["windows"] = windows;
    json["messages"] = toJson(stack.messages);
    json["assumptions"] = inEnglish(stack.assumptions);
    return json;
}

Json toJson(const dicom::OtherObject& object, PatientData patientData) {
    Json json = {{"kind", object.kind.english()}, {"sopClassUid", object.sopClassUid}};
    if (!object.referencedSeriesUids.empty()) json["referencedSeriesUids"] = object.referencedSeriesUids;
    if (patientData == PatientData::include) json["file"] = object.file.string();
    if (!dicom::isSegmentation(object.sopClassUid)) return json;
    if (const auto segmentation = dicom::readSegmentation(object.file)) {
        json["segments"] = Json::array();
        for (const Segment& segment : segmentation->segments)
            json["segments"].push_back({{"number", segment.number}, {"label", segment.label}});
    }
    return json;
}

Json toJson(const dicom::Series& series, std::size_t place, const dicom::ChosenStack& best,
            PatientData patientData) {
    Json json = {{"place", place},
                 {"seriesInstanceUid", series.seriesInstanceUid},
                 {"modality", series.modality},
                 {"description", series.description},
                 {"instances", series.instances},
                 {"transferSyntaxUids", series.transferSyntaxUids},
                 {"patientPosition", series.patientPosition},
                 {"canBeVolume", series.canBeVolume()},
                 {"messages", toJson(series.messages)},
                 {"stacks", Json::array()},
                 {"objects", Json::array()}};
    if (series.number) json["number"] = *series.number;
    for (std::size_t i = 0; i < series.stacks.size(); ++i) {
        const dicom::Stack& stack = series.stacks[i];
        json["stacks"].push_back(
            toJson(stack, fmt::format("{}.{}", place, i + 1), &stack == best.stack, patientData));
    }
    for (const dicom::OtherObject& object : series.objects)
        json["objects"].push_back(toJson(object, patientData));
    return json;
}

}  // namespace

std::string shownValue(const dicom::StackLabel& label) {
    const bool tellsWhenOrWho = label.attribute == "AcquisitionTime" || label.attribute == "ContentTime" ||
                                label.attribute.ends_with("UID");
    return tellsWhenOrWho ? "…" : label.value;
}

Json toJson(const Message& message) {
    Json arguments = Json::object();
    for (const TextArgument& argument : message.arguments) {
        Json& said = arguments[argument.name];
        if (const auto* text = std::get_if<Text>(&argument.value)) {
            said = text->english();
        } else if (const auto* words = std::get_if<std::string>(&argument.value)) {
            said = *words;
        } else if (const auto* number = std::get_if<double>(&argument.value)) {
            said = *number;
        } else {
            said = std::get<std::int64_t>(argument.value);
        }
    }
    return {{"key", message.key},
            {"severity", dicom::nameOf(message.severity)},
            {"arguments", arguments},
            {"sentence", message.sentence.english()},
            {"action", message.action.english()}};
}

Json toJson(const dicom::Scan& scan, const dicom::ChosenStack& best, PatientData patientData) {
    Json json = {{"filesSeen", scan.filesSeen},
                 {"notDicom", scan.notDicom},
                 {"images", scan.imageCount()},
                 {"otherObjects", scan.objectCount()},
                 {"patients", scan.patients},
                 {"messages", toJson(scan.messages)},
                 {"best", nullptr},
                 {"studies", Json::array()},
                 {"skipped", Json::array()}};
    json["best"] = {{"why", best.why.english()}};
    std::size_t place = 0;
    for (const dicom::Study& study : scan.studies) {
        Json entry = {{"patient", study.patient + 1}};
        if (patientData == PatientData::include) {
            entry["patientName"] = study.patientName;
            entry["patientId"] = study.patientId;
            entry["date"] = study.date;
            entry["description"] = study.description;
            entry["studyInstanceUid"] = study.studyInstanceUid;
        }
        entry["series"] = Json::array();
        for (const dicom::Series& series : study.series) {
            entry["series"].push_back(toJson(series, ++place, best, patientData));
        }
        json["studies"].push_back(entry);
    }
    for (const dicom::SkippedFile& file : scan.skipped) {
        Json entry = toJson(file.message);
        if (!file.seriesInstanceUid.empty()) entry["seriesInstanceUid"] = file.seriesInstanceUid;
        if (patientData == PatientData::include) entry["file"] = file.file.string();
        json["skipped"].push_back(entry);
    }
    return json;
}

}  // namespace macula::study

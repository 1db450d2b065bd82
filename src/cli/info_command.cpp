// macula info PATH: what is in a folder, and what can be shown of it.
//
// Output goes into mails and bug reports. So who the patient is, when, and where the files lie (people name
// folders after patients) is left out unless --patient asks for it.
#include <CLI/App.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "dicom/loader.h"
#include "dicom/scan.h"
#include "dicom/transfer_syntax.h"

namespace macula::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::filesystem::path path;
    bool json = false;
    bool patient = false;
};

std::string_view severityName(dicom::Severity severity) {
    switch (severity) {
        case dicom::Severity::info:
            return "note";
        case dicom::Severity::warning:
            return "warning";
        case dicom::Severity::blocksVolume:
            return "cannot be shown";
    }
    return "note";
}

Json toJson(const dicom::Message& message) {
    return {{"severity", severityName(message.severity)},
            {"key", message.key},
            {"sentence", message.sentence},
            {"action", message.action}};
}

Json toJson(const glm::dvec3& vector) {
    return {vector.x, vector.y, vector.z};
}

Json toJson(const dicom::Series& series, std::size_t place, bool isBest) {
    Json json = {{"place", place},
                 {"seriesInstanceUid", series.seriesInstanceUid},
                 {"modality", series.modality},
                 {"description", series.description},
                 {"size", {series.columns, series.rows, series.slices}},
                 {"instances", series.instances.size()},
                 {"transferSyntaxUids", series.transferSyntaxUids},
                 {"patientPosition", series.patientPosition},
                 {"orientation", series.orientation},
                 {"canBeVolume", series.canBeVolume()},
                 {"best", isBest},
                 {"messages", Json::array()},
                 {"assumptions", series.assumptions}};
    if (series.number) json["number"] = *series.number;
    if (series.spacingMm) json["spacingMm"] = toJson(*series.spacingMm);
    if (series.firstPositionMm) json["firstPositionMm"] = toJson(*series.firstPositionMm);
    if (series.lastPositionMm) json["lastPositionMm"] = toJson(*series.lastPositionMm);
    if (series.worldFromVoxel) {
        Json rows = Json::array();
        for (int row = 0; row < 4; ++row) {
            Json values = Json::array();
            for (int column = 0; column < 4; ++column)
                values.push_back((*series.worldFromVoxel)[column][row]);
            rows.push_back(values);
        }
        json["worldFromVoxel"] = rows;
    }
    for (const dicom::Message& message : series.messages) json["messages"].push_back(toJson(message));
    return json;
}

void printJson(const dicom::Scan& scan, const dicom::Series* best, const Options& options) {
    Json json = {{"filesSeen", scan.filesSeen},
                 {"notDicom", scan.notDicom},
                 {"otherObjects", scan.others.size()},
                 {"studies", Json::array()},
                 {"skipped", Json::array()}};
    std::size_t place = 0;
    for (const dicom::Study& study : scan.studies) {
        Json entry = Json::object();
        if (options.patient) {
            entry = {{"patientName", study.patientName},
                     {"patientId", study.patientId},
                     {"date", study.date},
                     {"description", study.description},
                     {"studyInstanceUid", study.studyInstanceUid}};
        }
        entry["series"] = Json::array();
        for (const dicom::Series& series : study.series) {
            entry["series"].push_back(toJson(series, ++place, &series == best));
        }
        json["studies"].push_back(entry);
    }
    for (const dicom::SkippedFile& file : scan.skipped) {
        Json entry = toJson(file.message);
        if (options.patient) entry["file"] = file.file.string();
        json["skipped"].push_back(entry);
    }
    // Text in old files is not always what its character set says; a broken byte is no reason to print
    // nothing.
    fmt::print("{}\n", json.dump(4, ' ', false, Json::error_handler_t::replace));
}

// Text from a file must not steer the terminal it is shown in: no C0 and no C1 controls, the latter also as
// the UTF-8 pairs C2 80 to C2 9F, and as lone bytes.
std::string printable(const std::string& text) {
    std::string result;
    int following = 0;  // bytes of a UTF-8 sequence still to come
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0u;
        const bool c1Pair = following == 0 && c == 0xc2 && next >= 0x80 && next < 0xa0;
        const bool stray = following == 0 && c >= 0x80 && c < 0xc2;
        if (c < 0x20 || c == 0x7f || c1Pair || stray) {
            result += '?';
            i += c1Pair ? 1 : 0;
            following = 0;
            continue;
        }
        result += text[i];
        following = c >= 0xf0 ? 3 : c >= 0xe0 ? 2 : c >= 0xc2 ? 1 : following > 0 ? following - 1 : 0;
    }
    return result;
}

std::string orNone(const std::string& text) {
    return text.empty() ? "(none)" : printable(text);
}

void print(const dicom::Series& series, std::size_t place, bool isBest) {
    fmt::print("  {}[{}] {}  {} x {} x {}", isBest ? '*' : ' ', place, orNone(series.modality),
               series.columns, series.rows, series.slices);
    if (series.spacingMm) {
        fmt::print("  {:.4g} x {:.4g} x {:.4g} mm", series.spacingMm->x, series.spacingMm->y,
                   series.spacingMm->z);
    }
    if (!series.orientation.empty()) fmt::print("  {}", printable(series.orientation));
    fmt::print("\n");
    if (series.number) fmt::print("        number       {}\n", *series.number);
    if (!series.description.empty()) fmt::print("        description  {}\n", printable(series.description));
    for (const std::string& uid : series.transferSyntaxUids) {
        fmt::print("        encoding     {}\n", dicom::describeTransferSyntax(uid));
    }
    for (const dicom::Message& message : series.messages) {
        fmt::print("        {}: {}{}{}\n", severityName(message.severity), message.sentence,
                   message.action.empty() ? "" : " ", message.action);
    }
    for (const std::string& assumption : series.assumptions) fmt::print("        assumed: {}\n", assumption);
}

void printText(const dicom::Scan& scan, const dicom::Series* best, const std::string& why,
               const Options& options) {
    std::size_t place = 0;
    for (std::size_t i = 0; i < scan.studies.size(); ++i) {
        const dicom::Study& study = scan.studies[i];
        fmt::print("Study {}\n", i + 1);
        if (options.patient) {
            fmt::print("  patient      {}\n  id           {}\n  date         {}\n  description  {}\n",
                       orNone(study.patientName), orNone(study.patientId), orNone(study.date),
                       orNone(study.description));
        }
        for (const dicom::Series& series : study.series) print(series, ++place, &series == best);
    }
    for (const dicom::SkippedFile& file : scan.skipped) {
        fmt::print("Left out: {} {}{}\n", file.message.sentence, file.message.action,
                   options.patient ? " (" + printable(file.file.string()) + ")" : "");
    }
    fmt::print("{} files, {} of them no DICOM, {} DICOM objects that are no images.\n", scan.filesSeen,
               scan.notDicom, scan.others.size());
    if (!why.empty()) fmt::print("{}{}\n", best ? "* " : "", why);
}

Result<void> showInfo(const Options& options) {
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const dicom::Scan scan, dicom::scanFolder(options.path, progress));
    std::string why;
    const dicom::Series* best = dicom::bestSeries(scan, &why);
    if (options.json) {
        printJson(scan, best, options);
    } else {
        printText(scan, best, why, options);
    }
    return {};
}

}  // namespace

void addInfo(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    auto* command =
        app.add_subcommand("info", "List the studies and series in a folder; * marks what is shown first");
    command->add_option("PATH", options->path, "Folder with DICOM files, or one file")->required();
    command->add_flag("--json", options->json, "Print JSON");
    command->add_flag("--patient", options->patient,
                      "Also print patient name, ID, study date and description, and paths of files");
    command->callback([options, &action] { action = [options] { return showInfo(*options); }; });
}

}  // namespace macula::cli

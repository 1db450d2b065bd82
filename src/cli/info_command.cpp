// macula info PATH: what is in a folder, and what can be shown of it.
//
// Output goes into mails and bug reports. So who the patient is, when, and where the files lie (people name
// folders after patients) is left out unless --patient asks for it.
#include <CLI/App.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/printable.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/study_options.h"
#include "cli/volume_file_info.h"
#include "dicom/read/sop_class.h"
#include "dicom/read/transfer_syntax.h"
#include "dicom/segmentation/segmentation.h"
#include "formats/volume_file.h"
#include "study/list/scan_json.h"
#include "study/open/loaded_study.h"
#include "study/open/scanned_place.h"
#include "study/planar/planar_images.h"

namespace macula::cli {

namespace {

constexpr std::size_t kMostStacksShown = 40;
constexpr std::size_t kStacksOfMany = 8;  // shown of more than these

struct InfoOptions {
    std::filesystem::path path;
    bool json = false;
    bool patient = false;
    dicom::ScanOptions how;
};

std::string orNone(const std::string& text) {
    return text.empty() ? "(none)" : printable(text);
}

std::string_view label(Severity severity) {
    switch (severity) {
        case Severity::info:
            return "note";
        case Severity::warning:
            return "warning";
        case Severity::blocksVolume:
            return "no 3D";
        case Severity::blocksLoading:
            return "cannot be opened";
    }
    return "note";
}

// "1 file", "2 files".
std::string counted(std::size_t count, std::string_view one) {
    return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

void print(const std::vector<Message>& messages, std::string_view indent) {
    for (const Message& message : messages) {
        fmt::print("{}{}: {}{}{}\n", indent, label(message.severity), message.sentence.english(),
                   message.action.empty() ? "" : " ", message.action.english());
    }
}

// "EchoTime 4.6, phase 2 of 20"
std::string describe(const dicom::Stack& stack) {
    std::string text;
    for (const dicom::StackLabel& split : stack.splitBy) {
        text += fmt::format("  {} {}", printable(split.attribute), orNone(study::shownValue(split)));
    }
    if (stack.phases > 1) text += fmt::format("  phase {} of {}", stack.phase + 1, stack.phases);
    return text;
}

void print(const dicom::Stack& stack, const std::string& place, bool isBest) {
    fmt::print("   {}[{}]  {} x {} x {}", isBest ? '*' : ' ', place, stack.columns, stack.rows,
               stack.slices.empty() ? stack.frames.size() : stack.slices.size());
    if (stack.spacingMm) {
        fmt::print("  {:.4g} x {:.4g} x {:.4g} mm{}", stack.spacingMm->x, stack.spacingMm->y,
                   stack.spacingMm->z, stack.isCalibrated ? "" : ", not calibrated");
    }
    fmt::print("{}{}{}\n", stack.orientation.empty() ? "" : "  ", printable(stack.orientation),
               describe(stack));
    if (study::canBeShownAsImages(stack))
        fmt::print("          shown as images, not in 3D; macula picture writes one of them\n");
    print(stack.messages, "          ");
}

// Of a segmentation.
void printSegments(const dicom::OtherObject& object) {
    if (!dicom::isSegmentation(object.sopClassUid)) return;
    const auto segmentation = dicom::readSegmentation(object.file);
    if (!segmentation) {
        fmt::print("      segmentation: {}\n", segmentation.error().message.english());
        return;
    }
    fmt::print("      segmentation in {}, segments {}\n", counted(segmentation->frames.size(), "frame"),
               segmentation->segments.empty() ? "without a description" : "by number and label:");
    for (const Segment& segment : segmentation->segments)
        fmt::print("        {:>5}  {}\n", segment.number, orNone(segment.label));
}

void print(const dicom::Series& series, std::size_t place, const dicom::ChosenStack& best) {
    fmt::print("  [{}] {}", place, orNone(series.modality));
    if (series.number) fmt::print("  series {}", *series.number);
    if (!series.description.empty()) fmt::print("  {}", printable(series.description));
    fmt::print("\n");
    for (const std::string& uid : series.transferSyntaxUids) {
        fmt::print("      {}\n", Text("encoding: {}", dicom::describeTransferSyntax(uid)).english());
    }
    print(series.messages, "      ");
    for (const dicom::OtherObject& object : series.objects) printSegments(object);
    // Hundreds of stacks that say the same are one fact: the first few, the best one, and how many more.
    std::size_t notShown = 0;
    std::size_t imagesNotShown = 0;
    for (std::size_t i = 0; i < series.stacks.size(); ++i) {
        const dicom::Stack& stack = series.stacks[i];
        if (series.stacks.size() <= kMostStacksShown || i < kStacksOfMany || &stack == best.stack) {
            print(stack, fmt::format("{}.{}", place, i + 1), &stack == best.stack);
        } else {
            ++notShown;
            imagesNotShown += stack.frames.size();
        }
    }
    if (notShown > 0) {
        fmt::print("    and {} with {}; --json lists them all.\n", counted(notShown, "more stack"),
                   counted(imagesNotShown, "image"));
    }
}

void printText(const dicom::Scan& scan, const dicom::ChosenStack& best, const InfoOptions& options) {
    std::size_t place = 0;
    for (std::size_t i = 0; i < scan.studies.size(); ++i) {
        const dicom::Study& study = scan.studies[i];
        // Of images of which the message at the end tells, once.
        if (std::all_of(study.series.begin(), study.series.end(),
                        [](const auto& s) { return s.scattered; })) {
            place += study.series.size();
            continue;
        }
        fmt::print("Study {}{}\n", i + 1,
                   scan.patients > 1 ? fmt::format("  (patient {})", study.patient + 1) : std::string());
        if (options.patient) {
            fmt::print("  patient      {}\n  id           {}\n  date         {}\n  description  {}\n",
                       orNone(study.patientName), orNone(study.patientId), orNone(study.date),
                       orNone(study.description));
        }
        for (const dicom::Series& series : study.series) {
            ++place;
            if (!series.scattered) print(series, place, best);
        }
    }
    for (const dicom::SkippedFile& file : scan.skipped) {
        fmt::print("Left out: {} {}{}\n", file.message.sentence.english(), file.message.action.english(),
                   options.patient ? " (" + printable(file.file.string()) + ")" : "");
    }
    print(scan.messages, "");
    fmt::print("{}: {}, {}, {} left out, {} not DICOM.\n", counted(scan.filesSeen, "file"),
               counted(scan.imageCount(), "image"), counted(scan.objectCount(), "other DICOM object"),
               scan.skipped.size(), scan.notDicom);
    fmt::print("{}{}\n", best ? "* " : "", best.why.english());
}

// Programs that asked for a document get one also where nothing could be read.
void printAsJson(const Error& error, const InfoOptions& options) {
    auto json = toJson(dicom::Scan{}, dicom::ChosenStack{}, study::PatientData::leaveOut);
    json["error"] = {{"sentence", error.message.english()}, {"action", error.hint.english()}};
    if (options.patient && !error.where.empty()) json["error"]["where"] = error.where;
    fmt::print("{}\n", jsonText(json));
}

Result<void> showWhatIsThere(const InfoOptions& options) {
    Progress progress(terminalProgressBar(), interruptToken());
    if (formats::isVolumeFileName(options.path)) return showVolumeFile(options.path, options.json, progress);
    if (options.path == "phantom:") {
        showPhantom(options.json);
        return {};
    }
    MACULA_TRY(const study::ScannedPlace place, study::scanPlace(options.path, progress, options.how));
    const dicom::ChosenStack best = dicom::bestVolume(place.scan);
    if (!options.json) {
        printText(place.scan, best, options);
        return {};
    }
    const auto json = toJson(place.scan, best,
                             options.patient ? study::PatientData::include : study::PatientData::leaveOut);
    fmt::print("{}\n", jsonText(json));
    return {};
}

Result<void> showInfo(const InfoOptions& options) {
    Result<void> shown = showWhatIsThere(options);
    if (!shown && options.json && shown.error().code == ErrorCode::inputNotUsable)
        printAsJson(shown.error(), options);
    return shown;
}

}  // namespace

void addInfo(CLI::App& app, Action& action) {
    auto options = std::make_shared<InfoOptions>();
    auto* command =
        app.add_subcommand("info", "List the studies and series in a folder; * marks what is shown first");
    command
        ->add_option("PATH", options->path,
                     "Folder, ZIP, tar or ISO of DICOM files, one file, NIfTI, NRRD, MetaImage, or phantom:")
        ->required();
    command->add_flag("--json", options->json, "Print JSON");
    addJoin(*command, options->how);
    command->add_flag("--patient", options->patient,
                      "Also print patient name, ID, study date and description, and paths of files");
    command->callback([options, &action] { action = [options] { return showInfo(*options); }; });
}

}  // namespace macula::cli

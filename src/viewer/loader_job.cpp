#include "viewer/loader_job.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#include "base/phantom.h"
#include "dicom/best_volume.h"
#include "dicom/loader.h"

namespace macula::viewer {

namespace {

Result<LoadedStudy> loadPhantom(Progress& progress) {
    progress.beginStage("Making the phantom", 1);
    auto volume = std::make_shared<const Volume>(phantom::make());
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "Loading was cancelled.", {}, {}};
    progress.advance();
    return LoadedStudy{.volume = std::move(volume), .description = "Built-in phantom"};
}

Error notUsable(std::string sentence, const std::filesystem::path& where) {
    return {ErrorCode::inputNotUsable, std::move(sentence), where.string(),
            "Choose a folder with a CT or MR series of several parallel slices."};
}

bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
    if (a.filename() != b.filename()) return false;  // the scan was of the file's own folder
    std::error_code notThere;
    return a == b || std::filesystem::equivalent(a, b, notThere);
}

// The stack that `file` belongs to, and no other: beside it may lie those of another patient.
Result<dicom::Choice> stackHolding(const std::filesystem::path& file, const dicom::Scan& scan) {
    for (const dicom::Study& study : scan.studies) {
        for (const dicom::Series& series : study.series) {
            for (const dicom::Stack& stack : series.stacks) {
                const bool holds =
                    std::any_of(stack.frames.begin(), stack.frames.end(),
                                [&](const dicom::Frame& f) { return sameFile(f.instance->file, file); });
                if (!holds) continue;
                if (const Message* reason = stack.whyNoVolume()) return notUsable(reason->sentence, file);
                return dicom::Choice{&series, &stack, "The images of the file that was opened."};
            }
            for (const dicom::OtherObject& object : series.objects) {
                if (sameFile(object.file, file)) return notUsable(object.kind + ": this is no image.", file);
            }
        }
    }
    for (const dicom::SkippedFile& skipped : scan.skipped) {
        if (sameFile(skipped.file, file)) return notUsable(skipped.message.sentence, file);
    }
    return notUsable("The file is not a DICOM image.", file);
}

Result<dicom::Choice> chooseVolume(const dicom::Scan& scan, const std::filesystem::path& folder) {
    dicom::Choice choice = dicom::bestVolume(scan);
    if (choice) return choice;
    return notUsable(choice.why, folder);
}

Result<LoadedStudy> loadPath(const std::filesystem::path& given, Progress& progress) {
    // Of a name without a folder the parent would be empty.
    const std::filesystem::path path = std::filesystem::absolute(given).lexically_normal();
    std::error_code notThere;
    const bool isFile = std::filesystem::is_regular_file(path, notThere);
    MACULA_TRY(const dicom::Scan scan, dicom::scanFolder(isFile ? path.parent_path() : path, progress));
    MACULA_TRY(const dicom::Choice choice, isFile ? stackHolding(path, scan) : chooseVolume(scan, path));
    MACULA_TRY(std::shared_ptr<const Volume> volume,
               dicom::loadVolume(*choice.series, *choice.stack, progress));
    LoadedStudy study{.volume = in16Bits(std::move(volume)),
                      .description = choice.series->description,
                      .whyThisSeries = choice.why};
    const auto tell = [&](const std::vector<Message>& messages) {
        for (const Message& message : messages) {
            if (message.severity != Severity::info) study.messages.push_back(message.sentence);
        }
    };
    tell(scan.messages);
    tell(choice.series->messages);
    tell(choice.stack->messages);
    tell(study.volume->provenance().messages);
    if (!scan.skipped.empty()) {
        study.messages.push_back(std::to_string(scan.skipped.size()) +
                                 (scan.skipped.size() == 1 ? " file was" : " files were") +
                                 " left out; `macula info` on the folder says why.");
    }
    return study;
}

}  // namespace

Result<LoadedStudy> loadStudy(const StudySource& source, Progress& progress) {
    try {
        return source ? loadPath(*source, progress) : loadPhantom(progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory,
                     "There is not enough memory for this study.",
                     {},
                     "Close other programs, or open a smaller series."};
    } catch (const std::exception&) {
        // Nothing is known of it but that this study cannot be shown; the window must live on.
        return Error{ErrorCode::inputNotUsable, "The study could not be opened.",
                     source ? source->string() : std::string(),
                     "Run `macula info` on the folder to find out what is wrong with it."};
    }
}

StudyLoader::StudyLoader(QObject* parent)
    : QObject(parent),
      job_(this, {.progressed =
                      [this](const ProgressUpdate& update) {
                          emit progressed(QString::fromStdString(update.stage), update.fraction);
                      },
                  .ended = [this](const Result<LoadedStudy>& outcome) { tellOutcome(outcome); }}) {}

void StudyLoader::open(StudySource source) {
    job_.start([source = std::move(source)](Progress& progress) { return loadStudy(source, progress); });
    emit began();
}

void StudyLoader::cancel() {
    if (job_.cancel()) emit cancelled();
}

void StudyLoader::tellOutcome(const Result<LoadedStudy>& outcome) {
    if (outcome) {
        emit loaded(*outcome);
    } else if (outcome.error().code == ErrorCode::cancelled) {
        emit cancelled();
    } else {
        emit failed(outcome.error());
    }
}

}  // namespace macula::viewer

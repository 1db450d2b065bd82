#include "study/list/study_tree.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "base/parsing.h"
#include "dicom/documents/document.h"
#include "dicom/manifest/imaging_manifest.h"
#include "dicom/read/sop_class.h"
#include "study/list/search_text.h"
#include "study/open/presented_volume.h"
#include "study/open/stack_label_text.h"
#include "study/planar/planar_images.h"
#include "study/planar/planar_presentation.h"

namespace macula::study {

namespace {

Text imagesText(std::size_t count) {
    return count == 1 ? Text("1 image") : Text("{} images", count);
}

Text withBetween(std::vector<Text> facts) {
    return Text::joined(std::move(facts), " · ");
}

Text toldWithAction(const Message& message) {
    return Text::joined({message.sentence, message.action}, " ");
}

void addMessages(const std::vector<Message>& messages, StudyRow& row) {
    for (const Message& message : messages) {
        Text text = toldWithAction(message);
        // Compares sentences: arguments that they do not show may differ.
        const std::string said = text.english();
        const bool isKnown =
            std::ranges::any_of(row.messages, [&](const Text& known) { return known == said; });
        if (!isKnown) row.messages.push_back(std::move(text));
    }
}

Text whyNoVolume(const dicom::Stack& stack) {
    if (stack.canBeVolume()) return {};
    const Message* reason = stack.whyNoVolume();
    return reason != nullptr ? reason->sentence : Text("The images are no volume.");
}

// The reason why a series has no volume.
Text whyNoVolume(const dicom::Series& series) {
    for (const Message& message : series.messages) {
        if (message.severity >= Severity::blocksVolume) return message.sentence;
    }
    const bool isOfManifests = series.stacks.empty() && !series.objects.empty() &&
                               std::ranges::all_of(series.objects, [](const dicom::OtherObject& object) {
                                   return object.kind == dicom::imagingManifestKind();
                               });
    if (isOfManifests)
        return Text(
            "This is an imaging manifest: it names images that lie in an archive. Open its file to fetch "
            "them.");
    const auto largest = std::max_element(
        series.stacks.begin(), series.stacks.end(),
        [](const dicom::Stack& a, const dicom::Stack& b) { return a.frames.size() < b.frames.size(); });
    if (largest != series.stacks.end()) return whyNoVolume(*largest);
    for (const Message& message : series.messages) {
        if (message.key == dicom::key::kUnsupportedSopClass || message.key == dicom::key::kPresentationState)
            return message.sentence;
    }
    return Text("There are no images in this series.");
}

Text sizeText(const dicom::Stack& stack) {
    if (!stack.canBeVolume()) return Text("{} × {}", stack.columns, stack.rows);
    return Text("{} × {} × {}", stack.columns, stack.rows, stack.slices.size());
}

Text voxelText(const dicom::Stack& stack) {
    if (!stack.canBeVolume() || !stack.spacingMm) return {};
    const glm::dvec3& mm = *stack.spacingMm;
    return withBetween({Text("{:.3g} × {:.3g} × {:.3g} mm", mm.x, mm.y, mm.z),
                        stack.isCalibrated ? Text() : Text("not calibrated")});
}

// The stack whose picture stands for a series: the volume with the most images, otherwise the stack with the
// most.
const dicom::Stack* pictureOf(const dicom::Series& series) {
    const auto best = std::max_element(
        series.stacks.begin(), series.stacks.end(), [](const dicom::Stack& a, const dicom::Stack& b) {
            return std::pair(a.canBeVolume(), a.frames.size()) < std::pair(b.canBeVolume(), b.frames.size());
        });
    return best == series.stacks.end() ? nullptr : &*best;
}

// Whether the text has only digits and separators of dates. Any other text may name somebody.
bool isDate(std::string_view text) {
    return text.find_first_not_of("0123456789.-/") == std::string_view::npos;
}

class Builder {
  public:
    Builder(const FoundVolumes& found, Names names, const KeyImages* keys)
        : found_(found), hides_(names == Names::hidden), keys_(keys) {
        for (std::size_t i = 0; i < found.volumes().size(); ++i)
            volumes_.emplace(found.volumes()[i].stack, i);
    }

    StudyTree build() {
        const std::vector<dicom::Study>& studies = found_.scan().studies;
        std::map<int, std::vector<const dicom::Study*>> byPatient;
        for (auto study = studies.rbegin(); study != studies.rend(); ++study) {
            if (std::any_of(study->series.begin(), study->series.end(), isListed))
                byPatient[study->patient].push_back(&*study);
        }
        for (const auto& [patient, ofPatient] : byPatient) addPatient(patient, ofPatient);
        addScattered();
        addLeftOut();
        return std::move(tree_);
    }

  private:
    static bool isListed(const dicom::Series& series) {
        return !series.scattered || std::any_of(series.stacks.begin(), series.stacks.end(),
                                                [](const dicom::Stack& s) { return s.canBeVolume(); });
    }

    // A search finds the row by its title and by `searched`.
    std::size_t add(StudyRow row, const std::vector<std::string>& searched) {
        const std::size_t index = tree_.rows.size();
        std::string words = row.title.english();
        for (const std::string& each : searched) words += "\n" + each;
        row.searched = foldedForSearch(words);
        if (row.parent == kNoRow) {
            tree_.top.push_back(index);
        } else {
            row.searched += "\n" + tree_.rows[row.parent].searched;
            tree_.rows[row.parent].children.push_back(index);
        }
        tree_.rows.push_back(std::move(row));
        return index;
    }

    void addPatient(int patient, const std::vector<const dicom::Study*>& studies) {
        StudyRow row{.kind = StudyRow::Kind::patient};
        std::vector<std::string> searched;
        if (hides_) {
            row.title = Text("Patient {}", patient + 1);
        } else {
            const Identity identity = identityOf(*studies.front());
            const std::vector<Text> lines = linesOf(identity);
            row.title = lines[0];
            row.details = {lines[1]};
            searched = {lines[1].english(), identity.birthDate};
        }
        const std::size_t index = add(std::move(row), searched);
        for (const dicom::Study* study : studies) addStudy(*study, index);
    }

    void addStudy(const dicom::Study& study, std::size_t parent) {
        Identity identity = identityOf(study);
        if (hides_) identity.studyDescription.clear();
        if (hides_ && !isDate(trimmed(identity.studyDate))) identity.studyDate.clear();
        StudyRow row{.kind = StudyRow::Kind::study, .parent = parent};
        row.title = linesOf(identity)[2];
        std::vector<std::string> modalities;
        std::size_t listed = 0;
        for (const dicom::Series& series : study.series) {
            if (!isListed(series)) continue;
            ++listed;
            if (std::find(modalities.begin(), modalities.end(), series.modality) == modalities.end())
                modalities.push_back(series.modality);
        }
        std::vector<Text> words;
        for (const std::string& modality : modalities) words.push_back(Text::verbatim(modality));
        row.details = {withBetween({Text::joined(std::move(words), ", "),
                                    listed == 1 ? Text("1 series") : Text("{} series", listed)})};
        // Without the modalities: a search for one of them would find all series of the study.
        const std::size_t index = add(std::move(row), {identity.studyDate});
        for (const dicom::Series& series : study.series) {
            if (isListed(series)) addSeries(series, study.patient, index);
        }
    }

    void addSeries(const dicom::Series& series, int patient, std::size_t parent) {
        StudyRow row{.kind = StudyRow::Kind::series, .parent = parent};
        row.title = titleOf(series);
        std::vector<const dicom::Stack*> volumes;
        std::size_t images = 0;
        for (const dicom::Stack& stack : series.stacks) {
            images += stack.frames.size();
            if (stack.canBeVolume()) volumes.push_back(&stack);
        }
        if (!found_.isWhole()) images = series.instances;
        row.details = {factsOf(series, images, volumes.size())};
        const bool isOne = series.stacks.size() == 1;
        if (volumes.size() == 1) row.volume = volumes_.at(volumes.front());
        if (isOne || volumes.size() == 1) {
            const dicom::Stack& stack = isOne ? series.stacks.front() : *volumes.front();
            // Each on its own line: the list is narrow, and would cut off the slice distance, which comes
            // last.
            row.details.push_back(sizeText(stack));
            if (Text voxel = voxelText(stack); !voxel.empty()) row.details.push_back(std::move(voxel));
            if (Text on = doseText(stack, patient); !on.empty()) row.details.push_back(std::move(on));
        }
        addKeyImages(series, row);
        const std::vector<const dicom::OtherObject*> presentations = presentationsOf(series);
        const std::vector<const dicom::OtherObject*> documents = documentsOf(series);
        // A series of presentation states or documents alone lacks no volume: a user opens one of them.
        const bool isOfPresentations = !presentations.empty() && series.stacks.empty();
        const bool isOfDocuments =
            !documents.empty() && documents.size() == series.objects.size() && series.stacks.empty();
        if (isOne && found_.isWhole() && canBeShownAsImages(series.stacks.front()))
            setImages(row, series.stacks.front());
        else if (volumes.empty() && found_.isWhole() && !isOfPresentations && !isOfDocuments)
            row.whyNot = whyNoVolume(series);
        const bool isOneDocument = isOfDocuments && documents.size() == 1;
        if (isOneDocument) {
            row.document = StudyRow::Document{documents.front()->file, patient};
            row.details.push_back(titleOf(*documents.front()));
        }
        if (!isOfDocuments) addMessages(series.messages, row);
        if (isOne) addMessages(series.stacks.front().messages, row);
        row.picture = pictureOf(series);
        const std::size_t index = add(std::move(row), {series.modality});
        for (const dicom::OtherObject* object : presentations) addPresentation(*object, patient, index);
        for (const dicom::OtherObject* object : documents)
            if (!isOneDocument) addDocument(*object, patient, index);
        if (isOne) return;
        for (std::size_t i = 0; i < series.stacks.size(); ++i) addStack(series.stacks[i], i, index);
    }

    // Of a series or a stack.
    template <class Images>
    void addKeyImages(const Images& images, StudyRow& row) const {
        if (keys_ == nullptr) return;
        for (Text& line : keys_->linesOf(images, !hides_)) row.details.push_back(std::move(line));
    }

    Text titleOf(const dicom::Series& series) const {
        const std::string description(hides_ ? std::string_view() : trimmed(series.description));
        if (description.empty())
            return series.number ? Text("Series {}", *series.number) : Text("Series without a number");
        return series.number ? Text("Series {}: {}", *series.number, description)
                             : Text("Series without a number: {}", description);
    }

    Text factsOf(const dicom::Series& series, std::size_t images, std::size_t volumes) const {
        const std::size_t objects = series.objects.size();
        std::vector<Text> facts{Text::verbatim(series.modality),
                                images > 0 ? imagesText(images) : Text("no images")};
        if (!found_.isWhole()) facts.back() = Text("{} so far", std::move(facts.back()));
        if (objects > 0) facts.push_back(objects == 1 ? Text("1 object") : Text("{} objects", objects));
        if (series.stacks.size() > 1)
            facts.push_back(volumes == 1 ? Text("1 volume") : Text("{} volumes", volumes));
        return withBetween(std::move(facts));
    }

    // Of a radiotherapy dose: the images that it lies on, by their frame of reference. Else empty.
    Text doseText(const dicom::Stack& stack, int patient) const {
        if (stack.modality != "RTDOSE" || !found_.isWhole()) return {};
        const std::string frame = frameOfReferenceOf(stack);
        if (frame.empty()) return {};
        for (const FoundVolume& each : found_.volumes()) {
            const bool isOn = each.stack->modality != "RTDOSE" &&
                              dicom::mayBeOnePatient(found_.scan(), each.study->patient, patient) &&
                              frameOfReferenceOf(*each.stack) == frame;
            if (isOn)
                return each.series->number ? Text("Dose on series {}", *each.series->number)
                                           : Text("Dose on images of this folder");
        }
        return {};
    }

    // The messages of the stack say why it is no volume.
    static void setImages(StudyRow& row, const dicom::Stack& stack) {
        row.images = &stack;
        row.details.push_back(Text("Shown as images, not in 3D"));
    }

    // The presentation states of the series, newest first.
    static std::vector<const dicom::OtherObject*> presentationsOf(const dicom::Series& series) {
        std::vector<const dicom::OtherObject*> all;
        for (const dicom::OtherObject& object : series.objects) {
            if (object.presentation) all.push_back(&object);
        }
        std::ranges::stable_sort(all, std::ranges::greater(), [](const dicom::OtherObject* object) {
            return std::pair(object->presentation->date, object->presentation->time);
        });
        return all;
    }

    // Those that can be read. An imaging manifest is none: it is opened to fetch what it names.
    static std::vector<const dicom::OtherObject*> documentsOf(const dicom::Series& series) {
        std::vector<const dicom::OtherObject*> all;
        for (const dicom::OtherObject& object : series.objects) {
            if (dicom::isDocument(object.sopClassUid) && object.kind != dicom::imagingManifestKind())
                all.push_back(&object);
        }
        return all;
    }

    Text titleOf(const dicom::OtherObject& document) const {
        const std::string label(hides_ ? std::string_view() : trimmed(document.label));
        return label.empty() ? document.kind : Text("{}: {}", document.kind, label);
    }

    void addDocument(const dicom::OtherObject& object, int patient, std::size_t parent) {
        StudyRow row{.kind = StudyRow::Kind::document, .parent = parent};
        row.title = titleOf(object);
        row.document = StudyRow::Document{object.file, patient};
        add(std::move(row), {});
    }

    void addPresentation(const dicom::OtherObject& object, int patient, std::size_t parent) {
        const dicom::PresentationHeading& heading = *object.presentation;
        const bool isOfSlices = object.sopClassUid == dicom::sop_class::kSoftcopyPresentationState;
        const bool isOf3d = object.sopClassUid == dicom::sop_class::kVolumePresentationState;
        StudyRow row{.kind = StudyRow::Kind::presentation, .parent = parent};
        row.title = isOf3d ? Text("3D view") : isOfSlices ? Text("View of slices") : object.kind;
        const std::string date(trimmed(heading.date));
        std::vector<std::string> words;
        if (!hides_) {
            if (const std::string label(trimmed(heading.label)); !label.empty())
                row.title = Text("{}: {}", std::move(row.title), label);
            words = {std::string(trimmed(heading.description)), dateForPeople(date),
                     nameForPeople(heading.creator)};
        } else if (isDate(date)) {
            words = {dateForPeople(date)};
        }
        std::vector<Text> facts;
        for (const std::string& each : words) facts.push_back(Text::verbatim(each));
        if (Text line = withBetween(std::move(facts)); !line.empty()) row.details = {std::move(line)};
        PresentedVolume shown = presentedVolume(object, patient, found_);
        if (const dicom::Stack* images = shown.index ? nullptr : presentedImages(object, patient, found_)) {
            row.presentation = StudyRow::Presentation{.file = object.file, .images = images};
        } else if (shown.index) {
            row.presentation =
                StudyRow::Presentation{.file = object.file, .volume = *shown.index, .isOfSlices = isOfSlices};
        } else {
            row.whyNot = std::move(shown.whyNot);
        }
        add(std::move(row), words);
    }

    void addStack(const dicom::Stack& stack, std::size_t place, std::size_t parent) {
        StudyRow row{.kind = StudyRow::Kind::stack, .parent = parent};
        std::vector<Text> labels;
        if (hides_) {
            labels.push_back(Text("Stack {}", place + 1));
        } else {
            for (const dicom::StackLabel& label : stack.splitBy) labels.push_back(textOf(label));
        }
        if (stack.phases > 1) labels.push_back(Text("phase {} of {}", stack.phase + 1, stack.phases));
        if (labels.empty()) labels.push_back(Text("Stack {}", place + 1));
        row.title = Text::joined(std::move(labels), ", ");
        row.details = {withBetween({imagesText(stack.frames.size()), sizeText(stack)})};
        if (Text voxel = voxelText(stack); !voxel.empty()) row.details.push_back(std::move(voxel));
        addKeyImages(stack, row);
        if (found_.isWhole() && canBeShownAsImages(stack))
            setImages(row, stack);
        else
            row.whyNot = whyNoVolume(stack);
        addMessages(stack.messages, row);
        if (stack.canBeVolume()) row.volume = volumes_.at(&stack);
        row.picture = &stack;
        add(std::move(row), {stack.modality});
    }

    // Adds one row for all images that each have a series of their own. Its message asks whether they are one
    // series: hundreds of rows of one image each would hide that.
    void addScattered() {
        for (const Message& message : found_.scan().messages) {
            if (message.key != dicom::key::kUidPerSlice) continue;
            StudyRow row{.kind = StudyRow::Kind::leftOut};
            row.title = message.sentence;
            row.messages = {toldWithAction(message)};
            add(std::move(row), {});
        }
    }

    void addLeftOut() {
        const std::vector<dicom::SkippedFile>& skipped = found_.scan().skipped;
        std::vector<std::pair<Message, std::size_t>> reasons;  // in the order of the scan
        std::map<std::string, std::size_t> placeOf;            // in `reasons`, by sentence
        // Folders that are unreadable for another reason than permissions.
        std::vector<Message> otherFolders;
        std::size_t folders = 0;
        for (const dicom::SkippedFile& file : skipped) {
            if (file.isFolder && file.message.key != dicom::key::kUnreadableFolder)
                otherFolders.push_back(file.message);
            if (file.isFolder) {
                ++folders;
                continue;
            }
            const auto [place, isNew] = placeOf.try_emplace(file.message.sentence.english(), reasons.size());
            if (isNew) reasons.emplace_back(file.message, 0);
            ++reasons[place->second].second;
        }
        if (const std::size_t files = skipped.size() - folders; files > 0) {
            StudyRow row{.kind = StudyRow::Kind::leftOut};
            row.title = files == 1 ? Text("1 file left out") : Text("{} files left out", files);
            const std::size_t parent = add(std::move(row), {});
            for (const auto& [reason, count] : reasons) addReason(reason, count, parent);
        }
        if (const std::size_t closed = folders - otherFolders.size(); closed > 0) {
            addReason(
                dicom::message(dicom::key::kUnreadableFolder, {{"count", static_cast<std::int64_t>(closed)}}),
                1, kNoRow);
        }
        for (const Message& message : otherFolders) addReason(message, 1, kNoRow);
    }

    void addReason(const Message& reason, std::size_t count, std::size_t parent) {
        StudyRow row{.kind = StudyRow::Kind::leftOut, .parent = parent};
        row.title = count == 1 ? reason.sentence : Text("{} × {}", count, reason.sentence);
        if (!reason.action.empty()) row.details = {reason.action};
        row.messages = {toldWithAction(reason)};
        add(std::move(row), {});
    }

    const FoundVolumes& found_;
    const bool hides_;
    const KeyImages* keys_;
    std::map<const dicom::Stack*, std::size_t> volumes_;
    StudyTree tree_;
};

}  // namespace

StudyTree studyTree(const FoundVolumes& found, Names names, const KeyImages* keys) {
    return Builder(found, names, keys).build();
}

std::vector<bool> rowsThatMatch(const StudyTree& tree, std::string_view typed) {
    const std::vector<std::string> words = searchWords(typed);
    std::vector<bool> shown(tree.rows.size());
    for (std::size_t i = tree.rows.size(); i-- > 0;) {
        const StudyRow& row = tree.rows[i];
        if (!shown[i] && !holdsAll(row.searched, words)) continue;
        shown[i] = true;
        if (row.parent != kNoRow) shown[row.parent] = true;
    }
    return shown;
}

}  // namespace macula::study

#include "dicom/documents/content_tree.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "dicom/documents/document_tags.h"
#include "dicom/documents/document_values.h"

namespace macula::dicom {

namespace {

namespace tags = document_tag;

constexpr std::size_t kMostEntries = 10'000;
constexpr std::size_t kMostBytes = std::size_t{4} << 20;
constexpr std::size_t kMostNumbers = 30'000;  // of the points of one shape

DocumentRelation relationOf(std::string_view relation) {
    using Pair = std::pair<std::string_view, DocumentRelation>;
    constexpr std::array kRelations = std::to_array<Pair>({
        {"HAS PROPERTIES", DocumentRelation::hasProperties},
        {"HAS CONCEPT MOD", DocumentRelation::describes},
        {"HAS OBS CONTEXT", DocumentRelation::observed},
        {"HAS ACQ CONTEXT", DocumentRelation::observed},
        {"INFERRED FROM", DocumentRelation::inferredFrom},
        {"SELECTED FROM", DocumentRelation::selectedFrom},
    });
    for (const auto& [name, known] : kRelations) {
        if (relation == name) return known;
    }
    return DocumentRelation::contains;
}

Text shapeText(std::string_view type, std::size_t points) {
    if (type == "POINT") return Text("a point");
    if (type == "MULTIPOINT") return Text("{} points", points);
    if (type == "POLYLINE") return Text("a line of {} points", points);
    if (type == "POLYGON") return Text("a polygon of {} corners", points);
    if (type == "CIRCLE") return Text("a circle");
    if (type == "ELLIPSE") return Text("an ellipse");
    if (type == "ELLIPSOID") return Text("an ellipsoid");
    return Text("a shape of {} points", points);
}

class Reader {
  public:
    explicit Reader(StudyDocument& document) : document_(document) {}

    void read(const Dataset& root) {
        struct Level {
            std::vector<Dataset> items;
            std::size_t next = 0;
            std::size_t parent = DocumentEntry::kNone;
            std::string place;
        };
        std::vector<Level> levels;
        levels.push_back({root.items(tags::kContent), 0, DocumentEntry::kNone, "1"});
        while (!levels.empty()) {
            Level& level = levels.back();
            if (level.next == level.items.size()) {
                levels.pop_back();
                continue;
            }
            if (document_.entries.size() == kMostEntries || bytes_ > kMostBytes) {
                isCut_ = true;
                break;
            }
            const Dataset item = level.items[level.next++];
            const std::string place = fmt::format("{}.{}", level.place, level.next);
            const std::size_t entry = document_.entries.size();
            add(item, level.parent, int(levels.size()) - 1, place);
            levels.push_back({item.items(tags::kContent), 0, entry, place});  // ends the life of `level`
        }
        nameReferences();
        addNotes();
    }

  private:
    void add(const Dataset& item, std::size_t parent, int depth, const std::string& place) {
        DocumentEntry entry;
        entry.parent = parent;
        entry.depth = depth;
        entry.place = place;
        entry.type = inLines(item.shortText(tags::kValueType));
        entry.relation = relationOf(item.shortText(tags::kRelationship));
        entry.name = codeIn(item, tags::kConceptName);
        entry.heading = wordsOf(entry.name);
        places_.emplace(place, document_.entries.size());
        if (item.has(tags::kReferencedItem)) {
            std::string at;
            for (const double number : item.allNumbers(tags::kReferencedItem))
                at += fmt::format("{}{:.0f}", at.empty() ? "" : ".", number);
            byReference_.emplace_back(document_.entries.size(), at);
        } else {
            setValue(entry, item);
        }
        bytes_ += entry.name.meaning.size() + entry.value.format().size();
        for (const TextArgument& argument : entry.value.arguments()) {
            if (const auto* words = std::get_if<std::string>(&argument.value)) bytes_ += words->size();
        }
        document_.entries.push_back(std::move(entry));
    }

    void setValue(DocumentEntry& entry, const Dataset& item) {
        const std::string& type = entry.type;
        if (type == "CONTAINER") {
            entry.isSection = true;
        } else if (type == "TEXT") {
            setText(entry, item, tags::kTextValue);
        } else if (type == "NUM") {
            setNumber(entry, item);
        } else if (type == "CODE") {
            entry.code = codeIn(item, tags::kConceptCode);
            entry.value = wordsOf(entry.code);
            entry.isTechnical = entry.name.scheme == "DCM" && entry.name.value == "121049";  // language
        } else if (type == "DATETIME") {
            entry.value = Text::verbatim(dateTimeOf(item.text(tags::kDateTime).value_or("")));
        } else if (type == "DATE") {
            entry.value = Text::verbatim(dateOf(item.text(tags::kDate).value_or("")));
        } else if (type == "TIME") {
            entry.value = Text::verbatim(timeOf(item.text(tags::kTime).value_or("")));
        } else if (type == "PNAME") {
            entry.value = Text::verbatim(personOf(item.text(tags::kPersonName).value_or("")));
        } else if (type == "UIDREF") {
            setText(entry, item, tags::kUid);
            entry.isTechnical = true;
        } else if (type == "IMAGE" || type == "COMPOSITE" || type == "WAVEFORM") {
            setReferences(entry, item);
        } else if (type == "SCOORD" || type == "SCOORD3D") {
            setPoints(entry, item);
        } else if (type == "TCOORD") {
            entry.value = Text("A time range: {}", inLines(item.text(tags::kTemporalRange).value_or("?")));
        } else {
            ++unknown_;
            return;
        }
        if (entry.value.empty() && !entry.isSection) ++empty_;
    }

    void setText(DocumentEntry& entry, const Dataset& item, Tag tag) {
        entry.value = wordsOf(item, tag);
        if (entry.value.empty() && item.has(tag)) ++tooLong_;
    }

    // PS3.3 C.18.1.
    void setNumber(DocumentEntry& entry, const Dataset& item) {
        const Text qualifier = wordsOf(codeIn(item, tags::kNumericValueQualifier));
        const std::vector<Dataset> measured = item.items(tags::kMeasuredValue);
        if (!measured.empty()) {
            const Dataset& value = measured.front();
            entry.code = codeIn(value, tag::kMeasurementUnitsCode);
            const std::string digits = inLines(value.shortText(tags::kNumericValue));
            entry.number = value.number(tags::kFloatingPointValue);
            if (!entry.number) entry.number = value.number(tags::kNumericValue);
            if (!digits.empty() && !entry.number) ++unreadable_;
            const std::string unit = unitOf(entry.code);
            const bool isAngle = unit == "°";
            if (!digits.empty())
                entry.value = Text::verbatim(unit.empty() || isAngle ? digits + unit
                                                                     : fmt::format("{} {}", digits, unit));
        }
        if (!qualifier.empty())
            entry.value = entry.value.empty() ? qualifier : Text("{} ({})", entry.value, qualifier);
        else if (entry.value.empty())
            entry.value = Text("no value");
    }

    void setReferences(DocumentEntry& entry, const Dataset& item) {
        entry.references = referencesIn(item, tags::kReferencedSops, nowhere_);
        if (entry.references.empty()) {
            if (item.itemCount(tags::kReferencedSops) == 0) ++nowhere_;
            entry.value = Text("An object that the report does not name");
            return;
        }
        entry.value = nameOf(entry.references.front());
    }

    void setPoints(DocumentEntry& entry, const Dataset& item) {
        DrawnPoints points{.type = inLines(item.shortText(tags::kGraphicType)),
                           .numbers = item.allNumbers(tags::kGraphicData),
                           .isInSpace = entry.type == "SCOORD3D",
                           .frameOfReferenceUid = item.shortText(tags::kFrameOfReferenceOfPoints)};
        const std::size_t each = points.isInSpace ? 3 : 2;
        if (points.numbers.empty() || points.numbers.size() % each != 0 ||
            points.numbers.size() > kMostNumbers) {
            ++unreadablePoints_;
            entry.value = Text("A shape whose points cannot be read");
            return;
        }
        Text shape = shapeText(points.type, points.numbers.size() / each);
        entry.value = points.isInSpace ? Text("Drawn in space: {}", std::move(shape))
                                       : Text("Drawn on an image: {}", std::move(shape));
        entry.points = std::move(points);
    }

    // Names the items that others refer to by their place.
    void nameReferences() {
        for (const auto& [entry, place] : byReference_) {
            const auto found = places_.find(place);
            Text& value = document_.entries[entry].value;
            if (found == places_.end()) {
                ++nowhere_;
                value = Text("See an item that is not there");
                continue;
            }
            const DocumentEntry& other = document_.entries[found->second];
            const Text words = other.value.empty() ? other.heading : other.value;
            value = words.empty() ? Text("See item {}", place) : Text("See: {}", words);
        }
    }

    void addNotes() {
        const auto note = [&](std::size_t count, Text one, Text several) {
            if (count > 0) document_.notes.push_back(count == 1 ? std::move(one) : std::move(several));
        };
        if (isCut_)
            document_.notes.push_back(
                Text("The document is larger than what is shown here: the rest of it is missing below."));
        note(empty_, Text("One entry of the document has no value."),
             Text("{} entries of the document have no value.", empty_));
        note(unknown_, Text("One entry of the document is of a kind that is not shown."),
             Text("{} entries of the document are of kinds that are not shown.", unknown_));
        note(tooLong_, Text("One text of the document is too long to be shown."),
             Text("{} texts of the document are too long to be shown.", tooLong_));
        note(unreadable_, Text("One number of the document is no number; it is shown as it is."),
             Text("{} numbers of the document are no numbers; they are shown as they are.", unreadable_));
        note(unreadablePoints_, Text("One shape of the document has points that cannot be read."),
             Text("{} shapes of the document have points that cannot be read.", unreadablePoints_));
        note(nowhere_, Text("One reference of the document leads nowhere."),
             Text("{} references of the document lead nowhere.", nowhere_));
    }

    StudyDocument& document_;
    std::map<std::string, std::size_t> places_;
    std::vector<std::pair<std::size_t, std::string>> byReference_;  // entry, place of the other one
    std::size_t bytes_ = 0;
    bool isCut_ = false;
    std::size_t empty_ = 0, unknown_ = 0, tooLong_ = 0, unreadable_ = 0, unreadablePoints_ = 0, nowhere_ = 0;
};

}  // namespace

void addContent(StudyDocument& document, const Dataset& root) {
    Reader(document).read(root);
}

}  // namespace macula::dicom

#include "dicom/documents/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "dicom/documents/document_tags.h"
#include "dicom/documents/document_values.h"

namespace macula::dicom {

namespace {

namespace tags = document_tag;

constexpr Tag kPlanName{0x300A, 0x0003};
constexpr Tag kPlanDescription{0x300A, 0x0004};
constexpr Tag kPlanIntent{0x300A, 0x000A};
constexpr Tag kPlanGeometry{0x300A, 0x000C};
constexpr Tag kPrescriptionDescription{0x300A, 0x000E};
constexpr Tag kDoseReferences{0x300A, 0x0010};
constexpr Tag kDoseReferenceNumber{0x300A, 0x0012};
constexpr Tag kDoseReferenceStructure{0x300A, 0x0014};
constexpr Tag kDoseReferenceDescription{0x300A, 0x0016};
constexpr Tag kDoseReferenceType{0x300A, 0x0020};
constexpr Tag kDeliveryMaximumDose{0x300A, 0x0023};
constexpr Tag kTargetMinimumDose{0x300A, 0x0025};
constexpr Tag kTargetPrescriptionDose{0x300A, 0x0026};
constexpr Tag kTargetMaximumDose{0x300A, 0x0027};
constexpr Tag kOrganMaximumDose{0x300A, 0x002C};
constexpr Tag kFractionGroups{0x300A, 0x0070};
constexpr Tag kFractionGroupNumber{0x300A, 0x0071};
constexpr Tag kFractionsPlanned{0x300A, 0x0078};
constexpr Tag kBeamDose{0x300A, 0x0084};
constexpr Tag kBeamMeterset{0x300A, 0x0086};
constexpr Tag kBrachyApplications{0x300A, 0x00A0};
constexpr Tag kBeams{0x300A, 0x00B0};
constexpr Tag kMachine{0x300A, 0x00B2};
constexpr Tag kDosimeterUnit{0x300A, 0x00B3};
constexpr Tag kBeamNumber{0x300A, 0x00C0};
constexpr Tag kBeamName{0x300A, 0x00C2};
constexpr Tag kBeamDescription{0x300A, 0x00C3};
constexpr Tag kBeamType{0x300A, 0x00C4};
constexpr Tag kRadiationType{0x300A, 0x00C6};
constexpr Tag kDeliveryType{0x300A, 0x00CE};
constexpr Tag kWedges{0x300A, 0x00D0};
constexpr Tag kBoli{0x300A, 0x00ED};
constexpr Tag kBlocks{0x300A, 0x00F0};
constexpr Tag kControlPoints{0x300A, 0x0111};
constexpr Tag kNominalEnergy{0x300A, 0x0114};
constexpr Tag kDoseRate{0x300A, 0x0115};
constexpr Tag kGantryAngle{0x300A, 0x011E};
constexpr Tag kGantryDirection{0x300A, 0x011F};
constexpr Tag kCollimatorAngle{0x300A, 0x0120};
constexpr Tag kCouchAngle{0x300A, 0x0122};
constexpr Tag kIsocentre{0x300A, 0x012C};
constexpr Tag kBrachySetups{0x300A, 0x0230};
constexpr Tag kIonBeams{0x300A, 0x03A2};
constexpr Tag kIonControlPoints{0x300A, 0x03A8};
constexpr Tag kReferencedBeams{0x300C, 0x0004};
constexpr Tag kReferencedBeamNumber{0x300C, 0x0006};
constexpr Tag kReferencedStructureSets{0x300C, 0x0060};
constexpr Tag kApproval{0x300E, 0x0002};
constexpr Tag kReviewDate{0x300E, 0x0004};
constexpr Tag kReviewer{0x300E, 0x0008};

constexpr std::size_t kMostBeams = 500;
constexpr std::size_t kMostEntries = 10'000;

Text withUnit(const Dataset& item, Tag tag, std::string_view unit) {
    const auto number = item.number(tag);
    return number ? Text::verbatim(fmt::format("{}{}", numberText(*number), unit)) : Text();
}

class Reader {
  public:
    Reader(StudyDocument& document, const Dataset& header) : document_(document), header_(header) {}

    void read() {
        addPlan();
        addPrescription();
        addFractions();
        addBeams(kBeams, kControlPoints);
        addBeams(kIonBeams, kIonControlPoints);
        if (header_.itemCount(kBrachySetups) > 0)
            document_.notes.push_back(Text("The plan has brachytherapy, which is not shown here."));
        if (isCut_)
            document_.notes.push_back(
                Text("The document is larger than what is shown here: the rest of it is missing below."));
        if (unreadable_ > 0)
            document_.notes.push_back(Text("Some numbers of the plan cannot be read, and are left out."));
    }

  private:
    std::size_t section(Text heading, std::size_t parent = DocumentEntry::kNone) {
        DocumentEntry entry;
        entry.parent = parent;
        entry.depth = parent == DocumentEntry::kNone ? 0 : document_.entries[parent].depth + 1;
        entry.isSection = true;
        entry.heading = std::move(heading);
        document_.entries.push_back(std::move(entry));
        return document_.entries.size() - 1;
    }
    void add(std::size_t parent, Text heading, Text value) {
        if (value.empty()) return;
        if (document_.entries.size() >= kMostEntries) {
            isCut_ = true;
            return;
        }
        DocumentEntry entry;
        entry.parent = parent;
        entry.depth = document_.entries[parent].depth + 1;
        entry.heading = std::move(heading);
        entry.value = std::move(value);
        document_.entries.push_back(std::move(entry));
    }
    // Of an element that is there, and is no number.
    Text number(const Dataset& item, Tag tag, std::string_view unit) {
        Text text = withUnit(item, tag, unit);
        if (text.empty() && item.has(tag)) ++unreadable_;
        return text;
    }

    void addPlan() {
        const std::size_t plan = section(Text("Plan"));
        add(plan, Text("Label"), wordsOf(header_, tags::kPlanLabel));
        add(plan, Text("Name"), wordsOf(header_, kPlanName));
        add(plan, Text("Description"), wordsOf(header_, kPlanDescription));
        add(plan, Text("Intent"), wordsOf(header_, kPlanIntent));
        add(plan, Text("Geometry"), wordsOf(header_, kPlanGeometry));
        DocumentEntry structures;
        std::size_t nowhere = 0;
        structures.references = referencesIn(header_, kReferencedStructureSets, nowhere);
        if (structures.references.empty()) return;
        structures.parent = plan;
        structures.depth = 1;
        structures.heading = Text("Made on");
        structures.value = nameOf(structures.references.front());
        document_.entries.push_back(std::move(structures));
    }

    void addPrescription() {
        const std::size_t prescription = section(Text("Prescription"));
        add(prescription, Text("Description"), wordsOf(header_, kPrescriptionDescription));
        for (const Dataset& item : header_.items(kDoseReferences)) {
            if (document_.entries.size() >= kMostEntries) break;
            const std::string number = inLines(item.shortText(kDoseReferenceNumber));
            const std::size_t dose = section(Text("Dose reference {}", number), prescription);
            add(dose, Text("Description"), wordsOf(item, kDoseReferenceDescription));
            add(dose, Text("Type"), wordsOf(item, kDoseReferenceType));
            add(dose, Text("Defined by"), wordsOf(item, kDoseReferenceStructure));
            add(dose, Text("Prescribed dose"), this->number(item, kTargetPrescriptionDose, " Gy"));
            add(dose, Text("Least dose"), this->number(item, kTargetMinimumDose, " Gy"));
            add(dose, Text("Greatest dose"), this->number(item, kTargetMaximumDose, " Gy"));
            add(dose, Text("Greatest dose of the organ"), this->number(item, kOrganMaximumDose, " Gy"));
            add(dose, Text("Greatest dose that may be delivered"),
                this->number(item, kDeliveryMaximumDose, " Gy"));
        }
        if (document_.entries.size() == prescription + 1)
            add(prescription, Text("Dose"), Text("The plan names no prescribed dose."));
    }

    void addFractions() {
        for (const Dataset& item : header_.items(kFractionGroups)) {
            if (document_.entries.size() >= kMostEntries) break;
            const std::string number = inLines(item.shortText(kFractionGroupNumber));
            const std::size_t group = section(Text("Fraction group {}", number));
            add(group, Text("Planned fractions"), this->number(item, kFractionsPlanned, ""));
            const std::vector<Dataset> beams = item.items(kReferencedBeams);
            add(group, Text("Beams"), Text::verbatim(std::to_string(beams.size())));
            if (item.integer(kBrachyApplications).value_or(0) > 0)
                add(group, Text("Brachytherapy"), Text("It has some, which is not shown here."));
            for (std::size_t i = 0; i < std::min(beams.size(), kMostBeams); ++i)
                delivered_[beams[i].integer(kReferencedBeamNumber).value_or(-1)].push_back(
                    {number, beams[i].number(kBeamMeterset), beams[i].number(kBeamDose)});
        }
    }

    void addBeams(Tag sequence, Tag controlPoints) {
        const std::vector<Dataset> beams = header_.items(sequence);
        if (beams.size() > kMostBeams) isCut_ = true;
        for (std::size_t i = 0; i < std::min(beams.size(), kMostBeams); ++i) {
            if (document_.entries.size() >= kMostEntries) break;
            addBeam(beams[i], beams[i].items(controlPoints));
        }
    }

    void addBeam(const Dataset& beam, const std::vector<Dataset>& points) {
        const std::string number = inLines(beam.shortText(kBeamNumber));
        const std::string name = inLines(beam.text(kBeamName).value_or(""));
        const std::size_t at =
            section(name.empty() ? Text("Beam {}", number) : Text("Beam {}: {}", number, name));
        add(at, Text("Description"), wordsOf(beam, kBeamDescription));
        add(at, Text("Type"), wordsOf(beam, kBeamType));
        add(at, Text("Delivery"), wordsOf(beam, kDeliveryType));
        add(at, Text("Radiation"), wordsOf(beam, kRadiationType));
        add(at, Text("Machine"), wordsOf(beam, kMachine));
        if (points.empty())
            add(at, Text("Control points"), Text("The plan has none for this beam."));
        else
            addPoints(at, beam, points);
        for (const auto& [tag, heading] :
             {std::pair(kWedges, Text("Wedges")), std::pair(kBlocks, Text("Blocks")),
              std::pair(kBoli, Text("Boli"))}) {
            if (beam.integer(tag).value_or(0) > 0) add(at, heading, this->number(beam, tag, ""));
        }
        addDelivered(at, beam);
    }

    void addPoints(std::size_t at, const Dataset& beam, const std::vector<Dataset>& points) {
        const Dataset& first = points.front();
        const std::string radiation = beam.shortText(kRadiationType);
        add(at, Text("Energy"),
            number(first, kNominalEnergy,
                   radiation == "PHOTON" ? " MV"
                   : radiation == "ION"  ? " MeV/u"
                                         : " MeV"));
        add(at, Text("Dose rate"), number(first, kDoseRate, " MU/min"));
        add(at, Text("Gantry angle"), angles(points, kGantryAngle, first.shortText(kGantryDirection)));
        add(at, Text("Collimator angle"), angles(points, kCollimatorAngle, {}));
        add(at, Text("Couch angle"), angles(points, kCouchAngle, {}));
        if (const auto mm = first.numbers(kIsocentre, 3))
            add(at, Text("Isocentre"),
                Text::verbatim(fmt::format("{:.1f}, {:.1f}, {:.1f} mm", (*mm)[0], (*mm)[1], (*mm)[2])));
        add(at, Text("Control points"), Text::verbatim(std::to_string(points.size())));
    }

    // An angle that later control points do not repeat stays as it is.
    static Text angles(const std::vector<Dataset>& points, Tag tag, const std::string& direction) {
        const auto first = points.front().number(tag);
        if (!first) return {};
        constexpr double kSameDeg = 0.05;
        double last = *first;
        bool turns = false;
        for (const Dataset& point : points) {
            last = point.number(tag).value_or(last);
            turns = turns || std::abs(last - *first) >= kSameDeg;
        }
        const std::string from = fmt::format("{:.1f}°", *first);
        if (!turns) return Text::verbatim(from);
        const std::string to = fmt::format("{:.1f}°", last);
        if (direction == "CW") return Text("from {} to {}, clockwise", from, to);
        if (direction == "CC") return Text("from {} to {}, counter-clockwise", from, to);
        return Text("from {} to {}", from, to);
    }

    void addDelivered(std::size_t at, const Dataset& beam) {
        const auto found = delivered_.find(beam.integer(kBeamNumber).value_or(-1));
        if (found == delivered_.end()) return add(at, Text("Meterset"), Text("In no fraction group."));
        const std::string unit = inLines(beam.shortText(kDosimeterUnit));
        for (const Delivered& each : found->second) {
            const auto withGroup = [&](const std::string& value) {
                return Text("{} in fraction group {}", value, each.group);
            };
            if (each.meterset)
                add(at, Text("Meterset"),
                    withGroup(fmt::format("{} {}", numberText(*each.meterset), unit.empty() ? "MU" : unit)));
            if (each.doseGy)
                add(at, Text("Dose of the beam"), withGroup(fmt::format("{} Gy", numberText(*each.doseGy))));
        }
    }

    struct Delivered {
        std::string group;
        std::optional<double> meterset;
        std::optional<double> doseGy;
    };

    StudyDocument& document_;
    const Dataset& header_;
    std::map<int, std::vector<Delivered>> delivered_;  // by the number of the beam
    bool isCut_ = false;
    std::size_t unreadable_ = 0;
};

// PS3.3 C.8.8.16.
void addApproval(StudyDocument& document, const Dataset& header) {
    const std::string approval = header.shortText(kApproval);
    const std::string who = personOf(header.text(kReviewer).value_or(""));
    const std::string when = dateOf(header.text(kReviewDate).value_or(""));
    document.isVerified = approval == "APPROVED";
    if (approval == "REJECTED")
        document.status.push_back(Text("Rejected: it must not be used."));
    else if (approval == "UNAPPROVED")
        document.status.push_back(Text("Not approved by anybody."));
    else if (approval != "APPROVED")
        document.status.push_back(Text("The plan does not say whether anybody approved it."));
    else if (who.empty())
        document.status.push_back(Text("Approved."));
    else if (when.empty())
        document.status.push_back(Text("Approved by {}.", who));
    else
        document.status.push_back(Text("Approved by {} on {}.", who, when));
}

}  // namespace

void readPlan(StudyDocument& document, const Dataset& header) {
    document.title = wordsOf(header, tags::kPlanLabel);
    addApproval(document, header);
    document.status.push_back(
        Text("What the plan says is shown for reading. Nothing of it may be used for treatment."));
    Reader(document, header).read();
}

}  // namespace macula::dicom

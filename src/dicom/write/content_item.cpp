#include "dicom/write/content_item.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdlib>

#include "dicom/write/decimal_string.h"

namespace macula::dicom {

namespace {

const char* nameOf(Relation relation) {
    switch (relation) {
        case Relation::contains:
            return "CONTAINS";
        case Relation::hasConceptModifier:
            return "HAS CONCEPT MOD";
        case Relation::hasObservationContext:
            return "HAS OBS CONTEXT";
        case Relation::hasAcquisitionContext:
            return "HAS ACQ CONTEXT";
        case Relation::inferredFrom:
            return "INFERRED FROM";
    }
    std::abort();
}

// An outline is a closed polyline on an image (PS3.3 C.18.6.1.2), and a polygon in space (C.18.9.1.2).
const char* nameOf(ReportedShape shape, bool isInSpace) {
    switch (shape) {
        case ReportedShape::polyline:
            return "POLYLINE";
        case ReportedShape::outline:
            return isInSpace ? "POLYGON" : "POLYLINE";
        case ReportedShape::ellipse:
            return "ELLIPSE";
    }
    std::abort();
}

}  // namespace

void writeCode(ItemWriter item, const CodedName& code) {
    item.text(DCM_CodeValue, code.value);
    item.text(DCM_CodingSchemeDesignator, code.scheme);
    item.text(DCM_CodeMeaning, code.meaning);
}

void writeReference(ItemWriter item, const ReferencedImage& image) {
    item.text(DCM_ReferencedSOPClassUID, image.sopClassUid);
    item.text(DCM_ReferencedSOPInstanceUID, image.sopInstanceUid);
    if (!image.frames.empty())
        item.text(DCM_ReferencedFrameNumber, fmt::format("{}", fmt::join(image.frames, "\\")));
}

ContentItem::ContentItem(ItemWriter dataset, const CodedName& title, const char* templateNumber)
    : item_(dataset) {
    item_.text(DCM_ValueType, "CONTAINER");
    writeCode(item_.item(DCM_ConceptNameCodeSequence, 0), title);
    asContainer(templateNumber);
}

void ContentItem::asContainer(const char* templateNumber) {
    item_.text(DCM_ContinuityOfContent, "SEPARATE");
    if (templateNumber == nullptr) return;
    ItemWriter by = item_.item(DCM_ContentTemplateSequence, 0);
    by.text(DCM_MappingResource, "DCMR");
    by.text(DCM_TemplateIdentifier, templateNumber);
}

ItemWriter ContentItem::child(const char* relation, const char* valueType, const CodedName* name) {
    ItemWriter made = item_.nextItem(DCM_ContentSequence);
    made.text(DCM_RelationshipType, relation);
    made.text(DCM_ValueType, valueType);
    if (name != nullptr) writeCode(made.item(DCM_ConceptNameCodeSequence, 0), *name);
    return made;
}

ContentItem ContentItem::container(const CodedName& name, const char* templateNumber) {
    ContentItem made(child(nameOf(Relation::contains), "CONTAINER", &name));
    made.asContainer(templateNumber);
    return made;
}

void ContentItem::code(Relation relation, const CodedName& name, const CodedName& value) {
    writeCode(child(nameOf(relation), "CODE", &name).item(DCM_ConceptCodeSequence, 0), value);
}

void ContentItem::text(Relation relation, const CodedName& name, const std::string& value) {
    child(nameOf(relation), "TEXT", &name).text(DCM_TextValue, value);
}

void ContentItem::uid(Relation relation, const CodedName& name, const std::string& value) {
    child(nameOf(relation), "UIDREF", &name).text(DCM_UID, value);
}

ContentItem ContentItem::number(const ReportedNumber& number) {
    ItemWriter made = child(nameOf(Relation::contains), "NUM", &number.name);
    ItemWriter measured = made.item(DCM_MeasuredValueSequence, 0);
    measured.text(DCM_NumericValue, decimalString(number.value));
    // The 16 characters of a Decimal String do not hold every value exactly.
    measured.numbers(DCM_FloatingPointValue, {number.value});
    writeCode(measured.item(DCM_MeasurementUnitsCodeSequence, 0), number.unit);
    return ContentItem(made);
}

void ContentItem::image(const ReferencedImage& image) {
    writeReference(child(nameOf(Relation::contains), "IMAGE", nullptr).item(DCM_ReferencedSOPSequence, 0),
                   image);
}

void ContentItem::points(Relation relation, const CodedName& name, ReportedShape shape,
                         const PointsOnImage& points, const ReferencedImage& image) {
    ItemWriter made = child(nameOf(relation), "SCOORD", &name);
    std::vector<float> numbers;
    for (const glm::dvec2& px : points.pointsPx) numbers.insert(numbers.end(), {float(px.x), float(px.y)});
    if (shape == ReportedShape::outline) numbers.insert(numbers.end(), {numbers[0], numbers[1]});
    made.floats(DCM_GraphicData, numbers);
    made.text(DCM_GraphicType, nameOf(shape, false));
    ContentItem on(made);
    writeReference(on.child("SELECTED FROM", "IMAGE", nullptr).item(DCM_ReferencedSOPSequence, 0), image);
}

void ContentItem::points(Relation relation, const CodedName& name, ReportedShape shape,
                         const PointsInSpace& points, const std::string& frameOfReferenceUid) {
    ItemWriter made = child(nameOf(relation), "SCOORD3D", &name);
    std::vector<float> numbers;
    for (const glm::dvec3& mm : points.pointsMm)
        numbers.insert(numbers.end(), {float(mm.x), float(mm.y), float(mm.z)});
    if (shape == ReportedShape::outline) numbers.insert(numbers.end(), {numbers[0], numbers[1], numbers[2]});
    made.floats(DCM_GraphicData, numbers);
    made.text(DCM_GraphicType, nameOf(shape, true));
    made.text(DCM_ReferencedFrameOfReferenceUID, frameOfReferenceUid);
}

}  // namespace macula::dicom

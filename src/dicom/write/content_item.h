// Items of the content tree of a structured report (PS3.3 C.17.3). Only for the writers of this folder.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "dicom/write/item_writer.h"
#include "dicom/write/measurement_report.h"
#include "dicom/write/referenced_series.h"

namespace macula::dicom {

// How an item relates to the one above it.
enum class Relation {
    contains,
    hasConceptModifier,
    hasObservationContext,
    hasAcquisitionContext,
    inferredFrom
};

// A container, or a number below which there is where it comes from. Children are written as they are added.
class ContentItem {
  public:
    // The root: a container, by the template of this number (PS3.16).
    ContentItem(ItemWriter dataset, const CodedName& title, const char* templateNumber);

    ContentItem container(const CodedName& name, const char* templateNumber = nullptr);
    void code(Relation relation, const CodedName& name, const CodedName& value);
    void text(Relation relation, const CodedName& name, const std::string& value);
    void uid(Relation relation, const CodedName& name, const std::string& value);
    ContentItem number(const ReportedNumber& number);
    void image(const ReferencedImage& image);
    // Points on an image, in its pixels (SCOORD), or in space (SCOORD3D). At least one.
    void points(Relation relation, const CodedName& name, ReportedShape shape, const PointsOnImage& points,
                const ReferencedImage& image);
    void points(Relation relation, const CodedName& name, ReportedShape shape, const PointsInSpace& points,
                const std::string& frameOfReferenceUid);

  private:
    explicit ContentItem(ItemWriter item) : item_(item) {}
    ItemWriter child(const char* relation, const char* valueType, const CodedName* name);
    void asContainer(const char* templateNumber);

    ItemWriter item_;
};

// An item of a code sequence (PS3.3 8.8).
void writeCode(ItemWriter item, const CodedName& code);
// A reference to an instance, with its frames (PS3.3 10.3).
void writeReference(ItemWriter item, const ReferencedImage& image);

}  // namespace macula::dicom

// The sections of the property panel, from top to bottom.
#pragma once

#include <functional>
#include <vector>

#include "studio/properties/section.h"

namespace idap {

struct SectionEntry {
  bool (*applies)(const Selected&);
  Section* (*make)(PanelLink&, QWidget* parent);
};

// To add one: its file with a function that returns its entry, and a line in sections.cpp.
const std::vector<SectionEntry>& sectionEntries();

SectionEntry homeSection();
SectionEntry levelSection();
SectionEntry siteSection();
SectionEntry commonSection();
SectionEntry groupSection();
SectionEntry pieceSection();
SectionEntry openingSection();
SectionEntry placeSection();
SectionEntry sizeSection();
SectionEntry rotationSection();
SectionEntry parametersSection();
SectionEntry lampSection();
SectionEntry finishSection();
SectionEntry wallSection();
SectionEntry wallEndsSection();
SectionEntry wallLeftSection();
SectionEntry wallRightSection();
SectionEntry roomSection();
SectionEntry cameraSection();
SectionEntry dimensionSection();
SectionEntry labelSection();
SectionEntry polylineSection();
SectionEntry pieceNotesSection();

}  // namespace idap

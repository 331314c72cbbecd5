#include "studio/properties/sections.h"

namespace idap {

const std::vector<SectionEntry>& sectionEntries() {
  static const std::vector<SectionEntry> kEntries{
      homeSection(),       levelSection(),      siteSection(),     groupSection(),     pieceSection(),
      placeSection(),      sizeSection(),       rotationSection(), openingSection(),   lampSection(),
      parametersSection(), finishSection(),     wallSection(),     wallLeftSection(),  wallRightSection(),
      wallEndsSection(),   roomSection(),       cameraSection(),   dimensionSection(), labelSection(),
      polylineSection(),   pieceNotesSection(), commonSection(),
  };
  return kEntries;
}

}  // namespace idap

// Setting many pieces in order: align, distribute, mirror, lift; and flipping the whole plan.
#pragma once

#include "model/edits/element_edits.h"

namespace idap {

// The ways of lining pieces up with the lead: what cannot move (locked, or held by a wall) if there is such a
// piece, or else the first in order of id. Left, right, top (far), bottom (near) by the bounding boxes on the
// plan; CentreHorizontal brings the middles to one x, CentreVertical to one y; the Side ones along the lead's
// own axes where it is turned; SideBySide puts them in a row beside it, backs in line.
enum class Alignment {
  Left,
  Right,
  Top,
  Bottom,
  CentreHorizontal,
  CentreVertical,
  FrontSide,
  BackSide,
  LeftSide,
  RightSide,
  SideBySide
};
// Pieces and groups, each as one.
Home alignElements(const Home& home, const Elements& elements, Alignment alignment);
// The first and last along the axis stay, the gaps between become equal.
Home distributeElements(const Home& home, const Elements& elements, bool horizontally);

// Left and right exchanged: of one piece, and of doors in walls, where they stand; of several elements about
// the middle of them all.
Home mirrorElements(const Home& home, const Elements& elements);
// The whole plan, all levels, mirrored about a vertical (horizontally) or a level line through its middle.
Home flipPlan(const Home& home, bool horizontally);

// To the floor, or on top of what is under it (a table).
Home resetElevations(const Home& home, const Elements& elements);

// Copies, moved; groups with all in them, walls with their doors. A door copied without its wall belongs to
// the wall it comes to lie in. copies is what to select.
struct CopyEdit {
  Home home;
  Elements copies;
};
CopyEdit duplicateElements(const Home& home, const Elements& elements, Vec3 by);

// What is put on the clipboard: a home of only these elements, with the files they use.
Home extractElements(const Home& home, const Elements& elements);
// All of a fragment put into a home on a level, with new ids, moved; into a group, where one is given.
CopyEdit pasteElements(const Home& home, const Home& fragment, LevelId level, Vec3 by, GroupId group = {});
// Finish, lamp, transparency, size of text: how the first element of the fragment looks, given to others of
// its kind.
Home pasteStyle(const Home& home, const Home& fragment, const Elements& elements);

// Without the files in the home that nothing uses.
Home withoutUnusedAssets(const Home& home);

}  // namespace idap

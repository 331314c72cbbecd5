#include "model/edits/finish_edits.h"

#include "model/edits/piece_edits.h"
#include "model/edits/table_edits.h"

namespace idap {

namespace {

void paint(Wall& wall, const std::string& part, const Finish& finish) {
  if (part.empty() || part == kPartLeft) wall.left.finish = finish;
  if (part.empty() || part == kPartRight) wall.right.finish = finish;
  if (part == kPartTop) wall.top = finish;
  if (part == kPartBaseboardLeft && wall.left.baseboard) wall.left.baseboard->finish = finish;
  if (part == kPartBaseboardRight && wall.right.baseboard) wall.right.baseboard->finish = finish;
}

void paint(Room& room, const std::string& part, const Finish& finish) {
  if (part.empty() || part == kPartFloor) room.floor = finish;
  if (part == kPartCeiling) room.ceiling = finish;
}

void paint(Piece& piece, const std::string& part, const Finish& finish) {
  if (part.empty()) {
    piece.finish = finish;
    piece.slotFinishes.clear();
  } else if (finish.empty()) {
    piece.slotFinishes.erase(part);
  } else {
    piece.slotFinishes[part] = finish;
  }
}

}  // namespace

Home withFinish(const Home& home, const Elements& elements, const std::string& part, const Finish& finish) {
  Home next = changePieces(home, elements, [&](Piece& piece) { paint(piece, part, finish); });
  changeEach(next.walls, elements.walls, [&](Wall& wall) { paint(wall, part, finish); });
  changeEach(next.rooms, elements.rooms, [&](Room& room) { paint(room, part, finish); });
  return next;
}

}  // namespace idap
